"""What a recogniser gives for a block of frames."""

from dataclasses import dataclass

from phonemeengine.arrays import Float32Array, UInt8Array


@dataclass(frozen=True)
class Recognition:
    """The phonemes of a block.

    Attributes
    ----------
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`.
    scores : float32, shape (n_frames, n_scores): the columns that the recogniser's `scores` names, or None where it
        names none.
    visemes : float32, shape (n_frames, 15): how likely each `Viseme` is; None where the recogniser hears none.
    """

    phonemes: UInt8Array
    scores: Float32Array | None = None
    visemes: Float32Array | None = None
