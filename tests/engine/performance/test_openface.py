import re
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import CorpusError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.openface import head_turns
from phonemeengine.performance.face_csv import parse_openface, read_expression, read_face_csv
from phonemeengine.performance.recording import HEAD
from tests.engine.mouth.speaking import speech

TOP = "frame, face_id, timestamp, confidence, success, pose_Rx, pose_Ry, pose_Rz, AU12_r, AU26_r, AU25_r, AU12_c"
ROWS = (
    "1, 0, 3.000, 0.98, 1, 0.0, 0.0, 0.0, 0.0, 5.0, 1.0, 0",
    "2, 0, 3.033, 0.02, 0, 9.0, 9.0, 9.0, 5.0, 5.0, 5.0, 1",
    "3, 0, 3.067, 0.98, 1, 0.1, 0.2, 0.3, 2.5, 1.0, 1.0, 1",
)


def test_intensities_become_shapes_and_frames_without_a_face_are_left_out() -> None:
    track = parse_openface("\n".join([TOP, *ROWS]), "a.csv")
    assert track.times == pytest.approx([0, 0.067], abs=1e-6)
    moved = dict(zip(track.channels, track.weights.T.tolist(), strict=True))
    assert moved["mouthSmileLeft"] == moved["mouthSmileRight"] == pytest.approx([0, 0.5])
    assert moved["jawOpen"] == pytest.approx([1, 0.2])
    assert [moved[name][0] for name in HEAD] == pytest.approx([0, 0, 0])
    assert track.notes == ("no blend shape of ARKit is moved by AU25, which is left out",)


def test_heads_turn_by_the_rotation_that_openface_documents() -> None:
    """Its wiki: radians, R = Rx Ry Rz; its axes point to the right of a picture, downwards, and into it."""

    def about(axis: int, angle: float) -> np.ndarray:
        turned, (k, m) = np.eye(3), ((1, 2), (2, 0), (0, 1))[axis]
        turned[k, k] = turned[m, m] = np.cos(angle)
        turned[m, k], turned[k, m] = np.sin(angle), -np.sin(angle)
        return turned

    pose = np.array([[0.1, 0, 0], [0, 0.2, 0], [0, 0, 0.3], [0.35, -0.6, 0.25]])
    yaw, pitch, roll = head_turns(pose).T
    # down; to the performer's right; towards the performer's left shoulder
    assert (pitch[0], yaw[1], roll[2]) == pytest.approx(tuple(np.degrees([-0.1, -0.2, 0.3])))
    x, y, z = pose[3]
    own = np.radians([-yaw[3], -pitch[3], roll[3]])  # ours: a head rolls first, then nods, then turns
    np.testing.assert_allclose(
        about(0, x) @ about(1, y) @ about(2, z), about(1, own[0]) @ about(0, own[1]) @ about(2, own[2]), atol=1e-12
    )


def test_what_is_written_is_read_back_as_both_sides_alike(tmp_path: Path) -> None:
    exporter, path = Exporter("openface-csv", ExportOptions(rate=60.0)), tmp_path / "a.csv"
    path.write_bytes(b"".join(exporter.chunks_of(speech())))
    assert exporter.format.owns is not None
    assert exporter.format.owns(path.read_bytes())
    made = exporter.export_of(speech()).animation
    track = read_face_csv(path)
    for name, column in zip(track.channels, track.weights.T, strict=True):
        if name in HEAD:
            assert column == pytest.approx(made.head[:, HEAD.index(name)], abs=1e-3)
        elif name in {"jawOpen", "mouthPucker", "mouthFunnel", "browInnerUp"}:
            assert column == pytest.approx(made.weights[:, ARKIT.index(name)], abs=1e-4)
        elif name.startswith("mouthSmile"):
            sides = [ARKIT.index("mouthSmileLeft"), ARKIT.index("mouthSmileRight")]
            assert column == pytest.approx(made.weights[:, sides].mean(axis=1), abs=1e-4)
    assert read_expression(path).weights(0.3)[ARKIT.index("jawOpen")] == pytest.approx(
        np.interp(0.3, track.times, track.weights[:, track.channels.index("jawOpen")])
    )


@pytest.mark.parametrize(
    ("lines", "sentence"),
    [
        (["timestamp,success,gaze_0_x", "0,1,0"], "has the column timestamp and action units such as AU12_r"),
        (["timestamp,AU99_r", "0,1"], "has the column timestamp and action units"),
        ([TOP, ROWS[1]], "there is no frame with a face in it; record it again"),
        ([TOP], "there is no frame with a face in it"),
        ([TOP, ROWS[0].replace("5.0", "nan"), ROWS[2]], "all its numbers must be finite"),
        ([TOP, ROWS[0].replace("5.0", "wide"), ROWS[2]], "there must be a number in each cell"),
        ([TOP, ROWS[0].replace("5.0", "99.0"), ROWS[2]], "a blend shape's weight must lie in 0..1"),
        ([TOP, ROWS[0][:-5], ROWS[2]], "line 2: a row has 12 cells, found 11"),
        ([TOP, ROWS[2], ROWS[0]], "the times of frames must not go back"),
        ([TOP, ROWS[0], ROWS[2].replace("3.067", "4.0")], "frames may be missing for 0.1 s at most"),
    ],
)
def test_what_is_no_recording_is_refused_in_a_sentence(lines: list[str], sentence: str) -> None:
    with pytest.raises(CorpusError, match=re.escape(sentence)) as refused:
        parse_openface("\n".join(lines), "a.csv")
    assert str(refused.value).startswith("a.csv")
