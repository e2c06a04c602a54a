"""A line that says what went wrong and what to do, without a dialog."""

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from phonemeanalyser.theme import Theme

SHOWN_MS = 15_000


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
        dismiss = QToolButton()
        dismiss.setText("✕")
        dismiss.setAutoRaise(True)
        dismiss.setToolTip("Dismiss")
        dismiss.clicked.connect(lambda _checked: self.say(""))
        row = QHBoxLayout(self)
        row.setContentsMargins(10, 4, 6, 4)
        row.addWidget(self.label, 1)
        row.addWidget(dismiss)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setObjectName("banner")
        self.setStyleSheet(
            f"#banner {{ background: {theme.bad} }} #banner QLabel, #banner QToolButton {{ color: white }}"
        )
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(lambda: self.say(""))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Take as many lines as the sentence needs now."""
        super().resizeEvent(event)
        self._fit()

    def say(self, sentence: str) -> None:
        """Show a sentence; an empty one takes the banner away."""
        self.label.setText(sentence)
        self.shown.emit(bool(sentence))
        self._fit()
        if sentence:
            self._timer.start(SHOWN_MS)

    def _fit(self) -> None:
        self.label.setFixedHeight(max(0, self.label.heightForWidth(self.label.width())))  # no toolbar asks for that
