"""The preset: everything that a recognition was tuned with, as one value and one TOML file.

The TOML file holds the 21 numbers of a PhonemeData file by name, the front end, the statistics, the intensity's
range, the user's own variables, the recogniser's name and notes.
"""

import tomllib
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import Any

import tomli_w

from engine.errors import EngineError, PresetError, SettingsError
from engine.features.variables import Kind, Spectrum, Variable, check_user_variables
from engine.phonemes import Phoneme
from engine.presets.phonemedata import format_phoneme_data, parse_phoneme_data
from engine.recognition.phoneme_data import FILTER_FIELDS, LARGEST, PhonemeData, Thresholds
from engine.recognition.recogniser import check_recogniser
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
_CHOICES = ("decimation", "window_function")
_STATISTICS = ("statistics", "minimum_hold")
_INTENSITY = ("intensity_low", "intensity_high")
_IN_BINS = ("high_pass_start", "high_pass_end")
_PLAIN = ("format", "name", "recogniser", "notes", "variables", "successors")
_TABLES = ("front_end", "phoneme_data", "statistics", "intensity")
_VARIABLE = ("name", "low", "high", "kind", "source")

# what stands in a preset file, where it is not just a number
_TYPES: dict[str, type] = {
    **dict.fromkeys(("format", "name", "recogniser", "notes", "kind", "source", *_CHOICES), str),
    **dict.fromkeys(("variables", "filters"), list),
    **dict.fromkeys(("quantise", "mel_bands"), int),
    "successors": dict,
    "statistics": bool,
}
_WORDS = {str: "text", list: "a list", int: "a whole number", dict: "a table", bool: "true or false"}


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
    EngineError : a variable's name is taken, or there is no such recogniser, or there are two.
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
        check_recogniser(self.recogniser)

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
            numbers[name] = float(f"{numbers[name] * BIN_WIDTH:.15g}")  # what was round in Hz is so again
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
    except (ValueError, RecursionError) as error:
        raise PresetError(f"this is no TOML file: {error}") from error
    if document.get("format") != FORMAT:
        raise PresetError(f"a preset begins with format = {FORMAT!r}, found {document.get('format')!r}")
    try:
        return _preset_of(document)
    except SettingsError as error:
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
            raise PresetError(
                f"{path.name}: a preset is smaller than 1 MB, this has {path.stat().st_size / 1e6:.1f} MB; "
                "choose a .toml or .phonemedata file"
            )
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
    part = path.with_name(path.name + ".part")
    try:
        part.write_bytes(text.encode(errors="replace"))
        part.replace(path)
    except OSError as error:
        with suppress(OSError):
            part.unlink()
        raise PresetError(f"{path.name}: cannot be written ({error.strerror}); choose another folder") from error


def _of_phoneme_data(text: str, name: str, base: Preset) -> Preset:
    thesis = AnalysisSettings()
    settings = replace(base.settings, filters=thesis.filters, quantise=4, decimation=Decimation.PLAIN)
    preset = replace(base, name=name, settings=settings, recogniser="thesis")
    return preset.with_phoneme_data(parse_phoneme_data(text))


def _preset_of(document: dict[str, Any]) -> Preset:
    for key in document.keys() - {*_PLAIN, *_TABLES}:
        raise PresetError(f"a preset does not know {key}")
    texts = _checked({key: document[key] for key in _PLAIN if key in document})
    front_end = _table(document, "front_end", _FRONT_END)
    front_end["filters"] = frozenset(_choice(Filter, f, "filters") for f in front_end["filters"])
    front_end["decimation"] = _choice(Decimation, front_end["decimation"], "decimation")
    front_end["window_function"] = _choice(WindowFunction, front_end["window_function"], "window_function")
    statistics = _table(document, "statistics", _STATISTICS)
    intensity = _table(document, "intensity", _INTENSITY)
    data = _table(document, "phoneme_data", tuple(f.name for f in fields(PhonemeData)))
    preset = Preset(
        name=texts.get("name", "untitled"),
        settings=AnalysisSettings(**front_end, **statistics, **intensity),
        variables=tuple(_variable_of(entry) for entry in texts.get("variables", [])),
        recogniser=texts.get("recogniser", "thesis"),
        successors=_successors_of(texts.get("successors", {})),
        notes=texts.get("notes", ""),
    )
    return preset.with_phoneme_data(PhonemeData(**data))


def _table(document: dict[str, Any], name: str, keys: tuple[str, ...]) -> dict[str, Any]:
    table = document.get(name)
    if not isinstance(table, dict):
        raise PresetError(f"the table [{name}] is missing")
    for key in table.keys() ^ set(keys):
        raise PresetError(f"[{name}] lacks {key}" if key in keys else f"[{name}] does not know {key}")
    return _checked(table)


def _checked(table: dict[str, Any]) -> dict[str, Any]:
    """Give a copy of a table, after refusing values of the wrong type and numbers that no float32 holds."""
    for key, value in table.items():
        expected = _TYPES.get(key, float)
        fits = isinstance(value, int | float if expected is float else expected)
        if not fits or isinstance(value, bool) != (expected is bool):
            raise PresetError(f"{key} must be {_WORDS.get(expected, 'a number')}, found {_shown(value)}")
        if isinstance(value, int | float) and not abs(value) <= LARGEST:
            raise PresetError(f"{key} must be a finite number within ±3.4e38, found {_shown(value)}")
    return dict(table)


def _shown(value: Any) -> str:
    endless = isinstance(value, int) and abs(value) > LARGEST
    return "an endless number" if endless else f"{value!r:.60}"


def _choice(kind: Any, value: Any, name: str) -> Any:
    try:
        return kind(value)
    except ValueError:
        raise PresetError(f"{name} must be one of {', '.join(kind)}, found {_shown(value)}") from None


def _variable_of(entry: Any) -> Variable:
    values = _table({"variables": entry}, "variables", _VARIABLE)
    kind, source = _choice(Kind, values["kind"], "kind"), _choice(Spectrum, values["source"], "source")
    return Variable(values["name"], float(values["low"]), float(values["high"]), kind, source)


def _successors_of(table: dict[str, Any]) -> dict[Phoneme, Phoneme]:
    known = {p.label: p for p in Phoneme}
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
