"""What the menu Help opens: the manual, *What Is This?*, which tells it of anything clicked, and the list of keys.

A page is in the language of the window where there is a translation, such as ``docs/de/manual.md``, else in English.
A translation has the headings and paragraphs of the English page in the same order: links and *What Is This?* name
the English ones.
"""

import re
from functools import cache
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any

from PySide6 import QtWidgets
from PySide6.QtCore import QEvent, QObject, Qt, QUrl, Signal
from PySide6.QtGui import QDesktopServices, QHelpEvent, QTextCursor, QTextDocument, QWhatsThisClickedEvent
from typing_extensions import override

from phonemeanalyser.desktop.language import WRITTEN_IN, language_in_use, tr, tr_noop
from phonemeanalyser.desktop.widgets.builders import CLOSE, ScrolledDown, column, dialog_buttons, label, named, row
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


class ManualDialog(QtWidgets.QDialog):
    """Shows the pages with a list of them and a field that searches.

    Attributes
    ----------
    pages, text, field : the list, the page, and what is searched for.
    """

    def __init__(self, parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Manual"))
        self.resize(*SIZE)
        self.pages = named(QtWidgets.QListWidget(), tr("Manual pages"))
        self.pages.addItems([title_of(page) for page in PAGES])
        self.pages.setFixedWidth(max(LIST_WIDTH, self.pages.sizeHintForColumn(0) + 2 * self.pages.frameWidth()))
        self.text = named(QtWidgets.QTextBrowser(), tr("Page"))
        self.text.setOpenLinks(False)
        self.field = named(QtWidgets.QLineEdit(), tr("Search the manual"))
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


class LicencesDialog(QtWidgets.QDialog):
    """Shows the parts of the program with their licences, whole."""

    def __init__(self, parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Licences"))
        self.resize(*SIZE)
        text = named(QtWidgets.QTextBrowser(), tr("Licences of all components"))
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


PASSAGES = {
    "Transport": ("manual", "Playback"),
    "PositionSlider": ("manual", "#The whole file"),
    "OutputButton": ("manual", "Playback"),
    "StateChips": ("manual", "Chips"),
    "MicrophoneBar": ("manual", "Device, channel, rate and level"),
    "RecordButton": ("manual", "Record"),
    "ToneBar": ("manual", "Tone"),
    "PresetBox": ("manual", "Presets"),
    "FilterColumn": ("manual", "Filters"),
    "LookAheadSlider": ("manual", "Look-ahead"),
    "AveragedView": ("manual", "Averaged spectra"),
    "CurvePanel": ("manual", "Averaged spectra"),
    "SpectrumView": ("manual", "Spectrum"),
    "WaveformView": ("manual", "Spectrum"),
    "ScrollView": ("manual", "Spectrum"),
    "FilePanel": ("manual", "#The whole file"),
    "PhonemeView": ("manual", "Phoneme"),
    "ScoreStrip": ("calibrating", "#The score on Analyse"),
    "RecogniserChoice": ("manual", "Phoneme"),
    "VariablePanel": ("manual", "Variable"),
    "ThresholdView": ("manual", "Thresholds"),
    "RuleEditor": ("manual", "Rules"),
    "DockTabs": ("manual", "Pages"),
    "PhonemeDataPanel": ("calibrating", "#The 21 numbers of PhonemeData"),
    "RulesPanel": ("calibrating", "#Rules found in labelled sound"),
    "PageSwitch": ("manual", "Pages"),
    "QStatusBar": ("manual", "The status line"),
    "GuideView": ("calibrating", "Guided calibration"),
    "TakesPanel": ("calibrating", "Takes"),
    "VariablesPanel": ("calibrating", "Distributions"),
    "DistributionView": ("calibrating", "Distributions"),
    "ConfusionView": ("calibrating", "Confusion matrix"),
    "SegmentList": ("calibrating", "Confusion matrix"),
    "FitPanel": ("calibrating", "Fit"),
    "ComparePanel": ("calibrating", "Compare"),
    "WorkbenchView": ("calibrating", "Recordings"),
    "HeadView": ("manual", "The head"),
    "VisemePanel": ("manual", "Mouth shapes"),
    "MovestateBars": ("manual", "Mouth shapes"),
    "ChoicesPanel": ("manual", "Mouth table"),
    "TransitionTimesView": ("manual", "Mouth table"),
    "ExpressionPanel": ("manual", "Expression"),
    "OscPanel": ("manual", "Other programs"),
    "SpeechTimeline": ("manual", "The timeline"),
    "KeyLanes": ("manual", "Keys"),
    "VoicePanel": ("manual", "Voice & Face…"),
    "VoiceButton": ("manual", "Voice & Face…"),
    "TextPanel": ("manual", "Align"),
    "TalkPage": ("manual", "The head"),
}
"""Page and term of the manual for what lies in a widget, by the name of its class or its own; the innermost wins."""


class WhatIsThis(QObject):
    """Answers for all widgets of a window.

    Signals
    -------
    page_asked : the user wants to read on, on this page of the manual.
    """

    page_asked = Signal(str)

    def __init__(self, window: QtWidgets.QWidget) -> None:
        super().__init__(window)
        self._window = window

    def begin(self) -> None:
        """Have the next click ask."""
        app = QtWidgets.QApplication.instance()
        assert app is not None
        app.installEventFilter(self)  # not before: each event of the program goes through it
        QtWidgets.QWhatsThis.enterWhatsThisMode()

    @override
    def eventFilter(self, asked: QObject, event: QEvent) -> bool:
        """Answer what Qt asks while the pointer has a question mark."""
        kinds = QEvent.Type
        if event.type() not in {kinds.QueryWhatsThis, kinds.WhatsThis, kinds.WhatsThisClicked}:
            return False
        if not isinstance(asked, QtWidgets.QWidget) or asked.window() is not self._window:
            return False
        if event.type() == kinds.QueryWhatsThis:
            event.setAccepted(bool(explanation_of(asked)))
        elif isinstance(event, QWhatsThisClickedEvent):
            self.page_asked.emit(event.href())
        elif isinstance(event, QHelpEvent):
            QtWidgets.QWhatsThis.showText(event.globalPos(), explanation_of(asked), asked)
        return True


def explanation_of(widget: QtWidgets.QWidget) -> str:
    """Return what a widget is, as HTML: its name, its tool tip, and what the manual says; empty for nothing."""
    found = passage_for(widget)
    name, tip = name_of(widget), _tip_of(widget)
    if found is None and not tip:
        return ""
    parts = [f"<b>{name}</b>"] if name else []
    parts += [f"<p>{tip}</p>"] if tip and tip != name else []
    if found is not None:
        document = QTextDocument()
        document.setMarkdown(passage(*found))
        words = document.toHtml()
        parts.append(words[words.index("<body") :].removesuffix("</body></html>"))
        parts.append(f'<p><a href="{found[0]}.md">{tr("More in the manual")}</a></p>')
    return "".join(parts)


def passage_for(widget: QtWidgets.QWidget) -> tuple[str, str] | None:
    """Return page and term of the manual for a widget: those of the innermost part of the window that has any."""
    asked: QtWidgets.QWidget | None = widget
    while asked is not None:
        for name in (asked.objectName(), *(kind.__name__ for kind in type(asked).__mro__)):
            if name in PASSAGES:
                return PASSAGES[name]
        asked = asked.parentWidget()
    return None


def name_of(widget: QtWidgets.QWidget) -> str:
    """Return what a widget is called: its accessible name, or what is written on it."""
    if widget.accessibleName():
        return widget.accessibleName()
    return widget.text() if isinstance(widget, QtWidgets.QAbstractButton | QtWidgets.QLabel) else ""


def _tip_of(widget: QtWidgets.QWidget) -> str:
    """Return the tool tip of a widget, or of what it lies in."""
    asked: QtWidgets.QWidget | None = widget
    while asked is not None and not asked.isWindow():
        if asked.toolTip():
            return asked.toolTip()
        asked = asked.parentWidget()
    return ""


HEAD = [
    (tr_noop("Orbit; with Shift, pan"), tr_noop("Arrows")),
    (tr_noop("Zoom in, zoom out"), "+, −"),
    (tr_noop("Fit to view"), tr_noop("Home")),
    (tr_noop("Wireframe"), "W"),
    (tr_noop("Move light"), tr_noop("Comma, full stop")),
    (tr_noop("Hold mouth shape"), "Q S H M P I A E U O"),
]
KEYS = [
    (tr_noop("Raise, lower key; with Shift, farther"), tr_noop("Up, Down")),
    (tr_noop("Move key by one picture"), tr_noop("Left, Right")),
    (tr_noop("Mark range"), tr_noop("Shift+Left, Shift+Right")),
    (tr_noop("Smooth, raise or lower range"), tr_noop("Menu key")),
    (tr_noop("Previous, next key; with Ctrl, curve"), tr_noop("Page Up, Page Down")),
    (tr_noop("Delete key"), tr_noop("Del")),
]
CALIBRATE = [
    (tr_noop("Guided calibration"), "G"),
    (tr_noop("Record take while held"), "Q S H M P I A E U O"),
    (tr_noop("Set start, end of the range"), "[, ]"),
    (tr_noop("Play take"), tr_noop("Return")),
    (tr_noop("Exclude or include take"), "X"),
    (tr_noop("Delete take"), tr_noop("Del")),
]
GUIDE = [
    (tr_noop("Start"), tr_noop("Return")),
    (tr_noop("Repeat previous sound"), tr_noop("Backspace")),
    (tr_noop("Repeat this sound"), "R"),
    (tr_noop("Skip"), tr_noop("Right")),
    (tr_noop("Use New Preset"), tr_noop("Return")),
    (tr_noop("End guided calibration"), tr_noop("Esc")),
]
N_COLUMNS = (3, 2)
"""Of the list, and of one that would be wider than the screen."""
HIGHEST, EDGES = 640, 60
"""Pixels; what does not fit into a small window is scrolled. Those that frame, margins and scroll bar take."""


class ShortcutsDialog(QtWidgets.QDialog):
    """Lists the keys by menu.

    Parameters
    ----------
    menus : for each menu, the entries' texts and keys.
    """

    def __init__(self, menus: dict[str, list[tuple[str, str]]], parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Keyboard Shortcuts"))
        blocks = [_block(title, [(text, key) for text, key in entries if key]) for title, entries in menus.items()]
        blocks.append(_block(tr("Sliders and timeline"), [(tr("One step; with Shift, a tenth"), tr("Left, Right"))]))
        blocks.append(_block(tr("Custom variable"), [(tr("Discard the marked range"), tr("Esc"))]))
        blocks.append(_block(tr("Calibrate page"), CALIBRATE))
        blocks.append(_block(tr("Guided calibration"), GUIDE))
        blocks.append(_block(tr("Head, while it has the focus"), HEAD))
        blocks.append(_block(tr("Keys of blend shapes, while they have the focus"), KEYS))
        room = self.screen().availableSize().width() - EDGES
        for n_columns in N_COLUMNS:
            self.list = QtWidgets.QLabel(_side_by_side([block for block in blocks if block], n_columns))
            if self.list.sizeHint().width() <= room:
                break
        scope = label(
            tr(
                "Menu shortcuts that are single letters, Delete, F2 or use Shift work on the Analyse page only. "
                "While a list, number or text field has the focus, letters go to that field: click a plot to "
                "leave it."
            ),
            wraps=True,
        )
        scroll = ScrolledDown()
        scroll.show_body(self.list)
        rows = column((scroll, 1), scope, dialog_buttons(self, CLOSE), on=self, margins=None)
        width = self.sizeHint().width()
        height = rows.totalHeightForWidth(width) - scroll.sizeHint().height() + self.list.sizeHint().height()
        self.resize(width, min(height, HIGHEST))


def _block(title: str, keys: list[tuple[str, str]]) -> list[str]:
    """Return the rows of a menu; none where it has no key."""
    rows = [f"<tr><td>{tr(text)}&nbsp;&nbsp;&nbsp;</td><td>{tr(key)}</td></tr>" for text, key in keys]
    return [f"<tr><td colspan=2><br><b>{title}</b></td></tr>", *rows] if rows else []


def _side_by_side(blocks: list[list[str]], n_columns: int) -> str:
    """Lay blocks of rows out in columns, the highest of which is as low as it can be."""
    ways = [(0, *cuts, len(blocks)) for cuts in combinations(range(1, len(blocks)), n_columns - 1)]
    parts = [[blocks[start:end] for start, end in pairwise(cuts)] for cuts in ways]
    best = min(parts, key=lambda part: max(sum(map(len, column)) + len(column) for column in part))
    columns = [[row for block in part for row in block] for part in best]
    cells = "<td width=24></td>".join(
        f"<td><table cellspacing=0>{''.join(column)}</table></td>" for column in columns
    )
    return f"<table><tr>{cells}</tr></table>"
