"""The text of a preset file: TOML with every number by name, read strictly.

It holds the 21 numbers of a PhonemeData file, the front end, the statistics, the intensity's range, the user's own
variables and rules, the recogniser's name and notes.
"""

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import asdict, fields, replace
from pathlib import Path
from typing import Any, TypeVar

import tomli_w

from phonemeengine.arrays import LARGEST_FLOAT32
from phonemeengine.encoder.head import load_head
from phonemeengine.encoder.live import load_live_encoder
from phonemeengine.errors import ModelError, PresetError, SettingsError
from phonemeengine.features.variables import Kind, Spectrum, Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset, judgement_of
from phonemeengine.recognition.model import load_model
from phonemeengine.recognition.rules import FILTER_FIELDS, Condition, PhonemeData, PitchSet, Rule
from phonemeengine.recognition.scores import ConfidenceCurve
from phonemeengine.recognition.segments import SUCCESSORS
from phonemeengine.recognition.spec import THESIS
from phonemeengine.recognition.templates import UNTEMPLATED, Templates
from phonemeengine.settings import OLD_MODEL_KINDS, PARAMETERS, STAGES, AnalysisSettings, Filter, ModelKind
from phonemeengine.storage.strict_table import StrictTable, parse_toml, shown

T = TypeVar("T")

FORMAT = "phonemeanalyser preset 2"
_OLDER = {"phonemeanalyser preset 1": {"file_model": "offline_model", "file_ear": "file_model"}}
"""What the keys of older formats are called now."""

# what stands in each table, and of which kind it is
_USUAL = AnalysisSettings()
_KINDS: dict[str, dict[str, type]] = {
    name: {of.name: type(getattr(_USUAL, of.name)) for of in stage.parameters if of.name not in FILTER_FIELDS}
    for name, stage in STAGES.items()
}
FRONT_END: dict[str, type] = {"filters": list, **{n: kind for f in Filter for n, kind in _KINDS[f].items()}}
STATISTICS: dict[str, type] = {"statistics": bool, **_KINDS["statistics"]}
INTENSITY = _KINDS["intensity"]
_AHEAD = _KINDS["look_ahead"]
_OPTIONAL = [name for name, parameter in PARAMETERS.items() if parameter.optional]
_TEXTS = ("name", "recogniser", "model", "offline_model", "encoder_head", "live_encoder", "notes")
_VARIABLE: dict[str, type] = {"name": str, "low": float, "high": float, "kind": Kind, "source": Spectrum, "per": str}
_RULE: dict[str, type] = {"phoneme": Phoneme, "conditions": list, "enabled": bool}
_PITCH_SET: dict[str, type] = {"name": str, "low": float, "high": float}
_PHONEME_DATA: dict[str, type] = {field.name: float for field in fields(PhonemeData)}

_TABLES = ("front_end", "phoneme_data", "statistics", "intensity")
_CURVE = ("scores", "shares")
_OPTIONAL_TABLES = (
    "variables", "rules", "successors", "templates", "sensitivities", "confidence", "judged", "pitch_sets",
    "confusions",
)  # fmt: skip
_TEMPLATED = {p.label: p for p in Phoneme if p not in UNTEMPLATED}
_TEMPLATE_NUMBERS = ("spread", "silence_below")
_CONDITION = re.compile(r"(# *)?([a-z][a-z0-9_]*) *([<>]) *(\S+)")
_OFF = "# "
"""What stands before a condition that is switched off."""


def preset_to_toml(preset: Preset, models: Mapping[str, str] | None = None) -> str:
    """Write a preset as the text of a TOML file.

    `models` holds the names of its models' files, in the same folder, by the names of the fields.
    """
    settings = preset.settings
    front_end: dict[str, Any] = {name: getattr(settings, name) for name in FRONT_END}
    front_end["filters"] = [f.value for f in Filter if settings.has(f)]
    document = {
        "format": FORMAT,
        "name": preset.name,
        "recogniser": preset.recogniser,
        **{name: getattr(settings, name) for name in _AHEAD},
        **(models or {}),
        "live_model": None if preset.live_model is ModelKind.ENCODER else preset.live_model,
        "file_model": None if preset.file_model is ModelKind.WHISPER else preset.file_model,
        "notes": preset.notes,
        "front_end": front_end,
        "phoneme_data": asdict(preset.phoneme_data),
        "statistics": {name: getattr(settings, name) for name in STATISTICS},
        "intensity": {name: getattr(settings, name) for name in INTENSITY},
        "successors": {p.label: q.label for p, q in preset.successors.items()},
        "sensitivities": {p.label: float(preset.sensitivities[p]) for p in Phoneme if p in preset.sensitivities}
        or None,
        "confusions": {p.label: list(row) for p, row in preset.confusions.items()} or None,
        "confidence": {k: asdict(preset.confidences[k]) for k in ModelKind if k in preset.confidences} or None,
        "variables": [_document_of(variable) for variable in preset.variables],
        "rules": [_document_of_rule(rule) for rule in preset.rules],
        "templates": _table_of_templates(preset.templates) if preset.templates else None,
        "judged": preset.judged.table() if preset.judged else None,
        "pitch_sets": [_table_of_set(pitch_set) for pitch_set in preset.pitch_sets] or None,
    }
    present = {key: entry for key, entry in document.items() if entry is not None}
    return tomli_w.dumps(_plain(present), multiline_strings=True)


