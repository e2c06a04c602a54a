"""The strip that says how right what is recognised is."""
