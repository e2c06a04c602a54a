"""Tiles of a file's sonagram: what is looked at is measured in the background, coarse ones serve meanwhile."""

from dataclasses import replace
from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.desktop.session import sonagram_tiles
from phonemeanalyser.desktop.session.sonagram_tiles import COLUMNS, SonagramTiles
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.sonagram import FLOOR, LEVELS, SonagramSettings, sonagram_of
from phonemeengine.settings import SAMPLE_RATE, AnalysisSettings
from tests.desktop.hands import CARDS, click, shown, wav
from tests.sounds import noise, silence, tone

SOUND = np.concatenate((tone(1000, 10.0, 0.5), silence(10.0), noise(12.0, 0.05)))
WHOLE = TimeSpan(0, 32)


@pytest.fixture
def tiles(qtbot, tmp_path: Path):
    path = wav(tmp_path, SOUND)
    tiles = SonagramTiles()
    tiles.open(lambda: SoundReader(path), 32.0)
    yield tiles
    tiles.close()


def measured(tiles: SonagramTiles, qtbot, seen: TimeSpan, n_pixels: int):
    tiles.tiles_for(seen, n_pixels)
    qtbot.waitUntil(lambda: not tiles.busy)
    return tiles.tiles_for(seen, n_pixels)


@pytest.mark.parametrize(("seen", "n_pixels"), [(WHOLE, 1000), (TimeSpan(9.5, 10.5), 800), (TimeSpan(31, 32), 3)])
def test_what_is_seen_is_covered_with_a_column_a_pixel_or_two(tiles, qtbot, seen, n_pixels):
    assert tiles.tiles_for(seen, n_pixels) == []
    found = sorted(measured(tiles, qtbot, seen, n_pixels))
    assert found[0].span.start <= seen.start
    assert found[-1].span.end >= seen.end
    for one, other in pairwise(found):
        assert one.span.end == pytest.approx(other.span.start)
    columns_per_pixel = seen.seconds / n_pixels / (found[0].span.seconds / COLUMNS)
    assert 1 <= columns_per_pixel < 2 or found[0].span.seconds == COLUMNS * sonagram_tiles.FINEST


def test_a_tile_is_the_sonagram_of_its_seconds(tiles, qtbot):
    for tile in measured(tiles, qtbot, TimeSpan(9, 12), 700):
        period = tile.span.seconds / COLUMNS * SAMPLE_RATE
        expected = sonagram_of(SOUND, tiles.settings, tile.span.start * SAMPLE_RATE, COLUMNS, period)
        np.testing.assert_allclose(tile.levels, expected, atol=0.2)


def test_a_coarser_tile_serves_until_the_finer_one_is_there(tiles, qtbot):
    (coarse,) = measured(tiles, qtbot, WHOLE, 500)
    meanwhile = tiles.tiles_for(TimeSpan(4, 5), 500)
    assert [t.span for t in meanwhile] == [coarse.span]
    fine = measured(tiles, qtbot, TimeSpan(4, 5), 500)
    assert all(t.span.seconds < 2 for t in fine)


def test_of_long_columns_excerpts_are_there_first_and_all_of_them_later(tiles, qtbot):
    with qtbot.waitSignal(tiles.changed):
        tiles.tiles_for(WHOLE, 60)
    (first,) = tiles.tiles_for(WHOLE, 60)
    middles = (np.arange(60) + 0.5) * first.span.seconds / COLUMNS
    for column in (5, 15, 25, 50):  # the tone, the silence, the noise
        expected = sonagram_of(SOUND, tiles.settings, (middles[column] - 0.04) * SAMPLE_RATE, 1, 0.08 * SAMPLE_RATE)
        np.testing.assert_allclose(first.levels[column], expected[0], atol=0.3)
    (whole,) = measured(tiles, qtbot, WHOLE, 60)
    assert whole.levels is not first.levels
    expected = sonagram_of(SOUND, tiles.settings, 0.0, 60, first.span.seconds / COLUMNS * SAMPLE_RATE)
    np.testing.assert_allclose(whole.levels[:60], expected, atol=0.3)


