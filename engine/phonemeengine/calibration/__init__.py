"""Labelled recordings: reading them, scoring against them, and fitting thresholds to them."""
