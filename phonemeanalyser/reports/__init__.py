"""What is told about scores: as text, as JSON, as a page."""
