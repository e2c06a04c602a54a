"""Reads the arrays of an ``.npz`` file; how large it says they are is checked before anything is unpacked."""

import io
import tokenize
import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

MOST_ARRAYS = 1024
PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
"""The ways in which NumPy compresses, which unpack no more than an archive says there is."""
_DAMAGE = (zipfile.BadZipFile, zlib.error, tokenize.TokenError, EOFError, MemoryError, OSError, RuntimeError)


def read_npz(path: Path, largest: int) -> dict[str, NDArray[Any]]:
    """Read all arrays of an archive as `arrays_in_npz` does; OSError where the file cannot be read."""
    return arrays_in_npz(path.read_bytes(), largest)


def arrays_in_npz(archived: bytes, largest: int) -> dict[str, NDArray[Any]]:
    """Read all arrays of an archive that `numpy.savez` wrote, never anything that is executed.

    Parameters
    ----------
    largest : bytes that all arrays may have together.

    Raises
    ------
    ValueError : the archive is damaged or too large, or holds what is no array.
    """
    content = io.BytesIO(archived)
    try:
        with zipfile.ZipFile(content) as archive:
            entries = archive.infolist()
        if sum(entry.file_size for entry in entries) > largest or len(entries) > MOST_ARRAYS:
            raise ValueError(f"the arrays have more than {largest} bytes")
        if any(entry.compress_type not in PACKED for entry in entries):
            raise ValueError("the archive is compressed in a way that NumPy does not use")
        with np.load(content, allow_pickle=False) as file:
            arrays = dict(file)
    except _DAMAGE as error:
        raise ValueError("the archive is damaged") from error
    if not all(isinstance(array, np.ndarray) for array in arrays.values()):
        raise ValueError("there is a file in the archive that is no array")
    return arrays
