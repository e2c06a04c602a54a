"""The state of a training on disk, so that one that was interrupted goes on where it was."""

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.files import atomic_write


class Checkpoint:
    """A file with the state of a training.

    Parameters
    ----------
    path : where it lies; it need not be there yet.
    """

    def __init__(self, path: Path) -> None:
        self._path = path

    def keep(self, state: Sequence[Float32Array], generator: np.random.Generator, step: int) -> None:
        """Write the state; the older one stays until the new one is complete."""
        about = json.dumps({"step": step, "generator": generator.bit_generator.state}).encode()
        with atomic_write(self._path) as file:
            np.savez(file, allow_pickle=False, about=np.frombuffer(about, np.uint8), **_named(state))

    def restore(self, state: Sequence[Float32Array], generator: np.random.Generator) -> int:
        """Read the state into the arrays and the generator, if there is one; returns the number of steps done."""
        if not self._path.is_file():
            return 0
        with np.load(self._path, allow_pickle=False) as file:
            for name, array in _named(state).items():
                array[...] = file[name]
            about = json.loads(file["about"].tobytes())
        generator.bit_generator.state = about["generator"]
        return int(about["step"])


def _named(state: Sequence[Float32Array]) -> dict[str, Float32Array]:
    return {f"array_{k}": array for k, array in enumerate(state)}
