"""Frames: 2048 samples around sample 441k + 220, however the sound comes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.dsp.framing import LEAD, Framer, frame_count
from phonemeengine.settings import HOP, WINDOW
from tests.sounds import Sound, noise


def frames_by_definition(sound: Sound) -> Sound:
    """Cut the frames as the convention says: window k is centred on sample 441k + 220, silence around the sound."""
    padded = np.concatenate((np.zeros(WINDOW), sound, np.zeros(WINDOW)))
    starts = [WINDOW + HOP * k + HOP // 2 - WINDOW // 2 for k in range(-(-len(sound) // HOP))]
    return np.array([padded[s : s + WINDOW] for s in starts], np.float32).reshape(-1, WINDOW)


def framed(blocks: list[Sound]) -> Sound:
    framer = Framer()
    parts = [framer.cut_frames(block) for block in blocks]
    return np.concatenate([*parts, framer.finish()])


@pytest.mark.parametrize(
    ("n_samples", "n_frames"), [(0, 0), (1, 1), (441, 1), (442, 2), (882, 2), (44_100, 100), (44_101, 101)]
)
def test_every_begun_hop_of_a_sound_has_a_frame(n_samples: int, n_frames: int):
    assert frame_count(n_samples) == n_frames
    assert len(framed([np.ones(n_samples, np.float32)])) == n_frames


@pytest.mark.parametrize("n_samples", [1, 220, 441, 1243, 1244, 1245, 2048, 5000])
def test_a_frame_is_centred_on_the_middle_of_its_ten_milliseconds(n_samples: int):
    sound = noise(n_samples / 44_100)
    np.testing.assert_array_equal(framed([sound]), frames_by_definition(sound))


@given(cuts=st.lists(st.integers(0, 4000), max_size=12))
def test_frames_are_the_same_for_any_cutting(cuts: list[int]):
    sound = noise(4000 / 44_100)
    np.testing.assert_array_equal(framed(np.split(sound, sorted(cuts))), frames_by_definition(sound))


def test_a_frame_comes_out_as_soon_as_its_last_sample_is_in():
    framer = Framer()
    first_complete = WINDOW - LEAD
    assert len(framer.cut_frames(np.zeros(first_complete - 1, np.float32))) == 0
    assert len(framer.cut_frames(np.zeros(1, np.float32))) == 1
    assert len(framer.cut_frames(np.zeros(HOP - 1, np.float32))) == 0
    assert len(framer.cut_frames(np.zeros(1, np.float32))) == 1


def test_finishing_twice_gives_no_second_end():
    framer = Framer()
    framer.cut_frames(np.zeros(1000, np.float32))
    assert len(framer.finish()) == 3
    assert len(framer.finish()) == 0


def test_frames_cannot_be_written_to():
    frames = framed([noise(0.1)])
    frames[0, 0] = 1  # a copy may
    with pytest.raises(ValueError, match="read-only"):
        Framer().cut_frames(noise(0.1))[0, 0] = 1


def test_samples_of_double_precision_are_taken_as_numbers_not_as_bytes():
    sound = noise(0.1)
    np.testing.assert_array_equal(framed([sound.astype(np.float64)]), frames_by_definition(sound))
