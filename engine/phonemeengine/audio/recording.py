"""Sound on its way to the disk as it comes: a file that is playable at any moment and moves if its place vanishes."""

import errno
import io
import logging
import math
import os
import shutil
import threading
from collections import deque
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Protocol

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio import libsndfile
from phonemeengine.audio.journal import RecordingMarker
from phonemeengine.audio.libsndfile import DecodingError, FlacEncoder
from phonemeengine.audio.wav import WavEncoder
from phonemeengine.errors import RecordingError
from phonemeengine.storage.files import atomic_write, free_path, printable, printable_name, reason_of

COPIED_AT_ONCE = 1 << 20
"""Bytes."""

TROUBLES: dict[int, tuple[str, str]] = {
    errno.ENOSPC: ("the disk is full", "free some space or record to another disk"),
    errno.EDQUOT: ("your share of the disk is used up", "free some space or record to another disk"),
    errno.EFBIG: ("the disk takes no larger file", "go on in a new file, or on a disk formatted as exFAT or NTFS"),
    errno.EROFS: ("the disk has become read-only", "record to another disk"),
    errno.EACCES: ("writing is no longer permitted", "change the permissions or record to another folder"),
    errno.EPERM: ("writing is no longer permitted", "change the permissions or record to another folder"),
}
"""What each refusal of the disk means while a recording runs, and what to do."""


