"""Mouth tables: what ships says what the subject says, and a broken file is refused in one sentence."""

import re
import tomllib
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import MouthError
from phonemeengine.mouth.blendshape_names import ARKIT, OCULUS, VRM
from phonemeengine.mouth.table import (
    SPEAKING,
    TABLES,
    MotionSettings,
    MouthTable,
    TransitionTimes,
    load_table,
    shipped_tables,
    table_of,
    table_to_toml,
    tables_by_movestates,
)
from phonemeengine.phonemes import Phoneme

GOOD = (TABLES / "vrm.toml").read_text(encoding="utf-8")
UNTIMED = re.sub(r"\[times\][^\[]*", "", GOOD)
"""A table as it was before each sound had times of its own."""
COLUMNS = {"arkit": ARKIT, "eleven": ARKIT, "five": ARKIT, "oculus": OCULUS, "vrm": VRM}


def weight(table: MouthTable, phoneme: Phoneme, movestate: str) -> float:
    return float(table.weights()[phoneme, table.movestates.index(movestate)])


@pytest.mark.parametrize("name", shipped_tables())
def test_every_shipped_table_knows_all_phonemes_and_stays_within_the_movement(name: str) -> None:
    table = load_table(name)
    assert set(table.phonemes) == set(Phoneme)
    assert table.notes
    weights = table.weights()
    assert weights.shape == (11, len(table.movestates))
    assert (weights >= 0).all()
    assert (weights <= 1).all()


@pytest.mark.parametrize(("name", "columns"), COLUMNS.items())
def test_the_sets_of_other_programs_have_their_movestates_in_their_order(name: str, columns: tuple[str, ...]) -> None:
    assert load_table(name).movestates == columns


def test_each_set_of_movestates_has_the_table_that_is_named_as_it() -> None:
    tables = tables_by_movestates()
    moved = [load_table(name).movestates for name in tables]
    assert set(moved) == {load_table(name).movestates for name in shipped_tables()} - {()}
    assert len(set(moved)) == len(moved)
    assert set(tables) >= {"arkit", "oculus", "vrm", "vrm1"}
    assert tables["arkit"] == "ARKit 52"


def test_arkit_has_52_names_of_which_each_left_has_a_right() -> None:
    assert len(set(ARKIT)) == 52
    sided = {name.removesuffix("Left") for name in ARKIT if name.endswith("Left")} - {"jaw", "mouth"}
    assert all(f"{name}Right" in ARKIT for name in sided)


def test_the_five_shapes_are_of_all_phonemes_and_closed_for_lips_and_silence() -> None:
    shapes = load_table("five").phonemes
    assert (set(shapes), len({*shapes.values()})) == (set(Phoneme), 5)
    assert {p.label for p, shape in shapes.items() if shape == "closed"} == {"m", "p", "silence"}


def test_the_eleven_shapes_are_one_for_each_phoneme() -> None:
    shapes = load_table("eleven").phonemes
    assert dict(shapes) == {p: p.label for p in Phoneme}


@pytest.mark.parametrize("name", ["arkit", "eleven"])
def test_shapes_are_made_as_a_phonetician_says(name: str) -> None:
    """a is the most open vowel and i and u the closest; o and u are rounded, i and e spread; m and p shut."""
    table = load_table(name)
    jaw = {p: weight(table, p, "jawOpen") for p in Phoneme}
    assert jaw[Phoneme.A] > jaw[Phoneme.O] > jaw[Phoneme.U]
    assert jaw[Phoneme.A] > jaw[Phoneme.E] > jaw[Phoneme.I]
    assert jaw[Phoneme.M] == jaw[Phoneme.P] == jaw[Phoneme.SILENCE] == 0
    for rounded in (Phoneme.O, Phoneme.U, Phoneme.SCH):
        assert weight(table, rounded, "mouthFunnel") + weight(table, rounded, "mouthPucker") > 0.8
    for spread in (Phoneme.I, Phoneme.E):
        assert weight(table, spread, "mouthSmileLeft") == weight(table, spread, "mouthSmileRight") > 0
        assert weight(table, spread, "mouthPucker") == 0
    for shut in (Phoneme.M, Phoneme.P):
        assert weight(table, shut, "mouthPressLeft") > 0.2


