"""The preset, its front end and thresholds, and the phoneme that is recognised."""
