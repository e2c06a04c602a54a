"""Label files: what is written is what is read, whatever the format, and others read it too."""

from itertools import accumulate, pairwise

import numpy as np
import parselmouth
import pytest
from hypothesis import given
from hypothesis import strategies as st
from parselmouth.praat import call, run

from phonemeengine.calibration.scores.corpus import frame_labels_of
from phonemeengine.errors import CorpusError
from phonemeengine.labels.files import read_labels, write_labels
from phonemeengine.labels.phone_sets import PhonemeMap
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from tests.labelled import labels_of

ENCODINGS = ("utf-8", "utf-8-sig", "utf-16", "utf-16-be", "utf-16-le")

phonemes = st.sampled_from(Phoneme)
phones = st.text(st.characters(exclude_categories=("Cs", "Cc", "Zl", "Zp")), min_size=1, max_size=8)


@st.composite
def labellings(draw):
    """Labels in order of time, with gaps between some of them."""
    steps = draw(st.lists(st.integers(2, 10**6), min_size=1, max_size=12))
    times = [t / 10**6 for t in accumulate([draw(st.integers(0, 10**6)), *steps])]
    labels = [
        Label(start, end, draw(phones), draw(phonemes), draw(st.sampled_from(["core", "ambiguous", "trimmed"])))
        for start, end in pairwise(times)
    ]
    return tuple(label for label in labels if draw(st.booleans())) or (labels[0],)


def heard(labels):
    return [(round(label.start, 6), round(label.end, 6), label.phoneme) for label in labels]


@given(labellings())
def test_the_corpus_format_keeps_everything(tmp_path_factory, labels):
    path = tmp_path_factory.mktemp("labels") / "x.csv"
    write_labels(labels, path)
    again = read_labels(path)
    assert heard(again) == heard(labels)
    assert [(x.phone, x.certainty) for x in again] == [(x.phone, x.certainty) for x in labels]


@given(labellings(), st.sampled_from(ENCODINGS), st.booleans(), st.floats(0, 10))
def test_a_textgrid_keeps_names_and_times(tmp_path_factory, labels, encoding, short, duration):
    path = tmp_path_factory.mktemp("labels") / "x.TextGrid"
    write_labels(labels, path, duration=duration, encoding=encoding, short=short)
    assert heard(read_labels(path)) == heard(labels)


@given(labellings())
def test_a_label_track_keeps_names_and_times(tmp_path_factory, labels):
    path = tmp_path_factory.mktemp("labels") / "x.txt"
    write_labels(labels, path)
    assert heard(read_labels(path)) == heard(labels)


AWKWARD = (
    Label(0.25, 0.5, 'say "ah"', Phoneme.A),
    Label(0.5, 0.75, "ʃ 日本 <exists> 12 ! \\", Phoneme.SCH),
    Label(1.0, 1.5, '""', Phoneme.SZ),
)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
@pytest.mark.parametrize("short", [False, True])
def test_praat_reads_what_is_written(tmp_path, encoding, short):
    path = tmp_path / "x.TextGrid"
    write_labels(AWKWARD, path, duration=2.0, encoding=encoding, short=short)
    grid = parselmouth.read(str(path))
    assert call(grid, "Get number of tiers") == 2
    assert [call(grid, "Get tier name", k) for k in (1, 2)] == ["phonemes", "phones"]
    n = call(grid, "Get number of intervals", 1)
    found = [
        (call(grid, "Get start time of interval", 2, k), call(grid, "Get label of interval", 2, k))
        for k in range(1, n + 1)
    ]
    expected = [(0, ""), (0.25, AWKWARD[0].phone), (0.5, AWKWARD[1].phone), (0.75, ""), (1, '""'), (1.5, "")]
    assert found == expected
    assert [call(grid, "Get label of interval", 1, k) for k in (2, 3, 5)] == ["a", "sch", "sz"]
    assert call(grid, "Get end time") == 2


