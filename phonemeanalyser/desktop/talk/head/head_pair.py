"""The head, and beside it another one that says the same by other means; each says what moves it."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.head.face_model import MovingHead
from phonemeanalyser.desktop.talk.head.head_view import HeadView
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column, named, row
from phonemeanalyser.desktop.widgets.labels import ElidedLabel


class CaptionedHead(QWidget):
    """A head with what moves it below, where that is to be said.

    Attributes
    ----------
    view : the head.
    caption : what moves it.
    """

    def __init__(self, head: MovingHead, theme: Theme) -> None:
        super().__init__()
        self._head = head
        self.view = HeadView(head, theme)
        self.caption = named(ElidedLabel(), tr("what moves the head"))
        self.caption.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.caption.setContentsMargins(6, 2, 6, 2)
        self.caption.setStyleSheet(f"background: {theme.base}")
        column((self.view, 1), self.caption, on=self, spacing=0)

    def show_state(self) -> None:
        """Say what moves it."""
        self.caption.setText(tr_engine(self._head.caption))
        self.caption.setToolTip("\n".join((self._head.caption, *self._head.notes)))
        self.caption.setVisible(bool(self._head.caption))


class HeadPair(QWidget):
    """One head, or two in step, of which both are looked at alike.

    Attributes
    ----------
    main, beside : the heads.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self.main, self.beside = CaptionedHead(talking.head, theme), CaptionedHead(talking.beside, theme)
        row((self.main, 1), (self.beside, 1), on=self, spacing=1)
        self.main.view.looked.connect(lambda: self._look_alike(self.main.view, self.beside.view))
        self.beside.view.looked.connect(lambda: self._look_alike(self.beside.view, self.main.view))
        talking.changed.connect(self._show_state)
        self._show_state()

    def refresh(self) -> None:
        """Show the faces as they are now."""
        self.main.view.refresh()
        if self._talking.comparing:
            self.beside.view.refresh()

    def _look_alike(self, one: HeadView, other: HeadView) -> None:
        seen = (one.camera, one.wireframe, one.light)
        if self._talking.comparing and seen != (other.camera, other.wireframe, other.light):
            other.look(camera=one.camera, wireframe=one.wireframe, light=one.light)

    def _show_state(self) -> None:
        shown = self._talking.comparing
        if shown and not self.beside.isVisibleTo(self):
            self.beside.view.copy_view_from(self.main.view)
        self.beside.setVisible(shown)
        for head in (self.main, self.beside):
            head.show_state()
