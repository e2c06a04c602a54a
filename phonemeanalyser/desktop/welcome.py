"""Four cards for the first start of the program."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QPushButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column, label, named, row, tool_button

CARD_WIDTH = 188
CARDS = (
    (tr_noop("Watch the Demo"), tr_noop("Play a recording and see which phonemes are recognised, and why.")),
    (tr_noop("Use My Microphone"), tr_noop("Speak and watch the phonemes; nothing is recorded until you press R.")),
    (
        tr_noop("Calibrate My Voice"),
        tr_noop("Read two sentences aloud; the preset is adapted to your voice in a minute."),
    ),
    (
        tr_noop("Animate a Recording"),
        tr_noop("Open a recording, paste its text, align both, and export the animation of a face."),
    ),
)


class WelcomeCards(QFrame):
    """Lies over the page until a card is chosen, all are dismissed, or the user begins something else.

    Parameters
    ----------
    window : whose cards they are.
    page : what they lie over.

    Signals
    -------
    demo_asked, microphone_asked, calibration_asked, animation_asked : what the user chose.

    Attributes
    ----------
    cards : the four buttons.
    """

    demo_asked, microphone_asked = Signal(), Signal()
    calibration_asked, animation_asked = Signal(), Signal()

    def __init__(self, theme: Theme, window: QWidget, page: QWidget) -> None:
        super().__init__(window)
        self._window, self._page = window, page
        self.setObjectName("welcome")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setStyleSheet(
            f"#welcome {{ background: {theme.raised}; border: 1px solid {theme.line}; border-radius: 10px }}"
            f"QFrame#card {{ background: {theme.base}; border: 1px solid {theme.line}; border-radius: 8px }}"
        )
        self.cards: list[QPushButton] = []
        self.dismiss = tool_button(
            "✕", tr("Close the cards; Help shows them again"), tr("Close cards"), self.hide, flat=True
        )
        asked = (self.demo_asked, self.microphone_asked, self.calibration_asked, self.animation_asked)
        cards = [
            self._card(tr(title), tr(words), signal.emit) for (title, words), signal in zip(CARDS, asked, strict=True)
        ]
        top = row((label(tr("<b>What would you like to do first?</b>")), 1), self.dismiss)
        pairs = [row(*cards[k : k + 2], spacing=12) for k in (0, 2)]  # four in a row are too wide for a small window
        column(top, *pairs, on=self, margins=(18, 12, 18, 18), spacing=10)
        page.installEventFilter(self)
        self.hide()

    def show_cards(self) -> None:
        """Show them, with the first one ready for the return key."""
        self.show()
        self._fit()
        self.cards[0].setFocus()

    @override
    def eventFilter(self, _page: QObject, event: QEvent) -> bool:
        if event.type() in {QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.Show}:
            self._fit()
        return False

    @override
    def event(self, event: QEvent) -> bool:
        """Go at Escape, which is for the cards while they are seen."""
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            event.accept()
            if event.type() == QEvent.Type.KeyPress:
                self.hide()
            return True
        return super().event(event)

    def leave_for(self, widget: QWidget) -> None:
        """Go when something else was clicked."""
        if not self.isAncestorOf(widget):
            self.hide()

    def _card(self, title: str, words: str, chosen: Callable[[], object]) -> QFrame:
        card, button, told = QFrame(), named(QPushButton(title), tip=words), label(words, wraps=True)
        card.setObjectName("card")
        card.setFixedWidth(CARD_WIDTH)
        button.setAutoDefault(True)
        button.setAccessibleDescription(words)
        button.clicked.connect(lambda _checked: self.hide())
        button.clicked.connect(lambda _checked: chosen())
        inside = column(on=card, margins=(14, 14, 14, 14))
        inside.addWidget(told, 1, Qt.AlignmentFlag.AlignTop)
        inside.addWidget(button)
        self.cards.append(button)
        return card

    def _fit(self) -> None:
        """Lie amid the page."""
        if self.isHidden():
            return
        self.resize(self.sizeHint())
        corner = self._page.mapTo(self._window, self._page.rect().center())
        self.move(corner - self.rect().center())
        self.raise_()
