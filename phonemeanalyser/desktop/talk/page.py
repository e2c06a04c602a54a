"""The page of the head: the head and its text at the left, and what it does at the right."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QCheckBox, QMenu, QScrollArea, QSizePolicy, QSplitter, QToolButton, QWidget

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.expression.expression_panel import ExpressionPanel
from phonemeanalyser.desktop.talk.expression.osc_panel import OscPanel
from phonemeanalyser.desktop.talk.head.head_pair import HeadPair
from phonemeanalyser.desktop.talk.head.head_view import HINT, LIGHT_STEP
from phonemeanalyser.desktop.talk.head.movestate_bars import MovestateBars
from phonemeanalyser.desktop.talk.head.phoneme_chip import PhonemeChip
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.mouth_table.choices_panel import ChoicesPanel
from phonemeanalyser.desktop.talk.mouth_table.viseme_panel import VisemePanel
from phonemeanalyser.desktop.talk.words.text_panel import TextPanel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import (
    column,
    heading,
    label,
    line,
    named,
    open_at_once,
    row,
    scrolling,
    spoken_button,
)
from phonemeanalyser.desktop.widgets.elided_label import ElidedLabel
from phonemeanalyser.desktop.widgets.phoneme_keys import HeldKeys
from phonemeanalyser.desktop.widgets.wheel import leave_wheel
from phonemeengine.mouth.face_driver import FaceDriver

PANEL_WIDTH = 480
COMPARISONS = {
    None: tr_noop("One Head"),
    FaceDriver.RULES: tr_noop("With Sounds, by the Mouth Table"),
    FaceDriver.PINYIN: tr_noop("With Letters of Pinyin"),
    FaceDriver.TABLE: tr_noop("With a Table of Recorded Faces"),
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
        self.open = spoken_button(tr("Open Sound…"), tr("Open a sound file, and have the head say it at once"))
        self.play = spoken_button(tr("Play"), tr("Play or pause (Space)"))
        self.stop = spoken_button(tr("Stop"), tr("Stop (Escape)"))
        self.preset = spoken_button(tr("Load Preset…"), tr("Load a preset or PhonemeData file (Ctrl+Shift+O)"))
        self.save = spoken_button(tr("Save ▾"), tr("Save words and phones, or the text as a voice says it"))
        self.wireframe = named(QCheckBox(tr("wireframe")), tip=tr("Draw the edges of the mesh alone (W)"))
        self.compare = spoken_button(tr("Compare ▾"), tr("Show a second head in step, which other means move"))
        self.home = spoken_button("⌂", tr("Look at the whole head from the front (Home, or a double click)"))
        self.light_left = spoken_button("☀ ◂", tr("Move the light to the left (,)"))
        self.light_right = spoken_button("▸", tr("Move the light to the right (.)"))
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
        self.save_words.setToolTip(tr("Of the sound file in hand, as a TextGrid, which exports take"))
        self.save_speech = menu.addAction(tr("Spoken Text as Sound…"), self.speech_asked.emit)
        self.save_speech.setToolTip(tr("As WAV, with words and phones as a TextGrid beside it"))
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
        self.home.clicked.connect(lambda _checked: self.head.go_home())
        self.wireframe.toggled.connect(lambda on: self.head.look(wireframe=on))
        self.light_left.clicked.connect(lambda _checked: self.head.move_light(-LIGHT_STEP))
        self.light_right.clicked.connect(lambda _checked: self.head.move_light(LIGHT_STEP))
        self.head.looked.connect(lambda: self.wireframe.setChecked(self.head.wireframe))
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
        looks = (self.compare, self.wireframe, self.light_left, self.light_right, self.home)
        below = column(
            row(self.open, self.play, self.stop, self.preset, self.save, 1, spacing=6),
            row(self.heard, (self.said, 1), *looks, spacing=6),
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
            *part(heading(tr("Movestates")), self.bars),
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
