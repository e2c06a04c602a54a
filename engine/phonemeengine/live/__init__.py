"""Sound as it happens: files that are played, microphones that are listened to."""
