"""Scripts, and how their words are pronounced (grapheme to phoneme)."""
