"""The documentation: its links lead somewhere, what it names is there, and the formats stand in it key by key."""

import ast
import importlib
import re
import tomllib
from argparse import ArgumentParser
from collections.abc import Iterator
from dataclasses import fields
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import tomli_w

from phonemeanalyser.server.files import FIELDS
from phonemeengine.conversion.options import OPTIONS, SERVED, Option
from phonemeengine.errors import PresetError
from phonemeengine.features.variables import BUILT_IN_NAMES, Kind, Spectrum
from phonemeengine.labels.phone_sets import ARTICULATIONS, CONSONANT_CLASSES, VOWEL_CLASSES
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.style import GROUPS, limits_of
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.document import preset_from_toml, preset_to_toml
from phonemeengine.presets.files import FACTORY, FACTORY_PRESETS, load_preset
from phonemeengine.recognition.rules import LAYOUT
from phonemeengine.settings import PARAMETERS, AnalysisSettings, Decimation, Filter, WindowFunction
from phonemeengine.speech.pinyin.table import USUAL_PINYIN_TABLE
from phonemeengine.speech.pinyin.timing import format_plan
from phonemeengine.speech.pinyin.track import pinyin_track
from tests.conftest import ROOT
from tools.trees import tree_of

DOCS = ROOT / "docs"
PAGES = [*sorted(DOCS.rglob("*.md")), *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md"))]
LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCE = re.compile(r"^ *```.*?^ *```", re.MULTILINE | re.DOTALL)
NAME = re.compile(r"`([A-Z][a-z]\w*)\.(\w+)`")
PLACE = re.compile(r"`((?:engine|phonemeanalyser|tests|tools|examples|docs|presets|screenshots|\.github)/[\w./-]+)`")
PRESETS = (DOCS / "presets.md").read_text(encoding="utf-8")
EXPRESSION_PAGE = (DOCS / "expression.md").read_text(encoding="utf-8")
FORMATS_PAGE = (DOCS / "formats.md").read_text(encoding="utf-8")

CONVERTING = ("analyse", "align", "export", "preview", "speak")

Row = tuple[str, str, str, str]
"""Key, type, range and default."""


def prose(page: Path) -> str:
    return FENCE.sub("", page.read_text(encoding="utf-8"))


@cache
def anchors(page: Path) -> set[str]:
    titles = re.findall(r"^#+ (.+)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", title).strip().lower().replace(" ", "-") for title in titles}


def pairs(pattern: re.Pattern[str]) -> list[tuple[Path, Any]]:
    return [(page, found) for page in PAGES for found in dict.fromkeys(pattern.findall(prose(page)))]


def shown(page: Path) -> str:
    return page.relative_to(ROOT).as_posix()


def test_every_link_leads_somewhere() -> None:
    links = [(page, link) for page, link in pairs(LINK) if "://" not in link]
    assert len(links) > 300
    assert [(shown(page), link) for page, link in links if not leads_somewhere(page, link)] == []


def leads_somewhere(page: Path, link: str) -> bool:
    place, _, anchor = link.partition("#")
    target = (page.parent / place).resolve() if place else page
    return target.exists() and target.is_relative_to(ROOT) and (not anchor or anchor in anchors(target))


def test_every_page_stands_in_the_list_of_pages() -> None:
    listed = re.findall(r": (\S+\.md)$", (ROOT / "mkdocs.yml").read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(listed) == sorted(
        [*(page.relative_to(DOCS).as_posix() for page in DOCS.rglob("*.md")), "CONTRIBUTING.md", "CHANGELOG.md"]
    )


def test_a_newcomer_reads_no_more_than_150_lines() -> None:
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) <= 150


def test_every_file_that_is_named_is_there() -> None:
    places = pairs(PLACE)
    assert len(places) > 90
    assert [(shown(page), place) for page, place in places if not (ROOT / place).exists()] == []


def test_every_name_of_the_code_is_there() -> None:
    names = [(page, name) for page, name in pairs(NAME) if page.name != "CHANGELOG.md"]
    assert len(names) > 25
    assert [(shown(page), name) for page, name in names if name not in defined()] == []


def test_what_the_page_on_the_engine_calls_is_where_it_says() -> None:
    page = prose(DOCS / "engine.md")
    modules = [
        importlib.import_module(name) for name in {"phonemeengine", *re.findall(r"`(phonemeengine\.[\w.]+)`", page)}
    ]
    called = re.findall(r"(?<![\w.])([A-Za-z]\w+)\(", " ".join(re.findall(r"`([^`]+)`", page)))
    assert len(called) > 20
    assert {name for name in called if not any(hasattr(module, name) for module in modules)} == {"close"}


