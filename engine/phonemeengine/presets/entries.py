"""What can be said of a preset file without loading it: its name, and one line that says what it is."""

import tomllib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from phonemeengine.presets.files import LARGEST_FILE, is_phoneme_data

LONGEST_SUMMARY = 110
"""Characters."""


@dataclass(frozen=True)
class PresetEntry:
    """A preset file, as a list of presets shows it.

    Attributes
    ----------
    path : the file.
    name : what the preset is called.
    summary : what it is, in one line; may be empty.
    """

    path: Path
    name: str
    summary: str


def preset_entries(paths: Iterable[Path]) -> tuple[PresetEntry, ...]:
    """Return the entries of those files that look like presets; whoever loads one hears what is wrong with it."""
    return tuple(_entries(paths))


def _entries(paths: Iterable[Path]) -> Iterator[PresetEntry]:
    for path in paths:
        if not path.is_file() or path.stat().st_size > LARGEST_FILE:
            continue
        if is_phoneme_data(path):
            yield PresetEntry(path, path.stem, "The rules of the thesis with the 21 numbers of a PhonemeData file.")
            continue
        try:
            document = tomllib.loads(path.read_text(encoding="utf-8-sig"))
        except (OSError, ValueError, RecursionError):
            continue
        notes = str(document.get("notes", "")).strip().partition("\n")[0]
        yield PresetEntry(path, str(document.get("name", path.stem)), _shortened(notes))


def _shortened(line: str) -> str:
    return line if len(line) <= LONGEST_SUMMARY else line[: LONGEST_SUMMARY - 1] + "…"
