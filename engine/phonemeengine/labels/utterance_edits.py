"""Words and phones of an utterance that are changed by hand: renamed, inserted, deleted and split.

Phones that a change makes or moves were not compared with the sound, so they have no score.
"""

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np

from phonemeengine.errors import CorpusError
from phonemeengine.labels.phone_sets import ipa_class, ipa_phoneme, split_ipa
from phonemeengine.labels.tiers import SHORTEST
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word


def with_word(utterance: Utterance, k: int, word: Word) -> Utterance:
    """Return an utterance with another word in the place of word `k`."""
    return replace(utterance, words=(*utterance.words[:k], word, *utterance.words[k + 1 :]))


def with_inserted(utterance: Utterance, word: Word) -> Utterance:
    """Return an utterance with one more word.

    Raises
    ------
    CorpusError : there is a word at its time already.
    """
    for other in utterance.words:
        if other.start < word.end - SHORTEST and word.start < other.end - SHORTEST:
            raise CorpusError(
                f"{other.text!r} is said from {other.start:.3f} to {other.end:.3f} s; delete it first, or go to a "
                "pause"
            )
    words = sorted((*utterance.words, word), key=lambda one: one.start)
    return replace(utterance, words=tuple(words))


def without_word(utterance: Utterance, k: int) -> Utterance:
    """Return an utterance without word `k`; there is silence in its place."""
    return replace(utterance, words=utterance.words[:k] + utterance.words[k + 1 :])


def gap_at(utterance: Utterance, seconds: float) -> tuple[float, float]:
    """Return from when to when nothing is said around a time; an empty gap where something is."""
    if any(word.start <= seconds < word.end for word in utterance.words):
        return seconds, seconds
    before = max((word.end for word in utterance.words if word.end <= seconds), default=0.0)
    return before, min((word.start for word in utterance.words if word.start > seconds), default=utterance.duration)


def split_word(utterance: Utterance, k: int, seconds: float) -> Utterance:
    """Return an utterance in which a word is two, of which the second begins with the phone at a time.

    The first one keeps the text, the second one has its phones for a text, until it is renamed.

    Raises
    ------
    CorpusError : no phone of it begins there, but for the first.
    """
    word = utterance.words[k]
    cut = next((n for n, phone in enumerate(word.phones) if phone.start <= seconds < phone.end), 0)
    if cut == 0:
        raise CorpusError(
            f"{word.text!r} can't be split at {seconds:.3f} s, in its first sound; go to the sound that the second "
            "word is to begin with"
        )
    parts: tuple[list[Syllable], list[Syllable]] = ([], [])
    for syllable in word.syllables:
        for part, belongs in zip(parts, (_before, _from), strict=True):
            phones = belongs(syllable.phones, word.phones[cut].start)
            if phones:
                part.append(replace(syllable, phones=phones, text=syllable.text if phones == syllable.phones else ""))
    first, second = (tuple(part) for part in parts)
    named = "".join(phone.ipa for syllable in second for phone in syllable.phones)
    two = (replace(word, syllables=first), Word(named, second))
    return replace(utterance, words=(*utterance.words[:k], *two, *utterance.words[k + 1 :]))


def _before(phones: tuple[Phone, ...], seconds: float) -> tuple[Phone, ...]:
    return tuple(phone for phone in phones if phone.start < seconds)


def _from(phones: tuple[Phone, ...], seconds: float) -> tuple[Phone, ...]:
    return tuple(phone for phone in phones if phone.start >= seconds)


def renamed_phone(utterance: Utterance, k: int, ipa: str) -> Utterance:
    """Return an utterance in which phone `k` is another sound, or several, which share its time.

    Raises
    ------
    CorpusError : it is no IPA.
    """
    symbols = split_ipa(ipa.strip())
    unknown = [symbol for symbol in symbols if ipa_class(symbol) is None]
    if not symbols or unknown:
        raise CorpusError(f"{ipa.strip() or ' '!r:.40} is no sound of IPA; write one, such as ə, or delete the phone")

    def named(phone: Phone) -> tuple[Phone, ...]:
        edges = pairwise(np.linspace(phone.start, phone.end, len(symbols) + 1).tolist())
        return tuple(Phone(*next(edges), symbol, ipa_phoneme(symbol)) for symbol in symbols)

    return _with_phone(utterance, k, named)


def split_phone(utterance: Utterance, k: int, seconds: float) -> Utterance:
    """Return an utterance in which a phone is two of the same name, the second of which begins at a time.

    Raises
    ------
    CorpusError : one of them would be shorter than 5 ms.
    """
    phone = list(utterance.phones)[k]
    if not phone.start + SHORTEST <= seconds <= phone.end - SHORTEST:
        raise CorpusError(
            f"{phone.ipa!r} can't be split at {seconds:.3f} s: each part lasts {1000 * SHORTEST:g} ms at least; move "
            "the cursor into the phone"
        )
    two = replace(phone, end=seconds, score=None), replace(phone, start=seconds, score=None)
    return _with_phone(utterance, k, lambda _phone: two)


def without_phone(utterance: Utterance, k: int) -> Utterance:
    """Return an utterance without phone `k`: its time belongs to the one before it in the word, or after it.

    Raises
    ------
    CorpusError : it is the only one of its word.
    """
    at = 0
    for number, word in enumerate(utterance.words):
        phones = word.phones
        if at <= k < at + len(phones):
            if len(phones) == 1:
                raise CorpusError(f"{word.text!r} has no other sound; delete the word")
            gone, n = phones[k - at], k - at
            heir = phones[n - 1] if n else phones[1]
            longer = replace(heir, end=gone.end, score=None) if n else replace(heir, start=gone.start, score=None)
            changed = {gone: (), heir: (longer,)}
            syllables = (
                replace(s, phones=tuple(new for phone in s.phones for new in changed.get(phone, (phone,))))
                for s in word.syllables
            )
            kept = replace(word, syllables=tuple(s for s in syllables if s.phones))
            return with_word(utterance, number, kept)
        at += len(phones)
    raise CorpusError(f"there are {at} phones, found {k}; choose 0..{at - 1}")


def _with_phone(utterance: Utterance, k: int, change: Callable[[Phone], tuple[Phone, ...]]) -> Utterance:
    """Return an utterance in which one phone is replaced by others of the same time."""
    at, words = 0, []
    for word in utterance.words:
        syllables = []
        for syllable in word.syllables:
            phones: list[Phone] = []
            for phone in syllable.phones:
                phones += change(phone) if at == k else (phone,)
                at += 1
            syllables.append(replace(syllable, phones=tuple(phones)))
        words.append(replace(word, syllables=tuple(syllables)))
    return replace(utterance, words=tuple(words))
