"""Recorded performances: a table of how a face moved with which sounds, and new sentences made of it."""
