"""Which shapes of a face stand for which of ours, in the naming schemes of other programs.

The names are facts of public documents: ARKit's as the manuals of Face Cap and Faceit write them, Unified Expressions
(docs.vrcft.io), XR_FB_face_tracking2 (registry.khronos.org), the extended profile of Character Creator 4 (manual of
Reallusion), and the action units of FACS as M. Ozel relates ARKit to them (melindaozel.com).
"""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import MouthError
from phonemeengine.mouth.blendshape_names import ARKIT, OCULUS
from phonemeengine.mouth.face_mapping import guess_mapping, mapped_table, ours_of
from phonemeengine.mouth.table import load_table, table_of, table_to_toml

SIDED = tuple(
    name.removesuffix("Left") for name in ARKIT if name.endswith("Left") and name not in ("jawLeft", "mouthLeft")
)
LETTERS = {"Left": "L", "Right": "R"}


def both(stems: dict[str, str], pattern: str) -> dict[str, tuple[str, ...]]:
    """Name each of ours with a side as a pattern says it, with {stem}, {side} and {letter}."""
    return {
        f"{ours}{side}": (pattern.format(stem=stem, side=side, letter=letter),)
        for ours, stem in stems.items()
        for side, letter in LETTERS.items()
    }


FACE_CAP = {name: (name,) for name in ARKIT} | both({stem: stem for stem in SIDED}, "{stem}_{letter}")

UNIFIED_SIDED = {stem: stem[0].upper() + stem[1:] for stem in SIDED}
UNIFIED_SIDED |= {"eyeBlink": "EyeClosed", "mouthSmile": "MouthCornerPull", "browDown": "BrowLowerer"}
UNIFIED = both(UNIFIED_SIDED, "{stem}{side}") | {
    "jawForward": ("JawForward",),
    "jawRight": ("JawRight",),
    "jawLeft": ("JawLeft",),
    "jawOpen": ("JawOpen",),
    "mouthClose": ("MouthClosed",),
    "mouthFunnel": tuple(f"LipFunnel{row}{side}" for row in ("Upper", "Lower") for side in LETTERS),
    "mouthPucker": tuple(f"LipPucker{row}{side}" for row in ("Upper", "Lower") for side in LETTERS),
    "mouthRight": ("MouthUpperRight", "MouthLowerRight"),
    "mouthLeft": ("MouthUpperLeft", "MouthLowerLeft"),
    "mouthRollLower": ("LipSuckLowerLeft", "LipSuckLowerRight"),
    "mouthRollUpper": ("LipSuckUpperLeft", "LipSuckUpperRight"),
    "mouthShrugLower": ("MouthRaiserLower",),
    "mouthShrugUpper": ("MouthRaiserUpper",),
    "browInnerUp": ("BrowInnerUpLeft", "BrowInnerUpRight"),
    "cheekPuff": ("CheekPuffLeft", "CheekPuffRight"),
    "tongueOut": ("TongueOut",),
}

