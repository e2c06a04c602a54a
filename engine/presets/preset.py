"""The preset: everything that a recognition was tuned with, as one value and one TOML file.

The TOML file holds the 21 numbers of a PhonemeData file by name, the front end, the statistics, the intensity's
range, the user's own variables, the recogniser's name and notes.
"""

import os
import tempfile
import tomllib
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import Any, NoReturn

import tomli_w

from engine.errors import EngineError, PresetError
from engine.features.variables import Kind, Spectrum, Variable, check_user_variables
from engine.phonemes import Phoneme
from engine.presets.phonemedata import format_phoneme_data, parse_phoneme_data
from engine.recognition.phoneme_data import FILTER_FIELDS, PhonemeData, Thresholds
from engine.recognition.recogniser import recogniser_of
from engine.recognition.statistics import SUCCESSORS
from engine.settings import BIN_WIDTH, AnalysisSettings, Decimation, Filter, WindowFunction

FORMAT = "phonemeanalyser preset 1"
FACTORY = Path(__file__).resolve().parents[2] / "presets"
"""The folder of the presets that ship with the program."""
DEFAULT_PRESET = FACTORY / "thesis.toml"
LARGEST_FILE = 1 << 20

_FRONT_END = (
    "filters", "quantise", "decimation", "pre_emphasis", "window_function", "low_pass_start", "low_pass_end",
    "mel_bands",
)  # fmt: skip
_STATISTICS = ("statistics", "minimum_hold")
_INTENSITY = ("intensity_low", "intensity_high")
_IN_BINS = ("high_pass_start", "high_pass_end")


@dataclass(frozen=True)
class Preset:
    """A calibrated recognition.

    Attributes
    ----------
    name : what people call it.
    settings : the front end.
    thresholds : the numbers that the rules compare with.
    variables : the user's own variables.
    recogniser : name of the recogniser.
    successors : what replaces an unidentified frame after each phoneme.
    notes : free text.

    Raises
    ------
    EngineError : a variable's name is taken, or there is no such recogniser.
    """

    name: str = "untitled"
    settings: AnalysisSettings = field(default_factory=AnalysisSettings)
    thresholds: Thresholds = field(default_factory=Thresholds)
    variables: tuple[Variable, ...] = ()
    recogniser: str = "thesis"
    successors: Mapping[Phoneme, Phoneme] = field(default_factory=lambda: SUCCESSORS)
    notes: str = ""

    def __post_init__(self) -> None:
        check_user_variables(self.variables)
        recogniser_of(self.recogniser, self.thresholds)

    @property
    def phoneme_data(self) -> PhonemeData:
        """The 21 numbers of the old file format."""
        numbers = {name: getattr(self.settings, name) for name in FILTER_FIELDS}
        for name in _IN_BINS:
            numbers[name] /= BIN_WIDTH
        return PhonemeData(**asdict(self.thresholds), **numbers)

    def with_phoneme_data(self, data: PhonemeData) -> "Preset":
        """Give the preset that has these 21 numbers and is otherwise the same."""
        numbers = {name: getattr(data, name) for name in FILTER_FIELDS}
        for name in _IN_BINS:
            numbers[name] *= BIN_WIDTH
        thresholds = Thresholds(**{f.name: getattr(data, f.name) for f in fields(Thresholds)})
        return replace(self, settings=replace(self.settings, **numbers), thresholds=thresholds)


def preset_to_toml(preset: Preset) -> str:
    """Write a preset as the text of a TOML file."""
    settings = preset.settings
    front_end: dict[str, Any] = {name: getattr(settings, name) for name in _FRONT_END}
    front_end["filters"] = [f.value for f in Filter if settings.has(f)]
    document = {
        "format": FORMAT,
        "name": preset.name,
        "recogniser": preset.recogniser,
        "notes": preset.notes,
        "front_end": front_end,
        "phoneme_data": asdict(preset.phoneme_data),
        "statistics": {name: getattr(settings, name) for name in _STATISTICS},
        "intensity": {name: getattr(settings, name) for name in _INTENSITY},
        "successors": {p.label: q.label for p, q in preset.successors.items()},
        "variables": [asdict(variable) for variable in preset.variables],
    }
    return tomli_w.dumps(_plain(document), multiline_strings=True)


def preset_from_toml(text: str) -> Preset:
    """Read a preset from the text of a TOML file.

    Raises
    ------
    PresetError : not TOML, not of this format, an unknown or missing name, or a value out of range.
    """
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise PresetError(f"this is no TOML file: {error}") from error
    if document.get("format") != FORMAT:
        raise PresetError(f"a preset begins with format = {FORMAT!r}, found {document.get('format')!r}")
    try:
        return _preset_of(document)
    except PresetError:
        raise
    except (EngineError, TypeError, ValueError, AttributeError) as error:
        raise PresetError(str(error)) from error


