"""Normals, wetness, light, and finer triangles: on balls and cubes everything is known."""

import moderngl
import numpy as np
import pytest

from phonemeanalyser.rendering.renderer import HeadRenderer
from phonemeanalyser.rendering.surface import MOST_TRIANGLES, Surface, specular_mask, subdivided
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh, load_head
from phonemeengine.mouth.movestate import MovestateSet, movestate_of
from tests.graphics import ball, context, joined
from tests.meshes import cube, morph_mesh_of_cube, volume

__all__ = ["context"]  # a fixture
NO_POLES = slice(25, -25)
"""Of the ball's vertices: at its poles some belong to triangles without an area."""


@pytest.fixture(scope="module")
def head() -> MorphMesh:
    return load_head()


def edges_of(triangles: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Count the triangles at each edge, where vertices at one place count as one."""
    _, place = np.unique(points.round(5), axis=0, return_inverse=True)
    corners = place.reshape(-1)[triangles]
    sides = np.sort(np.stack((corners, np.roll(corners, -1, axis=1)), axis=2).reshape(-1, 2), axis=1)
    sides = sides[sides[:, 0] != sides[:, 1]]
    return np.unique(sides, axis=0, return_counts=True)[1]


def test_a_ball_faces_away_from_its_middle_wherever_it_is_and_however_large():
    mesh = ball()
    surface = Surface(mesh)
    for radius, middle in ((1.0, 0.0), (3.0, 2.0)):
        normals = surface.normals((radius * mesh.positions + np.float32(middle)).astype(np.float32))
        assert np.einsum("ij,ij->i", normals, mesh.positions)[NO_POLES].min() > 0.985
        assert np.linalg.norm(normals, axis=1) == pytest.approx(1, abs=1e-5)


def test_vertices_that_were_split_at_one_place_face_alike():
    mesh = ball()
    mesh = mesh_of(np.round(mesh.positions, 6), mesh.triangles)
    normals = Surface(mesh).normals(mesh.positions * np.float32((1, 2, 1)))
    seam, first = normals.reshape(13, 25, 3)[1:-1, -1], normals.reshape(13, 25, 3)[1:-1, 0]
    assert seam == pytest.approx(first, abs=1e-6)


def test_the_surface_says_of_a_mesh_at_rest_what_the_mesh_says(head: MorphMesh):
    normals = Surface(head.mesh).normals(head.mesh.positions)
    assert np.einsum("ij,ij->i", normals, head.mesh.normals).min() > 0.99


def test_a_vertex_without_an_area_faces_the_viewer():
    flat = mesh_of([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)])
    assert Surface(flat).normals(flat.positions).tolist() == [[0, 0, 1]] * 3


def test_eyes_are_wet_because_they_are_round():
    beside = cube()
    far = mesh_of(beside.positions + np.float32((5, 0, 0)), beside.triangles)
    wet = specular_mask(joined(far, ball()))
    assert wet[:8].tolist() == [0] * 8
    assert wet[8:].min() == 1


def test_of_the_head_eyes_teeth_and_lips_are_wet_and_skin_and_brows_dry(head: MorphMesh):
    wet, points = specular_mask(head.mesh), head.mesh.positions
    assert (wet == 1).sum() == 2 * 416
    crown = points[:, 1] > 0.9
    assert wet[crown].max() == 0
    lips = (np.abs(points[:, 0]) < 0.1) & (np.abs(points[:, 1] + 0.05) < 0.06) & (points[:, 2] > 1.27)
    assert wet[lips].mean() > 0.2


def test_a_ball_in_a_ball_is_dark_and_one_alone_is_open(context: moderngl.Context):
    inner, outer = ball(0.4), ball(1.0)
    renderer = HeadRenderer(context, MorphMesh(joined(inner, outer)))
    openness = np.frombuffer(renderer._looks.read(), np.float32).reshape(-1, 5)[:, 4]
    assert openness[: len(inner)].max() < 0.02
    assert openness[len(inner) :][NO_POLES].min() > 0.9
    renderer.release()


def test_the_closed_mouth_and_the_nostrils_are_darker_than_the_forehead(context: moderngl.Context, head: MorphMesh):
    renderer = HeadRenderer(context, head)
    openness = np.frombuffer(renderer._looks.read(), np.float32).reshape(-1, 5)[:, 4]
    x, y, z = head.mesh.positions.T
    forehead = (np.abs(x) < 0.3) & (y > 0.9) & (y < 1.15) & (z > 1.0)  # below the hair
    throat = (np.abs(x) < 0.15) & (np.abs(y + 0.2) < 0.15) & (z > 0.3) & (z < 1.0)
    assert throat.sum() > 20
    assert openness[forehead].min() > 0.9  # hair stands above it
    assert openness[throat].max() < 0.1
    renderer.release()


def test_a_smoothed_figure_has_four_triangles_for_each_and_stays_closed(head: MorphMesh):
    finer = subdivided(head)
    assert len(finer.mesh.triangles) == 4 * len(head.mesh.triangles)
    assert (
        edges_of(finer.mesh.triangles, finer.mesh.positions).max()
        == edges_of(head.mesh.triangles, head.mesh.positions).max()
    )
    n_open = [int((edges_of(one.mesh.triangles, one.mesh.positions) == 1).sum()) for one in (head, finer)]
    assert n_open[1] <= 2.01 * n_open[0]  # hairs of a brow that cross at a vertex come apart
    assert [state.name for state in finer.states] == [state.name for state in head.states]
    assert [state.interactable for state in finer.states] == [state.interactable for state in head.states]


def test_smoothing_rounds_a_large_mesh_and_nothing_leaves_its_hull():
    mesh = ball(n=16)
    finer = subdivided(MorphMesh(mesh)).mesh
    radii = np.linalg.norm(finer.positions, axis=1)
    assert radii.max() <= 1.0001
    assert 0.9 * volume(mesh) < volume(finer) < volume(mesh)


def test_a_plane_stays_a_plane_and_keeps_its_corners_edges():
    x, y = np.meshgrid(np.arange(12.0), np.arange(12.0))
    k = np.arange(144).reshape(12, 12)
    a, b, c, d = (part.ravel() for part in (k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]))
    triangles = np.concatenate((np.stack((a, b, c), 1), np.stack((a, c, d), 1)))
    plane = mesh_of(np.column_stack((x.ravel(), y.ravel(), 0.3 * x.ravel())), triangles)
    points = subdivided(MorphMesh(plane)).mesh.positions
    assert points[:, 2] == pytest.approx(0.3 * points[:, 0], abs=1e-5)
    on_edge = np.isclose(points[:144], plane.positions, atol=1e-5).all(axis=1).reshape(12, 12)
    assert on_edge[0, 2:-2].all()
    assert on_edge[2:-2, 2:-2].all()


def test_a_small_part_keeps_its_form():
    finer = subdivided(morph_mesh_of_cube())
    assert volume(finer.mesh) == pytest.approx(8, rel=1e-5)
    assert len(finer.mesh.triangles) == 48


def test_moving_a_smoothed_figure_is_smoothing_a_moved_one(head: MorphMesh):
    finer, moved = subdivided(head), MovestateSet(head.mesh, head.states)
    percentages = {"jawOpen": 60.0, "mouthSmileLeft": 40.0, "eyeBlinkRight": 100.0}
    moved.set_percentages(percentages)
    other = MovestateSet(finer.mesh, finer.states)
    other.set_percentages(percentages)
    mesh = head.mesh
    wanted = subdivided(MorphMesh(mesh_of(moved.morphed(), mesh.triangles, normals=mesh.normals))).mesh.positions
    assert np.abs(other.morphed() - wanted).max() < 3e-4  # offsets below 0.0001 are left out


def test_a_mesh_that_is_fine_already_is_left_as_it_is():
    fine = MorphMesh(ball(n=2 * int(np.sqrt(MOST_TRIANGLES / 2)) + 4), (movestate_of("none", np.zeros((1, 3))),))
    assert len(fine.mesh.triangles) > MOST_TRIANGLES
    assert subdivided(fine) is fine
