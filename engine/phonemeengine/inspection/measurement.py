"""The measures of a selection: how loud, how high, with which formants and phonemes; and the selection itself."""

import csv
import io
import math
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.wav import WavEncoder, check_wav_name
from phonemeengine.dsp.formants import CEILING, WINDOW_SECONDS, formants_of
from phonemeengine.errors import AudioError, EngineError
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.inspection.whole_sound import FrameRange, FrameState, SoundTracks, analyse_whole, tracks_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, Channel
from phonemeengine.storage.files import atomic_write, reason_of

N_FORMANTS = 3
"""Of each frame, in the table."""
AT_ONCE = 30.0
"""Seconds that are read at a time, so that the memory does not grow with the selection."""
QUIETEST = 1e-6
"""Amplitude, -120 dB; what is quieter counts as this."""
MEASUREMENT_COLUMNS = ("measure", "unit", "mean", "min", "max")
ANALYSIS_SHARE = 0.8
"""Of the work of measuring a file that is not analysed yet."""


class Statistics(NamedTuple):
    """Mean and range over those frames that have a value."""

    mean: float
    least: float
    most: float


@dataclass(frozen=True)
class StretchMeasurement:
    """The measures of a selection.

    Attributes
    ----------
    start, end : of the selection, seconds from the sound's beginning.
    level : root mean square of its samples, dB of full scale.
    peak : largest sample, dB of full scale.
    statistics : of the pitch ``f0`` and the formants ``F1`` to ``F3``, Hz, over the frames with a pitch, and of every
        measured variable over all frames; what no frame has is left out.
    shares : of the phonemes in its frames, 0..1; those that do not occur are left out.
    """

    start: float
    end: float
    level: float
    peak: float
    statistics: dict[str, Statistics]
    shares: dict[Phoneme, float]

    def rows(self) -> list[tuple[str, str, str, str, str]]:
        """Return a table of all of it: measure, unit, mean, min and max, as `MEASUREMENT_COLUMNS`."""
        found = [("duration", "s", f"{self.end - self.start:.3f}", "", "")]
        found += [("level", "dB", f"{self.level:.1f}", "", f"{self.peak:.1f}")]
        found += [
            (name, "Hz" if name in _IN_HERTZ else "", f"{s.mean:.5g}", f"{s.least:.5g}", f"{s.most:.5g}")
            for name, s in self.statistics.items()
        ]
        return found + [(p.label, "%", f"{100 * share:.1f}", "", "") for p, share in self.shares.items()]


_IN_HERTZ = {"f0", *(f"F{k + 1}" for k in range(N_FORMANTS))}


def measure(
    path: str | os.PathLike[str],
    start: float,
    end: float,
    preset: Preset,
    *,
    channel: Channel = Channel.MIX,
    ceiling: float = CEILING,
    progress: Progress = no_progress,
) -> StretchMeasurement:
    """Measure a selection of a sound file, which is analysed whole first, as `analyse_whole` does.

    Parameters
    ----------
    path : the sound file.
    start, end : of the selection, seconds; what lies beyond the sound is left out.
    preset : what is recognised with, by the best model that it has for files.
    channel : what is measured of a file of several channels.
    ceiling : Hz below which the formants are looked for: 5500 for women, 5000 for men, up to 8000 for children.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    AudioError : the file cannot be read, or the selection holds nothing of it.
    Cancelled : `progress` did not want to go on.
    """

    def open_sound() -> SoundReader:
        return SoundReader(path, channel)

    with open_sound() as reader:
        tracks = tracks_of(reader)
        frames_between(start, end, tracks.n_frames)  # before the work that would be in vain
    analyse_whole(open_sound, preset, tracks, progress=subrange(progress, 0.0, ANALYSIS_SHARE))
    return measure_stretch(
        open_sound, tracks, start, end, ceiling=ceiling, progress=subrange(progress, ANALYSIS_SHARE, 1.0)
    )


def measure_stretch(
    open_sound: Callable[[], SoundReader],
    tracks: SoundTracks,
    start: float,
    end: float,
    *,
    ceiling: float = CEILING,
    progress: Progress = no_progress,
) -> StretchMeasurement:
    """Measure a selection of a sound that is analysed already; see `measure`.

    Raises
    ------
    AudioError : the sound cannot be read, or the selection holds nothing of it.
    EngineError : the selection is not analysed yet.
    """
    frames = frames_between(start, end, tracks.n_frames)
    if not tracks.is_known(frames):
        raise EngineError("this segment is still being analysed; measure it in a moment")
    place = slice(frames.first, frames.last)
    features = tracks.features
    columns = {name: features[name][place] for name in features.names}
    pitch = columns.pop("f0", np.zeros(frames.last - frames.first, np.float32))
    voiced = pitch > 0
    with open_sound() as reader:
        measured = _measured(reader, frames, (start, end), ceiling, progress)
    values = {"f0": pitch[voiced]}
    values |= {f"F{k + 1}": measured.formants[voiced, k] for k in range(N_FORMANTS)}
    values |= columns
    statistics = {name: _statistics_of(v) for name, v in values.items() if np.isfinite(v).any()}
    codes, counts = np.unique(tracks.phonemes[place], return_counts=True)
    shares = {Phoneme(int(code)): float(n) / len(voiced) for code, n in zip(codes, counts, strict=True)}
    first, last = max(0.0, start), min(end, tracks.n_frames * FRAME_PERIOD)
    return StretchMeasurement(first, last, _decibels(measured.rms), _decibels(measured.peak), statistics, shares)


