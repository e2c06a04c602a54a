"""Pinyin tables: the one that ships says what the subject says, and a broken one is refused in one sentence."""

import re
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import MouthError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.table import USUAL_PINYIN_TABLE, load_pinyin_table, pinyin_table_of

TABLE = load_pinyin_table()
GOOD = USUAL_PINYIN_TABLE.read_text(encoding="utf-8")
JAW = {"b": 0, "f": 6, "d": 12, "g": 25, "r": 8, "y": 8, "a": 100, "o": 50, "u": 15, "e": 50, "i": 12, "&": 0}
"""How far the jaw is open, in percent of the widest."""


def weight(shape: str, movestate: str) -> float:
    return float(TABLE.weights()[shape][ARKIT.index(movestate)])


def test_the_table_that_ships_has_ten_letters_rest_and_a_variant_on_the_52_movestates() -> None:
    assert TABLE.mouth.movestates == ARKIT
    assert set(TABLE.mouth.shapes) == set("&bfdgryaoei") | {"u"}
    assert all(((row >= 0) & (row <= 1)).all() for row in TABLE.weights().values())


@pytest.mark.parametrize(("shape", "percent"), JAW.items())
def test_the_jaw_opens_by_its_share_of_the_widest(shape: str, percent: float) -> None:
    assert weight(shape, "jawOpen") == pytest.approx(percent / 100 * weight("a", "jawOpen"), abs=1e-6)


def test_shapes_are_made_as_a_phonetician_says() -> None:
    for rounded in "oru":
        assert weight(rounded, "mouthFunnel") + weight(rounded, "mouthPucker") > 0.9
    for spread in "yi":
        assert weight(spread, "mouthSmileLeft") == weight(spread, "mouthSmileRight") > 0.3
    for unrounded in "aeidgyf&":
        assert weight(unrounded, "mouthPucker") == 0
    assert weight("b", "mouthPressLeft") > 0.3
    assert weight("f", "mouthRollLower") > 0.5
    assert weight("u", "mouthPucker") > weight("o", "mouthPucker")


def test_the_shapes_are_told_apart() -> None:
    rows = np.array(list(TABLE.weights().values()))
    distances = np.abs(rows[:, None] - rows[None]).sum(axis=2)
    assert distances[~np.eye(len(rows), dtype=bool)].min() > 0.2


def test_marks_pause_as_long_as_their_weights_say() -> None:
    weights = {"。": 1, "？": 1, "！": 1, "；": 0.75, "：": 0.75, "，": 0.5, "、": 0.25, "…": 0.75, "—": 0.5}
    assert TABLE.marks == weights
    assert TABLE.pause == 2.4


def test_the_rime_has_more_of_a_syllable_than_the_onset() -> None:
    assert set(TABLE.onset_shares) == set("&bfdgryaoeiu")
    assert set(TABLE.onset_shares.values()) == {0.3}


def test_sounds_that_are_no_pinyin_have_shapes_too() -> None:
    shapes = {p: TABLE.mouth.phonemes[p] for p in (Phoneme.SILENCE, Phoneme.M, Phoneme.SCH, Phoneme.U, Phoneme.A)}
    assert list(shapes.values()) == ["&", "b", "r", "u", "a"]


def test_an_animator_sets_the_onset_of_one_letter_and_a_spring() -> None:
    table = pinyin_table_of(GOOD.replace("ws = 0.3", "ws = 0.3\nb = 0.2").replace("spring = false", "spring = true"))
    assert (table.onset_shares["b"], table.onset_shares["d"]) == (0.2, 0.3)
    assert table.spring is not None
    assert (table.spring.mass, table.spring.stiffness, table.spring.damping) == (1, 900, 60)
    assert TABLE.spring is None


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('format = "phonemeanalyser pinyin 1"', 'format = "pinyin"', "a pinyin table begins with format"),
        ('movestates = "arkit"', 'movestates = "arkti"', "movestates must be one of arkit"),
        ('f = ["f"]', "f = []", r"\[onsets\] lacks 'f'; add it to the list"),
        ('f = ["f"]', 'f = ["f", "b"]', r"\[onsets\] names 'b' twice; remove one"),
        ('f = ["f"]', 'f = ["f", "v"]', r"\[onsets\] f names 'v', which does not exist; choose one of b, p"),
        ('f = ["f"]', 'x = ["f"]', r"\[onsets\] has the shape 'x', which \[shapes\] lacks"),
        ('f = ["f"]', 'ff = ["f"]', r"\[onsets\] has 'ff', which is no letter"),
        ('i = ["i", "in", "ing"]', 'i = ["i", "in"]', r"\[rimes\] lacks 'ing'"),
        ('hm = "gb"', 'hm = "gbb"', r"\[syllables\] hm must be two letters that \[shapes\] has, found 'gbb'"),
        ('hm = "gb"', 'hello = "gb"', r"\[syllables\] names 'hello', which is no syllable without tone"),
        ('hm = "gb"', 'hm3 = "gb"', r"\[syllables\] names 'hm3', which is no syllable without tone"),
        ('u = ["w"', 'v = ["w"', r"\[variants\] has the shape 'v', which"),
        ("ws = 0.3", "ws = 0.5", r"\[weights\] ws must be a share in 0.1..0.45, found 0.5"),
        ('"，" = 0.5', '"，" = 2', r"\[marks\] ， must be a weight in 0..1, found 2"),
        ('"，" = 0.5', '"，，" = 0.5', r"\[marks\] names '，，', which is no punctuation mark"),
        ("reach = 0.5", "reach = 0", r"\[transition\] reach must be a share in 0.05..1, found 0"),
        ("damping = 60.0", "damping = 900.0", "swings ever farther; choose a larger mass"),
        ("mass = 1.0", "mass = 0", "the mass of a spring must be a number above 0"),
        ('[shapes."&"]', "[shapes.x]", r"\[shapes\] lacks &, the mouth at rest"),
        ("jawOpen = 66", "jawOpn = 66", r"\[shapes.a\] moves 'jawOpn', which is no movestate"),
        ('er = "', 'r = "', r"\[doubtful\] names 'r', which is no syllable without tone"),
        ('silence = "&"\n', "", r"\[phonemes\] lacks silence; name its mouth shape"),
    ],
)
def test_a_table_with_nonsense_is_refused_in_one_sentence(old: str, new: str, words: str) -> None:
    assert old in GOOD
    with pytest.raises(MouthError, match=words) as refusal:
        pinyin_table_of(GOOD.replace(old, new, 1))
    assert "\n" not in re.sub(r"\(.*\)", "", str(refusal.value))


def test_a_refusal_names_the_file(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text("format = 3", encoding="utf-8")
    with pytest.raises(MouthError, match=r"^mine.toml: a pinyin table begins with format"):
        load_pinyin_table(path)
    with pytest.raises(MouthError, match=r"^none.toml: there is no such file"):
        load_pinyin_table(tmp_path / "none.toml")


@given(st.data())
def test_a_damaged_table_is_read_or_refused(data: st.DataObject) -> None:
    at = data.draw(st.integers(0, len(GOOD)))
    damaged = GOOD[:at] + data.draw(st.text(max_size=3)) + GOOD[at + data.draw(st.integers(0, 30)) :]
    with suppress(MouthError):
        assert len(pinyin_table_of(damaged).letters_of("hao")) == 2
