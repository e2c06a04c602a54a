"""Sliders for what the face expresses beside its speech, and how far speech holds that back."""

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QSlider,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.heading import heading

COLUMNS = 2
PERCENT_WIDTH = 40
METER_HEIGHT = 10


class ExpressionPanel(QWidget):
    """Lists the expressions that ship with the program.

    Attributes
    ----------
    sliders : by the name of the expression.
    priority : the slider of speech's priority.
    meter : shows how far speech holds expressions back, %.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking, self._model = talking, talking.expression
        self.sliders = {name: _slider(f"how far the face shows {name}") for name in self._model.shares}
        self._percents = {name: _percent() for name in self._model.shares}
        self.priority = _slider("priority of speech")
        self.priority.setToolTip(
            "How much of lips and jaw speech has; the expression has the rest. 50 % gives each all that it asks for"
        )
        self.meter = QProgressBar()
        self.meter.setRange(0, 100)
        self.meter.setTextVisible(False)
        self.meter.setFixedHeight(METER_HEIGHT)
        self.meter.setAccessibleName("how far speech holds the expression back")
        self.meter.setToolTip(
            "How far speech holds the expression back: it goes within 0.1 s and comes back in 0.5 s"
        )
        self.neutral = QToolButton()
        self.neutral.setText("Neutral")
        self.neutral.setToolTip("Set all expressions back to 0")
        self.neutral.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._lay_out(theme)
        self._connect()
        self._show_state()

    def refresh(self) -> None:
        """Show what changes by itself."""
        held_back = round(100 * self._talking.performer.inhibition)
        if held_back != self.meter.value():
            self.meter.setValue(held_back)

    def _lay_out(self, theme: Theme) -> None:
        head = QHBoxLayout()
        head.addWidget(heading("Expression"), 1)
        head.addWidget(self.neutral)
        grid = QGridLayout()
        grid.setVerticalSpacing(3)
        grid.setHorizontalSpacing(5)
        n_rows = -(-len(self.sliders) // COLUMNS)
        for k, (name, slider) in enumerate(self.sliders.items()):
            column = 3 * (k // n_rows)
            for offset, widget in enumerate((QLabel(name), slider, self._percents[name])):
                grid.addWidget(widget, k % n_rows, column + offset)
            grid.setColumnStretch(column + 1, 1)
        below = QHBoxLayout()
        below.setSpacing(8)
        for words, widget in (("speech priority", self.priority), ("held back", self.meter)):
            label = QLabel(words)
            label.setStyleSheet(f"color: {theme.faint}")
            below.addWidget(label)
            below.addWidget(widget, 1)
        column_of_all = QVBoxLayout(self)
        column_of_all.setContentsMargins(0, 0, 0, 0)
        column_of_all.setSpacing(4)
        for layout in (head, grid, below):
            column_of_all.addLayout(layout)

    def _connect(self) -> None:
        for name, slider in self.sliders.items():
            slider.valueChanged.connect(lambda value, name=name: self._model.set_share(name, value / 100))
        self.priority.valueChanged.connect(lambda value: self._model.set_priority(value / 100))
        self.neutral.clicked.connect(lambda _checked: self._model.clear())
        self._model.changed.connect(self._show_state)

    def _show_state(self) -> None:
        for name, share in self._model.shares.items():
            with QSignalBlocker(self.sliders[name]):
                self.sliders[name].setValue(round(100 * share))
            self._percents[name].setText(f"{100 * share:.0f} %" if share else "")
        with QSignalBlocker(self.priority):
            self.priority.setValue(round(100 * self._model.priority))
        self.neutral.setEnabled(any(self._model.shares.values()))


def _slider(name: str) -> QSlider:
    slider = QSlider(Qt.Orientation.Horizontal)
    slider.setRange(0, 100)
    slider.setPageStep(10)
    slider.setMinimumWidth(44)
    slider.setAccessibleName(name)
    slider.setToolTip(f"{name[0].upper()}{name[1:]}")
    return slider


def _percent() -> QLabel:
    label = QLabel()
    label.setFixedWidth(PERCENT_WIDTH)
    label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    return label
