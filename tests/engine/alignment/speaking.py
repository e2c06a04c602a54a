"""Words, and what a recogniser would hear of them, made by hand."""

import numpy as np

from phonemeengine.alignment.evidence import KINDS, MANNERS, Evidence, Manner, kind_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.text.pronunciation import Pronunciation, ScriptWord
from phonemeengine.text.syllables import SpokenSyllable

SURE = 0.9
LOUD_SPEECH = -20.0


def word(text: str, *spellings: str) -> ScriptWord:
    """A word whose pronunciations are spelt in IPA, a letter a sound; the text itself where none is given."""
    return ScriptWord(text, tuple(Pronunciation((SpokenSyllable(tuple(s), 1),)) for s in spellings or (text,)))


def words(text: str) -> list[ScriptWord]:
    return [word(part) for part in text.split()]


def heard(said: str, n_frames: int = 8) -> Evidence:
    """Each sound of what is said, for so many frames; a full stop is silence."""
    parts = [(0, Manner.SILENCE) if ipa == "." else (kind_of(ipa), KINDS[kind_of(ipa)].manner) for ipa in said]
    probabilities = np.full((len(parts), len(Phoneme)), (1 - SURE) / (len(Phoneme) - 1), np.float32)
    levels = np.zeros((len(parts), 2), np.float32)
    for k, (kind, manner) in enumerate(parts):
        probabilities[k, KINDS[kind].phoneme] = SURE
        blob = max(MANNERS[manner], key=lambda blob: blob.weight)
        levels[k] = LOUD_SPEECH + blob.loudness, LOUD_SPEECH + blob.loudness + blob.sharpness
    return Evidence(np.repeat(probabilities, n_frames, axis=0), np.repeat(levels, n_frames, axis=0))
