from pathlib import Path

import numpy as np
import pytest

from phonemeengine import CorpusError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.performance.gltf_face import parse_gltf_face, read_gltf_face
from phonemeengine.performance.recording import HEAD
from tests.avatars import avatar
from tests.engine.mouth.speaking import DURATION, speech
from tests.engine.performance.faces import animated_face
from tests.glb_faces import face_with_targets


@pytest.mark.parametrize("interpolation", ["LINEAR", "STEP", "CUBICSPLINE"])
def test_the_weights_of_targets_with_arkits_names_are_read(interpolation: str) -> None:
    content = animated_face(["JAWOPEN", "nose", "mouthClose"], [[0, 5, 0], [0.5, 5, 1], [0.2, 5, 0]], interpolation)
    track = parse_gltf_face(content, "face.glb")
    assert track.channels == ("jawOpen", "mouthClose")
    assert track.weights == pytest.approx(np.array([[0, 0], [0.5, 1], [0.2, 0]]))
    assert track.sampled(np.array([0.25, 1.25]))[:, 0] == pytest.approx([0.25, 0.35])


def test_an_export_is_read_back(tmp_path: Path) -> None:
    path = tmp_path / "face.glb"
    exporter = Exporter("gltf", ExportOptions(rate=60.0))
    path.write_bytes(b"".join(exporter.chunks_of(speech())))
    movement = exporter.export_of(speech()).animation
    track = read_gltf_face(path)
    assert track.duration == pytest.approx(DURATION, abs=1 / 60)
    assert set(track.channels) == {*ARKIT, *HEAD}
    for name, column in zip(track.channels, track.weights.T, strict=True):
        if name in ARKIT:
            assert column == pytest.approx(movement.weights[:, ARKIT.index(name)], abs=1e-6)
        else:
            assert column == pytest.approx(movement.head[:, HEAD.index(name)], abs=1e-3)


@pytest.mark.parametrize("version", [0, 1])
def test_bones_that_turn_are_read_where_no_shape_has_their_name(version: int, tmp_path: Path) -> None:
    path = tmp_path / "avatar.vrm"
    path.write_bytes(avatar(version, only=("mouthPucker",)))
    exporter = Exporter("gltf", ExportOptions(rate=60.0, mesh=path))
    movement = exporter.export_of(speech()).animation
    track = parse_gltf_face(b"".join(exporter.chunks_of(speech())), "avatar.vrm")
    found = dict(zip(track.channels, track.weights.T, strict=True))
    for name in ("jawOpen", "mouthPucker", "eyeLookDownRight"):
        assert found[name] == pytest.approx(movement.weights[:, ARKIT.index(name)], abs=0.01)
    assert movement.weights[:, ARKIT.index("jawOpen")].max() > 0.3
    assert np.stack([found[name] for name in HEAD], axis=1) == pytest.approx(movement.head, abs=1e-3)


def test_action_units_are_read_as_the_shapes_that_they_move() -> None:
    content = animated_face(["AU12", "facs_AU45_L", "AU99", "AU26"], [[0, 0, 1, 0], [0.4, 0.5, 1, 0.2], [0] * 4])
    track = parse_gltf_face(content, "face.glb")
    rows = dict(zip(track.channels, track.weights[1], strict=True))
    assert rows == pytest.approx({"mouthSmileLeft": 0.4, "mouthSmileRight": 0.4, "eyeBlinkLeft": 0.5, "jawOpen": 0.2})


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"no glTF", "its JSON cannot be read"),
        (face_with_targets(["jawOpen"]), "no animation in it moves a blend shape of ARKit"),
        (animated_face(["nose"], [[0], [1], [0]]), "no animation in it moves a blend shape of ARKit"),
        (animated_face(["jawOpen"], [[0], [99], [0]]), "frame 2: a blend shape's weight must lie in 0..1"),
        (animated_face(["jawOpen", "nose"], [[0], [1], [0]]), "has 3 values for 2 morph targets at 3 times"),
        (animated_face(["jawOpen"], [[0], [1], [0]], output=99), "names number 99 of its accessors"),
        (animated_face(["jawOpen"], [[0], [2], [0]], input=0, output=0), "it again"),
    ],
)
def test_what_moves_no_face_is_refused_in_a_sentence(content: bytes, sentence: str) -> None:
    with pytest.raises(CorpusError, match=sentence.replace(".", r"\.")) as refused:
        parse_gltf_face(content, "face.glb")
    assert str(refused.value).startswith("face.glb")
