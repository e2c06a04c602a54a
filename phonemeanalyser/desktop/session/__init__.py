"""What every page shares: the sound that is played or heard, its preset and its results."""
