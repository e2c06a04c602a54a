"""Everything that a microphone recorded since Clear, on disk, so that one can go back in it."""

import logging
import queue
import tempfile
import threading
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO, NamedTuple

import numpy as np
from typing_extensions import override

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import mono_of
from phonemeengine.audio.resampling import Resampler
from phonemeengine.audio.wav import WavEncoder
from phonemeengine.execution import Closing
from phonemeengine.settings import SAMPLE_RATE, Channel
from phonemeengine.storage.files import reason_of

MOST_WAITING = 2000
"""Blocks that wait for the disk at most; a disk that is stuck for longer loses what comes after them."""
PATIENCE = 2.0
"""Seconds that who asks waits for the disk at most."""

_log = logging.getLogger(__name__)


class _Begin(NamedTuple):
    """The order to begin anew."""


_Order = tuple[Float32Array, int] | _Begin | threading.Event


class RecordedSound(Closing):
    """Writes what comes into a file of its own, mono at 44.1 kHz and 24 bits; memory stays as it is.

    Blocks may come from another thread, which never waits for the disk.

    Attributes
    ----------
    failure : why nothing is kept any more, as a sentence; None while all is well.
    """

    def __init__(self) -> None:
        self.failure: str | None = None
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._file: BinaryIO | None = None
        self._encoder: WavEncoder | None = None
        self._path: Path | None = None
        self._n_files = 0
        self._rate = 0
        self._resampler: Resampler | None = None
        self._orders: queue.Queue[_Order | None] = queue.Queue(MOST_WAITING)
        self._thread = threading.Thread(target=self._run, name="recorded sound", daemon=True)
        self._thread.start()

    def add_samples(self, block: Float32Array, rate: int) -> None:
        """Take a block, shape (n, n_channels), and its rate in Hz."""
        if self.failure is None and not self._orders.full():
            self._orders.put_nowait((mono_of(block, Channel.MIX), rate))

    def clear(self) -> None:
        """Forget what came so far, and begin anew."""
        self._orders.put(_Begin())

    def snapshot(self) -> Path | None:
        """Return the file with all that has come so far, which may go on growing; None where nothing has."""
        done = threading.Event()
        self._orders.put(done)
        done.wait(PATIENCE)
        encoder = self._encoder
        return self._path if encoder is not None and encoder.n_samples else None

    @override
    def close(self) -> None:
        """Forget everything, on the disk too."""
        if self._thread.is_alive():
            self._orders.put(None)
            self._thread.join(PATIENCE)

    def _run(self) -> None:
        while (order := self._orders.get()) is not None:
            try:
                self._do(order)
            except OSError as error:
                reason = reason_of(error)
                self.failure = f"The history is not kept any more ({reason}); free some space on the disk."
                _log.warning("%s", self.failure)
        self._end()
        if self._folder is not None:
            self._folder.cleanup()

    def _do(self, order: _Order) -> None:
        if isinstance(order, threading.Event):
            order.set()
        elif isinstance(order, _Begin):
            self._end()
        else:
            self._write(*order)

    def _write(self, block: Float32Array, rate: int) -> None:
        if self._encoder is None:
            self._begin()
        assert self._encoder is not None
        if rate != self._rate:
            self._rate, self._resampler = rate, None if rate == SAMPLE_RATE else Resampler(rate, 1)
        mono = block[:, np.newaxis]
        self._encoder.write(mono if self._resampler is None else self._resampler.resample(mono))

    def _begin(self) -> None:
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="phonemeanalyser-", ignore_cleanup_errors=True)
        self._n_files += 1
        self._path = Path(self._folder.name) / f"recorded {self._n_files}.wav"
        self._file = self._path.open("w+b", buffering=0)
        self._encoder = WavEncoder(self._file, SAMPLE_RATE, 1)

    def _end(self) -> None:
        encoder, self._encoder, self._resampler, self._rate = self._encoder, None, None, 0
        if encoder is not None and self._file is not None and self._path is not None:
            encoder.close()
            self._file.close()
            with suppress(OSError):  # another program has it open
                self._path.unlink()
