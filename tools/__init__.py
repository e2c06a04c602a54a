"""What is neither product nor test: measuring, fuzzing, endurance, voices, pictures, the head."""
