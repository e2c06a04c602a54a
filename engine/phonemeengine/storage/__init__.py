"""Files and folders: written whole or not at all, read strictly, never replaced unasked."""
