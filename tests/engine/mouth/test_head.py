from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import MeshError
from phonemeengine.mouth.head import HEAD, load_head
from phonemeengine.mouth.morph_mesh import MorphMesh
from phonemeengine.mouth.movestate import MovestateSet
from phonemeengine.mouth.table import load_table
from phonemeengine.performance.poses import load_poses
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.table import load_pinyin_table


@pytest.fixture(scope="module")
def morph_mesh() -> MorphMesh:
    return load_head()


def colour_of(morph_mesh: MorphMesh, where: np.ndarray) -> np.ndarray:
    """The mean colour of some vertices."""
    return morph_mesh.mesh.colours[where].mean(axis=0)


def width(positions: np.ndarray, where: np.ndarray) -> float:
    """How far some vertices reach from left to right."""
    return float(np.ptp(positions[where, 0]))


def test_the_head_has_the_52_shapes_of_arkit_and_all_of_them_move(morph_mesh: MorphMesh):
    assert len(morph_mesh.states) == 52
    assert {"jawOpen", "mouthClose", "mouthPucker", "eyeBlinkLeft", "tongueOut"} < {s.name for s in morph_mesh.states}
    assert all(len(state) > 100 for state in morph_mesh.states)


def test_the_file_is_small_and_holds_nothing_that_is_executed():
    assert HEAD.stat().st_size < 400_000
    with np.load(HEAD, allow_pickle=False) as file:
        assert all(file[name].dtype != object for name in file.files)


def test_the_head_is_closed_so_that_no_one_looks_into_the_neck(morph_mesh: MorphMesh):
    """Each edge of skin and neck has two sides; eyes and teeth are open behind, where nobody looks."""
    with np.load(HEAD, allow_pickle=False) as file:
        part = file["part"]
    triangles = morph_mesh.mesh.triangles[(part == 0)[morph_mesh.mesh.triangles].all(axis=1)]
    _, places = np.unique(morph_mesh.mesh.positions, axis=0, return_inverse=True)
    edges = np.sort(places[np.concatenate([triangles[:, (k, (k + 1) % 3)] for k in range(3)])], axis=1)
    _, sides = np.unique(edges, axis=0, return_counts=True)
    assert np.all(sides == 2)


def test_the_neck_ends_in_shoulders_that_stand_still(morph_mesh: MorphMesh):
    positions = morph_mesh.mesh.positions
    shirt = positions[:, 1] < -1.3
    neck = positions[(positions[:, 1] > -0.8) & (positions[:, 1] < -0.6)]
    assert np.ptp(positions[shirt, 0]) > 2 * np.ptp(positions[positions[:, 1] > 0, 0])
    assert np.ptp(positions[shirt, 0]) > 2.5 * np.ptp(neck[:, 0])
    assert abs(positions[shirt, 0].max() + positions[shirt, 0].min()) < 0.1
    for state in morph_mesh.states:
        assert not np.isin(np.flatnonzero(shirt), state.numbers).any() or not np.any(
            state.offsets[np.isin(state.numbers, np.flatnonzero(shirt))]
        )


def test_the_skull_is_round(morph_mesh: MorphMesh):
    """Nowhere does the arc over an edge rise by more than a third of a millimetre, a pixel of a large window."""
    mesh = morph_mesh.mesh
    a, b = np.concatenate([mesh.triangles[:, (k, (k + 1) % 3)] for k in range(3)]).T
    skull = (mesh.positions[a, 1] > 0.7) & (mesh.positions[b, 1] > 0.7)
    turned = np.arccos(np.clip((mesh.normals[a] * mesh.normals[b]).sum(axis=1), -1, 1))
    arcs = turned * np.linalg.norm(mesh.positions[a] - mesh.positions[b], axis=1) / 8
    assert skull.sum() > 500
    assert arcs[skull].max() < 0.0045


def test_it_looks_to_the_front_and_stands_upright(morph_mesh: MorphMesh):
    positions = morph_mesh.mesh.positions
    nose = positions[positions[:, 2].argmax()]
    assert abs(nose[0]) < 0.05
    assert positions[:, 1].max() > 1 > nose[1]


def test_eyes_have_a_dark_pupil_a_blue_iris_and_a_white(morph_mesh: MorphMesh):
    with np.load(HEAD, allow_pickle=False) as file:
        eye = file["part"] == 1
    positions = morph_mesh.mesh.positions
    centre = (positions[eye].min(axis=0) + positions[eye].max(axis=0)) / 2
    from_axis = np.hypot(*(positions - centre)[:, :2].T)
    front = eye & (positions[:, 2] > centre[2])
    pupil = colour_of(morph_mesh, front & (from_axis < 0.028))
    iris = colour_of(morph_mesh, front & (from_axis > 0.035) & (from_axis < 0.06))
    white = colour_of(morph_mesh, front & (from_axis > 0.08))
    assert pupil.max() < 0.1
    assert iris[2] > iris[0] + 0.1
    assert white.min() > 0.85


