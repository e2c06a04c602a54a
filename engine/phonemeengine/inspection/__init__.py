"""What is shown of a whole sound: tracks, measured stretches, averaged spectra, tables, and two presets compared."""
