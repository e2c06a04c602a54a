"""The head, and beside it another one that says the same by other means; each says what moves it."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QWidget

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.head.face_model import MovingHead
from phonemeanalyser.desktop.talk.head.head_view import LIGHT_STEP, HeadView
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column, named, row, spoken_button, tool_button
from phonemeanalyser.desktop.widgets.labels import ElidedLabel
from phonemeengine.mouth.head import Framing


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
        self.caption = named(ElidedLabel(), tr("Driver of the head"))
        self.caption.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.caption.setContentsMargins(6, 2, 6, 2)
        self.caption.setStyleSheet(f"background: {theme.base}")
        column((self.view, 1), self.caption, on=self, spacing=0)

    def show_state(self) -> None:
        """Say what moves it."""
        self.caption.setText(tr_engine(self._head.caption))
        self.caption.setToolTip("\n".join((self.caption.text(), *self._head.notes)))
        self.caption.setVisible(bool(self._head.caption))


class HeadPair(QWidget):
    """One head, or two in step, of which both are looked at alike.

    Attributes
    ----------
    main, beside : the heads.
    looks : what changes how they are looked at, for a row of controls: wireframe, light and the way back.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self.main, self.beside = CaptionedHead(talking.head, theme), CaptionedHead(talking.beside, theme)
        row((self.main, 1), (self.beside, 1), on=self, spacing=1)
        self.wireframe = named(QCheckBox(tr("Wireframe")), tip=tr("Draw only the edges of the mesh (W)"))
        self.light_left = spoken_button("☀ ◂", tr("Move the light to the left (,)"))
        self.light_right = spoken_button("▸", tr("Move the light to the right (.)"))
        self.framings = {
            Framing.MOUTH: tool_button(tr("Mouth"), tr("Show the mouth from the front")),
            Framing.FACE: tool_button(tr("Face"), tr("Show the whole head from the front (Home or double-click)")),
            Framing.BUST: tool_button(tr("Bust"), tr("Show head and shoulders from the front")),
        }
        self.looks = (self.wireframe, self.light_left, self.light_right, *self.framings.values())
        self._connect()
        self.main.view.looked.connect(lambda: self._look_alike(self.main.view, self.beside.view))
        self.beside.view.looked.connect(lambda: self._look_alike(self.beside.view, self.main.view))
        talking.changed.connect(self._show_state)
        self._show_state()

    def refresh(self) -> None:
        """Show the faces as they are now."""
        self.main.view.refresh()
        if self._talking.comparing:
            self.beside.view.refresh()

    def _connect(self) -> None:
        head = self.main.view
        self.framings[Framing.MOUTH].clicked.connect(lambda _checked: head.go_home(Framing.MOUTH))
        self.framings[Framing.FACE].clicked.connect(lambda _checked: head.go_home())
        self.framings[Framing.BUST].clicked.connect(lambda _checked: head.go_home(Framing.BUST))
        self.wireframe.toggled.connect(lambda on: head.look(wireframe=on))
        self.light_left.clicked.connect(lambda _checked: head.move_light(-LIGHT_STEP))
        self.light_right.clicked.connect(lambda _checked: head.move_light(LIGHT_STEP))
        head.looked.connect(lambda: self.wireframe.setChecked(head.wireframe))

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
