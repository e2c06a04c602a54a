"""Speech from text: voices, and mouths that are driven by what is written."""
