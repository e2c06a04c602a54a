"""The sources as trees, each read once, however many look through it."""

import ast
import gc
from functools import cache
from pathlib import Path


@cache
def tree_of(path: Path) -> ast.Module:
    """Return the tree of a file of Python."""
    tree = ast.parse(path.read_text("utf-8"))
    gc.freeze()  # trees stay: to look through all of them at each collection takes half a second
    return tree


@cache
def nodes_of(path: Path) -> list[ast.AST]:
    """Return all nodes of that tree, which take as long to walk through as to read."""
    return [*ast.walk(tree_of(path))]
