"""The labels of the file in hand: taken from beside it, edited, undone, saved, and compared with what is heard."""

import shutil

import pytest
from PySide6.QtGui import QUndoStack

from phonemeanalyser.desktop.session.label_tiers import Boundary, ChosenLabel, LabelTiers
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.inspection.whole_sound import SoundTracks
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.tiers import read_tiers, write_tiers
from phonemeengine.labels.utterance import RawLabel
from phonemeengine.phonemes import Phoneme
from tests.desktop.hands import CARDS

M_A = Tier("phones", (RawLabel(0.1, 0.3, "m", ""), RawLabel(0.3, 0.6, "a", "")))
WORDS = Tier("words", (RawLabel(0.1, 0.6, "Mama", ""),))


def names(labels):
    return [raw.name for raw in labels.tiers[0].raw_labels]


@pytest.fixture
def sound(tmp_path):
    path = tmp_path / "cards.flac"
    shutil.copy(CARDS, path)
    return path


@pytest.fixture
def stack(qapp):
    return QUndoStack()


@pytest.fixture
def labels(stack, sound):
    write_tiers([M_A, WORDS], sound.with_suffix(".TextGrid"), duration=2.0)
    found = LabelTiers(stack)
    found.follow(sound, 2.0)
    return found


def test_labels_beside_a_sound_are_there_with_the_tier_that_names_phonemes(labels, sound):
    assert labels.path == sound.with_suffix(".TextGrid")
    assert [tier.name for tier in labels.tiers] == ["phones", "words"]
    assert labels.state.shown == (0, 1)
    assert labels.state.said == 0
    assert not labels.has_unsaved_changes
    labels.follow(sound.with_name("other.wav"), 1.0)
    assert (labels.path, labels.tiers) == (None, ())


def test_edits_are_undone_one_by_one_and_a_drag_at_once(labels, stack):
    labels.begin_move(Boundary(ChosenLabel(0, 0), is_end=True))
    for seconds in (0.35, 0.4, 0.42):
        labels.move(seconds)
    labels.rename(ChosenLabel(0, 1), "o")
    labels.insert(0, 0.7, 0.8, "s")
    labels.delete(ChosenLabel(0, 0))
    assert names(labels) == ["o", "s"]
    assert stack.count() == 4
    assert labels.has_unsaved_changes
    for _ in range(3):
        stack.undo()
    assert [(raw.start, raw.end) for raw in labels.tiers[0].raw_labels] == [(0.1, 0.42), (0.42, 0.6)]
    stack.undo()
    assert labels.tiers[0] == read_tiers(labels.path)[0]
    assert not labels.has_unsaved_changes
    stack.redo()
    assert labels.tiers[0].raw_labels[0].end == 0.42


def test_boundaries_at_one_time_move_together_as_far_as_all_can_unless_one_moves_alone(labels, stack):
    end_of_a = Boundary(ChosenLabel(0, 1), is_end=True)
    labels.begin_move(end_of_a)
    labels.move(0.7)
    assert [labels.tiers[k].raw_labels[-1].end for k in (0, 1)] == [0.7, 0.7]
    labels.move(0.2)  # a begins at 0.3, and lasts 5 ms at least
    assert [labels.tiers[k].raw_labels[-1].end for k in (0, 1)] == pytest.approx([0.305, 0.305])
    labels.begin_move(end_of_a, alone=True)
    labels.move(0.5)
    assert [labels.tiers[k].raw_labels[-1].end for k in (0, 1)] == pytest.approx([0.5, 0.305])
    stack.undo()
    stack.undo()
    assert not labels.has_unsaved_changes


def test_a_label_is_split_at_a_time_and_merged_with_its_neighbour(labels, stack, qtbot):
    labels.split(0.4)
    assert [(raw.start, raw.end, raw.name) for raw in labels.tiers[0].raw_labels[1:]] == [
        (0.3, 0.4, "a"),
        (0.4, 0.6, "a"),
    ]
    assert labels.chosen == ChosenLabel(0, 2)
    labels.rename(labels.chosen, "o")
    labels.merge(ChosenLabel(0, 2), back=True)
    assert [(raw.start, raw.end, raw.name) for raw in labels.tiers[0].raw_labels] == [
        (0.1, 0.3, "m"),
        (0.3, 0.6, "o"),
    ]
    assert labels.chosen == ChosenLabel(0, 1)
    before = labels.state
    for refused in (lambda: labels.merge(ChosenLabel(0, 1)), lambda: labels.split(0.302), lambda: labels.split(1.0)):
        with qtbot.waitSignal(labels.error):
            refused()
    assert labels.state == before
    for _ in range(3):
        stack.undo()
    assert not labels.has_unsaved_changes


def test_labels_and_tiers_are_chosen_by_steps(labels):
    assert labels.tier_in_use == 0
    assert labels.choose_beside(0.2, 1) == ChosenLabel(0, 0)
    assert labels.choose_beside(0.2, 1) == ChosenLabel(0, 1)
    assert labels.choose_beside(0.2, 1) == ChosenLabel(0, 1)
    assert labels.choose_tier(0.2, 1) == ChosenLabel(1, 0)
    labels.choose(None)
    assert labels.tier_in_use == 1
    assert labels.choose_tier(0.2, -1) == ChosenLabel(0, 0)
    labels.choose(None)
    assert labels.choose_beside(1.0, -1) == ChosenLabel(0, 1)
    assert labels.choose_beside(1.0, -1) == ChosenLabel(0, 0)


