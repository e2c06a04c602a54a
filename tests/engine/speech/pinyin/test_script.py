"""Chinese text as syllables and pauses: marks pause, quotes and numbers do not, and nothing is silently lost."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import TextError
from phonemeengine.labels.pinyin import is_sound
from phonemeengine.speech.pinyin.script import WrittenMark, WrittenSyllable, script_of
from phonemeengine.speech.pinyin.track import pinyin_track
from tests.engine.speech.pinyin.saying import TABLE


def shown(text: str) -> str:
    """Write what is spoken as pinyin and marks."""
    items = script_of(text, TABLE).written
    return " ".join(item.sound if isinstance(item, WrittenSyllable) else item.text for item in items)


def pauses(text: str) -> list[float]:
    return [item.weight for item in script_of(text, TABLE).written if isinstance(item, WrittenMark)]


@pytest.mark.parametrize(
    ("text", "spoken"),
    [
        ("你好，世界。", "ni2 hao3 ， shi4 jie4 。"),
        ("我们去银行。", "wo3 men5 qu4 yin2 hang2 。"),
        ("长大以后还钱", "zhang3 da4 yi3 hou4 huan2 qian2"),
        ("绿的女儿", "lü4 de5 nü3 er2"),
        ("謝謝", "xie4 xie4"),
        ("\uf944", "long2"),
        ("嗯，呣", "n2 ， m2"),
    ],
)
def test_characters_are_spoken_as_people_do(text: str, spoken: str) -> None:
    assert shown(text) == spoken


@pytest.mark.parametrize(("marks", "weight"), [*TABLE.marks.items()])
def test_a_mark_pauses_by_its_weight(marks: str, weight: float) -> None:
    assert pauses(f"好{marks}好") == [weight]


@pytest.mark.parametrize(
    ("marks", "weights"),
    [
        (".", [1]),
        ("?", [1]),
        ("!", [1]),
        (";", [0.75]),
        (":", [0.75]),
        (",", [0.5]),
        ("\n", [1]),
        ("\r\n", [1]),
        ("……", [0.75]),
        ("——", [0.5]),
        ("？！", [1]),
        ("、，", [0.5]),
        ("，\n", [1]),
        ("，” “", [0.5]),
        ("。”", [1]),
        ("“", []),
        ("》《", []),
        ("（）", []),
        ("「」『』", []),
        (" ", []),
        ("·", []),
        ("-", []),
    ],
)
def test_half_width_marks_are_full_ones_the_heaviest_of_a_row_counts_and_quotes_are_none(
    marks: str, weights: list[float]
) -> None:
    assert pauses(f"好{marks}好") == weights


@pytest.mark.parametrize("number", ["3.5", "12:30", "1,234,567", "2026"])
def test_marks_within_numbers_are_no_pauses(number: str) -> None:
    assert pauses(f"有{number}个。") == [1]
    assert len(script_of(f"有{number}个。", TABLE).written) > 5


def test_what_is_no_chinese_is_skipped_and_told() -> None:
    script = script_of("我用iPhone，看www.example.com🙂。", TABLE)
    assert script.skipped == ("iPhone", "www.example.com", "🙂")
    assert [item.text for item in script.written] == ["我", "用", "，", "看", "。"]
    assert pinyin_track("我🙂。").utterance.skipped == ("🙂",)


def test_latin_words_in_a_silent_text_are_spoken_and_move_the_mouth() -> None:
    track = pinyin_track("我用Google，吗。")
    assert [word.text for word in track.utterance.words] == ["我", "用", "Google", "吗"]
    assert track.utterance.skipped == ()
    assert track.utterance.words[2].phones[0].ipa == "ɡ"
    rows = track.plan.rows
    assert [row.text for row in rows if row.kind == "pause"] == ["，", "。"]
    assert all(a.end == b.start for a, b in pairwise(rows))


@pytest.mark.parametrize("text", ["", " ", "hello", "。。。", "🙂", "\0", "[[tS]]", "<b>", "\u202e", "\ud800"])
def test_a_text_without_a_chinese_character_is_refused(text: str) -> None:
    with pytest.raises(TextError, match="there is no Chinese syllable in the text; write some"):
        pinyin_track(text)


@given(st.text(st.characters() | st.sampled_from("你好银行，。、\n3.5%"), max_size=30))
def test_any_text_becomes_syllables_and_marks_that_never_follow_each_other(text: str) -> None:
    written = script_of(text, TABLE).written
    assert all(is_sound(item.sound) for item in written if isinstance(item, WrittenSyllable))
    for one, other in pairwise(written):
        assert not (isinstance(one, WrittenMark) and isinstance(other, WrittenMark))
