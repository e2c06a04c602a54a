"""The camera that looks at a head: geometry."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeanalyser.rendering.camera import HIGHEST, Camera
from tests.meshes import cube

ANGLES = st.floats(-20, 20)


def test_the_place_of_a_mesh_is_where_it_is_seen_and_room_beside():
    points = np.array([[-1, -1, 0], [1, 1, 0]], np.float32)
    camera = Camera(distance=10.0)
    seen = camera.matrix(2.0) @ (1, 1, 0, 1)
    right, top = (seen[:2] / seen[3] + 1) / 2 * (800, 400)
    left, bottom, width, height = camera.place_of(points, (800, 400))
    assert right < left + width < right + 0.2 * width
    assert top < bottom + height < top + 0.2 * height
    assert (left + left + width, bottom + bottom + height) == pytest.approx((800, 400), abs=2)
    assert camera.place_of(points + np.array((0, 0, 20)), (800, 400)) == (0, 0, 800, 400)
    assert Camera(distance=10.0).pan(-9, 0).place_of(points, (800, 400))[2] >= 1


def seen_at(camera: Camera, point: tuple[float, float, float], aspect: float = 1.0) -> np.ndarray:
    x, y, z, w = camera.matrix(aspect).astype(float) @ np.array([*point, 1.0])
    return np.array((x, y, z)) / w


@pytest.fixture
def camera() -> Camera:
    return Camera.facing(cube())


def test_what_the_camera_looks_at_is_in_the_middle(camera: Camera):
    moved = camera.orbit(1.0, 0.4).pan(0.2, -0.1).zoom(3)
    assert seen_at(moved, moved.centre)[:2] == pytest.approx((0, 0), abs=1e-6)
    assert np.linalg.norm(moved.eye - moved.centre) == pytest.approx(moved.distance)


def test_from_the_front_right_is_right_and_up_is_up(camera: Camera):
    assert seen_at(camera, (0.5, 0, 0))[0] > 0
    assert seen_at(camera, (0, 0.5, 0))[1] > 0
    assert seen_at(camera, (0, 0, 0.5))[2] < seen_at(camera, (0, 0, 0))[2] < 1


def test_going_round_to_the_right_shows_the_right_side(camera: Camera):
    aside = camera.orbit(math.pi / 2, 0)
    assert aside.eye == pytest.approx((camera.distance, 0, 0), abs=1e-9)
    above = camera.orbit(0, 0.5)
    assert above.eye[1] > 0


@given(dx=ANGLES, dy=ANGLES)
def test_nobody_goes_over_the_top_and_once_round_is_where_one_was(dx: float, dy: float):
    camera = Camera.facing(cube()).orbit(dx, dy)
    assert abs(camera.elevation) <= HIGHEST
    assert abs(camera.azimuth) <= math.pi + 1e-9
    assert camera.orbit(2 * math.pi, 0).matrix(1.0) == pytest.approx(camera.matrix(1.0), abs=1e-5)


@given(steps=st.floats(-200, 200))
def test_zooming_never_reaches_the_head_nor_loses_it(steps: float):
    camera = Camera.facing(cube())
    near = camera.zoom(steps)
    assert 0.3 * camera.distance < near.distance < 5 * camera.distance
    assert 0 < seen_at(near, (0.05, 0, 0))[0] < 1
    assert abs(seen_at(near, (0, 0, 1))[2]) < 1
    assert abs(seen_at(near, (0, 0, -1))[2]) < 1


@given(dx=st.floats(-100, 100), dy=st.floats(-100, 100))
def test_panning_keeps_near_to_the_head(dx: float, dy: float):
    camera = Camera.facing(cube()).orbit(0.4, 0.2)
    moved = camera.pan(dx, dy)
    assert np.linalg.norm(np.subtract(moved.centre, camera.centre)) <= camera.radius
    if abs(dx) > 1e-3:
        assert math.copysign(1, seen_at(moved, camera.centre)[0]) == -math.copysign(1, dx)


def test_a_pan_by_a_picture_s_height_moves_what_is_in_the_middle_by_it(camera: Camera):
    moved = camera.zoom(6).pan(0.0, 0.25)
    assert seen_at(moved, camera.centre)[1] == pytest.approx(-0.5, rel=1e-5)


@pytest.mark.parametrize("aspect", [0.3, 1.0, 2.5])
def test_all_of_a_mesh_is_in_the_picture_whatever_its_form(aspect: float, camera: Camera):
    for corner in cube().positions.tolist():
        for azimuth in (0.0, 0.8, 2.0):
            assert np.all(np.abs(seen_at(camera.orbit(azimuth, 0.0), tuple(corner), aspect)) < 1)


def test_moving_a_camera_leaves_the_old_one_where_it_was(camera: Camera):
    before = camera.matrix(1.3)
    camera.orbit(1, 1).pan(1, 1).zoom(5)
    assert np.array_equal(camera.matrix(1.3), before)
