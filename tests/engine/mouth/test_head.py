from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import MeshError
from phonemeengine.mouth.blendshape_names import ARKIT, TONGUE
from phonemeengine.mouth.morph_mesh import USUAL_HEAD, Head, MorphMesh, load_head
from phonemeengine.mouth.movestate import MovestateSet
from phonemeengine.mouth.poses import load_poses
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.table import load_pinyin_table

PARTS = ("skin", "left eye", "lower teeth", "right eye", "tongue", "upper teeth", "hair", "brows and lashes")


@pytest.fixture(scope="module", params=[*Head])
def head(request: pytest.FixtureRequest) -> Head:
    return Head(request.param)


@pytest.fixture(scope="module")
def morph_mesh(head: Head) -> MorphMesh:
    return load_head(head)


@pytest.fixture(scope="module")
def part(head: Head) -> np.ndarray:
    """What each vertex belongs to, a place in PARTS."""
    with np.load(head.path, allow_pickle=False) as file:
        return file["part"]


def colour_of(morph_mesh: MorphMesh, where: np.ndarray) -> np.ndarray:
    """The mean colour of some vertices."""
    return morph_mesh.mesh.colours[where].mean(axis=0)


def width(positions: np.ndarray, where: np.ndarray) -> float:
    """How far some vertices reach from left to right."""
    return float(np.ptp(positions[where, 0]))


def test_the_head_has_the_shapes_of_arkit_and_of_the_tongue_and_all_of_them_move(morph_mesh: MorphMesh):
    assert {state.name for state in morph_mesh.states} == {*ARKIT, *TONGUE}
    assert all(len(state) > 80 for state in morph_mesh.states)


def test_the_file_is_small_and_holds_nothing_that_is_executed(head: Head):
    assert head.path.stat().st_size < 400_000
    with np.load(head.path, allow_pickle=False) as file:
        assert all(file[name].dtype != object for name in file.files)


def test_both_heads_are_two_people_with_the_same_shapes():
    woman, man = load_head(Head.WOMAN), load_head(str(Head.MAN))
    assert [state.name for state in woman.states] == [state.name for state in man.states]
    assert np.ptp(man.mesh.positions[:, 0]) > 1.1 * np.ptp(woman.mesh.positions[:, 0])
    assert (woman.mesh.name, man.mesh.name) == ("woman", "man")
    assert load_head().mesh.name == USUAL_HEAD


def test_proportions_are_those_of_people(morph_mesh: MorphMesh, part: np.ndarray):
    """A face between its cheekbones is narrower than high, and an eye is a fifth of a head wide."""
    positions = morph_mesh.mesh.positions
    skin = positions[(part == 0) & (positions[:, 1] > -0.75)]
    face = skin[(skin[:, 2] > 0.6) & (np.abs(skin[:, 1] - 0.45) < 0.1)]
    chin = skin[(skin[:, 2] > 0.9) & (np.abs(skin[:, 0]) < 0.05), 1].min()
    assert 0.55 < np.ptp(face[:, 0]) / (positions[part == 6, 1].max() - chin) < 0.75
    eyes = [positions[part == PARTS.index(f"{side} eye")] for side in ("left", "right")]
    apart = eyes[0][:, 0].mean() - eyes[1][:, 0].mean()
    assert 0.55 < apart < 0.70  # the middle of people is 0.63


def test_the_neck_ends_in_shoulders_that_stand_still(morph_mesh: MorphMesh):
    positions = morph_mesh.mesh.positions
    shirt = positions[:, 1] < -1.4
    neck = positions[(positions[:, 1] > -0.8) & (positions[:, 1] < -0.6) & (np.abs(positions[:, 0]) < 0.7)]
    assert np.ptp(positions[shirt, 0]) > 2 * np.ptp(neck[:, 0])
    assert abs(positions[shirt, 0].max() + positions[shirt, 0].min()) < 0.1
    assert not any(
        np.any(state.offsets[np.isin(state.numbers, np.flatnonzero(shirt))]) for state in morph_mesh.states
    )


