"""The sonagram of live sound: what a file of the same sound shows, whatever the preset does to the spectra."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeanalyser.desktop.session.results import CAPACITY, GAP, History
from phonemeanalyser.desktop.session.sonagram_tiles import COLUMNS, LiveSonagram, SonagramTiles, levels_of
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.analyser import analyse_blocks
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.sonagram import NARROW_BAND, WIDE_BAND, FrequencyAxis
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE
from tests.desktop.hands import wav
from tests.sounds import noise, silence, tone

THESIS = load_preset(FACTORY / "thesis.toml")
SOUND = np.concatenate((tone(1000, 0.5, 0.5), silence(0.5), noise(0.7, 0.01), tone(3000, 0.8, 0.1)))


@pytest.fixture
def history() -> History:
    return History()


@pytest.fixture
def tiles(qtbot):
    tiles = SonagramTiles()
    yield tiles
    tiles.close()


@pytest.fixture
def live(history, tiles) -> LiveSonagram:
    return LiveSonagram(history, tiles)


def hear(history: History, sound, at_once: int = 441 * 7):
    parts = np.array_split(sound, max(1, len(sound) // at_once))
    for analysis in analyse_blocks(parts, THESIS, pitch=True):
        history.append(analysis)
        yield analysis


def joined(live: LiveSonagram, seen: TimeSpan, n_pixels: int):
    return np.concatenate([tile.levels for tile in sorted(live.tiles_for(seen, n_pixels))]).astype(np.float32)


@pytest.mark.parametrize("filtered", [False, True])
@pytest.mark.parametrize("window", [WIDE_BAND, 0.02, NARROW_BAND])
def test_it_is_the_sonagram_of_a_file_of_the_same_sound(history, tiles, live, tmp_path, window, filtered):
    tiles.use(replace(tiles.settings, window=window, axis=FrequencyAxis.MEL))
    tiles.show_filtered(THESIS.settings if filtered else None)
    for _ in hear(history, SOUND):
        live.tiles_for(TimeSpan(0, 2.5), 300)  # as it comes
    with SoundReader(wav(tmp_path, SOUND)) as reader:
        of_file = levels_of(reader, tiles.settings, tiles.filters, 0.0, 0.008, 310)
    found = joined(live, TimeSpan(0, 2.5), 300)[:310]
    assert np.isfinite(found[:312]).all()
    np.testing.assert_allclose(found[:306], of_file[:306], atol=0.6)  # WAV has 16 bits; the end is not heard yet


def test_what_was_measured_stays_and_only_what_is_new_is_measured(history, live):
    before = None
    for _ in hear(history, SOUND):
        now = joined(live, TimeSpan(0, 2.5), 1200)
        if before is not None:
            n = max(0, len(before) - COLUMNS)
            np.testing.assert_array_equal(now[:n], before[:n])
        before = now


def test_what_is_not_there_is_nan(history, live):
    for _ in hear(history, SOUND[:SAMPLE_RATE]):
        pass
    first = history.n
    for _ in hear(history, SOUND[:SAMPLE_RATE]):  # it begins again at frame 0
        pass
    found = joined(live, TimeSpan(0, history.n * FRAME_PERIOD), 10_000)
    columns = (np.arange(len(found)) * 0.001 / FRAME_PERIOD + 1e-6).astype(int)
    gone = (columns >= first) & (columns < first + GAP) | (columns >= history.n)
    np.testing.assert_array_equal(np.isnan(found).all(axis=1), gone)


def test_other_settings_measure_anew(history, tiles, live):
    for _ in hear(history, SOUND):
        pass
    before = joined(live, TimeSpan(0, 2.5), 300)
    tiles.use(replace(tiles.settings, high=4000.0))
    assert not np.array_equal(before, joined(live, TimeSpan(0, 2.5), 300))


def test_after_clear_nothing_of_the_old_sound_is_left(history, live):
    for _ in hear(history, SOUND):
        live.tiles_for(TimeSpan(0, 2.5), 300)
    history.clear()
    live.forget()
    assert live.tiles_for(TimeSpan(0, 2.5), 300) == []
    for _ in hear(history, silence(0.5)):
        pass
    assert np.nanmax(joined(live, TimeSpan(0, 0.5), 300)) == -120


def test_formants_come_with_the_sound_and_of_the_last_minute(history, tiles, live):
    assert live.formants_in(TimeSpan(0, 1), 5500.0) is None
    pulses = np.zeros(2 * SAMPLE_RATE, np.float32)
    pulses[::400] = 0.5
    for _ in hear(history, pulses):
        live.formants_in(TimeSpan(0, 2), 5500.0)
    for _ in range(5):
        found = live.formants_in(TimeSpan(0, 2), 5500.0)
    assert found.first == 0
    assert len(found.frequencies) > 190
    assert np.isfinite(found.frequencies[20:180]).any(axis=1).all()
    assert live.formants_in(TimeSpan(0, CAPACITY), 5500.0) is None
