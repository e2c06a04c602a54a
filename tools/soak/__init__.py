"""A microphone that is heard for a long time: nothing may be lost, and nothing may grow."""