def test_it_looks_to_the_front_and_stands_upright(morph_mesh: MorphMesh):
    positions = morph_mesh.mesh.positions
    nose = positions[positions[:, 2].argmax()]
    assert abs(nose[0]) < 0.05
    assert positions[:, 1].max() > 1 > nose[1]


def test_pupils_are_round_and_dark_amid_an_iris_and_a_white(morph_mesh: MorphMesh, part: np.ndarray):
    positions, colours = morph_mesh.mesh.positions, morph_mesh.mesh.colours
    eye = part == PARTS.index("left eye")
    centre = (positions[eye].min(axis=0) + positions[eye].max(axis=0)) / 2
    pupil = eye & (colours.max(axis=1) < 0.1)
    from_axis = np.hypot(*(positions[pupil] - positions[pupil].mean(axis=0))[:, :2].T)
    edge = from_axis[from_axis > 0.5 * from_axis.max()]
    assert len(edge) >= 24
    assert np.ptp(edge) < 0.02 * edge.mean()
    white = colour_of(morph_mesh, eye & (np.hypot(*(positions - centre)[:, :2].T) > 0.1) & (positions[:, 2] > 1.05))
    assert white.min() > 0.8


def test_lips_are_redder_than_the_cheeks(morph_mesh: MorphMesh):
    positions, colours = morph_mesh.mesh.positions, morph_mesh.mesh.colours
    redness = colours[:, 0] - colours[:, 1]
    mouth = np.linalg.norm(positions - positions[np.argmax(redness * (positions[:, 2] > 1.3))], axis=1) < 0.1
    cheek = (np.abs(np.abs(positions[:, 0]) - 0.5) < 0.1) & (positions[:, 2] > 0.8) & (np.abs(positions[:, 1]) < 0.1)
    assert redness[mouth & (positions[:, 2] > 1.25)].max() > redness[cheek].mean() + 0.08


def test_an_open_jaw_lowers_the_lower_teeth_and_a_smile_widens_the_mouth(morph_mesh: MorphMesh, part: np.ndarray):
    lower, upper = part == 2, part == 5
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
def test_for_f_the_lower_lip_meets_the_upper_teeth(table: str, morph_mesh: MorphMesh, part: np.ndarray):
    """In steps from the left to the right canine: within a millimetre and a half, where a unit is a decimetre."""
    arkit = load_table("arkit")
    m = arkit.shapes[arkit.phonemes[Phoneme.M]]
    assert lip_to_teeth(morph_mesh, part, positions_of(morph_mesh, shapes_of_f()[table])).mean() < 0.015
    assert lip_to_teeth(morph_mesh, part, positions_of(morph_mesh, m)).mean() > 0.03


def positions_of(morph_mesh: MorphMesh, percentages: Mapping[str, float]) -> np.ndarray:
    """Where the vertices are in a mouth shape."""
    face = MovestateSet(morph_mesh.mesh, morph_mesh.states)
    face.set_percentages(dict(percentages))
    return face.morphed().copy()


