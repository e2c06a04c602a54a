"""The desktop program."""

import builtins

import PySide6.QtCore  # noqa: F401 - it replaces Python's import

# What it puts there reads the source of every module and keeps it, to know who imports other spellings of names from
# PySide6. Nothing here does, and the window would be seen a fifth later.
builtins.__import__ = vars(builtins).get("__orig_import__", builtins.__import__)
