"""The Analyse page: plots, filters, thresholds and transport."""
