"""The waveform of what is seen, where the analysis of the whole file has not come yet."""

from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.desktop.session.seen_tracks import WaveformTrack
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.waveform_peaks import WaveformPeaks
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.hands import wav
from tests.sounds import tone

SOUND = tone(100.0, 60.0, 0.5) * np.linspace(0.1, 1.0, 60 * SAMPLE_RATE, dtype=np.float32)


@pytest.fixture
def track(qtbot, tmp_path: Path):
    path = wav(tmp_path, SOUND)
    track = WaveformTrack()
    track.open(lambda: SoundReader(path), 60.0)
    yield track
    track.close()


def read(n: int) -> WaveformPeaks:
    """The outline as far as the analysis has read the sound."""
    peaks = WaveformPeaks()
    peaks.push(SOUND[:n])
    return peaks


def test_where_one_looks_the_waveform_is_there_before_the_analysis_has_come_so_far(track, qtbot):
    seen = TimeSpan(40.0, 50.0)
    with qtbot.waitSignal(track.changed):
        assert np.isnan(track.outline_in(seen, read(0), 100).high).all()
    whole = read(len(SOUND)).between(40.0 * SAMPLE_RATE, 50.0 * SAMPLE_RATE, 100)
    found = track.outline_in(seen, read(5 * SAMPLE_RATE), 100)
    np.testing.assert_allclose(found.high, whole.high, atol=0.01)
    np.testing.assert_allclose(found.low, whole.low, atol=0.01)
    assert not track.busy


def test_what_is_known_is_not_read_again_and_what_is_beside_is_there_at_once(track, qtbot):
    track.outline_in(TimeSpan(0.0, 15.0), read(len(SOUND)), 100)
    assert not track.busy
    with qtbot.waitSignal(track.changed):
        track.outline_in(TimeSpan(20.0, 35.0), read(0), 100)
    assert not np.isnan(track.outline_in(TimeSpan(25.0, 40.0), read(0), 100).high).any()
    assert not track.busy


def test_a_longer_view_is_shown_as_it_is_read_and_of_no_file_nothing_is_read(track, qtbot, tmp_path):
    (tmp_path / "long").mkdir()
    path = wav(tmp_path / "long", np.tile(SOUND, 11))
    track.open(lambda: SoundReader(path), 660.0)
    seen = TimeSpan(0.0, 660.0)
    track.outline_in(seen, read(0), 100)  # starts reading
    qtbot.waitUntil(lambda: np.isfinite(track.outline_in(seen, read(0), 100).high[0]))
    qtbot.waitUntil(lambda: not track.busy)
    found = track.outline_in(seen, read(0), 660)
    whole = WaveformPeaks()
    whole.push(np.tile(SOUND, 11))
    np.testing.assert_allclose(found.high, whole.between(0, 660 * SAMPLE_RATE, 660).high, atol=0.01)
    assert not track.busy
    track.leave()
    track.outline_in(TimeSpan(0.0, 10.0), read(0), 100)
    assert not track.busy


def test_each_sample_of_a_short_view_is_known_and_where_the_wave_crosses_zero(track, qtbot):
    seen = TimeSpan(30.0, 30.5)
    with qtbot.waitSignal(track.changed):
        assert track.samples_in(seen) is None
    first, samples = track.samples_in(seen)
    assert first == 30 * SAMPLE_RATE
    np.testing.assert_allclose(samples, SOUND[first : first + len(samples)], atol=1e-3)
    assert track.crossing_near(seen, 30.203, 0.01) == pytest.approx(30.205, abs=1e-4)  # of 100 Hz, every 5 ms
    assert track.crossing_near(seen, 30.203, 0.001) is None
    assert track.samples_in(TimeSpan(20.0, 40.0)) is None
