"""A whole sound as a FLAC file, written so that a half one never shows."""

from pathlib import Path

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.libsndfile import DecodingError, FlacEncoder
from phonemeengine.audio.recording_file import describe_os_error
from phonemeengine.errors import RecordingError
from phonemeengine.files import atomic_write


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
