"""Utterances as TextGrid files: tiers of words, syllables, phones and phonemes, as forced aligners write them."""

import os
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import replace
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

from typing_extensions import override

from phonemeengine.errors import CorpusError, TextError
from phonemeengine.execution import Closing
from phonemeengine.labels.files import TIER_NAMES, names_in
from phonemeengine.labels.phone_sets import PhonemeMap, labels_named, marks_silence
from phonemeengine.labels.pinyin import sound_of, timed_syllable
from phonemeengine.labels.table import read_text
from phonemeengine.labels.textgrid import Interval, Tier, TierSpool, grid_lines, length_of, tiers_of
from phonemeengine.labels.timed_words import SYLLABLE_TIER, WORD_TIER, tiers_of_speaker
from phonemeengine.labels.utterance import (
    LONGEST_OVERHANG,
    ROUNDING,
    Phone,
    RawLabel,
    Syllable,
    Utterance,
    Word,
    in_order,
)
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import printable_name

WORDS, SYLLABLES, PHONES, PHONEMES = "words", "syllables", "phones", "phonemes"
"""The names of the tiers that are written; of those that are read, the beginnings count."""
STRESS_MARKS = ("", "ˈ", "ˌ")
"""What stands before a syllable in the IPA, by its stress."""
_HALF = 0.5
"""The share of a syllable that its onset has where only the syllable is labelled."""


def format_utterance(
    utterance: Utterance, silence: str = "", more: Mapping[str, Sequence[Interval]] | None = None
) -> str:
    """Return an utterance as the text of a TextGrid: its words, syllables, phones in IPA, and phonemes.

    Parameters
    ----------
    utterance : what is said.
    silence : the name of the intervals between.
    more : further tiers, by name.
    """
    with UtteranceSpool(silence) as spool:
        for word in utterance.words:
            spool.add(word)
        return "".join(spool.lines(utterance.duration, more))


class UtteranceSpool(Closing):
    """What is said in a sound, word by word, for a TextGrid; it may be long, so it lies on the disk meanwhile.

    Parameters
    ----------
    silence : the name of the intervals between words.
    """

    def __init__(self, silence: str = "") -> None:
        self._tiers = {name: TierSpool(name, silence) for name in (WORDS, SYLLABLES, PHONES, PHONEMES)}

    def add(self, word: Word) -> None:
        """Add the next word."""
        self._tiers[WORDS].add(word.start, word.end, word.text)
        for syllable in word.syllables:
            self._tiers[SYLLABLES].add(syllable.start, syllable.end, syllable.text or ipa_of_syllable(syllable))
        for phone in word.phones:
            self._tiers[PHONES].add(phone.start, phone.end, phone.ipa or phone.phoneme.label)
            self._tiers[PHONEMES].add(phone.start, phone.end, phone.phoneme.label)

    def lines(self, duration: float, more: Mapping[str, Sequence[Interval]] | None = None) -> Iterator[str]:
        """Return the lines of the TextGrid of a sound, once; see `format_utterance`."""
        with ExitStack() as stack:
            further = {name: stack.enter_context(TierSpool(name)) for name in more or {}}
            for name, tier in further.items():
                for stretch in (more or {})[name]:
                    tier.add(*stretch)
            yield from grid_lines([*self._tiers.values(), *further.values()], duration)

    @override
    def close(self) -> None:
        """Forget what was added."""
        for tier in self._tiers.values():
            tier.close()


def tells_sounds(path: str | os.PathLike[str], speaker: str | None = None) -> bool:
    """Return whether a TextGrid has a tier of sounds, or of syllables, besides its words; see `read_utterance`.

    Raises
    ------
    CorpusError : it cannot be read, or has several speakers and none of them was chosen.
    """
    name = printable_name(path := Path(path))
    tiers = tiers_of_speaker(tiers_of(read_text(path), name), speaker, name)
    return any(_labels_in(tiers, names) is not None for names in (TIER_NAMES, (SYLLABLE_TIER,)))


def has_words(path: str | os.PathLike[str]) -> bool:
    """Return whether a TextGrid has a tier of words, of any speaker.

    Raises
    ------
    CorpusError : it cannot be read.
    """
    tiers = tiers_of(read_text(path := Path(path)), printable_name(path))
    names = (tier.name.lower() for tier in tiers if tier.raw_labels)
    return any(part.strip().startswith(WORD_TIER) for name in names for part in name.split(" - "))


