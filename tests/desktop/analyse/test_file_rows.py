"""The rows of a file's view as arrays."""

import numpy as np
import pytest

from phonemeanalyser.desktop.analyse.lanes.file_rows import (
    columns_of,
    course_of,
    lane_pixels,
    usual_course_of,
    usual_of,
    wave_pixels,
    wide_runs,
)
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.dsp.waveform_peaks import Peaks
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme

COLOURS = np.arange(len(FrameState) * len(Phoneme), dtype=np.uint32).reshape(len(FrameState), -1)


@pytest.fixture
def tracks() -> SoundTracks:
    tracks = SoundTracks(100)
    tracks.phonemes[:] = Phoneme.A
    tracks.phonemes[50:60] = Phoneme.U
    tracks.states[:80] = FrameState.KNOWN
    tracks.states[70:80] = FrameState.OUTDATED
    return tracks


def test_each_column_has_the_frame_under_its_middle() -> None:
    assert columns_of(TimeSpan(0.0, 0.1), 10, 100).tolist() == list(range(10))
    assert columns_of(TimeSpan(-0.02, 0.03), 5, 2).tolist() == [-1, -1, 0, 1, -1]


def test_the_lane_has_the_colour_of_phoneme_and_state(tracks: SoundTracks) -> None:
    pixels = lane_pixels(tracks, TimeSpan(0.0, 1.0), 100, COLOURS)
    assert pixels[10] == COLOURS[FrameState.KNOWN, Phoneme.A]
    assert pixels[55] == COLOURS[FrameState.KNOWN, Phoneme.U]
    assert pixels[75] == COLOURS[FrameState.OUTDATED, Phoneme.A]
    assert pixels[90] == COLOURS[FrameState.UNKNOWN, Phoneme.A]


def test_only_wide_runs_that_are_known_are_named(tracks: SoundTracks) -> None:
    runs = wide_runs(tracks, TimeSpan(0.2, 1.0), 0.15)
    assert runs.starts.tolist() == [0.2]
    assert runs.ends.tolist() == [0.5]
    assert runs.codes.tolist() == [Phoneme.A]
    assert wide_runs(tracks, TimeSpan(0.0, 1.0), 0.099).codes.tolist() == [Phoneme.A, Phoneme.U, Phoneme.A, Phoneme.A]
    assert len(wide_runs(SoundTracks(0), TimeSpan(0.0, 0.0), 0.1).codes) == 0


def test_the_outline_of_a_waveform_is_painted_from_its_lowest_to_its_highest_sample() -> None:
    peaks = Peaks(np.array([-1.0, 0.0, np.nan], np.float32), np.array([1.0, 0.5, np.nan], np.float32))
    painted = wave_pixels(peaks, 1.0, 9, 7, 0) == 7
    assert painted.sum(axis=0).tolist() == [9, 3, 0]
    assert painted[4, 1]
    assert not painted[5:, 1].any()


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
    times, values = usual_course_of(pitch, 0, TimeSpan(0.0, 720.0), 500)
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
