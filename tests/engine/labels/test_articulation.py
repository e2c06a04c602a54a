"""How sounds are made: the inventory is whole, and its classes are those of phonetics."""

import pytest

from phonemeengine.labels.phone_sets import (
    ARTICULATIONS,
    IPA,
    IPA_LETTERS,
    articulations_of,
    letters_of,
    phone_classes_in,
)
from phonemeengine.phonemes import VOWELS


def test_every_letter_is_a_sound_whose_phoneme_is_known() -> None:
    assert {letter for letter in IPA_LETTERS if phone_classes_in(letter)[1] is None} == set()
    assert all(letters_of(name) for _, _, names in IPA for name in names.split())


def test_a_sound_is_a_vowel_or_a_consonant_and_never_both() -> None:
    assert not ARTICULATIONS["vowel"] & ARTICULATIONS["consonant"]
    for letter in IPA_LETTERS:
        phone_class = phone_classes_in(letter)[1]
        assert phone_class is not None
        assert (phone_class.phoneme in VOWELS) == (letter in ARTICULATIONS["vowel"]), letter


def test_no_class_stands_before_one_that_it_holds() -> None:
    names = list(ARTICULATIONS)
    for k, name in enumerate(names):
        assert not [later for later in names[k + 1 :] if ARTICULATIONS[later] < ARTICULATIONS[name]]


@pytest.mark.parametrize(
    ("letter", "classes"),
    [
        ("f", ("labiodental", "fricative", "consonant")),
        ("m", ("bilabial", "nasal", "consonant")),
        ("ʁ", ("uvular", "rhotic", "fricative", "consonant")),
        ("y", ("front rounded vowel", "rounded vowel", "close vowel", "front vowel", "vowel")),
    ],
)
def test_the_classes_of_a_sound_go_from_what_says_the_most_to_what_says_the_least(
    letter: str, classes: tuple[str, ...]
) -> None:
    found = articulations_of(letter)
    assert [name for name in found if name in classes] == list(classes)
    assert all(letter in ARTICULATIONS[name] for name in found)


@pytest.mark.parametrize(
    ("phone", "letters"),
    [
        ("tʰ", "t"),
        ("t̪", "t"),
        ("n̩", "n"),
        ("ɑ̃", "ɑ"),
        ("õ", "o"),
        ("ç", "ç"),
        ("iː", "i"),
        ("g", "ɡ"),
        ("t͡ʃ", "tʃ"),
        ("ʧ", "tʃ"),
        ("aɪ", "aɪ"),
        ("oʊ̯", "oʊ"),
        ("", ""),
        ("7", ""),
    ],
)
def test_marks_change_no_sound_and_two_letters_are_two_sounds(phone: str, letters: str) -> None:
    assert letters_of(phone) == tuple(letters)
