"""The phones of a syllable of pinyin: what drawings, labels and other mouth tables are made of.

Of an affricate the friction stands for both halves, since it is what the lips show; of a final its nucleus.
"""

from phonemeengine.labels.phone_sets import phone_classes_in
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.letters import NASALS, initial_and_final
from phonemeengine.speech.pinyin.plan import Plan, PlanKind

_INITIALS = {
    "b": "p", "p": "pʰ", "m": "m", "f": "f", "d": "t", "t": "tʰ", "n": "n", "l": "l", "g": "k", "k": "kʰ", "h": "x",
    "j": "ɕ", "q": "ɕ", "x": "ɕ", "zh": "ʂ", "ch": "ʂ", "sh": "ʂ", "r": "ʐ", "z": "s", "c": "s", "s": "s", "y": "j",
    "w": "w", "": "",
}  # fmt: skip
_NUCLEI = {"a": "a", "o": "o", "e": "ə", "ê": "ɛ", "i": "i", "u": "u", "ü": "y"}
"""Of a final that holds several of these, the first counts that is no glide."""
_NASALS = {"m": "m", "n": "n", "ng": "ŋ"}


def syllable_of(sound: str, start: float, turn: float, end: float) -> Syllable:
    """Return a syllable with its phones.

    Parameters
    ----------
    sound : pinyin with its tone as a digit.
    start, end : seconds.
    turn : when the onset ends, where there is one.
    """
    onset, rime = _ipa_of(sound[:-1])
    turn = turn if onset else start
    phones = [_phone(start, turn, onset)] if onset else []
    return Syllable((*phones, _phone(turn, end, rime)), text=sound)


def utterance_of(plan: Plan) -> Utterance:
    """Return what a plan says of a text that nobody speaks: each syllable is a word."""
    syllables = (row for row in plan.rows if row.kind is PlanKind.SYLLABLE)
    words = (Word(row.text, (syllable_of(row.sound, row.start, row.turn, row.end),)) for row in syllables)
    return Utterance(tuple(words), plan.duration)


def _ipa_of(syllable: str) -> tuple[str, str]:
    if syllable in NASALS:
        nasal = syllable.removeprefix("h")
        return _INITIALS[syllable.removesuffix(nasal)], _NASALS[nasal]
    initial, final = initial_and_final(syllable)
    return _INITIALS[initial], _NUCLEI[next((vowel for vowel in "aoeê" if vowel in final), final[0])]


def _phone(start: float, end: float, ipa: str) -> Phone:
    sound = phone_classes_in(ipa)[1]
    return Phone(start, end, ipa, sound.phoneme if sound else Phoneme.UNIDENTIFIED)
