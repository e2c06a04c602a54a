"""Modules for which packages may be missing that most commands do not need."""

import importlib
from types import ModuleType

from phonemeengine import EngineError


def module_that_draws(name: str) -> ModuleType:
    """Import a module of this package that needs those of previews.

    Raises
    ------
    EngineError : they are not installed.
    """
    return _imported(f"phonemeanalyser.cli.{name}", "previews need", "preview")


def module_that_serves() -> ModuleType:
    """Import the server.

    Raises
    ------
    EngineError : the packages that it needs are not installed.
    """
    return _imported("phonemeanalyser.server.service", "a server needs", "server")


def _imported(name: str, needing: str, extra: str) -> ModuleType:
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise EngineError(
            f"{needing} packages that cannot be loaded ({error}); install them with: pip install "
            f"'phonemeanalyser[{extra}]'"
        ) from error