class RecordingFile:
    """A new file that no other process has.

    Attributes
    ----------
    path : where it was made.
    raw : the file itself, unbuffered, open for writing and reading.

    Raises
    ------
    RecordingError : there is such a file already, or none can be made there.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.raw: BinaryIO = _made(path)

    def is_there(self) -> bool:
        """Return whether the path still leads to this file."""
        try:
            return os.path.samestat(os.fstat(self.raw.fileno()), self.path.stat())
        except PermissionError:
            return True  # it cannot be found out
        except OSError:
            return False

    def copy_to(self, folder: Path) -> Path:
        """Copy what was written into another folder, under a free name, from the open file itself.

        Raises
        ------
        OSError : it cannot be read or written; nothing is left there.
        """
        folder.mkdir(parents=True, exist_ok=True)
        path = free_path(folder / self.path.name)
        with path.open("xb") as copy:
            try:
                self.raw.seek(0)
                shutil.copyfileobj(self.raw, copy, COPIED_AT_ONCE)
            except OSError:
                path.unlink()
                raise
        return path

    def close(self) -> None:
        """Let go of the file; it stays."""
        with suppress(OSError):
            self.raw.close()

    def discard(self) -> None:
        """Let go of the file and remove it, if it is still where it was made."""
        was_there = self.is_there()
        self.close()
        if was_there:
            with suppress(OSError):
                self.path.unlink()


def describe_os_error(error: OSError) -> tuple[str, str]:
    """Return what a refusal of the disk means, and what to do."""
    unknown = (f"the disk refuses to take more ({reason_of(error)})", "check it or record to another disk")
    return TROUBLES.get(error.errno or 0, unknown)


def shown_folder(path: Path) -> str:
    """Return the folder of a file, without characters that would break the sentence it stands in."""
    return printable(str(path.absolute().parent))


def _made(path: Path) -> io.FileIO:
    name, folder = printable_name(path), shown_folder(path)
    try:
        if path.is_dir():
            raise RecordingError(f"{name}: this is a folder; choose a name for a new file")
        return path.open("x+b", buffering=0)
    except FileExistsError as error:
        raise RecordingError(
            f"{name}: there is a file of that name, which a recording does not overwrite; choose another name"
        ) from error
    except (FileNotFoundError, NotADirectoryError) as error:
        raise RecordingError(f"{name}: there is no folder {folder}; make it or choose another") from error
    except PermissionError as error:
        raise RecordingError(
            f"{name}: writing to {folder} is not permitted; change its permissions or choose another folder"
        ) from error
    except (OSError, ValueError) as error:
        raise RecordingError(
            f"{name}: it cannot be made in {folder} ({reason_of(error)}); choose another folder or name"
        ) from error


# A whole sound as a FLAC file, written so that a half one never shows.


def write_flac(path: Path, samples: Float32Array, rate: int) -> None:
    """Write a sound of 24 bits to a file, which appears once it is complete and on the disk.

    Parameters
    ----------
    path : ends in ``.flac``; a file of that name is replaced.
    samples : shape (n,) or (n, n_channels), ±1, n > 0.
    rate : 4000..655350 Hz.

    Raises
    ------
    RecordingError : the file cannot be written; nothing is left there.
    """
    try:
        with atomic_write(path, durable=True) as file:
            encoder = FlacEncoder(file, rate, 1 if samples.ndim == 1 else samples.shape[1], marks=False)
            encoder.write(samples)
            encoder.close()
    except OSError as error:
        what, advice = describe_os_error(error)
        raise RecordingError(f"{path.name}: {what}, so the sound is not kept; {advice}") from error
    except DecodingError as error:
        raise RecordingError(
            f"{path.name}: this sound cannot be written as FLAC ({error}); record it again"
        ) from error


PERIOD = 0.2
"""Seconds between two writings to the disk."""

MOST_WAITING = 60.0
"""Sound that waits for the disk at most, seconds; then the disk counts as stuck."""

GONE = "its folder or the file itself has gone"
STUCK = "check the disk or record to another"
ELSEWHERE = "record to another folder"

_log = logging.getLogger(__name__)


class Encoder(Protocol):
    """Writes a sound file whose header is true after every block.

    Attributes
    ----------
    n_samples : samples per channel that a reader of the file finds now.
    """

    n_samples: int

    def write(self, block: Float32Array) -> None:
        """Append a block, shape (n, n_channels), ±1; OSError where the disk refuses, and what fits stays."""
        ...

    def mark(self, seconds: float) -> None:
        """Mark that this many seconds are missing after what was written; OSError where the disk refuses."""
        ...

    def close(self) -> None:
        """Finish the file, which stays open; OSError where the disk refuses."""
        ...


@dataclass(frozen=True)
class _Pause:
    """Sound that is missing: how long, in seconds, and the samples of silence that take its place."""

    seconds: float
    n_silent: int


class Recording:
    """Writes what is recorded to a new file of 24 bits, five times a second, in a thread of its own.

    Whatever happens to this process, the file is playable and lacks less than the last second. Whatever happens to
    the disk, `failure` says it, and what was written stays.

    Parameters
    ----------
    path : the new file, .wav (RF64 beyond 4 GB) or .flac.
    rate : Hz.
    n_channels : channels of the blocks.
    journal : folder in which the recording is noted while it runs.
    rescue : folder into which the recording is copied if its own vanishes.

    Attributes
    ----------
    path : where the recording is; another place once it was rescued.
    failure : the sentence that says why the recording has ended by itself; None while all is well.
    notes : remarks for the user, a sentence each; mostly none.

    Raises
    ------
    RecordingError : the recording cannot begin.
    """

    close_timeout = 5.0
    """Time that `close` waits for a disk that takes nothing, seconds."""

    def __init__(self, path: Path, rate: int, n_channels: int, *, journal: Path, rescue: Path) -> None:
        self.path = path
        self.rate = rate
        self.n_channels = n_channels
        self.failure: str | None = None
        self._rescue = rescue
        self._name = printable_name(path)
        _check_form(path, rate, n_channels, self._name)
        self._file = self._make_file(path)
        with ExitStack() as unless_begun:
            unless_begun.callback(self._file.discard)
            self._encoder = _encoder(self._file, rate, n_channels, self._name)
            unless_begun.pop_all()
        self._note, self.notes = _noted(journal, path, self._name)
        self._waiting: deque[Float32Array | _Pause] = deque()
        self._n_given = self._n_done = 0
        self._rescuing = False
        self._ending = threading.Event()
        _log.info("recording to %s begins: %d Hz, %d channels", path, rate, n_channels)
        self._thread = threading.Thread(target=self._run, name="recording", daemon=True)
        self._thread.start()

    def _make_file(self, path: Path) -> RecordingFile:
        """Make the file; a subclass writes to another disk."""
        return RecordingFile(path)

    @property
    def n_samples(self) -> int:
        """Samples per channel that are safely on disk."""
        return self._encoder.n_samples

    @property
    def seconds(self) -> float:
        """Length of what is safely on disk, seconds."""
        return self.n_samples / self.rate

    def write(self, block: Float32Array) -> None:
        """Take a block, shape (n, n_channels), ±1; returns at once. What comes after the end is dropped.

        All calls come from one thread.
        """
        if self._ending.is_set():
            return
        if self._n_given - self._n_done > MOST_WAITING * self.rate:
            self._fail(f"the disk is {MOST_WAITING:.0f} s behind", STUCK, shown_folder(self.path))
            return
        self._waiting.append(np.array(block, np.float32).reshape(-1, self.n_channels))
        self._n_given += len(block)

    def skip(self, seconds: float, n_silent: int = 0) -> None:
        """Mark here that this many seconds of sound are missing, and have samples of silence take their place.

        Returns at once; to be called by the thread that writes.
        """
        if not self._ending.is_set():
            self._waiting.append(_Pause(seconds, n_silent))

    def close(self) -> None:
        """End the recording and finish its file; from any thread, and as often as you like.

        A recording without a sample leaves no file. What still waits is written, and a rescue is waited for; a disk
        that takes nothing for 5 s is not, and `failure` says so.
        """
        self._ending.set()
        n_samples = -1
        while self._thread.is_alive() and (self._rescuing or n_samples != self.n_samples):
            n_samples = self.n_samples
            self._thread.join(self.close_timeout)
        if self._thread.is_alive():
            self._fail(f"the disk has taken nothing for {self.close_timeout:.0f} s", STUCK, shown_folder(self.path))

    def _run(self) -> None:
        try:
            self._follow()
            self._encoder.close()
        except OSError as error:
            self._end_badly(error)
        except Exception as error:  # noqa: BLE001 - whatever it is, the user must learn that nothing is recorded
            self._fail(f"it cannot be encoded ({error})", "report this as a bug", shown_folder(self.path))
        finally:
            self._let_go()

    def _follow(self) -> None:
        ending = False
        while not ending:
            ending = self._ending.wait(PERIOD)
            while self._waiting:
                first = self._waiting.popleft()
                if isinstance(first, _Pause):
                    self._pass_over(first)
                else:
                    self._take_up(first)
            if not self._file.is_there():
                raise FileNotFoundError(errno.ENOENT, "the file has gone")

    def _pass_over(self, pause: _Pause) -> None:
        self._encoder.mark(pause.seconds)
        for begin in range(0, pause.n_silent, self.rate):
            n = min(self.rate, pause.n_silent - begin)
            self._encoder.write(np.zeros((n, self.n_channels), np.float32))

    def _take_up(self, first: Float32Array) -> None:
        """Write a block, and what waits behind it, up to about a second."""
        parts, n = [first], len(first)
        while n < self.rate and self._waiting and not isinstance(block := self._waiting[0], _Pause):
            parts.append(block)
            self._waiting.popleft()
            n += len(block)
        self._encoder.write(np.concatenate(parts))
        self._n_done += n

    def _end_badly(self, error: OSError) -> None:
        self._ending.set()
        with suppress(OSError):
            self._encoder.close()
        if self._file.is_there():
            self._fail(*describe_os_error(error), shown_folder(self.path))
        elif self.n_samples == 0:
            self._fail(GONE, ELSEWHERE, None)
        else:
            self._save_elsewhere()

    def _save_elsewhere(self) -> None:
        self._rescuing = True
        try:
            rescued = self._file.copy_to(self._rescue)
        except OSError as refusal:
            self._fail(f"its folder has gone, and saving it elsewhere failed ({reason_of(refusal)})", ELSEWHERE, None)
        else:
            self.path = rescued
            self._fail(GONE, ELSEWHERE, shown_folder(rescued))

    def _fail(self, what: str, advice: str, folder: str | None) -> None:
        """Set the sentence, if none is set yet, and end; `folder` is where what was recorded is kept."""
        length = math.floor(self.seconds * 10) / 10
        after = f"so the recording stopped after {length:.1f} s"
        kept = f", which are kept in {folder}" if folder else ", which are lost"
        if self.n_samples == 0:
            after, kept = "so nothing was recorded", ""
        if self.failure is None:
            self.failure = f"{self._name}: {what}, {after}{kept}; {advice}"
            _log.error("%s", self.failure)
        self._ending.set()

    def _let_go(self) -> None:
        with suppress(Exception):
            self._encoder.close()
        if self.n_samples:
            self._file.close()
        else:
            self._file.discard()
        if self._note:
            self._note.remove()
        _log.info("recording to %s has ended: %.2f s", self.path, self.seconds)


def _check_form(path: Path, rate: int, n_channels: int, name: str) -> None:
    """Refuse what the file's kind cannot hold."""
    suffix = path.suffix.lower()
    if suffix not in {".wav", ".flac"}:
        raise RecordingError(f"{name}: a recording is a .wav or a .flac file; let its name end like that")
    low, high = libsndfile.LOWEST_FLAC_RATE, libsndfile.HIGHEST_FLAC_RATE
    most = libsndfile.MOST_FLAC_CHANNELS
    if suffix == ".flac" and not (low <= rate <= high and n_channels <= most):
        raise RecordingError(
            f"{name}: FLAC takes {low}..{high} Hz and at most {most} channels, got {rate} Hz and {n_channels}; "
            "record to a .wav file"
        )


def _encoder(file: RecordingFile, rate: int, n_channels: int, name: str) -> Encoder:
    kind = FlacEncoder if file.path.suffix.lower() == ".flac" else WavEncoder
    try:
        return kind(file.raw, rate, n_channels)
    except OSError as error:
        what, advice = describe_os_error(error)
        raise RecordingError(f"{name}: {what}, so nothing can be recorded; {advice}") from error
    except libsndfile.DecodingError as error:
        raise RecordingError(f"{name}: this machine's libsndfile cannot write FLAC; record to a .wav file") from error


def _noted(journal: Path, path: Path, name: str) -> tuple[RecordingMarker | None, tuple[str, ...]]:
    """Note the recording; one that cannot be noted is made all the same."""
    try:
        return RecordingMarker(journal, path), ()
    except (OSError, NotImplementedError) as error:
        remark = f"{name}: if the program ends in mid-recording, this file will not be offered at the next start"
        return None, (f"{remark} ({reason_of(error) if isinstance(error, OSError) else error})",)
