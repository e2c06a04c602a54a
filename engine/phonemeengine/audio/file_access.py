"""Files as bytes on the disk: what may be opened, and under which name it is spoken of."""

import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any, BinaryIO

from typing_extensions import override

from phonemeengine.errors import AudioError
from phonemeengine.storage.files import is_folder, why_unreadable


def open_checked(path: Path, name: str) -> BinaryIO:
    """Open a file for reading, and speak of it as `name`.

    Raises
    ------
    AudioError : it is missing, a folder, a device, or not permitted.
    """
    try:
        if path.exists() and not path.is_file() and not is_folder(path):
            raise AudioError(f"{name}: this is a device, not an audio file; choose a file")
        file = path.open("rb")
    except (OSError, ValueError) as error:
        raise AudioError(f"{name}: {why_unreadable(path, error)}") from error
    return file


class FileSlice(io.RawIOBase):
    """A part of a file as a file of its own; it has no name whose ending could mislead libsndfile.

    Parameters
    ----------
    file : open for reading.
    end : where the part ends, bytes.
    corrections : bytes that stand in it instead of the file's, by their places in the part.
    begin : where the part begins, bytes.
    lead : bytes that are put in front of it.
    """

    def __init__(
        self,
        file: BinaryIO,
        end: int,
        corrections: Sequence[tuple[int, bytes]] = (),
        begin: int = 0,
        lead: bytes = b"",
    ) -> None:
        self._file = file
        self._begin, self._lead = begin, lead
        self._end = end - begin + len(lead)
        self._corrections = corrections
        self._at = 0

    @override
    def readable(self) -> bool:
        return True

    @override
    def seekable(self) -> bool:
        return True

    @override
    def tell(self) -> int:
        return self._at

    @override
    def seek(self, offset: int, whence: int = io.SEEK_SET) -> int:
        """Go to a place, which may lie beyond the end."""
        base = {io.SEEK_SET: 0, io.SEEK_CUR: self._at, io.SEEK_END: self._end}[whence]
        self._at = max(0, base + offset)
        return self._at

    @override
    def readinto(self, buffer: Any) -> int:
        view = memoryview(buffer).cast("B")[: max(0, self._end - self._at)]
        if not len(view):  # the place may be one that no file has
            return 0
        lead = self._lead[self._at : self._at + len(view)]
        view[: len(lead)] = lead
        self._file.seek(self._begin + max(0, self._at - len(self._lead)))
        n = len(lead) + int(self._file.readinto(view[len(lead) :]))  # type: ignore[attr-defined]
        for place, content in self._corrections:
            for k in range(max(place, self._at), min(place + len(content), self._at + n)):
                view[k - self._at] = content[k - place]
        self._at += n
        return n
