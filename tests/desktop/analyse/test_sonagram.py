"""The live sonagram's colours."""

import numpy as np

from phonemeanalyser.desktop.analyse.lanes.sonagram import as_measured


def test_normalising_makes_nothing_brighter_than_it_was_measured() -> None:
    shown = np.array([[1.0, 0.5], [1.0, 0.5], [1.0, 0.5], [0.1, 0.05]], np.float16)
    peaks = np.array([10 ** (-75 / 20), 10 ** (-25 / 20), np.nan, 0.1], np.float32)
    room, voice, unknown, bare = 20 * np.log10(as_measured(shown, peaks)[:, 0])
    np.testing.assert_allclose([room, voice, unknown, bare], [-75, -25, 0, -20], atol=0.01)