OPENXR_SIDED = {
    "eyeBlink": "EYES_CLOSED",
    "eyeLookDown": "EYES_LOOK_DOWN",
    "eyeLookUp": "EYES_LOOK_UP",
    "eyeSquint": "LID_TIGHTENER",
    "eyeWide": "UPPER_LID_RAISER",
    "mouthSmile": "LIP_CORNER_PULLER",
    "mouthFrown": "LIP_CORNER_DEPRESSOR",
    "mouthDimple": "DIMPLER",
    "mouthStretch": "LIP_STRETCHER",
    "mouthPress": "LIP_PRESSOR",
    "mouthLowerDown": "LOWER_LIP_DEPRESSOR",
    "mouthUpperUp": "UPPER_LIP_RAISER",
    "browDown": "BROW_LOWERER",
    "browOuterUp": "OUTER_BROW_RAISER",
    "cheekSquint": "CHEEK_RAISER",
    "noseSneer": "NOSE_WRINKLER",
}
OPENXR = both(OPENXR_SIDED, "XR_FACE_EXPRESSION2_{stem}_{letter}_FB") | {
    ours: tuple(f"XR_FACE_EXPRESSION2_{name}_FB" for name in names)
    for ours, names in {
        "eyeLookOutLeft": ("EYES_LOOK_LEFT_L",),
        "eyeLookInLeft": ("EYES_LOOK_RIGHT_L",),
        "eyeLookOutRight": ("EYES_LOOK_RIGHT_R",),
        "eyeLookInRight": ("EYES_LOOK_LEFT_R",),
        "jawForward": ("JAW_THRUST",),
        "jawRight": ("JAW_SIDEWAYS_RIGHT",),
        "jawLeft": ("JAW_SIDEWAYS_LEFT",),
        "jawOpen": ("JAW_DROP",),
        "mouthClose": ("LIPS_TOWARD",),
        "mouthFunnel": ("LIP_FUNNELER_LB", "LIP_FUNNELER_LT", "LIP_FUNNELER_RB", "LIP_FUNNELER_RT"),
        "mouthPucker": ("LIP_PUCKER_L", "LIP_PUCKER_R"),
        "mouthRight": ("MOUTH_RIGHT",),
        "mouthLeft": ("MOUTH_LEFT",),
        "mouthRollLower": ("LIP_SUCK_LB", "LIP_SUCK_RB"),
        "mouthRollUpper": ("LIP_SUCK_LT", "LIP_SUCK_RT"),
        "mouthShrugLower": ("CHIN_RAISER_B",),
        "mouthShrugUpper": ("CHIN_RAISER_T",),
        "browInnerUp": ("INNER_BROW_RAISER_L", "INNER_BROW_RAISER_R"),
        "cheekPuff": ("CHEEK_PUFF_L", "CHEEK_PUFF_R"),
        "tongueOut": ("TONGUE_OUT",),
    }.items()
}

CC4_SIDED = {
    "eyeBlink": "Eye_Blink",
    "eyeSquint": "Eye_Squint",
    "eyeWide": "Eye_Wide",
    "mouthSmile": "Mouth_Smile",
    "mouthFrown": "Mouth_Frown",
    "mouthDimple": "Mouth_Dimple",
    "mouthStretch": "Mouth_Stretch",
    "mouthPress": "Mouth_Press",
    "mouthLowerDown": "Mouth_Down_Lower",
    "mouthUpperUp": "Mouth_Up_Upper",
    "browDown": "Brow_Drop",
    "browOuterUp": "Brow_Raise_Outer",
    "cheekSquint": "Cheek_Raise",
    "noseSneer": "Nose_Sneer",
}
CC4 = both(CC4_SIDED, "{stem}_{letter}") | {
    "eyeLookUpLeft": ("Eye_L_Look_Up",),
    "eyeLookUpRight": ("Eye_R_Look_Up",),
    "eyeLookDownLeft": ("Eye_L_Look_Down",),
    "eyeLookDownRight": ("Eye_R_Look_Down",),
    "eyeLookOutLeft": ("Eye_L_Look_L",),
    "eyeLookInLeft": ("Eye_L_Look_R",),
    "eyeLookOutRight": ("Eye_R_Look_R",),
    "eyeLookInRight": ("Eye_R_Look_L",),
    "jawForward": ("Jaw_Forward",),
    "jawRight": ("Jaw_R",),
    "jawLeft": ("Jaw_L",),
    "jawOpen": ("Jaw_Open",),
    "mouthClose": ("Mouth_Close",),
    "mouthFunnel": tuple(f"Mouth_Funnel_{row}_{side}" for row in ("Up", "Down") for side in "LR"),
    "mouthPucker": tuple(f"Mouth_Pucker_{row}_{side}" for row in ("Up", "Down") for side in "LR"),
    "mouthRight": ("Mouth_R",),
    "mouthLeft": ("Mouth_L",),
    "mouthRollLower": ("Mouth_Roll_In_Lower_L", "Mouth_Roll_In_Lower_R"),
    "mouthRollUpper": ("Mouth_Roll_In_Upper_L", "Mouth_Roll_In_Upper_R"),
    "mouthShrugLower": ("Mouth_Shrug_Lower",),
    "mouthShrugUpper": ("Mouth_Shrug_Upper",),
    "browInnerUp": ("Brow_Raise_Inner_L", "Brow_Raise_Inner_R"),
    "cheekPuff": ("Cheek_Puff_L", "Cheek_Puff_R"),
    "tongueOut": ("Tongue_Out",),
}