def test_the_way_of_a_block_names_what_is_there() -> None:
    told = [line.split("|")[2].strip(" `") for line in prose(DOCS / "architecture.md").splitlines() if "| `" in line]
    way = [name for name in told if re.fullmatch(r"\w+(\.\w+)?", name)]
    assert len(way) > 15
    assert [name for name in way if (*name.split("."), "")[:2] not in defined()] == []


@cache
def defined() -> frozenset[tuple[str, str]]:
    """Name each class and function of both packages, and each class with each of its members."""
    files = [path for folder in ("engine", "phonemeanalyser") for path in (ROOT / folder).rglob("*.py")]
    return frozenset(name for path in files for name in _names(tree_of(path)))


def _names(module: ast.Module) -> Iterator[tuple[str, str]]:
    for node in module.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name, ""
        if isinstance(node, ast.ClassDef):
            yield from ((node.name, member) for member in _members(node))


def _members(node: ast.ClassDef) -> Iterator[str]:
    for part in ast.walk(node):
        if isinstance(part, ast.FunctionDef):
            yield part.name
        elif isinstance(part, ast.Attribute) and isinstance(part.ctx, ast.Store):
            yield part.attr
        elif isinstance(part, ast.AnnAssign) and isinstance(part.target, ast.Name):
            yield part.target.id
        elif isinstance(part, ast.Assign) and part in node.body:  # such as the members of an enumeration
            yield from (target.id for target in part.targets if isinstance(target, ast.Name))


