"""Disturb the mel powers of a batch as microphones do: other levels, colours, noise, band limits, a noise floor.

All of it is done on powers, where sounds add up. Chance comes from PyTorch's generator.
"""

from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from phonemeengine.arrays import Float64Array
from phonemeengine.dsp.mel import FLOOR, SHORT, warped_mel_bank
from phonemeengine.encoder.whisper import ENCODER_RATE, LEAST_POWER, N_FFT, slaney_bank
from phonemeengine.settings import SAMPLE_RATE

GAINS = (-18.0, 8.0)
"""Other levels, dB."""
COLOUR = 6.0
"""Unevenness of microphones and rooms over frequency, dB."""
TILT = 4.0
"""Slope from the lowest to the middle band, standard deviation, dB."""
HISS_SNRS = (0.0, 30.0)
"""Level of the loudest third of the speech above added noise, dB."""
FLOORS = (-120.0, -70.0)
"""Level of the microphone's own noise in each band, dB below full scale."""
NOISY, FLOORED, NARROW, BASSLESS, HIDDEN = 0.5, 0.85, 0.15, 0.1, 0.4
"""Shares of the recordings with noise, with a floor, without the highest bands, the lowest bands, some others."""
STEADY = 0.5
"""Share of the noise that is steady; the rest is babble, three others who speak at once."""


@dataclass(frozen=True)
class Bands:
    """Mel bands of a spectrum.

    Attributes
    ----------
    floor : least power.
    full_scale : power of a full-scale sine in them, dB.
    degrees : degrees of freedom of the power of noise in each band, shape (n_bands,): wide bands are steadier.
    centres : their frequencies, Hz, shape (n_bands,).
    """

    floor: float
    full_scale: float
    degrees: tuple[float, ...]
    centres: tuple[float, ...]


def _bands(floor: float, full_scale: float, bank: Float64Array, bin_width: float) -> Bands:
    """Describe the bands of a bank of filters, shape (n_bands, n_bins)."""
    # the variance of a sum of powers of noise tells of how many bins of equal weight it seems to be
    degrees = np.maximum(1, bank.sum(axis=1) ** 2 / (bank**2).sum(axis=1))
    centres = (bank @ np.arange(bank.shape[1])) / bank.sum(axis=1) * bin_width
    return Bands(floor, full_scale, tuple(degrees.tolist()), tuple(centres.tolist()))


SMALL_BANDS = _bands(FLOOR, 0.0, warped_mel_bank().T.astype(float), SAMPLE_RATE / SHORT)
WHISPER_BANDS = _bands(
    # a sine of amplitude 1 gives a bin of a quarter of the window's length
    LEAST_POWER,
    float(20 * np.log10(N_FFT / 4) + 10 * np.log10(slaney_bank().max())),
    slaney_bank(),
    ENCODER_RATE / N_FFT,
)
"""The bands of the small network, and of Whisper, every 10 ms."""


def disturbed(logarithms: Tensor, bands: Bands) -> Tensor:
    """Disturb a batch.

    Parameters
    ----------
    logarithms : of mel powers, to the base 10, shape (n_batch, n_frames, n_bands).
    bands : which they are.

    Returns
    -------
    logarithms of the disturbed powers, same shape.
    """
    n, _, n_bands = logarithms.shape
    places = torch.linspace(-1, 1, n_bands, device=logarithms.device)
    decibels = _curves(n, COLOUR, places) + _tilts(n, TILT, places) + _uniform(GAINS, n, places)
    noisy = 10 ** (logarithms + decibels / 10)
    degrees = torch.tensor(bands.degrees, device=logarithms.device)
    noisy = noisy + _noise(noisy, places, degrees)
    noisy = noisy * _limits(n, places)
    floors = bands.full_scale + _uniform(FLOORS, n, places) + _tilts(n, 5.0, places)
    floored = torch.rand(n, 1, 1, device=places.device) < FLOORED
    noisy = noisy + _powers(floors) * _flicker(noisy.shape, degrees) * floored
    return _with_hidden_bands(torch.log10(noisy + bands.floor))


