"""The ear that is shipped: a preset as one file, and the C that listens with it."""
