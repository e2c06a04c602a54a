"""Rules of the project that a look at the source can check: no patched modules, and no sleeps."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import ROOT

PATCHES = {"monkeypatch.setattr", "patch.setattr", "mock.patch", "mock.patch.object", "patch.object", "mocker.patch"}
SLEEPS = {"time.sleep", "sleep", "asyncio.sleep", "qtbot.wait", "QTest.qWait", "QTest.qSleep"}
PRIVATE = re.compile(r"(?<!\bself)(?<!\bcls)(?<!\bos)(?<![\"/])\._(?!replace\b)[a-z]\w*|import .*\b_[a-z]")
MOST_PRIVATE = 75
"""Lines of tests that use a private name of something else; may only fall."""
WAITING = ROOT / "tests" / "waiting.py"
"""Where waiting has its one home."""


def called(source: str) -> Iterator[tuple[str, int]]:
    """Give what a program calls by name, each with its line; a sleep of no time only lets others have their turn."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and not (
            node.args and isinstance(node.args[0], ast.Constant) and node.args[0].value == 0
        ):
            yield ast.unparse(node.func), node.lineno


def sources(*folders: str) -> Iterator[tuple[Path, str]]:
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*.py")):
            yield path, path.read_text(encoding="utf-8")


def broken(names: set[str], source: str) -> list[int]:
    """Give the lines that call one of these, also in programs that stand in a text."""
    if not any(name in source for name in names):
        return []
    programs = [source, *(node.value for node in ast.walk(ast.parse(source)) if is_program(node))]
    return [line for program in programs for name, line in called(program) if name in names]


def is_program(node: ast.AST) -> bool:
    """Say whether a text is a program of several lines."""
    if not isinstance(node, ast.Constant) or not isinstance(node.value, str) or "import" not in node.value:
        return False
    try:
        ast.parse(node.value)
    except SyntaxError:
        return False
    return True


@pytest.mark.parametrize(
    ("source", "lines"),
    [
        ("monkeypatch.setattr(room, 'N', 3)", [1]),
        ("def test():\n    with mock.patch('a.b'):\n        pass", [2]),
        ("import time\ntime.sleep(0.1)", [2]),
        ("async def wait():\n    await asyncio.sleep(0.01)\n    await asyncio.sleep(0)", [2]),
        ("qtbot.wait(20); QTest.qWait(5)", [1, 1]),
        ("CHILD = 'import time; time.sleep(60)'", [1]),
        (
            "monkeypatch.setenv('HOME', ''); monkeypatch.setitem(sys.modules, 'av', None); settle(); wait_for(done)",
            [],
        ),
    ],
)
def test_what_is_patched_and_what_sleeps_is_found(source: str, lines: list[int]) -> None:
    assert broken(PATCHES | SLEEPS, source) == lines


def test_tests_patch_nothing_and_wait_in_one_place() -> None:
    found = {
        str(path.relative_to(ROOT)): broken(PATCHES | SLEEPS if path != WAITING else PATCHES, source)
        for path, source in sources("tests")
        if path != Path(__file__)
    }
    assert len(found) > 300
    assert {path: lines for path, lines in found.items() if lines} == {}


def private_uses(source: str) -> list[str]:
    return [line.strip() for line in source.splitlines() if PRIVATE.search(line)]


def test_hardly_a_test_uses_a_private_name() -> None:
    assert private_uses("self._one\npoint._replace(x=1)\nos._exit(1)\nplayer._thread\nfrom a import b, _c") == [
        "player._thread",
        "from a import b, _c",
    ]
    found = [line for path, source in sources("tests") if path != Path(__file__) for line in private_uses(source)]
    assert len(found) <= MOST_PRIVATE, found


def test_types_are_not_imported_apart() -> None:
    found = [
        path
        for path, source in sources("engine", "phonemeanalyser", "tools", "examples")
        if "TYPE_CHECKING" in source
    ]
    assert found == []