@pytest.mark.parametrize("encoding", ["UTF-8", "UTF-16"])
@pytest.mark.parametrize("command", ["Save as text file", "Save as short text file"])
def test_what_praat_writes_is_read(tmp_path, encoding, command):
    path = tmp_path / "x.TextGrid"
    grid = call("Create TextGrid", 0, 1.5, "words sounds marks", "marks")
    call(grid, "Insert boundary", 2, 0.5)
    call(grid, "Insert boundary", 2, 0.75)
    for tier, interval, text in ((1, 1, 'she said "ah"\nand m'), (2, 1, "ʃ"), (2, 3, 'the "a"')):
        call(grid, "Set interval text", tier, interval, text)
    call(grid, "Insert point", 3, 0.3, "here")
    run(f'Text writing preferences: "{encoding}"')
    try:
        call(grid, command, str(path))
    finally:
        run('Text writing preferences: "UTF-8"')
    labels = read_labels(path, PhonemeMap({'the "a"': Phoneme.A}))
    assert heard(labels) == [(0, 0.5, Phoneme.SCH), (0.75, 1.5, Phoneme.A)]
    assert labels[1].phone == 'the "a"'


def test_line_ends_and_remarks_do_not_matter(tmp_path):
    path, other = tmp_path / "x.TextGrid", tmp_path / "y.TextGrid"
    write_labels(AWKWARD, path, duration=2)
    text = path.read_text(encoding="utf-8").replace("intervals [2]:", 'intervals [2]: ! "no" 12 <exists>')
    other.write_text(text, encoding="utf-8", newline="\r\n")
    assert read_labels(other) == read_labels(path)


def test_the_first_tier_of_sounds_is_read_unless_another_is_named(tmp_path):
    grid = call("Create TextGrid", 0, 1, "words sounds others", "")
    for tier, text in ((1, "mama"), (2, "m"), (3, "u")):
        call(grid, "Set interval text", tier, 1, text)
    path = tmp_path / "x.TextGrid"
    call(grid, "Save as text file", str(path))
    assert read_labels(path)[0].phoneme is Phoneme.M
    assert read_labels(path, tier="others")[0].phoneme is Phoneme.U
    with pytest.raises(CorpusError, match=r"no tier of intervals named 'none'.*'words', 'sounds', 'others'"):
        read_labels(path, tier="none")


def test_audacity_labels_of_a_spectrogram_are_read_and_points_are_remarks(tmp_path):
    path = tmp_path / "x.txt"
    path.write_text("0.5\t1.0\ta\n\\\t100.0\t2000.0\n1.2\t1.2\tcough here\n1,5\t2,0\tSCH\n2.0\t2.5\t\n\n")
    assert heard(read_labels(path)) == [(0.5, 1.0, Phoneme.A), (1.5, 2.0, Phoneme.SCH)]


def test_what_no_label_covers_is_silence_and_not_certain(tmp_path):
    path = tmp_path / "x.txt"
    path.write_text("0.02\t0.03\ta\n0.04\t0.05\tm\n")
    frames = frame_labels_of(read_labels(path))
    assert frames.phonemes.tolist() == [0, 0, Phoneme.A, 0, Phoneme.M]
    assert frames.certain.tolist() == [False, False, True, False, True]


@given(st.lists(phonemes, min_size=1, max_size=60))
def test_labels_of_frames_say_at_each_frame_what_was_recognised(codes):
    labels = labels_of(np.array(codes, np.uint8))
    assert frame_labels_of(labels).phonemes.tolist() == codes
    assert all(a.end == b.start and a.phoneme != b.phoneme for a, b in pairwise(labels))
    assert labels[-1].end == pytest.approx(0.01 * len(codes))


def test_the_last_label_ends_with_the_sound():
    labels = labels_of(np.array([Phoneme.A, Phoneme.M, Phoneme.M], np.uint8), 0.0255)
    assert heard(labels) == [(0, 0.01, Phoneme.A), (0.01, 0.0255, Phoneme.M)]


def test_the_corpus_reads_as_its_scorer_reads_it(corpus):
    path = corpus / "espeak_de" / "de" / "de_00.csv"
    rows = [line.split(",") for line in path.read_text(encoding="utf-8").splitlines()[1:]]
    times = np.arange(0.005, float(rows[-1][1]), 0.01)
    expected = np.zeros(len(times), np.uint8)
    for start, end, _, name, _ in rows:
        expected[(times >= float(start)) & (times < float(end))] = Phoneme[name.upper()]
    assert np.array_equal(frame_labels_of(read_labels(path)).phonemes, expected)
