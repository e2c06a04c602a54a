"""Where recordings, presets and copies go: folders and free names. The only module that imports platformdirs."""

from datetime import datetime
from pathlib import Path

from phonemeengine.errors import RecordingError
from phonemeengine.storage.files import free_path, printable_name, reason_of

FOLDER = "PhonemeAnalyser"
"""Name of our folders among those of the user."""


def recordings_folder() -> Path:
    """Return the folder in which recordings are made unless the user chooses one; it need not exist."""
    from platformdirs import user_music_path  # noqa: PLC0415 - as below

    return user_music_path() / FOLDER


def presets_folder() -> Path:
    """Return the folder of the user's own presets; it need not exist."""
    from platformdirs import user_documents_path  # noqa: PLC0415 - as below

    return user_documents_path() / FOLDER / "presets"


def styles_folder() -> Path:
    """Return the folder of the user's own styles; it need not exist."""
    return presets_folder().with_name("styles")


def journal_folder() -> Path:
    """Return the folder in which running recordings are noted; it need not exist."""
    return data_folder() / "unfinished"


def data_folder() -> Path:
    """Return the folder of what the program keeps for the user; it need not exist."""
    from platformdirs import user_data_path  # noqa: PLC0415 - takes 15 ms, which only who needs it should wait for

    return user_data_path(FOLDER, appauthor=False)


def cache_folder() -> Path:
    """Return the folder of what can be made again at any time; it need not exist."""
    from platformdirs import user_cache_path  # noqa: PLC0415 - as above

    return user_cache_path(FOLDER, appauthor=False)


def new_recording_path(folder: Path, suffix: str) -> Path:
    """Return a free name for a recording that begins now, and make the folder if need be.

    Raises
    ------
    RecordingError : the folder cannot be made.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError) as error:
        raise RecordingError(
            f"{printable_name(folder)}: this folder for recordings cannot be made "
            f"({reason_of(error)}); choose another"
        ) from error
    return free_path(folder / f"{datetime.now().astimezone():%Y-%m-%d %H-%M-%S}{suffix}")
