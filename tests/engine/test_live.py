"""The player: what is heard is what is analysed, once, in order, and never too early."""

import threading
import time
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import soundfile

from engine import live
from engine.analyser import Analysis, analyses_of
from engine.audio.files import SoundReader
from engine.audio.stream import ClockOutput
from engine.errors import AudioError
from engine.live import FilePlayer, Heard
from engine.presets.preset import Preset
from engine.recognition.phoneme_data import Thresholds
from engine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, AnalysisSettings, Channel
from tests.bad_files import BAD_FILES, ODD_FILES
from tests.outputs import HandDrivenOutput
from tests.sounds import noise, silence, tone, vowel

PRESET = Preset(settings=AnalysisSettings(time_smooth=0.4, frequency_smooth=0.3))
SPEECH = np.concatenate(
    (
        silence(0.1),
        vowel((700, 1200, 2500), 0.3),
        noise(0.2, 0.2),
        vowel((310, 800, 2300), 0.25, f0=210),
        tone(900, 0.1533, 0.8),
        vowel((280, 2200, 3000), 0.3),
    )
)
N_FRAMES = -(-len(SPEECH) // HOP)
PATIENCE = 20.0


def wait_for(truth: Callable[[], bool], what: str) -> None:
    """Wait until the analysis thread has done its part."""
    end = time.monotonic() + PATIENCE
    while not truth():
        assert time.monotonic() < end, f"waited in vain for {what}"
        time.sleep(0.001)


class Rig:
    """A player on outputs that the test moves."""

    def __init__(self, path: Path, preset: Preset = PRESET, **options: Channel) -> None:
        self.outputs: list[HandDrivenOutput] = []
        self.player = FilePlayer(path, preset, open_device=self._open, **options)

    def _open(self, n_channels: int) -> HandDrivenOutput:
        self.outputs.append(HandDrivenOutput(n_channels))
        return self.outputs[-1]

    @property
    def output(self) -> HandDrivenOutput:
        return self.outputs[-1]

    def settle(self) -> None:
        """Wait until the thread has followed all commands and written as much as it may."""
        player = self.player
        player._wake.set()

        def settled() -> bool:
            held = not player.playing or player._at_end or self.output.room < live.STEP
            return player._error is not None or (not player._commands and player._target is None and held)

        wait_for(settled, "the analysis thread")

    def hear(self, n_frames: int) -> list[Heard]:
        """Have some frames' time pass bit by bit; checks that nothing comes before it is heard."""
        taken: list[Heard] = []
        for _ in range(n_frames):
            self.settle()
            self.output.move(HOP)
            taken += self.player.take()
        return taken

    def hear_all(self, most: int = 10 * N_FRAMES) -> list[Heard]:
        """Play to the end."""
        taken: list[Heard] = []
        while not self.player.finished and most:
            taken += self.hear(1)
            most -= 1
        return taken


@pytest.fixture
def path(tmp_path: Path) -> Path:
    soundfile.write(tmp_path / "speech.wav", SPEECH, SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "speech.wav"


@pytest.fixture
def rig(path: Path) -> Iterator[Rig]:
    rig = Rig(path)
    yield rig
    rig.player.close()


def offline(path: Path, preset: Preset = PRESET, channel: Channel = Channel.MIX) -> Analysis:
    """The analysis of the whole file, as one block."""
    with SoundReader(path, channel) as reader:
        return joined(list(analyses_of(reader.blocks(10_000), preset, pitch=True)))


def joined(analyses: list[Analysis]) -> Analysis:
    return replace(
        analyses[0],
        spectra=np.concatenate([a.spectra for a in analyses]),
        features=replace(analyses[0].features, values=np.concatenate([a.features.values for a in analyses])),
        recognised=np.concatenate([a.recognised for a in analyses]),
        phonemes=np.concatenate([a.phonemes for a in analyses]),
        intensities=np.concatenate([a.intensities for a in analyses]),
    )


def frames_of(taken: list[Heard]) -> list[int]:
    return [k for heard in taken for k in range(heard.first_frame, heard.first_frame + len(heard.analysis))]


def agree(taken: list[Heard], whole: Analysis, first: int = 0) -> None:
    """The frames that were handed out are those of the whole file, from `first` to its end."""
    found = joined([heard.analysis for heard in taken])
    expected = whole.part(slice(first, first + len(found)))
    np.testing.assert_array_equal(found.phonemes, expected.phonemes)
    np.testing.assert_array_equal(found.recognised, expected.recognised)
    np.testing.assert_allclose(found.features.values, expected.features.values, rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(found.spectra, expected.spectra, rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(found.intensities, expected.intensities, rtol=1e-3, atol=1e-4)


# -- playing --------------------------------------------------------------------------------------------------


def test_playing_hands_out_every_frame_once_and_in_order_as_the_whole_file_gives_them(rig: Rig, path: Path) -> None:
    rig.player.play()
    taken = rig.hear_all()
    assert frames_of(taken) == list(range(N_FRAMES))
    agree(taken, offline(path))
    assert rig.player.n_dropped == 0


def test_no_frame_comes_before_its_middle_is_heard_nor_two_steps_late(rig: Rig) -> None:
    rig.player.play()
    end = False
    while not end:
        rig.settle()
        rig.output.move(100)
        end = rig.output.heard >= len(SPEECH)
        for heard in rig.player.take():
            middles = (np.array(frames_of([heard])) + 0.5) * HOP
            assert middles[-1] - 1 <= rig.output.heard or end
            assert rig.output.heard - middles[0] <= live.STEP + 100


def test_what_is_heard_is_the_file(rig: Rig) -> None:
    rig.player.play()
    rig.hear_all()
    np.testing.assert_array_equal(np.concatenate(rig.output.played)[:, 0], SPEECH)


def test_a_player_on_the_clock_gives_every_frame_too(path: Path) -> None:
    player = FilePlayer(path, PRESET, open_device=lambda _n: ClockOutput())
    assert not player.has_card
    start = time.monotonic()
    player.play()
    taken: list[Heard] = []

    def done() -> bool:
        taken.extend(player.take())
        return player.finished

    wait_for(done, "the end")
    assert time.monotonic() - start >= len(SPEECH) / SAMPLE_RATE - 0.01
    player.close()
    assert frames_of(taken) == list(range(N_FRAMES))
    agree(taken, offline(path))


@pytest.mark.parametrize("channel", Channel)
def test_one_channel_is_analysed_and_both_are_heard(channel: Channel, tmp_path: Path) -> None:
    path = tmp_path / "stereo.wav"
    soundfile.write(path, np.stack((SPEECH, SPEECH[::-1] / 2), axis=1), SAMPLE_RATE, subtype="FLOAT")
    rig = Rig(path, channel=channel)
    rig.player.play()
    taken = rig.hear_all()
    rig.player.close()
    assert rig.output.n_channels == 2
    np.testing.assert_allclose(np.concatenate(rig.output.played)[:, 1], SPEECH[::-1] / 2)
    agree(taken, offline(path, channel=channel))


@pytest.mark.parametrize("name", ODD_FILES)
def test_an_unusual_file_is_played_to_its_end(name: str, tmp_path: Path) -> None:
    path = ODD_FILES[name](tmp_path)
    rig = Rig(path)
    rig.player.play()
    taken = rig.hear_all()
    assert rig.player.finished
    rig.player.close()
    assert frames_of(taken) == list(range(len(offline(path))))


def test_a_player_stands_still_until_it_is_told_to_play(rig: Rig) -> None:
    time.sleep(0.05)
    assert not rig.player.playing
    assert not rig.output.running
    assert (rig.player.take(), rig.player.position, rig.output.n_written) == ([], 0.0, 0)
    assert not rig.player.finished


def test_the_position_is_what_is_heard(rig: Rig) -> None:
    rig.player.play()
    rig.settle()
    rig.output.move(5000)
    assert rig.player.position == pytest.approx(5000 / SAMPLE_RATE)


def test_the_loudness_changes_what_is_heard_and_not_what_is_found(rig: Rig, path: Path) -> None:
    rig.player.set_gain(0.25)
    rig.player.play()
    taken = rig.hear_all()
    assert rig.output.gain == 0.25
    agree(taken, offline(path))


# -- pausing --------------------------------------------------------------------------------------------------


def test_a_pause_holds_everything(rig: Rig) -> None:
    rig.player.play()
    before = frames_of(rig.hear(20))
    rig.player.pause()
    rig.settle()
    written, position = rig.output.n_written, rig.player.position
    time.sleep(0.06)
    assert not rig.output.running
    assert not rig.player.finished
    assert (rig.output.n_written, rig.player.position, rig.player.take()) == (written, position, [])
    rig.player.play()
    after = frames_of(rig.hear_all())
    assert before + after == list(range(N_FRAMES))


# -- seeking --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("frame", [1, 3, 39, 40, 41, 70, 101, N_FRAMES - 1])
@pytest.mark.parametrize("playing", [True, False])
def test_frames_after_a_seek_are_those_of_the_whole_file(frame: int, playing: bool, rig: Rig, path: Path) -> None:
    if playing:
        rig.player.play()
        rig.hear(10)
    rig.player.seek(frame * FRAME_PERIOD)
    assert rig.player.position == pytest.approx(frame * FRAME_PERIOD)
    rig.settle()
    assert rig.player.position == pytest.approx(frame * FRAME_PERIOD)
    rig.player.play()
    taken = rig.hear_all()
    assert frames_of(taken) == list(range(frame, N_FRAMES))
    agree(taken, offline(path), frame)


@pytest.mark.parametrize("frame", range(0, N_FRAMES, 7))
def test_a_seek_to_the_beginning_of_a_frame_goes_to_that_frame(frame: int, rig: Rig) -> None:
    rig.player.seek(frame * FRAME_PERIOD)
    rig.settle()
    assert round(rig.player.position / FRAME_PERIOD, 6) == frame


def test_a_seek_back_plays_the_same_again(rig: Rig, path: Path) -> None:
    rig.player.play()
    first = rig.hear(60)
    rig.player.seek(0)
    rig.settle()
    again = rig.hear_all()
    assert frames_of(first) == list(range(len(frames_of(first))))
    assert frames_of(again) == list(range(N_FRAMES))
    agree(again, offline(path))


def test_many_seeks_in_a_row_end_at_the_last_one(rig: Rig, path: Path) -> None:
    rig.player.play()
    rig.hear(5)
    for frame in [*range(0, N_FRAMES, 3), 50]:
        rig.player.seek(frame * FRAME_PERIOD)
    rig.settle()
    taken = rig.hear_all()
    assert frames_of(taken) == list(range(50, N_FRAMES))
    agree(taken, offline(path), 50)


@pytest.mark.parametrize(("seconds", "position"), [(-5.0, 0.0), (1e9, (N_FRAMES - 1) * FRAME_PERIOD)])
def test_a_seek_beyond_an_end_goes_to_that_end(seconds: float, position: float, rig: Rig) -> None:
    rig.player.seek(seconds)
    rig.settle()
    assert rig.player.position == pytest.approx(position)


def test_a_seek_in_the_last_moment_is_not_the_end(rig: Rig, monkeypatch: pytest.MonkeyPatch) -> None:
    rig.player.play()
    while not rig.player._at_end:
        rig.hear(1)
    slow, go_on = rig.player.reader.seek, threading.Event()

    def seek_slowly(sample: int) -> None:
        go_on.wait(PATIENCE)
        slow(sample)

    monkeypatch.setattr(rig.player.reader, "seek", seek_slowly)
    rig.player.seek(0.2)
    wait_for(lambda: not rig.player._commands, "the seek's beginning")
    rig.output.move(1e9)
    rig.player.take()
    assert not rig.player.finished
    go_on.set()
    rig.settle()
    assert frames_of(rig.hear_all()) == list(range(20, N_FRAMES))


# -- the end --------------------------------------------------------------------------------------------------


def test_a_loop_goes_on_from_the_first_frame(rig: Rig, path: Path) -> None:
    rig.player.loop = True
    rig.player.play()
    taken = rig.hear(2 * N_FRAMES + 30)
    assert frames_of(taken)[: 2 * N_FRAMES + 20] == [*range(N_FRAMES), *range(N_FRAMES), *range(20)]
    assert not rig.player.finished
    second = taken[next(k for k, heard in enumerate(taken) if k and heard.first_frame == 0) :]
    agree(second[: N_FRAMES // 2], offline(path))
    assert rig.player.position == pytest.approx((rig.output.heard - 2 * len(SPEECH)) / SAMPLE_RATE)
    rig.player.loop = False
    rig.hear_all()
    assert rig.player.finished


def test_after_the_end_it_can_be_played_again(rig: Rig) -> None:
    rig.player.play()
    rig.hear_all()
    assert rig.player.position == pytest.approx(len(SPEECH) / SAMPLE_RATE)
    rig.player.pause()
    rig.player.seek(0)
    rig.settle()
    assert not rig.player.finished
    rig.player.play()
    assert frames_of(rig.hear_all()) == list(range(N_FRAMES))


# -- another preset -------------------------------------------------------------------------------------------


def test_another_preset_acts_on_the_next_block(rig: Rig) -> None:
    everything_is_silence = Thresholds(
        silence_zero_crossings=1e9, silence_energy=1e9, silence_max_energy=1e9, silence_szsch1=1e9
    )
    rig.player.play()
    rig.hear(40)
    rig.settle()
    analysed = rig.player._analyser.n_frames
    rig.player.use(replace(PRESET, thresholds=everything_is_silence))
    taken = rig.hear_all()
    codes = dict(zip(frames_of(taken), joined([h.analysis for h in taken]).recognised.tolist(), strict=True))
    assert not any(codes[k] for k in range(analysed, N_FRAMES))
    assert any(codes[k] for k in codes if k < analysed)


def test_another_front_end_acts_on_the_next_block(rig: Rig) -> None:
    rig.player.play()
    rig.hear(10)
    rig.player.use(replace(PRESET, settings=AnalysisSettings(filters=frozenset())))
    taken = rig.hear_all()
    assert [heard.analysis.spectra.shape[1] for heard in taken][-1] == 1024
    assert frames_of(taken)[-1] == N_FRAMES - 1


def test_another_preset_is_kept_over_a_seek(rig: Rig, path: Path) -> None:
    other = Preset(settings=AnalysisSettings(quantise=2))
    rig.player.use(other)
    rig.player.seek(0.3)
    rig.settle()
    rig.player.play()
    agree(rig.hear_all(), offline(path, other), 30)


# -- what goes wrong ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["not_a_number", "truncated_flac"])
def test_a_file_that_breaks_in_the_middle_raises_where_it_is_taken(name: str, tmp_path: Path) -> None:
    rig = Rig(BAD_FILES[name](tmp_path))
    rig.player.play()
    with pytest.raises(AudioError, match=r" \d\.\d{3} s"):
        rig.hear(1000)
    assert rig.player.take() == [] or not rig.player.finished
    rig.player.seek(0)
    rig.settle()
    assert frames_of(rig.hear(5))[:3] == [0, 1, 2]
    rig.player.close()


def test_a_seek_into_damage_raises_and_the_beginning_still_plays(tmp_path: Path) -> None:
    rig = Rig(BAD_FILES["not_a_number"](tmp_path))
    rig.player.seek(0.9)
    wait_for(lambda: rig.player._error is not None, "the error")
    with pytest.raises(AudioError, match="not_a_number"):
        rig.player.take()
    rig.player.seek(0)
    rig.player.play()
    rig.settle()
    assert frames_of(rig.hear(5))[:3] == [0, 1, 2]
    rig.player.close()


def test_a_bug_in_the_analysis_is_raised_where_it_is_taken(rig: Rig, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_samples: object) -> None:
        raise ZeroDivisionError("a bug")

    monkeypatch.setattr(rig.player._analyser, "push", fail)
    rig.player.play()
    wait_for(lambda: rig.player._error is not None, "the error")
    with pytest.raises(ZeroDivisionError):
        rig.player.take()


@pytest.mark.parametrize("name", ["not_a_sound", "missing", "empty", "list_that_hangs"])
def test_a_bad_file_opens_no_device_and_leaves_no_thread(name: str, tmp_path: Path) -> None:
    before = threading.active_count()
    opened: list[int] = []

    def open_device(n_channels: int) -> HandDrivenOutput:
        opened.append(n_channels)
        return HandDrivenOutput(n_channels)

    with pytest.raises(AudioError):
        FilePlayer(BAD_FILES[name](tmp_path), PRESET, open_device=open_device)
    assert threading.active_count() == before
    assert not opened


def test_a_lost_device_goes_on_on_the_clock_from_the_same_place(rig: Rig, path: Path) -> None:
    rig.player.play()
    before = frames_of(rig.hear(33))
    position = rig.player.position
    rig.output.lost = True
    after = rig.player.take()
    wait_for(lambda: not rig.player.has_card, "the clock")
    wait_for(lambda: rig.output.closed, "the end of the device")
    assert position - FRAME_PERIOD <= rig.player.position < position + 0.5
    assert "no sound card" in rig.player.output_name
    assert rig.player.playing

    def done() -> bool:
        after.extend(rig.player.take())
        return rig.player.finished

    wait_for(done, "the end")
    first = after[0].first_frame
    assert abs(first - before[-1]) <= 2
    assert frames_of(after) == list(range(first, N_FRAMES))
    agree(after, offline(path), first)


def test_a_device_lost_in_a_pause_stays_paused_on_the_clock(rig: Rig) -> None:
    rig.player.play()
    rig.hear(33)
    rig.player.pause()
    rig.output.lost = True
    position = rig.player.position
    rig.player.take()
    wait_for(lambda: not rig.player.has_card, "the clock")
    wait_for(lambda: not rig.player._commands, "the thread")
    time.sleep(0.03)
    assert position - FRAME_PERIOD <= rig.player.position <= position
    assert rig.player.take() == []


def test_frames_that_nobody_takes_are_dropped_and_counted(rig: Rig, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(live, "MOST_WAITING", 5)
    rig.output.ahead = 10 * len(SPEECH)
    rig.player.play()
    rig.settle()
    rig.output.move(1e9)
    taken = frames_of(rig.player.take())
    assert rig.player.n_dropped == N_FRAMES - len(taken) > 0
    assert taken == list(range(N_FRAMES - len(taken), N_FRAMES))


def test_closing_ends_the_thread_and_lets_file_and_device_go(path: Path) -> None:
    before = set(threading.enumerate())
    for state in ("standing", "playing", "paused", "seeking", "ended"):
        rig = Rig(path)
        if state != "standing":
            rig.player.play()
        if state == "paused":
            rig.player.pause()
        if state == "seeking":
            rig.player.seek(1.0)
        if state == "ended":
            rig.hear_all()
        start = time.monotonic()
        rig.player.close()
        assert time.monotonic() - start < 2, state
        assert rig.output.closed, state
        assert rig.player.reader._raw.closed, state
    assert set(threading.enumerate()) == before


class SlowDeque(deque[Any]):
    """Lets the other thread have its turn between looking and taking."""

    def __getitem__(self, k: Any) -> Any:
        time.sleep(0.001)
        return super().__getitem__(k)


def test_a_seek_between_looking_and_taking_trips_nobody(rig: Rig) -> None:
    rig.player._waiting = SlowDeque()
    rig.player.play()
    for _ in range(30):
        rig.settle()
        rig.output.move(1e9)
        rig.player.seek(0)
        rig.player.take()
