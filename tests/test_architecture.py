"""Architectural rules that a machine can check."""

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PRODUCT = ("engine", "phonemeanalyser")
MOST = 10
"""Lines of code that may not stand twice."""
LONGEST = 500
"""Lines that a file of Python may have."""
DESKTOP = "phonemeanalyser.desktop"
DRAWING = ("PySide6.QtWidgets", "pyqtgraph", f"{DESKTOP}.theme")
"""Of what a view is made."""


def stretches(text: str, n: int) -> dict[tuple[str, ...], int]:
    """Give all n lines that follow each other, and where they begin; layout and comments do not count."""
    lines = [(number, " ".join(line.split())) for number, line in enumerate(text.splitlines(), 1)]
    lines = [(number, line) for number, line in lines if line and not line.startswith("#")]
    return {tuple(line for _, line in lines[k : k + n]): lines[k][0] for k in range(len(lines) - n + 1)}


def repeated(texts: dict[str, str], n: int) -> list[list[str]]:
    """Give the places of all n lines that stand in two texts or more, but for imports."""
    places = defaultdict(list)
    for name, text in texts.items():
        for stretch, line in stretches(text, n).items():
            if not all(line.startswith(("import ", "from ")) for line in stretch):
                places[stretch].append(f"{name}:{line}")
    return [found for found in places.values() if len(found) > 1]


def test_no_ten_lines_of_product_code_stand_twice() -> None:
    files = [path for folder in PRODUCT for path in (ROOT / folder).rglob("*.py")]
    assert len(files) > 100
    assert repeated({str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in files}, MOST) == []


@pytest.mark.parametrize(("n", "found"), [(3, [["a:2", "b:1"]]), (4, [])])
def test_lines_that_stand_twice_are_found_however_they_are_laid_out(n: int, found: list[list[str]]) -> None:
    texts = {"a": "x = 1\nif y:\n    z()\n\nelse:\n", "b": "if  y:\n  # why\n  z()\nelse:\nw\n"}
    assert repeated(texts, n) == found


def test_no_import_hides_from_the_program() -> None:
    files = [path for folder in (*PRODUCT, "tests", "tools") for path in (ROOT / folder).rglob("*.py")]
    texts = {str(path): path.read_text(encoding="utf-8") for path in files}
    found = {path: ast.walk(ast.parse(text)) for path, text in texts.items() if "TYPE_CHECKING" in text}
    assert __file__ in found  # which names it in a text
    assert [path for path, nodes in found.items() for node in nodes if "TYPE_CHECKING" in _names_in(node)] == []


def _names_in(node: ast.AST) -> set[str]:
    if isinstance(node, ast.ImportFrom):
        return {alias.name for alias in node.names}
    return {getattr(node, "id", ""), getattr(node, "attr", "")}


def too_long(texts: dict[str, str]) -> list[str]:
    """Give the names of all texts with more lines than a file may have."""
    return [name for name, text in texts.items() if len(text.splitlines()) > LONGEST]


def test_no_file_of_python_is_longer_than_the_rule_allows() -> None:
    files = [path for folder in (*PRODUCT, "tests") for path in (ROOT / folder).rglob("*.py")]
    assert too_long({str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in files}) == []


def test_a_file_is_too_long_from_the_line_after_the_last_that_it_may_have() -> None:
    assert too_long({"one": "x\n" * LONGEST, "other": "x\n" * LONGEST + "x"}) == ["other"]


# -- models know no view ------------------------------------------------------------------------------


def imports_of(text: str) -> Iterator[str]:
    """Give all that a module imports, wherever it does: modules, and the names that are taken out of them."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (str(node.module), *(f"{node.module}.{name.name}" for name in node.names))


def is_model(module: str) -> bool:
    """Return whether a module is one that may not know a view: by its package, or by its name."""
    name = module.rpartition(".")[2]
    return f"{module}.".startswith(f"{DESKTOP}.session.") or name == "model" or name.endswith("_model")


def views_known(texts: dict[str, str]) -> list[str]:
    """Give each model of the desktop that knows a view, and by which modules it comes to it."""
    imports = {module: set(imports_of(text)) for module, text in texts.items()}
    views = {module for module, known in imports.items() if known & set(DRAWING)} | set(DRAWING)
    found = []
    for model in filter(is_model, texts):
        ways = [(model,)]
        seen = {model}
        for way in ways:
            if way[-1] in views:
                found.append(" > ".join(name.removeprefix(f"{DESKTOP}.") for name in way))
                break
            ways += [(*way, name) for name in sorted((imports[way[-1]] & imports.keys()) - seen)]
            seen |= imports[way[-1]]
    return found


def test_models_of_the_desktop_know_no_view() -> None:
    folder = ROOT / DESKTOP.replace(".", "/")
    files = {path: path.relative_to(ROOT).with_suffix("").parts for path in folder.rglob("*.py")}
    texts = {".".join(parts).removesuffix(".__init__"): path.read_text("utf-8") for path, parts in files.items()}
    models = list(filter(is_model, texts))
    assert f"{DESKTOP}.talk.model" in models
    assert len(models) > 30
    assert views_known(texts) == []


def test_a_model_that_comes_to_a_view_by_another_module_is_found() -> None:
    label = "from PySide6.QtWidgets import QLabel"
    texts = {
        f"{DESKTOP}.talk.voice_model": f"from {DESKTOP}.talk import words",
        f"{DESKTOP}.talk.words": f"def show():\n    import {DESKTOP}.talk.lanes",
        f"{DESKTOP}.talk.lanes": label,
        f"{DESKTOP}.talk.page": f"from {DESKTOP}.talk.lanes import QLabel",
        f"{DESKTOP}.session.history": label,
        f"{DESKTOP}.talk.model": "from PySide6.QtCore import QObject",
    }
    assert views_known(texts) == ["talk.voice_model > talk.words > talk.lanes", "session.history"]
