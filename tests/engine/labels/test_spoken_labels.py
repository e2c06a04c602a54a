"""What a voice said, as tiers of words, syllables and phones, and back."""

from pathlib import Path

import pytest

from phonemeengine.labels.phone_sets import ipa_of, stress_of_arpabet
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word, shifted
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.phonemes import Phoneme


def _spoken() -> Utterance:
    """Say "about me", with silence before, between and after the words."""
    names = [("ə", Phoneme.E), ("b", Phoneme.P), ("a", Phoneme.A), ("t", Phoneme.UNIDENTIFIED)]
    phones = [Phone((2 + k) / 10, (3 + k) / 10, ipa, phoneme) for k, (ipa, phoneme) in enumerate(names)]
    about = Word("about", (Syllable(tuple(phones[:1])), Syllable(tuple(phones[1:]), 1)))
    me = Word("me", (Syllable((Phone(0.7, 0.8, "m", Phoneme.M), Phone(0.8, 0.9, "i", Phoneme.I)), 2),))
    return Utterance((about, me), 1.2)


def test_words_syllables_and_stress_survive_a_textgrid(tmp_path: Path) -> None:
    path = tmp_path / "a.TextGrid"
    path.write_text(format_utterance(_spoken(), "sil"), encoding="utf-8")
    assert read_utterance(path, 1.2) == _spoken()


def test_without_a_tier_of_syllables_a_word_is_a_single_one(tmp_path: Path) -> None:
    path = tmp_path / "a.TextGrid"
    path.write_text(format_utterance(_spoken(), "sil").replace('"syllables"', '"notes"'), encoding="utf-8")
    assert [len(word.syllables) for word in read_utterance(path, 1.2).words] == [1, 1]


def test_a_word_may_be_said_later() -> None:
    word = _spoken().words[0]
    later = shifted(word, 2.0)
    assert (later.start, later.end) == (pytest.approx(word.start + 2), pytest.approx(word.end + 2))
    assert [phone.ipa for phone in later.phones] == [phone.ipa for phone in word.phones]


@pytest.mark.parametrize(
    ("name", "ipa", "stress"),
    [
        ("AA1", ("ɑ",), 1),
        ("AH0", ("ə",), 0),
        ("AH2", ("ʌ",), 2),
        ("JH", ("d", "ʒ"), 0),
        ("AY1", ("aɪ",), 1),
        ("tʃ", ("t", "ʃ"), 0),
        ("tʃ_cl", ("t",), 0),
        ("tʃ_fr", ("ʃ",), 0),
        ("aː", ("a",), 0),
        ("ˈn̩", ("n̩",), 0),
    ],
)
def test_a_phone_has_a_name_in_the_ipa_whether_it_is_written_so_or_in_arpabet(
    name: str, ipa: tuple[str, ...], stress: int
) -> None:
    assert ipa_of(name) == ipa
    assert stress_of_arpabet(name) == stress
