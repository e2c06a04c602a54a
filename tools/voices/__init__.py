"""Makes training speech with phone and class labels from free synthesizers, in the corpus format."""
