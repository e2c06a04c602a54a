"""The head of an exported face turns as its pose says, wherever it hangs in the scene."""

import json
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from phonemeengine.errors import ExportError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.gltf import read_face
from phonemeengine.mouth.exports.gltf_rotation import rotations_of, turnings_of
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.expression.streams import held_expression
from phonemeengine.mouth.face_mapping import guess_mapping, mapped_table
from phonemeengine.mouth.idle_motion import DOWN, SIDEWAYS, UP
from phonemeengine.mouth.performer import IdleMotion
from phonemeengine.mouth.table import table_to_toml
from tests.avatars import HEAD, JAW, LEFT_EYE, RIGHT_EYE, avatar
from tests.engine.mouth.speaking import speech
from tests.glb_faces import face_with_targets

Numbers = NDArray[np.float64]
RATE = 30.0
FORMS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
ABOUT_X = [float(np.sin(0.4)), 0.0, 0.0, float(np.cos(0.4))]


class Scene:
    """A GLB with its animation, read as the specification says, and nothing of the program's."""

    def __init__(self, content: bytes) -> None:
        length = int.from_bytes(content[12:16], "little")
        self.document = json.loads(content[20 : 20 + length])
        self.binary = content[28 + length :]
        self.animation = self.document["animations"][-1]

    def values(self, accessor: int) -> NDArray[np.float32]:
        form = self.document["accessors"][accessor]
        view = self.document["bufferViews"][form["bufferView"]]
        width = FORMS[form["type"]]
        begin = view.get("byteOffset", 0) + form.get("byteOffset", 0)
        return np.frombuffer(self.binary, "<f4", form["count"] * width, begin).reshape(-1, width)

    def track(self, node: int, path: str) -> NDArray[np.float32] | None:
        for channel in self.animation["channels"]:
            if channel["target"] == {"node": node, "path": path}:
                return self.values(self.animation["samplers"][channel["sampler"]]["output"])
        return None

    def matrix(self, node: int, frame: int) -> Numbers:
        """Where a node puts its children in the scene, at a frame."""
        form = self.document["nodes"][node]
        if "matrix" in form:
            own = np.array(form["matrix"], float).reshape(4, 4).T
        else:
            parts = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]} | form
            tracks = {path: self.track(node, path) for path in ("translation", "rotation")}
            place, turn = (
                np.array(parts[path] if track is None else track[frame], float) for path, track in tracks.items()
            )
            own = np.eye(4)
            own[:3, :3] = Rotation.from_quat(turn).as_matrix() * parts["scale"]
            own[:3, 3] = place
        above = [k for k, other in enumerate(self.document["nodes"]) if node in other.get("children", [])]
        return self.matrix(above[0], frame) @ own if above else own


def exported(mesh: Path | None = None, *, head: bool = True) -> Scene:
    (content,) = Exporter("gltf", ExportOptions(rate=RATE, mesh=mesh, idle=IdleMotion(head=head))).chunks_of(speech())
    return Scene(content)


def poses() -> Rotation:
    """Yaw, pitch and roll as another format holds them, as rotations of the scene."""
    animation = Exporter("curves-json", ExportOptions(rate=RATE)).export_of(speech()).animation
    return rotations_of(animation.head)


def face(folder: Path, nodes: list[dict[str, object]], **more: object) -> Path:
    (folder / "plain.glb").write_bytes(face_with_targets(ARKIT))
    glb = read_face(folder / "plain.glb")
    glb.document["nodes"] = nodes
    below = {child for node in nodes for child in node.get("children", [])}
    glb.document["scenes"] = [{"nodes": [k for k in range(len(nodes)) if k not in below]}]
    glb.document |= more
    (folder / "face.glb").write_bytes(glb.content())
    return folder / "face.glb"


def turns_about(scene: Scene, still: Scene, node: int, pivot: Numbers) -> None:
    """Every point that hangs on the node turns about the pivot (of the scene) as the pose of each frame says."""
    turns = poses()
    for frame in range(0, len(turns), 7):
        for point in np.array([[0, 0, 0, 1], [1, 0, 0, 1], [0, 2, -3, 1]], float):
            rest = (still.matrix(node, frame) @ point)[:3]
            expected = pivot + turns[frame].apply(rest - pivot)
            np.testing.assert_allclose((scene.matrix(node, frame) @ point)[:3], expected, atol=2e-5)