def read_utterance(
    path: str | os.PathLike[str], duration: float, mapping: PhonemeMap | None = None, speaker: str | None = None
) -> Utterance:
    """Read what is said in a sound from a TextGrid with a tier of sounds, or of syllables of pinyin.

    Where there is a tier of words, these are known, and of syllables, these. Without words, what is said between two
    silences is one, without a text; or each syllable where there are no sounds, or some unknown ones. A
    syllable's mark of stress counts.

    Parameters
    ----------
    path : the file.
    duration : of the sound, seconds.
    mapping : what unknown names stand for.
    speaker : whose tiers, where they name speakers (``mary - phones``).

    Raises
    ------
    UnknownPhonemeError : names of sounds stand for no phoneme.
    CorpusError : it cannot be read, has neither tier, says something impossible, or has several speakers and none of
        them was chosen.
    """
    path, mapping = Path(path), mapping or PhonemeMap()
    name, text = printable_name(path), read_text(path)
    tiers = tiers_of_speaker(tiers_of(text, name), speaker, name)
    _check_length(length_of(text, name), duration, name)
    begins = (TIER_NAMES, (WORD_TIER,), (SYLLABLE_TIER,))
    of_sounds, of_words, of_syllables = (_labels_in(tiers, names) for names in begins)
    if of_sounds is None and (of_syllables is None or (of_syllables and not any(map(_is_pinyin, of_syllables)))):
        raise CorpusError(
            f"{name}: there is no tier named {PHONES!r} with a label, or {SYLLABLES!r} of pinyin; add one in Praat, "
            "or align it by its words"
        )
    sounds, words, syllables = (in_order(raw or (), name, duration) for raw in (of_sounds, of_words, of_syllables))
    pinyin = _as_pinyin(syllables)
    if sounds and (not pinyin or all(map(mapping.knows, names_in(sounds)))):
        known = labels_named(sounds, mapping.phone_classes_of(names_in(sounds), name))
        phones = [Phone(label.start, label.end, label.phone, label.phoneme) for label in known]
        said = tuple(_words_of(phones, _Stretches(words), _Stretches(syllables)))
        if not any(syllable.text for word in said for syllable in word.syllables):
            pinyin = ()  # such as "so" and "mi": it says no more than the sounds do
    else:
        _check_pinyin(syllables, name)
        phones = [phone for raw in pinyin for phone in _phones_of(raw)]
        words = words or syllables
    said = tuple(_words_of(phones, _Stretches(words), _Stretches(pinyin or syllables)))
    return Utterance(said, max([duration, *(word.end for word in said)]))


class _Stretches:
    """Labels in order of time, to be found by a time."""

    def __init__(self, labels: Sequence[RawLabel]) -> None:
        self._labels = labels
        self._starts = [label.start - ROUNDING for label in labels]

    def at(self, time: float) -> RawLabel | None:
        """Return the label at a time, seconds."""
        k = bisect_right(self._starts, time) - 1
        return self._labels[k] if k >= 0 and time < self._labels[k].end else None


class _Owned(NamedTuple):
    """A phone, and the labels of its word and its syllable."""

    phone: Phone
    word: RawLabel | None
    syllable: RawLabel | None


def _labels_in(tiers: Sequence[Tier], begins: tuple[str, ...]) -> tuple[RawLabel, ...] | None:
    """Return what the first tier of a name that has labels says besides silence; None where there is no such tier."""
    for tier in tiers:
        if tier.name.lower().startswith(begins) and tier.raw_labels:
            return tuple(raw for raw in tier.raw_labels if not marks_silence(raw.name))
    return None


def _as_pinyin(syllables: Sequence[RawLabel]) -> tuple[RawLabel, ...]:
    """Return syllables with their tones as digits; nothing unless all of them are pinyin."""
    try:
        return tuple(replace(raw, name=sound_of(raw.name)) for raw in syllables)
    except TextError:
        return ()


def _check_length(labelled: float, duration: float, file: str) -> None:
    if labelled > duration + LONGEST_OVERHANG:
        raise CorpusError(
            f"{file}: this TextGrid is of a sound of {labelled:.2f} s, and the sound here lasts {duration:.2f} s; "
            "check that they belong together, or cut the TextGrid in Praat"
        )


def _is_pinyin(raw: RawLabel) -> bool:
    try:
        return bool(sound_of(raw.name))
    except TextError:
        return False


def _check_pinyin(syllables: Sequence[RawLabel], file: str) -> None:
    for raw in syllables:
        try:
            sound_of(raw.name)
        except TextError as error:
            raise CorpusError(f"{file}, {raw.place}: {error}") from error


def _phones_of(raw: RawLabel) -> tuple[Phone, ...]:
    return timed_syllable(raw.name, raw.start, raw.start + _HALF * (raw.end - raw.start), raw.end).phones


def _words_of(phones: Sequence[Phone], words: _Stretches, syllables: _Stretches) -> Iterator[Word]:
    """Return words with the phones that lie in them; those that lie in none are words of their own."""
    middles = ((phone.start + phone.end) / 2 for phone in phones)
    owned = [_Owned(phone, words.at(at), syllables.at(at)) for phone, at in zip(phones, middles, strict=True)]
    for (silent, word), said in groupby(owned, lambda one: (one.phone.phoneme is Phoneme.SILENCE, one.word)):
        if not silent:
            yield Word(word.name if word else "", tuple(_syllables_of(said)))


def _syllables_of(said: Iterable[_Owned]) -> Iterator[Syllable]:
    for raw, part in groupby(said, lambda one: one.syllable):
        syllable = Syllable(tuple(one.phone for one in part), _stress_in(raw.name) if raw else 0)
        written = raw is not None and raw.name != ipa_of_syllable(syllable)
        yield replace(syllable, text=raw.name) if written else syllable


def ipa_of_syllable(syllable: Syllable) -> str:
    """Return a syllable in the IPA, with its stress."""
    return STRESS_MARKS[syllable.stress] + "".join(phone.ipa or phone.phoneme.label for phone in syllable.phones)


def _stress_in(name: str) -> int:
    return next((stress for stress, mark in enumerate(STRESS_MARKS) if mark and name.startswith(mark)), 0)
