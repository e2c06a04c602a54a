"""Sounds that become files: of what kind, what is said in them, what moves a face by it, and the work itself."""
