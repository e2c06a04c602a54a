"""Whether a file that is there already is one that this program wrote itself, so that another may take its place.

Each format says what its own files look like; where those of other programs look alike, none counts as ours.
"""

import re
from collections.abc import Callable
from pathlib import Path

Owns = Callable[[bytes], bool]
"""Says of the content of a file whether a format of this program wrote it; when in doubt, it did not."""

LARGEST = 1 << 30
"""Bytes of a file that are looked at."""

JSON_TEXT = rb'"(?:[^"\\]|\\.)*"'
"""A text in JSON, as a regular expression."""


def begins_like(pattern: bytes) -> Owns:
    """Give what takes files for ours that begin as a regular expression says."""
    form = re.compile(pattern)
    return lambda content: form.match(content) is not None


def is_own(path: Path, owns: Owns) -> bool:
    """Say whether there is a file at `path` that a format wrote; one that cannot be read is not."""
    try:
        with path.open("rb") as file:
            return owns(file.read(LARGEST))
    except OSError:
        return False
