"""Utterances as TextGrid files: tiers of words, phones and phonemes, as forced aligners write them."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from phonemeengine.errors import CorpusError
from phonemeengine.files import printable_name
from phonemeengine.labels.files import TIER_NAMES, names_in
from phonemeengine.labels.label import ROUNDING, Label, RawLabel, in_order
from phonemeengine.labels.phoneme_map import PhonemeMap, labels_named
from phonemeengine.labels.text_io import read_text
from phonemeengine.labels.textgrid import Tier, format_tiers, tiers_of
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.labels.utterance_tiers import stress_in
from phonemeengine.phonemes import Phoneme

WORDS, SYLLABLES, PHONES, PHONEMES = "words", "syllables", "phones", "phonemes"
"""The names of tiers; syllables are only read."""


def format_utterance(utterance: Utterance) -> str:
    """Write an utterance as the text of a TextGrid: its words, its phones in IPA, and our phonemes."""
    phones = list(utterance.phones)
    tiers = {
        WORDS: [(word.start, word.end, word.text) for word in utterance.words],
        PHONES: [(phone.start, phone.end, phone.ipa or phone.phoneme.label) for phone in phones],
        PHONEMES: [(phone.start, phone.end, phone.phoneme.label) for phone in phones],
    }
    return format_tiers(tiers, utterance.duration)


def read_utterance(path: Path, duration: float, mapping: PhonemeMap | None = None) -> Utterance:
    """Read what is said in a sound from a TextGrid with a tier of sounds, and one of words where there is one.

    Without a tier of words, what is said between two silences is one, without a text. A tier of syllables parts
    words, and its marks of stress count; without one, a word is a single syllable.

    Parameters
    ----------
    path : the file.
    duration : of the sound, seconds.
    mapping : what names stand for that nobody knows.

    Raises
    ------
    UnknownPhonemeError : names of sounds stand for no phoneme.
    CorpusError : it cannot be read, has no tier of sounds, or says something impossible.
    """
    name, mapping = printable_name(path), mapping or PhonemeMap()
    tiers = tiers_of(read_text(path), name)
    sounds = next((tier for tier in tiers if tier.name.lower().startswith(TIER_NAMES) and tier.raw_labels), None)
    if sounds is None:
        raise CorpusError(f"{name}: there is no tier named {PHONES!r} with a label; align it by its words instead")
    raw = in_order(sounds.raw_labels, name, duration)
    phones = [_phone_of(label) for label in labels_named(raw, mapping.phone_classes_of(names_in(raw), name))]
    words, syllables = (in_order(_labels_in(tiers, kind), name, duration) for kind in (WORDS, SYLLABLES))
    return Utterance(tuple(_words_of(phones, words, syllables)), duration)


def script_in(path: Path) -> str | None:
    """Return the words of a TextGrid that has a tier of words; None for one that has none.

    Raises
    ------
    CorpusError : it cannot be read.
    """
    words = _labels_in(tiers_of(read_text(path), printable_name(path)), WORDS)
    return " ".join(raw.name for raw in words) or None


def _labels_in(tiers: Sequence[Tier], name: str) -> Sequence[RawLabel]:
    return next((tier.raw_labels for tier in tiers if tier.name.lower().startswith(name[:4])), ())


def _phone_of(label: Label) -> Phone:
    return Phone(label.start, label.end, label.phone, label.phoneme)


def _words_of(phones: Sequence[Phone], words: Sequence[RawLabel], syllables: Sequence[RawLabel]) -> Iterator[Word]:
    """Return words with the phones that lie in them; those that lie in none are words of their own."""
    for owner, part in _runs_in(phones, words):
        yield Word(owner.name if owner else "", tuple(_syllables_of(part, syllables)))


def _syllables_of(phones: Sequence[Phone], syllables: Sequence[RawLabel]) -> Iterator[Syllable]:
    for owner, part in _runs_in(phones, syllables):
        yield Syllable(tuple(part), stress_in(owner.name) if owner else 0)


def _runs_in(phones: Sequence[Phone], stretches: Sequence[RawLabel]) -> Iterator[tuple[RawLabel | None, list[Phone]]]:
    """Return phones that follow each other in the same stretch, with that stretch; silence ends a run."""
    part: list[Phone] = []
    owner: RawLabel | None = None
    for phone in phones:
        middle = (phone.start + phone.end) / 2
        within = next((label for label in stretches if label.start - ROUNDING <= middle < label.end), None)
        if part and (within is not owner or phone.phoneme is Phoneme.SILENCE):
            yield owner, part
            part = []
        if phone.phoneme is not Phoneme.SILENCE:
            part.append(phone)
        owner = within
    if part:
        yield owner, part
