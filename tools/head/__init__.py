"""Makes the head that ships with the program."""
