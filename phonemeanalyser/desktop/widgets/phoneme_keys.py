"""The key of each phoneme: held down, it records a take, or tests a mouth."""

from typing import Any, Protocol

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtWidgets import QApplication, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.widgets.key_filters import is_typed_into
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