def test_a_label_begins_and_ends_where_it_is_said_to(labels):
    labels.choose(ChosenLabel(0, 1))
    labels.set_edge(0.35, end=False)
    labels.set_edge(0.8, end=True)
    assert [(raw.start, raw.end) for raw in labels.tiers[0].raw_labels] == [(0.1, 0.35), (0.35, 0.8)]
    assert labels.tiers[1].raw_labels[0].end == 0.8
    assert labels.chosen == ChosenLabel(0, 1)


def test_a_label_is_asked_for_only_where_there_is_room(labels, qtbot):
    assert labels.has_room(labels.gap_at(1.0))
    assert labels.gap_at(1.0) == (0.6, 2.0)
    with qtbot.waitSignal(labels.error):
        assert not labels.has_room(TimeSpan(0.2, 0.9))
    with qtbot.waitSignal(labels.error):
        assert not labels.has_room(labels.gap_at(0.2))


def test_edits_of_another_sound_are_not_undone(labels, stack, sound):
    labels.delete(ChosenLabel(0, 0))
    labels.follow(sound.with_name("other.wav"), 1.0)
    stack.undo()
    assert labels.tiers == ()


def test_the_first_label_makes_a_tier(qapp):
    stack = QUndoStack()
    labels = LabelTiers(stack)
    labels.follow(None, 2.0)
    labels.insert(None, 0.5, 0.9, "a")
    assert (labels.tiers[0].name, labels.state.said, labels.state.shown) == ("phonemes", 0, (0,))
    stack.undo()
    assert labels.tiers == ()


def test_saving_keeps_all_tiers(labels, tmp_path):
    labels.rename(ChosenLabel(0, 0), "p")
    told = []
    labels.info.connect(told.append)
    assert labels.save(tmp_path / "new.TextGrid")
    assert "new.TextGrid" in told[0]
    assert not labels.has_unsaved_changes
    assert [t.name for t in read_tiers(tmp_path / "new.TextGrid")] == ["phones", "words"]


def test_what_cannot_be_used_is_one_sentence_and_changes_nothing(labels, sound, tmp_path, qtbot):
    before = labels.state
    bad = tmp_path / "bad.txt"
    bad.write_text("0.0\t0.5\ta\n0.4\t0.6\to\n")
    with qtbot.waitSignal(labels.error) as told:
        assert not labels.load(bad)
    assert "must not overlap" in told.args[0]
    with qtbot.waitSignal(labels.error):
        assert not labels.save(tmp_path / "no such folder" / "x.csv")
    with qtbot.waitSignal(labels.error):
        labels.insert(0, 0.2, 0.4, "x")
    with qtbot.waitSignal(labels.error):
        labels.rename(ChosenLabel(0, 0), " ")
    assert labels.state == before
    sound.with_suffix(".TextGrid").write_text("File type = nonsense")
    with qtbot.waitSignal(labels.error):
        labels.follow(sound, 2.0)
    assert labels.tiers == ()


def test_said_and_recognised_are_compared(session, qtbot, sound):
    sound.with_suffix(".txt").write_text("0.00\t0.50\to\n0.50\t1.00\tword\n")
    session.open(sound)
    qtbot.waitUntil(lambda: not session.whole.busy)
    tracks, labels = session.whole.tracks, session.labels
    heard = tracks.phonemes[:50]
    wrong = labels.errors(tracks)
    assert all(e.said is Phoneme.O and e.end <= 0.5 for e in wrong)
    assert sum(round(100 * (e.end - e.start)) for e in wrong) <= int((heard != Phoneme.O).sum())
    assert wrong
    assert labels.next_error(tracks, -1.0) == wrong[0]
    assert labels.next_error(tracks, wrong[0].start) == (wrong[1] if len(wrong) > 1 else None)
    assert labels.next_error(tracks, 9.0, back=True) == wrong[-1]
    assert labels.next_error(tracks, 0.0, back=True) is None
    labels.show((0,), None)
    assert labels.errors(tracks) == []


def test_what_is_not_recognised_yet_is_no_error(labels, sound):
    labels.follow(sound, 2.0)
    assert labels.said_frames() is not None
    assert labels.errors(SoundTracks(200)) == []


def test_what_is_in_doubt_is_known_of_tables_and_of_names(labels, sound, tmp_path):
    table = tmp_path / "x.csv"
    table.write_text("start_s,end_s,phone,class,certainty\n0.1,0.2,ɛ,e,ambiguous\n0.2,0.3,ʃ,sch,core\n")
    assert labels.load(table)
    assert [tier.name for tier in labels.tiers] == ["phones", "classes"]
    assert labels.state.said == 1
    assert labels.doubts(1) == {0: "ambiguous"}
    assert labels.doubts(0) == {}
    write_tiers(
        [Tier("phones", (RawLabel(0.1, 0.3, "aɪ", ""), RawLabel(0.3, 0.4, "m", "")))], tmp_path / "y.TextGrid"
    )
    assert labels.load(tmp_path / "y.TextGrid")
    assert labels.doubts(0) == {0: "diphthong"}


def test_a_format_that_loses_something_takes_a_copy_and_says_what(labels, sound, tmp_path):
    labels.rename(ChosenLabel(0, 0), "p")
    told = []
    labels.info.connect(told.append)
    assert labels.lost_in(tmp_path / "x.txt") == ("words",)
    assert labels.save(tmp_path / "x.txt")
    assert "without words" in told[-1]
    assert labels.has_unsaved_changes
    assert labels.path == sound.with_suffix(".TextGrid")
    assert [raw.name for raw in read_tiers(tmp_path / "x.txt")[0].raw_labels] == ["p", "a"]
