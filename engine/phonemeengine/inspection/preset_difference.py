"""Where two presets hear something else in the same sound."""

import csv
import io
import os
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from phonemeengine.audio.files import SoundReader
from phonemeengine.execution import Progress, no_progress, subrange
from phonemeengine.inspection.whole_sound import FrameRange, FrameState, SoundTracks, analyse_whole, tracks_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, Channel

DIFFERENCE_COLUMNS = ("start_s", "end_s", "first", "second")


class DifferentStretch(NamedTuple):
    """A stretch in which two presets hear two things.

    Attributes
    ----------
    start, end : seconds.
    first, second : what each of them hears.
    """

    start: float
    end: float
    first: Phoneme
    second: Phoneme

    def row(self) -> tuple[str, str, str, str]:
        """Return it as a row of a table, as `DIFFERENCE_COLUMNS`."""
        return f"{self.start:.2f}", f"{self.end:.2f}", self.first.label, self.second.label


class PresetDifference(NamedTuple):
    """How differently two presets hear a sound.

    Attributes
    ----------
    share : of the frames, 0..1, in which they hear two things.
    stretches : where.
    """

    share: float
    stretches: tuple[DifferentStretch, ...]


def difference(
    sound: str | os.PathLike[str], first: Preset, second: Preset, *, channel: Channel = Channel.MIX,
    progress: Progress = no_progress,
) -> PresetDifference:  # fmt: skip
    """Hear a sound file with two presets, and return where they hear two things.

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
    stretches = tuple(
        DifferentStretch(
            (place.start + begin) * FRAME_PERIOD, (place.start + end) * FRAME_PERIOD,
            Phoneme(int(one[begin])), Phoneme(int(other[begin])),
        )
        for begin, end in pairwise(edges)
        if differs[begin]
    )  # fmt: skip
    return PresetDifference(float(differs.sum() / known.sum()), stretches)


def format_difference(found: PresetDifference) -> str:
    """Return the stretches as CSV with a line of names."""
    file = io.StringIO()
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(DIFFERENCE_COLUMNS)
    rows.writerows(stretch.row() for stretch in found.stretches)
    return file.getvalue()
