"""Words and phones that are changed by hand."""

import pytest

from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.labels.utterance_edits import (
    gap_at,
    renamed_phone,
    split_phone,
    split_word,
    with_inserted,
    without_phone,
    without_word,
)
from phonemeengine.phonemes import Phoneme


def said(text: str, start: float, *phones: str) -> Word:
    """A word of one syllable, each phone of which lasts 0.1 s."""
    times = [start + 0.1 * k for k in range(len(phones) + 1)]
    made = (Phone(a, b, ipa, Phoneme.UNIDENTIFIED, 0.5) for a, b, ipa in zip(times, times[1:], phones, strict=False))
    return Word(text, (Syllable(tuple(made), 1),))


SAID = Utterance((said("so", 0.2, "s", "o"), said("mat", 0.6, "m", "a", "t")), 1.0, "en-us")


def spelt(utterance: Utterance) -> list[tuple[str, str]]:
    return [(word.text, "".join(phone.ipa for phone in word.phones)) for word in utterance.words]


def test_a_word_is_inserted_where_nothing_is_said_and_nowhere_else() -> None:
    assert gap_at(SAID, 0.5) == pytest.approx((0.4, 0.6))
    assert gap_at(SAID, 0.1) == pytest.approx((0.0, 0.2))
    assert gap_at(SAID, 0.95) == pytest.approx((0.9, 1.0))
    assert gap_at(SAID, 0.3) == (0.3, 0.3)
    between = said("a", 0.45, "a")
    assert [word for word, _ in spelt(with_inserted(SAID, between))] == ["so", "a", "mat"]
    with pytest.raises(CorpusError, match=r"'so' is said from 0\.200 to 0\.400 s; delete it first"):
        with_inserted(SAID, said("a", 0.35, "a"))


def test_a_word_is_deleted() -> None:
    assert spelt(without_word(SAID, 0)) == [("mat", "mat")]


def test_a_word_is_split_before_the_sound_at_the_cursor() -> None:
    assert spelt(split_word(SAID, 1, 0.75)) == [("so", "so"), ("mat", "m"), ("at", "at")]
    with pytest.raises(CorpusError, match="in its first sound"):
        split_word(SAID, 1, 0.65)


def test_a_phone_is_renamed_to_one_sound_or_several_of_its_time() -> None:
    assert spelt(renamed_phone(SAID, 1, "ə"))[0] == ("so", "sə")
    several = renamed_phone(SAID, 1, "ts")
    assert spelt(several)[0] == ("so", "sts")
    assert several.words[0].end == SAID.words[0].end
    with pytest.raises(CorpusError, match="is no sound of IPA"):
        renamed_phone(SAID, 1, "!")
    with pytest.raises(CorpusError, match="is no sound of IPA"):
        renamed_phone(SAID, 1, " ")


def test_a_phone_is_split_and_deleted_and_a_word_keeps_one() -> None:
    assert spelt(split_phone(SAID, 0, 0.25))[0] == ("so", "sso")
    with pytest.raises(CorpusError, match="5 ms at least"):
        split_phone(SAID, 0, 0.201)
    shorter = without_phone(SAID, 3)
    assert spelt(shorter)[1] == ("mat", "mt")
    assert [(p.start, p.end) for p in shorter.words[1].phones] == [
        pytest.approx((0.6, 0.8)),
        pytest.approx((0.8, 0.9)),
    ]
    assert without_phone(SAID, 0).words[0].start == SAID.words[0].start
    with pytest.raises(CorpusError, match="has no other sound; delete the word"):
        without_phone(without_phone(SAID, 0), 0)