def load_preset(path: Path, base: Preset | None = None) -> Preset:
    """Load a preset from a TOML file or a PhonemeData file.

    A PhonemeData file says only the 21 numbers; everything else is that of `base`, with the thesis's front end.

    Raises
    ------
    PresetError : the file cannot be read or is no preset; the message begins with the file's name.
    """
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise PresetError(f"{path.name}: a preset is smaller than 1 MB; choose a .toml or .phonemedata file")
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise PresetError(f"{path.name}: this is not a text file; choose a .toml or .phonemedata file") from error
    except OSError as error:
        raise PresetError(f"{path.name}: cannot be read ({error.strerror}); check the file") from error
    try:
        if path.suffix.lower() == ".toml":
            return preset_from_toml(text)
        return _of_phoneme_data(text, path.stem, base or Preset())
    except EngineError as error:
        raise PresetError(f"{path.name}: {error}") from error


def save_preset(preset: Preset, path: Path) -> None:
    """Save a preset: as PhonemeData where the name ends in ``.phonemedata`` or ``.txt``, else as TOML.

    The old file stays until the new one is complete.

    Raises
    ------
    PresetError : the file cannot be written.
    """
    is_text = path.suffix.lower() in {".phonemedata", ".txt"}
    text = format_phoneme_data(preset.phoneme_data) if is_text else preset_to_toml(preset)
    try:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=path.name, suffix=".part")
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        Path(name).replace(path)
    except OSError as error:
        raise PresetError(
            f"{path.name}: cannot be written ({error.strerror}); choose another folder"
        ) from error


def _of_phoneme_data(text: str, name: str, base: Preset) -> Preset:
    thesis = AnalysisSettings()
    settings = replace(base.settings, filters=thesis.filters, quantise=4, decimation=Decimation.PLAIN)
    preset = replace(base, name=name, settings=settings, recogniser="thesis")
    return preset.with_phoneme_data(parse_phoneme_data(text))


def _preset_of(document: dict[str, Any]) -> Preset:
    front_end = _table(document, "front_end", _FRONT_END)
    front_end["filters"] = frozenset(_choice(Filter, f, "filters") for f in front_end["filters"])
    front_end["decimation"] = _choice(Decimation, front_end["decimation"], "decimation")
    front_end["window_function"] = _choice(WindowFunction, front_end["window_function"], "window_function")
    statistics = _table(document, "statistics", _STATISTICS)
    intensity = _table(document, "intensity", _INTENSITY)
    data = _table(document, "phoneme_data", tuple(f.name for f in fields(PhonemeData)))
    for table in (front_end, statistics, intensity, data):
        _check_numbers(table)
    preset = Preset(
        name=str(document.get("name", "untitled")),
        settings=AnalysisSettings(**front_end, **statistics, **intensity),
        variables=tuple(_variable_of(entry) for entry in document.get("variables", [])),
        recogniser=str(document.get("recogniser", "thesis")),
        successors=_successors_of(document.get("successors", {})),
        notes=str(document.get("notes", "")),
    )
    return preset.with_phoneme_data(PhonemeData(**data))


def _table(document: dict[str, Any], name: str, keys: tuple[str, ...]) -> dict[str, Any]:
    table = document.get(name)
    if not isinstance(table, dict):
        raise PresetError(f"the table [{name}] is missing")
    for key in table.keys() ^ set(keys):
        _refuse_key(name, key, known=key in keys)
    return dict(table)


def _refuse_key(table: str, key: str, *, known: bool) -> NoReturn:
    raise PresetError(f"[{table}] lacks {key}" if known else f"[{table}] does not know {key}")


def _check_numbers(table: dict[str, Any]) -> None:
    for key, value in table.items():
        expected = bool if key == "statistics" else int | float
        if isinstance(value, str | frozenset):
            continue
        if not isinstance(value, expected) or (expected is not bool and isinstance(value, bool)):
            what = "true or false" if expected is bool else "a number"
            raise PresetError(f"{key} must be {what}, found {value!r}")


def _choice(kind: Any, value: Any, name: str) -> Any:
    try:
        return kind(value)
    except ValueError:
        raise PresetError(f"{name} must be one of {', '.join(kind)}, found {value!r}") from None


def _variable_of(entry: dict[str, Any]) -> Variable:
    low, high = float(entry["low"]), float(entry["high"])
    kind, source = _choice(Kind, entry["kind"], "kind"), _choice(Spectrum, entry["source"], "source")
    return Variable(str(entry["name"]), low, high, kind, source)


def _successors_of(table: dict[str, str]) -> dict[Phoneme, Phoneme]:
    known = {p.label: p for p in Phoneme}
    for name in [*table.keys(), *table.values()]:
        if name not in known:
            raise PresetError(f"[successors] knows no phoneme {name!r}; known are {', '.join(known)}")
    return {**SUCCESSORS, **{known[p]: known[q] for p, q in table.items()}}


def _plain(value: Any) -> Any:
    """Turn enumerations into the text that TOML knows."""
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [_plain(entry) for entry in value]
    return str(value) if isinstance(value, str) else value
