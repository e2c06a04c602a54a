"""Which keys belong to the widget that has the focus, which to the window's menus, and which to phonemes."""

from collections.abc import Callable
from typing import Any, Protocol

from PySide6 import QtWidgets
from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QApplication, QWidget
from shiboken6 import isValid
from typing_extensions import override

from phonemeanalyser.desktop.widgets.builders import leave_wheel
from phonemeengine.phonemes import Phoneme

_MOVING = frozenset({Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Home, Qt.Key.Key_End})
_EDITING = frozenset({Qt.Key.Key_Backspace, Qt.Key.Key_Delete, *_MOVING})
_CLIPBOARD = frozenset({Qt.Key.Key_A, Qt.Key.Key_C, Qt.Key.Key_V, Qt.Key.Key_X})
_RETURN = frozenset({Qt.Key.Key_Return, Qt.Key.Key_Enter})
_LEAVING = frozenset({Qt.Key.Key_Escape, Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab, Qt.Key.Key_Backtab})
_PLAIN = (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.KeypadModifier)
_TYPED_INTO = (
    QtWidgets.QComboBox,
    QtWidgets.QAbstractSpinBox,
    QtWidgets.QAbstractItemView,
    QtWidgets.QLineEdit,
    QtWidgets.QTextEdit,
    QtWidgets.QPlainTextEdit,
)
_LETTERS_ARE_KEYS = "letters are keys"


def give_letters_to_page(view: QtWidgets.QAbstractItemView) -> None:
    """Have letters be keys of the page while a list has the focus: nothing is searched in it by typing."""
    view.setProperty(_LETTERS_ARE_KEYS, True)


def is_typed_into(widget: QtWidgets.QWidget | None) -> bool:
    """Return whether letters belong to a widget: text, numbers, and lists that are searched by typing."""
    return isinstance(widget, _TYPED_INTO) and not widget.property(_LETTERS_ARE_KEYS)


def settle_focus(page: QtWidgets.QWidget) -> None:
    """Have the buttons of a page take the focus by Tab only, so that Space still plays; fields leave the wheel."""
    leave_wheel(page, by_click=False)
    for button in page.findChildren(QtWidgets.QAbstractButton):
        if button.focusPolicy() & Qt.FocusPolicy.ClickFocus:
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)


class NumberFieldKeys(QObject):
    """Leaves to a field of numbers the keys that write a number; Space and undo stay the window's."""

    @override
    def eventFilter(self, _watched: QObject, event: Any) -> bool:
        """Refuse keys that the field would swallow, so that the window's shortcuts see them."""
        if event.type() != QEvent.Type.ShortcutOverride or _writes_a_number(event):
            return False
        event.ignore()
        return True


class ArrowKeys(QObject):
    """Leaves Left and Right to a widget that moves something by them; with Shift they are shortcuts of the window."""

    @override
    def eventFilter(self, _watched: QObject, event: Any) -> bool:
        if event.type() != QEvent.Type.ShortcutOverride or event.modifiers() not in _PLAIN:
            return False
        if event.key() not in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            return False
        event.accept()
        return True


class ControlKeys(QObject):
    """Leaves keys that would be shortcuts of the window to the control that has the focus.

    Those are Space where that is a button, and where one types or searches letters, digits, Home, End and Delete.
    """

    @override
    def eventFilter(self, _watched: QObject, event: Any) -> bool:
        if event.type() != QEvent.Type.ShortcutOverride or event.modifiers() not in _PLAIN:
            return False
        focused = QtWidgets.QApplication.focusWidget()
        if event.key() == Qt.Key.Key_Space:
            claimed = isinstance(focused, QtWidgets.QAbstractButton)
        else:
            typed = bool(event.text()) and event.text().isprintable()
            claimed = is_typed_into(focused) and (typed or event.key() in _EDITING)
        event.setAccepted(claimed)
        return claimed


