"""A voice and an aligner that say what a test wants, and note what they were asked for."""

from collections.abc import Iterator

import numpy as np

from phonemeanalyser.desktop.talk.words.scripts import ScriptedSound
from phonemeanalyser.desktop.talk.words.voice_model import Installed, VoiceChoice
from phonemeengine.errors import TextError
from phonemeengine.execution import Progress
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.text.espeak import Language
from tests.sounds import vowel

SENTENCE = 0.5
"""Seconds that the voice takes for a sentence."""
LANGUAGES = (
    Language("de", "German", "gmw/de"),
    Language("en-gb", "English (Great Britain)", "gmw/en"),
    Language("en-us", "English (America)", "gmw/en-US"),
)

INSTALLED = Installed(LANGUAGES, ("Reed", "croak", "f1", "f2", "klatt", "m1"))


def word(text: str, start: float, end: float, score: float | None = None) -> Word:
    """A word of one syllable: an s, and an o twice as long."""
    turn = start + (end - start) / 3
    phones = (Phone(start, turn, "s", Phoneme.SZ, score), Phone(turn, end, "o", Phoneme.O, score))
    return Word(text, (Syllable(phones),))


class FakeVoice:
    """Speaks each sentence as half a second of a vowel; each is one word.

    Attributes
    ----------
    asked : texts and languages.
    choices : the voices that were asked for.
    """

    def __init__(self) -> None:
        self.asked: list[tuple[str, str]] = []
        self.choices: list[VoiceChoice] = []

    def speak(self, text: str, language: str, voice: VoiceChoice) -> Iterator[SpokenSentence]:
        """Say a text."""
        self.asked.append((text, language))
        self.choices.append(voice)
        if language not in {known.tag for known in LANGUAGES}:
            raise TextError(f"there is no language {language!r}; choose another")
        samples = vowel((700, 1200, 2500), SENTENCE)
        return (
            SpokenSentence(np.asarray(samples, np.float32), (word(said.strip(), 0.1, 0.4),), said)
            for said in text.split(".")
            if said.strip()
        )


class FakeAligner:
    """Finds what it is told to find.

    Attributes
    ----------
    found : the answer.
    asked : what it was asked.
    """

    def __init__(self, found: Utterance) -> None:
        self.found = found
        self.asked: list[ScriptedSound] = []

    def align(self, script: ScriptedSound, progress: Progress) -> Utterance:
        """Align."""
        self.asked.append(script)
        progress(0.5)
        return self.found


def syllable(text: str, pinyin: str, start: float, end: float) -> Word:
    """A Chinese character: one syllable of an h and an a."""
    turn = (start + end) / 2
    phones = (Phone(start, turn, "x", Phoneme.UNIDENTIFIED), Phone(turn, end, "aʊ", Phoneme.A))
    return Word(text, (Syllable(phones, 0, pinyin),))
