"""The text of a mouth table's file: TOML that `table.table_of` reads as the same table."""

from typing import Any

import tomli_w

from phonemeengine.mouth.blendshape_names import NAMES
from phonemeengine.mouth.motion_settings import TransitionTimes
from phonemeengine.mouth.table import FORMAT, MouthTable


def table_to_toml(table: MouthTable) -> str:
    """Write a mouth table as the text of a TOML file; every phoneme has its times by name."""
    known = [name for name, movestates in NAMES.items() if movestates == table.movestates]
    document: dict[str, Any] = {
        "format": FORMAT,
        "name": table.name,
        "notes": table.notes,
        "movestates": known[0] if known else list(table.movestates),
        "firm": [phoneme.label for phoneme in sorted(table.closed_phonemes)],
        "phonemes": {phoneme.label: shape for phoneme, shape in table.phonemes.items()},
        "phones": {name: _phone_entry(table, name) for name in table.phones},
        "times": {phoneme.label: _times_entry(times) for phoneme, times in table.times.items()},
        "manner": {
            "loudness": table.motion.loudness,
            "quiet": table.motion.minimum_opening,
            "randomness": table.motion.randomness,
        },
        "shapes": {name: dict(percentages) for name, percentages in table.shapes.items()},
    }
    return tomli_w.dumps(document)


def _phone_entry(table: MouthTable, name: str) -> str | dict[str, Any]:
    """Return what [phones] says of a phone or class: a shape alone, where it says no more."""
    times = table.phone_times.get(name)
    firm = {"firm": True} if name in table.closed_phones else {}
    more = (_times_entry(times) if times else {}) | firm
    return {"shape": table.phones[name]} | more if more else table.phones[name]


def _times_entry(times: TransitionTimes) -> dict[str, float]:
    return {"attack": times.attack, "release": times.release}
