"""A sonagram of what a recogniser gets to see: the spectra of 46 ms after all filters that are on."""

from functools import lru_cache

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.mel import spread_mel
from phonemeengine.dsp.sonagram import FLOOR, SonagramSettings
from phonemeengine.features.front_end import FrontEnd
from phonemeengine.settings import BIN_WIDTH, HOP, AnalysisSettings

ROUNDING = 0.001
"""Samples by which a frame may begin before a column and still belong to it."""
AT_ONCE = 500
"""Frames that are filtered at a time."""


def filtered_sonagram_of(
    samples: Float32Array,
    settings: AnalysisSettings,
    layout: SonagramSettings,
    first: float,
    n_columns: int,
    period: float,
) -> Float32Array:
    """Return the levels of a section of sound after filters, dB of full scale, float32, shape (n_columns, n_rows).

    A column is the mean power of the frames that begin in it; where none does, the frame that began before it. Frames
    are 10 ms apart; what lies beyond the sound is silent, `FLOOR`.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz, beginning at a frame, with enough before the section for filters that
        remember.
    settings : the filters.
    layout : the rows; the window is that of the recogniser.
    first : the sample at which the first column begins.
    n_columns : how many.
    period : samples from one column to the next.
    """
    # It is filtered by the recogniser's own front end, so that what is seen is what was recognised.
    front_end, framer = FrontEnd(settings, (), pitch=False), Framer()
    power = np.zeros((n_columns + 1, layout.n_rows))  # the first one is what begins before the section
    counts = np.zeros(n_columns + 1)
    edges = first + np.arange(n_columns + 1) * period
    parts = (samples[k : k + AT_ONCE * HOP] for k in range(0, len(samples), AT_ONCE * HOP))
    n_frames = 0
    for frames in (*map(framer.cut_frames, parts), framer.finish()):
        if len(frames):
            block = front_end.measure(frames)
            spectra = block.spectra if block.mel is None else spread_mel(block.mel, block.spectra.shape[1], BIN_WIDTH)
            rows = np.square(spectra) @ _row_weights(spectra.shape[1], layout)
            starts = (n_frames + np.arange(len(rows))) * HOP + ROUNDING
            # Column 0 is what lies before the picture; frames that begin before it are remembered for the first
            # columns, which may be narrower than 10 ms and then hold no frame.
            columns = np.searchsorted(edges, starts, side="right")
            before, inside = starts < first, columns <= n_columns
            if before.any():
                power[0], counts[0] = rows[before][-1], 1
            np.add.at(power, columns[inside & ~before], rows[inside & ~before])
            np.add.at(counts, columns[inside & ~before], 1)
            n_frames += len(rows)
    power /= np.maximum(counts, 1)[:, np.newaxis]
    # each empty column shows the last one before it that has a frame
    nearest = np.maximum.accumulate(np.where(counts > 0, np.arange(n_columns + 1), 0))
    shown = power[nearest][1:]
    shown[edges[:-1] >= len(samples)] = 0
    return np.asarray(np.maximum(10 * np.log10(np.maximum(shown, 1e-30)), FLOOR), np.float32)


@lru_cache(maxsize=4)
def _row_weights(n_bins: int, layout: SonagramSettings) -> Float32Array:
    """Return what each bin gives to each row, shape (n_bins, n_rows): rows lie on straight lines between bins."""
    places = np.minimum(layout.frequencies / BIN_WIDTH, n_bins - 1.0)
    below = np.minimum(places.astype(int), n_bins - 2)
    share = (places - below).astype(np.float32)
    weights = np.zeros((n_bins, layout.n_rows), np.float32)
    rows = np.arange(layout.n_rows)
    weights[below, rows] = 1 - share
    weights[below + 1, rows] += share
    return weights
