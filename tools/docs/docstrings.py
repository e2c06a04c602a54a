"""Lets mkdocstrings read our docstrings: `name : text` on one line, with the type in the code."""

import re
from typing import Any

import griffe

_SECTION = re.compile(r"^(Parameters|Attributes|Returns|Yields|Raises)\n-+\n(.+\n?)*", re.MULTILINE)
_ENTRY = re.compile(r"^(\S.*?) : (.+)$", re.MULTILINE)


class NumpyDocstrings(griffe.Extension):
    """Writes entries as numpydoc has them, before they are parsed."""

    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        """Put the text of each entry on a line of its own."""
        if obj.docstring:
            obj.docstring.value = numpydoc(obj.docstring.value)


def numpydoc(text: str) -> str:
    """Return a docstring whose entries have their text below them, and whose examples begin as in Markdown."""
    text = text.replace("::\n", ":\n")
    return _SECTION.sub(lambda found: _ENTRY.sub(r"\1\n    \2", found[0]), text)