def test_lips_are_redder_than_the_cheeks(morph_mesh: MorphMesh):
    positions, colours = morph_mesh.mesh.positions, morph_mesh.mesh.colours
    redness = colours[:, 0] - colours[:, 1]
    mouth = np.linalg.norm(positions - positions[np.argmax(redness * (positions[:, 2] > 1.3))], axis=1) < 0.1
    cheek = (np.abs(np.abs(positions[:, 0]) - 0.5) < 0.1) & (positions[:, 2] > 0.8) & (np.abs(positions[:, 1]) < 0.1)
    assert redness[mouth & (positions[:, 2] > 1.25)].max() > redness[cheek].mean() + 0.08


def test_an_open_jaw_lowers_the_lower_teeth_and_a_smile_widens_the_mouth(morph_mesh: MorphMesh):
    with np.load(HEAD, allow_pickle=False) as file:
        lower, upper = file["part"] == 2, file["part"] == 5
    states = MovestateSet(morph_mesh.mesh, morph_mesh.states)
    rest = states.morphed().copy()
    states.set_percentage("jawOpen", 100)
    moved = states.morphed() - rest
    assert moved[lower, 1].mean() < -0.15
    assert np.abs(moved[upper]).max() < 0.01
    states.reset_all()
    smiles = [state for state in morph_mesh.states if state.name.startswith("mouthSmile")]
    corners = np.intersect1d(*(state.numbers for state in smiles))
    states.set_percentages({state.name: 100 for state in smiles})
    assert width(states.morphed(), corners) > width(rest, corners)


def shapes_of_f() -> dict[str, Mapping[str, float]]:
    """The shapes of f and v that all tables have, by the table's name."""
    tables = {"arkit": "f", "rhubarb": "G", "preston-blair": "FV"}
    shapes = {table: load_table(table).shapes[name] for table, name in tables.items()}
    return {**shapes, "pinyin": load_pinyin_table().mouth.shapes["f"], "poses": load_poses().shapes["teeth"]}


@pytest.mark.parametrize("table", shapes_of_f())
def test_for_f_the_lower_lip_meets_the_upper_teeth(table: str, morph_mesh: MorphMesh):
    """In steps from the left to the right canine: within a millimetre and a half, where a unit is a decimetre."""
    arkit = load_table("arkit")
    m = arkit.shapes[arkit.phonemes[Phoneme.M]]
    assert lip_to_teeth(morph_mesh, positions_of(morph_mesh, shapes_of_f()[table])).mean() < 0.015
    assert lip_to_teeth(morph_mesh, positions_of(morph_mesh, m)).mean() > 0.04


def positions_of(morph_mesh: MorphMesh, percentages: Mapping[str, float]) -> np.ndarray:
    """Where the vertices are in a mouth shape."""
    face = MovestateSet(morph_mesh.mesh, morph_mesh.states)
    face.set_percentages(dict(percentages))
    return face.morphed().copy()


def lip_to_teeth(morph_mesh: MorphMesh, positions: np.ndarray) -> np.ndarray:
    """How far the lower lip is from the edges of the upper teeth, in steps from left to right."""
    with np.load(HEAD, allow_pickle=False) as file:
        upper = file["part"] == 5
        rolls = (
            np.linalg.norm(file["offsets"][file["names"].tolist().index("mouthRollLower")].astype(float), axis=1)
            > 0.03
        )
    triangles = morph_mesh.mesh.triangles.astype(int)
    inside = np.array([(i, k, 8 - i - k) for i in range(9) for k in range(9 - i)]) / 8
    teeth, lip = (
        np.einsum("wk,tkd->twd", inside, positions[triangles[part[triangles].all(axis=1)]]).reshape(-1, 3)
        for part in (upper, rolls)
    )
    apart = []
    for x in np.linspace(-0.1, 0.1, 9):
        tooth, skin = (points[np.abs(points[:, 0] - x) < 0.012] for points in (teeth, lip))
        edge = tooth[tooth[:, 1] < tooth[:, 1].min() + 0.02]
        apart.append(np.linalg.norm(edge[:, np.newaxis] - skin, axis=2).min())
    return np.array(apart)


def test_eyes_and_brows_live_their_own_life(morph_mesh: MorphMesh):
    own = {state.name for state in morph_mesh.states if not state.interactable}
    assert {"eyeBlinkLeft", "browInnerUp"} < own
    assert not {"jawOpen", "mouthSmileLeft", "cheekPuff"} & own


def test_a_damaged_installation_says_so(tmp_path: Path):
    (tmp_path / "head.npz").write_bytes(HEAD.read_bytes()[:1000])
    for path in (tmp_path / "head.npz", tmp_path / "missing.npz"):
        with pytest.raises(MeshError, match="the program's own head cannot be read; install the program again"):
            load_head(path)
