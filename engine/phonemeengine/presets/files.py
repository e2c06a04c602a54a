"""Preset files: TOML, and the old PhonemeData text; read, written, and told of without loading them."""

import os
import re
import tomllib
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from importlib import resources
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from phonemeengine.arrays import LARGEST_FLOAT32
from phonemeengine.encoder.head import load_head, save_head
from phonemeengine.encoder.live import LiveEncoder, load_live_encoder, save_live_encoder
from phonemeengine.errors import EngineError, ModelError, PresetError, remedy
from phonemeengine.presets.document import FRONT_END, INTENSITY, STATISTICS, preset_from_toml, preset_to_toml
from phonemeengine.presets.preset import Preset, judgement_of
from phonemeengine.recognition.model import load_model, save_model
from phonemeengine.recognition.rules import LAYOUT, PhonemeData
from phonemeengine.recognition.spec import spec_of
from phonemeengine.storage.files import read_text_file, write_file
from phonemeengine.storage.paths import presets_folder
from phonemeengine.storage.strict_table import StrictTable

# PhonemeData files: 21 numbers as text, the thesis's own format.

_NUMBERS = tuple(name for line in LAYOUT for name in line)
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
    values = {name: _number(word, line, name) for name, (line, word) in zip(_NUMBERS, found, strict=False)}
    if len(found) < len(_NUMBERS):
        raise PresetError(
            f"a PhonemeData file holds {len(_NUMBERS)} numbers, found {len(found)}; "
            f"the first one missing after line {found[-1][0] if found else 1} is {_NUMBERS[len(found)]}; add it"
        )
    if len(found) > len(_NUMBERS):
        line, word = found[len(_NUMBERS)]
        raise PresetError(
            f"a PhonemeData file holds {len(_NUMBERS)} numbers and ends with {_NUMBERS[-1]}, "
            f"found {len(found)}; remove {_shown(word)} in line {line} and what follows"
        )
    return PhonemeData(**values)


def format_phoneme_data(data: PhonemeData) -> str:
    """Write the 21 numbers as six lines, each with the fewest digits that keep its float32 value."""
    return "".join(",".join(_shortest(getattr(data, name)) for name in line) + "\n" for line in LAYOUT)


def _number(word: str, line: int, name: str) -> float:
    if not _SPELLING.fullmatch(word):
        raise PresetError(f"line {line}: {name} must be a number, found {_shown(word)}; correct it")
    value = float(word)
    if not abs(value) <= LARGEST_FLOAT32:
        raise PresetError(f"line {line}: {name} must be a finite number, found {_shown(word)}; correct it")
    return value


def _shown(word: str) -> str:
    return repr(word if len(word) <= 20 else word[:20] + "...")


def _shortest(value: float) -> str:
    return np.format_float_positional(np.float32(value), trim="-")


assert {field.name for field in fields(PhonemeData)} == set(_NUMBERS)


_SHIPPED = Path(str(resources.files("phonemeengine.presets"))) / "factory"
FACTORY = _SHIPPED if _SHIPPED.is_dir() else Path(__file__).resolve().parents[3] / "presets"
"""The folder of the presets that ship with the program: inside an installed package, at the top of a checkout."""
DEFAULT_PRESET = FACTORY / "learned.toml"
THESIS_PRESET = FACTORY / "thesis.toml"
_NAMES = ("learned", "extended", "templates", "thesis", "thesis-calm", "thesis-anti-aliased")
FACTORY_PRESETS = tuple(FACTORY / f"{name}.toml" for name in _NAMES)
"""The presets that ship with the program, the surest one first."""
THESIS_PRESETS = tuple(path for path in FACTORY_PRESETS if path.stem.startswith("thesis"))
LARGEST_FILE = 1 << 20
PHONEME_DATA_SUFFIXES = (".phonemedata", ".txt")
MODEL_SUFFIXES = {
    "model": ".npz",
    "offline_model": ".files.npz",
    "encoder_head": ".whisper.npz",
    "live_encoder": ".encoder.onnx",
}
"""What the files of a preset's models end in, by field."""
_FILES: dict[str, tuple[Callable[[Path], Any], Callable[[Any, Path], None]]] = {
    "model": (load_model, save_model),
    "offline_model": (load_model, save_model),
    "encoder_head": (load_head, save_head),
    "live_encoder": (load_live_encoder, save_live_encoder),
}
"""What reads and writes them."""
PRESET_SUFFIXES = (".toml", *PHONEME_DATA_SUFFIXES)


