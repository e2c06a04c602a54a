"""Recordings of Mandarin whose syllables are labelled: their times move the mouth."""

import os
from collections.abc import Sequence
from pathlib import Path

from phonemeengine.errors import CorpusError, TextError
from phonemeengine.files import printable_name
from phonemeengine.labels.label import RawLabel, in_order
from phonemeengine.labels.phone_sets import own_phone_class
from phonemeengine.labels.text_io import read_text
from phonemeengine.labels.textgrid import Tier, tiers_of
from phonemeengine.labels.utterance import Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.letters import sound_of
from phonemeengine.speech.pinyin.phones import syllable_of

TIER_NAME = "syll"
"""What the name of a tier of syllables begins with, in small letters."""
HALF = 0.5
"""The share of a syllable that its onset's phone has: nobody has labelled that."""


def read_syllables(path: str | os.PathLike[str], duration: float) -> Utterance:
    """Read what is said in a recording from a TextGrid with a tier ``syllables`` of pinyin, tones written or not.

    Parameters
    ----------
    path : the TextGrid.
    duration : of the sound, seconds.

    Raises
    ------
    CorpusError : it cannot be read, has no such tier, or times are impossible.
    TextError : a label is no syllable of pinyin.
    """
    name = printable_name(Path(path))
    labels = in_order(_chosen(tiers_of(read_text(Path(path)), name), name).raw_labels, name, duration)
    words = tuple(_word_of(label, name) for label in labels if not _is_silence(label))
    return Utterance(words, max([duration, *(word.end for word in words)]))


def _chosen(tiers: Sequence[Tier], name: str) -> Tier:
    found = [tier for tier in tiers if tier.name.lower().startswith(TIER_NAME) and tier.raw_labels]
    if not found:
        names = ", ".join(repr(tier.name[:40]) for tier in tiers) or "none"
        raise CorpusError(
            f"{name}: there is no tier of intervals named 'syllables' with a label, found {names}; add it in Praat"
        )
    return found[0]


def _is_silence(label: RawLabel) -> bool:
    known = own_phone_class(label.name)
    return known is not None and known.phoneme is Phoneme.SILENCE


def _word_of(label: RawLabel, name: str) -> Word:
    try:
        sound = sound_of(label.name)
    except TextError as error:
        raise TextError(f"{name}, {label.place}: {error}") from error
    turn = label.start + HALF * (label.end - label.start)
    return Word(label.name, (syllable_of(sound, label.start, turn, label.end),))
