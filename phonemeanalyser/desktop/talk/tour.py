"""A short tour of the page of the head: one control after the other is framed, with a sentence, until one leaves."""

from typing import NamedTuple

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QTabWidget, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column, label, named, row, tool_button

WIDTH, GAP, EDGE = 300, 8, 3
"""Pixels of the sentence, between it and what is framed, and of the frame."""


class Stop(NamedTuple):
    """What the tour points at.

    Attributes
    ----------
    control : that is framed.
    words : about it.
    tab : that has to be in front for it to be seen; None where it is in no tab.
    """

    control: QWidget
    words: str
    tab: QWidget | None = None


class Tour(QFrame):
    """Lies over a page while it runs; Return goes on, Escape leaves.

    Parameters
    ----------
    page : that is led through.
    stops : in their order.

    Attributes
    ----------
    stops : as they were given.
    stop : the number of the current one.
    onward, back, leave : its buttons.
    """

    def __init__(self, page: QWidget, stops: tuple[Stop, ...], theme: Theme) -> None:
        super().__init__(page)
        self._page, self.stops = page, stops
        self.stop = 0
        self._frame = QFrame(page)
        self._frame.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._frame.setStyleSheet(
            f"border: {EDGE}px solid {theme.accent}; border-radius: 6px; background: transparent"
        )
        self.setObjectName("tour")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setStyleSheet(
            f"#tour {{ background: {theme.raised}; border: 1px solid {theme.accent}; border-radius: 8px }}"
        )
        named(self, tr("Tour of Talk"))
        self._words, self._count = label(wraps=True), label(colour=theme.faint)
        self.back = tool_button(tr("Back"), tr("Go to the step before"), act=self._go_back)
        self.leave = tool_button(
            tr("Leave"), tr("Leave the tour (Escape); Help > Tour of Talk shows it again"), act=self.end
        )
        self.onward = tool_button("", tr("Go to the next step (Return)"), act=self._go_on)
        column(
            self._words,
            row(self._count, 1, self.leave, self.back, self.onward, spacing=6),
            on=self,
            margins=(12, 10, 12, 10),
            spacing=8,
        )
        self.setFixedWidth(WIDTH)
        page.installEventFilter(self)
        self.hide()
        self._frame.hide()

    def begin(self) -> None:
        """Show the first step."""
        self._show(0)

    def end(self) -> None:
        """Leave, with the focus on what was pointed at."""
        if not self.isHidden():
            self.hide()
            self._frame.hide()
            self.stops[self.stop].control.setFocus()

    @override
    def eventFilter(self, _page: QObject, event: QEvent) -> bool:
        """Go along with the page, and leave with it."""
        if event.type() in {QEvent.Type.Resize, QEvent.Type.LayoutRequest}:
            self._fit()
        elif event.type() == QEvent.Type.Hide:
            self.end()
        return False

    @override
    def event(self, event: QEvent) -> bool:
        """Take Escape and Return, which belong to the tour while it has the focus."""
        if isinstance(event, QKeyEvent) and event.key() in {Qt.Key.Key_Escape, Qt.Key.Key_Return, Qt.Key.Key_Enter}:
            event.accept()
            if event.type() == QEvent.Type.KeyPress:
                (self.end if event.key() == Qt.Key.Key_Escape else self._go_on)()
            return True
        return super().event(event)

    def _go_on(self) -> None:
        if self.stop + 1 < len(self.stops):
            self._show(self.stop + 1)
        else:
            self.end()

    def _go_back(self) -> None:
        self._show(max(0, self.stop - 1))

    def _show(self, number: int) -> None:
        self.stop = number
        stop, n = self.stops[number], len(self.stops)
        if stop.tab is not None:
            for tabs in self._page.findChildren(QTabWidget):
                tabs.setCurrentWidget(stop.tab)
        self._words.setText(stop.words)
        self.setAccessibleDescription(stop.words)
        self._count.setText(tr("{k} of {n}").format(k=number + 1, n=n))
        self.back.setEnabled(number > 0)
        self.onward.setText(tr("Next") if number + 1 < n else tr("Done"))
        self.show()
        self._frame.show()
        self._fit()
        self.onward.setFocus()

    def _fit(self) -> None:
        """Lie below what is framed; without room there, above it or in front of it."""
        if self.isHidden():
            return
        control = self.stops[self.stop].control
        seen = control.visibleRegion().boundingRect() if control.isVisible() else control.rect()
        framed = QRect(control.mapTo(self._page, seen.topLeft()), seen.size()).adjusted(-EDGE, -EDGE, EDGE, EDGE)
        page = self._page.rect()
        self._frame.setGeometry(framed & page)
        self.resize(WIDTH, self.heightForWidth(WIDTH) if self.hasHeightForWidth() else self.sizeHint().height())
        height = self.height()
        below, above = framed.bottom() + GAP, framed.top() - GAP - height
        top = below if below + height <= page.bottom() else above if above >= 0 else page.center().y() - height // 2
        left = min(max(framed.left(), GAP), page.right() - WIDTH - GAP)
        self.move(QPoint(left, top))
        self._frame.raise_()
        self.raise_()