Known = TypeVar("Known")


def load_preset(path: str | os.PathLike[str]) -> Preset:
    """Return the preset of a TOML file or a PhonemeData file, or the one of that name, such as ``learned``.

    A PhonemeData file always means the thesis's recogniser, front end and statistics, with its 21 numbers. A bare
    name is that of a factory preset or of one in `presets_folder`, unless there is such a file.

    Raises
    ------
    PresetError : the file cannot be read or is no preset; the message begins with the file's name.
    """
    path = preset_path(path)
    if path.name == str(path) and not path.suffix and not os.path.lexists(path):
        words = remedy(str(path), sorted(_names()), "name a file, or one of {}")
        raise PresetError(f"{path}: there is no such preset; {words}")
    text = read_text_file(path, LARGEST_FILE, "a .toml or .phonemedata file", PresetError)
    try:
        if path.suffix.lower() == ".toml":
            return preset_from_toml(text, path.parent, FACTORY)
        return _of_phoneme_data(text, path.stem)
    except EngineError as error:
        raise PresetError(f"{path.name}: {error}") from error


def save_preset(preset: Preset, path: str | os.PathLike[str]) -> None:
    """Save a preset: as PhonemeData where the name ends in ``.phonemedata`` or ``.txt``, else as TOML.

    What a PhonemeData file cannot hold is lost there; `beyond_phoneme_data` says what that is. A model is saved
    beside it, under the same name with ``.npz``, the offline model with ``.files.npz``, what it knows of the speech
    encoder with ``.whisper.npz``, and the real-time model with ``.encoder.onnx``, unless it is one of those that ship
    with the program, which is only named. The old files stay until the new ones are complete.

    Raises
    ------
    PresetError : a file cannot be written.
    """
    path = Path(path)
    if is_phoneme_data(path):
        write_file(path, format_phoneme_data(preset.phoneme_data).encode(errors="replace"), PresetError)
        return
    text = preset_to_toml(preset, save_models(preset, path))
    write_file(path, text.encode(errors="replace"), PresetError)


def save_models(preset: Preset, path: Path, shipped: Path = FACTORY) -> dict[str, str]:
    """Save the models of a preset, unless they are there already; return the names of their files by field.

    Parameters
    ----------
    preset : a preset.
    path : its file; the models are saved beside it.
    shipped : the folder of the presets that ship with the program, whose real-time models are not copied.
    """
    found = {}
    for field, (load, save) in _FILES.items():
        known = getattr(preset, field)
        if known is None:
            continue
        beside = path.with_suffix(MODEL_SUFFIXES[field])
        if field == "live_encoder" and _is_shipped(known, path.parent, shipped):
            beside = shipped / Path(known.name).name
        elif not _holds(beside, known, load):
            save(known, beside)
        found[field] = beside.name
    return found


def _is_shipped(encoder: LiveEncoder, folder: Path, shipped: Path) -> bool:
    """Return whether a real-time model ships with the program, and presets in a folder find it there by its name."""
    name = Path(encoder.name).name
    another = (folder / name).exists() and not _holds(folder / name, encoder, load_live_encoder)
    return not another and _holds(shipped / name, encoder, load_live_encoder)


def preset_path(name: str | os.PathLike[str]) -> Path:
    """Return the file of a preset that is given by its path, or by the bare name of a factory or own preset."""
    path = Path(name)
    if path.name != str(path) or os.path.lexists(path):
        return path
    return _names().get(str(path), path)


def _names() -> dict[str, Path]:
    return {path.stem: path for path in (*own_presets(), *FACTORY_PRESETS)}


def own_presets() -> tuple[Path, ...]:
    """Return the preset files in the user's own folder, by name."""
    folder = presets_folder()
    found = [path for path in folder.iterdir() if path.suffix.lower() in PRESET_SUFFIXES] if folder.is_dir() else []
    return tuple(sorted(found, key=lambda path: path.name.lower()))


def factory_preset(recogniser: str) -> Preset | None:
    """Return the factory preset that was tuned with a recogniser; None for one that brings none.

    Raises
    ------
    EngineError : there is no such recogniser, or its preset cannot be read.
    """
    name = spec_of(recogniser).factory_preset
    return load_preset(FACTORY / name) if name else None


