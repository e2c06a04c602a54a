"""Endings without a question to the user: a signal of the system, and the end of the user's session."""

import gc
import logging
import os
import signal
import socket
import sys
import threading
from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QObject, QSocketNotifier, Signal
from PySide6.QtWidgets import QApplication

from phonemeanalyser.desktop.session.unsaved import UnsavedChanges

ENDING_SIGNALS = ("SIGTERM", "SIGINT", "SIGHUP")


def end_promptly(code: int) -> None:
    """Prepare the end of the process, now that all is closed; where a background thread still works, end it here.

    Python's end stops such a thread in the middle of its C++ code, which may crash the process: a daemon thread that
    wants the lock of the interpreter then is unwound through code that allows no exception. Without such threads,
    only the last garbage collection is left out: a second, in which nothing is freed that the system does not take
    back at once.

    Parameters
    ----------
    code : the exit code.
    """
    if any(thread.daemon for thread in threading.enumerate()):
        logging.shutdown()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
    gc.disable()
    gc.freeze()


class EndingSignals(QObject):
    """Tells of the signals by which a system ends programs, in Qt's event loop; one that is ignored stays ignored.

    Signals
    -------
    came : the system wants the program to end.
    """

    came = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._received, self._written = socket.socketpair()
        self._written.setblocking(False)
        signal.set_wakeup_fd(self._written.fileno())
        self._notifier = QSocketNotifier(self._received.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._receive)
        numbers = [getattr(signal, name) for name in ENDING_SIGNALS if hasattr(signal, name)]
        for number in numbers:
            if signal.getsignal(number) is not signal.SIG_IGN:
                signal.signal(number, lambda _number, _frame: None)  # Python tells the socket

    def _receive(self) -> None:
        self._received.recv(64)
        self.came.emit()


class SessionKeeper(QObject):
    """Keeps everything when the system ends program or session.

    Parameters
    ----------
    app : tells of the end of a session.
    save : keeps layout and choices for the next start.
    unsaved : keeps the changes of the preset.
    """

    def __init__(self, app: QApplication, save: Callable[[], None], unsaved: UnsavedChanges) -> None:
        super().__init__()
        self._save = save
        self._unsaved = unsaved
        self._ended_by_system = False
        self._signals = EndingSignals()
        self._signals.came.connect(self.end)
        app.commitDataRequest.connect(lambda _manager: self.keep())
        app.saveStateRequest.connect(lambda _manager: self.keep())

    def keep(self) -> None:
        """Keep everything now."""
        self._unsaved.keep()
        self._save()

    def end(self) -> None:
        """Keep everything, and end the program, whatever the user is being asked."""
        self._ended_by_system = True
        self.keep()
        QCoreApplication.exit(0)

    def close(self) -> None:
        """Forget unsaved changes where the user, asked about them, has gone; else leave them to the next start."""
        if not self._ended_by_system:
            self._unsaved.forget()
        self._unsaved.close()
