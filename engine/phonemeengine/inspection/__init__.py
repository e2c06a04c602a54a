"""What is shown of a whole sound: tracks, measured selections, averaged spectra, tables, and two presets compared."""
