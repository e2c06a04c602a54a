"""A face with its movement as GLB, read back by pygltflib."""

import json
from base64 import b64encode
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from pygltflib import GLTF2

from phonemeengine.errors import ExportError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.gltf import read_face
from phonemeengine.mouth.files.gltf_document import chunks_of
from phonemeengine.mouth.performer import IdleMotion
from tests.engine.mouth.speaking import DURATION, speech
from tests.glb_faces import face_with_targets, glb_of

STILL = IdleMotion(blinks=False)


def animated(mesh: Path, **options: object) -> bytes:
    (content,) = Exporter("gltf", ExportOptions(mesh=mesh, idle=STILL, **options)).chunks_of(speech())
    return content


def face(folder: Path, content: bytes) -> Path:
    path = folder / "face.glb"
    path.write_bytes(content)
    return path


def floats_of(gltf: GLTF2, accessor: int) -> np.ndarray:
    """Read an accessor of scalars as the specification says."""
    form = gltf.accessors[accessor]
    view = gltf.bufferViews[form.bufferView]
    assert (form.componentType, form.type, view.buffer) == (5126, "SCALAR", 0)
    begin = (view.byteOffset or 0) + (form.byteOffset or 0)
    assert begin % 4 == 0
    return np.frombuffer(gltf.binary_blob(), "<f4", form.count, begin)


def read(content: bytes, folder: Path) -> GLTF2:
    path = folder / "read.glb"
    path.write_bytes(content)
    gltf = GLTF2().load(str(path))
    assert gltf is not None
    assert gltf.buffers[0].byteLength <= len(gltf.binary_blob())
    return gltf


def test_the_movement_is_that_of_live_link_and_its_times_rise(tmp_path: Path) -> None:
    names = ("jawOpen", "unknown", "mouthPucker", "mouthPucker_jawOpen")
    gltf = read(animated(face(tmp_path, face_with_targets(names)), rate=30.0), tmp_path)
    (animation,) = gltf.animations
    channel, sampler = animation.channels[0], animation.samplers[0]
    assert (channel.target.node, channel.target.path, sampler.interpolation) == (0, "weights", "LINEAR")
    times, weights = floats_of(gltf, sampler.input), floats_of(gltf, sampler.output).reshape(-1, 4)
    np.testing.assert_allclose(times, np.arange(int(DURATION * 30) + 1) / 30, atol=1e-6)
    form = gltf.accessors[sampler.input]
    assert (form.min, form.max) == ([0.0], [pytest.approx(float(times[-1]))])
    movement = Exporter("livelink-csv", ExportOptions(rate=30.0, idle=STILL)).export_of(speech()).animation
    np.testing.assert_allclose(weights[:, 3], weights[:, 0] * weights[:, 2], atol=1e-6)
    assert weights[:, 3].max() > 0.01
    for target, name in enumerate(names[:3]):
        expected = movement.weights[:, ARKIT.index(name)] if name in ARKIT else np.zeros(len(times))
        np.testing.assert_allclose(weights[:, target], expected, atol=1e-6)
    assert weights[:, 0].max() > 0.3


def test_the_face_itself_stays_as_it_was(tmp_path: Path) -> None:
    path = face(tmp_path, face_with_targets(("jawOpen",)))
    before, after = GLTF2().load(str(path)), read(animated(path), tmp_path)
    assert after.binary_blob()[: len(before.binary_blob())] == before.binary_blob()
    one, other = (json.loads(gltf.gltf_to_json()) for gltf in (before, after))
    for name in ("asset", "scene", "scenes", "nodes", "meshes"):
        assert one[name] == other[name]
    for name in ("accessors", "bufferViews"):
        assert one[name] == other[name][: len(one[name])]


def test_a_gltf_with_its_files_beside_it_moves_as_the_same_glb_does(tmp_path: Path) -> None:
    glb = face_with_targets(("jawOpen", "mouthPucker"))
    text, binary = chunks_of(glb)
    asunder = json.loads(text)
    first, rest = asunder["bufferViews"][0]["byteLength"], bytes(binary)
    asunder["buffers"] = [
        {"uri": "corners%20here.bin", "byteLength": first},
        {
            "uri": "data:application/octet-stream;base64," + b64encode(rest[first:]).decode(),
            "byteLength": len(rest) - first,
        },
    ]
    asunder["bufferViews"][1:] = [
        view | {"buffer": 1, "byteOffset": view["byteOffset"] - first} for view in asunder["bufferViews"][1:]
    ]
    asunder["images"] = [{"uri": "skin.png", "name": "skin"}]
    (tmp_path / "corners here.bin").write_bytes(rest[:first])
    (tmp_path / "skin.png").write_bytes(b"a picture")
    path = tmp_path / "face.gltf"
    path.write_text(json.dumps(asunder))
    found, expected = read(animated(path), tmp_path), read(animated(face(tmp_path, glb)), tmp_path)
    view = found.bufferViews[found.images[0].bufferView]
    assert found.images[0].mimeType == "image/png"
    assert found.binary_blob()[view.byteOffset :][: view.byteLength] == b"a picture"
    for view, same in zip(found.bufferViews[:3], expected.bufferViews[:3], strict=True):
        place, other = view.byteOffset or 0, same.byteOffset or 0
        assert found.binary_blob()[place : place + 36] == expected.binary_blob()[other : other + 36]
    weights = [floats_of(gltf, gltf.animations[0].samplers[0].output) for gltf in (found, expected)]
    assert (weights[0] == weights[1]).all()


