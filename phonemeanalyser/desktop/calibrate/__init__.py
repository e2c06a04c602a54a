"""The Calibrate page: takes, thresholds, fits and the guided calibration.

What the window needs of it is imported when it is first asked for (PEP 562), since that is a fifth of all imports of
the program, and the window is to be seen before. ``__init__.pyi`` tells type checkers the same.
"""

from importlib import import_module
from typing import Any

_HOMES = {"CalibrationDialogs": "dialogs", "CalibrationModel": "model", "CalibrationPage": "page"}


def __getattr__(name: str) -> Any:
    """Import what the window asks for."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
