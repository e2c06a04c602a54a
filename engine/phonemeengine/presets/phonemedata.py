"""PhonemeData files: 21 numbers as text, the thesis's own format."""

import re
from dataclasses import fields

import numpy as np

from phonemeengine.arrays import LARGEST_FLOAT32
from phonemeengine.errors import PresetError
from phonemeengine.recognition.phoneme_data import LAYOUT, PhonemeData

_NAMES = tuple(name for line in LAYOUT for name in line)
_SPELLING = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?|[-+]?(nan|inf|infinity)", re.IGNORECASE)


def parse_phoneme_data(text: str) -> PhonemeData:
    """Read the 21 numbers from the text of a PhonemeData file.

    Commas, semicolons, spaces and line breaks may stand between them in any mix; a byte order mark is passed over.

    Raises
    ------
    PresetError : a wrong count, a word, NaN or infinity; names the line, the field and what was found.
    """
    found = [
        (number, word)
        for number, line in enumerate(text.removeprefix("\ufeff").splitlines(), 1)
        for word in re.split(r"[,;\s]+", line)
        if word
    ]
    values = {name: _number(word, line, name) for name, (line, word) in zip(_NAMES, found, strict=False)}
    if len(found) < len(_NAMES):
        raise PresetError(
            f"a PhonemeData file holds {len(_NAMES)} numbers, found {len(found)}; "
            f"the first one missing after line {found[-1][0] if found else 1} is {_NAMES[len(found)]}"
        )
    if len(found) > len(_NAMES):
        line, word = found[len(_NAMES)]
        raise PresetError(
            f"a PhonemeData file holds {len(_NAMES)} numbers and ends with {_NAMES[-1]}, "
            f"found {len(found)}; line {line} goes on with {_shown(word)}"
        )
    return PhonemeData(**values)


def format_phoneme_data(data: PhonemeData) -> str:
    """Write the 21 numbers as six lines, each with the fewest digits that keep its float32 value."""
    return "".join(",".join(_shortest(getattr(data, name)) for name in line) + "\n" for line in LAYOUT)


def _number(word: str, line: int, name: str) -> float:
    if not _SPELLING.fullmatch(word):
        raise PresetError(f"line {line}: {name} must be a number, found {_shown(word)}")
    value = float(word)
    if not abs(value) <= LARGEST_FLOAT32:
        raise PresetError(f"line {line}: {name} must be a finite number, found {_shown(word)}")
    return value


def _shown(word: str) -> str:
    return repr(word if len(word) <= 20 else word[:20] + "...")


def _shortest(value: float) -> str:
    return np.format_float_positional(np.float32(value), trim="-")


assert {field.name for field in fields(PhonemeData)} == set(_NAMES)
