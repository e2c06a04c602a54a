"""The tongue, which no camera sees: a pose for each sound, as ``tongue.toml`` has them."""

from functools import lru_cache
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.mouth.blendshape_names import TONGUE
from phonemeengine.performance.poses import PLACE, PoseTable, load_poses, pose_shares
from phonemeengine.performance.recording import SILENCE
from phonemeengine.performance.sentence import Sentence

USUAL_TONGUE = Path(__file__).with_name("tongue.toml")
TO_REST = 0.1
"""Seconds in which the tongue comes to rest in a pause, and comes from there."""


def tongue_weights(sentence: Sentence, times: Float64Array, frame: float) -> Float32Array:
    """Return the weights of the movestates of `TONGUE`, float32, shape (n_times, 6).

    Poses are mixed as those of the mouth are, with what they leave on the way from each pose to the next one.

    Parameters
    ----------
    sentence : its phones.
    times : seconds.
    frame : how long a picture is shown, seconds; no pose holds for less.
    """
    poses = _usual_tongue()
    posed = pose_shares(sentence, poses, times, frame)
    way = _on_the_way(sentence, poses, times)
    if not posed.shapes:
        return way
    shapes = np.stack([_weights_of(shape, poses) for shape in posed.shapes])
    weights: Float32Array = posed.shares @ shapes + (1 - posed.shares.sum(axis=1, keepdims=True)) * way
    return weights


@lru_cache(maxsize=1)
def _usual_tongue() -> PoseTable:
    return load_poses(USUAL_TONGUE)


def _weights_of(shape: str, poses: PoseTable) -> Float32Array:
    """Return the weights of a shape; the tongue is a whole, so what a shape does not name is at rest."""
    return np.nan_to_num(poses.weights(shape, TONGUE))


def _on_the_way(sentence: Sentence, poses: PoseTable, times: Float64Array) -> Float32Array:
    """Return a tongue that goes from each pose to the next one along half a cosine."""
    rest = np.zeros(len(TONGUE), np.float32)
    stations: list[tuple[float, Float32Array]] = []
    for phone in sentence:
        pose = poses.pose_of(phone.name)
        if pose is not None:
            stations.append((phone.start + PLACE * phone.duration, _weights_of(pose.shape, poses)))
        elif phone.name == SILENCE:
            inset = min(TO_REST, phone.duration / 2)
            stations += [(phone.start + inset, rest), (phone.end - inset, rest)]
    at, shapes = np.array([time for time, _ in stations]), np.stack([shape for _, shape in stations])
    places = np.interp(times, at, np.arange(len(at)))
    last = np.minimum(places.astype(np.intp) + 1, len(at) - 1)
    share = (0.5 - 0.5 * np.cos(np.pi * (places % 1))).astype(np.float32)[:, None]
    way: Float32Array = (1 - share) * shapes[places.astype(np.intp)] + share * shapes[last]
    return way
