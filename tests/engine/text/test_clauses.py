from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.text.cleaning import LONGEST, clauses_of, sentences_of


def test_a_sentence_ends_at_its_mark_and_at_the_end_of_a_line() -> None:
    text = "Who? “Me!” he said. A title\nAnd more… Well"
    assert list(sentences_of(text)) == ["Who?", "“Me!”", "he said.", "A title", "And more…", "Well"]


def test_titles_initials_and_ordinals_end_no_sentence() -> None:
    text = "Mr. Smith met J. R. on the 3. of May, e.g. at noon. Then he left."
    assert list(sentences_of(text)) == [text[:-14], "Then he left."]


def test_clauses_end_at_commas_too_but_not_within_numbers() -> None:
    assert list(clauses_of("It cost 3,500 euro, or 3.5 pounds; no more.")) == [
        "It cost 3,500 euro,",
        "or 3.5 pounds;",
        "no more.",
    ]


def test_chinese_clauses_need_no_spaces() -> None:
    assert list(clauses_of("你好，世界。“再见！”他说")) == ["你好，", "世界。", "“再见！”", "他说"]


def test_marks_of_either_width_end_a_chinese_clause() -> None:
    assert list(clauses_of("他说:“好,走吧!”……然后3.5元—走了.")) == [
        "他说:",
        "“好,",
        "走吧!”",
        "……",
        "然后3.5元—",
        "走了.",
    ]


def test_a_text_without_a_mark_is_cut_between_words() -> None:
    parts = list(sentences_of("word " * 1000))
    assert all(len(part) <= LONGEST for part in parts)
    assert " ".join(parts).split() == ["word"] * 1000


def test_a_word_without_end_is_cut_anywhere() -> None:
    parts = list(sentences_of("a" * 1000))
    assert "".join(parts) == "a" * 1000
    assert max(map(len, parts)) <= LONGEST


@given(st.text(alphabet="ab好1.,!? \n。，“”…—"))
def test_nothing_is_lost_by_cutting(text: str) -> None:
    assert "".join("".join(sentences_of(text)).split()) == "".join(text.split())
    assert "".join("".join(clauses_of(text)).split()) == "".join(text.split())
