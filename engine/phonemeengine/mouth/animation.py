"""The movement of a face through a whole sound, frame by frame."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import MouthError
from phonemeengine.mouth.blendshape_names import EYELIDS
from phonemeengine.mouth.blinks import Blinker
from phonemeengine.mouth.cues import Cue
from phonemeengine.mouth.head_motion import HeadMotion
from phonemeengine.mouth.morpher import Detail, Morpher
from phonemeengine.mouth.table import MouthTable
from phonemeengine.mouth.transcript import Transcript

LOWEST_RATE, HIGHEST_RATE = 1.0, 240.0
"""Frames per second."""


@dataclass(frozen=True)
class IdleMotion:
    """What a face does besides speaking, and which of all faces it is.

    Attributes
    ----------
    blinks, head : whether it blinks, and whether its head moves.
    seed : equal seeds make equal faces.
    detail : how much of the speech its mouth follows.
    """

    blinks: bool = True
    head: bool = True
    seed: int = 0
    detail: Detail = Detail.PHONEMES


@dataclass(frozen=True)
class Animation:
    """The weights of a face's movestates at a frame rate.

    Attributes
    ----------
    rate : frames per second; frame k shows the time k / rate.
    movestates : the names of the columns.
    weights : float32, shape (n_frames, n_movestates), 1 for the whole movement.
    head : float32, shape (n_frames, 3): yaw, pitch and roll, degrees; zeros where the head does not move.
    """

    rate: float
    movestates: tuple[str, ...]
    weights: Float32Array
    head: Float32Array

    @property
    def times(self) -> Float64Array:
        """The time of each frame, seconds, shape (n_frames,)."""
        return np.arange(len(self.weights)) / self.rate


def animation_of(
    speech: Transcript, cues: Sequence[Cue], table: MouthTable, rate: float, life: IdleMotion | None = None
) -> Animation:
    """Animate a face: its mouth moves along the cues with the loudness of the sound.

    Parameters
    ----------
    speech : what was said.
    cues : the same, cleaned; see `cues_of`.
    table : the mouth shapes.
    rate : frames per second, 1..240.
    life : what else the face does; blinks and a moving head, where it is None.

    Raises
    ------
    MouthError : the rate lies outside its range.
    """
    if not LOWEST_RATE <= rate <= HIGHEST_RATE:
        raise MouthError(
            f"the frame rate must lie in {LOWEST_RATE:g}..{HIGHEST_RATE:g} frames per second, got {rate:g}; "
            "choose another"
        )
    life = life or IdleMotion()
    n_frames = math.floor(speech.duration * rate + 1e-6) + 1
    weights = _mouth(speech, cues, Morpher(table, detail=life.detail, seed=life.seed), rate, n_frames)
    if life.blinks:
        _blink(weights, table.movestates, Blinker(life.seed), rate)
    head = _head(speech, rate, n_frames, life.seed) if life.head else np.zeros((n_frames, 3), np.float32)
    return Animation(rate, table.movestates, weights, head)


def _mouth(speech: Transcript, cues: Sequence[Cue], morpher: Morpher, rate: float, n_frames: int) -> Float32Array:
    weights = np.zeros((n_frames, len(morpher.movestates)), np.float32)
    loud, starts = speech.intensities.tolist(), speech.times.tolist()
    heard = begun = 0
    for frame in range(n_frames):
        time = frame / rate
        while heard < len(loud) and starts[heard] <= time:
            morpher.hear_loudness(starts[heard], loud[heard])
            heard += 1
        while begun < len(cues) and cues[begun].start <= time:
            morpher.hear_phoneme(cues[begun].start, cues[begun].phoneme)
            begun += 1
        weights[frame] = morpher.weights(time)
    return weights


def _blink(weights: Float32Array, movestates: tuple[str, ...], blinker: Blinker, rate: float) -> None:
    columns = [movestates.index(lid) for lid in EYELIDS if lid in movestates]
    if columns:
        closures = np.array([blinker.closure(frame / rate) for frame in range(len(weights))], np.float32)
        for column in columns:
            weights[:, column] = np.maximum(weights[:, column], closures)


def _head(speech: Transcript, rate: float, n_frames: int, seed: int) -> Float32Array:
    motion, poses = HeadMotion(seed), np.zeros((n_frames, 3), np.float32)
    heard, starts = 0, speech.times.tolist()
    loud, pitches = speech.intensities.tolist(), speech.pitches.tolist()
    for frame in range(n_frames):
        while heard < len(loud) and starts[heard] <= frame / rate:
            motion.hear(starts[heard], loud[heard], pitches[heard])
            heard += 1
        pose = motion.pose(frame / rate)
        poses[frame] = pose.yaw, pose.pitch, pose.roll
    return poses
