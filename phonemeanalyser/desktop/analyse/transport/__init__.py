"""Playing and recording: position, output, microphone and tone."""
