"""Preset files: TOML, and the old PhonemeData text."""

from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from engine.errors import EngineError, ModelError, PresetError
from engine.presets.document import preset_from_toml, preset_to_toml
from engine.presets.phonemedata import format_phoneme_data, parse_phoneme_data
from engine.presets.preset import Preset
from engine.recognition.model import Model, load_model, save_model
from engine.settings import AnalysisSettings, Decimation

FACTORY = Path(__file__).resolve().parents[2] / "presets"
"""The folder of the presets that ship with the program."""
DEFAULT_PRESET = FACTORY / "learned.toml"
THESIS_PRESET = FACTORY / "thesis.toml"
LARGEST_FILE = 1 << 20


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
            return preset_from_toml(text, path.parent)
        return _of_phoneme_data(text, path.stem, base or Preset())
    except EngineError as error:
        raise PresetError(f"{path.name}: {error}") from error


def save_preset(preset: Preset, path: Path) -> None:
    """Save a preset: as PhonemeData where the name ends in ``.phonemedata`` or ``.txt``, else as TOML.

    A model is saved beside it, under the same name with ``.npz``. The old files stay until the new ones are complete.

    Raises
    ------
    PresetError : a file cannot be written.
    """
    if path.suffix.lower() in {".phonemedata", ".txt"}:
        _write(path, format_phoneme_data(preset.phoneme_data).encode(errors="replace"))
        return
    beside = path.with_suffix(".npz")
    if preset.model is not None and not _holds(beside, preset.model):
        save_model(preset.model, beside)
    text = preset_to_toml(preset, beside.name if preset.model is not None else "")
    _write(path, text.encode(errors="replace"))


def _holds(path: Path, model: Model) -> bool:
    try:
        return load_model(path) == model
    except ModelError:
        return False


def _write(path: Path, content: bytes) -> None:
    part = path.with_name(path.name + ".part")
    try:
        part.write_bytes(content)
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
