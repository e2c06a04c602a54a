"""A folder with an ear that builds and runs as it is: the preset, the sources, examples and how to go on."""

import os
from collections.abc import Iterable, Sequence
from pathlib import Path

from phonemeengine.errors import ExportError, remedy
from phonemeengine.mouth.table import load_table
from phonemeengine.presets.preset import Preset
from phonemeengine.shipping.sections import (
    is_ear_file,
    join_sections,
    mouth_section,
    recogniser_sections,
    viseme_sections,
    viseme_set_of,
)
from phonemeengine.shipping.targets import TARGETS
from phonemeengine.storage.files import atomic_write, reason_of

USUAL_TABLES = ("arkit", "rhubarb")
MOST_TABLES = 16


def format_ear(preset: Preset, tables: Iterable[str | os.PathLike[str]] = USUAL_TABLES) -> bytes:
    """Return a preset as an ``.ear`` file: all that it hears with live, and mouth tables.

    Parameters
    ----------
    preset : what to recognise with.
    tables : the mouth tables that go with it, by name or file; the ear knows each by its name without an ending.

    Raises
    ------
    PresetError : its recogniser is another package's, or hears files alone.
    MouthError : a table cannot be used.
    ExportError : there are too many tables, or two of one name.
    """
    paths = list(tables)
    names = {Path(table).stem: table for table in paths}
    if len(names) < len(paths) or len(names) > MOST_TABLES:
        raise ExportError(
            f"an ear has at most {MOST_TABLES} mouth tables, each with a name of its own, got {len(paths)}; "
            "leave some out"
        )
    visemes, recogniser = viseme_set_of(preset), recogniser_sections(preset)
    mouths = [mouth_section(name, load_table(table), visemes) for name, table in names.items()]
    return join_sections([*viseme_sections(visemes), *recogniser, *mouths])


def ship(
    preset: Preset,
    folder: str | os.PathLike[str],
    target: str = "c",
    *,
    tables: Sequence[str | os.PathLike[str]] = USUAL_TABLES,
    overwrite: bool = False,
) -> tuple[Path, ...]:
    """Write a folder with which a program without Python hears as a preset does live; return its files.

    Parameters
    ----------
    preset : what to recognise with.
    folder : where; it is made where there is none.
    target : what for: one of `phonemeengine.shipping.targets.TARGETS`.
    tables : the mouth tables that go with it, by name or file.
    overwrite : whether files that were changed since they were shipped are replaced too.

    Raises
    ------
    PresetError : its recogniser is another package's, or hears files alone.
    MouthError : a table cannot be used.
    ExportError : there is no such target, what makes its files is missing, another file is there, or one cannot be
        written.
    """
    if target not in TARGETS:
        raise ExportError(f"there is no target {target!r:.40}; {remedy(target, TARGETS)}")
    folder = Path(folder)
    files = {TARGETS[target].preset: format_ear(preset, tables), **TARGETS[target].files()}
    for name, content in files.items():
        if not overwrite:
            _check_free(folder / name, content)
    for name, content in files.items():
        _write(folder / name, content)
    return tuple(folder / name for name in files)


def _check_free(path: Path, content: bytes) -> None:
    """Refuse to replace what somebody changed; a preset that was shipped before gives way to the new one."""
    try:
        there = path.read_bytes() if path.exists() else content
    except OSError as error:
        raise ExportError(f"{path}: cannot be read ({reason_of(error)}); choose another folder") from error
    if there != content and not (is_ear_file(content) and is_ear_file(there)):
        raise ExportError(
            f"{path}: another file is there, or it was changed; choose another folder, or have it replaced "
            "(--overwrite)"
        )


def _write(path: Path, content: bytes) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as file:
            file.write(content)
    except OSError as error:
        raise ExportError(f"{path}: cannot be written ({reason_of(error)}); choose another folder") from error
