"""What the answers of other recognisers mean here, and by how much they come late."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from phonemeengine.arrays import UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels, frame_labels_of
from phonemeengine.calibration.scores.evaluation import shifted_frames
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.labels.phone_sets import (
    PhoneClass,
    ipa_class,
    labels_named,
    own_phone_class,
    phone_classes_in,
    split_ipa,
)
from phonemeengine.labels.utterance import RawLabel
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.settings import FRAME_PERIOD

Mark = tuple[float, float, str]
"""When an answer begins and ends, seconds, and its name."""
ClassOf = Callable[[str], PhoneClass | None]
"""Gives what a name stands for; None for one that is no sound of its own, such as a tone or a mark of stress."""

VISEMES = {
    "sil": Phoneme.SILENCE,
    "aa": Phoneme.A,
    "E": Phoneme.E,
    "I": Phoneme.I,
    "O": Phoneme.O,
    "U": Phoneme.U,
    "PP": Phoneme.P,
    "SS": Phoneme.SZ,
    "CH": Phoneme.SCH,
    **dict.fromkeys(("TH", "DD", "FF", "kk", "nn", "RR"), Phoneme.UNIDENTIFIED),
}
"""The visemes of Oculus as HeadAudio has them, each as a phoneme of its mouth shape."""

TENSE = "\N{COMBINING DOUBLE VERTICAL LINE BELOW}"
"""The mark of tense consonants of Korean."""
FASTEST, SLOWEST = -0.1, 0.4
"""Delays that are tried, seconds."""


def arpabet_class(name: str) -> PhoneClass | None:
    """Return what a phone of PocketSphinx stands for; noises that are no speech are silence."""
    if name == "+NSN+":
        return PhoneClass(Phoneme.SILENCE)
    return own_phone_class(name.strip("+")) or phone_classes_in(name)[0]


def ipa_token_class(name: str) -> PhoneClass | None:
    """Return what a token of IPA stands for; glide and vowel count as the vowel, tense consonants as plain ones."""
    if name.startswith("<"):
        return None
    name = name.replace(TENSE, "")
    known = phone_classes_in(name)[1]
    if known is not None:
        return known
    symbols = [found for symbol in split_ipa(name) if (found := ipa_class(symbol)) is not None]
    vowels = [found for found in symbols if found.phoneme in VOWELS]
    return next(iter(vowels or symbols), None)


def viseme_class(name: str) -> PhoneClass | None:
    """Return the phoneme that stands for a viseme."""
    return PhoneClass(VISEMES[name])


def frames_of(marks: Sequence[Mark], class_of: ClassOf, longest: float = math.inf) -> UInt8Array:
    """Return what was answered in each frame: codes of `Phoneme`, uint8, shape (n_frames,).

    Parameters
    ----------
    marks : the answers in order of time; where there is none, there is silence.
    class_of : gives what their names stand for.
    longest : seconds that an answer lasts at most.
    """
    classes = {name: class_of(name) for _, _, name in marks}
    raw: list[RawLabel] = []
    for start, end, name in marks:
        if classes[name] is not None:
            raw.append(RawLabel(start, end, name, ""))
        elif raw:  # the sound before it goes on
            raw[-1] = replace(raw[-1], end=end)
    raw = [replace(label, end=min(label.end, label.start + longest)) for label in raw]
    labels = labels_named(raw, {name: found for name, found in classes.items() if found is not None})
    return frame_labels_of(labels).phonemes if labels else np.zeros(0, np.uint8)


def best_delay(
    labels: Sequence[FrameLabels], answers: Sequence[UInt8Array], judged_by: Callable[[Scores], float]
) -> tuple[int, float]:
    """Return the constant delay of answers that scores best, in frames, and its figure; of equals the shortest."""
    delays = sorted(range(round(FASTEST / FRAME_PERIOD), round(SLOWEST / FRAME_PERIOD) + 1), key=abs)
    figures = [judged_by(scores_of(zip(labels, delayed(labels, answers, delay), strict=True))) for delay in delays]
    best = int(np.argmax(figures))
    return delays[best], figures[best]


def delayed(labels: Sequence[FrameLabels], answers: Sequence[UInt8Array], delay: int) -> tuple[UInt8Array, ...]:
    """Return answers that came late by some frames where they belong, as many as there are labels."""
    pairs = zip(labels, answers, strict=True)
    return tuple(shifted_frames(answer, delay, len(truth.phonemes)) for truth, answer in pairs)
