"""The page of the head: the head and its text at the left, what it does at the right; and the heads of a window."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QMenu, QScrollArea, QSizePolicy, QSplitter, QToolButton, QWidget

from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.expression.expression_panel import ExpressionPanel, OscPanel
from phonemeanalyser.desktop.talk.head.head_pair import HeadPair
from phonemeanalyser.desktop.talk.head.head_view import HINT, HeadView
from phonemeanalyser.desktop.talk.head.movestate_bars import MovestateBars
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.mouth_table.choices_panel import ChoicesPanel
from phonemeanalyser.desktop.talk.mouth_table.viseme_panel import VisemePanel
from phonemeanalyser.desktop.talk.words.text_panel import TextPanel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.builders import (
    column,
    heading,
    label,
    leave_wheel,
    line,
    open_at_once,
    row,
    scrolling,
    spoken_button,
)
from phonemeanalyser.desktop.widgets.labels import ElidedLabel
from phonemeanalyser.desktop.widgets.phoneme_keys import HeldKeys
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.phonemes import Phoneme

WIDTH, HEIGHT, EDGE = 96, 24, 4


class PhonemeChip(QWidget):
    """Paints the phoneme on its colour, and its intensity as a line below it.

    Attributes
    ----------
    phoneme, intensity : what is shown.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self.phoneme, self.intensity = Phoneme.SILENCE, 0.0
        self.setFixedSize(WIDTH, HEIGHT)
        self.setToolTip(tr("Current phoneme; the line below it is its intensity"))
        self.setAccessibleName(tr("Current phoneme"))

    def refresh(self) -> None:
        """Show what is playing now."""
        session = self._talking.session
        rests = not session.source.playing and (session.source.live or not session.source.position)
        newest = None if rests or session.microphone.silent else session.history.newest
        heard = (Phoneme.SILENCE, 0.0)
        if newest is not None:
            heard = Phoneme(int(newest.phonemes[-1])), round(float(newest.intensities[-1]), 2)
        if heard != (self.phoneme, self.intensity):
            self.phoneme, self.intensity = heard
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint it."""
        painter = QPainter(self)
        colour = QColor(PHONEME_COLOURS[self.phoneme])
        painter.fillRect(self.rect(), QColor(colour.red(), colour.green(), colour.blue(), 50))
        painter.fillRect(0, 0, EDGE, HEIGHT, colour)
        painter.fillRect(EDGE, HEIGHT - 3, round((WIDTH - EDGE) * self.intensity), 3, colour)
        painter.setPen(QColor(self._theme.text))
        box = self.rect().adjusted(EDGE, 0, 0, -2)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, sound_name(self.phoneme))


PANEL_WIDTH = 480
COMPARISONS = {
    None: tr_noop("No Comparison"),
    FaceDriver.RULES: tr_noop("With Phonemes (Rules)"),
    FaceDriver.PINYIN: tr_noop("With Pinyin Letters"),
    FaceDriver.TABLE: tr_noop("With Recorded Faces"),
}
"""What a second head can be moved by."""
BARS_EVERY = 2
"""The bars are drawn at every second picture."""


class TalkPage(QWidget):
    """Lays out head, text, mouth shapes, bars and choices.

    Signals
    -------
    sound_asked, preset_asked : the user wants the head to say another sound, or to load phoneme data.
    words_asked, speech_asked : the user wants to save what is said, or to have the text said into a file.

    Attributes
    ----------
    keys : to be installed as an event filter of the window.
    """

    sound_asked = Signal()
    preset_asked = Signal()
    words_asked = Signal()
    speech_asked = Signal()
    picture_asked = Signal(QWidget, str)

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self._ticks = 0
        self.heads = HeadPair(talking, theme)
        self.head = self.heads.main.view
        self.choices = ChoicesPanel(talking, theme)
        self.visemes = VisemePanel(talking, theme)
        self.expression = ExpressionPanel(talking, theme)
        self.bars = MovestateBars(talking, theme)
        for view in (self.heads.main.view, self.heads.beside.view, self.bars):
            view.menu.save_asked.connect(self.picture_asked)
        self.osc = OscPanel(talking.osc, theme)
        self.text = TextPanel(talking, theme)
        self.keys = HeldKeys(talking, self)
        self.open = spoken_button(tr("Open Audio File…"), tr("Open an audio file and play it at once"))
        self.play = spoken_button(tr("Play"), tr("Play or pause (Space)"))
        self.stop = spoken_button(tr("Stop"), tr("Stop (Escape)"))
        self.preset = spoken_button(tr("Load Preset…"), tr("Load a preset or PhonemeData file (Ctrl+Shift+O)"))
        self.save = spoken_button(tr("Save ▾"), tr("Save words and phones, or the spoken text"))
        self.compare = spoken_button(tr("Compare ▾"), tr("Show a second head in sync, moved by another driver"))
        self.said = ElidedLabel()
        self.heard = PhonemeChip(talking, theme)
        self._fill_save_menu()
        self._fill_compare_menu()
        self._lay_out()
        self._connect()
        self._show_state()

    def refresh(self) -> None:
        """Show what changes by itself."""
        self.heads.refresh()
        self.text.refresh()
        self._ticks += 1
        if self._ticks % BARS_EVERY == 0:
            self.bars.refresh()
            self.expression.refresh()
            self.heard.refresh()
            self.osc.refresh()

    def _fill_save_menu(self) -> None:
        menu = QMenu(self)
        menu.setToolTipsVisible(True)
        self.save_words = menu.addAction(tr("Words and Phones…"), self.words_asked.emit)
        self.save_words.setToolTip(
            tr("Save the words and phones of the audio file as a TextGrid, which Export can use")
        )
        self.save_speech = menu.addAction(tr("Spoken Text as Audio File…"), self.speech_asked.emit)
        self.save_speech.setToolTip(
            tr("Save the spoken text as WAV, with its words and phones in a TextGrid beside it")
        )
        _without_arrow(self.save, menu)

    def _fill_compare_menu(self) -> None:
        menu = QMenu(self)
        self.comparisons = QActionGroup(menu)
        for driver, words in COMPARISONS.items():
            action = self.comparisons.addAction(tr(words))
            action.setCheckable(True)
            action.setData(driver)
            menu.addAction(action)
        self.comparisons.triggered.connect(self._choose_comparison)
        _without_arrow(self.compare, menu)

    def _choose_comparison(self, action: QAction) -> None:
        driver = action.data()
        self._talking.text.drivers.compare(None if driver is None else FaceDriver(driver))

    def _connect(self) -> None:
        session = self._talking.session
        self.open.clicked.connect(lambda _checked: self.sound_asked.emit())
        self.preset.clicked.connect(lambda _checked: self.preset_asked.emit())
        self.play.clicked.connect(lambda _checked: session.toggle())
        self.stop.clicked.connect(lambda _checked: session.stop())
        self._talking.text.changed.connect(self._show_state)
        session.transport_changed.connect(self._show_state)
        session.opened.connect(self._show_state)

    def _show_state(self) -> None:
        session = self._talking.session
        self.play.setText(tr("Pause") if session.source.playing else tr("Play"))
        texts = self._talking.text
        compared = texts.drivers.compared
        for action in self.comparisons.actions():
            action.setChecked(action.data() == compared)
            by_table = action.data() == FaceDriver.TABLE
            action.setEnabled(not by_table or texts.drivers.performance.table is not None)
        self.save_words.setEnabled(texts.editable and texts.utterance is not None)
        self.save_speech.setEnabled(bool(texts.text.strip()))
        self.said.setText(session.source.name)
        self.said.setToolTip(f"{session.source.name}: {tr_engine(session.source.description)}")

    def _lay_out(self) -> None:
        below = column(
            row(self.open, self.play, self.stop, self.preset, self.save, 1, spacing=6),
            row(self.heard, (self.said, 1), self.compare, *self.heads.looks, spacing=6),
            self.text,
            margins=(8, 5, 8, 5),
            spacing=4,
        )
        left = QWidget()
        column((self.heads, 1), below, on=left, spacing=0)
        split = QSplitter(Qt.Orientation.Horizontal)
        split.addWidget(left)
        split.addWidget(self._panel())
        split.setStretchFactor(0, 1)
        split.setStretchFactor(1, 0)
        split.setSizes([10_000, PANEL_WIDTH])
        split.setChildrenCollapsible(False)
        row(split, on=self)

    def _panel(self) -> QWidget:
        def part(*widgets: QWidget) -> tuple[QWidget, ...]:
            return (line(self._theme.line), *widgets)

        body = QWidget()
        column(
            self.choices,
            *part(self.visemes),
            *part(self.expression),
            *part(heading(tr("Blend shapes")), self.bars),
            *part(heading(tr("Network")), self.osc),
            1,
            label(f"{tr(HINT)}.", self._theme.faint, wraps=True),
            on=body,
            margins=(10, 8, 10, 8),
            spacing=8,
        )
        leave_wheel(body)
        scroll = QScrollArea()
        scroll.setMinimumWidth(scrolling(scroll, body))
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scroll.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
        return scroll


def _without_arrow(button: QToolButton, menu: QMenu) -> None:
    """Have a button open a menu; the arrow of the style would lie on its text."""
    open_at_once(button, menu)
    button.setStyleSheet("QToolButton::menu-indicator { image: none }")


class Heads:
    """Moves the heads that are seen."""

    def __init__(self, talking: TalkModel) -> None:
        self._talking = talking
        self._heads: dict[str, HeadView] = {}
        self._views: list[HeadView | TalkPage] = []

    def add(self, name: str, head: HeadView, page: TalkPage | None = None) -> HeadView:
        """Move this one too, with all of its page; it is called so in every window."""
        self._heads[name] = head
        self._views.append(page or head)
        return head

    def move(self, *, frozen: bool) -> None:
        """Have the head say what is playing, where it is seen."""
        seen = [view for view in self._views if view.isVisible()]
        self._talking.watch(bool(seen) and not frozen)
        self._talking.tick()
        for view in seen:
            if not frozen:
                view.refresh()

    def copy_view_from(self, other: "Heads") -> None:
        """Show the heads from where another window shows them."""
        for name, head in self._heads.items():
            if name in other._heads:
                head.copy_view_from(other._heads[name])

    def release_gl(self) -> None:
        """Give everything back to the graphics driver."""
        for head in self._heads.values():
            head.release_gl()
