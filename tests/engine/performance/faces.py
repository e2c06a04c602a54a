"""Files of faces in the formats of other programs."""

import json
from collections.abc import Sequence

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.livelink import COUNT, HEADER
from tests.glb_faces import face_with_targets, glb_of

TIMES = (0.0, 0.5, 2.0)
KINDS = {str: "s", int: "i", float: "f"}


def ramp(n: int = 31, channel: str = "jawOpen", rate: float = 60.0) -> Animation:
    """Give a face of which one channel grows from 0 to 1, and whose head turns by 30 degrees meanwhile."""
    weights = np.zeros((n, len(ARKIT)), np.float32)
    weights[:, ARKIT.index(channel)] = np.linspace(0, 1, n)
    head = np.zeros((n, 3), np.float32)
    head[:, 0] = np.linspace(0, 30, n)
    return Animation(rate, ARKIT, weights, head)


def livelink_of(codes: Sequence[str], weights: Float32Array) -> str:
    """Give a recording of Live Link Face with these time codes, and values as the telephone writes them."""
    rows = (f"{code},{COUNT},{','.join(f'{x:.10f}' for x in row)}" for code, row in zip(codes, weights, strict=True))
    return "\n".join([HEADER, *rows]) + "\n"


def animated_face(
    names: Sequence[str], values: Sequence[Sequence[float]], interpolation: str = "LINEAR", **sampler: int
) -> bytes:
    """A triangle whose targets have values at `TIMES`; of a cubic one, the tangents are 9."""
    plain = face_with_targets(names)
    size = int.from_bytes(plain[12:16], "little")
    document, binary = json.loads(plain[20 : 20 + size]), plain[28 + size :]
    weights = np.array(values, "<f4")
    if interpolation == "CUBICSPLINE":
        weights = np.stack([np.full_like(weights, 9), weights, np.full_like(weights, 9)], axis=1)
    for array in (np.array(TIMES, "<f4"), weights):
        view = {"buffer": 0, "byteOffset": len(binary), "byteLength": array.nbytes}
        form = {"bufferView": len(document["bufferViews"]), "componentType": 5126, "count": array.size}
        document["bufferViews"].append(view)
        document["accessors"].append({**form, "type": "SCALAR"})
        binary += array.tobytes()
    n = len(document["accessors"])
    document["buffers"][0]["byteLength"] = len(binary)
    document["animations"] = [
        {
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
            "samplers": [{"input": n - 2, "output": n - 1, "interpolation": interpolation} | sampler],
        }
    ]
    return glb_of(document, binary)


def osc_line(seconds: float, address: str, *arguments: str | float) -> str:
    """A message as oscdump of liblo writes it."""
    whole, rest = divmod(seconds, 1)
    words = (f'"{x}"' if isinstance(x, str) else f"{x:f}" if isinstance(x, float) else str(x) for x in arguments)
    types = "".join(KINDS[type(x)] for x in arguments)
    return " ".join([f"{int(whole):08x}.{int(rest * 2**32):08x}", address, types, *words]).rstrip(" ")


def recorded_vmc(times: list[float], *, clock: bool = True) -> str:
    """A jaw that opens by a hundredth a frame, sent with or without the sender's clock, which is 5 s behind."""
    lines = []
    for k, time in enumerate(times):
        lines += [osc_line(time + k % 2 / 100, "/VMC/Ext/OK", 1)]
        lines += [osc_line(time, "/VMC/Ext/T", time - 5)] if clock else []
        lines += [osc_line(time, "/VMC/Ext/Blend/Val", "JawOpen", k / 100)]
        lines += [osc_line(time, "/VMC/Ext/Blend/Val", "Joy", 0.5)] if k else []
        lines += [osc_line(time + (k % 2 / 100 if clock else 0), "/VMC/Ext/Blend/Apply")]
    return "\n".join(lines) + "\n"
