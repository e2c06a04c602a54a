"""The text of a preset file: TOML with every number by name, read strictly.

It holds the 21 numbers of a PhonemeData file, the front end, the statistics, the intensity's range, the user's own
variables and rules, the recogniser's name and notes.
"""

import math
import re
import reprlib
import tomllib
from dataclasses import asdict, fields, replace
from pathlib import Path
from typing import Any

import tomli_w

from phonemeengine.errors import PresetError, SettingsError
from phonemeengine.features.variables import Kind, Spectrum, Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.presets.templates_table import table_of_templates, templates_of_table
from phonemeengine.recognition.model import Model, load_model
from phonemeengine.recognition.phoneme_data import LARGEST, PhonemeData
from phonemeengine.recognition.rules import Condition, Rule
from phonemeengine.recognition.smoothing import SUCCESSORS
from phonemeengine.recognition.spec import THESIS
from phonemeengine.settings import AnalysisSettings, Decimation, Filter, WindowFunction

FORMAT = "phonemeanalyser preset 1"

FRONT_END = (
    "filters", "quantise", "decimation", "pre_emphasis", "window_function", "low_pass_start", "low_pass_end",
    "mel_bands",
)  # fmt: skip
_CHOICES = ("decimation", "window_function")
STATISTICS = ("statistics", "minimum_hold", "hysteresis")
INTENSITY = ("intensity_low", "intensity_high")
_AHEAD = ("look_ahead", "live_look_ahead")
_PLAIN = (
    "format", "name", "recogniser", *_AHEAD, "model", "notes", "variables", "rules", "successors", "templates",
    "sensitivities",
)  # fmt: skip
_TABLES = ("front_end", "phoneme_data", "statistics", "intensity")
_VARIABLE = ("name", "low", "high", "kind", "source")
_OPTIONAL = ("per",)
"""What a variable may have besides."""

# what stands in a preset file, where it is not just a number
_TYPES: dict[str, type] = {
    **dict.fromkeys(("format", "name", "recogniser", "model", "notes", "kind", "source", "per", "phoneme"), str),
    **dict.fromkeys(_CHOICES, str),
    **dict.fromkeys(("variables", "filters", "rules", "conditions"), list),
    **dict.fromkeys(("quantise", "mel_bands"), int),
    **dict.fromkeys(("successors", "templates", "sensitivities"), dict),
    "statistics": bool,
}
PHONEME_NAMES = {p.label: p for p in Phoneme}
_CONDITION = re.compile(r"([a-z][a-z0-9_]*) *([<>]) *(\S+)")
_WORDS = {str: "text", list: "a list", int: "a whole number", dict: "a table", bool: "true or false"}


def preset_to_toml(preset: Preset, model: str = "") -> str:
    """Write a preset as the text of a TOML file; `model` is the name of its model's file, in the same folder."""
    settings = preset.settings
    front_end: dict[str, Any] = {name: getattr(settings, name) for name in FRONT_END}
    front_end["filters"] = [f.value for f in Filter if settings.has(f)]
    document = {
        "format": FORMAT,
        "name": preset.name,
        "recogniser": preset.recogniser,
        **{name: getattr(settings, name) for name in _AHEAD},
        **({"model": model} if model else {}),
        "notes": preset.notes,
        "front_end": front_end,
        "phoneme_data": asdict(preset.phoneme_data),
        "statistics": {name: getattr(settings, name) for name in STATISTICS},
        "intensity": {name: getattr(settings, name) for name in INTENSITY},
        "successors": {p.label: q.label for p, q in preset.successors.items()},
        **({"sensitivities": _table_of_sensitivities(preset)} if preset.sensitivities else {}),
        "variables": [_document_of(variable) for variable in preset.variables],
        "rules": [
            {"phoneme": rule.phoneme.label, "conditions": [str(c) for c in rule.conditions]} for rule in preset.rules
        ],
        **({"templates": table_of_templates(preset.templates)} if preset.templates else {}),
    }
    return tomli_w.dumps(_plain(document), multiline_strings=True)


def preset_from_toml(text: str, folder: Path) -> Preset:
    """Read a preset from the text of a TOML file; a model that it names lies in `folder`.

    Raises
    ------
    PresetError : not TOML, not of this format, an unknown or missing name, or a value out of range.
    ModelError : its model cannot be read.
    """
    try:
        document = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise PresetError(f"this is no TOML file: {error}") from error
    if document.get("format") != FORMAT:
        raise PresetError(f"a preset begins with format = {FORMAT!r}, found {_shown(document.get('format'))}")
    try:
        return _preset_of(document, folder)
    except SettingsError as error:
        raise PresetError(str(error)) from error


