import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine import TextError
from phonemeengine.text.cleaning import speakable


def test_emoji_are_left_out_and_that_is_said() -> None:
    cleaned = speakable("Well done 👍🏽 👩‍👩‍👧 ❤️ friend")
    assert cleaned.text.split() == ["Well", "done", "friend"]
    assert cleaned.notes == ("emoji have no sound and are left out (3 x)",)


def test_control_characters_and_nul_are_left_out_and_that_is_said() -> None:
    cleaned = speakable("a\0b\x01c\x1b[0m d")
    assert cleaned.text == "abc[0m d"
    assert "(3 x)" in cleaned.notes[0]


def test_half_a_character_of_a_broken_encoding_is_left_out() -> None:
    assert speakable("caf\udce9 au lait").text == "caf au lait"


def test_double_brackets_never_reach_the_voice() -> None:
    cleaned = speakable("say [[h@'loU]] [[[now")
    assert "[[" not in cleaned.text
    assert len(cleaned.notes) == 1


def test_layout_goes_silently_and_joiners_stay() -> None:
    cleaned = speakable("soft\u00adhyphen \ufeffmark می\u200cخواهم")
    assert cleaned.text == "softhyphen mark می\u200cخواهم"
    assert cleaned.notes == ()


def test_line_ends_of_all_systems_are_one() -> None:
    assert speakable("a\r\nb\rc\nd").text == "a\nb\nc\nd"


@pytest.mark.parametrize("text", ["", "   \n", "🎉🎉", "\0\0", "...", "—", "[[", "<>"])
def test_a_text_without_a_word_is_refused_with_a_remedy(text: str) -> None:
    with pytest.raises(TextError, match=r"there is no word to speak in .*; write some"):
        speakable(text)


@given(st.text())
def test_what_is_left_can_be_encoded_and_holds_no_control_character(text: str) -> None:
    try:
        left = speakable(text).text
    except TextError:
        return
    left.encode()
    assert all(c.isprintable() or c in "\n\u200c\u200d\u3000" or c.isspace() for c in left)
    assert "[[" not in left