class FocusReturn(QObject):
    """Gives the focus back to the main view of the page, where Qt would give it to the next control.

    It does so when the control that had it was hidden or disabled, also while a dialog was open, when a number was
    ended by Return, and when a list of choices was closed with the mouse. A list that was closed by a key leaves the
    focus in its box: more letters still search there.

    Parameters
    ----------
    window : whose focus it looks after.
    main_view : returns what has the focus when the page that is seen is entered.

    Signals
    -------
    clicked : the user clicked into this widget, which has the focus now.
    """

    clicked = Signal(QtWidgets.QWidget)

    def __init__(self, window: QtWidgets.QWidget, main_view: Callable[[], QtWidgets.QWidget]) -> None:
        super().__init__(window)
        self._window = window
        self._main_view = main_view
        self._closed_by_key = False
        self._last: QtWidgets.QWidget | None = None
        application = QtWidgets.QApplication.instance()
        assert isinstance(application, QtWidgets.QApplication)
        self._application = application
        self._application.focusChanged.connect(self._follow)
        window.installEventFilter(self)

    def end(self) -> None:
        """Look no more: the window closes, and its widgets lose the focus as they are destroyed."""
        self._application.focusChanged.disconnect(self._follow)

    def leave_field(self, *_chosen: object) -> None:
        """Leave a field that one types into: after a choice elsewhere, letters are keys again."""
        if is_typed_into(self._window.focusWidget()):
            self._main_view().setFocus()

    @override
    def eventFilter(self, watched: QObject, event: Any) -> bool:
        """Note which key was pressed in a list of choices, and see Return, which fields of numbers pass on."""
        if watched is self._window:
            ends_number = event.type() == QEvent.Type.KeyPress and event.key() in _RETURN
            if ends_number and isinstance(QtWidgets.QApplication.focusWidget(), QtWidgets.QAbstractSpinBox):
                self._main_view().setFocus()
        elif event.type() in {QEvent.Type.KeyPress, QEvent.Type.ShortcutOverride}:
            self._closed_by_key = event.key() in _LEAVING
        elif event.type() == QEvent.Type.MouseButtonPress:
            self._closed_by_key = False
        return False

    def _follow(self, old: QtWidgets.QWidget | None, now: QtWidgets.QWidget | None) -> None:
        if now is not None and QtWidgets.QApplication.mouseButtons() != Qt.MouseButton.NoButton:
            self.clicked.emit(now)
        if now is not None and isinstance(_box_of(now), QtWidgets.QComboBox):
            self._closed_by_key = False
            now.installEventFilter(self)
        elif (old is not None and self._is_left(old, now)) or self._returns_elsewhere(old, now):
            self._main_view().setFocus()
        if now is not None and now.window() is self._window:
            self._last = now

    def _returns_elsewhere(self, old: QtWidgets.QWidget | None, now: QtWidgets.QWidget | None) -> bool:
        """Return whether the window is active again, and what had its focus before can't have it any more."""
        last = self._last
        comes_back = (
            now is not None and now.window() is self._window and (old is None or old.window() is not self._window)
        )
        if not comes_back or last is None or last is now or not isValid(last):
            return False
        return last.window() is self._window and (last.isHidden() or not last.isEnabled())

    def _is_left(self, old: QtWidgets.QWidget, now: QtWidgets.QWidget | None) -> bool:
        """Return whether the focus went somewhere without the user's choice."""
        box = _box_of(old)
        if box is not None:
            return box is now and box.window() is self._window and not self._closed_by_key
        vanished = not old.isVisible() or not old.isEnabled()
        return vanished and old.window() is self._window and self._window.isActiveWindow()


def _box_of(view: QtWidgets.QWidget) -> QtWidgets.QComboBox | None:
    """Return the box whose list of choices a view is."""
    container = view.parentWidget() if isinstance(view, QtWidgets.QAbstractItemView) else None
    box = container.parentWidget() if container is not None else None
    return box if isinstance(box, QtWidgets.QComboBox) and box.view() is view else None


def _writes_a_number(event: Any) -> bool:
    control = event.modifiers() & Qt.KeyboardModifier.ControlModifier
    if control:
        return event.key() in _CLIPBOARD
    return event.key() in _EDITING or (bool(event.text()) and event.text() in "0123456789.,-+")


KEYS: dict[Phoneme, str] = {
    Phoneme.SILENCE: "Q",
    Phoneme.SZ: "S",
    Phoneme.SCH: "H",
    Phoneme.M: "M",
    Phoneme.P: "P",
    Phoneme.I: "I",
    Phoneme.A: "A",
    Phoneme.E: "E",
    Phoneme.U: "U",
    Phoneme.O: "O",
}
"""Letters that are none of the window's shortcuts: q for quiet, h for the sound of she, sch."""
PHONEME_OF = {int(getattr(Qt.Key, f"Key_{key}")): phoneme for phoneme, key in KEYS.items()}
SETTLE_MS = 70
"""Milliseconds after which a release counts: longer than between two repeats of a held key under load."""
_KEY_EVENTS = (QEvent.Type.KeyPress, QEvent.Type.KeyRelease)


class PressTarget(Protocol):
    """Does something for as long as a phoneme is held."""

    def press(self, phoneme: Phoneme) -> None:
        """Begin."""
        ...

    def release(self) -> None:
        """End."""
        ...


class HeldKeys(QObject):
    """Watches the keys that reach the window, and holds a phoneme for as long as its key is down.

    X11 repeats a held key as pairs of release and press, which a busy program cannot always tell from a hand. So a
    release counts once no press of the same key has followed it for `SETTLE_MS`.

    Parameters
    ----------
    holder : told what is held.
    page : where the keys count.

    Attributes
    ----------
    settling : runs from a release until it counts.
    """

    def __init__(self, holder: PressTarget, page: QWidget) -> None:
        super().__init__(page)
        self._holder = holder
        self._page = page
        self._down: int | None = None
        self.settling = QTimer(self)
        self.settling.setSingleShot(True)
        self.settling.setInterval(SETTLE_MS)
        self.settling.timeout.connect(self._let_go)

    @override
    def eventFilter(self, _watched: QObject, event: Any) -> bool:
        """Begin and end; without the window's focus nothing is held."""
        kind = event.type()
        if kind == QEvent.Type.WindowDeactivate:
            self._let_go()
            return False
        if kind not in _KEY_EVENTS:
            return False
        if kind == QEvent.Type.KeyRelease:
            if event.key() != self._down:
                return False
            if not event.isAutoRepeat():
                self.settling.start()
            return True
        return self._press(event)

    def _press(self, event: Any) -> bool:
        if event.key() == self._down:
            self.settling.stop()
            return True
        phoneme = PHONEME_OF.get(event.key())
        plain = event.modifiers() in {Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier}
        if phoneme is None or not plain or not self._page.isVisible() or not self._page.isEnabled():
            return False
        if is_typed_into(QApplication.focusWidget()):
            return False
        if self.settling.isActive():
            self._let_go()
        if not event.isAutoRepeat() and self._down is None:
            self._down = event.key()
            self._holder.press(phoneme)
        return True

    def _let_go(self) -> None:
        self.settling.stop()
        if self._down is not None:
            self._down = None
            self._holder.release()