def sections(page: str) -> dict[str, str]:
    """Return the text under each heading."""
    parts = re.split(r"^## (.+)$", page, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def rows(section: str, page: str = PRESETS) -> dict[str, Row]:
    """Return the rows of the table in a section, by key; rows of several keys give several."""
    found: dict[str, Row] = {}
    for line in sections(page)[section].splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| `"):
            key, kind, limits, default = (*cells[:4], "", "", "")[:4]
            found |= {name: (name, kind, limits, default) for name in re.findall(r"`([^`]+)`", key)}
    return found


def factory_documents() -> list[dict[str, object]]:
    return [tomllib.loads(path.read_text(encoding="utf-8")) for path in FACTORY_PRESETS]


@pytest.mark.parametrize("document", factory_documents(), ids=lambda document: str(document["name"]))
def test_every_key_of_a_preset_stands_in_the_docs(document: dict[str, object]) -> None:
    assert document.keys() <= rows("The whole file").keys()
    for key, value in document.items():
        several = isinstance(value, dict) and key == "confidence"  # one for each model
        tables = value if isinstance(value, list) else list(value.values()) if several else [value]
        for table in tables:
            if isinstance(table, dict) and key not in ("successors", "sensitivities"):
                assert table.keys() <= rows(key).keys(), key


@pytest.mark.parametrize("section", ["The whole file", "front_end", "phoneme_data", "statistics", "intensity"])
def test_the_docs_say_which_keys_of_a_preset_must_be_there(section: str) -> None:
    document = tomllib.loads(preset_to_toml(load_preset(FACTORY / "thesis.toml")))
    for key, _, _, default in rows(section).values():
        changed = {name: dict(value) if isinstance(value, dict) else value for name, value in document.items()}
        (changed if section == "The whole file" else changed[section]).pop(key, None)
        assert is_preset(changed) is (default != "-"), key


def is_preset(document: dict[str, object]) -> bool:
    try:
        preset_from_toml(tomli_w.dumps(document), FACTORY)
    except PresetError:
        return False
    return True


def test_ranges_and_defaults_of_the_docs_are_those_of_the_settings() -> None:
    told = {**rows("The whole file"), **rows("front_end"), **rows("statistics"), **rows("intensity")}
    told |= {name: row for name, row in rows("phoneme_data").items() if name in PARAMETERS and "bins" not in row[2]}
    for name, of in PARAMETERS.items():
        if name in told and not of.choices:
            assert told[name][2].startswith(f"{of.low:g}..{of.high:g}"), name
    assert {name for name in PARAMETERS if not name.startswith("high_pass")} <= told.keys()
    for field in fields(AnalysisSettings):
        if field.name in told and told[field.name][3] != "-" and not isinstance(field.default, str):
            assert float(told[field.name][3]) == field.default, field.name


def test_the_docs_name_every_choice_that_a_preset_has() -> None:
    choices = (*Filter, *Decimation, *WindowFunction, *Kind, *Spectrum, *BUILT_IN_NAMES, *(p.label for p in Phoneme))
    assert [choice for choice in choices if f"`{choice}`" not in PRESETS] == []


def test_the_docs_have_the_lines_of_a_phoneme_data_file() -> None:
    text = re.findall(r"^```text\n(.*?)^```", PRESETS, re.MULTILINE | re.DOTALL)[0]
    assert text.splitlines() == [", ".join(line) for line in LAYOUT]


def test_the_docs_name_every_key_of_the_mouth_tables() -> None:
    told = rows("Mouth tables", FORMATS_PAGE)
    for name in shipped_tables():
        path = ROOT / "engine" / "phonemeengine" / "mouth" / "tables" / f"{name}.toml"
        for key, value in tomllib.loads(path.read_text(encoding="utf-8")).items():
            assert {key, f"[{key}]", f"[{key}.NAME]"} & told.keys(), key
            if key == "manner":
                assert all(f"`{manner}`" in FORMATS_PAGE for manner in value)


def test_the_docs_name_every_key_of_the_pinyin_table() -> None:
    page = (DOCS / "pinyin.md").read_text(encoding="utf-8")
    told = rows("A table of your own", page)
    document = tomllib.loads(USUAL_PINYIN_TABLE.read_text(encoding="utf-8"))
    assert all({key, f"[{key}]", f"[{key}.NAME]"} & told.keys() for key in document)
    named = ["syllables", *(key for section in ("weights", "transition") for key in document[section])]
    assert all(f"`{key}`" in page for key in named)


def test_the_docs_have_the_plan_that_is_made_of_their_text() -> None:
    plan = (DOCS / "pinyin.md").read_text(encoding="utf-8").split("```text\n")[1].split("```")[0]
    assert plan == format_plan(pinyin_track("你好。").plan)


def test_the_docs_name_the_sounds_of_every_class_in_their_order() -> None:
    told = [line for line in FORMATS_PAGE.splitlines() if any(f"| `{name}` |" in line for name in ARTICULATIONS)]
    classes = CONSONANT_CLASSES | {"consonant": "all of these"} | VOWEL_CLASSES | {"vowel": "all of these"}
    assert told == [f"| `{name}` | {letters} |" for name, letters in classes.items()]
    assert list(classes) == list(ARTICULATIONS)


def test_the_docs_have_every_option_of_a_conversion_as_it_is_declared() -> None:
    page = (DOCS / "command-line.md").read_text(encoding="utf-8")
    told = [line for line in page.splitlines() if line.startswith("| `--")]
    assert told == [option_row(name, option) for name, option in OPTIONS.items()]


def option_row(name: str, option: Option) -> str:
    words = option.words.replace("<", "&lt;").replace("|", "\\|").replace("*", "\\*")
    value = option.value.replace("|", "\\|")
    limits = "{:g}..{:g}".format(*option.limits) if option.limits else ""
    takers = [command for command in CONVERTING if f"--{name}" in options_of(command)]
    takers += ["server"] if name in SERVED else []
    return f"| `--{name}{f' {value}' if value else ''}` | {words} | {limits} | {', '.join(takers)} |"


@cache
def options_of(command: str) -> frozenset[str]:
    parser = ArgumentParser()
    importlib.import_module(f"phonemeanalyser.cli.{command}").add_arguments(parser)
    return frozenset(parser._option_string_actions)


def test_the_docs_of_the_server_name_its_fields() -> None:
    told = (DOCS / "server.md").read_text(encoding="utf-8").split("`POST /export`")[1].split("as [the")[0]
    assert re.findall(r"`([a-z-]+)`", told) == ["sound", *FIELDS]


def test_the_docs_name_every_export_with_its_rate() -> None:
    told = rows("Exports", FORMATS_PAGE)
    assert told.keys() == FORMATS.keys()
    lines = {key: line for line in FORMATS_PAGE.splitlines() for key in FORMATS if f"| `{key}`" in line}
    for key, line in lines.items():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        assert (cells[3] or "0", cells[4] or "0 ms") == (
            f"{FORMATS[key].rate:g}",
            f"{1000 * FORMATS[key].anticipation:g} ms",
        ), key


def test_the_docs_have_every_number_of_a_style_with_its_limits() -> None:
    told = [line.split(" | ")[:3] for line in EXPRESSION_PAGE.splitlines() if line.startswith("| `[")]
    assert told == [
        [f"| `[{group}]` `{entry.name}`", f"{entry.default:g}", "{:g}..{:g}".format(*limits_of(entry)[:2])]
        for group, kind in GROUPS.items()
        for entry in fields(kind)
    ]
