"""The player: what is heard is what is analysed, once, in order, and never too early."""

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analysis
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.output import ClockOutput
from phonemeengine.live import player as live
from phonemeengine.live.player import Player
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Thresholds
from phonemeengine.settings import HOP, SAMPLE_RATE, AnalysisSettings, Channel
from tests.bad_files import ODD_FILES
from tests.fakes.players import N_FRAMES, PRESET, SPEECH, Rig, agree, frames_of, joined, offline
from tests.waiting import wait_for


def test_playing_hands_out_every_frame_once_and_in_order_as_the_whole_file_gives_them(rig: Rig, path: Path) -> None:
    rig.player.play()
    taken = rig.hear_all()
    assert frames_of(taken) == list(range(N_FRAMES))
    agree(taken, offline(path))
    assert rig.player.n_dropped == 0
    np.testing.assert_array_equal(np.concatenate(rig.output.played)[:, 0], SPEECH)


def test_no_frame_comes_before_its_middle_is_heard_nor_two_steps_late(rig: Rig) -> None:
    check_times(rig)


def check_times(rig: Rig) -> None:
    """Play it to its end, and see when each frame comes."""
    rig.player.play()
    end = False
    while not end:
        rig.settle()
        rig.output.move(100)
        end = rig.output.heard >= len(SPEECH)
        for heard in rig.player.take_analyses():
            middles = (np.array(frames_of([heard])) + 0.5) * HOP
            assert middles[-1] - 1 <= rig.output.heard or end
            assert rig.output.heard - middles[0] <= live.PART * HOP + 100


def test_a_player_on_the_clock_gives_every_frame_too(path: Path) -> None:
    player = Player(SoundReader(path), PRESET, lambda _n: ClockOutput())
    assert not player.has_card
    start = time.monotonic()
    player.play()
    taken: list[Analysis] = []

    def done() -> bool:
        taken.extend(player.take_analyses())
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


@pytest.mark.parametrize("name", ["one_sample", "two_hundred_channels", "fast"])
def test_an_unusual_file_is_played_to_its_end(name: str, tmp_path: Path) -> None:
    path = ODD_FILES[name](tmp_path)
    rig = Rig(path)
    rig.player.play()
    taken = rig.hear_all()
    assert rig.player.finished
    rig.player.close()
    assert frames_of(taken) == list(range(len(offline(path))))


def test_a_player_stands_still_until_it_is_told_to_play(rig: Rig) -> None:
    rig.go_round()
    assert not rig.player.playing
    assert not rig.output.running
    assert (rig.player.take_analyses(), rig.player.position, rig.output.n_written) == ([], 0.0, 0)
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


def test_a_pause_holds_everything(rig: Rig) -> None:
    rig.player.play()
    before = frames_of(rig.hear(20))
    rig.player.pause()
    rig.settle()
    written, position = rig.output.n_written, rig.player.position
    rig.go_round()
    assert not rig.output.running
    assert not rig.player.finished
    assert (rig.output.n_written, rig.player.position, rig.player.take_analyses()) == (written, position, [])
    rig.player.play()
    after = frames_of(rig.hear_all())
    assert before + after == list(range(N_FRAMES))


def test_a_loop_goes_on_from_the_first_frame(rig: Rig, path: Path) -> None:
    rig.player.loop = True
    rig.player.play()
    taken = rig.hear(2 * N_FRAMES + 30)
    assert frames_of(taken)[: 2 * N_FRAMES + 20] == [*range(N_FRAMES), *range(N_FRAMES), *range(20)]
    assert not rig.player.finished
    second = taken[next(k for k, heard in enumerate(taken) if k and heard.start == 0) :]
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


def test_another_preset_acts_on_the_next_block(rig: Rig) -> None:
    everything_is_silence = Thresholds(
        silence_zero_crossings=1e9, silence_energy=1e9, silence_max_energy=1e9, silence_szsch1=1e9
    )
    rig.player.play()
    rig.hear(40)
    rig.settle()
    analysed = rig.player._analyser._next + live.STEP // HOP  # a block that is written may still be analysed
    rig.player.set_preset(replace(PRESET, thresholds=everything_is_silence))
    taken = rig.hear_all()
    codes = dict(zip(frames_of(taken), joined(taken).recognised.tolist(), strict=True))
    assert not any(codes[k] for k in range(analysed, N_FRAMES))
    assert any(codes[k] for k in codes if k < analysed)


def test_another_front_end_acts_on_the_next_block(rig: Rig) -> None:
    rig.player.play()
    rig.hear(10)
    rig.player.set_preset(replace(PRESET, settings=AnalysisSettings(filters=frozenset())))
    taken = rig.hear_all()
    assert [heard.spectra.shape[1] for heard in taken][-1] == 1024
    assert frames_of(taken)[-1] == N_FRAMES - 1


def test_another_preset_is_kept_over_a_seek(rig: Rig, path: Path) -> None:
    other = Preset(settings=AnalysisSettings(quantise=2))
    rig.player.set_preset(other)
    rig.player.seek(0.3)
    rig.settle()
    rig.player.play()
    agree(rig.hear_all(), offline(path, other), 30)


def test_a_sound_of_one_sample_can_be_looped(tmp_path: Path) -> None:
    rig = Rig(ODD_FILES["one_sample"](tmp_path))
    rig.player.loop = True
    rig.player.play()
    taken = rig.hear(40)
    rig.player.close()
    assert set(frames_of(taken)) == {0}
    assert 15 <= len(taken) <= 40


def test_a_stretch_ends_at_its_end_and_is_analysed_like_the_whole(rig: Rig, path: Path) -> None:
    rig.player.play_stretch(0.3, 0.6)
    assert rig.player.stretch == pytest.approx((0.3, 0.6))
    taken = rig.hear_all()
    assert frames_of(taken) == list(range(30, 60))
    np.testing.assert_array_equal(np.concatenate(rig.output.played)[:, 0], SPEECH[30 * HOP : 60 * HOP])
    assert rig.player.finished


def test_a_looped_stretch_begins_again_at_its_beginning_until_a_seek(rig: Rig) -> None:
    rig.player.loop = True
    rig.player.play_stretch(0.3, 0.4)
    taken: list[Analysis] = []
    while len(frames_of(taken)) < 35:
        rig.settle()
        rig.output.move(HOP)
        taken += rig.player.take_analyses()
    assert frames_of(taken)[:35] == [*range(30, 40)] * 3 + [*range(30, 35)]
    rig.player.loop = False
    rig.player.seek(0.9)
    assert rig.player.stretch is None
    assert frames_of(rig.hear_all())[0] == 90


def test_a_stretch_of_nothing_is_a_frame(rig: Rig) -> None:
    rig.player.play_stretch(0.3, 0.3)
    assert frames_of(rig.hear_all()) == [30]