FACS_SIDED = {
    "eyeBlink": "AU45",
    "eyeLookDown": "AU64",
    "eyeLookUp": "AU63",
    "eyeSquint": "AU7",
    "eyeWide": "AU5",
    "mouthSmile": "AU12",
    "mouthFrown": "AU15",
    "mouthDimple": "AU14",
    "mouthStretch": "AU20",
    "mouthPress": "AU24",
    "mouthLowerDown": "AU16",
    "mouthUpperUp": "AU10",
    "browDown": "AU4",
    "browOuterUp": "AU2",
    "cheekSquint": "AU6",
    "noseSneer": "AU9",
}
FACS = both(FACS_SIDED, "{stem}_{letter}") | {
    "eyeLookOutLeft": ("AU61_L",),
    "eyeLookInLeft": ("AU62_L",),
    "eyeLookOutRight": ("AU62_R",),
    "eyeLookInRight": ("AU61_R",),
    "jawForward": ("AU29",),
    "jawRight": ("AU30_R",),
    "jawLeft": ("AU30_L",),
    "jawOpen": ("AU26",),
    "mouthClose": ("AU8",),
    "mouthFunnel": ("AU22",),
    "mouthPucker": ("AU18",),
    "mouthRollLower": ("AU28",),
    "mouthRollUpper": ("AU28",),
    "mouthShrugLower": ("AU17",),
    "browInnerUp": ("AU1_L", "AU1_R"),
    "cheekPuff": ("AU34",),
    "tongueOut": ("AU19",),
}
SCHEMES = {"Face Cap": FACE_CAP, "Unified": UNIFIED, "OpenXR": OPENXR, "Character Creator": CC4, "FACS": FACS}


@pytest.mark.parametrize("scheme", SCHEMES.values(), ids=SCHEMES)
def test_of_52_shapes_at_least_45_are_guessed_right(scheme: dict[str, tuple[str, ...]]) -> None:
    names = sorted({name for names in scheme.values() for name in names})
    mapping = guess_mapping(names)
    right = [ours for ours, theirs in scheme.items() if {*mapping.targets.get(ours, ())} == {*theirs}]
    assert len(right) >= 45, {ours: (mapping.targets.get(ours), scheme[ours]) for ours in scheme if ours not in right}
    assert mapping.basis == "arkit"
    assert len(mapping.left_over) <= 2


NAMED = {
    "MediaPipe": ("eyeBlinkLeft", "eyeBlinkLeft"),
    "small letters": ("eyeblinkleft", "eyeBlinkLeft"),
    "Maya": ("head_blendShape.jawOpen", "jawOpen"),
    "CC3": ("A14_Eye_Blink_Left", "eyeBlinkLeft"),
    "MetaHuman": ("CTRL_expressions_mouthCornerPullL", "mouthSmileLeft"),
    "Daz": ("facs_bs_MouthSmileLeft_div2", "mouthSmileLeft"),
    "faceshift": ("EyeBlink_L", "eyeBlinkLeft"),
    "MakeHuman": ("LeftUpperLidClosed", "eyeBlinkLeft"),
    "MakeHuman's gaze": ("LeftEyeturnLeft", "eyeLookOutLeft"),
    "MikuMikuDance": ("ウィンク右", "eyeBlinkRight"),
    "half-width": ("ｳｨﾝｸ右", "eyeBlinkRight"),
    "a slip": ("mouthSmlie_L", "mouthSmileLeft"),
    "SRanipal": ("Mouth_Sad_Right", "mouthFrownRight"),
}


