"""The strict reader: what fits is given, everything else is refused in one sentence that says what to do."""

from enum import StrEnum
from pathlib import Path

import pytest

from phonemeengine.errors import MouthError
from phonemeengine.mouth.expression.streams import load_expressions
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.strict_table import parse_toml


class Colour(StrEnum):
    RED = "red"
    BLUE = "blue"


TEXT = """
format = "colours 1"
name = "mine"
on = true
count = 4
share = 1
colour = "red"
phoneme = "sch"
colours = ["red", "blue"]
numbers = [1, 2.5]
[inner.deep]
x = 1
[[rows]]
y = 2
"""
TABLE = parse_toml(TEXT, "a file of colours", "colours 1", MouthError)


@pytest.mark.parametrize(
    ("key", "kind", "value"),
    [
        ("name", str, "mine"),
        ("on", bool, True),
        ("count", int, 4),
        ("count", float, 4.0),
        ("share", float, 1.0),
        ("colour", Colour, Colour.RED),
        ("phoneme", Phoneme, Phoneme.SCH),
        ("numbers", list, [1, 2.5]),
        ("inner", dict, {"deep": {"x": 1}}),
    ],
)
def test_an_entry_is_given_as_its_kind(key: str, kind: type, value: object) -> None:
    found = TABLE.value(key, kind)
    assert found == value
    assert type(found) is kind or kind is Phoneme


def test_lists_and_tables_are_given() -> None:
    assert TABLE.members("colours", Colour) == (Colour.RED, Colour.BLUE)
    assert TABLE.numbers("numbers") == (1.0, 2.5)
    assert TABLE.table("inner").table("deep").value("x", int) == 1
    assert [row.value("y", int) for row in TABLE.tables("rows")] == [2]
    assert (TABLE.table("none").entries, TABLE.tables("none")) == ({}, [])


@pytest.mark.parametrize(
    ("ask", "sentence"),
    [
        (lambda t: t.value("name", int), "name must be a whole number within ±3.4e38, found 'mine'; correct it"),
        (lambda t: t.value("on", int), "on must be a whole number within ±3.4e38, found True; correct it"),
        (lambda t: t.value("count", bool), "count must be true or false, found 4; correct it"),
        (lambda t: t.value("name", Colour), "name must be one of red, blue, found 'mine'; correct it"),
        (lambda t: t.value("count", Colour), "count must be one of red, blue, found 4; correct it"),
        (lambda t: t.limited("count", 0, 1, "a share in 0..1"), "count must be a share in 0..1, found 4; correct it"),
        (lambda t: t.numbers("colours"), "colours must be a list of numbers within ±3.4e38, found .*; correct it"),
        (lambda t: t.tables("colours"), "colours must be a list of tables, found .*; correct it"),
        (lambda t: t.table("name"), "name must be a table, found 'mine'; correct it"),
        (
            lambda t: t.table("inner").table("deep").value("x", str),
            r"\[inner.deep\] x must be text, found 1; correct it",
        ),
        (lambda t: t.table("inner").phonemes(), r"\[inner\]: there is no phoneme 'deep'; choose one of .*"),
        (lambda t: t.table("inner").check_keys(("x",)), r"\[inner\] cannot have an entry 'deep'; remove it, .* x"),
        (lambda t: t.table("none").check_keys(("x",)), r"\[none\] lacks x; add it"),
        (lambda t: t.read({"name": str}), "a file of colours cannot have an entry 'on'; remove .* name"),
    ],
)
def test_what_does_not_fit_is_refused_with_what_came_and_what_to_do(ask, sentence: str) -> None:
    with pytest.raises(MouthError, match=f"^{sentence}$"):
        ask(TABLE)


@pytest.mark.parametrize("number", ["nan", "-inf", "1e39", "9" * 400])
@pytest.mark.parametrize("kind", [int, float])
def test_a_number_that_is_none_is_refused(number: str, kind: type) -> None:
    table = parse_toml(f'format = "x"\nn = {number}', "it", "x", MouthError)
    with pytest.raises(MouthError, match=r"n must be a .* number within|n must be a number within"):
        table.value("n", kind)


@pytest.mark.parametrize("text", ["", "format = 3", 'format = "colours 2"', "[format]"])
def test_another_format_is_refused(text: str) -> None:
    with pytest.raises(MouthError, match="a file of colours begins with format = 'colours 1', found"):
        parse_toml(text, "a file of colours", "colours 1", MouthError)


def test_a_refusal_of_a_file_names_it(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('format = "phonemeanalyser expressions 1"\n[expressions.glad]\nmouthSmile = 101\n')
    with pytest.raises(
        MouthError, match=r"^mine.toml: \[expressions.glad\] mouthSmile must be percent, 0..100, found"
    ):
        load_expressions(path)
    with pytest.raises(MouthError, match=r"^none.toml: "):
        load_expressions(tmp_path / "none.toml")


def test_a_default_stands_for_what_is_not_there_and_for_nothing_else() -> None:
    assert TABLE.value("none", bool, False) is False
    assert TABLE.value("on", bool, False) is True
    assert TABLE.limited("none", 0, 1, "a share in 0..1", 0.0) == 0
    with pytest.raises(MouthError, match="count must be a share"):
        TABLE.limited("count", 0, 1, "a share in 0..1", 0.5)
