"""Sound becomes numbers: pure functions on blocks of frames, first axis the frame."""