def test_a_mesh_without_morph_targets_is_refused_with_the_remedy(tmp_path: Path) -> None:
    (tmp_path / "face.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    with pytest.raises(
        ExportError, match=r"^face\.obj: there are no morph targets in it; .*movestates export face\.obj"
    ):
        animated(tmp_path / "face.obj")


def test_speech_is_added_to_the_movements_that_a_face_has(tmp_path: Path) -> None:
    path = face(tmp_path, face_with_targets(("jawOpen",)))
    twice = face(tmp_path, animated(path))
    gltf = read(animated(twice), tmp_path)
    assert [animation.name for animation in gltf.animations] == ["speech", "speech"]
    one, other = (floats_of(gltf, animation.samplers[0].output) for animation in gltf.animations)
    assert (one == other).all()


def test_every_node_that_shows_the_face_moves(tmp_path: Path) -> None:
    glb = read_face(face(tmp_path, face_with_targets(("jawOpen", "mouthPucker"))))
    glb.document["nodes"] += [{"mesh": 0}, {"name": "no mesh"}]
    gltf = read(animated(face(tmp_path, glb.content())), tmp_path)
    moved = [(channel.target.node, channel.target.path) for channel in gltf.animations[0].channels]
    assert moved == [
        (0, "weights"),
        (1, "weights"),
        *((k, path) for k in (0, 1) for path in ("rotation", "translation")),
    ]


def test_numbers_begin_on_a_word_whatever_a_file_ends_with(tmp_path: Path) -> None:
    odd = GOOD[:8] + (len(GOOD) + 2).to_bytes(4, "little") + GOOD[12:] + b"\7\7"
    begin = len(GOOD) - 72 - 8  # where the chunk of the two corners and offsets of 36 bytes begins
    assert odd[begin : begin + 8] == (72).to_bytes(4, "little") + b"BIN\0"
    odd = odd[:begin] + (74).to_bytes(4, "little") + odd[begin + 4 :]
    gltf = read(animated(face(tmp_path, odd)), tmp_path)
    sampler = gltf.animations[0].samplers[0]
    times = floats_of(gltf, sampler.input)
    assert times[0] == 0
    assert (np.diff(times) > 0).all()


def document(**changes: object) -> bytes:
    glb = {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": []}], **changes}
    return glb_of(glb, b"")


GOOD = face_with_targets(("jawOpen",))
TARGETS = [{"primitives": [{"targets": [{}]}], "extras": {"targetNames": ["jawOpen"]}}]
REFUSALS = {
    "text": (b"solid cube", "this is no face that can be moved; name a .glb"),
    "empty": (b"", "this is no face that can be moved"),
    "cut off": (GOOD[:-40], "its header says version 2 and .* bytes, and it has .*; export it again"),
    "of version 1": (GOOD[:4] + b"\x01" + GOOD[5:], "its header says version 1"),
    "a chunk that lies": (GOOD[:12] + b"\xff\xff\xff\x7f" + GOOD[16:], "a part of it is said to have 21474836"),
    "no JSON": (GOOD[:20] + b"}" + GOOD[21:], "its JSON cannot be read"),
    "a list": (glb_of([], b""), "its JSON is no table"),
    "buffers outside": (document(buffers=[{"uri": "a.bin", "byteLength": 4}]), "its buffers lie outside it"),
    "accessors as number": (document(accessors=7, meshes=TARGETS), "its accessors are no list"),
    "nodes as number": (document(nodes=7), "is a damaged glTF file"),
    "a node without its mesh": (document(nodes=[{"mesh": 9}]), "is a damaged glTF file"),
    "a mesh as text": (document(meshes=["face"]), "is a damaged glTF file"),
    "targets as number": (document(meshes=[{"primitives": [{"targets": 5}]}]), "is a damaged glTF file"),
    "targets without names": (face_with_targets(None, 3), "has no morph target of the table 'ARKit 52'"),
    "targets of other names": (
        face_with_targets(("Fcl_MTH_A",)),
        "has no morph target of the table 'ARKit 52' .eyeBlink",
    ),
    "no targets": (face_with_targets(()), "has no morph target"),
}


@pytest.mark.parametrize("case", REFUSALS)
def test_a_face_that_cannot_move_is_refused_in_one_sentence(case: str, tmp_path: Path) -> None:
    content, sentence = REFUSALS[case]
    with pytest.raises(ExportError, match=sentence) as refusal:
        animated(face(tmp_path, content))
    assert str(refusal.value).isprintable()


def test_a_face_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ExportError, match=r"gone.glb: there is no such file; check its name and folder"):
        animated(tmp_path / "gone.glb")


@settings(max_examples=200, deadline=None)
@given(st.integers(0, len(GOOD) - 1), st.binary(min_size=1, max_size=8))
@example(at=32, instead=b"\xed\xa0\x80")  # half a letter in a name
def test_no_damage_to_a_face_is_more_than_refused(
    tmp_path_factory: pytest.TempPathFactory, at: int, instead: bytes
) -> None:
    path = face(tmp_path_factory.mktemp("damaged"), GOOD[:at] + instead + GOOD[at + len(instead) :])
    with suppress(ExportError):
        content = animated(path)
        assert json.loads(content[20 : 20 + int.from_bytes(content[12:16], "little")])["animations"]
