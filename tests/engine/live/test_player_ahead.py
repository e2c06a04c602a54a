"""A player whose recogniser hears half a second ahead: reading is ahead of playing, and nothing comes late."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings
from tests.engine.live.test_player import check_times
from tests.fakes.players import N_FRAMES, SPEECH, Rig, agree, frames_of, offline
from tests.models import centred_model

MODEL = centred_model(dilations=(1, 2, 4, 8, 16, 16, 4))
LEARNED = Preset(recogniser="learned", model=MODEL, settings=AnalysisSettings(statistics=False))


@pytest.fixture
def ahead(path: Path) -> Iterator[Rig]:
    rig = Rig(path, LEARNED)
    yield rig
    rig.player.close()


def test_what_is_heard_is_the_file_and_every_frame_comes_once(ahead: Rig, path: Path) -> None:
    ahead.player.play()
    taken = ahead.hear_all()
    assert frames_of(taken) == list(range(N_FRAMES))
    agree(taken, offline(path, LEARNED))
    np.testing.assert_array_equal(np.concatenate(ahead.output.played)[:, 0], SPEECH)


def test_no_frame_comes_before_its_middle_is_heard_nor_two_steps_late(ahead: Rig) -> None:
    check_times(ahead)


@pytest.mark.parametrize("frame", [1, N_FRAMES - 1])
def test_frames_after_a_seek_are_those_of_the_whole_file(frame: int, ahead: Rig, path: Path) -> None:
    ahead.player.play()
    ahead.hear(10)
    ahead.player.seek(frame * FRAME_PERIOD)
    ahead.settle()
    assert ahead.player.position == pytest.approx(frame * FRAME_PERIOD)
    taken = ahead.hear_all()
    assert frames_of(taken) == list(range(frame, N_FRAMES))
    agree(taken, offline(path, LEARNED), frame)


def test_a_loop_goes_on_from_the_first_frame(ahead: Rig) -> None:
    ahead.player.loop = True
    ahead.player.play()
    taken = ahead.hear(2 * N_FRAMES + 30)
    assert frames_of(taken)[: 2 * N_FRAMES + 20] == [*range(N_FRAMES), *range(N_FRAMES), *range(20)]


@pytest.mark.parametrize(("first", "then"), [(Preset(), LEARNED), (LEARNED, Preset())])
def test_another_model_loses_no_frame_and_no_sound(first: Preset, then: Preset, path: Path) -> None:
    rig = Rig(path, first)
    rig.player.play()
    before = frames_of(rig.hear(20))
    rig.player.set_preset(then)
    after = frames_of(rig.hear_all())
    played = np.concatenate(rig.output.played)[:, 0]
    rig.player.close()
    assert before + after == list(range(N_FRAMES))
    np.testing.assert_array_equal(played, SPEECH)
