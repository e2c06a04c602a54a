"""How far model visemes are laid over what is looked up, and when."""

from dataclasses import dataclass
from itertools import groupby

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.mouth.poses import Pose, PoseTable
from phonemeengine.mouth.style_numbers import PoseNumbers
from phonemeengine.performance.recording import SILENCE, PerformedPhone
from phonemeengine.performance.units import Sentence


@dataclass(frozen=True, eq=False)
class PoseShares:
    """How far a face takes which poses.

    Attributes
    ----------
    shares : float32, shape (n_frames, n_posed), 0..1; those of a frame sum to 1 at most.
    shapes : the names of the shapes, one for each.
    firm : float32, shape (n_frames,): how far lips or teeth meet.
    """

    shares: Float32Array
    shapes: tuple[str, ...]
    firm: Float32Array


def pose_in(poses: PoseTable, phone: PerformedPhone) -> Pose | None:
    """Return the pose of a phone; None for none, and in silence."""
    return poses.pose_of("" if phone.name == SILENCE else phone.name)


def pose_shares(sentence: Sentence, poses: PoseTable, times: Float64Array, frame: float) -> PoseShares:
    """Return the shares of all poses of a sentence at some times.

    Parameters
    ----------
    sentence : its phones.
    times : seconds.
    frame : how long a picture is shown, seconds: no pose holds for less.
    """
    posed = [(k, pose) for k, phone in enumerate(sentence) if (pose := pose_in(poses, phone)) is not None]
    curves = np.zeros((len(posed), len(times)))
    for row, (k, pose) in zip(curves, posed, strict=True):
        row[:] = _curve(sentence, k, pose, poses.curve, times, frame)
    _share_out(curves, [pose.priority for _, pose in posed])
    firm = sum((row for row, (_, pose) in zip(curves, posed, strict=True) if pose.firm), np.zeros(len(times)))
    return PoseShares(curves.T.astype(np.float32), tuple(pose.shape for _, pose in posed), firm.astype(np.float32))


def posed_weights(
    weights: Float32Array, shares: PoseShares, poses: PoseTable, channels: tuple[str, ...]
) -> Float32Array:
    """Lay poses over weights, shape (n_frames, n_channels), of these channels: what they take, the weights lose."""
    if not shares.shapes:
        return weights
    shapes = np.stack([poses.weights(shape, channels) for shape in shares.shapes])
    decides = np.isfinite(shapes)
    taken = shares.shares @ decides.astype(np.float32)
    laid: Float32Array = shares.shares @ np.where(decides, shapes, 0.0) + (1 - taken) * weights
    return laid


def _curve(
    sentence: Sentence, k: int, pose: Pose, numbers: PoseNumbers, times: Float64Array, frame: float
) -> Float64Array:
    """Return how far the pose of a phone is taken: a plateau with two flanks, each half a Gaussian."""
    phone = sentence[k]
    plateau = max(frame, numbers.plateau * phone.duration * pose.width)
    begin = phone.start + numbers.place * phone.duration - plateau / 2
    distance = np.where(times < begin, begin - times, np.maximum(times - begin - plateau, 0.0))
    before = sentence[k - 1].duration if k else 0.0
    after = sentence[k + 1].duration if k + 1 < len(sentence) else 0.0
    longest = numbers.longest_neighbour
    coming = np.clip(numbers.coming * min(before, longest), numbers.least_coming, numbers.most_coming)
    leaving = np.clip(numbers.leaving * min(after, longest), numbers.least_leaving, numbers.most_leaving)
    width = np.where(times < begin, coming, leaving) * pose.width
    height = 1.0 if pose.firm else min(1.0, phone.duration / numbers.full_length)
    curve: Float64Array = height * np.exp(-0.5 * (distance / width) ** 2)
    return curve


def _share_out(curves: Float64Array, priorities: list[float]) -> None:
    """Make curves, shape (n, n_times), sum to 1 at most: the lower priorities get what the higher ones leave."""
    left = np.ones(curves.shape[1])
    order = sorted(range(len(curves)), key=lambda k: -priorities[k])
    for _, rows in groupby(order, key=priorities.__getitem__):
        equal = [*rows]
        total = curves[equal].sum(axis=0)
        curves[equal] *= np.minimum(1.0, left / np.maximum(total, 1e-12))
        left = np.maximum(left - curves[equal].sum(axis=0), 0.0)
