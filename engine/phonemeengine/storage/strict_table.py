"""Tables of files that people edit, read strictly: what does not fit is refused in one sentence, never guessed at."""

import os
import reprlib
import tomllib
from collections.abc import Callable, Collection, Iterator, Mapping
from enum import Enum
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeVar, cast

from phonemeengine.arrays import LARGEST_FLOAT32
from phonemeengine.errors import EngineError, remedy
from phonemeengine.phonemes import PHONEMES_BY_LABEL, Phoneme
from phonemeengine.storage.files import printable_name, read_text_file

T = TypeVar("T")

LARGEST_FILE = 1 << 20
"""Bytes: no person writes a longer one."""

_WORDS: dict[type, str] = {
    str: "text",
    bool: "true or false",
    int: "a whole number within ±3.4e38",
    float: "a number within ±3.4e38",
    list: "a list",
    dict: "a table",
}


class StrictTable:
    """A table of a file, asked for its entries by name and type.

    Parameters
    ----------
    entries : as `tomllib` or `json` gives them.
    name : what a refusal calls the table, such as ``a preset`` or ``[front_end]``.
    error : what a refusal is.
    """

    def __init__(self, entries: Mapping[str, Any], name: str, error: type[EngineError]) -> None:
        self.entries = entries
        self.name = name
        self._error = error

    def __contains__(self, key: str) -> bool:
        return key in self.entries

    def refusal(self, key: str, must: str, value: Any) -> EngineError:
        """Return the error that says of an entry what it must be, and what came."""
        return self._error(f"{self._prefix}{key} must be {must}, found {shown(value)}; correct it")

    def check_keys(self, required: Collection[str], optional: Collection[str] = ()) -> None:
        """Refuse unknown entries, and the lack of one that is required."""
        known = [*required, *optional]
        for key in self.entries:
            if key not in known:
                words = remedy(key, known, "remove it, or use one of {}")
                raise self._error(f"{self.name} cannot have an entry {shown(key)}; {words}")
        for key in required:
            if key not in self.entries:
                raise self._error(f"{self.name} lacks {key}; add it")

    def read(self, kinds: Mapping[str, type], optional: Collection[str] = ()) -> dict[str, Any]:
        """Return all entries, each of its kind as for `value`; refuse others, and a lack of those not optional."""
        self.check_keys([key for key in kinds if key not in optional], [key for key in kinds if key in optional])
        return {key: self.value(key, kind) for key, kind in kinds.items() if key in self.entries}

    def value(self, key: str, kind: type[T], default: T | None = None) -> T:
        """Return an entry: text, a truth, a number, a list, a table or a member of an enumeration, as `kind` says.

        Where there is a default, it stands for an entry that is not there.
        """
        if default is not None and key not in self:
            return default
        value = self.entries[key]
        if issubclass(kind, Enum):
            return cast("T", self._member(key, value, kind))
        fits = _is_number(value) if kind is float else type(value) is kind
        if not fits or (kind is int and not _is_number(value)):
            raise self.refusal(key, _WORDS[kind], value)
        return cast("T", float(value) if kind is float else value)

    def members(self, key: str, kind: type[T]) -> tuple[T, ...]:
        """Return a list of members of an enumeration."""
        return tuple(self._member(key, value, kind) for value in self.value(key, list))

    def numbers(self, key: str) -> tuple[float, ...]:
        """Return a list of numbers."""
        values = self.value(key, list)
        if not all(map(_is_number, values)):
            raise self.refusal(key, "a list of numbers within ±3.4e38", values)
        return tuple(map(float, values))

    def limited(self, key: str, low: float, high: float, what: str, default: float | None = None) -> float:
        """Return a number that must lie in ``low..high``, as `what` says, or the default of one that is not there."""
        if default is not None and key not in self:
            return default
        value = self.entries[key]
        if not _is_number(value) or not low <= value <= high:
            raise self.refusal(key, what, value)
        return float(value)

    def table(self, key: str) -> "StrictTable":
        """Return a table in this one; an empty one where there is none."""
        entries = self.value(key, dict, {})
        return StrictTable(entries, f"{self.name[:-1]}.{key}]" if self._prefix else f"[{key}]", self._error)

    def tables_by_name(self) -> Iterator[tuple[str, "StrictTable"]]:
        """Return all entries, which must be tables, with their names."""
        return ((key, self.table(key)) for key in self.entries)

    def tables(self, key: str) -> list["StrictTable"]:
        """Return a list of tables; an empty one where there is none."""
        entries = self.value(key, list, [])
        if any(type(entry) is not dict for entry in entries):
            raise self.refusal(key, "a list of tables", entries)
        return [StrictTable(entry, f"[{key}]", self._error) for entry in entries]

    def phonemes(self) -> dict[Phoneme, str]:
        """Return the phonemes that the entries are about, and for each its entry's name."""
        for key in self.entries:
            if key not in PHONEMES_BY_LABEL:
                words = remedy(key, PHONEMES_BY_LABEL)
                raise self._error(f"{self.name}: there is no phoneme {shown(key)}; {words}")
        return {PHONEMES_BY_LABEL[key]: key for key in self.entries}

    @property
    def _prefix(self) -> str:
        return f"{self.name} " if self.name.startswith("[") else ""

    def _member(self, key: str, value: Any, kind: type[Any]) -> Any:
        names = PHONEMES_BY_LABEL if kind is Phoneme else {member.value: member for member in kind}
        try:
            if isinstance(value, str):
                return names[value] if kind is Phoneme else kind(value)  # an enumeration may know older names
        except (KeyError, ValueError):  # refused below, as what is no text
            pass
        raise self.refusal(key, f"one of {', '.join(names)}", value)