def test_the_shapes_of_the_shipped_tables_are_told_apart() -> None:
    rows = load_table("eleven").weights()
    distances = np.abs(rows[:, None] - rows[None]).sum(axis=2)
    assert distances[~np.eye(11, dtype=bool)].min() > 0.2


def test_a_name_without_a_side_moves_both_sides() -> None:
    text = GOOD.replace('movestates = "vrm"', 'movestates = ["A", "I", "U", "E", "O", "lidLeft", "lidRight"]')
    table = table_of(text.replace("[shapes.A]\n", "[shapes.A]\nlid = 40\n"))
    assert weight(table, Phoneme.A, "lidLeft") == weight(table, Phoneme.A, "lidRight") == pytest.approx(0.4)


def test_a_side_and_both_sides_at_once_are_refused() -> None:
    text = GOOD.replace('movestates = "vrm"', 'movestates = ["A", "I", "U", "E", "O", "lidLeft", "lidRight"]')
    with pytest.raises(MouthError, match=r"\[shapes.A\] says twice what 'lidLeft' does; remove one"):
        table_of(text.replace("[shapes.A]\n", "[shapes.A]\nlid = 40\nlidLeft = 10\n"))


def test_a_table_may_exaggerate_and_pull_the_other_way() -> None:
    table = table_of(GOOD.replace("A = 100", "A = 150\nU = -20"))
    assert weight(table, Phoneme.A, "A") == pytest.approx(1.5)
    assert weight(table, Phoneme.A, "U") == pytest.approx(-0.2)


@pytest.mark.parametrize("name", shipped_tables())
def test_every_shipped_table_says_how_fast_the_mouth_is_for_which_sound(name: str) -> None:
    document = tomllib.loads((TABLES / f"{name}.toml").read_text(encoding="utf-8"))
    assert set(document["times"]) == {p.label for p in SPEAKING}
    assert all(set(times) == {"attack", "release"} for times in document["times"].values())
    assert load_table(name).times == load_table("arkit").times


def test_an_animator_sets_the_times_of_one_sound_and_the_manner() -> None:
    table = table_of(
        re.sub("a = { attack.*", "a = { attack = 0.3, release = 0.4 }", GOOD) + "\n[manner]\nquiet = 0\n"
    )
    assert table.times[Phoneme.A] == TransitionTimes(0.3, 0.4)
    assert table.times[Phoneme.E] == load_table("vrm").times[Phoneme.E]
    assert table.motion == MotionSettings(minimum_opening=0)


def test_a_table_that_gives_one_attack_and_release_for_all_still_means_it() -> None:
    table = table_of(UNTIMED + "\n[manner]\nattack = 0.2\nrelease = 0.3\nclosing = 0.04\nrandomness = 0\n")
    lips = {Phoneme.M, Phoneme.P}
    assert table.times == {p: TransitionTimes(0.04 if p in lips else 0.2, 0.3) for p in SPEAKING}
    assert table_of(UNTIMED).times == {p: TransitionTimes(0.05 if p in lips else 0.09, 0.16) for p in SPEAKING}


def test_what_a_sound_does_not_say_of_its_times_is_that_of_all() -> None:
    text = UNTIMED.replace("[shapes.closed]", "[times]\na = { attack = 0.3 }\nm = { release = 0.1 }\n[shapes.closed]")
    times = table_of(text + "\n[manner]\nrelease = 0.25\n").times
    assert (times[Phoneme.A], times[Phoneme.M]) == (TransitionTimes(0.3, 0.25), TransitionTimes(0.05, 0.1))
    assert times[Phoneme.E] == TransitionTimes(0.09, 0.25)


