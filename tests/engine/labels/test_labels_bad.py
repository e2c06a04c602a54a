"""Label files that say something impossible: each is refused with one sentence, in no time."""

import contextlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import CorpusError
from phonemeengine.labels.files import read_labels, write_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from tests.disks import refused

HEAD = 'File type = "ooTextFile"\nObject class = "TextGrid"\n\n'
GRID = HEAD + '0\n2\n<exists>\n1\n"IntervalTier"\n"phones"\n0\n2\n2\n0\n1\n"a"\n1\n2\n"m"\n'
CSV = "start_s,end_s,phone,class,certainty\n"
DURATION = 2.0

BAD = {
    "empty.TextGrid": (b"", "line 1: the kind of file must be a text"),
    "empty.txt": (b"", "no label in it"),
    "empty.csv": (b"", "lacks the column"),
    "picture.TextGrid": (b"\x89PNG\r\n\x1a\n\xff\x00\x12" * 9, "no text"),
    "zeros.txt": (bytes(4000), "must|is start, end and name"),
    "binary.TextGrid": (b"ooBinaryFile\x08TextGrid" + bytes(40), "binary; save it in Praat as a text file"),
    "sound.TextGrid": (GRID.replace("TextGrid", "Sound", 1), "no TextGrid"),
    "words.TextGrid": ("once upon a time", "cut off or damaged"),
    "half.TextGrid": (GRID[: len(GRID) // 2], "cut off or damaged"),
    "last_quote.TextGrid": (GRID[:-2], "closing quote"),
    "more_than_said.TextGrid": (GRID + '2\n3\n"u"\n', "the end of the file must be nothing more"),
    "huge_count.TextGrid": (GRID.replace("2\n2\n0\n1", "2\n999999999\n0\n1"), "cut off or damaged"),
    "many_tiers.TextGrid": (GRID.replace("<exists>\n1", "<exists>\n999999999"), "tier 2 .* cut off"),
    "negative_count.TextGrid": (GRID.replace("<exists>\n1", "<exists>\n-1"), "a whole number from 0, found '-1'"),
    "nan.TextGrid": (GRID.replace('0\n1\n"a"', '0\nNaN\n"a"'), "seconds from 0, found 0..nan s"),
    "negative.TextGrid": (GRID.replace('0\n1\n"a"', '-1\n1\n"a"'), "seconds from 0, found -1..1 s"),
    "backwards.TextGrid": (GRID.replace('0\n1\n"a"', '1\n0\n"a"'), "must not end before it starts, found 1..0 s"),
    "years.TextGrid": (GRID.replace('1\n2\n"m"', '1\n200000000\n"m"'), "within a day"),
    "overlap.TextGrid": (GRID.replace('1\n2\n"m"', '0.9\n2\n"m"'), "interval 2: .* found 0.9..2 s after 0..1 s"),
    "beyond.TextGrid": (GRID.replace('1\n2\n"m"', '1\n2.06\n"m"'), r"1..2.06 s lies beyond .* lasts 2.000 s"),
    "nothing.TextGrid": (HEAD + "0\n2\n<absent>\n", "no tier of intervals with a label"),
    "unlabelled.TextGrid": (GRID.replace('"a"', '""').replace('"m"', '" "'), "no tier of intervals with a label"),
    "points.TextGrid": (HEAD + '0\n2\n<exists>\n1\n"TextTier"\n"x"\n0\n2\n1\n1\n"a"\n', "no tier of intervals"),
    "transcript.txt": ("Hello world, this is text.\n", "line 1: a label of Audacity is .*found 'Hello"),
    "wholly_beyond.txt": ("0\t1\ta\n2.0\t2.02\tm\n", "line 2: .* lies beyond"),
    "nan.txt": ("nan\tnan\ta\n", "line 1: times must be seconds"),
    "points.txt": ("1\t1\ta\n", "points without length"),
    "overlap.txt": ("0\t1\ta\n0.5\t1.5\tm\n", "line 2: .* overlap, found 0.5..1.5 s after 0..1 s of line 1"),
    "no_class.csv": (CSV + "0,1,x,,core\n", "line 2: the class"),
    "words.csv": (CSV + "0,later,x,a,core\n", "line 2: start_s and end_s must be seconds, found '0' and 'later'"),
    "endless_cell.csv": (CSV + "0,1," + "x" * 200_000 + ",a,core\n", "cannot be read as CSV"),
    "labels.doc": ("0\t1\ta\n", "read from .TextGrid, .txt"),
}


@pytest.mark.parametrize("name", BAD)
def test_a_bad_label_file_is_refused_in_one_sentence(tmp_path, name):
    content, message = BAD[name]
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(CorpusError, match=message) as caught:
        read_labels(path, duration=DURATION)
    assert str(caught.value).startswith(name)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 300


def test_a_missing_label_file_and_a_folder_are_refused(tmp_path):
    (tmp_path / "folder.txt").mkdir()
    for name in ("missing.csv", "folder.txt"):
        with pytest.raises(CorpusError, match=rf"{name}: (there is no such file|this is a folder);"):
            read_labels(tmp_path / name)


def test_a_huge_file_is_refused_before_it_is_read(tmp_path):
    path = tmp_path / "x.csv"
    with path.open("wb") as file:
        file.truncate(1 << 40)  # more than memory takes, if it were read
    with pytest.raises(CorpusError, match="at most 64 MB"):
        read_labels(path)


@given(st.binary(max_size=300) | st.text(max_size=300).map(lambda text: (HEAD + text).encode("utf-8", "replace")))
def test_whatever_stands_in_a_file_it_is_read_or_refused(tmp_path_factory, content):
    folder = tmp_path_factory.mktemp("any")
    for name in ("x.TextGrid", "x.txt", "x.csv"):
        path = folder / name
        path.write_bytes(content)
        with contextlib.suppress(CorpusError):
            assert read_labels(path)


@given(st.integers(0, len(GRID) - 3))
def test_a_textgrid_that_is_cut_off_anywhere_is_refused(tmp_path_factory, end):
    path = tmp_path_factory.mktemp("cut") / "x.TextGrid"
    path.write_text(GRID[:end])
    with pytest.raises(CorpusError):
        read_labels(path)


def test_rounding_overlaps_are_mended(tmp_path):
    path = tmp_path / "x.txt"
    path.write_text("0\t1.0005\ta\n1\t2\tm\n")
    labels = read_labels(path)
    assert [(x.start, x.end) for x in labels] == [(0, 1), (1, 2)]


def test_a_label_that_ends_a_little_after_its_sound_is_cut(tmp_path):
    path = tmp_path / "x.txt"
    path.write_text("0\t1\ta\n1\t2.049\tm\n")
    assert read_labels(path, duration=DURATION)[-1].end == DURATION
    path.write_text("0\t1\ta\n1\t2.0005\tm\n")
    assert read_labels(path, duration=DURATION)[-1].end == 2.0005


def test_labels_are_given_in_order_of_time(tmp_path):
    path = tmp_path / "x.txt"
    path.write_text("1\t2\tm\n0\t1\ta\n")
    assert [x.phoneme for x in read_labels(path)] == [Phoneme.A, Phoneme.M]


@pytest.mark.parametrize("event", ["open", "os.rename"])
def test_the_old_file_stays_when_writing_fails(tmp_path, event):
    path = tmp_path / "x.csv"
    write_labels([Label(0, 1, "a", Phoneme.A)], path)
    old = path.read_bytes()
    refusal = pytest.raises(CorpusError, match=r"x\.csv: cannot be written \(No space left on device\)")
    with refused(tmp_path, events={event}), refusal:
        write_labels([Label(0, 2, "m", Phoneme.M)], path)
    assert path.read_bytes() == old
    assert [p.name for p in tmp_path.iterdir()] == ["x.csv"]


@pytest.mark.parametrize(("name", "labels"), [("x.doc", [Label(0, 1, "a", Phoneme.A)]), ("x.csv", [])])
def test_what_cannot_be_written_is_refused(tmp_path, name, labels):
    with pytest.raises(CorpusError, match=name):
        write_labels(labels, tmp_path / name)
    assert not list(tmp_path.iterdir())
