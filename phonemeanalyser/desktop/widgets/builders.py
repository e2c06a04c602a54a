"""How views are put together: rows and columns, buttons, choices and labels, each in one call."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

from PySide6 import QtWidgets
from PySide6.QtCore import QEvent, QObject, QSignalBlocker, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from typing_extensions import override

Part = QtWidgets.QWidget | QtWidgets.QLayout | int | tuple[QtWidgets.QWidget | QtWidgets.QLayout, int]
"""Of a row or a column: what stands there, also with its share of the room that is left, or such a share empty."""
Margins = tuple[int, int, int, int]
W = TypeVar("W", bound=QtWidgets.QWidget)
NONE = (0, 0, 0, 0)
MOST_OF_NAME = 90
"""Pixels of the name of a file on a button."""
Button = QtWidgets.QDialogButtonBox.StandardButton
CANCEL, CLOSE = Button.Cancel, Button.Close


def row(
    *parts: Part, on: QtWidgets.QWidget | None = None, margins: Margins | None = NONE, spacing: int | None = None
) -> QtWidgets.QHBoxLayout:
    """Lay out from left to right, on a widget or for another layout; None is what the style has."""
    return _filled(QtWidgets.QHBoxLayout(on) if on else QtWidgets.QHBoxLayout(), parts, margins, spacing)


def column(
    *parts: Part, on: QtWidgets.QWidget | None = None, margins: Margins | None = NONE, spacing: int | None = None
) -> QtWidgets.QVBoxLayout:
    """Lay out from top to bottom, as `row` does from left to right."""
    return _filled(QtWidgets.QVBoxLayout(on) if on else QtWidgets.QVBoxLayout(), parts, margins, spacing)


def grid(
    on: QtWidgets.QWidget | None = None, *, margins: Margins = NONE, across: int = -1, down: int = -1
) -> QtWidgets.QGridLayout:
    """Make a grid, with this much room between its columns and its rows, pixels; -1 is what the style has."""
    made = QtWidgets.QGridLayout(on) if on else QtWidgets.QGridLayout()
    made.setContentsMargins(*margins)
    made.setHorizontalSpacing(across)
    made.setVerticalSpacing(down)
    return made


def named(widget: W, name: str = "", tip: str = "") -> W:
    """Give a widget its name for screen readers, and its tip; what is empty is left out."""
    if name:
        widget.setAccessibleName(name)
    if tip:
        widget.setToolTip(tip)
    return widget


def tool_button(
    text: str, tip: str = "", name: str = "", act: Callable[[], object] | None = None, *, flat: bool = False
) -> QtWidgets.QToolButton:
    """Make a button, which takes the focus by Tab only."""
    button = named(QtWidgets.QToolButton(), name, tip)
    button.setText(text)
    button.setAutoRaise(flat)
    if act is not None:
        button.clicked.connect(lambda _checked: act())
    return button


def spoken_button(text: str, tip: str, act: Callable[[], object] | None = None) -> QtWidgets.QToolButton:
    """Make a button that screen readers call by its tip."""
    return tool_button(text, tip, tip, act)


def show_removable(button: QtWidgets.QToolButton, name: str, tip: str) -> None:
    """Have a button show the name of a file that a click removes from use; a long name is elided."""
    shown = button.fontMetrics().elidedText(name, Qt.TextElideMode.ElideMiddle, MOST_OF_NAME)
    button.setText(f"{shown} ×".replace("&", "&&"))
    named(button, tip, tip)


def tab_buttons(*buttons: QtWidgets.QAbstractButton, height: int = 0) -> tuple[QtWidgets.QAbstractButton, ...]:
    """Have buttons take the focus by Tab only, and be this high at least, pixels; return them."""
    for button in buttons:
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.setMinimumHeight(height)
    return buttons


def open_at_once(button: QtWidgets.QToolButton, menu: QtWidgets.QMenu) -> None:
    """Have a button open its menu when it is pressed."""
    button.setMenu(menu)
    button.setPopupMode(QtWidgets.QToolButton.ToolButtonPopupMode.InstantPopup)


def open_without_arrow(button: QtWidgets.QToolButton, menu: QtWidgets.QMenu) -> None:
    """Have a button open its menu when it is pressed; the arrow of the style would lie on its text."""
    open_at_once(button, menu)
    button.setStyleSheet("QToolButton::menu-indicator { image: none }")


def toggle_button(text: str, tip: str) -> QtWidgets.QToolButton:
    """Make a small button that stays down while it is on."""
    button = tool_button(text, tip)
    button.setCheckable(True)
    return button


def choice(items: Iterable[tuple[str, Any]], name: str = "", tip: str = "") -> QtWidgets.QComboBox:
    """Make a box to choose from: what is read, and what it stands for."""
    box = named(QtWidgets.QComboBox(), name, tip)
    for text, value in items:
        box.addItem(text, value)
    return box


def offer(box: QtWidgets.QComboBox, items: Iterable[tuple[str, Any]], chosen: Any, *, usual: Any = None) -> None:
    """Have a box offer these, where it offers others, and show what is chosen; else what is usual, or the first."""
    wanted = list(items)
    if [(box.itemText(k), box.itemData(k)) for k in range(box.count())] != wanted:
        box.clear()
        for text, value in wanted:
            box.addItem(text, value)
    values = [value for _, value in wanted]
    shown = chosen if chosen in values else usual
    box.setCurrentIndex(values.index(shown) if shown in values else 0)


def fill_rows(grid: QtWidgets.QGridLayout, rows: Iterable[Sequence[QtWidgets.QWidget]]) -> None:
    """Fill a grid with rows of widgets, of which the second one takes the room that is left."""
    for k, widgets in enumerate(rows):
        for place, widget in enumerate(widgets):
            grid.addWidget(widget, k, place)
    grid.setColumnStretch(1, 1)


def label(text: str = "", colour: str = "", *, wraps: bool = False, width: int = 0) -> QtWidgets.QLabel:
    """Make a label, in a colour and of several lines where that is wanted; numbers of a width stand at the right."""
    made = QtWidgets.QLabel(text)
    made.setWordWrap(wraps)
    if width:
        made.setFixedWidth(width)
        made.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    if colour:
        made.setStyleSheet(f"color: {colour}")
    return made


def heading(text: str) -> QtWidgets.QLabel:
    """Make the heading of a part of a page."""
    return QtWidgets.QLabel(f"<b>{text}</b>")


def line(colour: str, *, upright: bool = False) -> QtWidgets.QFrame:
    """Make a line of one pixel between two parts."""
    made = QtWidgets.QFrame()
    (made.setFixedWidth if upright else made.setFixedHeight)(1)
    made.setStyleSheet(f"background: {colour}")
    return made


def dialog_buttons(dialog: QtWidgets.QDialog, *buttons: Button, verb: str = "") -> QtWidgets.QDialogButtonBox:
    """Make the buttons that end a dialog; a verb names the one that does what the dialog is for, by Return, too."""
    box = QtWidgets.QDialogButtonBox()
    if verb:
        box.addButton(verb, QtWidgets.QDialogButtonBox.ButtonRole.AcceptRole).setDefault(True)
    for button in buttons:
        box.addButton(button)
    box.accepted.connect(dialog.accept)
    box.rejected.connect(dialog.reject)
    return box


def input_dialog(
    window: QtWidgets.QWidget, title: str, question: str, verb: str, text: str = "", items: Sequence[str] = ()
) -> QtWidgets.QInputDialog:
    """Make a dialog that asks for a text, or for one of some items; the verb names what its button does with it."""
    dialog = QtWidgets.QInputDialog(window)
    dialog.setWindowTitle(title)
    dialog.setLabelText(question)
    dialog.setOkButtonText(verb)
    if items:
        dialog.setComboBoxItems(list(items))
    else:
        dialog.setTextValue(text)
    return dialog


def answer_of(dialog: QtWidgets.QInputDialog) -> str | None:
    """Show a dialog, and return what was entered; None where it was cancelled."""
    taken = dialog.exec()
    dialog.deleteLater()
    return dialog.textValue() if taken else None


def style_list(table: QtWidgets.QTableWidget, row_height: int, widths: Sequence[int]) -> None:
    """Have a table be a plain list of lines to choose from; a column of width 0 takes what is left, pixels."""
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(row_height)
    header = table.horizontalHeader()
    header.setFixedHeight(22)
    header.setHighlightSections(False)
    for k, width in enumerate(widths):
        header.setSectionResizeMode(
            k, QtWidgets.QHeaderView.ResizeMode.Fixed if width else QtWidgets.QHeaderView.ResizeMode.Stretch
        )
        if width:
            header.resizeSection(k, width)
    table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectionBehavior.SelectRows)
    table.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setShowGrid(False)
    table.setTabKeyNavigation(False)


@contextmanager
def silent(*objects: QObject) -> Iterator[None]:
    """Have objects tell nothing while they are shown other values."""
    blockers = [QSignalBlocker(each) for each in objects]
    try:
        yield
    finally:
        for blocker in blockers:
            blocker.unblock()


L = TypeVar("L", bound=QtWidgets.QBoxLayout)


def _filled(layout: L, parts: Iterable[Part], margins: Margins | None, spacing: int | None) -> L:
    if margins is not None:
        layout.setContentsMargins(*margins)
    if spacing is not None:
        layout.setSpacing(spacing)
    for part in parts:
        item, stretch = part if isinstance(part, tuple) else (part, 0)
        if isinstance(item, int):
            layout.addStretch(item)
        elif isinstance(item, QtWidgets.QWidget):
            layout.addWidget(item, stretch)
        else:
            layout.addLayout(item, stretch)
    return layout


class Rewrapped(QtWidgets.QWidget):
    """Is wrapped anew when it has another width, or when something in it needs more room, or less."""

    @override
    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.wrap()

    @override
    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            self.wrap()
        return super().event(event)

    def wrap(self) -> None:
        """Choose one line or two."""
        raise NotImplementedError


class Wrapping(Rewrapped):
    """Shows two rows side by side where there is room, and else the second one below the first."""

    def __init__(
        self, first: QtWidgets.QLayout, second: QtWidgets.QLayout, margins: Margins, spacing: int = 8
    ) -> None:
        super().__init__()
        self._rows = (first, second)
        self._box = _filled(
            QtWidgets.QBoxLayout(QtWidgets.QBoxLayout.Direction.TopToBottom, self), [(first, 1), second], margins, 3
        )
        self._between = spacing

    @override
    def minimumSizeHint(self) -> QSize:
        margins = self._box.contentsMargins()
        width = max(each.minimumSize().width() for each in self._rows) + margins.left() + margins.right()
        return QSize(width, super().minimumSizeHint().height())

    @override
    def wrap(self) -> None:
        """Put the rows side by side where there is room."""
        needed = sum(each.sizeHint().width() for each in self._rows) + self._between
        is_wide = needed <= self._box.contentsRect().width()
        side, below = QtWidgets.QBoxLayout.Direction.LeftToRight, QtWidgets.QBoxLayout.Direction.TopToBottom
        if self._box.direction() is not (wanted := side if is_wide else below):
            self._box.setDirection(wanted)
            self._box.setSpacing(self._between if is_wide else 3)


LEAST = QSize(160, 68)
"""Pixels in which a view can still be used by scrolling."""


class Scrolled(QtWidgets.QScrollArea):
    """Shows a view as it is where there is room, and by scroll bars where there is too little."""

    def __init__(self, view: QtWidgets.QWidget) -> None:
        super().__init__()
        self._view = view
        self.setWidget(view)
        self.setWidgetResizable(True)
        self.setFrameShape(QtWidgets.QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    @override
    def sizeHint(self) -> QSize:
        return self._view.sizeHint()

    @override
    def minimumSizeHint(self) -> QSize:
        return LEAST.boundedTo(self._view.minimumSizeHint())

    @property
    def needed_width(self) -> int:
        """The least width at which nothing is scrolled sideways, pixels, with the bar that scrolls downwards."""
        return _needed_width(self, self._view)


def _needed_width(area: QtWidgets.QScrollArea, view: QtWidgets.QWidget) -> int:
    for layout in view.findChildren(QtWidgets.QLayout):
        layout.invalidate()  # else what lies within others has the width of the style before
    for widget in view.findChildren(QtWidgets.QWidget):
        widget.updateGeometry()
    return view.minimumSizeHint().width() + area.verticalScrollBar().sizeHint().width()


class ScrolledDown(QtWidgets.QScrollArea):
    """Scrolls a body downwards only; it is never narrower than the body in the style of the window."""

    def show_body(self, body: QtWidgets.QWidget) -> None:
        """Scroll this body from now on."""
        self.setWidget(body)
        self.setWidgetResizable(True)
        self.setFrameShape(QtWidgets.QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.keep_width(body)

    def keep_width(self, body: QtWidgets.QWidget) -> None:
        """Take the width that the body needs now as the least."""
        self.setMinimumWidth(_needed_width(self, body))

    @override
    def changeEvent(self, event: QEvent) -> None:
        """Measure anew in another style: that of the window comes after the body was made."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.StyleChange and (body := self.widget()):
            self.keep_width(body)


