"""The sound in hand: opening it, and what is known of it."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import soundfile
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.features.variables import Variable
from phonemeengine.settings import SAMPLE_RATE, Filter
from tests.bad_files import BAD_FILES, HOSTILE
from tests.desktop.sessions import DURATION, N_FRAMES, frames, settled
from tests.fakes.outputs import Outputs
from tests.sounds import tone


def test_without_a_file_nothing_happens(session: Session, model: PresetModel, tmp_path: Path) -> None:
    for act in (session.play, session.pause, session.toggle, session.stop, session.clear, session.close):
        act()
    session.seek(3)
    session.analyse_until(3)
    model.set_filter(Filter.MEL, True)
    assert not session.poll()
    assert not session.source.playing
    assert (session.path, session.source.duration, session.source.position) == (None, 0, 0)
    assert (session.source.name, session.source.description, session.source.player) == (
        "No file",
        "open one with Ctrl+O",
        None,
    )
    assert session.results.explain() is None


def test_an_opened_file_stands_at_its_beginning(session: Session, sound: Path, qtbot: QtBot) -> None:
    with qtbot.waitSignals([session.opened, session.transport_changed, session.cleared]):
        assert session.open(sound)
    assert session.path == sound
    assert session.source.duration == pytest.approx(DURATION)
    assert (session.source.position, session.source.playing, session.history.n) == (0, False, 0)
    assert session.source.description == "44 100 Hz, mono"
    assert session.source.player.output_name == "moved by hand"


def test_another_file_lets_the_first_one_go(
    session: Session, sound: Path, stereo: Path, outputs: Outputs, play: Callable[[float], None]
) -> None:
    session.open(sound)
    play(0.3)
    session.open(stereo)
    assert outputs.opened[0].closed
    assert (session.path, session.source.position, session.source.playing) == (stereo, 0, False)
    assert (session.history.n, session.averages.n_frames) == (0, 0)
    assert "stereo" in session.source.description


def test_a_sound_that_is_left_leaves_nothing(
    session: Session, sound: Path, outputs: Outputs, play: Callable[[float], None]
) -> None:
    session.open(sound)
    play(0.3)
    session.leave_sound()
    assert outputs.last.closed
    assert (session.path, session.source.name, session.source.player) == (None, "No file", None)
    assert (session.source.playing, session.source.position, session.history.n) == (False, 0, 0)
    assert (session.whole.tracks, session.view.duration, session.labels.duration) == (None, 0, 0)
    session.set_source(SourceKind.TONE)
    session.set_source(SourceKind.FILE)
    assert (session.path, session.source.player) == (None, None)


def test_a_file_that_has_gone_meanwhile_is_said_to_be_and_nothing_plays(session: Session, sound: Path) -> None:
    said: list[str] = []
    session.error.connect(said.append)
    session.open(sound)
    session.set_source(SourceKind.TONE)
    sound.unlink()
    session.set_source(SourceKind.FILE)
    session.play()
    (sentence,) = said
    assert sentence.startswith("speech.wav: ")
    assert (session.path, session.source.player, session.source.playing) == (sound, None, False)


@pytest.mark.parametrize("name", [n for n in BAD_FILES if n not in HOSTILE])
def test_a_bad_file_leaves_the_present_one_in_hand(
    name: str, session: Session, sound: Path, outputs: Outputs, play: Callable[[float], None], tmp_path: Path
) -> None:
    (tmp_path / "bad").mkdir()
    bad = BAD_FILES[name](tmp_path / "bad")
    said: list[str] = []
    session.error.connect(said.append)
    session.open(sound)
    play(0.2)
    before = (session.source.position, session.history.n)
    if session.open(bad):  # what is wrong shows when it is played
        play(10)
        assert (session.path, session.source.position, session.source.playing) == (bad, 0, False)
    else:
        assert (session.path, session.source.playing, session.history.n) == (sound, True, before[1])
        assert len(outputs.opened) == 1
        play(0.1)
        assert session.history.n > before[1]
    (sentence,) = said
    assert sentence.startswith(f"{bad.name}: ".replace("\n", "?"))


def test_clearing_forgets_what_was_gathered_and_goes_on(
    session: Session, sound: Path, play: Callable[[float], None], qtbot: QtBot
) -> None:
    session.open(sound)
    play(0.3)
    with qtbot.waitSignal(session.cleared):
        session.clear()
    assert (session.history.n, session.averages.n_frames) == (0, 0)
    assert session.history.extremes("energy") is None
    assert session.source.playing
    play(10)
    assert frames(session)[0] in {29, 30}
    assert frames(session)[-1] == N_FRAMES - 1


def test_the_newest_frame_is_explained(session: Session, sound: Path) -> None:
    session.open(sound)
    session.analyse_until(0.3)
    trace = session.results.explain()
    assert trace is not None
    assert trace.phoneme == session.history.recognised[session.history.n - 1]
    assert trace.comparisons


def test_an_edit_while_it_plays_acts_on_what_comes(
    session: Session, model: PresetModel, sound: Path, play: Callable[[float], None], outputs: Outputs, qtbot: QtBot
) -> None:
    session.open(sound)
    outputs.last.ahead = SAMPLE_RATE // 5
    play(0.2)
    for name in ("silence_zero_crossings", "silence_energy", "silence_max_energy", "silence_szsch1"):
        model.tune(name, 1e6)
    settled(session, qtbot)
    play(10)
    late = session.history.recognised[np.arange(45, N_FRAMES)]
    assert not late.any()
    assert session.history.recognised[np.arange(10, 20)].any()


def test_a_new_variable_is_measured_while_it_plays(
    session: Session, model: PresetModel, sound: Path, play: Callable[[float], None], outputs: Outputs
) -> None:
    session.open(sound)
    outputs.last.ahead = SAMPLE_RATE // 5
    play(0.1)
    model.add_variable(Variable("mine", 100, 5000))
    session.seek(0.2)
    play(0.3)
    assert "mine" in session.history.names
    extremes = session.history.extremes("mine")
    assert extremes is not None
    assert extremes[0] > 0


def test_a_file_that_breaks_stops_and_says_so_once(
    session: Session, play: Callable[[float], None], tmp_path: Path
) -> None:
    said: list[str] = []
    session.error.connect(said.append)
    session.open(BAD_FILES["not_a_number"](tmp_path))
    play(10)
    assert (session.source.playing, session.source.position) == (False, 0)
    for _ in range(5):
        session.poll()
    assert len(said) == 1
    assert "NaN" in said[0]


def test_a_lost_sound_card_is_replaced_by_the_clock(
    session: Session, sound: Path, outputs: Outputs, play: Callable[[float], None], qtbot: QtBot
) -> None:
    session.open(sound)
    play(0.2)
    assert session.source.player.has_card
    outputs.alive = False  # else the player would find the card again on a slow machine
    outputs.last.lost = True

    def done() -> bool:
        session.poll()
        return not session.source.playing

    qtbot.waitUntil(done)
    assert not session.source.player.has_card
    assert sorted(set(frames(session))) == list(range(N_FRAMES))


def test_a_change_while_nothing_plays_shows_in_what_was_heard_last(
    session: Session, model: PresetModel, sound: Path, qtbot: QtBot
) -> None:
    session.open(sound)
    session.analyse_until(0.5)
    frames_before = session.history.frames[:50].copy()
    rewritten: list[int] = []
    session.rewritten.connect(rewritten.append)
    for name in ("silence_zero_crossings", "silence_energy", "silence_max_energy", "silence_szsch1"):
        model.tune(name, 1e6)
    assert rewritten == []  # nothing is analysed in the window's thread
    qtbot.waitUntil(lambda: not session.history.phonemes[:50].any())
    assert rewritten == [0] * 2  # for the first of them, and for all that came meanwhile
    assert session.history.n == 50
    np.testing.assert_array_equal(session.history.frames[:50], frames_before)
    trace = session.results.explain()
    assert trace is not None
    assert trace.rule == "silence"


def test_analysing_again_with_the_same_preset_changes_nothing(session: Session, sound: Path, qtbot: QtBot) -> None:
    session.open(sound)
    session.analyse_until(0.6)
    phonemes, samples = session.history.phonemes[:60].copy(), session.history.samples[:60].copy()
    with qtbot.waitSignal(session.rewritten):
        session.results.analyse_again(sound, session.channel)
    np.testing.assert_array_equal(session.history.phonemes[:60], phonemes)
    np.testing.assert_allclose(session.history.samples[:60], samples, atol=1e-6)


def test_a_place_sought_while_nothing_plays_shows_the_seconds_before_it(session: Session, sound: Path) -> None:
    session.open(sound)
    session.seek(0.5)
    assert frames(session) == list(range(50))
    session.seek(0.2)
    assert frames(session) == list(range(20))
    assert session.averages.n_frames == 0


def test_what_was_heard_stays_before_a_place_that_is_sought(session: Session, sound: Path) -> None:
    session.open(sound)
    session.analyse_until(0.4)
    before = {name: session.history.extremes(name) for name in session.history.names}
    phonemes = session.history.phonemes[:40].copy()
    for seconds, first in ((0.7, 0), (0.2, 0), (0.0, 0)):
        session.seek(seconds)
        assert frames(session) == [*range(40), *range(first, round(100 * seconds))]
        np.testing.assert_array_equal(session.history.phonemes[:40], phonemes)
        assert {name: session.history.extremes(name) for name in session.history.names} == before


def test_the_extremes_are_those_since_clear_though_the_preset_changes_in_a_pause(
    session: Session, model: PresetModel, tmp_path: Path
) -> None:
    loud_first = np.concatenate((tone(1000, 1.0, 0.8), tone(1000, 12.0, 0.1)))
    soundfile.write(tmp_path / "long.wav", loud_first, SAMPLE_RATE, subtype="FLOAT")
    session.open(tmp_path / "long.wav")
    session.analyse_until(13.0)
    before = session.history.extremes("volume")
    assert before is not None
    assert before[0] == pytest.approx(0.8, abs=0.01)
    model.tune("silence_energy", 0.5)
    assert session.history.extremes("volume") == pytest.approx(before)
    model.set_setting("high_pass_end", 400.0)
    assert session.history.extremes("volume") == pytest.approx(before)
    assert session.history.n_measured("volume") == session.history.n
    session.clear()
    assert session.history.extremes("volume") is None


def test_the_sound_card_is_let_go_before_the_next_file_takes_it(
    session: Session, sound: Path, stereo: Path, outputs: Outputs
) -> None:
    session.open(sound)
    first = outputs.last
    seen: list[bool] = []
    session.playback.open_device = lambda n: (seen.append(first.closed), outputs(n))[1]
    session.open(stereo)
    assert seen == [True]
