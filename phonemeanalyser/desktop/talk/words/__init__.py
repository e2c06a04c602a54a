"""Texts: their words over time, scripts and voices."""
