"""All recordings measured once, so that every change of a preset is known at once."""
