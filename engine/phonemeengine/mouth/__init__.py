"""The mouth: movestates, how they follow the phonemes, and mouth cues for every program."""
