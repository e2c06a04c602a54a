"""Averaged spectra: accumulated, kept as small text files, compared on one frequency axis."""

import csv
import io
import json
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import CurveError
from phonemeengine.settings import BIN_WIDTH, FRAME_PERIOD, HOP, WINDOW, Channel
from phonemeengine.storage.files import read_text_file, write_file

FORMAT = "phonemeanalyser curve 1"
COLUMNS = ["frequency_hz", "amplitude"]
SPREAD = "spread_db"
"""The third column, of curves whose spread is known."""
LARGEST_FILE = 4 << 20
MOST_BINS = 1 << 14
QUIETEST = 1e-5
"""Amplitude, -100 dB; what is quieter counts as this in levels and their spread."""


class SoundPart(NamedTuple):
    """What is averaged of a sound file.

    Attributes
    ----------
    path : the file.
    channel : what is analysed of a sound that has several.
    spans : starts and ends, seconds; frames count whose middles lie within.
    """

    path: Path
    channel: Channel
    spans: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class AveragedSpectrum:
    """An averaged spectrum.

    Attributes
    ----------
    name : what people call it, such as the speaker and the sound.
    frequencies : float64, shape (n_bins,), rising, Hz.
    amplitudes : float64, shape (n_bins,), 0 or more: the mean of the frames' amplitudes.
    n_frames : how many frames were averaged.
    front_end : in words, which filters shaped the spectra.
    since : in words, what was averaged, or what the average begins with; empty where unknown.
    level : root mean square of the frames' samples before all filters, dB of full scale; NaN where unknown.
    spread : float64, shape (n_bins,), dB: the standard deviation of the frames' levels; None where unknown.
    parts : what was averaged of which sound files; empty where there are none.
    colour : in which it is drawn, as #rrggbb; empty for any.
    hidden : whether it is left out of the plot.
    """

    name: str
    frequencies: Float64Array
    amplitudes: Float64Array
    n_frames: int
    front_end: str
    since: str = ""
    level: float = math.nan
    spread: Float64Array | None = None
    parts: tuple[SoundPart, ...] = ()
    colour: str = ""
    hidden: bool = False

    @property
    def seconds(self) -> float:
        """Duration of the frames that were averaged."""
        return self.n_frames * FRAME_PERIOD

    @property
    def levels(self) -> Float64Array:
        """The amplitudes in dB, -100 at least, shape (n_bins,)."""
        return np.asarray(20 * np.log10(np.maximum(self.amplitudes, QUIETEST)))

    def is_same(self, other: "AveragedSpectrum") -> bool:
        """Return whether both are the same average, whatever they are called and however they are drawn."""
        return (
            (self.n_frames, self.front_end) == (other.n_frames, other.front_end)
            and len(self.amplitudes) == len(other.amplitudes)
            and np.allclose(self.frequencies, other.frequencies, rtol=1e-6)
            and np.allclose(self.amplitudes, other.amplitudes, rtol=1e-6, atol=0)
        )

    def at(self, frequencies: Float64Array) -> Float64Array:
        """Return the amplitudes at other frequencies (Hz), linear between bins, NaN beyond the curve's end."""
        return np.interp(frequencies, self.frequencies, self.amplitudes, right=np.nan)


