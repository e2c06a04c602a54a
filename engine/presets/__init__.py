"""Presets and their files."""
