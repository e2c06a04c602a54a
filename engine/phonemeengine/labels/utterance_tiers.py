"""What a voice said, as a TextGrid: tiers of words, syllables and phones, without gaps."""

from collections.abc import Iterable, Iterator

from phonemeengine.labels.label import ROUNDING
from phonemeengine.labels.textgrid import Interval, format_tiers
from phonemeengine.labels.utterance import Syllable, Utterance

SILENCE = "sil"
STRESS_MARKS = ("", "ˈ", "ˌ")
"""What stands before a syllable in the IPA, by its stress."""


def format_spoken(utterance: Utterance) -> str:
    """Return the text of a TextGrid with the words, syllables and phones of an utterance.

    Silence is ``sil``; syllables that have no text of their own are written in IPA, with their stress.
    """
    words = [(word.start, word.end, word.text) for word in utterance.words]
    syllables = [(s.start, s.end, _name_of(s)) for word in utterance.words for s in word.syllables]
    phones = [(phone.start, phone.end, phone.ipa or phone.phoneme.label) for phone in utterance.phones]
    tiers = {"words": words, "syllables": syllables, "phones": phones}
    filled = {name: list(_with_silence(stretches, utterance.duration)) for name, stretches in tiers.items()}
    return format_tiers(filled, utterance.duration)


def stress_in(name: str) -> int:
    """Return the stress of a syllable, as `Syllable` has it, by the mark that its name begins with."""
    return next((stress for stress, mark in enumerate(STRESS_MARKS) if mark and name.startswith(mark)), 0)


def _name_of(syllable: Syllable) -> str:
    return syllable.text or STRESS_MARKS[syllable.stress] + "".join(phone.ipa for phone in syllable.phones)


def _with_silence(stretches: Iterable[Interval], duration: float) -> Iterator[Interval]:
    at = 0.0
    for start, end, text in stretches:
        if start > at + ROUNDING:
            yield at, start, SILENCE
        yield start, end, text
        at = end
    if duration > at + ROUNDING:
        yield at, duration, SILENCE
