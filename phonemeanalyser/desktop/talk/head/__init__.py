"""The heads, how they move, and the weights of their shapes."""
