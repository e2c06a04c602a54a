"""Forced alignment: where the words of a known script are in a recording of it."""
