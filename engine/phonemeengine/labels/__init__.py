"""Label files, and the names of sounds in them."""
