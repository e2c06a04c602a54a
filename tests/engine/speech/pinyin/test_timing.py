"""When syllables are said: sums are exact, rows follow each other, and a voice's own times stay."""

import csv
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import TextError
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.script import WrittenMark, WrittenSyllable, WrittenWord
from phonemeengine.speech.pinyin.timing import (
    PLAN_COLUMNS,
    Plan,
    PlanKind,
    SentencePlanner,
    format_plan,
    plan_of,
    said_at_rate,
)
from phonemeengine.speech.pinyin.track import pinyin_track
from phonemeengine.speech.silent import SilentText
from phonemeengine.text.syllables import SpokenSyllable
from tests.engine.speech.pinyin.saying import MA, NIHAO, SAID, SCRIPT, TABLE, plan_at_rate

Script = list[WrittenSyllable | WrittenMark]
SCRIPTS = st.lists(
    st.one_of(
        st.sampled_from(["ma1", "lü4", "zhuang4", "er2", "m2"]).map(lambda sound: WrittenSyllable("字", sound)),
        st.sampled_from(list(TABLE.marks.items())).map(lambda mark: WrittenMark(*mark)),
    ),
    min_size=1,
    max_size=30,
).filter(lambda script: any(isinstance(item, WrittenSyllable) for item in script))


def rows_of(plan: Plan) -> list[dict[str, str]]:
    return list(csv.DictReader(format_plan(plan).splitlines()))


@given(script=SCRIPTS, rate=st.floats(0.5, 10), seed=st.none() | st.integers(0, 9))
def test_a_text_lasts_as_long_as_its_syllables_and_pauses(script: Script, rate: float, seed: int | None) -> None:
    plan = plan_at_rate(script, TABLE, rate, seed)
    syllables = [item for item in script if isinstance(item, WrittenSyllable)]
    pauses = sum(item.weight for item in script if isinstance(item, WrittenMark))
    assert plan.duration == pytest.approx((len(syllables) + 2.4 * pauses) / rate, rel=1e-12)
    assert plan.rows[0].start == 0
    assert all(row.end == following.start for row, following in pairwise(plan.rows))
    for row in plan.rows:
        if row.kind is PlanKind.SYLLABLE:
            assert row.end - row.start == pytest.approx(1 / rate)
            assert 0.1 - 1e-9 <= (row.turn - row.start) * rate <= 0.45 + 1e-9


def test_the_pause_at_each_mark_is_its_weight_of_six_tenths_of_a_second() -> None:
    for mark, weight in TABLE.marks.items():
        plan = plan_at_rate([WrittenSyllable("吗", "ma5"), WrittenMark(mark, weight)], TABLE)
        assert plan.rows[1].end - plan.rows[1].start == pytest.approx(0.6 * weight)
        assert plan.duration == pytest.approx(0.25 + 0.6 * weight)


def test_without_a_seed_every_onset_has_its_share_and_with_one_they_vary_alike() -> None:
    script = [WrittenSyllable("吗", "ma5")] * 20
    shares = {
        seed: [round((row.turn - row.start) * 4, 6) for row in plan_at_rate(script, TABLE, seed=seed).rows]
        for seed in (None, 1, 2)
    }
    assert set(shares[None]) == {0.3}
    assert shares[1] == [round((row.turn - row.start) * 4, 6) for row in plan_at_rate(script, TABLE, seed=1).rows]
    assert len(set(shares[1])) > 10
    assert shares[1] != shares[2]
    assert all(0.3 * 0.85 <= share <= 0.3 * 1.15 for share in shares[1])


def test_the_plan_as_csv_reads_as_the_text_does() -> None:
    text = format_plan(plan_at_rate(SCRIPT, TABLE))
    assert text.splitlines() == [
        ",".join(PLAN_COLUMNS),
        "0.000,0.075,0.250,syllable,你,ni2,di",
        "0.250,0.325,0.500,syllable,好,hao3,ga",
        "0.500,0.500,0.800,pause,，,,&",
        "0.800,0.875,1.050,syllable,吗,ma5,ba",
        "1.050,1.050,1.650,pause,。,,&",
    ]


