"""A whole sound, analysed in the background: what is in view first, then all of it, in bounded memory.

An hour takes some 60 MB: a byte for each phoneme, four for each measured variable, and an outline of the waveform.
Spectra are not kept; `phonemeengine.dsp.sonagram` draws them from the sound.
"""

import csv
import io
import os
from collections.abc import Callable, Iterator
from enum import IntEnum
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from phonemeengine.analyser import BLOCK, Analysis, analyse_blocks, analyse_range, sure_of
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.workbench.retuner import Retuner, front_end_key, names_of, recogniser_key, rules_in
from phonemeengine.dsp.framing import frame_count
from phonemeengine.dsp.waveform_peaks import WaveformPeaks
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.features.variables import SCORES, Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import for_files, while_played
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import Sensitivity, scores_in
from phonemeengine.recognition.segments import intensities_of
from phonemeengine.settings import FRAME_PERIOD, HOP, Channel, ModelKind

MOST_PREVIEWED = 6000
"""Frames of 10 ms that are analysed ahead of their turn, since they are in view."""


class FrameState(IntEnum):
    """What is known of a frame; the number is the code used in arrays (uint8)."""

    UNKNOWN = 0
    OUTDATED = 1
    """Found with settings that are no longer in force."""
    KNOWN = 2


class FrameRange(NamedTuple):
    """Frames first..last-1."""

    first: int
    last: int


class _Measured(NamedTuple):
    """Variables that were measured, and their values, which change together."""

    names: tuple[str, ...]
    columns: Float32Array


class SoundTracks:
    """What was found in each frame of a sound of known length; one thread writes, others may look.

    Attributes
    ----------
    n_frames : of the sound.
    states : codes of `FrameState`, uint8, shape (n_frames,).
    recognised, phonemes : as of `Analysis`, uint8, shape (n_frames,).
    intensities : as of `Analysis`, float32, shape (n_frames,).
    peaks : the outline of the waveform, as far as the sound was read.
    revision : another number after each change.
    n_written : how many blocks were measured and written.
    """

    def __init__(self, n_frames: int) -> None:
        self.n_frames = n_frames
        self.states: UInt8Array = np.zeros(n_frames, np.uint8)
        self.recognised, self.phonemes = np.zeros(n_frames, np.uint8), np.zeros(n_frames, np.uint8)
        self.intensities, self._confidences = (np.zeros(n_frames, np.float32) for _ in range(2))
        self._find_confidences: Callable[[slice], Float32Array] | None = None
        self._measured = _Measured((), np.zeros((0, n_frames), np.float32))
        self.peaks = WaveformPeaks()
        self.revision = self.n_written = 0

    @property
    def names(self) -> tuple[str, ...]:
        """The measured variables; empty until something is known."""
        return self._measured.names

    @property
    def columns(self) -> Float32Array:
        """The variables, float32, shape (n_names, n_frames)."""
        return self._measured.columns

    @property
    def values(self) -> Float32Array:
        """The same as a view, float32, shape (n_frames, n_names)."""
        return self.columns.T

    @property
    def features(self) -> Features:
        """Names and values that belong together, whatever another thread measures meanwhile."""
        measured = self._measured
        return Features(measured.names, measured.columns.T)

    def confidences(self, frames: slice = slice(None)) -> Float32Array:
        """Return the confidences of some frames, as of `Analysis`, float32, shape (n_frames,)."""
        return self._confidences[frames] if self._find_confidences is None else self._find_confidences(frames)

    def find_confidences(self, find: Callable[[slice], Float32Array]) -> None:
        """Have confidences worked out when they are asked for, and not while a threshold is dragged."""
        self._find_confidences = find

    def outdate(self) -> None:
        """Mark all that is known as found with other settings; it stays to be seen until it is found anew."""
        self.states[self.states == FrameState.KNOWN] = FrameState.OUTDATED
        self.revision += 1

    def write(self, analysis: Analysis) -> None:
        """Take what was found in a block of frames; what lies beyond the sound is left out."""
        part = analysis.part(slice(max(0, -analysis.start), max(0, self.n_frames - analysis.start)))
        if part.features.names != self.names:
            columns = np.full((len(part.features.names), self.n_frames), np.nan, np.float32)
            self._measured = _Measured(part.features.names, columns)
        place = slice(part.start, part.start + len(part))
        self.recognised[place], self.phonemes[place] = part.recognised, part.phonemes
        self.intensities[place] = part.intensities
        if self._find_confidences is not None:  # which was of what another preset says
            self._confidences[:], self._find_confidences = np.nan, None
        self._confidences[place], self.columns[:, place] = part.confidences, part.features.values.T
        self.states[place] = FrameState.KNOWN
        self.revision, self.n_written = self.revision + 1, self.n_written + 1

    def is_known(self, frames: FrameRange) -> bool:
        """Return whether all of some frames are known, as the settings in force have them."""
        return bool((self.states[max(0, frames.first) : frames.last] == FrameState.KNOWN).all())


