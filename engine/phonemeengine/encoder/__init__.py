"""A speech encoder that has heard everybody: what it makes of a sound, and the head that names phonemes from it."""
