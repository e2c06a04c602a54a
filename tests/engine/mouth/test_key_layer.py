"""Keys over a movement: what an edit changes and what it leaves, and files of keys."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.errors import MouthError
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.key_layer import (
    FORMAT,
    NO_KEYS,
    UNEDITED,
    KeyCurve,
    KeyLayer,
    ShownCurve,
    format_keys,
    keys_beside,
    parse_keys,
    read_keys,
    write_keys,
)
from phonemeengine.mouth.performer import MOUTH_ALONE, Performer
from phonemeengine.mouth.table import load_table

RATE = 60.0


def curve_of(*keys: tuple[float, float]) -> KeyCurve:
    return KeyCurve(*np.array(keys, float).T)


@pytest.fixture
def jaw() -> ShownCurve:
    """Two openings of a jaw within two seconds."""
    times = np.arange(121) / RATE
    return ShownCurve((0.4 * np.sin(np.pi * times) ** 2).astype(np.float32), RATE)


def test_offsets_go_through_the_keys_and_end_with_them():
    curve = curve_of((1, 0), (1.5, 0.4), (2, 0))
    found = curve.at(np.array([0.0, 1, 1.25, 1.5, 2, 2.5]))
    assert found[[0, 1, 3, 4, 5]] == pytest.approx([0, 0, 0.4, 0, 0])
    assert 0 < found[2] < 0.4
    assert np.abs(curve.at(np.linspace(0, 3, 1000))).max() <= 0.4  # it does not overshoot
    assert not np.any(UNEDITED.at(np.linspace(0, 3, 10)))


def test_a_layer_changes_edited_blend_shapes_within_their_keys_alone():
    layer = KeyLayer({"jawOpen": curve_of((0.1, 0), (0.2, 0.9), (0.3, 0)), "other": curve_of((0, 1), (1, 1))})
    weights = np.full((61, 2), 0.3, np.float32)
    animation = Animation(RATE, ("mouthSmileLeft", "jawOpen"), weights, np.zeros((61, 3), np.float32))
    shown = animation.edited(layer)
    assert np.array_equal(shown.weights[:, 0], weights[:, 0])
    assert shown.weights[12, 1] == 1  # 0.3 + 0.9 is more than there is
    assert np.array_equal(np.flatnonzero(shown.weights[:, 1] != weights[:, 1]), np.arange(7, 18))
    assert np.all(weights == 0.3)
    part = replace(animation, weights=weights[10:], head=animation.head[10:]).edited(layer, 10)
    assert np.array_equal(part.weights, shown.weights[10:])
    assert animation.edited(NO_KEYS) is animation


def test_a_performer_shows_edits_from_where_its_sound_begins():
    table = load_table("arkit")
    performer, plain = Performer(table, MOUTH_ALONE), Performer(table, MOUTH_ALONE)
    performer.edit(KeyLayer({"jawOpen": curve_of((0, 0), (1, 0.5), (2, 0))}), start=10.0)
    jaw = table.movestates.index("jawOpen")
    for time, offset in ((9.9, 0), (11, 0.5), (12.1, 0)):
        assert performer.at(time).weights[jaw] == pytest.approx(plain.at(time).weights[jaw] + offset)


def test_a_dragged_point_is_passed_and_its_neighbours_stay(jaw):
    points = jaw.points()
    assert len(points) < 20
    assert np.abs(np.interp(jaw.times, points, np.interp(points, jaw.times, jaw.shown)) - jaw.shown).max() <= 0.021
    before, time, after = points[3:6].tolist()
    moved = replace(jaw, keys=jaw.with_point(time, 0.9, before, after))
    assert np.interp(time, jaw.times, moved.shown) == pytest.approx(0.9, abs=0.02)
    outside = (jaw.times <= before) | (jaw.times >= after)
    assert moved.shown[outside] == pytest.approx(jaw.shown[outside], abs=1e-6)
    again = replace(moved, keys=moved.with_point(time + 0.01, 0.5, before, after))
    assert np.interp(time + 0.01, jaw.times, again.shown) == pytest.approx(0.5, abs=0.02)
    assert replace(again, keys=again.as_generated(0, 2)).keys == UNEDITED


def test_a_deleted_point_leaves_a_straight_line(jaw):
    cut = replace(jaw, keys=jaw.without_point(0.25, 0.75))  # the top of the first opening
    inside = (jaw.times > 0.25) & (jaw.times < 0.75)
    ends = np.interp([0.25, 0.75], jaw.times, jaw.shown)
    assert cut.shown[inside] == pytest.approx(np.interp(jaw.times[inside], [0.25, 0.75], ends), abs=1e-6)


def test_smoothing_and_raising_change_their_range_alone(jaw):
    rough = replace(jaw, generated=jaw.generated + np.float32(0.1) * (np.arange(121) % 2).astype(np.float32))
    smooth = replace(rough, keys=rough.smoothed(0.5, 1.5))
    assert np.abs(np.diff(smooth.shown[40:80])).mean() < 0.3 * np.abs(np.diff(rough.shown[40:80])).mean()
    raised = replace(jaw, keys=jaw.raised(0.5, 1.5, 0.2))
    assert raised.shown[60] == pytest.approx(jaw.shown[60] + 0.2, abs=1e-6)
    for changed, whole in ((smooth, rough), (raised, jaw)):
        assert changed.shown[:30] == pytest.approx(whole.shown[:30])
        assert changed.shown[91:] == pytest.approx(whole.shown[91:])


@pytest.mark.parametrize(
    ("times", "words"), [((0.5, 0.4, 0.6), "keys lie one after the other"), ((1.5, 1.9, 2.5), "within the sound")]
)
def test_keys_out_of_order_or_outside_the_sound_are_refused(jaw, times, words):
    before, time, after = times
    with pytest.raises(MouthError, match=words):
        jaw.with_point(time, 0.5, before, after)


def test_keys_beyond_the_sound_move_nothing_and_stay_through_edits_within(jaw):
    beyond = ((5.0, 0.3), (9.0, -0.5))  # the file was longer, or is another one, when they were made
    shown = replace(jaw, keys=curve_of(*beyond))
    assert shown.shown == pytest.approx(jaw.shown)
    assert shown.points().max() <= jaw.times[-1]
    raised = shown.raised(0.5, 1.0, 0.2)
    assert raised.times[-2:].tolist() == [5.0, 9.0]
    assert replace(jaw, keys=raised).shown[45] == pytest.approx(jaw.shown[45] + 0.2, abs=1e-6)


def test_a_file_of_keys_gives_them_back(tmp_path):
    layer = KeyLayer({"jawOpen": curve_of((0.1, 0), (0.2, 0.9), (0.3, 0)), "tongueOut": curve_of((0, -1), (1, 1))})
    path = keys_beside(tmp_path / "talk.wav")
    write_keys(layer, path)
    assert path.name == "talk.keys.toml"
    assert read_keys(path) == layer
    assert parse_keys(format_keys(NO_KEYS)) == NO_KEYS


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("", "begins with format"),
        ('format = "phonemeanalyser-keys-9"', "begins with format"),
        ("no", "no TOML file"),
        (f'format = "{FORMAT}"\nshapes = 1', "cannot have an entry 'shapes'"),
        (f'format = "{FORMAT}"\n[[curves]]\nmovestate = "a"\ntimes = [0.0]\noffsets = []', "1 times and 0 offsets"),
        (f'format = "{FORMAT}"\n[[curves]]\nmovestate = "a"\ntimes = [0.0]\noffsets = [0.0]', "2..100000 keys"),
        (f'format = "{FORMAT}"\n[[curves]]\nmovestate = "a"\ntimes = [1, 1]\noffsets = [0, 0]', "found 1 s"),
        (f'format = "{FORMAT}"\n[[curves]]\nmovestate = "a"\ntimes = [-1, 1]\noffsets = [0, 0]', "found -1 s"),
        (f'format = "{FORMAT}"\n[[curves]]\nmovestate = "a"\ntimes = [0, 1]\noffsets = [0, 3]', "found 3"),
        (
            f'format = "{FORMAT}"\n' + 2 * '[[curves]]\nmovestate = "a"\ntimes = [0, 1]\noffsets = [0, 0]\n',
            "two curves",
        ),
    ],
)
def test_what_is_no_file_of_keys_is_refused_by_its_name(tmp_path, body, words):
    path = tmp_path / "talk.keys.toml"
    path.write_text(body)
    with pytest.raises(MouthError, match=words) as refused:
        read_keys(path)
    assert str(refused.value).startswith("talk.keys.toml: ")
