"""The formants of what is seen: measured once somebody looks, and those of the whole file."""

from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.desktop.session.seen_tracks import MOST_SECONDS, FormantTrack
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.formants import formants_of
from tests.desktop.hands import wav
from tests.sounds import vowel

SOUND = np.concatenate([vowel(f, 2.0, f0=110) for f in ((700.0, 1200.0, 2500.0), (300.0, 2200.0, 3000.0))])


@pytest.fixture
def track(qtbot, tmp_path: Path):
    path = wav(tmp_path, SOUND)
    track = FormantTrack()
    track.open(lambda: SoundReader(path), 4.0)
    yield track
    track.close()


def test_what_is_seen_is_measured_as_in_the_whole_file(track, qtbot):
    seen = TimeSpan(1.5, 2.5)
    with qtbot.waitSignal(track.changed):
        assert track.formants_in(seen) is None
    first, found = track.formants_in(seen)
    whole = formants_of(SOUND).frequencies[first : first + len(found)]
    assert first <= 150
    assert first + len(found) >= 250
    np.testing.assert_allclose(found[5:-5, :2], whole[5:-5, :2], rtol=0.02)


def test_what_is_beside_is_measured_ahead_and_further_on_when_it_is_seen(track, qtbot):
    with qtbot.waitSignal(track.changed):
        track.formants_in(TimeSpan(1.0, 2.0))
    known = track.formants_in(TimeSpan(1.4, 2.4))
    assert known is track.formants_in(TimeSpan(0.6, 1.6))
    with qtbot.waitSignal(track.changed):
        track.formants_in(TimeSpan(3.0, 4.0))
    assert track.formants_in(TimeSpan(3.0, 4.0)).first > known.first


def test_another_file_begins_anew(track, qtbot):
    with qtbot.waitSignal(track.changed):
        track.formants_in(TimeSpan(1.0, 2.0))
    assert track.formants_in(TimeSpan(1.0, 2.0)) is not None
    track.leave()
    assert track.formants_in(TimeSpan(1.0, 2.0)) is None


def test_in_a_long_view_there_are_none(track):
    assert track.formants_in(TimeSpan(0.0, MOST_SECONDS + 1)) is None
    assert track.formants_in(TimeSpan(0.0, 0.0)) is None


def test_a_file_that_vanished_is_said(track, qtbot, tmp_path):
    (tmp_path / "sound.wav").unlink()
    with qtbot.waitSignal(track.error) as said:
        track.formants_in(TimeSpan(0.0, 1.0))
    assert "sound.wav" in said.args[0]