def analyse_whole(
    open_sound: Callable[[], SoundReader],
    preset: Preset,
    tracks: SoundTracks,
    *,
    in_view: Callable[[], FrameRange] = lambda: FrameRange(0, 0),
    progress: Progress = no_progress,
    most_previewed: int = MOST_PREVIEWED,
) -> None:
    """Analyse a whole sound into tracks, as `analyse_file` does; what is in view is found first.

    What is found ahead of its turn is found once more when its turn comes: settings that remember, such as smoothing
    over time, may then say a little different.

    Parameters
    ----------
    open_sound : opens the sound; it is read at two places at once.
    preset : what is recognised with.
    tracks : made for this sound; what they know is outdated first.
    in_view : asked again and again for what is in view.
    progress : called with the share that is done, 0..1.
    most_previewed : frames of that which are found ahead of their turn at most.

    Raises
    ------
    AudioError : the sound cannot be read; what was found stays.
    Cancelled : `progress` did not want to go on; what was found stays.
    """
    tracks.outdate()
    with open_sound() as reader, open_sound() as ahead:
        seen = FrameRange(0, 0)

        def preview(done: int) -> None:
            nonlocal seen
            wanted = in_view()
            if wanted != seen:
                seen = wanted
                _find(ahead, preset, tracks, FrameRange(max(wanted.first, done), wanted.last), most_previewed)

        passes = _passes_of(preset)
        for k, passed in enumerate(passes):
            reader.seek(0)
            part = subrange(progress, k / len(passes), (k + 1) / len(passes))
            report_progress(part, 0.0)
            blocks = _outlined(reader.blocks(BLOCK * HOP), tracks)
            preview(0)
            for analysis in analyse_blocks(blocks, passed, pitch=True):
                tracks.write(analysis)
                done = analysis.start + len(analysis)
                report_progress(part, min(1.0, done / tracks.n_frames))
                if k == 0:
                    preview(done)
    report_progress(progress, 1.0)


def _passes_of(preset: Preset) -> list[Preset]:
    """Return the models of a sound, one after the other: that for files, and before a slow one a fast one."""
    last = for_files(preset)
    return [while_played(preset), last] if last.model_kind is ModelKind.WHISPER else [last]


def _outlined(blocks: Iterator[Float32Array], tracks: SoundTracks) -> Iterator[Float32Array]:
    """Give the blocks of a sound on, and let its outline grow by what it does not hold yet."""
    position = 0
    for block in blocks:
        fresh = tracks.peaks.n_samples - position
        if fresh < len(block):
            tracks.peaks.push(block[max(0, fresh) :])
        position += len(block)
        yield block


def _find(reader: SoundReader, preset: Preset, tracks: SoundTracks, frames: FrameRange, most: int) -> None:
    """Find what is wanted of some frames ahead of their turn."""
    first, last = max(0, frames.first), min(frames.last, frames.first + most, tracks.n_frames)
    if last > first and not tracks.is_known(FrameRange(first, last)):
        for analysis in analyse_range(reader, first, last, preset, pitch=True):
            tracks.write(analysis)


def tracks_of(reader: SoundReader) -> SoundTracks:
    """Return empty tracks for a sound."""
    return SoundTracks(frame_count(reader.n_samples))


# A sound that is analysed already, and recognised anew while a threshold is dragged: without the sound, at once.


class RetunedSound:
    """Recognises a sound anew with presets of the same front end, as `analyse_whole` would.

    Parameters
    ----------
    tracks : of the sound, all of it known.
    preset : with which it was analysed.
    """

    def __init__(self, tracks: SoundTracks, preset: Preset) -> None:
        self._tracks = tracks
        self._key = _key_of(preset)
        scores = _scores_in(tracks)
        if scores is not None:  # what they were before the sensitivities
            less = {phoneme: -value for phoneme, value in preset.sensitivities.items()}
            scores = Sensitivity(less).apply(scores.T).T
        values = {name: tracks.columns[tracks.names.index(name)] for name in names_of(preset)}
        self._retuner = Retuner(values, tracks.recognised.copy(), scores, np.array([0, tracks.n_frames]))
        self._levels = tracks.columns[tracks.names.index("volume")]
        self._loudness: tuple[tuple[float, float], Float32Array] | None = None

    def retune(self, preset: Preset) -> bool:
        """Write into the tracks what another preset says; says whether that can be known without the sound."""
        if _key_of(preset) != self._key:
            return False
        tracks, settings = self._tracks, preset.settings
        tracks.recognised[:], codes = self._retuner.recognise(for_files(preset))
        scores = self._retuner.scores(preset)
        tracks.phonemes[:] = codes
        bounds = settings.intensity_low, settings.intensity_high
        if self._loudness is None or self._loudness[0] != bounds:
            self._loudness = bounds, intensities_of(self._levels, *bounds)
        tracks.intensities[:] = self._loudness[1]
        tracks.intensities[codes == 0] = 0
        if scores is not None:
            first = tracks.names.index(SCORES[0])
            tracks.columns[first : first + len(SCORES)] = scores
        tracks.find_confidences(lambda frames: _confidences_in(tracks, preset, frames))
        tracks.states[:] = FrameState.KNOWN
        tracks.revision += 1
        return True


