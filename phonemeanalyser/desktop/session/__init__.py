"""What every page shares: the sound that is played or recorded, its preset and its results."""