def parse_toml(
    text: str,
    name: str,
    form: str,
    error: type[EngineError],
    older: Mapping[str, Mapping[str, str]] = MappingProxyType({}),
) -> StrictTable:
    """Return the top of a TOML file of one of our formats.

    Parameters
    ----------
    name : what such a file is called in a sentence, such as ``a preset``.
    form : what its entry ``format`` must say.
    older : older formats that are read too, each with the entries of its top that have another name now: the new name
        by the old one.

    Raises
    ------
    EngineError : `error`, because it is no TOML, or not of this format.
    """
    try:
        document = tomllib.loads(text)
    except (ValueError, RecursionError) as cause:
        raise error(f"this is no TOML file ({cause}); correct it there") from cause
    found, names = document.pop("format", None), {form: {}, **older}
    if not isinstance(found, str) or found not in names:
        came = "none" if found is None else shown(found)
        raise error(f"{name} begins with format = {form!r}, found {came}; choose another file, or update the program")
    return StrictTable({names[found].get(key, key): value for key, value in document.items()}, name, error)


def load_text(
    path: str | os.PathLike[str],
    what: str,
    error: type[EngineError],
    parse: Callable[[str], T],
    largest: int = LARGEST_FILE,
) -> T:
    """Return what is written in a text file of one of our formats.

    Parameters
    ----------
    what : what such a file is called where another is chosen, such as ``a mouth table (.toml)``.
    parse : reads the text.
    largest : bytes.

    Raises
    ------
    EngineError : `error`, because it cannot be read, or `parse` refuses its text; the message names the file.
    """
    text = read_text_file(Path(path), largest, what, error)
    try:
        return parse(text)
    except error as refused:
        raise error(f"{printable_name(Path(path))}: {refused}") from refused


def _is_number(value: Any) -> bool:
    return type(value) in {int, float} and abs(value) <= LARGEST_FLOAT32


def shown(value: Any) -> str:
    """Return a value as a sentence names it, however long or deep it is."""
    if isinstance(value, list | dict):
        return reprlib.repr(value)
    return "an endless number" if type(value) is int and abs(value) > LARGEST_FLOAT32 else f"{value!r:.60}"
