"""Reports of scores: as text, as JSON, as a page."""
