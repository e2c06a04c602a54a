"""Sound comes in: files now, sound cards and rings beside them."""
