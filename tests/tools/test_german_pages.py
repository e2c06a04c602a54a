"""The German pages of the manual say what the English ones do, with the labels of the German window."""

import re
from pathlib import Path

import pytest

from phonemeanalyser.desktop.help import blocks_of
from tests.conftest import ROOT
from tools.terms import GERMAN_PAGES, GLOSSARY
from tools.translations.ts_file import read_translations

PAGES = sorted(path for path in GERMAN_PAGES.glob("*.md") if path.name != GLOSSARY.name)
CODE = re.compile(r"^ *```.*?^ *```$|`[^`\n]+`", re.MULTILINE | re.DOTALL)
COMMENT = re.compile(r" +(#|/\*) .*$", re.MULTILINE)
LABEL = re.compile(r"(?<![*\w])\*([^*]+)\*(?![*\w])")
KIND = re.compile(r"#+ |\*\*|!\[|\d\. |\| |```|")
"""How a block of a page begins: a heading, a term, a picture, a step, a row, code, or a paragraph."""


def is_name(page: Path) -> str:
    return page.name


def english_of(page: Path) -> str:
    return (ROOT / "docs" / page.name).read_text("utf-8")


def plain(label: str) -> str:
    """Return a label as a page writes it amid a sentence: without markup, accelerator, arrow and ellipsis."""
    return re.sub(r"</?b>|&(?=\w)|^▶ | ▾$|…$", "", label.replace("&&", "&")).casefold()


def labels_in(text: str) -> set[str]:
    found = LABEL.findall(CODE.sub("", text))
    return {plain(part) for label in found for part in " ".join(label.split()).split(" > ")}


@pytest.mark.parametrize("page", PAGES, ids=is_name)
def test_a_german_page_has_the_blocks_of_the_english_one(page: Path) -> None:
    english, german = (
        [KIND.match(block)[0] for block in blocks_of(t)] for t in (english_of(page), page.read_text("utf-8"))
    )
    assert german == english


@pytest.mark.parametrize("page", PAGES, ids=is_name)
def test_a_german_page_has_the_rows_and_leads_where_the_english_one_does(page: Path) -> None:
    for found in (re.compile(r"^\|", re.MULTILINE), re.compile(r"([\w-]+)\.md[#)]")):
        english, german = (sorted(found.findall(text)) for text in (english_of(page), page.read_text("utf-8")))
        assert german == english


@pytest.mark.parametrize("page", PAGES, ids=is_name)
def test_a_german_page_has_the_code_of_the_english_one(page: Path) -> None:
    english, german = (
        re.findall(r"^```.*?^```", t, re.MULTILINE | re.DOTALL) for t in (english_of(page), page.read_text("utf-8"))
    )
    assert [COMMENT.sub("", code) for code in german] == [COMMENT.sub("", code) for code in english]


@pytest.mark.parametrize("page", PAGES, ids=is_name)
def test_a_german_page_names_what_the_german_window_has(page: Path) -> None:
    file = ROOT / "phonemeanalyser" / "desktop" / "translations" / "phonemeanalyser_de.ts"
    german_of: dict[str, set[str]] = {}
    for (english, _), german in read_translations(file).items():
        german_of.setdefault(plain(english), set()).add(plain(german))
    named, there = labels_in(english_of(page)), labels_in(page.read_text("utf-8"))
    assert {label for label in named if not german_of.get(label, {label}) & there} == set()
    assert there <= {german for label in named for german in german_of.get(label, {label})}


def test_the_list_of_pages_has_german_ones() -> None:
    assert "manual.md" in [page.name for page in PAGES]
