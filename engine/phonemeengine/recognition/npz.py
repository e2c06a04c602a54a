"""Reads the arrays of an ``.npz`` file; what it says of itself is checked before anything is allocated."""

import io
import math
import re
import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

MAGIC = b"\x93NUMPY"
HEADER = re.compile(
    rb"\{'descr': '([<|][fiub][1248])', 'fortran_order': (True|False), "
    rb"'shape': \((|\d{1,9},|\d{1,9}(?:, \d{1,9}){1,3})\), \} *\n?"
)
"""What NumPy writes for arrays of numbers; everything else is no array of ours."""
MOST_ARRAYS = 1024
PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)


def read_npz(path: Path, largest: int) -> dict[str, NDArray[Any]]:
    """Read all arrays of an archive; those that NumPy's `savez` wrote, with numbers in them.

    Parameters
    ----------
    largest : bytes that all arrays may have together.

    Raises
    ------
    ValueError : the archive is damaged or too large, or holds what is no array of numbers.
    OSError : the file cannot be read.
    """
    content = io.BytesIO(path.read_bytes())
    try:
        with zipfile.ZipFile(content) as archive:
            entries = archive.infolist()
            if sum(entry.file_size for entry in entries) > largest or len(entries) > MOST_ARRAYS:
                raise ValueError(f"the arrays have more than {largest} bytes")
            if any(entry.compress_type not in PACKED for entry in entries):
                raise ValueError("the archive is compressed in a way that NumPy does not use")
            return {entry.filename.removesuffix(".npy"): _array_of(_unpacked(archive, entry)) for entry in entries}
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, RuntimeError) as error:
        raise ValueError("the archive is damaged") from error


def _unpacked(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> bytes:
    """Unpack no more than the archive says there is, whatever is packed in it."""
    with archive.open(entry) as file:
        return file.read(entry.file_size)


def _array_of(content: bytes) -> NDArray[Any]:
    """Read an array as NumPy's format 1.0 has it: magic, version, length of the header, header, numbers."""
    begin = 10 + int.from_bytes(content[8:10], "little")
    found = HEADER.fullmatch(content[10:begin])
    if not content.startswith(MAGIC + b"\x01\x00") or found is None:
        raise ValueError("this is no array of numbers")
    dtype = np.dtype(found[1].decode())
    shape = tuple(int(n) for n in found[3].split(b",") if n)
    if len(content) - begin != math.prod(shape) * dtype.itemsize:
        raise ValueError("an array is longer or shorter than it says")
    order: Any = "F" if found[2] == b"True" else "C"
    return np.frombuffer(content, dtype, offset=begin).reshape(shape, order=order)
