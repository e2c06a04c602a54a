"""Takes: recorded, listed, and measured against the room."""
