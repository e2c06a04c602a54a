"""Seeking: what follows is what would have been played there."""

import threading
from pathlib import Path

import pytest

from phonemeengine.audio.files import SoundReader
from phonemeengine.settings import FRAME_PERIOD
from tests.fakes.players import N_FRAMES, Rig, agree, frames_of, offline
from tests.waiting import PATIENCE


@pytest.mark.parametrize("frame", [1, 40, 41, N_FRAMES - 1])
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


def test_a_seek_to_the_beginning_of_a_frame_goes_to_that_frame(rig: Rig) -> None:
    for frame in range(0, N_FRAMES, 7):
        rig.player.seek(frame * FRAME_PERIOD)
        rig.settle()
        assert round(rig.player.position / FRAME_PERIOD, 6) == frame


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


class SlowReader(SoundReader):
    """Goes to a place when it may."""

    asked, may_go = threading.Event(), threading.Event()

    def seek(self, sample: int) -> None:
        self.asked.set()
        assert self.may_go.wait(PATIENCE)
        super().seek(sample)


def test_a_seek_in_the_last_moment_is_not_the_end(path: Path) -> None:
    rig = Rig(SlowReader(path))
    rig.player.play()
    while not rig.player.all_written:
        rig.hear(1)
    rig.player.seek(0.2)
    assert SlowReader.asked.wait(PATIENCE)
    rig.output.move(1e9)
    rig.player.take_analyses()
    assert not rig.player.finished
    SlowReader.may_go.set()
    rig.settle()
    assert frames_of(rig.hear_all()) == list(range(20, N_FRAMES))
