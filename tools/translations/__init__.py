"""Keeps the translations of the window up to date: `make translations`."""
