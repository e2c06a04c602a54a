"""Modules of commands that draw heads, for which packages may be missing that no other command needs."""

import importlib
from types import ModuleType

from phonemeengine import EngineError


def module_that_draws(name: str) -> ModuleType:
    """Import a module of this package that needs those of previews.

    Raises
    ------
    EngineError : they are not installed.
    """
    try:
        return importlib.import_module(f"phonemeanalyser.cli.{name}")
    except ImportError as error:
        raise EngineError(
            f"previews need packages that cannot be loaded ({error}); install them with: pip install "
            "'phonemeanalyser[preview]'"
        ) from error
