import sqlite3
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import PerformanceError
from phonemeengine.performance import table_file
from phonemeengine.performance.recording import Performance
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.units import UnitKind
from phonemeengine.storage.files import is_own
from tests.engine.performance.sentences import CHANNELS, performance_of


@pytest.fixture
def table(tmp_path: Path) -> Path:
    """A table of the word "mama", said at five speeds."""
    path = tmp_path / "a b#?.sqlite"
    write_table(path, [performance_of("ma.ma", length) for length in (0.1, 0.2, 0.12, 0.3, 0.16)])
    return path


def test_a_table_tells_what_it_holds(table: Path) -> None:
    with PerformanceTable.open(table) as opened:
        about = opened.about
        assert (about.name, about.synthetic, about.n_recordings) == ("a b#?", False, 5)
        assert (about.channels, about.rate) == (CHANNELS, 100.0)
        assert about.duration == pytest.approx(6 * (0.1 + 0.2 + 0.12 + 0.3 + 0.16))
        assert opened.n_units()[UnitKind.WORD] == 5
        assert opened.names(UnitKind.SYLLABLE) == {("m", "a")}


def test_a_recording_comes_back_as_it_was_but_for_float16(tmp_path: Path) -> None:
    performance = performance_of("ma.ma tu")
    write_table(tmp_path / "t.sqlite", [performance])
    with PerformanceTable.open(tmp_path / "t.sqlite") as opened:
        ((number, found),) = opened.recordings()
        assert opened.recording(number).phones == found.phones == performance.phones
        assert (found.words, found.name) == (("ma.ma", "tu"), "ma.ma tu")
        assert np.abs(found.weights - performance.weights).max() < 0.0005


def test_a_recording_that_is_asked_for_again_is_not_read_again(table: Path) -> None:
    with PerformanceTable.open(table) as opened:
        assert opened.recording(1) is opened.recording(1)


def test_examples_of_the_nearest_duration_come_first(table: Path) -> None:
    with PerformanceTable.open(table) as opened:
        durations = [e.duration for e in opened.nearest(UnitKind.WORD, ("m", "a", "m", "a"), 0.5, 3)]
        assert durations == pytest.approx([3 * 0.16, 3 * 0.2, 3 * 0.12])
        assert [e.recording for e in opened.nearest(UnitKind.WORD, ("m", "a", "m", "a"), 9.0, 1)] == [4]
        assert opened.nearest(UnitKind.WORD, ("t", "u"), 0.5, 3) == ()


def test_examples_within_a_band_are_all_that_are_in_it(table: Path) -> None:
    with PerformanceTable.open(table) as opened:
        found = opened.within(UnitKind.WORD, ("m", "a", "m", "a"), 0.35, 0.5)
        assert [(e.recording, e.first, e.last) for e in found] == [(3, 3, 9), (5, 3, 9)]


def test_a_table_is_opened_where_nothing_can_be_written(table: Path) -> None:
    before = table.read_bytes()
    table.chmod(0o400)
    table.parent.chmod(0o500)
    try:
        with PerformanceTable.open(table) as opened:
            assert opened.recording(1).words == ("ma.ma",)
    finally:
        table.parent.chmod(0o700)
    assert [*table.parent.iterdir()] == [table]
    assert table.read_bytes() == before


def test_a_table_is_known_as_our_own(table: Path, tmp_path: Path) -> None:
    stranger = tmp_path / "other.sqlite"
    with closing(sqlite3.connect(stranger)) as connection:
        connection.execute("CREATE TABLE secrets(word)")
    assert is_own(table, table_file.owns)
    assert not is_own(stranger, table_file.owns)


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("PRAGMA application_id = 0", "another program wrote it"),
        ("PRAGMA user_version = 9", "has version 9, and this program knows those up to 2"),
        ("CREATE VIEW more AS SELECT 1", "its tables are not those of this program"),
        ("DROP TABLE unit", "its tables are not those of this program"),
        ("DELETE FROM recording", "no table of performances, or a damaged one"),
        ("DELETE FROM meta", "no table of performances, or a damaged one"),
    ],
)
def test_a_database_that_is_not_ours_is_refused_in_a_sentence(table: Path, words: str, reason: str) -> None:
    with closing(sqlite3.connect(table)) as connection:
        connection.execute(words)
        connection.commit()
    with pytest.raises(PerformanceError, match=reason):
        PerformanceTable.open(table)


@pytest.mark.parametrize("content", [b"", b"not a database", b"SQLite format 3\0" + b"\0" * 5000])
def test_a_file_that_is_no_database_is_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "t.sqlite"
    path.write_bytes(content)
    with pytest.raises(PerformanceError, match="no table of performances, or a damaged one"):
        PerformanceTable.open(path)
    with pytest.raises(PerformanceError, match="cannot be read"):
        PerformanceTable.open(tmp_path / "none.sqlite")


def test_a_recording_with_too_few_frames_is_refused(table: Path) -> None:
    with closing(sqlite3.connect(table)) as connection:
        connection.execute("UPDATE recording SET n_frames = n_frames + 1 WHERE id = 2")
        connection.commit()
    with PerformanceTable.open(table) as opened:
        assert opened.recording(1).name == "ma.ma"
        with pytest.raises(PerformanceError, match="the weights of a recording do not fit its frames"):
            opened.recording(2)
        with pytest.raises(PerformanceError, match="there is no recording of the number 77"):
            opened.recording(77)


def test_a_table_that_fails_in_the_middle_leaves_the_old_one(table: Path) -> None:
    before = table.read_bytes()
    others = [performance_of("ma"), performance_of("mi", rate=50)]
    with pytest.raises(PerformanceError, match="must have the same channels and rate as ma"):
        write_table(table, others)
    with pytest.raises(PerformanceError, match="at least one recording"):
        write_table(table, [])
    assert table.read_bytes() == before
    assert [*table.parent.iterdir()] == [table]


def test_a_table_that_cannot_be_written_is_refused(tmp_path: Path) -> None:
    with pytest.raises(PerformanceError, match=r"cannot be written \(No such file or directory\)"):
        write_table(tmp_path / "none" / "t.sqlite", [performance_of("ma")])


def test_a_performance_refuses_what_is_impossible() -> None:
    good = performance_of("ma")
    for weights, phones in (
        (good.weights[:, :1], good.phones),
        (good.weights * np.nan, good.phones),
        (good.weights, good.phones[1:]),
        (good.weights, (*good.phones[:1], *good.phones[2:])),
    ):
        with pytest.raises(PerformanceError, match=r"^ma: "):
            Performance("ma", 100.0, CHANNELS, weights, phones)
