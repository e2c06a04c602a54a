"""The server as another process of this program, so that the window stays smooth however many streams there are."""

import os
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, QProcess, QTimer, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.server.access import USUAL_HOST, USUAL_PORT
from phonemeanalyser.server.activity import Activity, Happening
from phonemeengine.errors import EngineError
from phonemeengine.presets.files import save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.storage.files import printable_name, reason_of
from phonemeengine.storage.paths import data_folder

CODE = "import sys; from phonemeanalyser.cli.main import main; sys.exit(main(sys.argv[1:]))"
"""What Python runs; a bundled program knows no ``-m``."""
ENDING_MS = 3000
"""Milliseconds that the process has to end by itself."""
MOST_LOGGED = 1000
"""Activities that are kept."""


@dataclass(frozen=True)
class ServeOrder:
    """What is served, as the command ``serve`` takes it; of a preset that is in no file as it is, the preset.

    The name is what the window calls the preset.
    """

    preset: Preset | Path
    host: str = USUAL_HOST
    port: int = USUAL_PORT
    token: str = ""
    name: str = ""

    def command(self, folder: Path) -> list[str]:
        """Return the words of the command; what they name and is in no file yet is written to a folder.

        Raises
        ------
        EngineError : a file cannot be written.
        """
        words = ["serve", "--supervised", "--host", self.host, "--port", str(self.port)]
        preset = self.preset
        if isinstance(preset, Preset):
            save_preset(preset, folder / "current.toml")
            preset = folder / "current.toml"
        words += ["--preset", str(preset)]
        return [*words, "--token-file", str(write_token(self.token))] if self.token else words


class ServerModel(QObject):
    """Starts and ends the server, and keeps what it tells; it ends with the program.

    Signals
    -------
    changed : it starts, serves, or has ended.
    told : the newest `Activity`, which is the last one of `log`.

    Attributes
    ----------
    order : what is served, or was last; None before.
    address : where it is served; empty while it is not.
    failure : why it has ended by itself; empty where it has not.
    log : what it told since it was started.
    """

    changed = Signal()
    told = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.order: ServeOrder | None = None
        self.address = self.failure = ""
        self.log: list[Activity] = []
        self._process: QProcess | None = None
        self._is_ending = False
        self._folder: tempfile.TemporaryDirectory[str] | None = None

    @property
    def running(self) -> bool:
        """Whether there is a process, be it only starting or ending."""
        return self._process is not None

    def start(self, order: ServeOrder) -> None:
        """Serve.

        Raises
        ------
        EngineError : a file that is needed cannot be written.
        """
        self._folder = tempfile.TemporaryDirectory(prefix="phonemeanalyser-")
        words = order.command(Path(self._folder.name))
        self.order, self.failure, self.log, self._is_ending = order, "", [], False
        self._process = process = QProcess(self)
        process.readyReadStandardOutput.connect(self._read)
        process.finished.connect(self._end)
        process.errorOccurred.connect(self._fail)
        process.start(sys.executable, ["-c", CODE, *words])
        self.changed.emit()

    def stop(self) -> None:
        """Have the server end."""
        if self._process is not None:
            self._is_ending = True
            self._process.terminate()
            timer = QTimer(self._process, singleShot=True, interval=ENDING_MS)
            timer.timeout.connect(self._process.kill)  # Windows ends no such program when it is asked
            timer.start()

    def close(self) -> None:
        """End the server now."""
        process = self._process
        if process is not None:
            self.stop()
            process.waitForFinished(ENDING_MS)
            process.kill()
            process.waitForFinished(ENDING_MS)

    def _read(self) -> None:
        process = self._process
        while process is not None and process.canReadLine():
            try:
                activity = Activity.from_line(bytes(process.readLine().data()).decode(errors="replace"))
            except (ValueError, TypeError, KeyError):
                continue  # what a library prints
            self.log = [*self.log[1 - MOST_LOGGED :], activity]
            if activity.what is Happening.SERVING:
                self.address = activity.words
                self.changed.emit()
            self.told.emit(activity)

    def _fail(self, error: QProcess.ProcessError) -> None:
        if error is QProcess.ProcessError.FailedToStart and self._process is not None:
            self._let_go(self._process.errorString())

    def _end(self) -> None:
        if self._process is not None:
            said = bytes(self._process.readAllStandardError().data()).decode(errors="replace").strip()
            told = (
                said.splitlines()[-1].removeprefix("phonemeanalyser: ") if said else "the server has ended by itself"
            )
            self._let_go("" if self._is_ending else told)

    def _let_go(self, failure: str) -> None:
        assert self._process is not None
        assert self._folder is not None
        self._process.deleteLater()
        self._folder.cleanup()
        self._process, self._folder, self.address, self.failure = None, None, "", failure
        self.changed.emit()


def token_path() -> Path:
    """Return the file of the token; it need not exist."""
    return data_folder() / "server-token.txt"


def write_token(token: str) -> Path:
    """Return the file of a token, which only the user can read, after writing it.

    Raises
    ------
    EngineError : it cannot be written.
    """
    path = token_path()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)  # an older one may be readable
        with os.fdopen(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as file:
            file.write(f"{token}\n")
    except OSError as error:
        words = tr("{path}: it can't be written ({reason}); free space there, or let it be written to")
        raise EngineError(words.format(path=printable_name(path), reason=reason_of(error))) from error
    return path


def kept_token() -> str:
    """Return the token of the last start; empty where there is none."""
    try:
        return token_path().read_text(encoding="utf-8").strip()
    except (OSError, ValueError):
        return ""
