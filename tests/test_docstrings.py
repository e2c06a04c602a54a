"""What docstrings and comments say is so, as far as a machine can tell."""

import ast
import builtins
import io
import pkgutil
import re
import sys
import tokenize
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.test_names import PACKAGES, modules
from tools.terms import statements

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
TICKED = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
"""A name; what stands between two back-ticks on both sides is a literal."""
NOTHING = re.compile(r"Returns? (nothing|None)\b")


def functions(tree: ast.AST) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    yield from (node for node in statements(tree) if isinstance(node, FUNCTIONS))


def false_returns(tree: ast.AST) -> Iterator[str]:
    """Give the functions whose docstrings say that they return something, or nothing, where they do not."""
    for function in functions(tree):
        said = ast.get_docstring(function) or ""
        if said.startswith("Return"):
            kind = ast.unparse(function.returns or ast.Name("None"))
            if kind == "None" and not NOTHING.match(said):
                yield f"{function.name}:{function.lineno} returns nothing"
            if "None" not in kind and NOTHING.match(said):
                yield f"{function.name}:{function.lineno} returns something"


def stored(target: ast.AST) -> Iterator[str]:
    for node in ast.walk(target):
        if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.id if isinstance(node, ast.Name) else node.attr


def names_of(tree: ast.AST) -> Iterator[str]:
    """Give all names and texts that code holds, docstrings left out."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield name
            case ast.Name(id=name) | ast.Attribute(attr=name) | ast.arg(arg=name) | ast.keyword(arg=str(name)):
                yield name
            case ast.alias(name=name):
                yield from name.split(".")
            case ast.Constant(value=str(text)):
                yield text


def members_of(definition: ast.ClassDef) -> set[str]:
    """Return the methods, fields and attributes of a class."""
    return {*stored(definition), *(function.name for function in functions(definition))}


class Product:
    """All that the product defines: modules, what stands at their tops, and the members of classes."""

    def __init__(self, trees: dict[Path, ast.Module]) -> None:
        self.modules = {part for path in trees for part in (*path.parts, path.stem)}
        self.tops = set(dir(builtins))
        self.members: defaultdict[str, set[str]] = defaultdict(set)
        self.bases: defaultdict[str, list[str]] = defaultdict(list)
        for tree in trees.values():
            for node in tree.body:
                defines = isinstance(node, (*FUNCTIONS, ast.ClassDef))
                self.tops |= {node.name} if defines else set(stored(node))
            for definition in (node for node in statements(tree) if isinstance(node, ast.ClassDef)):
                self.tops.add(definition.name)
                self.members[definition.name] |= members_of(definition)
                self.bases[definition.name] += [ast.unparse(base) for base in definition.bases]

    def has(self, name: str, nearby: set[str]) -> bool:
        """Return whether a name is one of the product, of its module or of an installed package."""
        return self._defines(name, nearby) or is_installed(name)  # which may import much

    def _defines(self, name: str, nearby: set[str]) -> bool:
        *owners, last = name.split(".")
        if name in nearby or name in self.tops:
            return True
        if owners and owners[-1] in self.members:
            return self._is_member(owners[-1], last)
        if owners:
            return all(part in nearby or part in self.tops or part in self.modules for part in name.split("."))
        return any(self._is_member(owner, name) for owner in nearby & self.members.keys())

    def _is_member(self, owner: str, name: str) -> bool:
        bases = self.bases[owner]
        foreign = [base for base in bases if base not in self.members and "." in base]  # Qt's, say
        return name in self.members[owner] or bool(foreign) or any(self._is_member(base, name) for base in bases)


def is_installed(name: str) -> bool:
    """Return whether a name begins with a module of Python, is one of a package, or is a command that runs one."""
    name = name.removeprefix("python -m ")
    if name.split(".")[0] in sys.stdlib_module_names or name in (package.name for package in PACKAGES):
        return True
    try:
        return "." in name and pkgutil.resolve_name(name) is not None
    except (ImportError, AttributeError, ValueError):
        return False


def prose_of(tree: ast.Module, text: str) -> Iterator[tuple[int, str]]:
    """Give the docstrings and comments of a module, with the lines that they begin at."""
    for node in statements(tree):
        match node:
            case ast.Expr(value=ast.Constant(value=str(said))):
                yield node.lineno, said
    if re.search(r"#.*`", text):  # it takes long
        tokens = tokenize.generate_tokens(io.StringIO(text).readline)
        yield from ((token.start[0], token.string) for token in tokens if token.type == tokenize.COMMENT)


def stale_names(path: Path, tree: ast.Module, product: Product) -> Iterator[str]:
    text = (ROOT / path).read_text(encoding="utf-8")
    if TICKED.search(text):
        named = [(line, name) for line, said in prose_of(tree, text) for name in TICKED.findall(said)]
        elsewhere = [(line, name) for line, name in named if name not in product.tops]
        if elsewhere:  # to gather all names of a module takes long
            nearby = {*names_of(tree), *(module.stem for module in (ROOT / path).parent.iterdir())}
            yield from (f"{path}:{line} `{name}`" for line, name in elsewhere if not product.has(name, nearby))


def described_again(trees: dict[Path, ast.Module]) -> list[str]:
    """Give the overrides whose docstring is that of what they override."""
    classes = [node for tree in trees.values() for node in statements(tree) if isinstance(node, ast.ClassDef)]
    bases = {node.name: [ast.unparse(base).split("[")[0] for base in node.bases] for node in classes}
    said = {(node.name, method.name): ast.get_docstring(method) for node in classes for method in functions(node)}

    def inherited(owner: str, method: str) -> str | None:
        found = (said.get((base, method)) or inherited(base, method) for base in bases.get(owner, ()))
        return next(filter(None, found), None)

    return [".".join(key) for key, docstring in said.items() if docstring and docstring == inherited(*key)]


def test_overrides_are_not_described_again() -> None:
    assert described_again(modules()) == []


def test_an_override_that_is_described_again_is_found() -> None:
    text = "\n".join(
        f"class {name}:\n  def close(self):\n    'Close {what}.'"
        for name, what in [("Door", "it"), ("Gate(Door)", "both wings"), ("Hatch(Gate)", "both wings"), ("Lid", "it")]
    )
    assert described_again({Path("doors.py"): ast.parse(text)}) == ["Hatch.close"]


def test_docstrings_say_return_where_something_is_returned() -> None:
    found = {str(path): list(false_returns(tree)) for path, tree in modules().items()}
    assert {path: functions for path, functions in found.items() if functions} == {}


@pytest.mark.parametrize(
    ("head", "docstring", "is_false"),
    [
        ("def f() -> None", "Return the sum.", True),
        ("async def f() -> None", "Return the sum.", True),
        ("def f() -> None", "Return nothing.", False),
        ("def f() -> None", "Add them up.", False),
        ("def f() -> int", "Return the sum.", False),
        ("def f() -> int", "Return nothing.", True),
    ],
)
def test_a_false_return_is_found(head: str, docstring: str, is_false: bool) -> None:
    assert bool([*false_returns(ast.parse(f'{head}:\n    """{docstring}"""'))]) == is_false


def test_every_name_in_back_ticks_exists() -> None:
    product = Product(modules())
    assert [stale for path, tree in modules().items() for stale in stale_names(path, tree, product)] == []


@pytest.mark.parametrize(
    ("said", "stale"),
    [
        ("`Sound`, `Sound.length`, `Sound.cut`, `cut`, `HOP`, `numpy.fft` and `loud`", []),
        ("``Sounds`` is a literal", []),
        ("`Sounds`", ["Sounds"]),
        ("`Sound.size`", ["Sound.size"]),
        ("`Loud.cut` is inherited, `Loud.size` is not", ["Loud.size"]),
    ],
)
def test_a_stale_name_is_found(said: str, stale: list[str], tmp_path: Path) -> None:
    path = tmp_path / "sound.py"
    path.write_text(
        f'HOP = 441\n\n\nclass Sound:\n    """{said}."""\n\n    length: int\n\n    def cut(self, loud: bool): ...\n'
        "\n\nclass Loud(Sound): ...\n"
    )
    tree = ast.parse(path.read_text(encoding="utf-8"))
    assert [found.split("`")[1] for found in stale_names(path, tree, Product({path: tree}))] == stale