def _preset_of(document: dict[str, Any], folder: Path) -> Preset:
    for key in document.keys() - {*_PLAIN, *_TABLES}:
        raise PresetError(f"a preset does not know {key[:60]}")
    texts = _checked({key: document[key] for key in _PLAIN if key in document})
    front_end = _table(document, "front_end", FRONT_END)
    front_end["filters"] = frozenset(_choice(Filter, f, "filters") for f in front_end["filters"])
    front_end["decimation"] = _choice(Decimation, front_end["decimation"], "decimation")
    front_end["window_function"] = _choice(WindowFunction, front_end["window_function"], "window_function")
    statistics = _table(document, "statistics", STATISTICS, optional=("hysteresis",))
    intensity = _table(document, "intensity", INTENSITY)
    ahead = {key: texts[key] for key in _AHEAD if key in texts}
    data = _table(document, "phoneme_data", tuple(f.name for f in fields(PhonemeData)))
    preset = Preset(
        name=texts.get("name", "untitled"),
        settings=AnalysisSettings(**front_end, **statistics, **intensity, **ahead),
        variables=tuple(_variable_of(entry) for entry in texts.get("variables", [])),
        recogniser=texts.get("recogniser", THESIS.name),
        model=_model_of(texts["model"], folder) if texts.get("model") else None,
        rules=tuple(_rule_of(entry) for entry in texts.get("rules", [])),
        templates=templates_of_table(texts["templates"]) if "templates" in texts else None,
        sensitivities=_sensitivities_of(texts.get("sensitivities", {})),
        successors=_successors_of(texts.get("successors", {})),
        notes=texts.get("notes", ""),
    )
    preset = preset.with_phoneme_data(PhonemeData(**data))
    return replace(preset, settings=replace(preset.settings, filters=front_end["filters"]))


def _table(
    document: dict[str, Any], name: str, keys: tuple[str, ...], optional: tuple[str, ...] = ()
) -> dict[str, Any]:
    table = document.get(name)
    if not isinstance(table, dict):
        raise PresetError(f"the table [{name}] is missing")
    for key in (table.keys() ^ set(keys)) - set(optional):
        raise PresetError(f"[{name}] lacks {key}" if key in keys else f"[{name}] does not know {key[:60]}")
    return _checked(table)


def _checked(table: dict[str, Any]) -> dict[str, Any]:
    """Return a copy of a table, after refusing values of the wrong type and numbers that no float32 holds."""
    for key, value in table.items():
        expected = _TYPES.get(key, float)
        fits = isinstance(value, int | float if expected is float else expected)
        if not fits or isinstance(value, bool) != (expected is bool):
            raise PresetError(f"{key} must be {_WORDS.get(expected, 'a number')}, found {_shown(value)}")
        if isinstance(value, int | float) and not abs(value) <= LARGEST:
            raise PresetError(f"{key} must be a finite number within ±3.4e38, found {_shown(value)}")
    return dict(table)


def _shown(value: Any) -> str:
    if isinstance(value, list | dict):
        return reprlib.repr(value)  # however deep it is
    endless = isinstance(value, int) and abs(value) > LARGEST
    return "an endless number" if endless else f"{value!r:.60}"


def _choice(kind: Any, value: Any, name: str) -> Any:
    try:
        return kind(value)
    except ValueError:
        raise PresetError(f"{name} must be one of {', '.join(kind)}, found {_shown(value)}") from None


def _variable_of(entry: Any) -> Variable:
    values = _table({"variables": entry}, "variables", (*_VARIABLE, *_OPTIONAL), optional=_OPTIONAL)
    kind, source = _choice(Kind, values["kind"], "kind"), _choice(Spectrum, values["source"], "source")
    low, high = float(values["low"]), float(values["high"])
    return Variable(values["name"], low, high, kind, source, values.get("per", ""))


def _document_of(variable: Variable) -> dict[str, Any]:
    return {key: value for key, value in asdict(variable).items() if value or key not in _OPTIONAL}


def _model_of(name: str, folder: Path) -> Model:
    if "/" in name or "\\" in name or name.startswith("."):
        raise PresetError(
            f"a model lies beside its preset, so model is a plain name such as voice.npz, found {_shown(name)}"
        )
    return load_model(folder / name)


def _rule_of(entry: Any) -> Rule:
    values = _table({"rules": entry}, "rules", ("phoneme", "conditions"))
    if values["phoneme"] not in PHONEME_NAMES:
        raise PresetError(
            f"[rules] knows no phoneme {_shown(values['phoneme'])}; known are {', '.join(PHONEME_NAMES)}"
        )
    return Rule(PHONEME_NAMES[values["phoneme"]], tuple(_condition_of(text) for text in values["conditions"]))


def _condition_of(text: Any) -> Condition:
    """Read a condition such as ``m_a1 < 3.5``."""
    found = _CONDITION.fullmatch(text) if isinstance(text, str) else None
    try:
        limit = float(found[3]) if found else math.nan
    except ValueError:
        limit = math.nan
    if found is None or not abs(limit) <= LARGEST:
        raise PresetError(
            f"a condition of a rule is a variable, < or >, and a number, such as m_a1 < 3.5; found {_shown(text)}"
        )
    return Condition(found[1], found[2], limit=limit)


def _table_of_sensitivities(preset: Preset) -> dict[str, float]:
    return {p.label: float(preset.sensitivities[p]) for p in Phoneme if p in preset.sensitivities}


def _sensitivities_of(table: dict[str, Any]) -> dict[Phoneme, float]:
    for name in table:
        if name not in PHONEME_NAMES:
            raise PresetError(f"[sensitivities] knows no phoneme {name!r:.60}; known are {', '.join(PHONEME_NAMES)}")
    return {PHONEME_NAMES[name]: float(value) for name, value in _checked(table).items()}


def _successors_of(table: dict[str, Any]) -> dict[Phoneme, Phoneme]:
    known = PHONEME_NAMES
    for name in [*table.keys(), *table.values()]:
        if not isinstance(name, str) or name not in known:
            raise PresetError(f"[successors] knows no phoneme {_shown(name)}; known are {', '.join(known)}")
    return {**SUCCESSORS, **{known[p]: known[q] for p, q in table.items()}}


def _plain(value: Any) -> Any:
    """Turn enumerations into the text that TOML knows."""
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [_plain(entry) for entry in value]
    return str(value) if isinstance(value, str) else value
