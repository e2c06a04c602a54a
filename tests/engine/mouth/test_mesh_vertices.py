"""Vertices are looked at, set and moved; the mesh that they were taken from stays as it is."""

import numpy as np
import pytest

from phonemeengine import MeshError, Mode, MovestateSet, load_head, movestate_at
from tests.meshes import CORNERS, cube


def test_a_vertex_is_where_the_mesh_has_it() -> None:
    np.testing.assert_array_equal(cube().vertices(5), CORNERS[5])
    np.testing.assert_array_equal(cube().vertices([5, 0, 5]), CORNERS[[5, 0, 5]])
    assert cube().vertices([]).shape == (0, 3)


def test_what_is_looked_at_can_be_changed_without_changing_the_mesh() -> None:
    mesh = cube()
    mesh.vertices([1])[:] = 7
    np.testing.assert_array_equal(mesh.positions, CORNERS)


def test_a_vertex_that_is_set_is_there_and_no_other_has_moved() -> None:
    before = cube()
    after = before.with_vertices([1, 6], [(2, 2, 2), (-3, 0, 0)])
    np.testing.assert_array_equal(after.vertices([1, 6]), [(2, 2, 2), (-3, 0, 0)])
    others = [0, 2, 3, 4, 5, 7]
    np.testing.assert_array_equal(after.positions[others], CORNERS[others])
    np.testing.assert_array_equal(before.positions, CORNERS)
    with pytest.raises(ValueError, match="read-only"):
        after.positions[0] = 0


def test_vertices_move_by_one_offset_or_by_one_each() -> None:
    np.testing.assert_array_equal(cube().moved([0, 3], (0, 1, 0)).positions[[0, 3]], CORNERS[[0, 3]] + [0, 1, 0])
    np.testing.assert_array_equal(cube().moved(2, (0, 0, 4)).vertices(2), CORNERS[2] + [0, 0, 4])
    each = cube().moved([0, 3], [(1, 0, 0), (0, 0, 5)])
    np.testing.assert_array_equal(each.positions[[0, 3]], CORNERS[[0, 3]] + [(1, 0, 0), (0, 0, 5)])


def test_the_normals_follow_where_triangles_moved() -> None:
    head = load_head().mesh
    tip = int(head.positions[:, 2].argmax())
    nose = head.within(head.vertices(tip), 0.1)
    longer = head.moved(nose, (0, 0, 0.3))
    turned = np.linalg.norm(longer.normals - head.normals, axis=1) > 1e-3
    assert turned[nose].any()
    assert turned.mean() < 0.1
    np.testing.assert_allclose(np.linalg.norm(longer.normals, axis=1), 1, rtol=1e-5)


def test_a_sphere_holds_all_that_is_not_farther_than_its_radius() -> None:
    assert cube().within((1, 1, 1), 0).tolist() == [1]
    assert cube().within((1, 1, 1), 2).tolist() == [0, 1, 3, 5]
    assert cube().within((0, 0, 0), 3**0.5).tolist() == list(range(8))
    assert cube().within((0, 0, 0), 1.7).tolist() == []


@pytest.mark.parametrize("number", [8, -1, 1.0, True])
def test_a_vertex_that_is_not_there_is_refused(number: object) -> None:
    for attempt in (cube().vertices, lambda n: cube().moved(n, (0, 0, 0))):
        with pytest.raises(MeshError, match=rf"the mesh has the vertices 0..7, got {number}; choose one of them"):
            attempt([number])


@pytest.mark.parametrize(
    ("positions", "said"),
    [
        ([(1, 2, 3)] * 3, r"2 vertices need positions of shape \(2, 3\), got \(3, 3\)"),
        ([(0, 0, np.nan)] * 2, "vertex 0 has no finite position"),
        ([(0, 0, 1e39)] * 2, "vertex 0 has no finite position"),
    ],
)
def test_positions_that_no_mesh_can_have_are_refused(positions: object, said: str) -> None:
    with pytest.raises(MeshError, match=said):
        cube().with_vertices([0, 1], positions)


def test_a_movestate_is_made_of_the_vertices_in_a_sphere_and_morphs_the_head() -> None:
    """What the README shows."""
    morph_mesh = load_head()
    tip = morph_mesh.mesh.positions[morph_mesh.mesh.positions[:, 2].argmax()]
    nose = morph_mesh.mesh.within(tip, 0.15)
    longer = movestate_at("longer nose", nose, [[0, 0, 0.2]] * len(nose))
    face = MovestateSet(morph_mesh.mesh, [*morph_mesh.states, longer])
    face.set_percentages({"jawOpen": 50, "eyeBlinkLeft": 90})
    face.set_interactable("eyeBlinkLeft", False)
    face.set_percentage("longer nose", 60, Mode.INTERACT)
    assert (face.percentage("jawOpen"), face.percentage("eyeBlinkLeft")) == pytest.approx((40, 90))
    face.set_percentage("longer nose", 60, Mode.RESET)
    assert (face.percentage("jawOpen"), face.percentage("eyeBlinkLeft")) == (0, 90)
    face.reset("eyeBlinkLeft")
    moved = face.morphed() - morph_mesh.mesh.positions
    assert 5 < len(nose) < 500
    np.testing.assert_allclose(moved[nose], np.tile((0, 0, 0.12), (len(nose), 1)), atol=1e-6)
    assert np.abs(np.delete(moved, nose, axis=0)).max() == 0
    assert face.weights[-1] == pytest.approx(0.6)
