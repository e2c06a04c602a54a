"""What can be played: a sound that is read block by block."""

from typing import Protocol

from phonemeengine.arrays import Float32Array
from phonemeengine.settings import Channel


class Reader(Protocol):
    """Gives a sound at 44.1 kHz, block by block."""

    channel: Channel
    n_channels: int
    n_samples: int

    @property
    def duration(self) -> float:
        """Length of the sound, seconds."""
        ...

    def read(self, n: int) -> Float32Array:
        """Return the next samples, shape (m, n_channels), fewer than `n` only at the end."""
        ...

    def mono(self, block: Float32Array) -> Float32Array:
        """Return what is recognised, shape (m,), of a block that `read` gave."""
        ...

    def seek(self, sample: int) -> None:
        """Go to a sample."""
        ...

    def close(self) -> None:
        """Let go."""
        ...