_SET_BY_WHEEL = (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox, QtWidgets.QSlider, QtWidgets.QTabBar)


class _OnlyWithFocus(QObject):
    @override
    def eventFilter(self, watched: QObject, event: Any) -> bool:
        """Leave the wheel to what is behind a widget that has not the focus."""
        if event.type() != QEvent.Type.Wheel or not isinstance(watched, QtWidgets.QWidget) or watched.hasFocus():
            return False
        event.ignore()
        return True


def leave_wheel(body: QtWidgets.QWidget, *, by_click: bool = True) -> None:
    """Have a widget and all numbers, choices, sliders and tabs in it heed the wheel only while they have the focus.

    Parameters
    ----------
    body : what is scrolled, or holds them.
    by_click : whether numbers, choices and sliders get the focus by a click; else that stays as it is.
    """
    for widget in (body, *(found for kind in _SET_BY_WHEEL for found in body.findChildren(kind))):
        if not isinstance(widget, _SET_BY_WHEEL):
            continue
        takes_it = widget.focusPolicy() == Qt.FocusPolicy.WheelFocus  # the wheel itself is to give no focus
        if takes_it or (by_click and not isinstance(widget, QtWidgets.QTabBar)):
            widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        widget.installEventFilter(_OnlyWithFocus(widget))


