"""Mel cepstra: the coarse shape of a spectrum, as few numbers."""

from functools import lru_cache

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.log_mel import N_BANDS

N_CEPSTRA = 12
"""Coefficients 1..12; the zeroth, the loudness, is left out."""


def cepstra_of(log_mels: Float32Array) -> Float32Array:
    """Return the cosine transform of logarithms of mel powers, without its zeroth coefficient.

    A louder sound has the same cepstra (S. Davis and P. Mermelstein, IEEE Trans. ASSP 28(4), 1980).

    Parameters
    ----------
    log_mels : float32, shape (n_frames, 40).

    Returns
    -------
    float32, shape (n_frames, 12).
    """
    cepstra: Float32Array = log_mels.dot(cepstral_cosines())
    return cepstra


@lru_cache(maxsize=1)
def cepstral_cosines() -> Float32Array:
    """Return the orthonormal cosines of the transform (DCT-II), shape (n_bands, n_cepstra)."""
    bands = np.arange(N_BANDS)[:, np.newaxis] + 0.5
    return np.asarray(
        np.sqrt(2 / N_BANDS) * np.cos(np.pi / N_BANDS * bands * np.arange(1, N_CEPSTRA + 1)), np.float32
    )
