"""What a network is to answer: what the labels say, softened by what the teacher heard."""

from typing import NamedTuple

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array

SMOOTHING = 0.05
"""Share of the certainty that is spread over all classes: labels lie a little beside the truth."""
TEACHER_SHARE = 0.5
"""How much the teacher counts beside a label (G. Hinton, O. Vinyals and J. Dean, "Distilling the Knowledge in a
Neural Network", arXiv:1503.02531, at the temperature 1); where there is no label, it alone counts."""


class Targets(NamedTuple):
    """What is to be answered in the frames of a batch.

    Attributes
    ----------
    wanted : probabilities, float32, shape (n_batch, n_frames, n_classes).
    weights : how much each frame counts, float32, shape (n_batch, n_frames).
    """

    wanted: Float32Array
    weights: Float32Array


def targets_of(
    codes: UInt8Array, heard: Float32Array, importance: Float32Array, certainties: Float32Array
) -> Targets:
    """Return what is to be answered of one kind of classes.

    Parameters
    ----------
    codes : of the labels, shape (n_batch, n_frames); n_classes or above where the label says nothing of this kind.
    heard : the teacher's probabilities, shape (n_batch, n_frames, n_classes); zeros where it says nothing.
    importance : how much a frame of each class counts, shape (n_classes,).
    certainties : how much each label counts, 0..1, shape (n_batch, n_frames).
    """
    n = len(importance)
    told = certainties * (codes < n)
    spoken = heard.sum(axis=2)
    taught = spoken * np.where(told > 0, TEACHER_SHARE, 1)
    labelled = told * (1 - TEACHER_SHARE * spoken)
    smoothed = np.full((n, n), SMOOTHING / n, np.float32) + (1 - SMOOTHING) * np.eye(n, dtype=np.float32)
    wanted = labelled[..., np.newaxis] * smoothed[np.minimum(codes, n - 1)] + taught[..., np.newaxis] * heard
    weights = wanted.sum(axis=2)
    wanted /= np.maximum(weights, np.float32(1e-9))[..., np.newaxis]
    meant = np.where(told > 0, np.minimum(codes, n - 1), heard.argmax(axis=2))
    return Targets(wanted.astype(np.float32), (weights * importance[meant]).astype(np.float32))
