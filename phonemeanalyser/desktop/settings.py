"""What outlives the window: choices of one type each in the user's settings, and where files of the user's are."""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QSettings

from phonemeengine.storage.paths import presets_folder

T = TypeVar("T")
N_RECENT = 8
"""Paths that are listed of those that were used last."""


@dataclass(frozen=True)
class Kept(Generic[T]):
    """A choice that is kept under a key; what is chosen now gives its type, and stands where nothing fit is kept."""

    key: str
    get: Callable[[], T]
    put: Callable[[T], object]

    def save(self, settings: QSettings) -> None:
        """Keep what is chosen."""
        keep(settings, self.key, self.get())

    def restore(self, settings: QSettings) -> None:
        """Choose what was kept; what is chosen already stays, without a signal to views."""
        chosen = self.get()
        if (kept := read(settings, self.key, chosen)) != chosen:
            self.put(kept)


def keep(settings: QSettings, key: str, value: Any) -> None:
    """Keep a value as text: of a switch 1 or 0, of an enumeration its value, of a number six digits at most."""
    if isinstance(value, bool | float):
        value = f"{value:g}"
    settings.setValue(key, str(value.value if isinstance(value, Enum) else value))


def read(settings: QSettings, key: str, default: T) -> T:
    """Return what is kept, in the type of the default; the default where nothing is kept, or nothing that fits."""
    kept = settings.value(key)
    if kept is None:
        return default
    try:
        typed: T = _typed(str(kept), default)
    except (ValueError, OverflowError):  # the file was edited by hand
        return default
    return typed


def read_paths(settings: QSettings, key: str) -> list[Path]:
    """Return the paths that are kept; Qt gives a list of one back as a text, and an empty one as nothing."""
    kept = settings.value(key) or []
    return [Path(str(path)) for path in (kept if isinstance(kept, list) else [kept])]


def remember(settings: QSettings, key: str, path: Path) -> None:
    """Put a path first among those that were used last."""
    here = path.resolve()
    recent = [here, *(other for other in read_paths(settings, key) if other != here)]
    settings.setValue(key, list(map(str, recent[:N_RECENT])))


def _typed(text: str, default: Any) -> Any:
    if isinstance(default, bool):
        return text == "1"
    if isinstance(default, int):
        return round(float(text))
    number = type(default)(text)
    if isinstance(number, float) and not math.isfinite(number):
        raise ValueError(text)
    return number


PROGRAM = Path(__file__).resolve().parents[1]


def in_program(path: Path) -> bool:
    """Return whether a file is the program's own, as the demo is."""
    return path.resolve().is_relative_to(PROGRAM)


def outside_program(path: Path, *, make_folder: bool = False) -> Path:
    """Return where a file of the user's is; for one beside the demo, in a folder in Documents, which may be made."""
    if not in_program(path):
        return path
    folder = presets_folder().parent
    if make_folder:
        with suppress(OSError):  # then writing tells why not
            folder.mkdir(parents=True, exist_ok=True)
    return folder / path.name
