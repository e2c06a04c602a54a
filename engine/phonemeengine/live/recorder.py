"""What is recorded from a microphone: a file, its phonemes beside it if that is wanted, and all since Clear."""

import csv
import logging
import math
import os
import queue
import tempfile
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO, NamedTuple

import numpy as np
from typing_extensions import override

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import mono_of
from phonemeengine.audio.recording import Recording
from phonemeengine.audio.resampling import Resampler
from phonemeengine.audio.wav import Gap, WavEncoder, gaps_in_words
from phonemeengine.errors import RecordingError
from phonemeengine.execution import Closing
from phonemeengine.recognition.segments import SEGMENT_COLUMNS, Segment, SegmentBuilder
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, Channel
from phonemeengine.storage.files import free_path, reason_of
from phonemeengine.storage.paths import journal_folder, recordings_folder

_log = logging.getLogger(__name__)


class Recorder(Closing):
    """Records what a listener receives.

    The file is begun with the first block. A microphone that comes back goes on in the same file, where the gap is
    marked; one with another sample rate or other channels goes into a file of its own.

    Parameters
    ----------
    target : the new file, ``.wav`` (RF64 beyond 4 GB) or ``.flac``, after which others get numbers; or what names
        each, called in the listening thread.
    with_phonemes : write the phonemes beside it as they are recognised, as a table that ends in ``.csv``.
    fill_gaps : write silence for the time in which a microphone was away, besides the mark.
    seconds : how much of each file is recorded at most.

    Attributes
    ----------
    journal, rescue : where running recordings are noted, and where one is copied to if its own folder vanishes; the
        user's own folders, unless others are set before the first sound.
    paths : the files, in their order.
    gaps : where sound is missing in the newest file.
    """

    def __init__(
        self,
        target: str | os.PathLike[str] | Callable[[], Path],
        *,
        with_phonemes: bool = False,
        fill_gaps: bool = False,
        seconds: float = math.inf,
    ) -> None:
        self.paths: list[Path] = []
        self.gaps: list[Gap] = []
        self.journal, self.rescue = journal_folder(), recordings_folder()
        self._next_path = target if callable(target) else _numbered(Path(target))
        self._with_phonemes = with_phonemes
        self._fill_gaps = fill_gaps
        self._most = seconds
        self._n_given = 0
        self._recording: Recording | None = None
        self._phonemes: PhonemeLog | None = None
        self._refusal: str | None = None
        self._closed = False
        self._turning = threading.Lock()

    @property
    def seconds(self) -> float:
        """Length of what is safely on disk in the newest file, seconds."""
        return self._recording.seconds if self._recording else 0.0

    @property
    def path(self) -> Path | None:
        """The newest file; None before the first sound."""
        return self._recording.path if self._recording else None

    @property
    def gap_words(self) -> str:
        """How long the gaps in the newest file were and what stands for them, in words; nothing without any."""
        return gaps_in_words(self.gaps, self.seconds, self._recording.rate) if self._recording else ""

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks for the user, a sentence each; mostly none."""
        return self._recording.notes if self._recording else ()

    @property
    def failure(self) -> str | None:
        """Why nothing is recorded any more, as a sentence; None while all is well."""
        return self._refusal or (self._recording.failure if self._recording else None)

    def write(self, block: Float32Array, rate: int, began: float, gap: float | None = None) -> None:
        """Take a block.

        Parameters
        ----------
        block : shape (n, n_channels), ±1.
        rate : Hz.
        began : when its first sample arrived, seconds of listening.
        gap : seconds that were lost before it; None where it follows the block before.
        """
        with self._turning:
            recording = self._recording
            if self._closed or self.failure:
                return
            if recording is None or (recording.rate, recording.n_channels) != (rate, block.shape[1]):
                recording = self._begin(rate, block.shape[1], began)
            elif gap is not None:
                self._skip(recording, gap, began)
            n = self._fitting(len(block), rate)
            if recording is not None and n:
                recording.write(block[:n])
                self._n_given += n

    def add_analysis(self, analysis: Analysis) -> None:
        """Take what was found in what was written."""
        if self._phonemes is not None and not self._closed:
            self._phonemes.add_analysis(analysis)

    @override
    def close(self) -> None:
        """End the recording and finish its files; what arrives afterwards begins no other."""
        with self._turning:
            self._closed = True
        self._finish(self._recording, self._phonemes)

    def _fitting(self, n: int, rate: int) -> int:
        """Return how many of `n` samples are still to be recorded."""
        return round(min(n, self._most * rate - self._n_given))

    def _skip(self, recording: Recording, seconds: float, began: float) -> None:
        """Mark a gap after which sound comes from `began` on, and fill it where that is wanted."""
        if self._fitting(1, recording.rate) == 0:
            return
        n_silent = self._fitting(round(seconds * recording.rate), recording.rate) if self._fill_gaps else 0
        gap = Gap(self._n_given, seconds, n_silent)
        self.gaps.append(gap)
        _log.warning("%s has a gap of %.2f s", recording.path, seconds)
        recording.skip(seconds, n_silent)
        self._n_given += n_silent
        if self._phonemes is not None:
            self._phonemes.skip(gap, recording.rate, began)

    def _begin(self, rate: int, n_channels: int, began: float) -> Recording | None:
        old, phonemes = self._recording, self._phonemes
        if old is not None:  # a disk may take its time, and the microphone does not wait
            threading.Thread(target=self._finish, args=(old, phonemes), name="recording ends").start()
        try:
            path = self._next_path()
            self._recording = Recording(path, rate, n_channels, journal=self.journal, rescue=self.rescue)
            self.paths.append(path)
            self._n_given = 0
            self.gaps = []
            self._phonemes = self._table(path, began) if self._with_phonemes else None
        except RecordingError as error:
            self._refusal = str(error)
            _log.error("%s", error)
            return None
        return self._recording

    def _table(self, path: Path, began: float) -> "PhonemeLog":
        return PhonemeLog(free_path(path.with_suffix(".csv")), began, self._most)

    def _finish(self, recording: Recording | None, phonemes: "PhonemeLog | None") -> None:
        if recording is not None:
            recording.close()
        if phonemes is not None and recording is not None:
            phonemes.close(recording.seconds)


def _numbered(path: Path) -> Callable[[], Path]:
    """Return what names the path itself, and then numbered ones after it."""
    names = iter([path])
    return lambda: next(names, None) or free_path(path)


class PhonemeLog:
    """Writes the phonemes of a recording as they are recognised; each row is on the disk when its phoneme ends.

    Parameters
    ----------
    path : the table, a new file.
    began : when the recording began, seconds of listening.
    seconds : how much is recorded at most; no row reaches beyond it.

    Raises
    ------
    RecordingError : the table cannot be written.
    """

    def __init__(self, path: Path, began: float, seconds: float = math.inf) -> None:
        self._began = self._lag = began
        self._most = seconds
        self._joiner = SegmentBuilder()
        self._shift: float | None = None
        self._writing = threading.Lock()
        try:
            self._file = path.open("x", encoding="utf-8", newline="", buffering=1)
            self._rows = csv.DictWriter(self._file, SEGMENT_COLUMNS, lineterminator="\n")
            self._rows.writeheader()
        except OSError as error:
            raise RecordingError(
                f"{path.name}: this table cannot be written ({error.strerror}); record without the phonemes beside it"
            ) from error

    def skip(self, gap: Gap, rate: int, began: float) -> None:
        """Write a row for a gap in the recording; what arrives after it begins at `began`."""
        place, end = round(gap.sample / rate, 6), round((gap.sample + gap.n_silent) / rate, 6)
        with self._writing:
            self._write(self._joiner.finish(place - (self._shift or 0.0)))
            self._joiner, self._shift = SegmentBuilder(), None
            self._began, self._lag = began, began - end
            with suppress(OSError):
                self._rows.writerow(dict(zip(SEGMENT_COLUMNS, (place, end, gap.label, 0.0, 1.0), strict=True)))

    def add_analysis(self, analysis: Analysis) -> None:
        """Take the next frames; those from before the recording are left out."""
        wanted = analysis.part(slice(max(0, round(self._began / FRAME_PERIOD) - analysis.start), None))
        if len(wanted) == 0:
            return
        with self._writing:
            if self._shift is None:
                self._shift = wanted.start * FRAME_PERIOD - self._lag
            self._write(self._joiner.extend(wanted.phonemes, wanted.intensities, None, wanted.confidences))

    def close(self, duration: float) -> None:
        """Write the last row, and finish."""
        with self._writing, suppress(OSError):
            self._write(self._joiner.finish(duration - (self._shift or 0.0)))
            self._file.close()

    def _write(self, runs: list[Segment]) -> None:
        """Write rows; a full disk is no matter of the table's, since the recording says so."""
        with suppress(OSError):
            for run in runs if not self._file.closed else []:
                shifted = replace(run, start=self._on_tape(run.start), end=self._on_tape(run.end))
                if shifted.start < shifted.end:
                    self._rows.writerow(shifted.row())

    def _on_tape(self, seconds: float) -> float:
        return min(max(0.0, seconds + (self._shift or 0.0)), self._most)


