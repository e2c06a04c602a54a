"""Label files that are edited: what was there stays, and what was changed is changed."""

from pathlib import Path

import parselmouth
import pytest

from phonemeengine.errors import CorpusError
from phonemeengine.labels.files import phoneme_tier_of
from phonemeengine.labels.label import RawLabel
from phonemeengine.labels.phoneme_map import PhonemeMap
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.tiers import (
    SHORTEST,
    columns_lost,
    deleted,
    inserted,
    labels_beside,
    moved,
    read_tiers,
    renamed,
    write_tiers,
)


def tier(*labels: tuple[float, float, str], name: str = "phones", points: bool = False) -> Tier:
    return Tier(name, tuple(RawLabel(start, end, text, "here") for start, end, text in labels), points)


def shown(found: Tier) -> list[tuple[float, float, str]]:
    return [(raw.start, raw.end, raw.name) for raw in found.raw_labels]


MA = tier((0.1, 0.3, "m"), (0.3, 0.6, "a"), (0.8, 0.9, "s"))


def test_a_grid_keeps_all_its_tiers_also_those_of_points_and_of_one_name(tmp_path: Path) -> None:
    tiers = (MA, tier((0.25, 0.25, "click"), name="events", points=True), tier((0.1, 0.6, "ma"), name="phones"))
    write_tiers(tiers, tmp_path / "x.TextGrid", duration=1.0)
    found = read_tiers(tmp_path / "x.TextGrid", duration=1.0)
    assert [(t.name, t.points, shown(t)) for t in found] == [(t.name, t.points, shown(t)) for t in tiers]
    praat = parselmouth.Data.read(str(tmp_path / "x.TextGrid"))
    assert parselmouth.praat.call(praat, "Get number of tiers") == 3
    assert parselmouth.praat.call(praat, "Get number of points", 2) == 1
    assert parselmouth.praat.call(praat, "Get label of interval", 1, 3) == "a"


@pytest.mark.parametrize("suffix", [".csv", ".txt"])
def test_other_formats_hold_one_tier(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"x{suffix}"
    write_tiers([MA], path)
    assert [shown(t) for t in read_tiers(path)] == [shown(MA)]
    with pytest.raises(CorpusError, match="only a TextGrid holds 2 tiers"):
        write_tiers([MA, MA], path)


def test_the_corpus_format_keeps_phone_and_certainty_of_what_is_not_renamed(tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    path.write_text("start_s,end_s,phone,class,certainty\n0.1,0.2,ɛ,e,ambiguous\n0.2,0.3,ʃ,sch,core\n")
    (found,) = read_tiers(path)
    write_tiers([renamed(found, 1, "sz")], path)
    assert path.read_text().splitlines()[1:] == [
        "0.100000,0.200000,ɛ,e,ambiguous",
        "0.200000,0.300000,sz,sz,core",
    ]


def test_a_textgrid_keeps_the_columns_of_the_corpus_format_as_tiers(tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    path.write_text("start_s,end_s,phone,class,certainty\n0.1,0.2,ɛ,e,ambiguous\n0.2,0.3,ʃ,sch,core\n")
    found = read_tiers(path)
    write_tiers(found, tmp_path / "x.TextGrid", duration=0.5)
    again = read_tiers(tmp_path / "x.TextGrid")
    assert {t.name: [name for _, _, name in shown(t)] for t in again} == {
        "x": ["e", "sch"],
        "transcription": ["ɛ", "ʃ"],
        "certainty": ["ambiguous", "core"],
    }
    assert {tuple((start, end) for start, end, _ in shown(t)) for t in again} == {((0.1, 0.2), (0.2, 0.3))}
    assert phoneme_tier_of(again, PhonemeMap()).name == "x"
    assert columns_lost(found, tmp_path / "x.TextGrid") == ()
    assert columns_lost(found, tmp_path / "x.txt") == ("phone", "certainty")
    assert columns_lost([MA], tmp_path / "x.txt") == ()


def test_a_boundary_moves_with_the_label_that_touches_it() -> None:
    assert shown(moved(MA, 0, end=True, seconds=0.4))[:2] == [(0.1, 0.4, "m"), (0.4, 0.6, "a")]
    assert shown(moved(MA, 1, end=False, seconds=0.2))[:2] == [(0.1, 0.2, "m"), (0.2, 0.6, "a")]
    assert shown(moved(MA, 1, end=True, seconds=0.7))[1:] == [(0.3, 0.7, "a"), (0.8, 0.9, "s")]


@pytest.mark.parametrize(
    ("k", "end", "seconds", "expected"),
    [
        (0, True, 9.0, 0.6 - SHORTEST),
        (0, True, 0.0, 0.1 + SHORTEST),
        (1, True, 9.0, 0.8),
        (2, False, 0.0, 0.6),
        (0, False, -3.0, 0.0),
        (2, True, 5.0, 5.0),
    ],
)
def test_no_boundary_swallows_a_label(k: int, end: bool, seconds: float, expected: float) -> None:
    label = moved(MA, k, end=end, seconds=seconds).raw_labels[k]
    assert (label.end if end else label.start) == pytest.approx(expected)


def test_labels_are_renamed_inserted_and_deleted() -> None:
    assert shown(renamed(MA, 1, "  o \n"))[1] == (0.3, 0.6, "o")
    assert shown(inserted(MA, 0.65, 0.75, "p"))[2] == (0.65, 0.75, "p")
    assert shown(deleted(MA, 0)) == shown(MA)[1:]


@pytest.mark.parametrize(
    ("start", "end", "name", "reason"),
    [
        (0.2, 0.5, "x", "is labelled from"),
        (0.7, 0.702, "x", "at least"),
        (0.65, 0.75, "  ", "needs a name"),
    ],
)
def test_what_cannot_be_inserted_is_one_sentence(start: float, end: float, name: str, reason: str) -> None:
    with pytest.raises(CorpusError, match=reason):
        inserted(MA, start, end, name)


def test_labels_that_overlap_or_lie_beyond_the_sound_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "x.txt"
    path.write_text("0.0\t0.5\ta\n0.4\t0.6\to\n")
    with pytest.raises(CorpusError, match="must not overlap"):
        read_tiers(path)
    path.write_text("0.0\t0.5\ta\n0.5\t9.0\to\n")
    with pytest.raises(CorpusError, match="beyond the end of the sound"):
        read_tiers(path, duration=1.0)


def test_the_labels_beside_a_sound_are_found_and_scripts_are_none(tmp_path: Path) -> None:
    sound = tmp_path / "a.wav"
    assert labels_beside(sound) is None
    (tmp_path / "a.txt").write_text("Good evening.\n")
    assert labels_beside(sound) is None
    (tmp_path / "a.txt").write_text("0.1\t0.2\ta\n")
    assert labels_beside(sound) == tmp_path / "a.txt"
    (tmp_path / "a.TextGrid").write_text("damaged")  # said when it is read
    assert labels_beside(sound) == tmp_path / "a.TextGrid"
    assert labels_beside(tmp_path / "no folder" / "a.wav") is None


def test_a_thousand_tiers_are_read(tmp_path: Path) -> None:
    path = tmp_path / "many.TextGrid"
    write_tiers([tier((0.1, 0.2, "a"), name=f"tier {k}") for k in range(1000)], path, duration=1.0)
    assert len(read_tiers(path)) == 1000