@pytest.mark.parametrize(("theirs", "ours"), NAMED.values(), ids=NAMED)
def test_names_of_many_programs_are_known(theirs: str, ours: str) -> None:
    assert guess_mapping([theirs]).targets == {ours: {theirs: 100.0}}


def test_a_shape_of_both_sides_moves_by_half_from_each() -> None:
    targets = guess_mapping(["まばたき", "AU12"]).targets
    assert targets["eyeBlinkLeft"] == targets["eyeBlinkRight"] == {"まばたき": 50.0}
    assert targets["mouthSmileLeft"] == targets["mouthSmileRight"] == {"AU12": 50.0}


def test_visemes_are_a_basis_where_a_face_has_no_more() -> None:
    oculus = guess_mapping([f"vrc.v_{name.lower()}" for name in OCULUS])
    assert oculus.basis == "oculus"
    assert {*oculus.targets} >= {*OCULUS}
    mmd = guess_mapping(["あ", "い", "う", "え", "お", "まばたき"])
    assert (mmd.basis, mmd.targets["A"], mmd.targets["O"]) == ("vrm", {"あ": 100.0}, {"お": 100.0})
    assert guess_mapping(["Fcl_MTH_A", "Fcl_MTH_I", "Fcl_MTH_U", "Fcl_MTH_E"]).targets["E"] == {"Fcl_MTH_E": 100.0}


def test_bones_stand_in_for_shapes_that_a_face_does_not_have() -> None:
    targets = guess_mapping(["Smile", "bone jawOpen", "bone eyeLookUpLeft"]).targets
    assert targets["jawOpen"] == {"bone jawOpen": 100.0}
    assert guess_mapping(["JawOpen", "bone jawOpen"]).targets["jawOpen"] == {"JawOpen": 100.0}


def test_what_has_no_meaning_is_left_over() -> None:
    mapping = guess_mapping(["JawOpen", "hat", "ear_wiggle"])
    assert mapping.left_over == ("hat", "ear_wiggle")
    assert len(mapping.missing) == len(ours_of("arkit")) - 1
    with pytest.raises(MouthError, match="no set of movestates 'x'"):
        guess_mapping([], "x")


def test_a_mapping_is_part_of_a_mouth_table_and_of_its_file(tmp_path: Path) -> None:
    mapping = guess_mapping(["Mouth Open", "smile_L", "smile_R", "Blink"])
    table = mapped_table(mapping, "my face")
    (tmp_path / "face.toml").write_text(table_to_toml(table), encoding="utf-8")
    read = load_table(tmp_path / "face.toml")
    assert read == table
    assert read.face_names == ("Blink", "Mouth Open", "smile_L", "smile_R")
    weights = np.zeros((2, len(read.movestates)), np.float32)
    weights[0, read.movestates.index("jawOpen")] = 0.5
    weights[1, read.movestates.index("eyeBlinkLeft")] = 1.0
    np.testing.assert_allclose(read.on_face(weights), [[0, 0.5, 0, 0], [0.5, 0, 0, 0]])


def test_a_table_for_a_face_with_visemes_blinks_too() -> None:
    table = mapped_table(guess_mapping(["あ", "い", "う", "まばたき"]), "MMD")
    assert {"A", "eyeBlinkLeft"} <= {*table.movestates}
    assert table.face_names == ("あ", "い", "う", "まばたき")
    with pytest.raises(MouthError, match="none of vrm; choose another table"):
        mapped_table(guess_mapping(["あ", "い", "う"]), "x", load_table("arkit"))


BAD = {
    "an unknown movestate": ("[targets]\njawOpne = { a = 100 }\n", "targets names 'jawOpne', which is no movestate"),
    "no table": ("[targets]\njawOpen = 3\n", "jawOpen"),
    "too much": ("[targets]\njawOpen = { a = 1000 }\n", "-400..400"),
}


@pytest.mark.parametrize(("text", "said"), BAD.values(), ids=BAD)
def test_bad_targets_are_refused(text: str, said: str) -> None:
    with pytest.raises(MouthError, match=said):
        table_of(table_to_toml(load_table("arkit")) + text)