def save_stretch(
    path: str | os.PathLike[str],
    start: float,
    end: float,
    target: str | os.PathLike[str],
    *,
    channel: Channel = Channel.MIX,
) -> None:
    """Write a selection of a sound file as WAV of 24 bits at 44.1 kHz; the mix keeps all channels.

    Raises
    ------
    AudioError : the file cannot be read, the selection holds nothing of it, or the target cannot be written, or ends
        otherwise than WAV.
    """
    check_wav_name(Path(target))
    with SoundReader(path, channel, as_it_is=True) as reader:
        first, last = round(max(0.0, start) * SAMPLE_RATE), min(round(end * SAMPLE_RATE), reader.n_samples)
        if not end > start or last <= first:
            raise _nothing_there(start, end)
        reader.seek(first)
        n_channels = reader.n_channels if channel is Channel.MIX else 1
        try:
            with atomic_write(Path(target)) as file:
                encoder = WavEncoder(file, SAMPLE_RATE, n_channels)
                while first < last:
                    n = min(last - first, round(AT_ONCE * SAMPLE_RATE))
                    encoder.write(reader.read(n) if n_channels > 1 else reader.read_mono(n)[:, np.newaxis])
                    first += n
                encoder.close()
        except OSError as error:
            raise AudioError(
                f"{Path(target).name}: cannot be written ({reason_of(error)}); choose another folder"
            ) from error


def format_measurement(measurement: StretchMeasurement) -> str:
    """Return a measurement as CSV with a line of names."""
    file = io.StringIO()
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(MEASUREMENT_COLUMNS)
    rows.writerows(measurement.rows())
    return file.getvalue()


def format_frames(tracks: SoundTracks, start: float, end: float) -> str:
    """Return the frames of a selection of an analysed sound as a table with tabs.

    Its columns are time, phoneme, intensity, confidence, and every variable; cells are empty where nothing is known.

    Raises
    ------
    AudioError : the selection holds nothing of the sound.
    """
    frames = frames_between(start, end, tracks.n_frames)
    features, confidences = tracks.features, tracks.confidences(slice(*frames)).tolist()
    lines = ["\t".join(("time_s", "phoneme", "intensity", "confidence", *features.names))]
    for k in range(frames.first, frames.last):
        if tracks.states[k] == FrameState.UNKNOWN:
            lines.append(f"{(k + 0.5) * FRAME_PERIOD:.3f}" + "\t" * (3 + len(features.names)))
            continue
        numbers = (tracks.intensities[k], confidences[k - frames.first], *features.values[k])
        cells = ("" if math.isnan(number) else f"{number:.6g}" for number in numbers)
        lines.append("\t".join((f"{(k + 0.5) * FRAME_PERIOD:.3f}", Phoneme(int(tracks.phonemes[k])).label, *cells)))
    return "\n".join(lines) + "\n"


def frames_between(start: float, end: float, n_frames: int) -> FrameRange:
    """Return the frames whose middles lie between two times, seconds; the nearest one where there is none.

    Raises
    ------
    AudioError : its end lies before its start, or it lies beyond the sound.
    """
    if not end > start or end <= 0 or start >= n_frames * FRAME_PERIOD:
        raise _nothing_there(start, end)
    first = min(max(0, math.ceil(start / FRAME_PERIOD - 0.5 - 1e-6)), n_frames - 1)
    return FrameRange(first, min(max(first + 1, math.ceil(end / FRAME_PERIOD - 0.5 - 1e-6)), n_frames))


def _nothing_there(start: float, end: float) -> AudioError:
    return AudioError(f"there is no sound from {start:g} to {end:g} s; choose a segment within the sound")


class _Levels(NamedTuple):
    """What the samples of a selection give by themselves: amplitudes, and the formants of its frames."""

    rms: float
    peak: float
    formants: Float32Array


def _measured(
    reader: SoundReader, frames: FrameRange, times: tuple[float, float], ceiling: float, progress: Progress
) -> _Levels:
    """Go through a selection, some seconds at a time."""
    energy, n, peak, formants = 0.0, 0, 0.0, []
    margin, step = math.ceil(WINDOW_SECONDS / FRAME_PERIOD), round(AT_ONCE / FRAME_PERIOD)
    start, end = (round(max(0.0, time) * SAMPLE_RATE) for time in times)
    for first in range(frames.first, frames.last, step):
        last, begin = min(first + step, frames.last), max(0, first - margin)
        reader.seek(begin * HOP)
        samples = reader.read_mono((last + margin - begin) * HOP)
        found = formants_of(samples, first_frame=first - begin, n_frames=last - first, ceiling=ceiling)
        formants.append(found.frequencies[:, :N_FORMANTS])
        low = start if first == frames.first else first * HOP
        high = end if last == frames.last else last * HOP
        part = samples[max(0, low - begin * HOP) : max(0, high - begin * HOP)].astype(float)
        energy, n = energy + float(part @ part), n + len(part)
        peak = max(peak, float(np.abs(part).max(initial=0.0)))
        report_progress(progress, (last - frames.first) / (frames.last - frames.first))
    return _Levels(math.sqrt(energy / max(n, 1)), peak, np.concatenate(formants))


def _statistics_of(values: Float32Array) -> Statistics:
    known = values[np.isfinite(values)].astype(float)
    return Statistics(float(known.mean()), float(known.min()), float(known.max()))


def _decibels(amplitude: float) -> float:
    return 20 * math.log10(max(amplitude, QUIETEST))
