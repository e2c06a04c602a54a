"""Curves JSON comes back as it was written, and what is damaged is refused in one sentence."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from phonemeengine.conversion.work import export
from phonemeengine.errors import MouthError
from phonemeengine.mouth.curves_file import FORMAT, parse_curves, read_curves
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import load_preset
from tests.conftest import ROOT

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
GOOD: dict[str, Any] = {
    "format": FORMAT,
    "sound": "a.wav",
    "duration": 0.1,
    "rate": 20,
    "table": "arkit",
    "cues": [{"start": 0, "end": 0.1, "phoneme": "a", "shape": "a", "intensity": 0.5}],
    "curves": [{"name": "jawOpen", "values": [0, 0.5, 1]}, {"name": "mouthClose", "values": [0, 0, 0.25]}],
    "head": [{"name": "pitch", "values": [0, 1, 2]}],
}


def read(**changes: Any) -> Any:
    return parse_curves(json.dumps(GOOD | changes))


def test_curves_are_columns_by_name_and_the_head_has_three_angles() -> None:
    curves = read()
    assert curves.movestates == ("jawOpen", "mouthClose")
    np.testing.assert_array_equal(curves.weights, np.array([[0, 0], [0.5, 0], [1, 0.25]], np.float32))
    np.testing.assert_array_equal(curves.head, np.array([[0, 0, 0], [0, 1, 0], [0, 2, 0]], np.float32))
    assert (curves.cues[0].phoneme, curves.cues[0].shape, curves.cues[0].phone) == (Phoneme.A, "a", "")


def test_a_face_of_which_only_the_head_moves_has_frames_without_curves() -> None:
    assert read(curves=[]).weights.shape == (3, 0)


def test_a_head_that_stays_has_no_angles() -> None:
    assert not read(head=[]).head.any()


def test_what_was_exported_comes_back(tmp_path: Path) -> None:
    path = tmp_path / "demo.curves.json"
    export(DEMO, path, "curves-json", load_preset("thesis"))
    curves = read_curves(path)
    assert (curves.sound, curves.rate, curves.table) == ("demo.flac", 60, "ARKit 52")
    assert len(curves.weights) == len(curves.head)
    assert 0 <= len(curves.weights) / 60 - curves.duration < 0.3  # until the mouth is at rest
    assert curves.weights.max() > 0.3
    assert [cue.end for cue in curves.cues[:-1]] == [cue.start for cue in curves.cues[1:]]


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        (
            {"format": "x"},
            "a file of curves has the format 'phonemeanalyser curves 1', found 'x'; choose another file",
        ),
        ({"rate": 0}, "rate must be a number of frames a second above 0, found 0; correct it"),
        ({"more": 1}, "a file of curves cannot have an entry 'more'"),
        ({"curves": [{"name": "a", "values": [float("nan")]}]}, "values must be a list of numbers"),
        ({"curves": [*GOOD["curves"], {"name": "jawOpen", "values": []}]}, "curves names 'jawOpen' twice"),
        ({"curves": [*GOOD["curves"], {"name": "b", "values": [1]}]}, "3 values of 'jawOpen' and 1 of 'b'"),
        ({"head": [{"name": "tilt", "values": [0, 1, 2]}]}, "head knows no angle 'tilt'"),
        ({"head": [{"name": "yaw", "values": [0, 1]}]}, "head has 2 values and curves 3; export the curves again"),
        ({"cues": [GOOD["cues"][0] | {"end": -1}]}, "a cue begins before it ends"),
        ({"cues": [GOOD["cues"][0] | {"phoneme": "q"}]}, "phoneme must be one of silence"),
        ({"cues": GOOD["cues"] * 2}, "a cue begins at 0 s, before the last one ends; export the curves again"),
        ({"cues": 3}, "cues must be a list, found 3"),
    ],
)
def test_what_is_impossible_is_refused(changes: dict[str, Any], sentence: str) -> None:
    with pytest.raises(MouthError) as refused:
        read(**changes)
    assert sentence in str(refused.value)


def test_a_file_that_is_no_json_is_named(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text("{", encoding="utf-8")
    with pytest.raises(MouthError, match=r"^a\.json: this is no JSON"):
        read_curves(tmp_path / "a.json")
