"""People's recordings whose words are not known, from the files of games: a teacher knows what is said there."""

import io
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
import soundfile

from tools.voices.voice import Voice
from tools.voices.writing import Speaker, Utterance

PEOPLE = "human"  # kind of speaker in the manifest
SHORTEST, LONGEST = 0.3, 30.0  # s
QUIETEST = 0.01  # root mean square of the loudest 20 ms, full scale 1: below it there is no speech


class Source(NamedTuple):
    """What the manifest says of all recordings of a package."""

    corpus: str
    language: str
    licence: str
    package: str


Clip = Callable[[], tuple[np.ndarray, int]]
"""Return the samples of a recording, mono, -1..1, and their rate in hertz."""


def voices_of(source: Source, clips: Mapping[str, Sequence[Clip]], hero: str = "") -> list[Voice]:
    """A voice without phones for each speaker of a source, in the order of their names; `hero` is a man."""
    return [_voice(source, name, "male" if name == hero else "", clips[name]) for name in sorted(clips)]


def _voice(source: Source, name: str, sex: str, clips: Sequence[Clip]) -> Voice:
    speaker = Speaker(source.corpus, name, source.language, sex, PEOPLE, source.licence, source.package, "")
    return Voice(speaker, {}, lambda: _spoken(clips))


def _spoken(clips: Sequence[Clip]) -> Iterator[Utterance]:
    for clip in clips:
        sound, sample_rate = clip()
        if is_speech(sound, sample_rate):
            yield Utterance(sound, sample_rate, [], "")


def is_speech(sound: np.ndarray, sample_rate: int) -> bool:
    """Whether a recording is neither short nor long, and somewhere loud enough to hold speech."""
    if not SHORTEST <= len(sound) / sample_rate <= LONGEST:
        return False
    size = sample_rate // 50
    frames = sound[: len(sound) // size * size].reshape(-1, size)
    return bool(np.sqrt((frames**2).mean(axis=1)).max() > QUIETEST)


def decoded(file: bytes | Path) -> tuple[np.ndarray, int]:
    """Return the samples of a sound file, mono, and their rate in hertz; none of one without a sound."""
    try:
        sound, sample_rate = soundfile.read(io.BytesIO(file) if isinstance(file, bytes) else file, always_2d=True)
    except soundfile.LibsndfileError:
        return np.zeros(0), 1
    return sound.mean(axis=1), sample_rate


def from_bytes(samples: bytes, sample_rate: int) -> tuple[np.ndarray, int]:
    """Return unsigned samples of 8 bits as numbers in -1..1, without their mean, and their rate in hertz."""
    sound = (np.frombuffer(samples, dtype=np.uint8) - 128.0) / 128.0
    return sound - (sound.mean() if len(sound) else 0.0), sample_rate