class ElidedLabel(QtWidgets.QLabel):
    """A label that shows as much of its text as there is room for, and makes no window wider.

    Parameters
    ----------
    text : what it says.
    asks : whether it asks for the room of its text where there is enough.
    """

    def __init__(self, text: str = "", *, asks: bool = False) -> None:
        super().__init__(text)
        self._asks = asks

    @override
    def minimumSizeHint(self) -> QSize:
        return QSize(0, super().minimumSizeHint().height())

    @override
    def sizeHint(self) -> QSize:
        """Ask for no width, or for that of the text."""
        wanted = super().sizeHint()
        return wanted if self._asks else QSize(0, wanted.height())

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        room = self.contentsRect()
        text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, room.width())
        QPainter(self).drawText(room, self.alignment(), text)


class StillLabel(QtWidgets.QLabel):
    """A label that has the window laid out anew only where its text needs another size.

    Any other label asks for that with each text, and Qt asks for the size of everything around it then; a label of
    fixed size does not.

    Parameters
    ----------
    least_width : as wide it is at least, pixels.
    """

    def __init__(self, least_width: int = 0) -> None:
        super().__init__()
        self._least = QSize(least_width, 0)

    @override
    def setText(self, text: str) -> None:
        """Write a text; one that is there already costs nothing."""
        if text == self.text():
            return
        super().setText(text)
        needed = self.sizeHint().expandedTo(self._least)
        if needed != self.minimumSize():
            self.setFixedSize(needed)
