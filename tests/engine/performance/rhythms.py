"""Sentences as rhythms, and performances of them whose heads move in ways that can be told beforehand."""

from collections.abc import Callable, Mapping
from itertools import count, pairwise
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float64Array
from phonemeengine.performance.recording import SILENCE, Performance, PerformedPhone
from phonemeengine.performance.table_file import PerformanceTable, write_table

RATE = 60.0
PAUSE = 0.3
Movement = Callable[[Float64Array], Float64Array]


def said(rhythm: str, length: float = 0.2, pause: float = PAUSE) -> tuple[PerformedPhone, ...]:
    """Give the phones of a rhythm such as ``"da.DA da, DA"``: each syllable a phone, those in capitals stressed.

    Spaces part words, full stops syllables; a comma is a pause, and there is one before and after all.
    """
    found: list[tuple[float, str, int, int, int]] = [(pause, SILENCE, -1, -1, 0)]
    numbers = count()
    for word, text in enumerate(rhythm.split()):
        syllables = text.strip(",").split(".")
        found += [(length, part.lower(), word, next(numbers), int(part.isupper())) for part in syllables]
        if text.endswith(","):
            found.append((pause, SILENCE, -1, -1, 0))
    found.append((pause, SILENCE, -1, -1, 0))
    at = [0.0, *np.cumsum([duration for duration, *_ in found]).tolist()]
    return tuple(
        PerformedPhone(start, (start + end) / 2, end, name, word, syllable, stress)
        for (start, end), (_, name, word, syllable, stress) in zip(pairwise(at), found, strict=True)
    )


def words_of(rhythm: str) -> tuple[str, ...]:
    """Give the words of a rhythm."""
    return tuple(rhythm.split())


def performed(rhythm: str, movements: Mapping[str, Movement], length: float = 0.2) -> Performance:
    """Give a performance of a rhythm whose channels are functions of time."""
    phones = said(rhythm, length)
    times = np.arange(int(phones[-1].end * RATE + 1e-6) + 1) / RATE
    weights = np.stack([movement(times) for movement in movements.values()], axis=1).astype(np.float32)
    return Performance(rhythm, RATE, tuple(movements), weights, phones, words_of(rhythm))


def table_of(folder: Path, *performances: Performance) -> PerformanceTable:
    """Write a table of performances, and open it."""
    path = folder / "rhythms.sqlite"
    write_table(path, performances)
    return PerformanceTable.open(path)
