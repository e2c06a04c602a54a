"""Where the sounds of a known sentence are in a recording of it, so that presets can be judged by it.

The recording has no labels by hand. Its sounds are known, though, in order, and so they are aligned with the phonemes
of the shipped recogniser. That one is no part of the presets that are compared, unless one of them is the shipped one
itself: that one is favoured a little where two sounds meet. So what lies within 10 ms of such a place, or 30 ms of a
silence, does not count.
"""

import os
from collections.abc import Iterator, Sequence
from functools import lru_cache
from pathlib import Path

from phonemeengine.alignment.align import align_analyses
from phonemeengine.analyser import analyse_blocks
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.sentences import Sentence
from phonemeengine.calibration.takes.take import TRIMMED
from phonemeengine.errors import TakeError
from phonemeengine.labels.phone_sets import phone_classes_in
from phonemeengine.labels.utterance import CORE, UNKNOWN_WORD, Label, Utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.model_choice import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, Channel
from phonemeengine.storage.files import printable_name
from phonemeengine.text.pronunciation import ScriptWord

LEAST_FRAMES = 3
"""Of a sound that is read without haste, 10 ms each, in the mean."""
LONGEST = 30
"""Seconds of a sound that are read."""
SPOKEN = "read"
"""What the corpus of a sentence that was read is called, and its folder."""
AROUND, AROUND_SILENCE = 0.01, 0.03
"""What does not count on each side of a place where two sounds meet, seconds."""


def aligned(samples: Float32Array, said: Sentence | Sequence[ScriptWord]) -> tuple[Label, ...]:
    """Label a recording of a sentence by its known text.

    Where sounds meet, and around silence, labels have the certainty ``trimmed``: the place is not known that well.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz, ±1.
    said : what was read: a sentence, or the words of a text (`phonemeengine.words_of`).

    Raises
    ------
    TakeError : it is too short for the sentence, or something else was read.
    """
    words = said.words if isinstance(said, Sentence) else said
    duration = len(samples) / SAMPLE_RATE
    n_sounds = sum(len(word.pronunciations[0].phones) for word in words)
    if duration < LEAST_FRAMES * n_sounds * FRAME_PERIOD:
        raise TakeError("the recording is too short for this sentence; read all of it, without rushing")
    found = align_analyses(analyse_blocks([samples], _judge()), words, duration)
    if found.skipped or any(word.text == UNKNOWN_WORD for word in found.words):
        raise TakeError("the recording does not match this sentence; read it again exactly as shown, without rushing")
    return labels_of(found)


def read_sentence(
    sound: str | os.PathLike[str], said: Sentence | Sequence[ScriptWord], channel: Channel = Channel.MIX
) -> LabelledUtterance:
    """Return a recording of a sentence, labelled by its known text: what `calibrate` learns a voice from.

    Parameters
    ----------
    sound : the file; at most half a minute of it is read.
    said : as for `aligned`.
    channel : which channel of the file is analysed.

    Raises
    ------
    AudioError : the file cannot be read.
    TakeError : it is too short for the sentence, or something else was read.
    """
    path = Path(sound)
    with SoundReader(path, channel) as reader:
        samples = reader.read_mono(LONGEST * SAMPLE_RATE)
    try:
        labels = aligned(samples, said)
    except TakeError as error:
        raise TakeError(f"{printable_name(path)}: {error}") from error
    return LabelledUtterance(path, labels, path.stem, SPOKEN, channel=channel)


def labels_of(utterance: Utterance) -> tuple[Label, ...]:
    """Return the phones of an utterance, and the silence between them, as labels without gaps."""
    labels = [*_with_silence(utterance)]
    return tuple(part for k in range(len(labels)) for part in _parts_of(labels, k))


def _with_silence(utterance: Utterance) -> Iterator[Label]:
    at, silence = 0.0, Phoneme.SILENCE
    for phone in utterance.phones:
        if phone.start - at > FRAME_PERIOD / 2:
            yield Label(at, phone.start, silence.label, silence)
        sense = phone_classes_in(phone.ipa)[1]
        yield Label(phone.start, phone.end, phone.ipa, phone.phoneme, sense.certainty if sense else CORE)
        at = phone.end
    if utterance.duration - at > FRAME_PERIOD / 2:
        yield Label(at, utterance.duration, silence.label, silence)


def _parts_of(labels: Sequence[Label], k: int) -> list[Label]:
    """Return a label's middle, and what of it does not count, where it meets another class."""
    label = labels[k]
    before, after = (_around(label, labels[n]) if 0 <= n < len(labels) else 0.0 for n in (k - 1, k + 1))
    first = min(label.start + before, (label.start + label.end) / 2)
    last = max(first, label.end - after)
    parts = ((label.start, first, TRIMMED), (first, last, label.certainty), (last, label.end, TRIMMED))
    return [Label(a, b, label.phone, label.phoneme, c) for a, b, c in parts if b - a > FRAME_PERIOD / 2]


def _around(one: Label, other: Label) -> float:
    classes = {one.phoneme, other.phoneme}
    if len(classes) == 1:
        return 0.0
    return AROUND_SILENCE if Phoneme.SILENCE in classes else AROUND


@lru_cache(maxsize=1)
def _judge() -> Preset:
    return for_files(load_preset(DEFAULT_PRESET))
