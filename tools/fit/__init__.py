"""Fits the presets that ship with the program to labelled speech."""
