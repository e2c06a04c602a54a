"""The manual inside the program: the pages of ``docs``, read in a window, and quoted by *What Is This?*.

A page is in the language of the window where there is a translation, such as ``docs/de/manual.md``, else in English.
A translation has the headings and paragraphs of the English page in the same order: links and *What Is This?* name
the English ones.
"""

import re
from functools import cache
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices, QTextCursor
from PySide6.QtWidgets import QDialog, QLineEdit, QListWidget, QTextBrowser, QWidget

from phonemeanalyser.desktop.language import WRITTEN_IN, language_in_use, tr
from phonemeanalyser.desktop.widgets.builders import CLOSE, column, dialog_buttons, named, row
from phonemeanalyser.licences import licences_text

PAGES = (
    "index",
    "tune-thresholds",
    "calibrate-my-voice",
    "animate-a-recording",
    "ship-to-a-game",
    "manual",
    "calibrating",
    "recognisers",
    "presets",
    "script",
    "speaking",
    "pinyin",
    "performance",
    "expression",
    "blender",
    "formats",
    "command-line",
    "cluster",
    "engine",
    "ship",
    "server",
    "program",
    "training",
    "glossary",
)
"""Those that users read, in this order."""
SIZE = 980, 640
"""Of the window at first, pixels."""
LIST_WIDTH = 200
"""Of the list of pages at least, pixels."""

_PICTURE = re.compile(r"^!\[[^\]]*\]\([^)]*\)\s*$", re.MULTILINE)
_HEADING = re.compile(r"^#+\s+(.*)$", re.MULTILINE)
_NO_LETTER = re.compile(r"[^\w\- ]")


class ManualDialog(QDialog):
    """Shows the pages with a list of them and a field that searches.

    Attributes
    ----------
    pages, text, field : the list, the page, and what is searched for.
    """

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Manual"))
        self.resize(*SIZE)
        self.pages = named(QListWidget(), tr("Manual pages"))
        self.pages.addItems([title_of(page) for page in PAGES])
        self.pages.setFixedWidth(max(LIST_WIDTH, self.pages.sizeHintForColumn(0) + 2 * self.pages.frameWidth()))
        self.text = named(QTextBrowser(), tr("Page"))
        self.text.setOpenLinks(False)
        self.field = named(QLineEdit(), tr("Search the manual"))
        self.field.setPlaceholderText(tr("Search"))
        self.field.setClearButtonEnabled(True)
        self.pages.currentRowChanged.connect(lambda row: self._show(PAGES[row]))
        self.text.anchorClicked.connect(self._follow)
        self.field.returnPressed.connect(self._search)
        sides = row(self.pages, (self.text, 1))
        column(row(self.field), (sides, 1), dialog_buttons(self, CLOSE), on=self, margins=None)
        self.show_page("manual.md")

    def show_page(self, link: str) -> None:
        """Show a page, from a heading on where the link names one, such as ``manual.md#the-whole-file``."""
        name, _, anchor = link.partition("#")
        page = Path(name).stem
        if page in PAGES:
            self.pages.setCurrentRow(PAGES.index(page))
            self._show(page)
        heading = heading_at(PAGES[self.pages.currentRow()], anchor)
        if heading:
            self._go_to(heading)

    def _show(self, page: str) -> None:
        self.text.setMarkdown(page_text(page))
        self.text.moveCursor(QTextCursor.MoveOperation.Start)

    def _follow(self, link: QUrl) -> None:
        if link.scheme():
            QDesktopServices.openUrl(link)
        elif Path(link.path()).stem in {*PAGES, ""}:
            self.show_page(link.toString())

    def _search(self) -> None:
        """Go to the next place of these words, on this page or one after it."""
        words = self.field.text()
        if not words or self.text.find(words):
            return
        row = self.pages.currentRow()
        for k in range(1, len(PAGES) + 1):
            other = (row + k) % len(PAGES)
            if words.casefold() in _plain(page_text(PAGES[other])).casefold():
                self.pages.setCurrentRow(other)
                self._show(PAGES[other])
                self.text.find(words)
                return

    def _go_to(self, words: str) -> None:
        """Have a heading stand at the upper edge."""
        block: Any = self.text.document().begin()
        while block.isValid():
            if block.blockFormat().headingLevel() and block.text() == words:
                top = self.text.document().documentLayout().blockBoundingRect(block).top()
                self.text.verticalScrollBar().setValue(round(top))
                return
            block = block.next()


class LicencesDialog(QDialog):
    """Shows the parts of the program with their licences, whole."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Licences"))
        self.resize(*SIZE)
        text = named(QTextBrowser(), tr("Licences of all components"))
        text.setMarkdown(licences_text(tr("Licences"), (tr("Component"), tr("Licence"), tr("Includes"))))
        column(text, dialog_buttons(self, CLOSE), on=self, margins=None)


def page_text(page: str) -> str:
    """Return a page as Markdown, without its pictures: they show what the reader has before him."""
    return _text_in(language_in_use(), page)


@cache
def _text_in(language: str, page: str) -> str:
    translated = docs_folder() / language / f"{page}.md"
    file = translated if translated.is_file() else docs_folder() / f"{page}.md"
    return _PICTURE.sub("", file.read_text("utf-8"))


def docs_folder() -> Path:
    """Return the folder of the pages: beside the program where it is installed, else in the checkout."""
    shipped = Path(__file__).resolve().parents[1] / "docs"
    return shipped if shipped.is_dir() else Path(__file__).resolve().parents[2] / "docs"


def title_of(page: str) -> str:
    """Return the first heading of a page."""
    found = _HEADING.search(page_text(page))
    return _plain(found[1]) if found else page


def heading_at(page: str, anchor: str) -> str:
    """Return the heading of a page that an anchor names, in English or as translated; empty for none."""
    shown = _HEADING.findall(page_text(page))
    for headings in (shown, _HEADING.findall(_text_in(WRITTEN_IN, page))):
        slugs = [slug_of(heading) for heading in headings]
        if anchor in slugs:
            return _plain(shown[slugs.index(anchor)])
    return ""


def passage(page: str, term: str) -> str:
    """Return what a page says of a term, as Markdown: the paragraph that begins with it, printed boldly.

    Parameters
    ----------
    term : in English, such as ``Filters``; with ``#`` before it, the first paragraph under that heading.

    Raises
    ------
    KeyError : the page has no such paragraph.
    """
    shown = blocks_of(page_text(page))
    for k, block in enumerate(blocks_of(_text_in(WRITTEN_IN, page))):
        if term.startswith("#") and block.startswith("#") and _plain(block.lstrip("# ")) == term[1:]:
            return shown[k + 1]
        if block.startswith(f"**{term}"):
            return shown[k]
    raise KeyError(f"{page}.md: {term}")


def slug_of(heading: str) -> str:
    """Return the anchor of a heading, as links have it."""
    return _NO_LETTER.sub("", _plain(heading).lower()).strip().replace(" ", "-")


def blocks_of(text: str) -> list[str]:
    """Return paragraphs, headings and list items, each as one line."""
    blocks: list[str] = []
    ended = True
    for line in text.splitlines():
        words = line.strip()
        if not words:
            ended = True
            continue
        starts = ended or line.startswith(("#", "- "))
        if starts:
            blocks.append(words.removeprefix("- "))
        else:
            blocks[-1] += " " + words
        ended = words.startswith("#")
    return blocks


def _plain(markdown: str) -> str:
    return re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", markdown).replace("*", "").replace("`", "").strip()
