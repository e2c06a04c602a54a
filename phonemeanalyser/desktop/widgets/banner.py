"""A line that says what went wrong or well and what to do, without a dialog."""

import logging
from collections.abc import Callable

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from phonemeanalyser.desktop.theme import Theme

SHOWN_MS = 15_000

_log = logging.getLogger(__name__)


class Banner(QWidget):
    """Appears with a sentence, and goes by itself, by a click, or when there is nothing more to say.

    Signals
    -------
    shown : whether it is to be seen.
    """

    shown = Signal(bool)

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self.label = QLabel()
        self.label.setWordWrap(True)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.dismiss = dismiss = QToolButton()
        dismiss.setText("✕")
        dismiss.setAutoRaise(True)
        dismiss.setToolTip("Dismiss")
        dismiss.setAccessibleName("dismiss the message")
        dismiss.clicked.connect(lambda _checked: self._dismiss())
        row = QHBoxLayout(self)
        row.setContentsMargins(10, 4, 6, 4)
        self.action = QToolButton()
        self.action.setToolTip("What can be done about it")
        self.action.clicked.connect(self._act)
        self._offer: tuple[str, str, Callable[[], object]] | None = None
        row.addWidget(self.label, 1)
        row.addWidget(self.action)
        row.addWidget(dismiss)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setObjectName("banner")
        self._theme = theme
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._go_back)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Take as many lines as the sentence needs now."""
        super().resizeEvent(event)
        self._fit()

    def show_error(self, sentence: str) -> None:
        """Show what went wrong; an empty sentence takes that away, but not an offer."""
        if sentence:
            _log.warning("%s", sentence)
            self._show(sentence, self._theme.bad, SHOWN_MS)
        else:
            self._go_back()

    def show_info(self, sentence: str) -> None:
        """Show what is going on, or went well."""
        self._show(sentence, self._theme.accent, SHOWN_MS)

    def offer(self, sentence: str, action: str, act: Callable[[], object]) -> None:
        """Show something that can be acted upon, until the user does so or dismisses it, whatever else is said."""
        self._show(sentence, self._theme.accent, 0)
        self._offer = sentence, action, act
        self.action.setText(action)
        self.action.setToolTip(f"{action}: {sentence}")
        self.action.show()
        self._fit()

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
            f"#banner {{ background: {colour} }} #banner QLabel {{ color: {self._theme.on_colour} }}"
            f"#banner QToolButton {{ color: {self._theme.on_colour}; background: rgba(255, 255, 255, 40); border: 0;"
            " border-radius: 3px; padding: 3px 9px }"
            "#banner QToolButton:hover { background: rgba(255, 255, 255, 90) }"
        )
        self.label.setText(sentence)
        self.action.hide()
        self.shown.emit(bool(sentence))
        self._fit()
        self._timer.stop()
        if sentence and duration_ms:
            self._timer.start(duration_ms)

    def _fit(self) -> None:
        self.label.setFixedHeight(max(0, self.label.heightForWidth(self.label.width())))  # no toolbar asks for that
