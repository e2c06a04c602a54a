"""What is done with the selected part of a file, and what is said where nothing is selected."""

from pathlib import Path

import pytest
import soundfile

from phonemeanalyser.desktop.session.selection import NOTHING_SELECTED, Selection
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.inspection.measurement import measure
from tests.desktop.hands import CARDS


@pytest.fixture
def selection(session, qtbot):
    session.open(CARDS)
    qtbot.waitUntil(lambda: not session.whole.busy)
    selection = Selection(session)
    yield selection
    selection.close()


SPAN = TimeSpan(0.5, 1.25)


def test_it_is_measured_as_the_engine_measures_it(session, selection, qtbot):
    session.view.select(SPAN)
    with qtbot.waitSignal(selection.measured) as told:
        selection.measure()
    assert told.args[0].rows() == measure(CARDS, *SPAN, session.preset.in_force).rows()


def test_it_is_saved_and_copied(session, selection, qtbot, tmp_path):
    session.view.select(SPAN)
    with qtbot.waitSignal(selection.info):
        selection.save(tmp_path / "part.wav")
    assert soundfile.info(tmp_path / "part.wav").duration == pytest.approx(0.75, abs=1e-3)
    lines = selection.frames_as_text().splitlines()
    assert len(lines) == 1 + 75
    assert lines[1].startswith("0.505\t")
    assert {len(line.split("\t")) for line in lines} == {4 + len(session.whole.tracks.names)}


def test_a_sound_is_not_saved_under_the_name_of_another_format(session, selection, qtbot, tmp_path):
    session.view.select(SPAN)
    with qtbot.waitSignal(selection.error, check_params_cb=bool) as told:
        selection.save(tmp_path / "part.mp3")
    assert "sounds are written as .wav here, not as .mp3" in told.args[0]
    assert list(tmp_path.iterdir()) == []


def test_it_is_played_once_and_stands_at_its_beginning_then(session, selection, outputs, qtbot):
    session.view.select(SPAN)
    selection.play()

    def over() -> bool:
        outputs.last.move(4410)
        session.poll()
        return not session.source.playing

    qtbot.waitUntil(over)
    assert session.source.position == pytest.approx(0.5)


def test_it_is_looped_on_demand(session, selection, outputs, qtbot):
    session.view.select(SPAN)
    selection.play(loop=True)
    assert session.playback.loop
    heard = []
    session.analysed.connect(heard.extend)

    def heard_enough() -> bool:
        outputs.last.move(2205)
        session.poll()
        return sum(map(len, heard)) >= 100

    qtbot.waitUntil(heard_enough)
    frames = [k for block in heard for k in range(block.start, block.start + len(block))]
    assert set(frames) == set(range(50, 125))
    assert frames.count(50) == 2


@pytest.mark.parametrize("act", ["play", "zoom", "measure", "frames_as_text"])
def test_nothing_selected_is_one_sentence(session, selection, qtbot, act):
    with qtbot.waitSignal(selection.error) as told:
        getattr(selection, act)()
    assert told.args == [NOTHING_SELECTED]


def test_all_is_selected_and_seen(session, selection):
    selection.select_all()
    assert session.view.selection == TimeSpan(0.0, session.source.duration)
    session.view.select(SPAN)
    selection.zoom()
    assert session.view.seen == SPAN
    selection.show_all()
    assert session.view.seen == TimeSpan(0.0, session.source.duration)


def test_a_file_that_has_gone_is_one_sentence(session, selection, qtbot, tmp_path):
    sound = tmp_path / "gone.wav"
    sound.write_bytes(Path(CARDS).read_bytes())
    session.open(sound)
    qtbot.waitUntil(lambda: not session.whole.busy)
    session.view.select(TimeSpan(0.1, 0.4))
    sound.unlink()
    with qtbot.waitSignal(selection.error) as told:
        selection.measure()
    assert "gone.wav" in told.args[0]