def preset_from_toml(text: str, folder: Path, shipped: Path | None = None) -> Preset:
    """Read a preset from the text of a TOML file; models that it names lie in `folder`.

    A real-time model that is not there may lie in `shipped`. One of these, or one for files, that cannot be read is
    left out, which `Preset.warnings` says.

    Raises
    ------
    PresetError : not TOML, not of this format, an unknown or missing name, or a value out of range.
    ModelError : its model cannot be read.
    """
    top = parse_toml(text, "a preset", FORMAT, PresetError, _OLDER)
    try:
        return _preset_of(top, folder, shipped)
    except SettingsError as error:
        raise PresetError(str(error)) from error


def _preset_of(top: StrictTable, folder: Path, shipped: Path | None) -> Preset:
    top.check_keys(_TABLES, (*_TEXTS, "live_model", "file_model", *_AHEAD, *_OPTIONAL_TABLES))
    texts = {key: top.value(key, str) for key in _TEXTS if key in top}
    settings = _settings_of(top)
    lost: list[str] = []

    def read(key: str, load: Callable[[Path], T], meanwhile: str) -> T | None:
        try:
            return load(_beside(texts[key], folder)) if texts.get(key) else None
        except ModelError as error:
            lost.append(f"{error}; until then {meanwhile}")
            return None

    offline_model = read("offline_model", load_model, "the real-time model recognises files")
    if offline_model is not None and not offline_model.centred:
        lost.append(f"{texts['offline_model']}: this is no offline model; the real-time model recognises files")
        offline_model = None
    encoder_head = read("encoder_head", load_head, "files are recognised without Whisper")
    live_encoder = read(
        "live_encoder",
        lambda path: load_live_encoder(path if path.exists() or shipped is None else shipped / path.name),
        "the small network recognises live sound",
    )
    preset = Preset(
        name=texts.get("name", "untitled"),
        settings=settings,
        variables=tuple(Variable(**entry.read(_VARIABLE, ("per",))) for entry in top.tables("variables")),
        recogniser=texts.get("recogniser", THESIS.name),
        model=load_model(_beside(texts["model"], folder)) if texts.get("model") else None,
        offline_model=offline_model,
        encoder_head=encoder_head,
        live_encoder=live_encoder,
        live_model=top.value("live_model", ModelKind, ModelKind.ENCODER),
        file_model=top.value("file_model", ModelKind, ModelKind.WHISPER),
        rules=tuple(_rule_of(entry) for entry in top.tables("rules")),
        templates=_templates_of_table(top.table("templates")) if "templates" in top else None,
        sensitivities=_sensitivities_of(top.table("sensitivities")),
        successors=_successors_of(top.table("successors")),
        pitch_sets=tuple(_set_of_table(entry) for entry in top.tables("pitch_sets")),
        confusions=_confusions_of(top.table("confusions")),
        confidences=_curves_of(top.table("confidence")),
        judged=judgement_of(top.table("judged")) if "judged" in top else None,
        notes=texts.get("notes", ""),
        warnings=tuple(lost),
    )
    preset = preset.with_phoneme_data(PhonemeData(**top.table("phoneme_data").read(_PHONEME_DATA)))
    return replace(preset, settings=replace(preset.settings, filters=settings.filters))