def test_no_picture_is_normalised_and_the_range_is_the_chosen_one(tiles, qtbot):
    measured(tiles, qtbot, TimeSpan(25, 26), 500)
    assert tiles.level_range == LEVELS
    measured(tiles, qtbot, TimeSpan(4, 5), 500)
    assert tiles.level_range == LEVELS
    tiles.show_levels(-70.0, 0.0)
    assert tiles.level_range == (-70.0, 0.0)


def test_other_settings_and_another_file_begin_anew(tiles, qtbot, tmp_path):
    measured(tiles, qtbot, WHOLE, 500)
    tiles.use(replace(tiles.settings, high=4000.0))
    assert tiles.tiles_for(WHOLE, 500) == []
    assert len(measured(tiles, qtbot, WHOLE, 500)) == 1
    (tmp_path / "other").mkdir()
    path = wav(tmp_path / "other", silence(32.0))
    tiles.open(lambda: SoundReader(path), 32.0)
    assert all((t.levels == FLOOR).all() for t in measured(tiles, qtbot, WHOLE, 500))
    tiles.leave()
    assert tiles.tiles_for(WHOLE, 500) == []


def test_no_more_is_kept_than_there_is_room_for_and_what_is_seen_stays(tiles, qtbot):
    tiles.most_tiles = 2
    for second in range(4):
        measured(tiles, qtbot, TimeSpan(second, second + 0.5), 500)
    assert len(tiles._tiles) == 2
    assert tiles.tiles_for(TimeSpan(3, 3.5), 500)


def test_a_file_that_vanished_is_said(tiles, qtbot, tmp_path):
    (tmp_path / "sound.wav").unlink()
    with qtbot.waitSignal(tiles.error) as said:
        tiles.tiles_for(WHOLE, 500)
    assert "sound.wav" in said.args[0]
    assert tiles.tiles_for(WHOLE, 500) == []


def test_nothing_is_measured_of_nothing(qtbot):
    tiles = SonagramTiles()
    assert tiles.tiles_for(TimeSpan(0, 0), 500) == []
    assert tiles.tiles_for(WHOLE, 0) == []
    assert tiles.settings == SonagramSettings()


def test_a_tile_that_is_read_in_parts_is_the_same():
    measured = partial(sonagram_tiles.levels_of, start=0.0, period=0.016, n_columns=COLUMNS)
    with SoundReader(CARDS) as reader:
        whole = measured(reader, SonagramSettings(), None)
        filters = AnalysisSettings()
        seen = measured(reader, SonagramSettings(), filters)
        again = measured(reader, SonagramSettings(), None, most_read=0.5)
        np.testing.assert_allclose(again, whole, atol=0.01)
        parts = measured(reader, SonagramSettings(), filters, most_read=0.5)
    np.testing.assert_allclose(parts, seen, atol=0.05)
    assert np.abs(seen - whole).max() > 3


def test_filters_are_seen_on_demand(desktop, qtbot):
    window = shown(desktop, qtbot)
    session = desktop.session
    tiles = session.sonagram
    qtbot.waitUntil(lambda: bool(tiles.tiles_for(session.view.seen, 400)))
    before = tiles.tiles_for(session.view.seen, 400)[-1].levels.copy()
    window.analysis.sonagram.filtered.trigger()
    qtbot.waitUntil(lambda: bool(tiles.tiles_for(session.view.seen, 400)))
    after = tiles.tiles_for(session.view.seen, 400)[-1].levels.copy()
    assert np.abs(before.astype(float) - after).max() > 3
    click(window.filters.switches["normalise"])
    assert tiles.filters == desktop.preset.in_force.settings
    window.analysis.sonagram.filtered.trigger()
    assert tiles.filters is None
