"""The runtime that is shipped: a preset as one file, and the C that recognises with it."""
