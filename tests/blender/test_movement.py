"""Curves and cues move shape keys at the times and by the weights that their files say."""

import json
from pathlib import Path
from random import Random
from typing import Any

import bpy
import numpy as np
import pytest
from mathutils import Vector

from phonemeengine.mouth.blendshape_names import ARKIT, LIVE_LINK_COLUMNS
from tests.blender.conftest import value_at

STEP = 5
"""Frames of Blender between two values: 25 frames a second against 5."""
CUES = [
    {"start": 0.0, "end": 0.4, "phoneme": "silence", "shape": "silence", "intensity": 0.0},
    {"start": 0.4, "end": 1.2, "phoneme": "a", "shape": "a", "intensity": 0.8},
    {"start": 1.2, "end": 2.0, "phoneme": "o", "shape": "o", "intensity": 0.8},
    {"start": 2.0, "end": 2.4, "phoneme": "a", "shape": "a", "intensity": 0.8},
    {"start": 2.4, "end": 4.0, "phoneme": "silence", "shape": "silence", "intensity": 0.0},
]


def curves(path: Path, **changes: Any) -> str:
    document = {
        "format": "phonemeanalyser curves 1",
        "sound": "a.wav",
        "duration": 0.8,
        "rate": 5,
        "table": "arkit",
        "cues": CUES,
        "curves": [{"name": "jawOpen", "values": [0, 0.5, 1, 0.25, 0]}],
        "head": [],
    }
    path.write_text(json.dumps(document | changes), encoding="utf-8")
    return str(path)


def live_link(path: Path, jaw: list[float], yaw: float = 0.0) -> str:
    rows = [",".join(LIVE_LINK_COLUMNS)]
    for frame, value in enumerate(jaw):
        values = [value if name == "jawOpen" else 0.0 for name in ARKIT] + [yaw, *[0.0] * 8]
        rows.append(f"10:00:{frame // 60:02d}:{frame % 60:02d}.000,61,{','.join(map(str, values))}")
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return str(path)


def test_a_curve_moves_the_shape_key_of_its_name_whatever_the_capitals(mouth: Any, tmp_path: Path) -> None:
    bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json"), first=11)
    values = [value_at(mouth, "JawOpen", 11 + STEP * k) for k in range(5)]
    assert values == pytest.approx([0, 0.5, 1, 0.25, 0])
    assert value_at(mouth, "JawOpen", 13.5) == pytest.approx(0.25, abs=1e-6)
    assert mouth.data.shape_keys.animation_data.action.frame_range == Vector((11, 11 + 4 * STEP))


def test_a_weight_beyond_a_key_s_range_is_shown_as_well(mouth: Any, tmp_path: Path) -> None:
    bpy.ops.lip_sync.import_curves(
        filepath=curves(tmp_path / "a.json", curves=[{"name": "jawOpen", "values": [-0.5, 1.5]}])
    )
    assert [value_at(mouth, "JawOpen", frame) for frame in (1, 6)] == pytest.approx([-0.5, 1.5])


def test_the_scene_lasts_as_long_as_the_curves(mouth: Any, tmp_path: Path) -> None:
    bpy.context.scene.frame_end = 10
    bpy.ops.lip_sync.import_curves(
        filepath=curves(tmp_path / "a.json", curves=[{"name": "jawOpen", "values": [0.0] * 10 + [1.0]}])
    )
    assert bpy.context.scene.frame_end == 51


def test_a_recording_of_live_link_moves_the_face_at_its_own_times(mouth: Any, tmp_path: Path) -> None:
    jaw = [k / 120 for k in range(121)]
    bpy.ops.lip_sync.import_curves(filepath=live_link(tmp_path / "a.csv", jaw))
    assert [value_at(mouth, "JawOpen", 1 + 25 * t) for t in (0, 0.4, 1.0, 2.0)] == pytest.approx([0, 0.2, 0.5, 1])


