"""What moves the mouth: rules, a performance, or a voice."""
