"""The rows of a file's view as arrays: as many columns as pixels, however many frames lie under each."""

from typing import NamedTuple

import numpy as np

from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.arrays import Float32Array, Float64Array, IndexArray, UInt8Array, UInt32Array
from phonemeengine.dsp.waveform_peaks import Peaks
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.settings import FRAME_PERIOD


class PhonemeRuns(NamedTuple):
    """Stretches of frames in a row that have one phoneme and one state, each of shape (n_runs,).

    Attributes
    ----------
    starts, ends : seconds.
    codes : of the phonemes.
    """

    starts: Float64Array
    ends: Float64Array
    codes: UInt8Array


def columns_of(seen: TimeSpan, n_columns: int, n_frames: int) -> IndexArray:
    """Return the frame under the middle of each column, -1 where the sound has none, shape (n_columns,)."""
    times = seen.start + (np.arange(n_columns) + 0.5) / n_columns * seen.seconds
    frames = np.floor(times / FRAME_PERIOD + 1e-9).astype(np.int64)
    return np.where((frames >= 0) & (frames < n_frames), frames, -1)


def lane_pixels(tracks: SoundTracks, seen: TimeSpan, n_columns: int, colours: UInt32Array) -> UInt32Array:
    """Return the colour of each column of a lane of phonemes, shape (n_columns,).

    Parameters
    ----------
    colours : RGB by state and phoneme, shape (n_states, n_phonemes).
    """
    at = columns_of(seen, n_columns, tracks.n_frames)
    states = np.where(at < 0, FrameState.UNKNOWN, tracks.states[at])
    return np.ascontiguousarray(colours[states, tracks.phonemes[at]])


def wide_runs(tracks: SoundTracks, seen: TimeSpan, least: float) -> PhonemeRuns:
    """Return the runs in view that last so many seconds at least, as far as they are known and in view."""
    first = max(0, int(seen.start / FRAME_PERIOD))
    last = min(tracks.n_frames, int(seen.end / FRAME_PERIOD) + 1)
    codes, states = tracks.phonemes[first:last], tracks.states[first:last]
    changes = np.flatnonzero((codes[1:] != codes[:-1]) | (states[1:] != states[:-1])) + 1
    edges = np.concatenate(([0], changes, [len(codes)])) if len(codes) else np.zeros(1, np.int64)
    times = np.clip((edges + first) * FRAME_PERIOD, seen.start, seen.end)
    begins = edges[:-1]
    wide = (np.diff(times) >= least) & (states[begins] != FrameState.UNKNOWN)
    return PhonemeRuns(times[:-1][wide], times[1:][wide], codes[begins[wide]])


def wave_pixels(peaks: Peaks, loudest: float, height: int, colour: int, background: int) -> UInt32Array:
    """Return the outline of a waveform, RGB, shape (height, n_columns)."""
    middle = (height - 1) / 2
    scale = middle / loudest
    top, bottom = (np.nan_to_num(middle - values * scale, nan=-9.0) for values in (peaks.high, peaks.low))
    rows = np.arange(height)[:, np.newaxis]
    inside = (rows >= np.round(top)) & (rows <= np.round(bottom)) & ~np.isnan(peaks.low)
    return np.where(inside, np.uint32(colour), np.uint32(background)).astype(np.uint32)


def course_of(values: Float32Array, first: int, seen: TimeSpan, n_columns: int) -> tuple[Float64Array, Float64Array]:
    """Return the course of a variable as a line: times in seconds, and values; NaN where it is broken.

    Where several frames lie under a column, it goes through the lowest and the highest of them: no peak is lost.

    Parameters
    ----------
    values : of the frames from `first` on, shape (n,).
    """
    times: Float64Array = (first + np.arange(len(values), dtype=np.float64) + 0.5) * FRAME_PERIOD
    if len(values) <= 2 * n_columns:
        return times, values.astype(np.float64)
    columns = ((times - seen.start) / seen.seconds * n_columns).astype(np.int64)
    starts = np.concatenate(([0], np.flatnonzero(np.diff(columns)) + 1))
    low, high = np.fmin.reduceat(values, starts), np.fmax.reduceat(values, starts)
    middle: Float64Array = np.repeat(seen.start + (columns[starts] + 0.5) / n_columns * seen.seconds, 2)
    return middle, np.stack((low, high), axis=1).ravel().astype(np.float64)


def usual_course_of(
    values: Float32Array, first: int, seen: TimeSpan, n_columns: int
) -> tuple[Float64Array, Float64Array]:
    """Return the course of a variable as one line, however many frames lie under a column: see `usual_of`.

    Times in seconds, and values; NaN where it is broken. Parameters are those of `course_of`.
    """
    per_point = max(1, int(np.ceil(seen.seconds / FRAME_PERIOD / n_columns)))
    usual = usual_of(values[:, np.newaxis], per_point, first)[:, 0]
    times: Float64Array = (
        (first // per_point + np.arange(len(usual), dtype=np.float64) + 0.5) * per_point * FRAME_PERIOD
    )
    return times, usual.astype(np.float64)


def usual_of(values: Float32Array, n: int, first: int) -> Float32Array:
    """Return the median of every `n` frames, shape (n_groups, n_values); NaN where most of them have no value.

    Groups begin at multiples of `n`, so that they stay the same while the view scrolls.

    Parameters
    ----------
    values : of the frames from `first` on, shape (n_frames, n_values).
    """
    if n == 1 or not len(values):
        return values
    before, after = first % n, -(first + len(values)) % n
    groups = np.pad(values, ((before, after), (0, 0)), constant_values=np.nan).reshape(-1, n, values.shape[1])
    known = np.isfinite(groups).sum(axis=1)
    groups = np.sort(groups, axis=1)  # NaN comes last
    middle = np.take_along_axis(groups, np.maximum(known - 1, 0)[:, np.newaxis] // 2, axis=1)[:, 0]
    return np.where(2 * known >= n, middle, np.float32(np.nan)).astype(np.float32)