def _noise(noisy: Tensor, places: Tensor, degrees: Tensor) -> Tensor:
    """Return steady coloured noise, or babble, at a drawn level below the speech, or none."""
    n, n_frames, _ = noisy.shape
    chance = torch.rand(2, n, 1, 1, device=noisy.device)
    steady = _powers(_tilts(n, 8.0, places) + _curves(n, COLOUR, places)) * _flicker(noisy.shape, degrees)
    babble = sum((noisy[torch.randperm(n, device=noisy.device)] for _ in range(3)), torch.zeros_like(noisy))
    noise = torch.where(chance[0] < STEADY, steady, babble)
    noise = noise / (noise.mean(dim=(1, 2), keepdim=True) + 1e-20)
    loudest = noisy.mean(dim=2).topk(max(1, n_frames // 3), dim=1).values.mean(dim=1)[:, None, None]
    return noise * loudest * _powers(-_uniform(HISS_SNRS, n, places)) * (chance[1] < NOISY)


def _limits(n: int, places: Tensor) -> Tensor:
    """Return factors that take the highest or the lowest bands away, shape (n, 1, n_bands)."""
    above, below, narrow, bassless = torch.rand(4, n, 1, 1, device=places.device)
    high = torch.where((narrow < NARROW) & (places >= 0.2 + 0.7 * above), 1e-7, 1.0)
    return high * torch.where((bassless < BASSLESS) & (places < -0.95 + 0.2 * below), 1e-5, 1.0)


def _with_hidden_bands(logarithms: Tensor) -> Tensor:
    """Put the mean into a few neighbouring bands (D. Park et al., "SpecAugment", arXiv:1904.08779)."""
    n, _, n_bands = logarithms.shape
    first, width, chance = torch.rand(3, n, 1, 1, device=logarithms.device)
    bands = torch.arange(n_bands, device=logarithms.device) / n_bands
    hidden = (chance < HIDDEN) & (bands >= first) & (bands < first + 0.02 + 0.13 * width)
    return torch.where(hidden, logarithms.mean(dim=(1, 2), keepdim=True), logarithms)


def _curves(n: int, most: float, places: Tensor) -> Tensor:
    """Draw smooth curves over the bands, dB, shape (n, 1, n_bands)."""
    orders = torch.arange(1, 5, device=places.device)[:, None]
    phases = 2 * torch.pi * torch.rand(n, 4, 1, device=places.device)
    heights = torch.randn(n, 4, 1, device=places.device) / orders
    waves = heights * torch.cos(orders * torch.pi / 2 * (places + 1) + phases)
    return (waves.sum(dim=1) * most * torch.rand(n, 1, device=places.device))[:, None]


def _tilts(n: int, spread: float, places: Tensor) -> Tensor:
    return places * torch.randn(n, 1, 1, device=places.device) * spread


def _uniform(limits: tuple[float, float], n: int, places: Tensor) -> Tensor:
    return limits[0] + (limits[1] - limits[0]) * torch.rand(n, 1, 1, device=places.device)


def _flicker(shape: torch.Size, degrees: Tensor) -> Tensor:
    """Draw how noise varies from frame to frame in each band; the mean is 1."""
    drawn: Tensor = torch._standard_gamma(degrees.expand(shape).contiguous())
    return drawn / degrees


def _powers(decibels: Tensor) -> Tensor:
    return 10 ** (decibels / 10)


WARPED, WARPS = 0.5, (0.86, 1.17)
"""Share of the excerpts whose frequencies are scaled, as by a shorter or longer vocal tract, and by how much."""
HIGH, HIGH_WARPS = 0.15, (1.17, 1.6)
"""Share of the excerpts that become a child's or a cartoon voice, pitch and formants alike, and how high."""


def warped(logarithms: Tensor, bands: Bands) -> Tensor:
    """Scale the frequencies of some excerpts of a batch, as other vocal tracts would (VTLP, N. Jaitly and G. Hinton,
    ICML workshop 2013); same shape."""
    n, n_frames, n_bands = logarithms.shape
    chance, factor = torch.rand(2, n, 1, device=logarithms.device)
    scaled, high = (low + (most - low) * factor for low, most in (WARPS, HIGH_WARPS))
    factor = torch.where(chance < WARPED, scaled, torch.where(chance > 1 - HIGH, high, 1.0))
    centres = torch.tensor(bands.centres, device=logarithms.device)
    # between which two bands the frequency lies that is moved to each
    places = torch.searchsorted(centres, (centres / factor).contiguous()).clamp(1, n_bands - 1)
    low, high = centres[places - 1], centres[places]
    share = ((centres / factor - low) / (high - low)).clamp(0, 1)[:, None, :]
    below = (places - 1)[:, None, :].expand(-1, n_frames, -1)
    return (1 - share) * logarithms.gather(2, below) + share * logarithms.gather(2, below + 1)
