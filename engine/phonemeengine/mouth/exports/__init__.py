"""Mouth cues and movements in the files of other programs."""
