"""The API on one page: whole, typed, light, and without what only tests need."""

import ast
import importlib
import inspect
import os
import subprocess
import sys
import typing
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import phonemeengine

STUB = Path(phonemeengine.__file__).with_suffix(".pyi")
NAMES = [name for name in phonemeengine.__all__ if name != "__version__"]
PATHS = str | os.PathLike[str]
WRAPPED = ("fget", "func", "__func__")
"""Where properties, cached ones, and methods of classes keep their function."""
GIVEN = {"Transcript", "LabelledUtterance", "ModelFolder"}
"""Values that come from the engine, and hold paths rather than take them."""


def stubbed() -> dict[str, str]:
    """What the stub says of each name: the module that it comes from."""
    return {
        alias.name: f"phonemeengine.{node.module}"
        for node in ast.parse(STUB.read_text(encoding="utf-8")).body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


def functions_of(offered: object) -> Iterator[Callable[..., Any]]:
    """What a user of a name calls, or reads."""
    if not isinstance(offered, type):
        yield from [offered] if inspect.isfunction(offered) else []
        return
    for name, member in vars(offered).items():
        function = next((getattr(member, inner) for inner in WRAPPED if hasattr(member, inner)), member)
        if inspect.isfunction(function) and (name == "__init__" or not name.startswith("_")):
            yield function


def parts_of(hint: Any) -> Iterator[Any]:
    """A type, and all that it is made of."""
    yield hint
    for part in typing.get_args(hint):
        yield from (inner for one in (part if isinstance(part, list) else [part]) for inner in parts_of(one))


def hints() -> Iterator[tuple[str, str, Any]]:
    """Each type that the page speaks of: where, of what, and which."""
    for name in NAMES:
        offered = getattr(phonemeengine, name)
        for function in functions_of(offered):
            for part, hint in typing.get_type_hints(function).items():
                yield f"{name}: {function.__qualname__}", part, hint
        if isinstance(offered, type) and not issubclass(offered, Exception):
            for part, hint in typing.get_type_hints(offered).items():
                yield name, part, hint


def modules_after(program: str) -> set[str]:
    program += "; import sys; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


def test_the_page_gives_what_the_stub_says_and_is_short_enough_to_be_read() -> None:
    known = stubbed()
    assert sorted(known) == sorted(NAMES)
    assert len(known) <= 150
    for name, module in known.items():
        assert getattr(phonemeengine, name) is getattr(importlib.import_module(module), name)


def test_whoever_asks_for_something_else_is_told_so() -> None:
    with pytest.raises(AttributeError, match="No phonemeengine attribute Analyzer"):
        phonemeengine.Analyzer  # noqa: B018
    assert {"Analyser", "calibrate", "load_preset"} <= set(dir(phonemeengine))


def test_every_type_that_the_page_gives_or_takes_can_be_imported_by_its_name() -> None:
    spoken_of = {inner for *_, hint in hints() for inner in parts_of(hint) if isinstance(inner, type)}
    ours = {kind for kind in spoken_of if kind.__module__.startswith("phonemeengine.")}
    assert len(ours) > 100
    hidden = {
        kind
        for kind in ours
        if kind.__name__.startswith("_") or getattr(sys.modules[kind.__module__], kind.__name__, None) is not kind
    }
    assert hidden == set()


def test_every_error_of_the_engine_is_on_the_page() -> None:
    errors = importlib.import_module("phonemeengine.errors")
    assert {name for name, value in vars(errors).items() if inspect.isclass(value) and name.endswith("Error")} <= set(
        NAMES
    )


def test_a_path_may_be_text_wherever_one_is_taken() -> None:
    taken = [
        (where, part)
        for where, part, hint in hints()
        if part != "return" and Path in (hint, *typing.get_args(hint)) and where.partition(":")[0] not in GIVEN
    ]
    assert taken == []
    assert ("load_preset: load_preset", "path", PATHS) in list(hints())


def test_what_lives_is_closed_at_the_end_of_its_block() -> None:
    living = [name for name in NAMES if hasattr(getattr(phonemeengine, name), "close")]
    assert set(living) == {
        "Listener",
        "OscExpression",
        "OscMouth",
        "PerformanceTable",
        "Recorder",
        "Sound",
        "SoundReader",
    }
    for name in living:
        assert hasattr(getattr(phonemeengine, name), "__exit__")


def test_what_only_tests_need_is_not_on_the_page() -> None:
    for name in ("Listener", "Recorder", "Sound"):
        parameters = set(inspect.signature(getattr(phonemeengine, name)).parameters)
        assert not parameters & {"open_device", "open_input", "journal", "rescue"}


def test_nobody_waits_for_what_is_not_asked_for() -> None:
    assert "numpy" not in modules_after("import phonemeengine")
    game = modules_after("from phonemeengine import Listener, Morpher, Sound, load_preset, load_table")
    assert not {name for name in game if name.startswith(("phonemeengine.calibration", "phonemeengine.mouth.files"))}
    assert not game & {"scipy", "sounddevice", "pythonosc", "platformdirs", "tqdm"}
