"""The table [templates] of a preset file: for each phoneme its 12 mean cepstra, their spread, and what is silence."""

from typing import Any

from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.templates import UNTEMPLATED, Templates
from phonemeengine.strict_table import StrictTable

_PHONEMES = {p.label: p for p in Phoneme if p not in UNTEMPLATED}
_NUMBERS = ("spread", "silence_below")


def table_of_templates(templates: Templates) -> dict[str, Any]:
    """Write templates as a table."""
    rows = {phoneme.label: list(row) for phoneme, row in templates.means.items()}
    return {"silence_below": templates.silence_below, "spread": list(templates.spread), **rows}


def templates_of_table(table: StrictTable) -> Templates:
    """Read templates from a table.

    Raises
    ------
    PresetError : an unknown or missing name, or no numbers.
    SettingsError : a template has the wrong length, or a number is impossible.
    """
    table.check_keys(_NUMBERS, _PHONEMES)
    means = {phoneme: table.numbers(name) for name, phoneme in _PHONEMES.items() if name in table}
    return Templates(means, table.numbers("spread"), table.value("silence_below", float))
