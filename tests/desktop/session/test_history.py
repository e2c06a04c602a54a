"""The last minute and the extremes since Clear."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from phonemeanalyser.desktop.session.results import CAPACITY, GAP, NOWHERE, History
from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.features.variables import Features, Variable
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, HOP, WINDOW, AnalysisSettings, Filter
from tests.sounds import tone

NAMES = ("one", "two")
EMPTY = Analyser(Preset()).push(np.zeros(0, np.float32))


def block(first: int, n: int, names: tuple[str, ...] = NAMES) -> Analysis:
    """Frames that say which ones they are: variable k of frame j is 100 k + j % 97."""
    frames = np.arange(first, first + n)
    values = 100 * np.arange(len(names)) + (frames % 97)[:, np.newaxis]
    windows = np.repeat((frames % 97)[:, np.newaxis], WINDOW, axis=1).astype(np.float32)
    features = Features(names, values.astype(np.float32))
    return replace(
        EMPTY,
        start=first,
        frames=replace(EMPTY.frames, windows=windows, spectra=windows, waveforms=windows, features=features),
        recognised=(frames % 11).astype(np.uint8),
        phonemes=((frames + 1) % 11).astype(np.uint8),
        intensities=(frames % 2).astype(np.float32),
    )


def filled(n: int, size: int = 500) -> History:
    history = History()
    for first in range(0, n, size):
        history.append(block(first, min(size, n - first)))
    return history


def shows(history: History, n: int) -> None:
    """The history of `n` frames holds the last minute of them, each in its place."""
    indices = history.indices(0, n + 1000)
    frames = np.arange(max(0, n - CAPACITY), n)
    assert history.n == n
    assert history.frames[indices].tolist() == frames.tolist()
    assert history.recognised[indices].tolist() == (frames % 11).tolist()
    assert history.phonemes[indices].tolist() == ((frames + 1) % 11).tolist()
    assert history.intensities[indices].tolist() == (frames % 2).tolist()
    np.testing.assert_array_equal(history.samples[indices, 0], frames % 97)
    np.testing.assert_array_equal(history.features(indices)["two"], 100 + frames % 97)


@pytest.mark.parametrize("n", [1, 499, CAPACITY - 1, CAPACITY, CAPACITY + 1, 2 * CAPACITY + 123])
def test_the_last_minute_is_remembered(n: int) -> None:
    shows(filled(n), n)


@settings(max_examples=15)
@given(cuts=st.lists(st.integers(0, CAPACITY + 700), max_size=8))
def test_the_history_does_not_depend_on_how_the_frames_came(cuts: list[int]) -> None:
    n = CAPACITY + 700
    history = History()
    places = [0, *sorted(cuts), *range(0, n, 5000), n]
    places.sort()
    for first, last in pairwise(places):
        if last > first:
            history.append(block(first, last - first))
    shows(history, n)


def test_columns_that_are_forgotten_have_no_index() -> None:
    history = filled(CAPACITY + 100)
    assert len(history.indices(0, 100)) == 0
    assert history.indices(90, 102).tolist() == [100, 101]
    assert len(history.indices(CAPACITY + 100, CAPACITY + 200)) == 0
    assert len(history.indices(50, 10)) == 0
    assert history.indices(CAPACITY - 1, CAPACITY + 2).tolist() == [CAPACITY - 1, 0, 1]


def test_extremes_are_those_since_clear_however_long_ago() -> None:
    history = filled(CAPACITY + 3000)
    mean = np.mean(np.arange(CAPACITY + 3000) % 97)
    assert history.extremes("one") == (96, pytest.approx(mean), 0)
    assert history.extremes("two") == (196, pytest.approx(100 + mean), 100)
    history.clear()
    assert history.extremes("one") is None
    history.append(block(5, 3))
    assert history.extremes("one") == (7, 6, 5)


def test_before_the_first_frame_there_are_no_extremes() -> None:
    assert History().extremes("one") is None
    assert filled(3).extremes("three") is None


def test_a_new_variable_leaves_the_others_as_they_are() -> None:
    history = filled(50)
    history.append(block(50, 10, names=("one", "two", "new")))
    assert history.names == ("one", "two", "new")
    indices = history.indices(0, 60)
    np.testing.assert_array_equal(history.features(indices)["two"], 100 + np.arange(60))
    np.testing.assert_array_equal(history.features(indices)["new"], [np.nan] * 50 + list(range(250, 260)))
    assert history.extremes("one") == (59, pytest.approx(29.5), 0)
    assert history.extremes("new") == (259, pytest.approx(254.5), 250)


def test_a_variable_that_goes_leaves_the_others_as_they_are() -> None:
    history = filled(50)
    history.append(block(50, 10, names=("two",)))
    assert history.names == ("two",)
    assert history.extremes("one") is None
    assert history.extremes("two") == (149, pytest.approx((50 * 124.5 + 10 * 54.5) / 60), 50)


def test_the_sound_is_silent_in_gaps_and_goes_on_as_far_as_the_newest_window() -> None:
    history = History()
    history.append(block(1, 3))
    history.append(block(50, 2))
    sound = history.sound_between(0, (3 + GAP + 5) * HOP)
    of_columns = [1, 2, 3, *[0] * GAP, 50, 51]
    np.testing.assert_array_equal(sound[: len(of_columns) * HOP : HOP], of_columns)
    ahead = WINDOW // 2 - HOP + HOP // 2
    assert history.n_samples == len(of_columns) * HOP + ahead
    assert set(sound[len(of_columns) * HOP : history.n_samples]) == {51}
    assert not sound[history.n_samples :].any()
    np.testing.assert_array_equal(history.sound_between(HOP - 2, HOP + 2), [1, 1, 2, 2])
    there = history.columns_with_sound(np.arange(len(of_columns) + 2))
    assert there.tolist() == [*[True] * 3, *[False] * GAP, True, True, False, False]


def test_clearing_forgets_the_columns() -> None:
    history = filled(100)
    history.clear()
    assert (history.n, history.newest) == (0, None)
    assert len(history.indices(0, 100)) == 0


def test_the_newest_block_is_at_hand() -> None:
    history = History()
    newest = block(0, 4)
    history.append(newest)
    assert history.newest is newest


@pytest.mark.parametrize("n_frames", [2, 50])
def test_through_the_mel_bank_a_tone_is_still_at_its_frequency(n_frames: int) -> None:
    settings = AnalysisSettings(filters=frozenset({Filter.MEL}))
    analysis = Analyser(Preset(settings=settings, variables=(Variable("mine", 1, 2),))).push(tone(1000, 0.6))
    spectra = analysis.part(slice(0, n_frames)).linear_spectra
    assert spectra.shape == (n_frames, 1024)
    assert abs(int(spectra[-1].argmax()) * BIN_WIDTH - 1000) < 150  # a band is that wide
    plain = Analyser(Preset()).push(tone(1000, 0.1))
    assert plain.linear_spectra is plain.spectra


def test_the_newest_run_ends_where_the_place_in_the_file_jumps() -> None:
    history = filled(50, 10)
    history.append(block(200, 30))
    assert history.newest_run(100) == (200, 230)
    assert history.newest_run(20) == (210, 230)
    assert History().newest_run(100) == (0, 0)


def test_columns_that_are_written_anew_leave_the_others_and_the_stretch_of_the_extremes_as_they_are() -> None:
    history = filled(CAPACITY + 300)
    before = history.frames[history.indices(300, history.n)].copy()
    history.rewrite(CAPACITY + 200, block(CAPACITY + 200, 100))
    assert history.n == CAPACITY + 300
    np.testing.assert_array_equal(history.frames[history.indices(300, history.n)], before)
    mean = np.mean(np.arange(CAPACITY + 300) % 97)
    assert history.extremes("one") == (96, pytest.approx(mean), 0)
    assert history.n_measured("one") == CAPACITY + 300
    frames = block(CAPACITY + 290, 10)
    high = replace(frames.features, values=np.full((10, 2), 1000, np.float32))
    history.rewrite(CAPACITY + 290, replace(frames, frames=replace(frames.frames, features=high)))
    highest, _, lowest = history.extremes("one") or (0, 0, 0)
    assert (highest, lowest, history.n_measured("one")) == (1000, 0, CAPACITY + 300)
    assert history.extremes("two")[2] == 100


def test_a_gap_lies_where_the_sound_does_not_go_on() -> None:
    history = filled(50)
    history.append(block(50, 10))
    history.append(block(0, 10))  # as a loop does
    history.append(block(10, 10))
    history.append(block(700, 10))  # as a seek does
    found = history.frames[history.indices(0, history.n)].tolist()
    gap = [NOWHERE] * GAP
    assert found == [*range(60), *gap, *range(20), *gap, *range(700, 710)]
    values = history.features(history.indices(0, history.n))["one"]
    assert np.flatnonzero(np.isnan(values)).tolist() == [*range(60, 60 + GAP), *range(80 + GAP, 80 + 2 * GAP)]
    assert history.n_measured("one") == 90
    assert history.newest_run(100) == (700, 710)


def test_what_nobody_heard_counts_for_nothing_and_gives_way() -> None:
    history = filled(50)
    before = history.extremes("one")
    for first, n in ((2000, 96), (300, 40), (1000, 20)):
        assert history.take_back_unheard() == 50
        assert history.newest is None
        history.append(block(first, n), heard=False)
        assert history.n == 50 + GAP + n
        assert history.extremes("one") == before
    history.append(block(1020, 5))
    assert history.n_measured("one") == 55
    assert history.frames[history.indices(0, history.n)].tolist()[-25:] == list(range(1000, 1025))
    for k in range(7):
        history.append(block(1025 + 1000 * k, 1000))
    assert history.n_measured("one") == 7055


def test_without_the_gap_the_phoneme_would_not_change_there() -> None:
    history = History()
    steady = [replace(block(first, 50), phonemes=np.full(50, 3, np.uint8)) for first in (0, 500)]
    for part in steady:
        history.append(part)
    assert history.changes_per_s(3) == 0
