"""A face speaks a sound: by the program where it is installed, else by the curves beside the sound."""

import shutil
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest

from tests.blender.conftest import ROOT, value_at

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"

WITH_SOUND = int(bpy.app.build_options.audaspace)
"""1 where this Blender was built with sound."""


def strips() -> Any:
    editor = bpy.context.scene.sequence_editor
    return editor.strips if hasattr(editor, "strips") else editor.sequences


def test_the_head_speaks_the_demo(head: Any, speaking: Any) -> None:
    bpy.ops.lip_sync.speak_sound(filepath=str(DEMO))
    jaw = [value_at(head, "jawOpen", frame) for frame in range(1, 100)]
    assert max(jaw) > 0.3
    assert min(jaw) < 0.05
    heard = [(strip.type, strip.frame_start, Path(strip.sound.filepath).name) for strip in strips()]
    assert heard == [("SOUND", 1, "demo.flac")] * WITH_SOUND


def test_a_face_with_a_table_of_its_own_speaks_by_it(mouth: Any, speaking: Any) -> None:
    bpy.ops.lip_sync.new_table(table="arkit")
    for shape in mouth.data.lip_sync.shapes:
        shape.movements.clear()
    opened = next(shape for shape in mouth.data.lip_sync.shapes if shape.name == "a").movements.add()
    opened.key, opened.percent = "Bart", 90
    bpy.ops.lip_sync.speak_sound(filepath=str(DEMO))
    beard = np.array([value_at(mouth, "Bart", frame) for frame in range(1, 100)])
    assert beard.max() > 0.3
    assert (beard < 0.01).any()
    assert value_at(mouth, "JawOpen", 50) == 0


def test_a_sound_that_is_spoken_again_is_played_once(head: Any, speaking: Any) -> None:
    for _ in range(2):
        bpy.ops.lip_sync.speak_sound(filepath=str(DEMO))
    assert len(strips()) == WITH_SOUND


def test_without_the_program_the_file_beside_the_sound_counts(head: Any, speaking: Any, tmp_path: Path) -> None:
    sound = Path(shutil.copy(DEMO, tmp_path))
    speaking.program = "no-such-program"
    (tmp_path / "demo.curves.json").write_text(
        '{"format": "phonemeanalyser curves 1", "sound": "demo.flac", "duration": 1, "rate": 25, "table": "arkit", '
        '"cues": [], "curves": [{"name": "jawOpen", "values": [0, 0.75, 0]}], "head": []}',
        encoding="utf-8",
    )
    bpy.ops.lip_sync.speak_sound(filepath=str(sound))
    assert value_at(head, "jawOpen", 2) == 0.75


def test_with_neither_there_is_one_sentence_and_the_face_stays(head: Any, speaking: Any, tmp_path: Path) -> None:
    sound = Path(shutil.copy(DEMO, tmp_path))
    speaking.program = "no-such-program"
    with pytest.raises(
        RuntimeError, match=r"not installed, and there is no demo\.curves\.json beside the sound; name"
    ):
        bpy.ops.lip_sync.speak_sound(filepath=str(sound))
    assert head.data.shape_keys.animation_data is None or head.data.shape_keys.animation_data.action is None
    assert bpy.context.scene.sequence_editor is None


def test_what_the_program_refuses_is_said(head: Any, speaking: Any, tmp_path: Path) -> None:
    (tmp_path / "a.wav").write_bytes(b"RIFF")
    with pytest.raises(RuntimeError, match=r"a\.wav: .*[a-z]"):
        bpy.ops.lip_sync.speak_sound(filepath=str(tmp_path / "a.wav"))
    assert bpy.context.scene.sequence_editor is None