def test_the_action_before_is_kept(mouth: Any, tmp_path: Path) -> None:
    for name in ("first.json", "second.json"):
        bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / name))
    assert {action.name: action.use_fake_user for action in bpy.data.actions} == {
        "first.json": True,
        "second.json": False,
    }


@pytest.mark.parametrize("mode", ["XYZ", "ZXY", "QUATERNION"])
def test_a_head_turns_about_the_axis_that_points_upwards(mouth: Any, tmp_path: Path, mode: str) -> None:
    mouth.rotation_mode = mode
    bpy.ops.lip_sync.import_curves(
        filepath=curves(tmp_path / "a.json", head=[{"name": "yaw", "values": [0, 10, 20, 30, 90]}]), with_head=True
    )
    bpy.context.scene.frame_set(1 + 4 * STEP)
    ahead = mouth.matrix_world.to_3x3() @ Vector((0, -1, 0))
    assert tuple(ahead) == pytest.approx((1, 0, 0), abs=1e-5)  # its left, where yaw goes


def test_a_head_nods_upwards_and_rolls_to_its_left(mouth: Any, tmp_path: Path) -> None:
    head = [{"name": "pitch", "values": [0, 0, 0, 0, 30]}]
    bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json", head=head), with_head=True)
    bpy.context.scene.frame_set(1 + 4 * STEP)
    assert (mouth.matrix_world.to_3x3() @ Vector((0, -1, 0))).z == pytest.approx(0.5)
    head = [{"name": "roll", "values": [0, 0, 0, 0, 30]}]
    bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json", head=head), with_head=True)
    bpy.context.scene.frame_set(1 + 4 * STEP)
    assert (mouth.matrix_world.to_3x3() @ Vector((0, 0, 1))).x == pytest.approx(0.5)


def test_a_face_without_such_shape_keys_is_refused_and_stays(mouth: Any, tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="Cube has no shape key called like what moves, tongueOut; choose another"):
        bpy.ops.lip_sync.import_curves(
            filepath=curves(tmp_path / "a.json", curves=[{"name": "tongueOut", "values": [0, 1]}])
        )
    assert mouth.data.shape_keys.animation_data is None
    assert not bpy.data.actions


