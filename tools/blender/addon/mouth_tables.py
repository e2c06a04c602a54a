# SPDX-License-Identifier: MIT
"""Mouth tables as the panel edits them: the movements of each mouth shape, on the shape keys of a face."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from phonemeengine.errors import MouthError
from phonemeengine.mouth.table import MouthTable, table_of, table_to_toml

Movement = tuple[str, float]
"""A shape key, and the percentage of it."""

cached_table = lru_cache(maxsize=16)(table_of)
"""`table_of`, for a panel that is drawn again and again."""


def key_named(name: str, keys: Sequence[str]) -> str | None:
    """Return which shape key a movestate's name means: that name, or else one that differs in capitals alone."""
    if name in keys:
        return name
    return next((key for key in keys if key.casefold() == name.casefold()), None)


def movements_on(table: MouthTable, keys: Sequence[str]) -> dict[str, list[Movement]]:
    """Return the movements of each mouth shape, of those movestates that a face has shape keys for.

    Where the table has the names of a face, these count.
    """
    rows = 100 * table.on_face(table.shape_weights())
    return {
        shape: [
            (key, round(percent, 3))
            for name, percent in zip(table.face_names, row.tolist(), strict=True)
            if percent and (key := key_named(name, keys))
        ]
        for shape, row in zip(table.shapes, rows, strict=True)
    }


def with_movements(base: MouthTable, shapes: Mapping[str, Iterable[Movement]], keys: Sequence[str]) -> MouthTable:
    """Return a table with other movements, whose movestates are the shape keys of a face and whatever else it names.

    Raises
    ------
    MouthError : a movement has no shape key, or a shape has two of one.
    """
    percentages = {shape: _percentages_of(shape, movements) for shape, movements in shapes.items()}
    more = dict.fromkeys(key for movements in percentages.values() for key in movements if key not in keys)
    return replace(base, movestates=(*keys, *more), shapes=percentages, targets={})


def checked_toml(table: MouthTable) -> str:
    """Return the text of a table's file, which is known to be read again.

    Raises
    ------
    MouthError : it would be refused.
    """
    text = table_to_toml(table)
    table_of(text)
    return text


def sounds_of(table: MouthTable, shape: str) -> str:
    """Return for which phonemes and phones a table has a shape, for people."""
    phonemes = [phoneme.label for phoneme, name in table.phonemes.items() if name == shape]
    return ", ".join([*phonemes, *(phone for phone, name in table.phones.items() if name == shape)])


def _percentages_of(shape: str, movements: Iterable[Movement]) -> dict[str, float]:
    percentages: dict[str, float] = {}
    for key, percent in movements:
        if not key:
            raise MouthError(f"shape {shape} has a movement without a shape key; choose one, or remove it")
        if key in percentages:
            raise MouthError(f"shape {shape} moves {key!r} twice; remove one")
        percentages[key] = percent
    return percentages
