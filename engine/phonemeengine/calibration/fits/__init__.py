"""Searches: for thresholds, limits, rules, templates and variables."""
