"""A line over the page that says what went wrong or well and what to do, without a dialog, and moves nothing."""

import logging
from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, QTimer
from PySide6.QtWidgets import QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_sentence
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import label, row, tool_button

SHOWN_MS = 15_000
WIDEST = 760
"""Of the line within a page, pixels: eyes need not wander."""
HEADINGS = 30
"""Pixels at the top of that part that stay free: its heading and controls."""
BESIDE = 12
"""Pixels at least between the line and the page's edges."""

_log = logging.getLogger(__name__)


class Banner(QWidget):
    """Appears with a sentence, and goes by itself, by a click, or when there is nothing more to say.

    Parameters
    ----------
    window : whose line it is.
    page : what it lies over.
    below : a part of the page, at whose top it lies while that is seen; else over the status line, hiding no control.
    """

    def __init__(self, theme: Theme, window: QWidget, page: QWidget, below: QWidget) -> None:
        super().__init__(window)
        self._window, self._page, self._below = window, page, below
        page.installEventFilter(self)
        self.label = label(wraps=True)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.dismiss = tool_button("✕", tr("Dismiss"), tr("Dismiss message"), self._dismiss, flat=True)
        self.action = tool_button("", tr("Suggested action"), act=self._act)
        self._offer: tuple[str, str, Callable[[], object]] | None = None
        self._row = row((self.label, 1), self.action, self.dismiss, on=self, margins=(10, 2, 6, 2))
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setObjectName("banner")
        self._theme = theme
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._go_back)

    @override
    def eventFilter(self, _page: QObject, event: QEvent) -> bool:
        if event.type() in {QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.Show}:
            self._fit()
        return False

    def show_error(self, sentence: str) -> None:
        """Show what went wrong; an empty sentence takes that away, but not an offer."""
        if sentence:
            _log.warning("%s", sentence)
            self._show(tr_sentence(sentence), self._theme.bad, SHOWN_MS)
        else:
            self._go_back()

    def show_info(self, sentence: str) -> None:
        """Show what is going on, or went well."""
        self._show(tr_sentence(sentence), self._theme.accent, SHOWN_MS)

    def offer(self, sentence: str, action: str, act: Callable[[], object]) -> None:
        """Show something that can be acted upon, until the user does so or dismisses it, whatever else is said."""
        self._show(sentence, self._theme.accent, 0)
        self._offer = sentence, action, act
        self.action.setText(action)
        self.action.setToolTip(f"{action}: {sentence}")
        self.action.show()
        self._fit()

    def withdraw(self, act: Callable[[], object]) -> None:
        """Offer something no longer that does this."""
        if self._offer is not None and self._offer[2] == act:
            is_shown = self.action.isVisibleTo(self)
            self._offer = None
            if is_shown:
                self._go_back()

    def _act(self) -> None:
        offer, self._offer = self._offer, None
        self._go_back()
        if offer is not None:
            offer[2]()

    def _dismiss(self) -> None:
        if self.action.isVisibleTo(self):
            self._offer = None
        self._go_back()

    def _go_back(self) -> None:
        """Show the offer that is still open, or nothing."""
        if self._offer is not None:
            self.offer(*self._offer)
        else:
            self._show("", self._theme.accent, 0)

    def _show(self, sentence: str, colour: str, duration_ms: int) -> None:
        self.setStyleSheet(
            f"#banner {{ background: {colour}; border-radius: 6px }}"
            f"#banner QLabel {{ color: {self._theme.on_colour} }}"
            f"#banner QToolButton {{ color: {self._theme.on_colour}; background: rgba(255, 255, 255, 40); border: 0;"
            " border-radius: 3px; padding: 3px 9px }"
            "#banner QToolButton:hover { background: rgba(255, 255, 255, 90) }"
        )
        self.label.setText(sentence)
        self.action.hide()
        self.setVisible(bool(sentence))
        self._fit()
        self._timer.stop()
        if sentence and duration_ms:
            self._timer.start(duration_ms)

    def _fit(self) -> None:
        """Lie amid, with as many lines as the sentence needs."""
        if self.isHidden():
            return
        self._row.activate()
        is_within = self._below.isVisible()
        room = self._page.width() - 2 * BESIDE
        width = min(WIDEST, room) if is_within else room
        height = self.heightForWidth(width)
        top = self._window.height() - height
        if is_within:
            top = self._below.mapTo(self._window, QPoint()).y() + HEADINGS
        left = self._page.mapTo(self._window, QPoint()).x() + (self._page.width() - width) // 2
        self.setGeometry(left, top, width, height)
        self.raise_()
