"""Labelled recordings: scores, distributions, fits and comparisons."""
