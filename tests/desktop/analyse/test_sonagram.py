"""The live sonagram's colours."""

import numpy as np

from phonemeanalyser.desktop.analyse.lanes.sonagram import limit_gain


def test_normalising_makes_no_quiet_room_bright_and_leaves_a_voice_and_bare_spectra_as_they_are() -> None:
    shown = np.array([[1.0, 0.5], [1.0, 0.5], [1.0, 0.5], [0.1, 0.05]], np.float16)
    peaks = np.array([10 ** (-75 / 20), 10 ** (-25 / 20), np.nan, 0.1], np.float32)
    room, voice, unknown, bare = 20 * np.log10(limit_gain(shown, peaks)[:, 0])
    np.testing.assert_allclose([room, voice, unknown, bare], [-45, 0, 0, -20], atol=0.01)
