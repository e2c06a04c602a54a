"""Takes of single sounds: kept, checked, listed; and the room in which they were made."""
