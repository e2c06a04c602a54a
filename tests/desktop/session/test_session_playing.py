"""Playing the sound in hand: every frame once, from wherever one goes."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.results import GAP
from phonemeanalyser.desktop.session.session import Session
from phonemeengine.audio.output import ClockOutput
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, Channel
from tests.desktop.sessions import DURATION, N_FRAMES, frames, settled
from tests.fakes.outputs import Outputs


def test_playing_gathers_every_frame_once_and_stops_at_the_end(
    session: Session, sound: Path, play: Callable[[float], None], qtbot: QtBot
) -> None:
    session.open(sound)
    with qtbot.waitSignal(session.transport_changed):
        play(10)
    assert frames(session) == list(range(N_FRAMES))
    assert session.averages.n_frames == N_FRAMES
    assert not session.source.playing
    assert session.source.position == 0


@pytest.mark.parametrize("seconds", [0.0, 0.1, 0.405, 0.6, DURATION])
def test_following_gives_what_playing_gives(
    seconds: float, session: Session, model: PresetModel, sound: Path, play: Callable[[float], None]
) -> None:
    session.open(sound)
    play(seconds)
    other = Session(model, Outputs())
    other.open(sound)
    other.analyse_until(seconds)
    n = other.history.n
    assert abs(n - session.history.n) <= 1  # frames come in pairs while it plays
    assert (n == N_FRAMES) == (seconds == DURATION)
    one, two = session.history, other.history
    both = np.arange(min(n, one.n))
    np.testing.assert_array_equal(one.frames[both], two.frames[both])
    np.testing.assert_array_equal(one.phonemes[both], two.phonemes[both])
    np.testing.assert_allclose(one.samples[both], two.samples[both], atol=2e-3)
    np.testing.assert_allclose(one.features(both).values, two.features(both).values, rtol=1e-3, atol=1e-4)
    assert other.source.position == pytest.approx(seconds, abs=FRAME_PERIOD)
    assert other.averages.n_frames == n
    other.close()


def test_following_never_goes_beyond_the_end(session: Session, sound: Path) -> None:
    session.open(sound)
    session.analyse_until(1e6)
    assert frames(session) == list(range(N_FRAMES))


def test_on_the_clock_it_plays_in_real_time(model: PresetModel, sound: Path, qtbot: QtBot) -> None:
    session = Session(model, lambda _n: ClockOutput())
    session.open(sound)
    session.play()

    def done() -> bool:
        session.poll()
        return not session.source.playing

    qtbot.waitUntil(done)
    assert frames(session) == list(range(N_FRAMES))
    assert "No audio device" in session.source.player.output_name
    assert session.source.player.n_dropped == 0
    session.close()


def test_play_pause_and_toggle(session: Session, sound: Path, qtbot: QtBot) -> None:
    session.open(sound)
    acts = (session.play, session.pause, session.toggle, session.toggle)
    for act, playing in zip(acts, (True, False, True, False), strict=True):
        with qtbot.waitSignal(session.transport_changed):
            act()
        assert session.source.playing is playing


def test_a_pause_keeps_the_place(session: Session, sound: Path, play: Callable[[float], None]) -> None:
    session.open(sound)
    play(0.3)
    session.pause()
    assert session.source.position == pytest.approx(0.3, abs=0.001)
    play(10)
    assert frames(session) == list(range(N_FRAMES))


def test_stopping_goes_to_the_beginning(
    session: Session, sound: Path, play: Callable[[float], None], qtbot: QtBot
) -> None:
    session.open(sound)
    play(0.3)
    n = session.history.n
    with qtbot.waitSignal(session.transport_changed):
        session.stop()
    assert (session.source.playing, session.source.position) == (False, 0)
    settled(session, qtbot)
    assert session.source.position == 0
    assert session.history.n == n  # what was seen stays to be looked at
    play(0.1)
    assert frames(session)[n] == 0


def test_the_average_begins_anew_with_the_sound_and_goes_on_after_a_pause(
    session: Session, sound: Path, play: Callable[[float], None], qtbot: QtBot
) -> None:
    session.open(sound)
    play(0.3)
    session.pause()
    n = session.averages.n_frames
    play(0.2)
    assert session.averages.n_frames > n
    assert session.averages.since == "Play at 0.00 s of speech.wav"
    session.stop()
    settled(session, qtbot)
    play(0.1)
    assert session.averages.n_frames <= 10
    session.clear()
    assert session.averages.since == ""
    play(0.1)
    assert session.averages.since.startswith("Clear at 0.1")


def test_a_loop_goes_round(session: Session, sound: Path, play: Callable[[float], None], outputs: Outputs) -> None:
    session.open(sound)
    session.playback.set_loop(True)
    outputs.last.ahead = SAMPLE_RATE // 4
    session.play()
    while session.history.n < N_FRAMES + GAP + 40:
        outputs.last.move(400)
        session.poll()
    assert frames(session)[: N_FRAMES + 40] == [*range(N_FRAMES), *range(40)]
    assert session.source.position < DURATION
    assert session.source.playing


def test_the_loop_is_kept_for_the_next_file(session: Session, sound: Path, stereo: Path) -> None:
    session.playback.set_loop(True)
    session.open(sound)
    session.open(stereo)
    assert session.playback.loop
    assert session.source.player is not None
    assert session.source.player.loop


@pytest.mark.parametrize(("seconds", "position"), [(0.4, 0.4), (-1.0, 0.0), (1e9, DURATION)])
def test_a_seek_goes_there_at_once(
    seconds: float, position: float, session: Session, sound: Path, qtbot: QtBot
) -> None:
    session.open(sound)
    with qtbot.waitSignal(session.transport_changed):
        session.seek(seconds)
    assert session.source.position == pytest.approx(position, abs=FRAME_PERIOD)
    settled(session, qtbot)
    assert session.source.position == pytest.approx(position, abs=FRAME_PERIOD)


def test_after_a_seek_the_frames_are_those_from_there(
    session: Session, sound: Path, play: Callable[[float], None], qtbot: QtBot
) -> None:
    session.open(sound)
    play(0.2)
    n = session.history.n
    session.seek(0.5)
    settled(session, qtbot)
    play(10)
    assert frames(session)[n:] == list(range(50, N_FRAMES))


@pytest.mark.parametrize(
    ("asked", "kept", "gain"),
    [(0, 0, 1.0), (-6, -6, 0.5012), (-20, -20, 0.1), (-60, -60, 0.0), (-90, -60, 0.0), (12, 0, 1.0)],
)
def test_the_volume_stays_within_its_limits(
    asked: float, kept: float, gain: float, session: Session, sound: Path, outputs: Outputs, qtbot: QtBot
) -> None:
    session.open(sound)
    with qtbot.waitSignal(session.transport_changed):
        session.playback.set_volume(asked)
    assert session.playback.volume == kept
    assert outputs.last.gain == pytest.approx(gain, abs=1e-4)
    session.open(sound)
    assert outputs.last.gain == pytest.approx(gain, abs=1e-4)


def test_another_channel_is_analysed_from_the_same_place(
    session: Session, stereo: Path, play: Callable[[float], None], qtbot: QtBot
) -> None:
    session.open(stereo)
    play(0.3)
    session.set_channel(Channel.RIGHT)
    assert session.source.playing
    assert session.source.position == pytest.approx(0.3, abs=2 * FRAME_PERIOD)
    settled(session, qtbot)
    play(0.2)
    assert set(session.history.phonemes[session.history.indices(0, 100)].tolist()) == {Phoneme.SILENCE}
    assert frames(session) == list(range(len(frames(session))))
    assert session.channel is Channel.RIGHT


def test_a_paused_sound_stays_paused_when_its_channel_changes(session: Session, stereo: Path, qtbot: QtBot) -> None:
    session.open(stereo)
    session.seek(0.4)
    settled(session, qtbot)
    session.set_channel(Channel.LEFT)
    assert not session.source.playing
    assert session.source.position == pytest.approx(0.4)


def test_if_the_file_has_gone_the_channel_stays_as_it_was(session: Session, stereo: Path, qtbot: QtBot) -> None:
    session.open(stereo)
    stereo.unlink()
    with qtbot.waitSignals([session.error, session.transport_changed]):
        session.set_channel(Channel.LEFT)
    assert session.channel is Channel.MIX
    assert session.path == stereo


def test_the_channel_can_be_chosen_before_there_is_a_file(session: Session, stereo: Path, qtbot: QtBot) -> None:
    with qtbot.waitSignal(session.transport_changed):
        session.set_channel(Channel.RIGHT)
    session.open(stereo)
    session.analyse_until(0.5)
    assert not session.history.phonemes[session.history.indices(0, 100)].any()