def _settings_of(top: StrictTable) -> AnalysisSettings:
    front_end = top.table("front_end")
    values = front_end.read(FRONT_END, _OPTIONAL) | {"filters": frozenset(front_end.members("filters", Filter))}
    values |= top.table("statistics").read(STATISTICS, _OPTIONAL) | top.table("intensity").read(INTENSITY, _OPTIONAL)
    return AnalysisSettings(**values | {key: top.value(key, float) for key in _AHEAD if key in top})


def _document_of(variable: Variable) -> dict[str, Any]:
    return {key: value for key, value in asdict(variable).items() if value or key != "per"}


def _beside(name: str, folder: Path) -> Path:
    if "/" in name or "\\" in name or name.startswith("."):
        raise PresetError(
            f"a model lies beside its preset, so model is a plain name such as voice.npz, found {shown(name)}; "
            "correct it"
        )
    return folder / name


def _document_of_rule(rule: Rule) -> dict[str, Any]:
    conditions = [f"{'' if c.enabled else _OFF}{c}" for c in rule.conditions]
    return {"phoneme": rule.phoneme.label, "conditions": conditions, **({} if rule.enabled else {"enabled": False})}


def _rule_of(entry: StrictTable) -> Rule:
    values = entry.read(_RULE, ("enabled",))
    conditions = tuple(_condition_of(text) for text in values["conditions"])
    return Rule(values["phoneme"], conditions, values.get("enabled", True))


def _condition_of(text: Any) -> Condition:
    """Read a condition such as ``m_a1 < 3.5``; one that is switched off begins with ``#``."""
    found = _CONDITION.fullmatch(text) if isinstance(text, str) else None
    try:
        limit = float(found[4]) if found else math.nan
    except ValueError:
        limit = math.nan
    if found is None or not abs(limit) <= LARGEST_FLOAT32:
        raise PresetError(
            f"a condition of a rule is a variable, a comparison and a number, such as m_a1 < 3.5; found {shown(text)}"
        )
    return Condition(found[2], found[3], limit=limit, enabled=not found[1])


def _sensitivities_of(table: StrictTable) -> dict[Phoneme, float]:
    return {phoneme: table.value(key, float) for phoneme, key in table.phonemes().items()}


def _confusions_of(table: StrictTable) -> dict[Phoneme, tuple[float, ...]]:
    return {phoneme: table.numbers(key) for phoneme, key in table.phonemes().items()}


def _curves_of(table: StrictTable) -> dict[ModelKind, ConfidenceCurve]:
    table.check_keys((), [*ModelKind, *OLD_MODEL_KINDS])
    return {ModelKind(name): _curve_of(curve) for name, curve in table.tables_by_name()}


def _curve_of(table: StrictTable) -> ConfidenceCurve:
    table.check_keys(_CURVE)
    return ConfidenceCurve(*(table.numbers(key) for key in _CURVE))


def _table_of_templates(templates: Templates) -> dict[str, Any]:
    """Return templates as a table."""
    rows = {phoneme.label: list(row) for phoneme, row in templates.means.items()}
    return {"silence_below": templates.silence_below, "spread": list(templates.spread), **rows}


def _templates_of_table(table: StrictTable) -> Templates:
    """Return templates from [templates]: for each phoneme its 12 mean cepstra, their spread, and what is silence."""
    table.check_keys(_TEMPLATE_NUMBERS, _TEMPLATED)
    means = {phoneme: table.numbers(name) for name, phoneme in _TEMPLATED.items() if name in table}
    return Templates(means, table.numbers("spread"), table.value("silence_below", float))


def _table_of_set(pitch_set: PitchSet) -> dict[str, Any]:
    head = {name: getattr(pitch_set, name) for name in _PITCH_SET}
    return {**head, "phoneme_data": asdict(pitch_set.data)}


def _set_of_table(table: StrictTable) -> PitchSet:
    """Return a set from an entry of [[pitch_sets]]: its name, its range, and its 21 numbers."""
    table.check_keys((*_PITCH_SET, "phoneme_data"))
    head: dict[str, Any] = {name: table.value(name, kind) for name, kind in _PITCH_SET.items()}
    return PitchSet(**head, data=PhonemeData(**table.table("phoneme_data").read(_PHONEME_DATA)))


def _successors_of(table: StrictTable) -> dict[Phoneme, Phoneme]:
    return {**SUCCESSORS, **{phoneme: table.value(key, Phoneme) for phoneme, key in table.phonemes().items()}}


def _plain(value: Any) -> Any:
    """Turn enumerations into the text that TOML knows."""
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [_plain(entry) for entry in value]
    return str(value) if isinstance(value, str) else value