@pytest.mark.parametrize("name", ["a.json", "a.csv"])
def test_a_damaged_file_is_refused_in_a_sentence(mouth: Any, tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("{", encoding="utf-8")
    with pytest.raises(RuntimeError, match=rf"{name}: this is no"):
        bpy.ops.lip_sync.import_curves(filepath=str(tmp_path / name))
    assert not bpy.data.actions


def table(mouth: Any) -> None:
    """Give a face a mouth table: a opens the jaw by 60 %, o rounds by 80 %, silence is rest."""
    bpy.ops.lip_sync.new_table(table="arkit")
    for shape in mouth.data.lip_sync.shapes:
        shape.movements.clear()
        for name, key, percent in (("a", "JawOpen", 60), ("o", "mouthFunnel", 80), ("o", "JawOpen", 20)):
            if shape.name == name:
                movement = shape.movements.add()
                movement.key, movement.percent = key, percent


def test_cues_are_strips_of_poses_that_fade_into_each_other(mouth: Any, tmp_path: Path) -> None:
    table(mouth)
    bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json"), form="CUES")
    tracks = mouth.data.shape_keys.animation_data.nla_tracks
    assert [len(track.strips) for track in tracks] == [3, 2]
    assert {strip.action.name for track in tracks for strip in track.strips} == {"Cube silence", "Cube a", "Cube o"}
    at = {
        t: (value_at(mouth, "JawOpen", 1 + 25 * t), value_at(mouth, "mouthFunnel", 1 + 25 * t))
        for t in (0.2, 0.4, 1.0, 1.2, 1.9, 2.0, 2.3, 2.4, 3.5)
    }
    rest, open_, rounded = (0, 0), (0.6, 0), (0.2, 0.8)
    wanted = {
        0.2: rest,
        0.4: rest,
        1.0: open_,
        1.2: open_,
        1.9: rounded,
        2.0: rounded,
        2.3: open_,
        2.4: open_,
        3.5: rest,
    }
    for time, (jaw, funnel) in wanted.items():
        assert at[time] == pytest.approx((jaw, funnel), abs=1e-5), time


def test_between_two_poses_the_mouth_is_on_its_way_and_nowhere_else(mouth: Any, tmp_path: Path) -> None:
    table(mouth)
    bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json"), form="CUES")
    jaw, funnel = (
        np.array([value_at(mouth, key, 1 + 25 * t) for t in np.arange(1.2, 1.4, 0.01)])
        for key in ("JawOpen", "mouthFunnel")
    )
    assert (np.diff(jaw) <= 1e-6).all()
    np.testing.assert_allclose((0.6 - jaw) / 0.4, funnel / 0.8, atol=1e-4)


def test_an_action_of_a_pose_is_edited_for_all_strips_of_it(mouth: Any, tmp_path: Path) -> None:
    table(mouth)
    bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json"), form="CUES")
    tracks = mouth.data.shape_keys.animation_data.nla_tracks
    shown = [strip for track in tracks for strip in track.strips if strip.action.name == "Cube a"]
    assert len(shown) == 2
    assert len({strip.action for strip in shown}) == 1


def test_cues_need_a_mouth_table(mouth: Any, tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="Cube has no mouth table; make one in the panel, or load one"):
        bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json"), form="CUES")
    assert not bpy.data.actions


def test_a_recording_without_cues_makes_no_strips(mouth: Any, tmp_path: Path) -> None:
    table(mouth)
    with pytest.raises(RuntimeError, match="there are no cues in it"):
        bpy.ops.lip_sync.import_curves(filepath=live_link(tmp_path / "a.csv", [0.0, 0.1, 0.2]), form="CUES")
    assert not bpy.data.actions


def test_a_table_that_moves_nothing_of_the_face_makes_no_strips(mouth: Any, tmp_path: Path) -> None:
    bpy.ops.lip_sync.new_table(table="oculus")
    with pytest.raises(
        RuntimeError, match="Cube has no shape key that its mouth table names; choose some in the panel"
    ):
        bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json"), form="CUES")
    assert not bpy.data.actions


def test_strips_lie_where_the_cues_are_however_short_these_are(mouth: Any, tmp_path: Path) -> None:
    table(mouth)
    chance = Random(1)
    cues, start = [], 0.0
    for k in range(200):
        end = round(start + chance.choice([0.0, 0.01, 0.02, 0.05, 0.3]), 4)
        cues.append(CUES[k % 3] | {"start": start, "end": end})
        start = end
    bpy.ops.lip_sync.import_curves(filepath=curves(tmp_path / "a.json", cues=cues), form="CUES")
    tracks = mouth.data.shape_keys.animation_data.nla_tracks
    strips = sorted((strip for track in tracks for strip in track.strips), key=lambda strip: strip.frame_start)
    lasting = [cue for cue in cues if cue["end"] > cue["start"]]
    begins = [strip.frame_start for strip in strips]
    np.testing.assert_allclose(begins, [1 + 25 * cue["start"] for cue in lasting], atol=2e-3)
    assert all(strip.frame_end >= 1 + 25 * cue["end"] - 2e-3 for strip, cue in zip(strips, lasting, strict=True))


@pytest.mark.parametrize("form", ["CUES", "CURVES"])
def test_strips_of_before_are_kept_and_silent_and_those_of_others_go_on(
    mouth: Any, tmp_path: Path, form: str
) -> None:
    table(mouth)
    path = curves(tmp_path / "a.json")
    keys = mouth.data.shape_keys
    keys.animation_data_create().nla_tracks.new().name = "Brows"
    bpy.ops.lip_sync.import_curves(filepath=path, form="CUES")
    bpy.ops.lip_sync.import_curves(filepath=path, form=form)
    muted = [track.mute for track in keys.animation_data.nla_tracks]
    assert muted == [False, True, True, *[False] * 2 * (form == "CUES")]
