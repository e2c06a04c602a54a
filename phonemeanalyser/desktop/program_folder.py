"""The program's own folder, where nothing of the user's is written: it may be read-only, and updates empty it."""

from contextlib import suppress
from pathlib import Path

from phonemeengine.storage.paths import presets_folder

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