@pytest.mark.parametrize("rate", [0, -1, 0.49, 10.1, float("nan"), float("inf")])
def test_a_rate_out_of_range_is_refused(rate: float) -> None:
    with pytest.raises(TextError, match=r"the rate must lie in 0\.5\.\.10 syllables per second, got"):
        SilentText("你好", "cmn", rate=rate)


def test_words_of_other_languages_last_as_long_as_their_phones() -> None:
    word = WrittenWord("cat", (SpokenSyllable(("k", "æ", "t"), 1), SpokenSyllable(("s", "j"))))
    syllable, said = said_at_rate([WrittenSyllable("吗", "ma5"), word], TABLE, 2.0)
    assert said.word is not None
    ends = [0.5 + x / 2 for x in (0.32, 0.69, 1.01, 1.4, 1.67)]
    assert [phone.end for phone in said.word.phones] == pytest.approx(ends)
    assert [row.end for row in said.rows] == [phone.end for phone in said.word.phones]
    assert said.rows[0].start == syllable.rows[0].end
    assert [syllable.stress for syllable in said.word.syllables] == [1, 0]
    assert [row.letters for row in said.rows] == ["d", "e", "d", "y", "d"]


def test_with_a_voice_its_own_times_count_and_what_lies_between_is_a_pause() -> None:
    rows = rows_of(plan_of(SAID, TABLE, SCRIPT))
    assert [(row["start_s"], row["end_s"], row["kind"], row["text"], row["letters"]) for row in rows] == [
        ("0.000", "0.100", "pause", "", "&"),
        ("0.100", "0.350", "syllable", "你", "di"),
        ("0.350", "0.700", "syllable", "好", "ga"),
        ("0.700", "0.950", "pause", "，", "&"),
        ("0.950", "1.150", "syllable", "吗", "ba"),
        ("1.150", "1.500", "pause", "。", "&"),
    ]
    assert rows[1]["turn_s"] == "0.175"


def test_marks_of_another_text_are_left_out() -> None:
    rows = rows_of(plan_of(SAID, TABLE, SCRIPT[1:]))
    assert {row["text"] for row in rows if row["kind"] == "pause"} == {""}


def test_an_english_name_among_chinese_words_moves_the_mouth_by_its_phones() -> None:
    phones = (Phone(0.7, 0.8, "m", Phoneme.M), Phone(0.8, 0.9, "iː", Phoneme.I))
    said = Utterance((NIHAO, Word("me", (Syllable(phones),)), MA), 1.15)
    rows = [row for row in rows_of(plan_of(said, TABLE, SCRIPT)) if row["kind"] == "phone"]
    assert [tuple(row.values()) for row in rows] == [
        ("0.700", "0.700", "0.800", "phone", "me", "m", "b"),
        ("0.800", "0.800", "0.900", "phone", "me", "iː", "i"),
    ]


def test_sentences_of_a_voice_are_planned_one_after_the_other_with_their_marks() -> None:
    phones = (Phone(1.6, 1.7, "m", Phoneme.M), Phone(1.7, 1.8, "iː", Phoneme.I))
    again = (Phone(2.0, 2.1, "m", Phoneme.M),)
    planner = SentencePlanner(TABLE)
    first = list(planner.rows_of("你好,吗.", (NIHAO, MA), 1.5))
    then = list(planner.rows_of("Me, me.", (Word("Me", (Syllable(phones),)), Word("me", (Syllable(again),))), 2.5))
    assert [(row.start, row.end, row.text) for row in first if row.kind is PlanKind.PAUSE] == [
        (0.0, 0.1, ""),
        (0.7, 0.95, "，"),
        (1.15, 1.5, "。"),
    ]
    assert [(row.start, row.end, row.text) for row in then if row.kind is PlanKind.PAUSE] == [
        (1.5, 1.6, ""),
        (1.8, 2.0, ","),
        (2.1, 2.5, "."),
    ]


def test_what_holds_no_pinyin_moves_no_letters() -> None:
    said = Utterance((Word("me", (Syllable((Phone(0, 1, "m", Phoneme.M),)),)),), 1.0)
    with pytest.raises(TextError, match="there is no syllable of pinyin in what is said; choose another driver"):
        pinyin_track(said, TABLE)
    assert [row.kind for row in plan_of(said, TABLE).rows] == [PlanKind.PHONE]
