"""What a performer did when a recording was made: the face as it was tracked, and where its sound is."""

import glob
import os
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import is_sound
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.performance.driver import FACE
from phonemeengine.performance.halves import weights_at
from phonemeengine.performance.recording import HEAD, Performance
from phonemeengine.performance.table_file import PerformanceTable


class RecordedFace:
    """A recording as it was tracked, for a performer to play: a `MouthTrack` of its own time.

    Turns of the head are counted from their median, as a camera stands anywhere.

    Parameters
    ----------
    performance : the recording.

    Attributes
    ----------
    movestates : those of `FACE`, in the order of the weights; those that were not tracked are 0.
    """

    movestates = FACE

    def __init__(self, performance: Performance) -> None:
        self._performance = performance
        places = {name: k for k, name in enumerate(performance.channels)}
        self._shown = [(k, places[name]) for k, name in enumerate(FACE) if name in places]
        turns = [places[name] for name in HEAD if name in places]
        self._turns = turns if len(turns) == len(HEAD) else []
        self._ahead = np.median(performance.weights[:, self._turns], axis=0)

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (60,), 0..1."""
        weights = np.zeros(len(FACE), np.float32)
        frame = self._frame_at(time)
        for place, column in self._shown:
            weights[place] = frame[column]
        return weights.clip(0, 1)

    def head(self, time: float) -> HeadPose | None:
        """Return how the head was turned at a time, seconds; None where that was not recorded."""
        if not self._turns:
            return None
        return HeadPose(*(self._frame_at(time)[self._turns] - self._ahead).tolist())

    def _frame_at(self, time: float) -> Float32Array:
        frame: Float32Array = weights_at(self._performance.weights, np.array([time * self._performance.rate]))[0]
        return frame


def original_sound(
    table: PerformanceTable, recording: str, folder: str | os.PathLike[str] | None = None
) -> Path | None:
    """Return the sound of a recording; None where there is none.

    Parameters
    ----------
    table : in which it is.
    recording : its name.
    folder : where the recordings are; where the table was built of them, as seen from the table, if it is None.
    """
    place = table.path.parent / table.about.folder if folder is None else Path(folder)
    found = sorted(place.glob(f"{glob.escape(recording)}.*")) if Path(recording).name == recording else []
    return next((path for path in found if is_sound(path)), None)
