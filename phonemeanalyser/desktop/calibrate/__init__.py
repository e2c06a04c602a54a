"""The Calibrate page: takes, thresholds, fits and the guided calibration."""
