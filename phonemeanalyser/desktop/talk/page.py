"""The page of the head: head, script and timeline at the left, tabs at the right; and the heads of a window."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSplitter, QTabWidget, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.drivers.comparison import ComparisonMenu, DifferenceBar
from phonemeanalyser.desktop.talk.expression.expression_panel import ExpressionPanel, OscPanel
from phonemeanalyser.desktop.talk.expression.style_panel import StylePanel
from phonemeanalyser.desktop.talk.head.head_view import HINT, HeadPair, HeadView
from phonemeanalyser.desktop.talk.head.movestate_bars import MovestateBars
from phonemeanalyser.desktop.talk.keys.key_panel import KeyPanel
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.mouth_table import ChoicesPanel, VisemePanel
from phonemeanalyser.desktop.talk.pictures import PICTURE_RATES
from phonemeanalyser.desktop.talk.tour import Stop, Tour
from phonemeanalyser.desktop.talk.words.text_panel import TextPanel
from phonemeanalyser.desktop.talk.words.time_line import LanesPanel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme, format_clock
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.keyboard import HeldKeys
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
        latest = (Phoneme.SILENCE, 0.0)
        if newest is not None:
            latest = Phoneme(int(newest.phonemes[-1])), round(float(newest.intensities[-1]), 2)
        if latest != (self.phoneme, self.intensity):
            self.phoneme, self.intensity = latest
            self.update()

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        colour = QColor(PHONEME_COLOURS[self.phoneme])
        painter.fillRect(self.rect(), QColor(colour.red(), colour.green(), colour.blue(), 50))
        painter.fillRect(0, 0, EDGE, HEIGHT, colour)
        painter.fillRect(EDGE, HEIGHT - 3, round((WIDTH - EDGE) * self.intensity), 3, colour)
        painter.setPen(QColor(self._theme.text))
        box = self.rect().adjusted(EDGE, 0, 0, -2)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, sound_name(self.phoneme))


PANEL_WIDTH = 400
"""Of the tabs at first, pixels."""
HEIGHTS = (10_000, 130, 190, 210)
"""Of head, script, timeline and keys at first: the head takes what the others leave, pixels."""
BARS_EVERY = 2
"""The bars are drawn at every second picture."""


class PictureCounter(QWidget):
    """Says at which time and in which picture of the animation the sound is, and how many of these a second has.

    Attributes
    ----------
    rate : the choice of the pictures of a second.
    place : the time, and the number of the picture, from 0.
    """

    def __init__(self, talking: TalkModel) -> None:
        super().__init__()
        self._talking = talking
        self.place = builders.label()
        self.place.setToolTip(tr("Time, and number of the picture, counted from 0"))
        self.rate = builders.choice(
            ((tr("{rate}/s").format(rate=rate), rate) for rate in PICTURE_RATES),
            tr("Pictures per Second"),
            tr("Pictures per second of the animation; Left and Right in the timeline go one picture back or forward"),
        )
        builders.row(self.place, self.rate, on=self, spacing=6)
        self.place.setMinimumWidth(self.place.fontMetrics().horizontalAdvance(self._words(3599.999, 215_999)))
        self.rate.activated.connect(lambda k: talking.pictures.set_rate(self.rate.itemData(k)))
        talking.changed.connect(self._show_rate)
        self._show_rate()

    def refresh(self) -> None:
        """Show where the sound is."""
        words = self._words(self._talking.session.source.position, self._talking.pictures.number)
        if words != self.place.text():
            self.place.setText(words)

    def _words(self, seconds: float, picture: int) -> str:
        clock = f"{format_clock(seconds - seconds % 60, False)[:-2]}{int(seconds % 60 * 1000 + 1e-6) / 1000:06.3f}"
        return tr("{clock} · picture {picture}").format(clock=clock, picture=picture)

    def _show_rate(self) -> None:
        self.rate.setCurrentIndex(self.rate.findData(self._talking.pictures.rate))
        self.refresh()


class TalkPage(QWidget):
    """Lays out head, script and timeline at the left, and at the right what the face is, does, sends and shows.

    Signals
    -------
    words_asked, speech_asked : the user wants to save what is said, or to have the text said into a file.
    export_asked : the user wants to export animation.
    picture_asked : the user wants to save a picture of a view, of this name.

    Attributes
    ----------
    keys : to be installed as an event filter of the window.
    differences : says where two heads differ.
    tabs : what stands at the right.
    tour : leads through the page.
    split, stack : the splitters between both sides, and between what is one above the other at the left.
    """

    words_asked = Signal()
    speech_asked = Signal()
    export_asked = Signal()
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
        self.style_panel = StylePanel(talking.styles, theme)
        self.bars = MovestateBars(talking, theme)
        self.osc = OscPanel(talking.osc, theme)
        self.text = TextPanel(talking, theme)
        self.lanes, self.key_panel = LanesPanel(talking, theme), KeyPanel(talking, theme)
        self.keys = HeldKeys(talking, self)
        for view in (self.heads.main.view, self.heads.beside.view, self.bars, self.lanes.line):
            view.menu.save_asked.connect(self.picture_asked)
        self.save_words = builders.spoken_button(
            tr("Save Words and Phones…"),
            tr("Save the words and phones of the audio file as a TextGrid, which Export can use"),
        )
        self.save_speech = builders.spoken_button(
            tr("Save Spoken Text…"),
            tr("Save the spoken text as WAV, with its words and phones in a TextGrid beside it"),
        )
        self.export = builders.spoken_button(
            tr("Export…"), tr("Export the animation for other programs, as the head shows it (Ctrl+Shift+E)")
        )
        self.show_keys = builders.spoken_button(
            tr("Keys"), tr("Show the curves of blend shapes, whose keys can be edited"), self._toggle_keys
        )
        self.show_keys.setCheckable(True)
        self.compare = builders.spoken_button(
            tr("Compare ▾"), tr("Show a second head in sync, moved by another driver or preset")
        )
        self.comparisons = ComparisonMenu(talking.text.drivers, talking.comparison, self)
        self.differences = DifferenceBar(talking)
        builders.open_without_arrow(self.compare, self.comparisons)
        self.chip = PhonemeChip(talking, theme)
        self.pictures = PictureCounter(talking)
        self.tabs = QTabWidget()
        self.split, self.stack = QSplitter(Qt.Orientation.Horizontal), QSplitter(Qt.Orientation.Vertical)
        self._lay_out()
        self.tour = Tour(self, self._stops(), theme)
        self._connect()
        self._show_state()

    def _stops(self) -> tuple[Stop, ...]:
        """Return what the tour points at, in the order of the work."""
        face, output = self.tabs.widget(0), self.tabs.widget(2)
        return (
            Stop(self.text.field, tr("Paste the text of the recording here. Ctrl+O opens another recording.")),
            Stop(
                self.text.language, tr("The language is guessed from the text. If it is wrong, type the right one.")
            ),
            Stop(
                self.text.act,
                tr("Align finds each word in the recording. Without a recording, a voice says the text."),
            ),
            Stop(
                self.lanes,
                tr(
                    "Click a word to play it, and drag boundaries that are wrong. Words that fit badly are hatched "
                    "and listed."
                ),
            ),
            Stop(self.choices, tr("Choose a face, or load one of your own."), face),
            Stop(self.show_keys, tr("Edit the curves of single blend shapes by their keys.")),
            Stop(self.export, tr("Export the animation for Blender, Unreal, Unity or Moho, or as a clip."), output),
        )

    @property
    def splitters(self) -> dict[str, QSplitter]:
        """What the user may have moved, by the names under which it is kept."""
        return {"talk/split": self.split, "talk/stack": self.stack}

    def refresh(self) -> None:
        """Show what changes by itself."""
        self.heads.refresh()
        self.lanes.refresh()
        self.key_panel.refresh()
        self.text.refresh()
        self._ticks += 1
        if self._ticks % BARS_EVERY == 0:
            for part in (self.bars, self.expression, self.chip, self.osc, self.pictures):
                part.refresh()

    def _connect(self) -> None:
        session = self._talking.session
        self.save_words.clicked.connect(lambda _checked: self.words_asked.emit())
        self.save_speech.clicked.connect(lambda _checked: self.speech_asked.emit())
        self.export.clicked.connect(lambda _checked: self.export_asked.emit())
        self._talking.keys.opened.connect(self._show_keys)
        for signal in (self._talking.text.changed, self._talking.text.text_changed):
            signal.connect(self._show_state)
        session.opened.connect(self._show_state)
        self._show_keys()

    def _toggle_keys(self) -> None:
        self._talking.keys.set_open(self.show_keys.isChecked())

    def _show_keys(self) -> None:
        is_open = self._talking.keys.open
        self.show_keys.setChecked(is_open)
        self.key_panel.setVisible(is_open)

    def _show_state(self) -> None:
        texts = self._talking.text
        self.save_words.setEnabled(texts.editable and texts.utterance is not None)
        self.save_speech.setEnabled(bool(texts.text.strip()))

    def _lay_out(self) -> None:
        where, looks = (
            builders.row(self.chip, self.pictures, self.show_keys, 1, spacing=6),
            builders.row(1, self.compare, *self.heads.looks, spacing=6),
        )
        bar = builders.Wrapping(where, looks, (8, 4, 8, 4))
        above = QWidget()
        builders.column((self.heads, 1), self.differences, bar, on=above, spacing=0)
        for part in (above, self.text, self.lanes, self.key_panel):
            self.stack.addWidget(part)
        self.stack.setStretchFactor(0, 1)
        self.stack.setSizes(list(HEIGHTS))
        self.split.addWidget(self.stack)
        self.split.addWidget(self.tabs)
        self.split.setStretchFactor(0, 1)
        self.split.setStretchFactor(1, 0)
        self.split.setSizes([10_000, PANEL_WIDTH])
        for splitter in (self.split, self.stack):
            splitter.setChildrenCollapsible(False)
        self.tabs.setDocumentMode(True)
        builders.named(self.tabs.tabBar(), tr("Parts of the page"))
        saved = builders.column(
            *(builders.row(button, 1) for button in (self.export, self.save_words, self.save_speech)), spacing=6
        )
        hint = builders.label(f"{tr(HINT)}.", self._theme.faint, wraps=True)
        for name, parts in (
            (tr("Face"), (self.choices, builders.line(self._theme.line), self.visemes, 1, hint)),
            (tr("Expression"), (self.expression, builders.line(self._theme.line), self.style_panel, 1)),
            (tr("Output"), (builders.heading(tr("Files")), saved, builders.heading(tr("Network")), self.osc, 1)),
            (tr("Inspect"), (builders.heading(tr("Blend shapes")), self.bars, 1)),
        ):
            body = QWidget()
            builders.column(*parts, on=body, margins=(10, 8, 10, 8), spacing=8)
            self.tabs.addTab(_scrolled(body), name)
        builders.row(self.split, on=self)


def _scrolled(body: QWidget) -> builders.ScrolledDown:
    """Return an area that scrolls a body downwards."""
    builders.leave_wheel(body)
    scroll = builders.ScrolledDown()
    scroll.show_body(body)
    scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return scroll


class Heads:
    """Moves the heads that are seen.

    Attributes
    ----------
    by_name : the heads, as they are called in every window.
    """

    def __init__(self, talking: TalkModel) -> None:
        self._talking = talking
        self.by_name: dict[str, HeadView] = {}
        self._views: list[HeadView | TalkPage] = []

    def add(self, name: str, head: HeadView, page: TalkPage | None = None) -> HeadView:
        """Move this one too, with all of its page; it is called so in every window."""
        self.by_name[name] = head
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
        for name, head in self.by_name.items():
            if name in other.by_name:
                head.copy_view_from(other.by_name[name])

    def release_gl(self) -> None:
        """Give everything back to the graphics driver."""
        for head in self.by_name.values():
            head.release_gl()