def test_yaw_pitch_and_roll_turn_to_the_left_upwards_and_to_the_left_shoulder() -> None:
    """The head looks along z, its left is x, above it is y."""
    yaw, pitch, roll = rotations_of(np.array([[10, 0, 0], [0, 10, 0], [0, 0, 10]], np.float32))
    forwards, upwards = np.array([0.0, 0, 1]), np.array([0.0, 1, 0])
    sine, cosine = np.sin(np.radians(10)), np.cos(np.radians(10))
    np.testing.assert_allclose(yaw.apply(forwards), [sine, 0, cosine], atol=1e-7)
    np.testing.assert_allclose(pitch.apply(forwards), [0, sine, cosine], atol=1e-7)
    np.testing.assert_allclose(roll.apply(upwards), [sine, cosine, 0], atol=1e-7)


def test_the_programs_own_head_nods_about_its_neck_and_blinks() -> None:
    scene, still = exported(), exported(head=False)
    assert [channel["target"]["path"] for channel in scene.animation["channels"]] == ["weights", "rotation"]
    assert [channel["target"]["path"] for channel in still.animation["channels"]] == ["weights"]
    turns_about(scene, still, 0, np.zeros(3))
    rotations = scene.track(0, "rotation")
    assert rotations is not None
    np.testing.assert_allclose(np.linalg.norm(rotations, axis=1), 1, atol=1e-6)
    assert np.ptp(rotations[:, 0]) > np.radians(0.5)  # it nods by more than a degree
    assert all(one @ other > 0.99 for one, other in pairwise(rotations))
    names = scene.document["meshes"][0]["extras"]["targetNames"]
    weights = scene.track(0, "weights").reshape(-1, len(names))
    assert weights[:, names.index("jawOpen")].max() > 0.3


def test_a_blink_is_in_the_weights() -> None:
    idle = IdleMotion(seed=next(seed for seed in range(50) if _lids(seed).max() > 0.9))
    (content,) = Exporter("gltf", ExportOptions(rate=RATE, idle=idle)).chunks_of(speech())
    scene = Scene(content)
    names = scene.document["meshes"][0]["extras"]["targetNames"]
    weights = scene.track(0, "weights").reshape(-1, len(names))
    np.testing.assert_allclose(weights[:, names.index("eyeBlinkLeft")], _lids(idle.seed), atol=1e-6)


def _lids(seed: int) -> NDArray[np.float32]:
    movement = (
        Exporter("livelink-csv", ExportOptions(rate=RATE, idle=IdleMotion(seed=seed))).export_of(speech()).animation
    )
    return movement.weights[:, ARKIT.index("eyeBlinkLeft")]


MATRIX = np.array([[0, -2, 0, 5], [2, 0, 0, 6], [0, 0, 2, 7], [0, 0, 0, 1]], float)
PLACES: dict[str, dict[str, object]] = {
    "at the origin": {},
    "somewhere": {"translation": [1, 2, 3], "rotation": ABOUT_X, "scale": [1, 2, 3]},
    "with a matrix": {"matrix": MATRIX.T.ravel().tolist()},
    "mirrored": {"matrix": (MATRIX @ np.diag([-1.0, 1, 1, 1])).T.ravel().tolist()},
}


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize(
    "above", [{}, {"rotation": ABOUT_X, "translation": [0, 1, 0]}, {"matrix": MATRIX.T.ravel().tolist()}]
)
def test_a_face_by_itself_turns_about_the_middle_of_its_lower_edge(
    place: str, above: dict[str, object], tmp_path: Path
) -> None:
    mesh = face(tmp_path, [{"mesh": 0, **PLACES[place]}, {"children": [0], **above}])
    scene, still = exported(mesh), exported(mesh, head=False)
    turns_about(scene, still, 0, (still.matrix(0, 0) @ [0.5, 0, 0, 1])[:3])


def test_parts_of_a_head_turn_with_it_once(tmp_path: Path) -> None:
    nodes = [
        {"name": "body", "children": [1]},
        {"name": "Armature:Head", "children": [2, 3], "translation": [0, 1.6, 0], "rotation": ABOUT_X},
        {"name": "skin", "mesh": 0},
        {"name": "teeth", "mesh": 0, "translation": [0, -0.1, 0]},
    ]
    mesh = face(tmp_path, nodes)
    scene, still = exported(mesh), exported(mesh, head=False)
    turned = [c["target"]["node"] for c in scene.animation["channels"] if c["target"]["path"] != "weights"]
    assert turned == [1]
    for part in (2, 3):
        turns_about(scene, still, part, np.array([0, 1.6, 0]))


