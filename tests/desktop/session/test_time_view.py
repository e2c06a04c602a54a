"""Which seconds are seen: always some of the file, and the time under the mouse stays there."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeanalyser.desktop.session.time_view import SHORTEST, USUAL, TimeSpan, TimeView

DURATIONS = st.floats(SHORTEST, 10_000)
SHARES = st.floats(0, 1)


def opened(duration: float) -> TimeView:
    view = TimeView()
    view.open(duration)
    return view


@given(DURATIONS, st.lists(st.tuples(SHARES, st.floats(0.01, 100), st.floats(-20_000, 20_000)), max_size=8))
def test_whatever_is_done_some_of_the_file_is_seen_and_nothing_else(duration, moves):
    view = opened(duration)
    for share, factor, seconds in moves:
        view.zoom(share * duration, factor)
        view.scroll(seconds)
        assert 0 <= view.seen.start < view.seen.end <= duration + 1e-9
        assert view.seen.seconds >= min(SHORTEST, duration) - 1e-9


@given(st.floats(0.2, 0.8), st.floats(0.5, 1.5))
def test_the_time_under_the_mouse_stays_there(share, factor):
    view = opened(1000)
    view.show(TimeSpan(400, 440))
    at = 400 + 40 * share
    view.zoom(at, factor)
    assert (at - view.seen.start) / view.seen.seconds == pytest.approx(share)


def test_a_file_is_opened_at_its_beginning_and_a_short_one_is_seen_whole():
    assert opened(600).seen == TimeSpan(0, USUAL)
    assert opened(3.2).seen == TimeSpan(0, 3.2)
    assert opened(0).seen == TimeSpan(0, 0)


def test_home_and_end_and_all():
    view = opened(600)
    view.scroll(1e9)
    assert view.seen == TimeSpan(590, 600)
    view.scroll(-1e9)
    assert view.seen == TimeSpan(0, 10)
    view.show_all()
    assert view.seen == TimeSpan(0, 600)


def test_the_page_turns_where_what_is_heard_leaves_it_unless_it_must_not():
    view = opened(600)
    view.follow(9.9)
    assert view.seen == TimeSpan(0, 10)
    view.follow(10.0)
    assert view.seen == TimeSpan(9, 19)
    view.follow(300)
    assert view.seen == TimeSpan(299, 309)
    view.follows = False
    view.follow(0)
    assert view.seen == TimeSpan(299, 309)


def test_a_selection_may_be_dragged_from_either_end_and_a_click_selects_nothing(qtbot):
    view = opened(600)
    with qtbot.waitSignal(view.selected):
        view.select(TimeSpan(5, 2))
    assert view.selection == TimeSpan(2, 5)
    view.select(TimeSpan(700, 590))
    assert view.selection == TimeSpan(590, 600)
    view.select(TimeSpan(3, 3.001))
    assert view.selection is None


def test_another_file_has_nothing_selected():
    view = opened(600)
    view.select(TimeSpan(1, 2))
    view.open(30)
    assert view.selection is None


def test_it_says_only_what_changed(qtbot):
    view = opened(600)
    with qtbot.assertNotEmitted(view.moved), qtbot.assertNotEmitted(view.selected):
        view.scroll(-5)
        view.select(None)
