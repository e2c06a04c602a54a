"""Facts of the moment as chips in the tool bar: views that stand still, a changed file, lost sound, lateness."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QLabel, QSizePolicy, QToolButton, QWidget

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import named, row, tool_button

PADDING = 8
"""Pixels at either side of a chip's text."""


class StateChips(QWidget):
    """Chips that are there while there is something to say; two of them can be clicked.

    Signals
    -------
    go_on_asked : the views are to go on.
    open_again_asked : the file in hand is to be opened again.

    Attributes
    ----------
    frozen, changed, unseen, lost, late : the chips.
    """

    go_on_asked = Signal()
    open_again_asked = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.frozen = tool_button(
            tr("frozen"),
            tr("The views stand still while sound goes on; click, or press F, and they go on"),
            tr("views stand still"),
            self.go_on_asked.emit,
        )
        self.changed = tool_button("", tr("What became of the file meanwhile"), act=self.open_again_asked.emit)
        self.unseen = named(
            QLabel(), tip=tr("Frames that were analysed but never drawn: the machine has too much to do")
        )
        self.lost = named(QLabel(), tip=tr("Sound that never came from the microphone, since listening began"))
        self.late = QLabel()
        self.late.setAlignment(Qt.AlignmentFlag.AlignCenter)
        chips = row(on=self, margins=(0, 0, 6, 0), spacing=4)
        for chip in self._chips:
            chip.hide()
            chips.addWidget(chip, 0, Qt.AlignmentFlag.AlignVCenter)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        self._dress(self.frozen, theme.accent)
        for chip in (self.changed, self.unseen, self.lost):
            self._dress(chip, theme.bad)

    def show_frozen(self, on: bool) -> None:
        """Say that the views stand still, or that they do not."""
        self.frozen.setVisible(on)

    def show_changed(self, words: str, tip: str) -> None:
        """Say that the file in hand is another one by now, or none; an empty text for neither."""
        if tip:
            self.changed.setToolTip(tip)
        _say(self.changed, words)

    def show_unseen(self, n_frames: int) -> None:
        """Say how many frames were never drawn; 0 for none."""
        _say(self.unseen, tr("{n} frames not drawn").format(n=n_frames) if n_frames else "")

    def show_lost(self, seconds: float) -> None:
        """Say how much sound never came; 0 for none."""
        _say(self.lost, tr("{seconds:.2f} s lost").format(seconds=seconds) if seconds >= 0.005 else "")

    def keep_room_for_late(self, widest: str) -> None:
        """Give the chip of lateness the width of a text, so that the tool bar stands still while the text changes."""
        font = self.late.font()
        font.setBold(True)
        self.late.setMinimumWidth(QFontMetrics(font).horizontalAdvance(widest) + 2 * PADDING)

    def show_late(self, words: str, colour: str = "", tip: str = "") -> None:
        """Say how late phonemes are on the screen; an empty text for nothing."""
        if words and colour:
            self._dress(self.late, colour)
        self.late.setToolTip(tip)
        _say(self.late, words)

    def words(self) -> str:
        """Return what the chips say."""
        return "   ".join(chip.text() for chip in self._chips if not chip.isHidden())

    @property
    def _chips(self) -> tuple[QToolButton | QLabel, ...]:
        return self.frozen, self.changed, self.unseen, self.lost, self.late

    def _dress(self, chip: QWidget, colour: str) -> None:
        sheet = (
            f"* {{ background: {colour}; color: {self._theme.on_colour}; border: 0; border-radius: 8px;"
            f" padding: 1px {PADDING}px; font-weight: bold }} QToolTip {{ font-weight: normal }}"
        )
        if sheet != chip.styleSheet():
            chip.setStyleSheet(sheet)


def _say(chip: QLabel | QToolButton, words: str) -> None:
    if words != chip.text():
        chip.setText(words)
    chip.setVisible(bool(words))
