"""How the channels of a whole file are mixed so that every channel with sound counts: measured before the analysis.

Measuring ends as soon as the sound is found to be an ordinary one; most are within their first second.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.settings import Channel

QUIET = -26.0
"""Peak below which a sound is amplified, dB of full scale: below, recognition takes more and more for silence."""
WANTED = -12.0
"""Peak to which it is amplified, dB."""
MOST_GAIN = 60.0
"""By how much at the most, dB; what is then still quiet is the noise of a recording of nothing."""
SILENT = 40.0
"""By how much a channel is quieter than the loudest where it does not sound, dB."""
CANCELLING = -0.5
"""Correlation from which on two channels cancel rather than add up: their mix is quieter than one of them alone."""
SURE = 10.0
"""Seconds of sound after which channels that all sound and do not cancel are taken to go on like that."""
STEADY = 10.0
"""By how much the loudest parts of speech are above its tenth quietest at least, dB; else it is a room's noise."""
PART = 0.01
"""Seconds of which each peak is taken."""
N_PEAKS = 10
"""Parts that are as loud as what is called the peak: a click or two are none."""
N_STEPS = 180
"""Steps of 1 dB below full scale in which the peaks of the parts are counted."""
_FAINTEST = 1e-9


@dataclass(frozen=True)
class Mix:
    """How channels become the one that is recognised.

    Attributes
    ----------
    weights : of the channels, whose amounts add up to 1; empty for their plain mean, or for the channel that is
        chosen.
    gain : factor by which the mix is amplified.
    notes : what is unusual about it, a sentence each.
    """

    weights: tuple[float, ...] = ()
    gain: float = 1.0
    notes: tuple[str, ...] = ()

    def channels_mixed(self, block: Float32Array) -> Float32Array:
        """Return the weighted sum of the channels, shape (n,), before it is amplified."""
        return np.asarray(block @ np.asarray(self.weights, np.float32), np.float32)

    def amplified(self, mono: Float32Array) -> Float32Array:
        """Return what is recognised, shape (n,), of the mix."""
        return mono if self.gain == 1.0 else np.clip(mono * np.float32(self.gain), -1.0, 1.0)


PLAIN = Mix()
"""The mean of all channels as it is."""


def measured_mix(blocks: Iterable[Float32Array], rate: int, channel: Channel) -> Mix:
    """Return how a whole sound is mixed.

    Parameters
    ----------
    blocks : of shape (n, n_channels), from its beginning; they are taken only as long as that may change anything.
    rate : Hz.
    channel : the channel that is chosen, or the mix of all.
    """
    peaks: list[Float64Array] = []
    products: Float64Array | None = None
    n_sounding, counts = 0, np.zeros(N_STEPS)
    for block in _parts(blocks, max(1, int(rate * PART))):
        found = block if channel is Channel.MIX else block[:, :, channel.number - 1 : channel.number]
        levels = np.abs(found).max(axis=1).astype(np.float64)
        counts += np.histogram(_decibels(levels.max(axis=1)), N_STEPS, (-N_STEPS, 0))[0]
        peaks = [np.sort(np.concatenate([*peaks, levels]), axis=0)[-N_PEAKS:]]
        n_channels = found.shape[2]
        if n_channels > 1:
            flat = found.reshape(-1, n_channels)
            products = np.asarray(flat.T @ flat + (0 if products is None else products), np.float64)
        loud = _decibels(peaks[0].min(axis=0)) if len(peaks[0]) == N_PEAKS else np.full(n_channels, -np.inf)
        n_sounding += int((levels.max(axis=1) > 10 ** (QUIET / 20)).sum())
        if loud.max() >= QUIET and (n_channels == 1 or _is_ordinary(loud, products, n_sounding)):
            return PLAIN
    if not peaks or len(peaks[0]) < N_PEAKS:
        return PLAIN
    tenth = float(np.searchsorted(np.cumsum(counts), counts.sum() / 10)) - N_STEPS
    return _mix_of(_decibels(peaks[0].min(axis=0)), products, tenth)


def cancels(products: Float64Array) -> bool:
    """Return whether channels cancel; sums of the products of their samples, shape (n_channels, n_channels)."""
    return bool((_signs(products, int(np.argmax(np.diag(products)))) < 0).any())


def _is_ordinary(loud: Float64Array, products: Float64Array | None, n_sounding: int) -> bool:
    assert products is not None
    return n_sounding * PART >= SURE and bool((loud > loud.max() - SILENT).all()) and not cancels(products)


def _mix_of(loud: Float64Array, products: Float64Array | None, tenth: float) -> Mix:
    notes: list[str] = []
    n = len(loud)
    weights: tuple[float, ...] = ()
    peak = float(loud.max())
    if n > 1 and products is not None and peak > _decibels(np.asarray(_FAINTEST)):
        sounding = loud > peak - SILENT
        signs = np.where(sounding, _signs(products, int(np.argmax(loud))), 0)
        if not sounding.all():
            numbers = ", ".join(str(k + 1) for k in np.flatnonzero(sounding))
            notes.append(
                f"only channel {numbers} of {n} has a signal and is used"
                if sounding.sum() == 1
                else f"only the channels {numbers} of {n} have a signal and are mixed"
            )
        if (signs < 0).any():
            numbers = ", ".join(str(k + 1) for k in np.flatnonzero(signs < 0))
            notes.append(f"its channels cancel each other out when mixed; channel {numbers} is inverted")
        if notes:
            weights = tuple(float(sign) / int(sounding.sum()) for sign in signs)
    gain = min(WANTED - peak, MOST_GAIN)
    if peak >= QUIET or peak < tenth + STEADY:
        return Mix(weights, 1.0, tuple(notes)) if notes else PLAIN
    notes.append(f"the recording peaks at {peak:.0f} dBFS; amplified by {gain:.0f} dB for recognition")
    return Mix(weights, float(10 ** (gain / 20)), tuple(notes))


def _signs(products: Float64Array, reference: int) -> Float64Array:
    """Return -1 for channels that cancel a reference, else 1."""
    powers = np.maximum(np.diag(products), _FAINTEST)
    alike = products[reference] / np.sqrt(powers * powers[reference])
    return np.where(alike < CANCELLING, -1.0, 1.0)


def _parts(blocks: Iterable[Float32Array], n: int) -> Iterator[Float32Array]:
    """Cut blocks into parts of n samples; shape (n_parts, n, n_channels). A rest is filled up with silence."""
    held: list[Float32Array] = []
    for block in blocks:
        held = [np.concatenate([*held, block])]
        n_whole = len(held[0]) // n
        if n_whole:
            yield held[0][: n_whole * n].reshape(n_whole, n, -1)
            held = [held[0][n_whole * n :]]
    if held and len(held[0]):
        yield np.pad(held[0], ((0, n - len(held[0])), (0, 0)))[np.newaxis]


def _decibels(levels: Float64Array) -> Float64Array:
    return 20 * np.log10(np.maximum(levels, _FAINTEST))
