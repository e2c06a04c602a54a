"""The course of a variable in the view of a file."""

import numpy as np
import pytest

from phonemeanalyser.desktop.analyse.lanes.file_painter import course_of
from phonemeanalyser.desktop.analyse.lanes.sonagram import usual_course_of, usual_of
from phonemeanalyser.desktop.session.time_view import TimeSpan


def test_no_peak_of_a_course_is_lost_however_narrow_it_is_drawn() -> None:
    values = np.zeros(10_000, np.float32)
    values[4321] = 5.0
    times, heights = course_of(values, 0, TimeSpan(0.0, 100.0), 100)
    assert len(times) == len(heights) == 200
    assert heights.max() == 5.0
    assert times[heights.argmax()] == pytest.approx(43.2, abs=1.0)
    values[2000:3000] = np.nan
    assert np.isnan(course_of(values, 0, TimeSpan(0.0, 100.0), 100)[1]).sum() == 20


def test_a_course_seen_from_near_goes_through_every_frame() -> None:
    times, heights = course_of(np.array([1, 2, 3], np.float32), 10, TimeSpan(0.1, 0.13), 100)
    assert times.tolist() == pytest.approx([0.105, 0.115, 0.125])
    assert heights.tolist() == [1, 2, 3]


def test_far_from_near_a_course_goes_through_what_is_usual_and_has_gaps() -> None:
    """Pitch of 120 Hz with a jump of an octave in every tenth frame: its extremes would be a solid block."""
    pitch = np.full(72_000, 120.0, np.float32)
    pitch[::10] = 240.0
    pitch[36_000:54_000] = np.nan
    times, values = usual_course_of(pitch, 0, 720.0, 500)
    assert len(times) <= 500
    assert np.all(np.diff(times) > 0)
    voiced = (times < 360) | (times > 540)
    np.testing.assert_array_equal(values[voiced], 120.0)
    assert np.isnan(values[~voiced]).all()


def test_groups_of_frames_stay_the_same_while_the_view_scrolls_and_near_by_each_frame_is_one() -> None:
    values = np.arange(40, dtype=np.float32)[:, np.newaxis]
    np.testing.assert_array_equal(usual_of(values, 4, 0)[2:5], usual_of(values[8:20], 4, 8))
    np.testing.assert_array_equal(usual_of(values[6:], 1, 6), values[6:])
    assert np.isnan(usual_of(values[7:], 4, 7)[0, 0])  # one frame of four is none
