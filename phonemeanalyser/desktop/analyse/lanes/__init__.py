"""Sonagram, phonemes, labels and course over time, of a file and of the microphone."""
