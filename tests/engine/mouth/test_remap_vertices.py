import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from numpy.typing import NDArray

from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import Mesh, mesh_of
from phonemeengine.mouth.morph_mesh import MorphTargets, matched, morph_targets_of, remap_vertices
from phonemeengine.mouth.movestate import movestate_of

POINTS = np.random.default_rng(1).standard_normal((40, 3)).astype(np.float32)


def face() -> MorphTargets:
    """Movestates of forty vertices, of which the last ten never move."""
    moving = np.where(np.arange(40)[:, np.newaxis] < 30, 1.0, 0.0)
    offsets = np.random.default_rng(2).standard_normal((2, 40, 3)) * moving
    return morph_targets_of(mesh_of(POINTS), [movestate_of("a", offsets[0]), movestate_of("b", offsets[1])])


def movements(of: MorphTargets, mesh: Mesh) -> set[tuple[bytes, bytes]]:
    """Each movement of the first state, as where it begins and where it goes."""
    state = of.states[0]
    return {
        (begin.tobytes(), offset.tobytes())
        for begin, offset in zip(mesh.positions[state.numbers], state.offsets, strict=True)
    }


@given(order=st.permutations(range(40)))
def test_every_place_moves_as_before_in_whatever_order_its_vertices_come(order: list[int]):
    other = mesh_of(POINTS[order])
    renumbered = remap_vertices(face(), other)
    assert movements(renumbered, other) == movements(face(), mesh_of(POINTS))
    np.testing.assert_array_equal(renumbered.positions, other.positions[renumbered.numbers])


def test_all_copies_of_a_vertex_that_was_split_move():
    split = mesh_of(np.vstack((POINTS, POINTS[:3])))
    assert remap_vertices(face(), split).states[0].numbers.tolist() == [*range(30), 40, 41, 42]


def test_lips_that_touch_still_move_apart():
    lips = np.array([(0, 0, 0), (0, 0, 0), (1, 0, 0)], np.float32)
    opened = morph_targets_of(mesh_of(lips), [movestate_of("open", [(0, 1, 0), (0, -1, 0), (0, 0, 0)])])
    moved = remap_vertices(opened, mesh_of(lips[[2, 0, 1]])).states[0]
    assert moved.numbers.tolist() == [1, 2]
    assert moved.offsets.tolist() == [[0, 1, 0], [0, -1, 0]]


def test_a_vertex_that_is_nowhere_is_named():
    other = POINTS.copy()
    other[[4, 7]] += 0.01
    with pytest.raises(MeshError, match=r"2 of the 30 vertices that move are not in the mesh within 0.0001: 4, 7;"):
        remap_vertices(face(), mesh_of(other))
    assert len(remap_vertices(face(), mesh_of(other), tolerance=0.02).states[0]) == 30


def test_many_vertices_that_are_nowhere_are_counted():
    with pytest.raises(MeshError, match=r"30 of the 30 .*: 0, 1, 2, 3, 4, 5, 6, 7 and 22 others;"):
        remap_vertices(face(), mesh_of(POINTS + 9))


def test_a_tolerance_that_finds_everything_everywhere_is_refused():
    crowd = mesh_of(np.zeros((3000, 3)))
    moving = morph_targets_of(crowd, [movestate_of("s", np.ones((3000, 3)))])
    with pytest.raises(MeshError, match="choose a smaller tolerance"):
        remap_vertices(moving, crowd)


def test_a_face_that_does_not_move_needs_no_place():
    still = morph_targets_of(mesh_of(POINTS), [movestate_of("s", np.zeros((40, 3)))])
    assert len(remap_vertices(still, mesh_of(POINTS + 9)).states[0]) == 0


def test_a_face_whose_numbers_fit_is_left_as_it_is_and_another_is_renumbered():
    own = face()
    assert matched(own, mesh_of(POINTS)) is own
    assert matched(own, mesh_of(POINTS[::-1])).states[0].numbers.tolist() == [*range(10, 40)]
    assert matched(own, mesh_of(np.vstack((POINTS[30:], POINTS[:30])))).numbers.tolist() == [*range(10, 40)]


@given(
    points=hnp.arrays(np.float32, (12, 3), elements=st.floats(-2, 2, width=32)),
    steps=hnp.arrays(np.float32, (12, 3), elements=st.sampled_from([0, 0.25, -0.25, 0.5])),
)
def test_a_vertex_is_wherever_another_is_within_the_tolerance(
    points: NDArray[np.float32], steps: NDArray[np.float32]
) -> None:
    mesh = mesh_of(np.vstack((points, points + steps)))
    targets = morph_targets_of(mesh_of(points), [movestate_of("a", np.ones((12, 3)))])
    apart = np.linalg.norm(points[:, np.newaxis].astype(float) - mesh.positions, axis=2)
    assert remap_vertices(targets, mesh, 0.3).numbers.tolist() == np.flatnonzero((apart <= 0.3).any(axis=0)).tolist()
