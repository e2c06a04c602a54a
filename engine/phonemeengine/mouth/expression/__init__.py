"""Expressions beside speech: a smile that speaks, without either spoiling the other."""
