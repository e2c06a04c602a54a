"""One widget a file: takes models, draws, never computes."""
