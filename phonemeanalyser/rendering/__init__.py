"""Pictures of a head: one renderer for the window and for files."""