class SpectrumAverage:
    """The running mean of spectra, and the spread of their levels; begins anew when the number of bins changes."""

    def __init__(self) -> None:
        self.clear()

    def add(self, spectra: Float32Array, windows: Float32Array | None = None) -> None:
        """Take in a block of spectra, shape (n_frames, n_bins), and the samples they are of, shape (n_frames, 2048).

        Without the samples the level is not known.
        """
        if spectra.shape[1] != len(self._sum):
            self.clear(spectra.shape[1])
        levels = 20 * np.log10(np.maximum(spectra, np.float32(QUIETEST)))
        self._sum += spectra.sum(axis=0, dtype=np.float64)
        self._levels += levels.sum(axis=0, dtype=np.float64)
        self._squares += np.square(levels, dtype=np.float64).sum(axis=0)
        self.n_frames += len(spectra)
        # of each frame its own 10 ms, since windows overlap
        own = np.full((1, 1), np.nan) if windows is None else windows[:, (WINDOW - HOP) // 2 : (WINDOW + HOP) // 2]
        self._power += float(np.square(own, dtype=np.float64).sum()) / HOP

    def clear(self, n_bins: int = 0) -> None:
        """Forget everything; the next spectra have this many bins, or any."""
        self.n_frames = 0
        self._sum, self._levels, self._squares = np.zeros((3, n_bins))
        self._power = 0.0

    def curve(self, name: str, front_end: str, since: str = "") -> AveragedSpectrum:
        """Return the mean so far; bins lie at multiples of 21.53 Hz."""
        n_bins, n = len(self._sum), max(self.n_frames, 1)
        variances = self._squares / n - (self._levels / n) ** 2
        return AveragedSpectrum(
            name,
            np.arange(n_bins, dtype=float) * BIN_WIDTH,
            self._sum / n,
            self.n_frames,
            front_end,
            since,
            10 * math.log10(max(self._power / n, QUIETEST**2)) if self.n_frames else math.nan,
            np.sqrt(np.maximum(variances, 0.0)) if self.n_frames else None,
        )


def distance_of(one: AveragedSpectrum, other: AveragedSpectrum) -> float:
    """Measure how differently two curves are shaped, in dB.

    The root mean square of their difference in dB, over the frequencies that both have, after the mean difference
    (loudness) is taken away; amplitudes below -80 dB of full scale count as -80 dB. NaN where nothing is shared.
    It is the measure d2 between log spectra of A. Gray and J. Markel ("Distance measures for speech processing", IEEE
    Trans. ASSP 24(5), 1976), with the gain taken away. See `check_comparable` for what may be compared.
    """
    finer = one if len(one.frequencies) >= len(other.frequencies) else other
    levels = [20 * np.log10(np.maximum(curve.at(finer.frequencies), 1e-4)) for curve in (one, other)]
    difference = levels[0] - levels[1]
    difference = difference[np.isfinite(difference)]
    return float(difference.std()) if len(difference) else math.nan


def check_comparable(one: AveragedSpectrum, other: AveragedSpectrum) -> None:
    """Refuse to compare two averages that were measured in different ways.

    Raises
    ------
    CurveError : their front ends differ, or their frequencies.
    """
    if one.front_end != other.front_end:
        mine, theirs = (curve.front_end.split(", ") for curve in (one, other))
        differ = [[words for words in mine if words not in theirs], [words for words in theirs if words not in mine]]
        said = [", ".join(own) or f"no {', '.join(others)}" for own, others in (differ, differ[::-1])]
        raise CurveError(
            f"{one.name} and {other.name} went through different filters ({said[0]} against {said[1]}); measure them "
            "again with the same ones"
        )
    n = min(len(one.frequencies), len(other.frequencies))
    if not np.allclose(one.frequencies[:n], other.frequencies[:n], rtol=1e-6):
        raise CurveError(
            f"{one.name} and {other.name} have different frequencies; average the sound of one of them again"
        )


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
    level = "" if math.isnan(curve.level) else f"{curve.level:.2f} dB"
    drawn = {"since": curve.since, "level": level, "colour": curve.colour, "hidden": "yes" if curve.hidden else ""}
    header |= {key: value for key, value in drawn.items() if value}
    lines = [f"# {FORMAT}", *(f"# {key}: {' '.join(str(value).split())}" for key, value in header.items())]
    lines += [f"# sound: {json.dumps([str(p.path), p.channel, p.spans])}" for p in curve.parts]
    columns = [curve.frequencies, curve.amplitudes] + ([] if curve.spread is None else [curve.spread])
    lines.append(",".join([*COLUMNS, SPREAD][: len(columns)]))
    lines += [",".join(f"{number:.9g}" for number in row) for row in zip(*columns, strict=True)]
    return "".join(line + "\n" for line in lines)


def format_spectra(curves: Sequence[AveragedSpectrum]) -> str:
    """Return averages as one table, CSV: the frequency, and of each curve its level and its spread, dB.

    Rows are those of the curve with the most bins; cells are empty where a curve ends, or its spread is unknown.
    """
    frequencies = max((curve.frequencies for curve in curves), key=len, default=np.zeros(0))
    columns: dict[str, Float64Array] = {"frequency_hz": frequencies}
    for k, curve in enumerate(curves):
        name = curve.name if [c.name for c in curves].count(curve.name) == 1 else f"{curve.name} ({k + 1})"
        columns[f"{name} level_db"] = 20 * np.log10(np.maximum(curve.at(frequencies), QUIETEST))
        spread = np.full(len(curve.frequencies), np.nan) if curve.spread is None else curve.spread
        columns[f"{name} {SPREAD}"] = np.interp(frequencies, curve.frequencies, spread, right=np.nan)
    return _csv_of(
        [list(columns), *([_cell(number) for number in row] for row in zip(*columns.values(), strict=True))]
    )


def format_distances(curves: Sequence[AveragedSpectrum]) -> str:
    """Return the difference of each pair of averages, dB, as CSV; empty where two cannot be compared."""
    names = [curve.name for curve in curves]
    rows = [[one.name, *(_cell(_comparable_distance(one, other)) for other in curves)] for one in curves]
    return _csv_of([["difference_db", *names], *rows])


def _comparable_distance(one: AveragedSpectrum, other: AveragedSpectrum) -> float:
    try:
        check_comparable(one, other)
    except CurveError:
        return math.nan
    return distance_of(one, other)


def _cell(number: float) -> str:
    return "" if math.isnan(number) else f"{number:.6g}"


def _csv_of(rows: Sequence[Sequence[str]]) -> str:
    file = io.StringIO()
    csv.writer(file, lineterminator="\n").writerows(rows)
    return file.getvalue()


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
        raise CurveError(f"{path.name}: {error}; choose a file saved by Save Curve") from error


def _parse(lines: list[str]) -> AveragedSpectrum:
    if not lines or lines[0].strip() != f"# {FORMAT}":
        raise ValueError(f"a curve begins with the line '# {FORMAT}', this does not")
    comments = [line[1:].partition(":") for line in lines[1:] if line.startswith("#")]
    header = {key.strip(): value.strip() for key, _, value in comments}
    rows = [line for line in lines if not line.startswith("#")]
    columns = rows[0].split(",") if rows else []
    if columns not in (COLUMNS, [*COLUMNS, SPREAD]):
        raise ValueError(f"the columns must be {','.join(COLUMNS)}, found {rows[0][:60] if rows else 'none'!r}")
    for key in ("name", "front end", "bins", "frames"):
        if key not in header:
            raise ValueError(f"the header lacks '{key}'")
    n = len(columns)
    points = np.array([_point(row, number, n) for number, row in enumerate(rows[1:], 1)]).reshape(-1, n)
    n_bins, n_frames = _count(header, "bins"), _count(header, "frames")
    if len(points) != n_bins or not 1 <= n_bins <= MOST_BINS:
        raise ValueError(f"the header announces {n_bins} bins (1..{MOST_BINS}), found {len(points)}")
    if np.any(np.diff(points[:, 0]) <= 0):
        raise ValueError("the frequencies must rise from row to row")
    colour = header.get("colour", "")
    return AveragedSpectrum(
        header["name"],
        points[:, 0],
        points[:, 1],
        n_frames,
        header["front end"],
        header.get("since", ""),
        float(found[1])
        if (found := re.fullmatch(r"(-?\d{1,3}(?:\.\d+)?) dB", header.get("level", "")))
        else math.nan,
        points[:, 2] if n > len(COLUMNS) else None,
        tuple(_part_of(value) for key, _, value in comments if key.strip() == "sound"),
        colour if re.fullmatch("#[0-9a-fA-F]{6}", colour) else "",
        header.get("hidden") == "yes",
    )


def _part_of(words: str) -> SoundPart:
    """Read what was averaged of a sound."""
    try:
        path, channel, spans = json.loads(words)
        return SoundPart(Path(path), Channel(channel), tuple((float(start), float(end)) for start, end in spans))
    except (ValueError, TypeError, RecursionError):
        fault = f"'sound' in the header must be [path, channel, [[start, end], ...]], found {words.strip()[:60]!r}"
        raise ValueError(fault) from None


def _count(header: dict[str, str], key: str) -> int:
    text = header[key]
    if not (text.isascii() and text.isdigit() and len(text) <= 12):
        raise ValueError(f"'{key}' in the header must be a whole number of 0 or more, found {text[:40]!r}")
    return int(text)


def _point(row: str, number: int, n_columns: int) -> list[float]:
    cells = row.split(",")
    try:
        numbers = [float(cell) for cell in cells]
    except ValueError:
        numbers = []
    if len(numbers) != n_columns:
        raise ValueError(f"row {number} must hold {n_columns} numbers, found {row[:40]!r}")
    if not all(math.isfinite(each) and each >= 0 for each in numbers):
        raise ValueError(f"row {number} must hold finite numbers of 0 or more, found {row[:40]!r}")
    return numbers
