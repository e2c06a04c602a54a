"""The guide: a voice learned from sentences that are read."""
