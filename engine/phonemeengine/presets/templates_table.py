"""The table [templates] of a preset file: for each phoneme its 12 mean cepstra, their spread, and what is silence."""

from collections.abc import Mapping
from typing import Any

from phonemeengine.errors import PresetError
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.templates import UNTEMPLATED, Templates

_PHONEMES = {p.label: p for p in Phoneme if p not in UNTEMPLATED}
_NUMBERS = ("spread", "silence_below")


def table_of_templates(templates: Templates) -> dict[str, Any]:
    """Write templates as a table."""
    rows = {phoneme.label: list(row) for phoneme, row in templates.means.items()}
    return {"silence_below": templates.silence_below, "spread": list(templates.spread), **rows}


def templates_of_table(table: Mapping[str, Any]) -> Templates:
    """Read templates from a table.

    Raises
    ------
    PresetError : an unknown or missing name, or no numbers.
    SettingsError : a template has the wrong length, or a number is impossible.
    """
    for name in table:
        if name not in _PHONEMES and name not in _NUMBERS:
            raise PresetError(f"[templates] does not know {name:.60}; known are {', '.join((*_NUMBERS, *_PHONEMES))}")
    for name in _NUMBERS:
        if name not in table:
            raise PresetError(f"[templates] lacks {name}")
    means = {phoneme: _numbers(table, name) for name, phoneme in _PHONEMES.items() if name in table}
    (silence_below,) = _numbers({"silence_below": [table["silence_below"]]}, "silence_below")
    return Templates(means, _numbers(table, "spread"), silence_below)


def _numbers(table: Mapping[str, Any], name: str) -> tuple[float, ...]:
    row = table[name]
    if not isinstance(row, list) or any(isinstance(v, bool) or not isinstance(v, int | float) for v in row):
        wanted = "a number" if name == "silence_below" else "a list of numbers"
        raise PresetError(f"{name} of [templates] must be {wanted}, found {row!r:.60}")
    try:
        return tuple(float(value) for value in row)
    except OverflowError:
        raise PresetError(f"{name} of [templates] must hold finite numbers, found an endless one") from None
