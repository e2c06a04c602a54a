"""Edited keys of blend shapes: their model and their lanes."""
