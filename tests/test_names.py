"""One name has one meaning, in both packages and beside Python's own."""

import ast
import importlib
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from tests.conftest import ROOT
from tools.trees import nodes_of, tree_of

PACKAGES = (ROOT / "engine" / "phonemeengine", ROOT / "engine" / "phonemetraining", ROOT / "phonemeanalyser")
PYTHON_S_OWN = (
    "builtins",
    "collections",
    "collections.abc",
    "contextlib",
    "dataclasses",
    "enum",
    "functools",
    "itertools",
    "pathlib",
    "types",
    "typing",
)
"""The modules whose names people use without the module's before them."""


@cache
def modules() -> dict[Path, ast.Module]:
    """Give the product's modules, by their paths."""
    files = [path for package in PACKAGES for path in sorted(package.rglob("*.py"))]
    return {path.relative_to(ROOT): tree_of(path) for path in files}


def names_in(module: ast.Module) -> Iterator[str]:
    """Give what a module defines: its classes, functions and values."""
    for node in module.body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            yield node.name
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        yield from (target.id for target in targets if isinstance(target, ast.Name))


def test_no_class_is_called_as_another_one() -> None:
    places: defaultdict[str, list[str]] = defaultdict(list)
    for path in modules():
        for node in nodes_of(ROOT / path):
            if isinstance(node, ast.ClassDef):
                places[node.name.lstrip("_")].append(f"{path}:{node.lineno}")
    assert len(places) > 200
    assert {name: where for name, where in places.items() if len(where) > 1} == {}


def test_no_public_name_hides_one_of_python() -> None:
    modules_of_python = map(importlib.import_module, PYTHON_S_OWN)
    known = {name for module in modules_of_python for name in getattr(module, "__all__", dir(module))}
    public = [
        (name, str(path))
        for path, module in modules().items()
        for name in names_in(module)
        if not name.startswith("_")
    ]
    assert len(public) > 500
    assert [(name, path) for name, path in public if name in known] == []
