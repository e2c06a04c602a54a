from pathlib import Path

import pytest

from phonemeengine import Cancelled, CorpusError, PerformanceError, PerformanceTable, UnitKind, build_table
from tests.engine.performance.corpora import write_recording
from tests.engine.performance.faces import recorded_vmc


def test_a_table_of_a_folder_has_its_recordings(tmp_path: Path) -> None:
    for name in ("one", "two"):
        write_recording(tmp_path, name)
    told: list[float] = []
    (tmp_path / "corpus.toml").write_text('format = "phonemeanalyser corpus 1"\nperson = "Ann"\nlanguage = "de"\n')
    built = build_table(
        tmp_path, tmp_path / "t.sqlite", language="de-at", progress=lambda share: told.append(share) is None
    )
    assert told == [0, 0.5, 1]
    assert (built.about.n_recordings, built.about.name, built.left_out, built.notes) == (2, tmp_path.name, (), ())
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        assert (table.about.person, table.about.language) == ("Ann", "de-at")
        assert [p.name for _, p in table.recordings()] == ["one", "two"]
        assert len(table.nearest(UnitKind.WORD, ("m", "a", "m", "i"), 0.45, 10)) == 2


def test_a_recording_that_cannot_be_used_is_left_out_and_said(tmp_path: Path) -> None:
    for name in ("bad", "good"):
        write_recording(tmp_path, name)
    face = tmp_path / "bad.csv"
    rows = face.read_text().splitlines()
    face.write_text("\n".join([*rows[:10], *rows[20:]]))
    built = build_table(tmp_path, tmp_path / "t.sqlite", name="Ann")
    assert (built.about.n_recordings, built.about.name) == (1, "Ann")
    (sentence,) = built.left_out
    assert "bad.csv: frames may be missing for 0.1 s at most" in sentence


def test_a_recording_with_other_channels_is_left_out(tmp_path: Path) -> None:
    for name in ("first", "other"):
        write_recording(tmp_path, name)
    (tmp_path / "other.csv").unlink()
    (tmp_path / "other.osc").write_text(recorded_vmc([k / 50 for k in range(51)]), encoding="utf-8")
    built = build_table(tmp_path, tmp_path / "t.sqlite")
    assert built.about.n_recordings == 1
    assert built.left_out[0].startswith("other: the recordings of a table must have the same channels and rate as")


def test_what_is_odd_about_a_recording_is_said(tmp_path: Path) -> None:
    write_recording(tmp_path)
    face = tmp_path / "mami.csv"
    rows = face.read_text().splitlines()
    face.write_text("\n".join([*rows[:10], *rows[13:]]))
    assert build_table(tmp_path, tmp_path / "t.sqlite").notes == (
        "mami.csv: frames are missing at 1 places, for 0.067 s at most; they are bridged",
    )


def test_a_build_that_is_cancelled_leaves_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "corpus"
    folder.mkdir()
    for name in ("one", "two"):
        write_recording(folder, name)
    with pytest.raises(Cancelled):
        build_table(folder, tmp_path / "t.sqlite", progress=lambda share: share < 0.5)
    assert [*tmp_path.iterdir()] == [folder]


def test_a_folder_without_a_usable_recording_makes_no_table(tmp_path: Path) -> None:
    with pytest.raises(CorpusError, match="there is none in this folder"):
        build_table(tmp_path, tmp_path / "t.sqlite")
    write_recording(tmp_path)
    (tmp_path / "mami.csv").write_text("nothing")
    with pytest.raises(PerformanceError, match=r"no recording can be used; of the first one: mami\.csv: this"):
        build_table(tmp_path, tmp_path / "t.sqlite")
    assert not (tmp_path / "t.sqlite").exists()
