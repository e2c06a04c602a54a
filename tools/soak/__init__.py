"""A microphone that is used for a long time: nothing may be lost, and nothing may grow."""