# The microphone's samples while a take is recorded.

LONGEST = 30.0
"""Seconds that are caught at most; what comes later is left out."""


class SampleCapture:
    """Keeps what comes between `begin` and `end`; blocks may come from another thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._blocks: list[Float32Array] = []
        self._mono: list[Float32Array] = []
        self._rate = 0
        self._n = 0
        self._open = False

    @property
    def open(self) -> bool:
        """Whether what comes is kept."""
        return self._open

    @property
    def seconds(self) -> float:
        """How much was caught."""
        return self._n / self._rate if self._rate else 0.0

    @property
    def full(self) -> bool:
        """Whether nothing more is kept."""
        return self.seconds >= LONGEST

    def add_samples(self, block: Float32Array, rate: int) -> None:
        """Take a block, shape (n, n_channels); one in another form than those before begins anew."""
        with self._lock:
            if not self._open or self.full:
                return
            if rate != self._rate or (self._blocks and self._blocks[0].shape[1] != block.shape[1]):
                self._forget()
                self._rate = rate
            self._blocks.append(block)
            self._mono.append(mono_of(block, Channel.MIX))
            self._n += len(block)

    def begin(self) -> None:
        """Keep what comes from now on."""
        with self._lock:
            self._forget()
            self._open = True

    def end(self) -> tuple[Float32Array, int]:
        """Keep no more; gives what was caught, shape (n, n_channels), and its rate in Hz."""
        with self._lock:
            self._open = False
            caught = np.concatenate(self._blocks) if self._blocks else np.zeros((0, 1), np.float32)
            rate = self._rate or SAMPLE_RATE
            self._forget()
        return caught, rate

    def so_far(self) -> tuple[Float32Array, int]:
        """Return what was caught so far as one channel, shape (n,), and its rate in Hz."""
        with self._lock:
            if len(self._mono) > 1:
                self._mono = [np.concatenate(self._mono)]
            return (self._mono[0] if self._mono else np.zeros(0, np.float32)), self._rate or SAMPLE_RATE

    def _forget(self) -> None:
        self._blocks, self._mono, self._n = [], [], 0


def to_mono_44k(samples: Float32Array, rate: int) -> Float32Array:
    """Return a sound, shape (n, n_channels), as one channel at 44.1 kHz, shape (m,)."""
    if rate != SAMPLE_RATE and len(samples):
        samples = Resampler(rate, samples.shape[1]).resample(samples, last=True)
    return mono_of(samples, Channel.MIX)


MOST_WAITING = 2000
"""Blocks that wait for the disk at most; a disk that is stuck for longer loses what comes after them."""
PATIENCE = 2.0
"""Seconds that who asks waits for the disk at most."""


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
