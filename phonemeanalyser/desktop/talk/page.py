"""The page of the head: the head and its text at the left, and what it does at the right."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import (
    QCheckBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QMenu,
    QScrollArea,
    QSizePolicy,
    QSplitter,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.choices_panel import ChoicesPanel
from phonemeanalyser.desktop.talk.expression_panel import ExpressionPanel
from phonemeanalyser.desktop.talk.head_pair import HeadPair
from phonemeanalyser.desktop.talk.head_view import HINT, LIGHT_STEP
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.movestate_bars import MovestateBars
from phonemeanalyser.desktop.talk.osc_panel import OscPanel
from phonemeanalyser.desktop.talk.phoneme_chip import PhonemeChip
from phonemeanalyser.desktop.talk.text_panel import TextPanel
from phonemeanalyser.desktop.talk.viseme_panel import VisemePanel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.elided_label import ElidedLabel
from phonemeanalyser.desktop.widgets.heading import heading
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
        self.open = _button(tr("Open Sound…"), tr("Open a sound file, and have the head say it at once"))
        self.play = _button(tr("Play"), tr("Play or pause (Space)"))
        self.stop = _button(tr("Stop"), tr("Stop (Escape)"))
        self.preset = _button(tr("Load Preset…"), tr("Load a preset or PhonemeData file (Ctrl+Shift+O)"))
        self.save = _button(tr("Save ▾"), tr("Save words and phones, or the text as a voice says it"))
        self.wireframe = QCheckBox(tr("wireframe"))
        self.wireframe.setToolTip(tr("Draw the edges of the mesh alone (W)"))
        self.compare = _button(tr("Compare ▾"), tr("Show a second head in step, which other means move"))
        self.home = _button("⌂", tr("Look at the whole head from the front (Home, or a double click)"))
        self.light_left = _button("☀ ◂", tr("Move the light to the left (,)"))
        self.light_right = _button("▸", tr("Move the light to the right (.)"))
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
        self.save.setMenu(menu)
        self.save.setStyleSheet("QToolButton::menu-indicator { image: none }")  # it would lie on the text
        self.save.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)

    def _fill_compare_menu(self) -> None:
        menu = QMenu(self)
        self.comparisons = QActionGroup(menu)
        for driver, words in COMPARISONS.items():
            action = self.comparisons.addAction(tr(words))
            action.setCheckable(True)
            action.setData(driver)
            menu.addAction(action)
        self.comparisons.triggered.connect(self._choose_comparison)
        self.compare.setMenu(menu)
        self.compare.setStyleSheet("QToolButton::menu-indicator { image: none }")
        self.compare.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)

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
        self.play.setText(tr("Pause") if session.playing else tr("Play"))
        texts = self._talking.text
        compared = texts.drivers.compared
        for action in self.comparisons.actions():
            action.setChecked(action.data() == compared)
            by_table = action.data() == FaceDriver.TABLE
            action.setEnabled(not by_table or texts.drivers.performance.table is not None)
        self.save_words.setEnabled(texts.editable and texts.utterance is not None)
        self.save_speech.setEnabled(bool(texts.text.strip()))
        self.said.setText(session.name)
        self.said.setToolTip(f"{session.name}: {tr_engine(session.description)}")

    def _lay_out(self) -> None:
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.heads, 1)
        column.addLayout(self._rows_below())
        split = QSplitter(Qt.Orientation.Horizontal)
        split.addWidget(left)
        split.addWidget(self._panel())
        split.setStretchFactor(0, 1)
        split.setStretchFactor(1, 0)
        split.setSizes([10_000, PANEL_WIDTH])
        split.setChildrenCollapsible(False)
        whole = QHBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(split)

    def _rows_below(self) -> QVBoxLayout:
        rows = QVBoxLayout()
        rows.setContentsMargins(8, 5, 8, 5)
        rows.setSpacing(4)
        looks = (self.compare, self.wireframe, self.light_left, self.light_right, self.home)
        for widgets in ((self.open, self.play, self.stop, self.preset, self.save), (self.heard, self.said, *looks)):
            row = QHBoxLayout()
            row.setSpacing(6)
            for widget in widgets:
                row.addWidget(widget, 1 if widget is self.said else 0)
            if self.said not in widgets:
                row.addStretch(1)
            rows.addLayout(row)
        rows.addWidget(self.text)
        return rows

    def _panel(self) -> QWidget:
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(10, 8, 10, 8)
        column.setSpacing(8)
        parts: tuple[tuple[QWidget, ...], ...] = (
            (self.choices,), (self.visemes,), (self.expression,), (heading(tr("Movestates")), self.bars),
            (heading(tr("Network")), self.osc),
        )  # fmt: skip
        for k, part in enumerate(parts):
            if k:
                column.addWidget(_line(self._theme))
            for widget in part:
                column.addWidget(widget)
        column.addStretch(1)
        hint = QLabel(f"{tr(HINT)}.")
        hint.setWordWrap(True)
        hint.setStyleSheet(f"color: {self._theme.faint}")
        column.addWidget(hint)
        leave_wheel(body)
        scroll = QScrollArea()
        scroll.setWidget(body)
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setMinimumWidth(body.minimumSizeHint().width() + scroll.verticalScrollBar().sizeHint().width())
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scroll.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
        return scroll


def _line(theme: Theme) -> QFrame:
    line = QFrame()
    line.setFixedHeight(1)
    line.setStyleSheet(f"background: {theme.line}")
    return line


def _button(text: str, tip: str) -> QToolButton:
    button = QToolButton()
    button.setText(text)
    button.setToolTip(tip)
    button.setAccessibleName(tip)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button
