"""Labelled recordings, and how right what a preset answers in them is."""
