"""The key of each phoneme: held down, it records a take, or tests a mouth."""

from typing import Any, Protocol

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QApplication, QLineEdit, QWidget

from phonemeengine.phonemes import Phoneme

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

    Parameters
    ----------
    holder : told what is held.
    page : where the keys count.
    """

    def __init__(self, holder: PressTarget, page: QWidget) -> None:
        super().__init__(page)
        self._holder = holder
        self._page = page
        self._down: int | None = None

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
                self._let_go()
            return True
        return self._press(event)

    def _press(self, event: Any) -> bool:
        phoneme = PHONEME_OF.get(event.key())
        plain = event.modifiers() in {Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier}
        if phoneme is None or not plain or not self._page.isVisible() or not self._page.isEnabled():
            return False
        if not event.isAutoRepeat() and self._down is None:
            self._down = event.key()
            self._holder.press(phoneme)
        return True

    def _let_go(self) -> None:
        if self._down is not None:
            self._down = None
            self._holder.release()


class LetterPassthrough(QObject):
    """Leaves the phonemes' letters to the window, where a list would search for them."""

    def eventFilter(self, _watched: QObject, event: Any) -> bool:
        """Refuse letters."""
        if event.type() not in _KEY_EVENTS or event.key() not in PHONEME_OF:
            return False
        if event.modifiers() != Qt.KeyboardModifier.NoModifier or isinstance(QApplication.focusWidget(), QLineEdit):
            return False
        event.ignore()
        return True