def _confidences_in(tracks: SoundTracks, preset: Preset, frames: slice) -> Float32Array:
    """Return the confidences of some frames that were recognised with a preset."""
    rules, found = rules_in(preset), [np.zeros(0, np.float32)]
    codes, values = tracks.phonemes[frames], tracks.values[frames]
    for first in range(0, len(codes), BLOCK):
        part = Features(tracks.names, values[first : first + BLOCK])
        deficits = rules.deficits(part) if rules is not None and preset.is_measured else None
        scores = scores_in(part) if rules is None else None
        found.append(sure_of(for_files(preset), codes[first : first + BLOCK], scores, deficits))
    return np.concatenate(found)


def _key_of(preset: Preset) -> object:
    """Return all that must be equal for answers to be known without the sound."""
    by_rules = rules_in(preset) is not None
    return front_end_key(preset), preset.file_model, preset.model_kind, None if by_rules else recogniser_key(preset)


def _scores_in(tracks: SoundTracks) -> np.ndarray | None:
    if SCORES[0] not in tracks.names:
        return None
    first = tracks.names.index(SCORES[0])
    return tracks.columns[first : first + len(SCORES)].copy()


# Where two presets recognise different phonemes in the same sound.

DIFFERENCE_COLUMNS = ("start_s", "end_s", "first", "second")


class DifferentSegment(NamedTuple):
    """A segment in which two presets differ.

    Attributes
    ----------
    start, end : seconds.
    first, second : what each of them recognises.
    """

    start: float
    end: float
    first: Phoneme
    second: Phoneme

    def row(self) -> tuple[str, str, str, str]:
        """Return it as a row of a table, as `DIFFERENCE_COLUMNS`."""
        return f"{self.start:.2f}", f"{self.end:.2f}", self.first.label, self.second.label


class PresetDifference(NamedTuple):
    """How much two presets differ on a sound.

    Attributes
    ----------
    share : of the frames, 0..1, in which they differ.
    segments : where.
    """

    share: float
    segments: tuple[DifferentSegment, ...]


def difference(
    sound: str | os.PathLike[str],
    first: Preset,
    second: Preset,
    *,
    channel: Channel = Channel.MIX,
    progress: Progress = no_progress,
) -> PresetDifference:
    """Recognise a sound file with two presets, and return where they differ.

    Raises
    ------
    AudioError : the file cannot be read.
    Cancelled : `progress` did not want to go on.
    """
    found = []
    for k, preset in enumerate((first, second)):
        with SoundReader(sound, channel) as reader:
            tracks = tracks_of(reader)
        part = subrange(progress, k / 2, (k + 1) / 2)
        analyse_whole(lambda: SoundReader(sound, channel), preset, tracks, progress=part)
        found.append(tracks)
    return difference_in(found[0], found[1], FrameRange(0, found[0].n_frames))


def difference_in(first: SoundTracks, second: SoundTracks, frames: FrameRange) -> PresetDifference:
    """Return where two analyses of one sound differ, in some of its frames that both know."""
    place = slice(max(0, frames.first), min(frames.last, first.n_frames, second.n_frames))
    known = (first.states[place] == FrameState.KNOWN) & (second.states[place] == FrameState.KNOWN)
    one, other = first.phonemes[place], second.phonemes[place]
    differs = known & (one != other)
    if not differs.any():
        return PresetDifference(0.0, ())
    changes = np.flatnonzero((one[1:] != one[:-1]) | (other[1:] != other[:-1]) | (differs[1:] != differs[:-1])) + 1
    edges = [0, *changes.tolist(), len(one)]
    segments = tuple(
        DifferentSegment(
            (place.start + begin) * FRAME_PERIOD,
            (place.start + end) * FRAME_PERIOD,
            Phoneme(int(one[begin])),
            Phoneme(int(other[begin])),
        )
        for begin, end in pairwise(edges)
        if differs[begin]
    )
    return PresetDifference(float(differs.sum() / known.sum()), segments)


def format_difference(found: PresetDifference) -> str:
    """Return the segments as CSV with a line of names."""
    file = io.StringIO()
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(DIFFERENCE_COLUMNS)
    rows.writerows(segment.row() for segment in found.segments)
    return file.getvalue()
