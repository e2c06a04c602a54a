"""Test tones: settings, waveforms and the reader that plays them."""
