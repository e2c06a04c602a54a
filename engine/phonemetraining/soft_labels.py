"""Soft labels: what a teacher that knows many more voices heard in recordings, kept on disk."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.training_examples import N_HEARD
from phonemeengine.errors import CorpusError
from phonemeengine.storage.files import reason_of

SOFT_LABELS, HEAD = "heard.npz", "head.npz"
"""Files of what the teacher heard, and of a head that heard all."""

SoftLabels = Mapping[str, NDArray[np.float16]]
"""By the key of the recording: shape (n_frames, 26), frames of 10 ms."""


def key_of(utterance: LabelledUtterance) -> str:
    """Return the name of a recording among the soft labels: corpus/speaker/file, without the file's ending."""
    return f"{utterance.voice}/{utterance.path.stem}"


def save_soft_labels(soft_labels: SoftLabels, path: Path) -> None:
    """Write soft labels into an ``.npz``."""
    np.savez(path, allow_pickle=False, **soft_labels)


def load_soft_labels(path: Path) -> dict[str, NDArray[np.float16]]:
    """Read soft labels.

    Raises
    ------
    CorpusError : the file cannot be read, or holds other arrays.
    """
    try:
        with np.load(path, allow_pickle=False) as file:
            found = {name: file[name] for name in file.files}
    except (OSError, ValueError, EOFError) as error:
        reason = reason_of(error) if isinstance(error, OSError) else "it is damaged"
        raise CorpusError(
            f"{path.name}: the soft labels cannot be read ({reason}); let the teacher hear again"
        ) from error
    if any(a.ndim != 2 or a.shape[1] != N_HEARD or a.dtype != np.float16 for a in found.values()):
        raise CorpusError(f"{path.name}: these are no soft labels of this version; let the teacher hear again")
    return found
