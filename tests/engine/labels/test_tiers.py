"""Label files that are edited: what was there stays, and what was changed is changed."""

from pathlib import Path

import parselmouth
import pytest

from phonemeengine.errors import CorpusError
from phonemeengine.labels.textgrid import Tier, tiers_of
from phonemeengine.labels.tiers import (
    SHORTEST,
    deleted,
    gap_at,
    inserted,
    kept_in,
    labels_beside,
    lost_in,
    merged,
    moved,
    read_tiers,
    renamed,
    split,
    write_tiers,
)
from phonemeengine.labels.utterance import RawLabel


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


TABLE = "start_s,end_s,phone,class,certainty\n0.1,0.2,ɛ,e,ambiguous\n0.2,0.3,ʃ,sch,core\n"


def test_the_corpus_format_is_a_tier_of_phones_and_one_of_classes(tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    path.write_text(TABLE)
    phones, classes = read_tiers(path)
    assert (phones.name, [raw.name for raw in phones.raw_labels]) == ("phones", ["ɛ", "ʃ"])
    assert (classes.name, [(raw.name, raw.certainty) for raw in classes.raw_labels]) == (
        "classes",
        [("e", "ambiguous"), ("sch", "core")],
    )
    write_tiers([moved(phones, 1, end=True, seconds=0.35), renamed(classes, 1, "sz")], path)
    assert path.read_text().splitlines()[1:] == ["0.100000,0.200000,ɛ,e,ambiguous", "0.200000,0.300000,ʃ,sz,core"]


def test_a_textgrid_keeps_the_columns_of_the_corpus_format_and_gives_them_back(tmp_path: Path) -> None:
    path, grid = tmp_path / "x.csv", tmp_path / "x.TextGrid"
    path.write_text(TABLE)
    found = read_tiers(path)
    write_tiers(found, grid, duration=0.5)
    names = [raw.name for tier in tiers_of(grid.read_text(), "x") for raw in tier.raw_labels]
    assert names == ["ɛ", "ʃ", "e", "sch", "ambiguous", "core"]
    write_tiers(read_tiers(grid), path)
    assert [line.split(",")[2:] for line in path.read_text().splitlines()[1:]] == [
        ["ɛ", "e", "ambiguous"],
        ["ʃ", "sch", "core"],
    ]


def test_what_a_format_loses_is_known_before(tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text(TABLE)
    found = (*read_tiers(tmp_path / "x.csv"), tier((0.1, 0.3, "esh"), name="words"))
    assert lost_in(found, 1, Path("x.TextGrid")) == ()
    assert lost_in(found, 1, Path("x.csv")) == ("words",)
    assert lost_in(found, 1, Path("x.txt")) == ("phones", "words", "certainty")
    assert lost_in([MA], 0, Path("x.txt")) == ()
    for suffix in (".TextGrid", ".csv", ".txt"):
        kept = kept_in(found, 1, Path(f"x{suffix}"))
        write_tiers(kept, tmp_path / f"y{suffix}", duration=1.0)
        assert len(read_tiers(tmp_path / f"y{suffix}")) == len(kept)


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


def test_labels_are_split_and_merged_over_gaps() -> None:
    assert shown(split(MA, 1, 0.5))[1:3] == [(0.3, 0.5, "a"), (0.5, 0.6, "a")]
    assert shown(merged(MA, 1, 2)) == [(0.1, 0.3, "m"), (0.3, 0.9, "a")]
    assert shown(merged(MA, 1, 0)) == [(0.1, 0.6, "a"), (0.8, 0.9, "s")]
    for act in (lambda: split(MA, 1, 0.302), lambda: merged(MA, 2, 3), lambda: merged(MA, 0, -1)):
        with pytest.raises(CorpusError):
            act()


def test_gaps_lie_between_labels() -> None:
    assert gap_at(MA, 0.7, 1.0) == (0.6, 0.8)
    assert gap_at(MA, 0.95, 1.0) == (0.9, 1.0)
    assert gap_at(MA, 0.2, 1.0) == (0.2, 0.2)
    assert gap_at(None, 0.2, 1.0) == (0.0, 1.0)


@pytest.mark.parametrize(
    ("start", "end", "name", "reason"),
    [(0.2, 0.5, "x", "is labelled from"), (0.7, 0.702, "x", "at least"), (0.65, 0.75, "  ", "needs a name")],
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