def lip_to_teeth(morph_mesh: MorphMesh, part: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """How far the lower lip is from the edges of the upper teeth, in steps from left to right."""
    upper, rolls = part == 5, moved_by(morph_mesh, "mouthRollLower", 0.03)
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


def moved_by(morph_mesh: MorphMesh, name: str, least: float) -> np.ndarray:
    """Which vertices a state moves by more than so many decimetres."""
    state = next(state for state in morph_mesh.states if state.name == name)
    moved = np.zeros(len(morph_mesh.mesh), bool)
    moved[state.numbers[np.linalg.norm(state.offsets, axis=1) > least]] = True
    return moved


SEALED = ({}, load_table("arkit").shapes["m"], load_table("arkit").shapes["p"], load_table("rhubarb").shapes["A"])


@pytest.mark.parametrize("shape", SEALED, ids=["rest", "m", "p", "rhubarb A"])
def test_closed_lips_hide_teeth_and_tongue(shape: Mapping[str, float], morph_mesh: MorphMesh, part: np.ndarray):
    """From the front, no ray that goes through the mouth's line meets anything but skin."""
    positions = positions_of(morph_mesh, shape)
    lips = moved_by(morph_mesh, "mouthRollLower", 0.02) | moved_by(morph_mesh, "mouthRollUpper", 0.02)
    low, high = positions[lips & (part == 0)].min(axis=0), positions[lips & (part == 0)].max(axis=0)
    triangles = morph_mesh.mesh.triangles.astype(int)
    x, y = np.meshgrid(np.linspace(0.8 * low[0], 0.8 * high[0], 13), np.arange(low[1], high[1], 0.006))
    seen = first_part(positions, triangles, part, np.column_stack((x.ravel(), y.ravel())))
    assert {*seen.tolist()} <= {0}


def test_a_tongue_shows_for_th_and_lies_behind_the_teeth_otherwise(morph_mesh: MorphMesh, part: np.ndarray):
    arkit, tongue, teeth = load_table("arkit"), part == 4, part == 5
    for name, shape in arkit.shapes.items():
        positions = positions_of(morph_mesh, shape)
        ahead = positions[tongue, 2].max() - positions[teeth, 2].max()
        assert ahead > 0.01 if name == "th" else ahead < 0.03, name


def first_part(positions: np.ndarray, triangles: np.ndarray, part: np.ndarray, places: np.ndarray) -> np.ndarray:
    """The part that is seen at each place from far along z."""
    corners = positions[triangles].astype(float)
    near = np.all(
        (corners[..., :2].max(axis=1) > places.min(axis=0)) & (corners[..., :2].min(axis=1) < places.max(axis=0)),
        axis=1,
    )
    corners, numbers = corners[near], part[triangles[near, 0]]
    lowest, highest = corners[..., :2].min(axis=1), corners[..., :2].max(axis=1)
    seen = np.zeros(len(places), int)
    for k, place in enumerate(places):
        here = np.flatnonzero(np.all((lowest <= place) & (place <= highest), axis=1))
        seen[k] = first_at(place, corners[here], numbers[here])
    return seen


def first_at(place: np.ndarray, corners: np.ndarray, numbers: np.ndarray) -> int:
    """The number of the triangle that is seen at a place; -1 for none."""
    if not len(corners):
        return -1
    a, b, c = corners[:, 0, :2], corners[:, 1, :2], corners[:, 2, :2]
    area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    flat = np.abs(area) < 1e-12
    v = ((place - a)[:, 0] * (c - a)[:, 1] - (place - a)[:, 1] * (c - a)[:, 0]) / np.where(flat, 1, area)
    w = ((b - a)[:, 0] * (place - a)[:, 1] - (b - a)[:, 1] * (place - a)[:, 0]) / np.where(flat, 1, area)
    depth = corners[:, 0, 2] * (1 - v - w) + corners[:, 1, 2] * v + corners[:, 2, 2] * w
    depth[flat | (v < 0) | (w < 0) | (v + w > 1)] = -np.inf
    return int(numbers[np.argmax(depth)]) if np.isfinite(depth).any() else -1


def test_eyes_and_brows_live_their_own_life(morph_mesh: MorphMesh):
    own = {state.name for state in morph_mesh.states if not state.interactable}
    assert {"eyeBlinkLeft", "browInnerUp"} < own
    assert not {"jawOpen", "mouthSmileLeft", "cheekPuff"} & own


def test_a_damaged_installation_says_so(tmp_path: Path):
    (tmp_path / "head.npz").write_bytes(USUAL_HEAD.path.read_bytes()[:1000])
    for path in (tmp_path / "head.npz", tmp_path / "missing.npz"):
        with pytest.raises(MeshError, match="the program's own head cannot be read; install the program again"):
            load_head(path)