def test_a_face_on_bones_turns_with_the_bone_of_the_head(tmp_path: Path) -> None:
    bones = [
        {"name": "mesh", "mesh": 0, "skin": 0},
        {"name": "mixamorig:Neck", "children": [2], "translation": [0, 1.5, 0], "rotation": ABOUT_X},
        {"name": "mixamorig:Head", "translation": [0, 0.2, 0], "children": [3]},
        {"name": "mixamorig:HeadTop_End"},
    ]
    mesh = face(tmp_path, bones, skins=[{"joints": [1, 2, 3]}])
    scene, still = exported(mesh), exported(mesh, head=False)
    turned = [c["target"] for c in scene.animation["channels"] if c["target"]["path"] != "weights"]
    assert turned == [{"node": 2, "path": "rotation"}]
    turns_about(scene, still, 3, still.matrix(2, 0)[:3, 3])


def test_a_face_on_bones_without_a_head_speaks_and_stays(tmp_path: Path) -> None:
    mesh = face(tmp_path, [{"mesh": 0, "skin": 0}, {"name": "root"}], skins=[{"joints": [1]}])
    assert [c["target"]["path"] for c in exported(mesh).animation["channels"]] == ["weights"]


@pytest.mark.parametrize("version", [0, 1])
def test_bones_of_an_avatar_move_jaw_eyes_and_head_whichever_way_it_faces(version: int, tmp_path: Path) -> None:
    path, table = tmp_path / "avatar.vrm", tmp_path / "own.toml"
    path.write_bytes(avatar(version, only=("mouthPucker",)))
    looks = [f"eyeLook{way}{side}" for side in ("Left", "Right") for way in ("Up", "Down", "Out", "In")]
    mapping = guess_mapping(["mouthPucker", "bone jawOpen", *(f"bone {name}" for name in looks)], "arkit")
    table.write_text(table_to_toml(mapped_table(mapping, "own")), encoding="utf-8")
    gaze = {"eyeLookUpLeft": 0.4, "eyeLookOutLeft": 0.5, "eyeLookDownRight": 0.3, "eyeLookInRight": 0.6}
    options = ExportOptions(rate=RATE, idle=IdleMotion(expression=Expression((held_expression(gaze),))))
    own = replace(options, mesh=path, table=str(table))
    scene = Scene(b"".join(Exporter("gltf", own).chunks_of(speech())))
    movement = Exporter("livelink-csv", options).export_of(speech()).animation
    jaw, opened = scene.track(JAW, "rotation"), movement.weights[:, ARKIT.index("jawOpen")]
    assert jaw is not None
    assert opened.max() > 0.3
    np.testing.assert_allclose(Rotation.from_quat(jaw).as_rotvec(degrees=True)[:, 0], 20 * opened, atol=0.02)
    for bone, first, outwards in ((LEFT_EYE, 0, 1), (RIGHT_EYE, 4, -1)):
        eye = scene.track(bone, "rotation")
        up, down, out, into = movement.weights[:, [ARKIT.index(name) for name in looks[first : first + 4]]].T
        assert eye is not None
        assert up.max() + down.max() > 0.25
        assert out.max() + into.max() > 0.4
        angles = np.stack([DOWN * down - UP * up, outwards * SIDEWAYS * (out - into)], axis=1)
        np.testing.assert_allclose(Rotation.from_quat(eye).as_rotvec(degrees=True)[:, :2], angles, atol=0.05)
    facing, frame = Rotation.from_euler("Y", 0 if version else 180, degrees=True), len(opened) // 2
    turned = facing * poses()[frame]
    np.testing.assert_allclose(scene.matrix(HEAD, frame)[:3, :3], turned.as_matrix(), atol=1e-5)


def test_axes_that_are_not_at_right_angles_stay(tmp_path: Path) -> None:
    sheared = np.eye(4)
    sheared[0, 1] = 0.5
    mesh = face(tmp_path, [{"mesh": 0, "matrix": sheared.T.ravel().tolist()}])
    scene = exported(mesh)
    assert [c["target"]["path"] for c in scene.animation["channels"]] == ["weights"]
    assert scene.document["nodes"][0]["matrix"] == sheared.T.ravel().tolist()


@pytest.mark.parametrize(
    "nodes",
    [
        [{"mesh": 0, "rotation": "round"}],
        [{"mesh": 0, "rotation": [0, 0, 1]}],
        [{"mesh": 0, "matrix": [1, 2, 3]}],
        [{"mesh": 0, "skin": 4}],
        [{"mesh": 0, "children": [0]}],
        [{"mesh": 0, "translation": [1e400, 0, 0]}],
        [{"mesh": 0, "translation": [1e300, 0, 0]}],
    ],
)
def test_a_damaged_scene_is_refused_in_one_sentence(nodes: list[dict[str, object]], tmp_path: Path) -> None:
    with pytest.raises(ExportError, match="damaged glTF file"):
        turnings_of(read_face(face(tmp_path, nodes)).document, [0], rotations_of(np.ones((3, 3), np.float32)))
