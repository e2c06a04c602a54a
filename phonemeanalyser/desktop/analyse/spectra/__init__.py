"""Spectrum, averaged spectra and waveform."""
