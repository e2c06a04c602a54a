"""Recognition by templates, in the way of uLipSync: the phoneme whose mean cepstra are nearest; silence by level."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import LARGEST_FLOAT32, Float32Array, ShortRepr
from phonemeengine.dsp.mel import N_CEPSTRA, cepstra_of, log_mels
from phonemeengine.errors import SettingsError, check_range
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import NO_SENSITIVITIES, Recognition, ScoredRecogniser, Sensitivity

UNTEMPLATED = (Phoneme.SILENCE, Phoneme.UNIDENTIFIED)
"""What has no template."""
SOFTNESS = 3.0
"""By how much the squared distance grows, in squared spreads, where a phoneme is e times less likely."""
RAMP = 1.5
"""Decibels around the level of silence over which silence becomes e times less likely."""


@dataclass(frozen=True, repr=False)
class Templates(ShortRepr):
    """What each phoneme's spectrum is like on average.

    Attributes
    ----------
    means : for each phoneme that can be named its 12 mean cepstra.
    spread : the standard deviations of the 12 cepstra within a phoneme; distances count in these.
    silence_below : level below which a frame is silent, dB; a full-scale sine has 0 dB.

    Raises
    ------
    SettingsError : there are no templates, or one has the wrong length, or a number is impossible.
    """

    means: Mapping[Phoneme, tuple[float, ...]]
    spread: tuple[float, ...]
    silence_below: float = -50.0

    def __post_init__(self) -> None:
        if not self.means:
            raise SettingsError(
                "there must be at least one template, and there is none; record takes of the phonemes"
            )
        for name, row in {**{p.label: row for p, row in self.means.items()}, "spread": self.spread}.items():
            _check_row(name, row)
        for phoneme in UNTEMPLATED:
            if phoneme in self.means:
                raise SettingsError(f"{phoneme.label} has no template; leave it out")
        if min(self.spread) <= 0:
            raise SettingsError(
                f"the spread must be above 0 in each of its numbers, got {min(self.spread):g}; correct it"
            )
        check_range("silence_below", self.silence_below, (-200, 0, "dB"))


class TemplateRecogniser(ScoredRecogniser):
    """Names the phoneme with the nearest template; its scores add up to 1.

    Parameters
    ----------
    templates : what it compares with.
    sensitivities : log-odds that are added to those of phonemes, nats.
    """

    look_ahead = 0

    def __init__(self, templates: Templates, sensitivities: Mapping[Phoneme, float] = NO_SENSITIVITIES) -> None:
        self._sensitivity = Sensitivity(sensitivities)
        self._silence_below = templates.silence_below
        self._phonemes = list(templates.means)
        # Both are divided by the spreads once, so that the distance is Mahalanobis's with a diagonal covariance: the
        # coefficients of the cosine transform are nearly uncorrelated.
        self._scale = (1 / np.array(templates.spread)).astype(np.float32)
        self._means = np.array(list(templates.means.values()), np.float32) * self._scale

    def recognise(self, windows: Float32Array, _features: Features) -> Recognition:
        """Recognise a block."""
        bands = log_mels(windows)
        scores = np.zeros((len(bands), len(Phoneme)), np.float32)
        # A soft threshold: silence and sound are equally likely at the level of silence, which is measured on the mel
        # powers. Clipped to ±60, beyond which float32 has nothing left to tell and exp would overflow.
        loud = 1 / (1 + np.exp(np.clip((self._silence_below - levels_of(bands)) / RAMP, -60, 60)))
        scores[:, self._phonemes] = self._likenesses(cepstra_of(bands)) * loud[:, np.newaxis]
        scores[:, Phoneme.SILENCE] = 1 - loud
        scores = self._sensitivity.apply(scores)
        return Recognition(scores.argmax(axis=1).astype(np.uint8), scores)

    def _likenesses(self, cepstra: Float32Array) -> Float32Array:
        """Turn distances from the templates into shares of 1, shape (n_frames, n_templates)."""
        places = (cepstra * self._scale)[:, np.newaxis]
        # With `SOFTNESS` 2 these were the posteriors of normal distributions of equal spread; 3 is less sure.
        distances = ((places - self._means) ** 2).sum(axis=2)
        likenesses: Float32Array = np.exp((distances.min(axis=1, keepdims=True) - distances) / np.float32(SOFTNESS))
        likenesses /= likenesses.sum(axis=1, keepdims=True)
        return likenesses


def _check_row(name: str, row: tuple[float, ...]) -> None:
    if len(row) != N_CEPSTRA:
        raise SettingsError(f"{name} must have {N_CEPSTRA} numbers in templates, got {len(row)}; correct it")
    for value in row:
        if not abs(value) <= LARGEST_FLOAT32:
            raise SettingsError(
                f"{name} must hold finite numbers within ±3.4e38 in templates, got {value}; correct it"
            )


def levels_of(log_mels: Float32Array) -> Float32Array:
    """Return the level of frames from the logarithms of their mel powers, dB, shape (n_frames,).

    A full-scale sine has about 0 dB; digital silence some -94 dB.
    """
    # powers of bands are added, not their decibels
    levels: Float32Array = 10 * np.log10((10**log_mels).sum(axis=1))
    return levels


def rounded_templates(means: Mapping[Phoneme, Float32Array], spread: Float32Array, silence_below: float) -> Templates:
    """Return templates with few digits, as a file shows them."""
    rows = {phoneme: _rounded(mean) for phoneme, mean in means.items()}
    return Templates(rows, _rounded(np.maximum(spread, 1e-3)), float(math.floor(10 * silence_below) / 10))


def _rounded(values: Float32Array) -> tuple[float, ...]:
    return tuple(round(float(value), 4) for value in values)
