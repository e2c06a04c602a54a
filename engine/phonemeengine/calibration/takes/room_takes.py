"""What takes say of the room they were recorded in, and of the speech in it."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.takes.room_noise import LEAST_SECONDS
from phonemeengine.labels.label import CORE
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE

BRIEF = frozenset({Phoneme.P, Phoneme.UNIDENTIFIED})
"""What is no speech to measure by: puffs are mostly the room."""


def room_in(takes: Sequence[LabelledUtterance]) -> Float32Array | None:
    """Return the sound of the newest take in which nobody speaks, float32, shape (n,), 44.1 kHz; None without one.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    for take in reversed(takes):
        phonemes = {label.phoneme for label in take.labels if label.certainty == CORE}
        if phonemes == {Phoneme.SILENCE}:
            room = _joined(_stretches(take))
            if len(room) >= LEAST_SECONDS * SAMPLE_RATE:
                return room
    return None


def speech_in(takes: Sequence[LabelledUtterance]) -> Float32Array | None:
    """Return what is surely said in takes, without pauses and p, one after the other; None where nothing is.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    found = _joined(part for take in takes for part in _stretches(take, without=BRIEF | {Phoneme.SILENCE}))
    return found if len(found) else None


def _stretches(take: LabelledUtterance, without: frozenset[Phoneme] = BRIEF) -> Iterator[Float32Array]:
    """Return the sound of each label that is certain."""
    wanted = [label for label in take.labels if label.certainty == CORE and label.phoneme not in without]
    if not wanted:
        return
    with SoundReader(take.path, as_it_is=True) as reader:
        sound = reader.read_mono()
    for label in wanted:
        yield sound[round(label.start * SAMPLE_RATE) : round(label.end * SAMPLE_RATE)]


def _joined(parts: Iterable[Float32Array]) -> Float32Array:
    return np.concatenate([np.zeros(0, np.float32), *parts])