# name: (what stands in the file, what is put there instead, what the refusal says)
CHANGES = {
    "no format": (
        'format = "phonemeanalyser mouth 1"',
        "",
        "begins with format = 'phonemeanalyser mouth 1', found none",
    ),
    "unknown key": ("firm =", "speed = 1\nfirm =", "cannot have an entry 'speed'; remove it, or use one of"),
    "lacking phoneme": ('sz = "teeth"\n', "", r"\[phonemes\] lacks sz; name its mouth shape"),
    "unknown phoneme": ('sz = "teeth"', 'sz = "teeth"\nth = "teeth"', r"\[phonemes\]: there is no phoneme 'th'"),
    "unknown shape": (
        'sz = "teeth"',
        'sz = "tooth"',
        r"\[phonemes\] sz has the shape 'tooth', which \[shapes\] lacks",
    ),
    "unknown movestate": ("I = 35", "jawOpen = 35", r"\[shapes.teeth\] moves 'jawOpen', which is no movestate"),
    "text as percentage": ("I = 35", 'I = "35"', r"\[shapes.teeth\] I must be a percentage in -400..400, found '35'"),
    "too far": ("I = 35", "I = 401", r"\[shapes.teeth\] I must be a percentage .* found 401"),
    "unknown set": ('movestates = "vrm"', 'movestates = "vrm2"', "movestates must be one of arkit, oculus, vrm"),
    "name twice": ('movestates = "vrm"', 'movestates = ["A", "A"]', "movestates names 'A' twice; remove one"),
    "no movestates": ('movestates = "vrm"\n', "", "a mouth table lacks movestates; add it"),
    "firm unknown": ('firm = ["m", "p"]', 'firm = ["b"]', "firm must be one of silence, .*, found 'b'"),
    "manner too slow": (
        "[shapes.A]",
        "[manner]\nattack = 0\n[shapes.A]",
        r"\[manner\] attack must be a number of seconds in 0.005..1, found 0",
    ),
    "times of silence": (
        "[times]",
        "[times]\nsilence = { attack = 0.1 }",
        r"\[times\] silence has none: .* remove it",
    ),
    "times of no phoneme": ("[times]", "[times]\nth = { attack = 0.1 }", r"\[times\]: there is no phoneme 'th'"),
    "times as number": ("a = { attack = 0.10, release = 0.20 }", "a = 0.1", r"\[times\] a must be like .* found 0.1"),
    "unknown time": ("a = { attack = 0.10", "a = { hold = 0.10", r"\[times\] a must be like { attack = 0.1"),
    "time too short": (
        "a = { attack = 0.10",
        "a = { attack = 0",
        r"\[times.a\] attack must be a number of seconds in 0.005..1, found 0",
    ),
    "time that acts on nothing": (
        "[shapes.A]",
        "[manner]\nattack = 0.2\n[shapes.A]",
        r"\[manner\] attack acts on nothing, since \[times\] names every phoneme; remove one of them",
    ),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_broken_table_is_refused_with_the_file_and_the_entry(change: str, tmp_path: Path) -> None:
    old, new, said = CHANGES[change]
    assert old in GOOD
    path = tmp_path / "mine.toml"
    path.write_text(GOOD.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(MouthError, match=said) as refusal:
        load_table(path)
    assert str(refusal.value).startswith("mine.toml: ")
    assert str(refusal.value).isprintable()


def test_a_table_that_is_not_there_is_refused_with_those_that_are(tmp_path: Path) -> None:
    with pytest.raises(
        MouthError, match=r"gone: there is no such mouth table; name a file, or one of annosoft, arkit"
    ):
        load_table("gone")
    (tmp_path / "large.toml").write_bytes(b"#" * ((1 << 20) + 1))
    with pytest.raises(MouthError, match=r"at most 1 MB, this has 1\.1 MB; choose another"):
        load_table(tmp_path / "large.toml")
    (tmp_path / "picture.toml").write_bytes(b"\x89PNG\r\n\x1a\n\xff")
    with pytest.raises(MouthError, match="no text file"):
        load_table(tmp_path / "picture.toml")
    with pytest.raises(MouthError, match="this is a folder; choose a file in it"):
        load_table(tmp_path)


@given(st.integers(0, len(GOOD) - 1), st.integers(0, 30), st.text(max_size=12))
def test_no_damage_to_a_table_is_more_than_refused(start: int, length: int, instead: str) -> None:
    with suppress(MouthError):
        table = table_of(GOOD[:start] + instead + GOOD[start + length :])
        assert np.isfinite(table.weights()).all()


@pytest.mark.parametrize("name", shipped_tables())
def test_a_table_that_is_written_reads_as_the_same_table(name: str) -> None:
    assert table_of(table_to_toml(load_table(name))) == load_table(name)
