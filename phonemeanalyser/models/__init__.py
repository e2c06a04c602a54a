"""State and signals: what the views draw and the user changes. No painting."""
