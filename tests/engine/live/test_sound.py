"""A sound file as a game uses it: what it says belongs to what is heard at this moment."""

import threading
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import latest_reading
from phonemeengine.errors import AudioError
from phonemeengine.live.sound import N_BINS, Sound
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import BIN_WIDTH, HOP, SAMPLE_RATE, WINDOW, Channel
from tests.bad_files import BAD_FILES
from tests.fakes.outputs import HandDrivenOutput, HandDrivenSound
from tests.fakes.players import N_FRAMES, PRESET, SPEECH, offline
from tests.sounds import silence, tone
from tests.waiting import wait_for

BIN = 40


class Game:
    """A sound on an output that is moved by hand, whose card is `ahead` samples late."""

    def __init__(self, path: Path, ahead: int = SAMPLE_RATE // 4) -> None:
        self.outputs: list[HandDrivenOutput] = []
        self.ahead = ahead
        self.sound = HandDrivenSound(self._open, path, PRESET)

    def _open(self, n_channels: int) -> HandDrivenOutput:
        self.outputs.append(HandDrivenOutput(n_channels, self.ahead))
        return self.outputs[-1]

    def settle(self) -> None:
        """Wait until as much is played as may be."""
        wait_for(self.sound.catch_up, "the analysis thread")

    def hear(self, n: int) -> None:
        """Have `n` samples be heard, a frame at a time."""
        for k in range(0, n, HOP):
            self.settle()
            self.outputs[-1].move(min(HOP, n - k))
            self.sound.poll()
        self.settle()


@pytest.fixture
def play() -> Iterator[Callable[..., Game]]:
    made: list[Game] = []

    def make(path: Path, **options: int) -> Game:
        made.append(Game(path, **options))
        return made[-1]

    yield make
    for game in made:
        game.sound.close()


@pytest.fixture
def stereo(tmp_path: Path) -> Path:
    """A sine on a bin in the left channel only, from 0.5 s to 1.5 s of 2 s."""
    sine = np.concatenate((silence(0.5), tone(BIN * BIN_WIDTH, 1.0), silence(0.5)))
    samples = np.stack([sine, np.zeros_like(sine)], axis=1)
    soundfile.write(tmp_path / "stereo.wav", samples, SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "stereo.wav"


Play = Callable[..., Game]


@pytest.mark.parametrize("ahead", [5_512, SAMPLE_RATE])
def test_a_sine_on_a_bin_reads_1_in_the_channel_where_it_is(play: Play, stereo: Path, ahead: int) -> None:
    game = play(stereo, ahead=ahead)
    game.sound.play()
    game.hear(SAMPLE_RATE // 4)
    assert not game.sound.spectrum().any()  # it has not been heard yet, though it is read already
    game.hear(SAMPLE_RATE * 3 // 4)
    left, right, both = (game.sound.spectrum(channel) for channel in (Channel.LEFT, Channel.RIGHT, Channel.MIX))
    assert left.shape == (N_BINS,)
    assert (left.argmax(), left[BIN]) == (BIN, pytest.approx(1.0, abs=1e-3))
    assert not left[: BIN - 3].round(3).any()
    assert not left[BIN + 4 :].round(3).any()
    assert not right.any()
    np.testing.assert_allclose(both, left / 2, atol=1e-6)


def test_the_analysis_buffer_is_the_file_around_what_is_heard(play: Play, path: Path) -> None:
    game = play(path)
    padded = np.concatenate((np.zeros(WINDOW // 2), SPEECH, np.zeros(WINDOW)))
    game.sound.play()
    at = 0
    for step in (100, 900, 20_000, 10_001):
        game.hear(step)
        at += step
        assert round(game.sound.position * SAMPLE_RATE) == at
        np.testing.assert_array_equal(game.sound.analysis_buffer(), padded[at : at + WINDOW])
    np.testing.assert_array_equal(game.sound.analysis_buffer(Channel.RIGHT), game.sound.analysis_buffer())


def test_the_poll_is_the_files_own_analysis_at_what_is_heard(play: Play, path: Path) -> None:
    game, whole = play(path), offline(path)
    assert game.sound.poll() == (Phoneme.SILENCE, 0, 0)
    game.sound.play()
    heard = set()
    for frame in range(N_FRAMES - 3):
        game.hear(HOP)
        if frame == 0:
            continue  # its middle is not heard yet
        phoneme, intensity, confidence = game.sound.poll()
        k = [
            j
            for j in (frame - 1, frame)
            if whole.phonemes[j] == phoneme
            and abs(whole.intensities[j] - intensity) < 1e-3
            and latest_reading(whole.part(slice(j, j + 1))).confidence == confidence
        ]
        assert k, frame  # the newest of the two frames of a block
        heard.add(phoneme)
    assert len(heard) > 2


def test_after_the_end_there_is_silence_and_the_place_is_the_end(play: Play, tmp_path: Path) -> None:
    soundfile.write(tmp_path / "a.wav", tone(700, 0.5, 0.5), SAMPLE_RATE)
    game = play(tmp_path / "a.wav")
    game.sound.play()
    assert game.sound.playing
    game.hear(SAMPLE_RATE // 4)
    assert game.sound.poll().intensity > 0
    game.hear(SAMPLE_RATE // 4 + HOP)
    assert game.sound.poll() == (Phoneme.SILENCE, 0, 0)
    assert not game.sound.playing
    assert game.sound.position == game.sound.duration == 0.5


def test_stopping_goes_to_the_beginning_and_into_silence(play: Play, path: Path) -> None:
    game = play(path)
    game.sound.play()
    game.hear(SAMPLE_RATE // 3)
    assert game.sound.poll().intensity > 0
    game.sound.stop()
    assert game.sound.poll() == (Phoneme.SILENCE, 0, 0)
    game.settle()
    assert (game.sound.position, game.sound.playing) == (0, False)
    assert game.sound.poll() == (Phoneme.SILENCE, 0, 0)
    game.sound.play()
    game.hear(SAMPLE_RATE // 3)
    assert round(game.sound.position * SAMPLE_RATE) == SAMPLE_RATE // 3
    assert game.sound.poll().intensity > 0


def test_a_pause_keeps_the_place_and_what_is_seen_there(play: Play, path: Path) -> None:
    game = play(path)
    game.sound.play()
    game.hear(SAMPLE_RATE // 3)
    before = game.sound.poll(), game.sound.position, game.sound.spectrum().tolist()
    game.sound.pause()
    game.settle()
    assert not game.sound.playing
    assert not game.outputs[0].running
    assert (game.sound.poll(), game.sound.position, game.sound.spectrum().tolist()) == before
    game.sound.play()
    game.hear(HOP)
    assert game.sound.position == pytest.approx(before[1] + 0.01)


def test_a_loop_begins_again_at_its_end(play: Play, path: Path) -> None:
    game = play(path)
    game.sound.play(loop=True)
    game.hear(len(SPEECH) + 20_000)
    assert game.sound.playing
    assert round(game.sound.position * SAMPLE_RATE) == 20_000
    np.testing.assert_array_equal(game.sound.analysis_buffer(), SPEECH[20_000 - WINDOW // 2 : 20_000 + WINDOW // 2])
    played = np.concatenate(game.outputs[0].played)[:, 0]
    np.testing.assert_array_equal(played[: len(SPEECH)], SPEECH)
    np.testing.assert_array_equal(played[len(SPEECH) : len(SPEECH) + 20_000], SPEECH[:20_000])


def test_seeking_goes_there_at_once_to_a_frame_and_sees_what_is_there(play: Play, path: Path) -> None:
    game = play(path)
    game.sound.seek(0.8049)
    assert game.sound.position == pytest.approx(0.80)
    game.settle()
    game.sound.play()
    game.hear(100)
    at = 80 * HOP + 100
    assert round(game.sound.position * SAMPLE_RATE) == at
    np.testing.assert_array_equal(game.sound.analysis_buffer(), SPEECH[at - WINDOW // 2 : at + WINDOW // 2])


@pytest.mark.parametrize(
    ("decibels", "gain", "says"), [(-20, 0.1, -20), (float("-inf"), 0, float("-inf")), (6, 1, 0)]
)
def test_the_volume_is_in_decibels_and_changes_no_phoneme(
    play: Play, path: Path, decibels: float, gain: float, says: float
) -> None:
    game, whole = play(path), offline(path)
    game.sound.volume = decibels
    assert game.outputs[0].gain == pytest.approx(gain, abs=1e-3)
    assert game.sound.volume == says
    game.sound.play()
    game.hear(40 * HOP)
    assert np.abs(whole.intensities[38:40] - game.sound.poll().intensity).min() < 1e-3


def test_a_damaged_file_raises_where_the_damage_is(play: Play, tmp_path: Path) -> None:
    game = play(BAD_FILES["not_a_number"](tmp_path))
    game.sound.play()
    with pytest.raises(AudioError, match="not_a_number"):
        game.hear(10 * SAMPLE_RATE)
    game.sound.seek(0)
    game.settle()
    game.sound.poll()


def test_a_file_that_is_none_raises_at_once_and_opens_no_device(tmp_path: Path) -> None:
    def refuse(_n: int) -> HandDrivenOutput:
        raise AssertionError("no device is needed")

    with pytest.raises(AudioError, match="missing"):
        HandDrivenSound(refuse, tmp_path / "missing.wav", PRESET)


def test_a_sound_tells_its_preset(path: Path) -> None:
    with Sound(path, PRESET) as sound:
        assert sound.preset is PRESET
        other = replace(PRESET, name="other")
        sound.set_preset(other)
        assert sound.preset is other


def test_closing_lets_file_and_device_go(path: Path) -> None:
    before = set(threading.enumerate())
    game = Game(path)
    with game.sound as sound:
        sound.play()
    assert game.outputs[0].closed
    assert set(threading.enumerate()) == before