def is_phoneme_data(path: Path) -> bool:
    """Return whether a file of this name holds the 21 numbers of PhonemeData, and nothing else."""
    return path.suffix.lower() in PHONEME_DATA_SUFFIXES


def beyond_phoneme_data(preset: Preset) -> tuple[str, ...]:
    """Return what of a preset a PhonemeData file cannot hold, in the user's words; empty where it holds all."""
    kept = Preset().with_phoneme_data(preset.phoneme_data)

    def differ(names: Iterable[str]) -> bool:
        return any(getattr(preset.settings, name) != getattr(kept.settings, name) for name in names)

    lost = {
        f"the recogniser {preset.recogniser}": preset.recogniser != kept.recogniser,
        "filters other than the thesis's": differ(FRONT_END),
        "hold and hysteresis": differ(STATISTICS),
        "the range of the intensity": differ(INTENSITY),
        "your variables": preset.variables != kept.variables,
        "rules": preset.rules != kept.rules,
        "the learned model": preset.model is not None,
        "the offline model": preset.offline_model is not None,
        "the real-time model": preset.live_encoder is not None,
        "the head on Whisper": preset.encoder_head is not None,
        "templates": preset.templates is not None,
        "sensitivities": any(preset.sensitivities.values()),
        "the pitch sets": bool(preset.pitch_sets),
        "the decoder": bool(preset.confusions),
        "the table of successors": dict(preset.successors) != dict(kept.successors),
        "what it was judged by": preset.judged is not None,
        "notes": bool(preset.notes.strip()),
    }
    return tuple(words for words, is_lost in lost.items() if is_lost)


def _of_phoneme_data(text: str, name: str) -> Preset:
    """Return the thesis with a file's numbers; bounds that were round in Hz before they became float32 are again."""
    preset = Preset(name=name).with_phoneme_data(parse_phoneme_data(text))
    settings = preset.settings
    rounded = replace(
        settings,
        high_pass_start=float(f"{settings.high_pass_start:.7g}"),
        high_pass_end=float(f"{settings.high_pass_end:.7g}"),
    )
    same = replace(preset, settings=rounded)
    is_same = format_phoneme_data(same.phoneme_data) == format_phoneme_data(preset.phoneme_data)
    return same if is_same else preset


def _holds(path: Path, model: Known, load: Callable[[Path], Known]) -> bool:
    try:
        return load(path) == model
    except ModelError:
        return False


# What can be said of a preset file without loading it: its name, and one line that says what it is.

LONGEST_SUMMARY = 110
"""Characters."""


@dataclass(frozen=True)
class PresetEntry:
    """A preset file, as a list of presets shows it.

    Attributes
    ----------
    path : the file.
    name : what the preset is called.
    summary : what it is, in one line; may be empty.
    """

    path: Path
    name: str
    summary: str


def preset_entries(paths: Iterable[Path]) -> tuple[PresetEntry, ...]:
    """Return the entries of those files that look like presets; loading one reports what is wrong with it."""
    return tuple(_entries(paths))


def _entries(paths: Iterable[Path]) -> Iterator[PresetEntry]:
    for path in paths:
        if not path.is_file() or path.stat().st_size > LARGEST_FILE:
            continue
        if is_phoneme_data(path):
            yield PresetEntry(path, path.stem, "The rules of the thesis with the 21 numbers of a PhonemeData file.")
            continue
        try:
            document = tomllib.loads(path.read_text(encoding="utf-8-sig"))
        except (OSError, ValueError, RecursionError):
            continue
        summary = _judged(document) or _shortened(str(document.get("notes", "")).strip().partition("\n")[0])
        yield PresetEntry(path, str(document.get("name", path.stem)), summary)


def _judged(document: dict[str, Any]) -> str:
    """Return what a preset was judged by, in one line; empty where that is not there, or damaged."""
    with suppress(PresetError):
        if "judged" in document:
            return str(judgement_of(StrictTable(document, "a preset", PresetError).table("judged")))
    return ""


def _shortened(line: str) -> str:
    return line if len(line) <= LONGEST_SUMMARY else line[: LONGEST_SUMMARY - 1] + "…"
