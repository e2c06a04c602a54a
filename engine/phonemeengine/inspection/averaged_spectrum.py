"""Averaged spectra: accumulated, kept as small text files, compared on one frequency axis."""

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import CurveError
from phonemeengine.settings import BIN_WIDTH
from phonemeengine.storage.files import read_text_file, write_file

FORMAT = "phonemeanalyser curve 1"
COLUMNS = ["frequency_hz", "amplitude"]
LARGEST_FILE = 4 << 20
MOST_BINS = 1 << 14


@dataclass(frozen=True)
class AveragedSpectrum:
    """An averaged spectrum.

    Attributes
    ----------
    name : what people call it, such as the speaker and the sound.
    frequencies : float64, shape (n_bins,), rising, Hz.
    amplitudes : float64, shape (n_bins,), 0 or more.
    n_frames : how many frames were averaged.
    front_end : in words, which filters shaped the spectra.
    since : in words, what the average begins with; empty where nobody knows.
    """

    name: str
    frequencies: Float64Array
    amplitudes: Float64Array
    n_frames: int
    front_end: str
    since: str = ""

    def at(self, frequencies: Float64Array) -> Float64Array:
        """Return the amplitudes at other frequencies (Hz), linear between bins, NaN beyond the curve's end."""
        return np.interp(frequencies, self.frequencies, self.amplitudes, right=np.nan)


class SpectrumAverage:
    """The running mean of spectra; begins anew when the number of bins changes."""

    def __init__(self) -> None:
        self.n_frames = 0
        self._sum = np.zeros(0)

    def add(self, spectra: Float32Array) -> None:
        """Take in a block of spectra, shape (n_frames, n_bins)."""
        if spectra.shape[1] != len(self._sum):
            self.clear()
            self._sum = np.zeros(spectra.shape[1])
        self._sum += spectra.sum(axis=0, dtype=np.float64)
        self.n_frames += len(spectra)

    def clear(self) -> None:
        """Forget everything."""
        self.n_frames = 0
        self._sum = np.zeros(0)

    def curve(self, name: str, front_end: str, since: str = "") -> AveragedSpectrum:
        """Return the mean so far; bins lie at multiples of 21.53 Hz."""
        n_bins = len(self._sum)
        return AveragedSpectrum(
            name,
            np.arange(n_bins, dtype=float) * BIN_WIDTH,
            self._sum / max(self.n_frames, 1),
            self.n_frames,
            front_end,
            since,
        )


def distance_of(one: AveragedSpectrum, other: AveragedSpectrum) -> float:
    """Measure how differently two curves are shaped, in dB.

    The root mean square of their difference in dB, over the frequencies that both have, after the mean difference
    (loudness) is taken away; amplitudes below -80 dB of full scale count as -80 dB. NaN where nothing is shared.
    """
    finer = one if len(one.frequencies) >= len(other.frequencies) else other
    levels = [20 * np.log10(np.maximum(curve.at(finer.frequencies), 1e-4)) for curve in (one, other)]
    difference = levels[0] - levels[1]
    difference = difference[np.isfinite(difference)]
    return float(difference.std()) if len(difference) else math.nan


def save_averaged_spectrum(curve: AveragedSpectrum, path: Path) -> None:
    """Save a curve, see `format_averaged_spectrum`; an old file stays until the new one is complete.

    Raises
    ------
    CurveError : the file cannot be written.
    """
    write_file(path, format_averaged_spectrum(curve).encode(errors="replace"), CurveError)


def format_averaged_spectrum(curve: AveragedSpectrum) -> str:
    """Return a curve as CSV with a header that says what it is."""
    header = {
        "name": curve.name,
        "front end": curve.front_end,
        "bins": len(curve.frequencies),
        "frames": curve.n_frames,
    }
    if curve.since:
        header["since"] = curve.since
    lines = [f"# {FORMAT}", *(f"# {key}: {' '.join(str(value).split())}" for key, value in header.items())]
    lines.append(",".join(COLUMNS))
    lines += [f"{f:.9g},{a:.9g}" for f, a in zip(curve.frequencies, curve.amplitudes, strict=True)]
    return "".join(line + "\n" for line in lines)


def load_averaged_spectrum(path: Path) -> AveragedSpectrum:
    """Load a curve that `save_averaged_spectrum` wrote.

    Raises
    ------
    CurveError : the file cannot be read or is no curve; the message begins with the file's name.
    """
    lines = read_text_file(path, LARGEST_FILE, "a file of Save Curve", CurveError).splitlines()
    try:
        return _parse(lines)
    except ValueError as error:
        raise CurveError(f"{path.name}: {error}") from error


def _parse(lines: list[str]) -> AveragedSpectrum:
    if not lines or lines[0].strip() != f"# {FORMAT}":
        raise ValueError(f"a curve begins with the line '# {FORMAT}'; choose a file saved by Save Curve")
    comments = [line[1:].partition(":") for line in lines[1:] if line.startswith("#")]
    header = {key.strip(): value.strip() for key, _, value in comments}
    rows = [line for line in lines if not line.startswith("#")]
    if not rows or rows[0].split(",") != COLUMNS:
        raise ValueError(f"the columns must be {','.join(COLUMNS)}, found {rows[0][:60] if rows else 'none'!r}")
    for key in ("name", "front end", "bins", "frames"):
        if key not in header:
            raise ValueError(f"the header lacks '{key}'")
    points = np.array([_point(row, number) for number, row in enumerate(rows[1:], 1)]).reshape(-1, 2)
    n_bins, n_frames = _count(header, "bins"), _count(header, "frames")
    if len(points) != n_bins or not 1 <= n_bins <= MOST_BINS:
        raise ValueError(f"the header announces {n_bins} bins (1..{MOST_BINS}), found {len(points)}")
    if np.any(np.diff(points[:, 0]) <= 0):
        raise ValueError("the frequencies must rise from row to row")
    since = header.get("since", "")
    return AveragedSpectrum(header["name"], points[:, 0], points[:, 1], n_frames, header["front end"], since)


def _count(header: dict[str, str], key: str) -> int:
    text = header[key]
    if not (text.isascii() and text.isdigit() and len(text) <= 12):
        raise ValueError(f"'{key}' in the header must be a whole number of 0 or more, found {text[:40]!r}")
    return int(text)


def _point(row: str, number: int) -> tuple[float, float]:
    cells = row.split(",")
    try:
        frequency, amplitude = (float(cell) for cell in cells)
    except ValueError:
        raise ValueError(f"row {number} must hold two numbers, found {row[:40]!r}") from None
    if not (math.isfinite(frequency) and math.isfinite(amplitude) and frequency >= 0 and amplitude >= 0):
        raise ValueError(f"row {number} must hold finite numbers of 0 or more, found {row[:40]!r}")
    return frequency, amplitude
