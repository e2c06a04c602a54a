"""A whole sound as a FLAC file, written so that a half one never shows."""

import os
from contextlib import ExitStack, suppress
from pathlib import Path

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.libsndfile import DecodingError, FlacEncoder
from phonemeengine.audio.recording_file import RecordingFile, describe_os_error
from phonemeengine.errors import RecordingError


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
    part = path.with_name(path.name + ".part")
    with suppress(OSError):
        part.unlink(missing_ok=True)
    file = RecordingFile(part)
    with ExitStack() as unless_written:
        unless_written.callback(_discard, file)
        try:
            encoder = FlacEncoder(file.raw, rate, 1 if samples.ndim == 1 else samples.shape[1], marks=False)
            encoder.write(samples)
            encoder.close()
            os.fsync(file.raw.fileno())
            file.close()
            part.replace(path)
        except OSError as error:
            what, advice = describe_os_error(error)
            raise RecordingError(f"{path.name}: {what}, so the sound is not kept; {advice}") from error
        except DecodingError as error:
            raise RecordingError(
                f"{path.name}: this sound cannot be written as FLAC ({error}); record it again"
            ) from error
        unless_written.pop_all()


def _discard(file: RecordingFile) -> None:
    file.close()
    with suppress(OSError):
        file.path.unlink(missing_ok=True)
