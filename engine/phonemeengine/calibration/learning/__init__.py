"""Training the learned recogniser, with NumPy alone."""
