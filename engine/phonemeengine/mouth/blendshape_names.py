"""The names of the movestates that avatars are made with, as other programs know them."""

ARKIT = (
    "eyeBlinkLeft",
    "eyeLookDownLeft",
    "eyeLookInLeft",
    "eyeLookOutLeft",
    "eyeLookUpLeft",
    "eyeSquintLeft",
    "eyeWideLeft",
    "eyeBlinkRight",
    "eyeLookDownRight",
    "eyeLookInRight",
    "eyeLookOutRight",
    "eyeLookUpRight",
    "eyeSquintRight",
    "eyeWideRight",
    "jawForward",
    "jawRight",
    "jawLeft",
    "jawOpen",
    "mouthClose",
    "mouthFunnel",
    "mouthPucker",
    "mouthRight",
    "mouthLeft",
    "mouthSmileLeft",
    "mouthSmileRight",
    "mouthFrownLeft",
    "mouthFrownRight",
    "mouthDimpleLeft",
    "mouthDimpleRight",
    "mouthStretchLeft",
    "mouthStretchRight",
    "mouthRollLower",
    "mouthRollUpper",
    "mouthShrugLower",
    "mouthShrugUpper",
    "mouthPressLeft",
    "mouthPressRight",
    "mouthLowerDownLeft",
    "mouthLowerDownRight",
    "mouthUpperUpLeft",
    "mouthUpperUpRight",
    "browDownLeft",
    "browDownRight",
    "browInnerUp",
    "browOuterUpLeft",
    "browOuterUpRight",
    "cheekPuff",
    "cheekSquintLeft",
    "cheekSquintRight",
    "noseSneerLeft",
    "noseSneerRight",
    "tongueOut",
)
"""The 52 blend shapes of ARKit, in the order in which Live Link Face writes them."""

LIVE_LINK_ANGLES = (
    "HeadYaw",
    "HeadPitch",
    "HeadRoll",
    "LeftEyeYaw",
    "LeftEyePitch",
    "LeftEyeRoll",
    "RightEyeYaw",
    "RightEyePitch",
    "RightEyeRoll",
)
LIVE_LINK_COLUMNS = (
    "Timecode",
    "BlendShapeCount",
    *(name[0].upper() + name[1:] for name in ARKIT),
    *LIVE_LINK_ANGLES,
)
"""The columns of the CSV of Live Link Face."""

OPENFACE_POSE = ("pose_Rx", "pose_Ry", "pose_Rz")
"""OpenFace's columns for the turns of the head, radians about the axes of a camera that it faces."""
STRONGEST_UNIT = 5.0
"""The highest intensity of an action unit; the lowest is 0."""

OCULUS = ("sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "ih", "oh", "ou")
"""The 15 visemes of Oculus Lipsync, in its order."""

VRM = ("A", "I", "U", "E", "O")
"""The mouths of an avatar of VRM 0, as VMC programs name them."""

VRM1 = ("aa", "ih", "ou", "ee", "oh")
"""The same mouths of VRM 1."""

NAMES: dict[str, tuple[str, ...]] = {"arkit": ARKIT, "oculus": OCULUS, "vrm": VRM, "vrm1": VRM1}
"""The sets that a mouth table may name instead of a list of its own."""

BONE = "bone "
"""What names of movestates begin with that are bones of the face, turned; the rest is the name of ARKit."""

EYELIDS = ("eyeBlinkLeft", "eyeBlinkRight")
"""The movestates that a blink closes."""

BROWS = ("browInnerUp", "browOuterUpLeft", "browOuterUpRight", "browDownLeft", "browDownRight")
"""ARKit's raisers of the brows, inner and outer, and their lowerers."""
SHOULDERS = ("shoulderShiftLeft", "shoulderShiftRight")
"""How far the shoulders have moved to a side, 1 for as far as the avatar's go; ARKit has no names for them."""
TONGUE = (
    "tongueTipInterdental",
    "tongueTipAlveolar",
    "tongueFrontDorsalPalate",
    "tongueMidDorsalPalate",
    "tongueBackDorsalVelar",
    "tongueRetreat",
)
"""Where the tongue is, beside ARKit's ``tongueOut``, as face tracking in OpenXR (XR_FB_face_tracking2) names it."""


def both_sides(name: str) -> tuple[str, str]:
    """Return the two movestates for which a name without a side stands, such as ``mouthSmile``."""
    return f"{name}Left", f"{name}Right"
