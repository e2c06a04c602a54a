"""Finds the texts of the window that are translated: those that the code gives to `tr` and its relatives.

To these come the words of the engine's table of parameters, so that a filter is named in one place, and the sentences
with which it refuses something.
"""

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from phonemeengine.settings import STAGES
from tools.translations.errors import errors_in
from tools.trees import nodes_of

ROOT = Path(__file__).resolve().parents[2]
WINDOW = ROOT / "phonemeanalyser" / "desktop"
N_TEXTS = {"tr": 1, "tr_noop": 1, "tr_amid": 1, "tr_count": 2}
"""How many of the first arguments of each function are texts."""


@dataclass(frozen=True)
class Source:
    """A text in English, and where it stands.

    Attributes
    ----------
    text, comment : what `tr` is given.
    file : the module, from the folder of the program on.
    """

    text: str
    comment: str
    file: str


@cache
def sources_in(folder: Path = WINDOW) -> dict[tuple[str, str], Source]:
    """Return all texts of a folder and of the engine by text and comment, each where it is found first."""
    found: dict[tuple[str, str], Source] = {}
    for path in sorted(folder.rglob("*.py")):
        for text, comment in texts_of(nodes_of(path)):
            found.setdefault((text, comment), Source(text, comment, path.relative_to(ROOT).as_posix()))
    for text in texts_of_parameters():
        found.setdefault((text, ""), Source(text, "", "engine/phonemeengine/settings.py"))
    for text, path in errors_in().items():
        found.setdefault((text, ""), Source(text, "", path.relative_to(ROOT).as_posix()))
    return found


def texts_of_parameters() -> Iterator[str]:
    """Yield the words of the engine's table of parameters."""
    for stage in STAGES.values():
        of_parameters = (words for of in stage.parameters for words in (of.label, of.part))
        words = (stage.label, stage.hint, *of_parameters, *stage.hints)
        yield from filter(None, words)


def texts_of(nodes: Iterable[ast.AST]) -> Iterator[tuple[str, str]]:
    """Yield text and comment of every call that has them as literals, in order."""
    for node in nodes:
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in N_TEXTS):
            continue
        comment = _literal(node.args[1]) if node.func.id == "tr" and len(node.args) > 1 else None
        for argument in node.args[: N_TEXTS[node.func.id]]:
            yield from ((text, comment or "") for text in _literals(argument))


def _literals(node: ast.expr) -> Iterator[str]:
    """Yield the texts that an argument can be: one, or either of a choice."""
    if isinstance(node, ast.IfExp):
        yield from (*_literals(node.body), *_literals(node.orelse))
    elif (text := _literal(node)) is not None:
        yield text


def _literal(node: ast.expr) -> str | None:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None
