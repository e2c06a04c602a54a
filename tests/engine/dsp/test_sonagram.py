"""The sonagram for eyes: levels, places and axes against tones, and what lies beyond the sound."""

import numpy as np
import pytest

from phonemeengine.dsp.mel import mel_of
from phonemeengine.dsp.sonagram import FLOOR, FrequencyAxis, SonagramSettings, row_frequencies, sonagram_of
from phonemeengine.errors import SettingsError
from phonemeengine.settings import SAMPLE_RATE
from tests.sounds import noise, silence, tone

COLUMN = 0.01 * SAMPLE_RATE


@pytest.mark.parametrize("axis", FrequencyAxis)
@pytest.mark.parametrize("frequency", [300.0, 1000.0, 5000.0])
def test_a_tone_of_full_scale_is_0_db_at_its_row(axis: FrequencyAxis, frequency: float):
    settings = SonagramSettings(0.03, axis, n_rows=400)
    levels = sonagram_of(tone(frequency, 0.5, 1.0), settings, 0, 50, COLUMN)[25]
    row = int(levels.argmax())
    assert settings.frequencies[row] == pytest.approx(frequency, abs=SAMPLE_RATE / settings.n_samples)
    assert levels[row] == pytest.approx(0, abs=2.5)  # between bins, and in wide rows, a little less
    far = np.abs(settings.frequencies - frequency) > 500
    assert levels[far].max() < -60


def test_half_the_amplitude_is_6_db_less():
    settings = SonagramSettings()
    loud, soft = (sonagram_of(tone(1000, 0.3, a), settings, 0, 30, COLUMN)[15].max() for a in (0.8, 0.4))
    assert loud - soft == pytest.approx(6.02, abs=0.01)


def test_a_column_lies_where_its_sound_is():
    sound = np.concatenate((silence(0.5), tone(1000, 0.1, 0.5), silence(0.4)))
    levels = sonagram_of(sound, SonagramSettings(0.01), 0, 100, COLUMN).max(axis=1)
    assert set(np.flatnonzero(levels > -20)) == set(range(50, 60))


def test_a_wide_column_loses_no_click():
    sound = silence(60.0)
    sound[round(33.337 * SAMPLE_RATE)] = 1.0
    levels = sonagram_of(sound, SonagramSettings(), 0, 60, SAMPLE_RATE).max(axis=1)
    assert levels.argmax() == 33
    assert (np.delete(levels, 33) == FLOOR).all()


def test_a_part_is_the_part_of_the_whole():
    sound, settings = noise(2.0, 0.1), SonagramSettings()
    whole = sonagram_of(sound, settings, 0, 200, COLUMN)
    np.testing.assert_allclose(sonagram_of(sound, settings, 50 * COLUMN, 20, COLUMN), whole[50:70], atol=1e-4)


def test_before_and_after_the_sound_there_is_silence():
    levels = sonagram_of(noise(0.2, 0.1), SonagramSettings(), -SAMPLE_RATE, 300, COLUMN)
    assert (levels[:90] == FLOOR).all()
    assert (levels[130:] == FLOOR).all()
    assert (levels[103:117] > -80).all()
    assert (sonagram_of(silence(0.0), SonagramSettings(), 0, 3, COLUMN) == FLOOR).all()


def test_rows_are_equally_far_apart_on_their_axis():
    rows = {axis: row_frequencies(axis, 100, 0, 8000) for axis in FrequencyAxis}
    assert np.diff(rows[FrequencyAxis.LINEAR]) == pytest.approx(8000 / 99)
    assert np.ptp(np.diff(mel_of(rows[FrequencyAxis.MEL]))) < 1e-6
    assert np.ptp(np.diff(np.log(rows[FrequencyAxis.LOGARITHMIC]))) < 1e-6
    assert rows[FrequencyAxis.LOGARITHMIC][0] == 20
    assert all(found[-1] == pytest.approx(8000) for found in rows.values())


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ({"window": 0.001}, "the window must lie in 0.002..0.2 s, got 0.001"),
        ({"low": 8000.0}, "must rise within 0..22050 Hz, got 8000 to 8000"),
        ({"high": 30_000.0}, "must rise within"),
        ({"n_rows": 1}, "the number of rows must lie in 2..4096, got 1"),
    ],
)
def test_what_no_sonagram_has_is_refused(fault: dict[str, float], words: str):
    with pytest.raises(SettingsError, match=words):
        SonagramSettings(**fault)
