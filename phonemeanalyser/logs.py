"""What happened while the program ran, in a file that a user can send in; nothing is kept unless it is asked for."""

import logging
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from logging.handlers import RotatingFileHandler
from pathlib import Path

from phonemeengine.errors import EngineError
from phonemeengine.storage.files import printable_name, reason_of

PACKAGES = ("phonemeengine", "phonemeanalyser")
LINE = "%(asctime)s %(levelname)s %(name)s: %(message)s"
LARGEST, KEPT = 1 << 20, 3
"""Bytes of a file of the desktop's log, and how many older ones are kept beside it."""

_log = logging.getLogger(__name__)


@contextmanager
def logged_to(path: Path | None) -> Iterator[None]:
    """Append what happens meanwhile to a file, refusals and crashes too; None keeps nothing.

    Raises
    ------
    EngineError : the file cannot be written.
    """
    if path is None:
        yield
        return
    with _kept_by(_opened(path)):
        try:
            yield
        except EngineError as error:
            _log.error("%s", error)
            raise
        except Exception:
            _log.exception("the program crashed")
            raise


@contextmanager
def logged_beside(folder: Path) -> Iterator[Path]:
    """Append what happens meanwhile to a file in a folder, of which three older ones are kept; gives its path.

    Where it cannot be written, nothing is kept, without an error. Threads that crash are logged as well.
    """
    path = folder / "phonemeanalyser.log"
    before, threading.excepthook = threading.excepthook, _log_thread
    try:
        folder.mkdir(parents=True, exist_ok=True)
        handler: logging.Handler = RotatingFileHandler(path, maxBytes=LARGEST, backupCount=KEPT, encoding="utf-8")
    except OSError:
        handler = logging.NullHandler()
    try:
        with _kept_by(handler):
            yield path
    finally:
        threading.excepthook = before


def _opened(path: Path) -> logging.Handler:
    try:
        return logging.FileHandler(path, encoding="utf-8")
    except (OSError, ValueError) as error:
        raise EngineError(
            f"{printable_name(path)}: this log cannot be written ({reason_of(error)}); choose another with --log"
        ) from error


@contextmanager
def _kept_by(handler: logging.Handler) -> Iterator[None]:
    handler.setFormatter(logging.Formatter(LINE))
    before = {logger: logger.level for logger in map(logging.getLogger, PACKAGES)}
    for logger in before:
        logger.addHandler(handler)
        logger.setLevel(logging.INFO)
    try:
        yield
    finally:
        for logger, level in before.items():
            logger.removeHandler(handler)
            logger.setLevel(level)
        handler.close()


def _log_thread(crash: threading.ExceptHookArgs) -> None:
    """Log what ended a thread, besides what Python says of it."""
    name = crash.thread.name if crash.thread is not None else "a thread"
    trouble = (crash.exc_type, crash.exc_value or crash.exc_type(), crash.exc_traceback)
    _log.error("%s crashed", name, exc_info=trouble)
    threading.__excepthook__(crash)
