"""The head, to be looked at from all sides, and beside it another one that says the same by other means."""

import math
import time
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QEvent, QPointF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QContextMenuEvent, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QCheckBox, QLabel, QSizePolicy, QStackedLayout, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.head import head_surface
from phonemeanalyser.desktop.talk.head.face_model import MovingHead
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import ElidedLabel, column, named, row, spoken_button, tool_button
from phonemeanalyser.desktop.widgets.plot import PlotMenu, table_of
from phonemeanalyser.rendering.camera import LIGHT, Camera, Light
from phonemeengine.mouth.morph_mesh import Framing, MorphMesh

PER_PIXEL = math.radians(0.4)
"""How far a drag of a pixel goes round the head."""
PER_KEY, PAN_PER_KEY = math.radians(8), 0.06
PER_NOTCH = 120
"""Of a wheel, in Qt's eighths of a degree."""
STILL = 3
"""Pixels by which a press may move and still be a click."""
LIGHT_STEP, MOST_LIGHT = math.radians(15), math.radians(75)
ARROWS = {Qt.Key.Key_Left: (-1, 0), Qt.Key.Key_Right: (1, 0), Qt.Key.Key_Up: (0, 1), Qt.Key.Key_Down: (0, -1)}
ZOOMS = {Qt.Key.Key_Plus: 1, Qt.Key.Key_Equal: 1, Qt.Key.Key_Minus: -1}
HINT = tr_noop(
    "Drag to orbit, Shift+drag or right-drag to pan, scroll to zoom. Keys: arrows orbit (with Shift, pan), + "
    "and − zoom, Home resets the view, W toggles the wireframe, comma and full stop move the light"
)


class HeadView(QWidget):
    """Shows the face as it is now; mouse and keys move the camera.

    Signals
    -------
    looked : the view has changed: camera, wireframe or light.

    Attributes
    ----------
    camera : None until there is a face.
    trouble : why no head can be drawn here; empty where it can.
    menu : what a right click offers.
    """

    looked = Signal()

    def __init__(self, head: MovingHead, theme: Theme) -> None:
        super().__init__()
        self.camera: Camera | None = None
        self.light: Light = LIGHT
        self.wireframe = False
        self.trouble = ""
        self.surface: head_surface.GlSurface | head_surface.PictureSurface | None = None
        self._head = head
        background = QColor(theme.base)
        self._background = (background.redF(), background.greenF(), background.blueF())
        self._morph_mesh: MorphMesh | None = None
        self._shown = -1
        self._from: QPointF | None = None
        self._pressed = QPointF()
        self._message = QLabel(tr("Loading head…"))
        self._work = TaskQueue(self._give_up)
        self._lay_out(theme)
        self.menu = PlotMenu(self, "head", lambda _at: self._values())
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.DefaultContextMenu)  # a right drag moves the head
        head.face.changed.connect(self._take_face)
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.setTimerType(Qt.TimerType.PreciseTimer)
        self._later.timeout.connect(self.refresh)

    def refresh(self) -> None:
        """Show the face as it is now, once what draws it is loaded."""
        if self._head.face.morph_mesh is None or self.trouble:
            return
        if self._morph_mesh is None:
            self._take_face()
        if self.surface is None and not self._work.busy:
            self._work.submit(lambda _progress: head_surface.load_rendering(), lambda _loaded: self._begin_drawing())
        if self.surface is None or self._shown == self._head.revision:
            return
        wait = self.surface.due - time.monotonic()
        if wait <= 0:
            self._shown = self._head.revision
            self.surface.redraw()
        elif not self._later.isActive():
            self._later.start(math.ceil(1000 * wait))  # the window's next picture may be too late

    def copy_view_from(self, other: "HeadView") -> None:
        """Look at the head as another view does."""
        self._morph_mesh, self.camera = other._morph_mesh, other.camera
        self.look(wireframe=other.wireframe, light=other.light)

    def look(
        self, *, camera: Camera | None = None, wireframe: bool | None = None, light: Light | None = None
    ) -> None:
        """Look at the head from elsewhere, or in another way."""
        self.camera = camera or self.camera
        self.wireframe = self.wireframe if wireframe is None else wireframe
        self.light = light or self.light
        if self.surface is not None:
            self.surface.redraw()
        self.looked.emit()

    def go_home(self, framing: Framing = Framing.FACE) -> None:
        """Look at the whole head from the front, or at the mouth or the bust, in the usual light."""
        if self._morph_mesh is not None:
            self.look(camera=Camera.facing(self._morph_mesh.mesh, framing), light=LIGHT)

    def release_gl(self) -> None:
        """Free all that the graphics driver holds, and draw no more."""
        self._work.close(CLOSE_TIMEOUT)
        if self.surface is not None:
            self.surface.release_gl()

    @override
    def sizeHint(self) -> QSize:
        return QSize(300, 340)

    # -- Qt's events --------------------------------------------------------------------------------------

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._from = self._pressed = event.position()
        self.setFocus(Qt.FocusReason.MouseFocusReason)

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._from is None or self.camera is None:
            return
        step, self._from = event.position() - self._from, event.position()
        aside = event.buttons() & (Qt.MouseButton.RightButton | Qt.MouseButton.MiddleButton)
        if aside or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            height = max(1, self.height())
            self.look(camera=self.camera.pan(-step.x() / height, step.y() / height))
        else:
            self.look(camera=self.camera.orbit(-step.x() * PER_PIXEL, step.y() * PER_PIXEL))

    @override
    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End; a right click that moved nothing opens the menu."""
        self._from = None
        moved = (event.position() - self._pressed).manhattanLength()
        if event.button() == Qt.MouseButton.RightButton and moved <= STILL:
            self.menu.open_at(event.position().toPoint())

    @override
    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        if event.reason() == QContextMenuEvent.Reason.Keyboard:
            self.menu.open_at(self.rect().center())

    @override
    def mouseDoubleClickEvent(self, _event: QMouseEvent) -> None:
        """Look at the whole head from the front."""
        self.go_home()

    @override
    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.camera is not None:
            self.look(camera=self.camera.zoom(event.angleDelta().y() / PER_NOTCH))
        event.accept()

    @override
    def event(self, event: QEvent) -> bool:
        """Claim the keys that are shortcuts of the window elsewhere."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and self._acts_on(event):
            event.accept()
            return True
        return super().event(event)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self.camera is None or not self._acts_on(event):
            super().keyPressEvent(event)
            return
        key = Qt.Key(event.key())
        if key in ARROWS:
            self._arrow(*ARROWS[key], shift=bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier))
        elif key in ZOOMS:
            self.look(camera=self.camera.zoom(ZOOMS[key]))
        elif key == Qt.Key.Key_Home:
            self.go_home()
        elif key == Qt.Key.Key_W:
            self.look(wireframe=not self.wireframe)
        else:
            self.move_light(LIGHT_STEP if key == Qt.Key.Key_Period else -LIGHT_STEP)

    def move_light(self, angle: float) -> None:
        """Move the light to the right, radians."""
        azimuth = min(max(self.light.azimuth + angle, -MOST_LIGHT), MOST_LIGHT)
        self.look(light=replace(self.light, azimuth=azimuth))

    def _values(self) -> str:
        """Return how far each movestate of the face is on, as a table."""
        states = self._head.face.states
        percentages = {} if states is None else states.percentages
        return table_of({"movestate": list(percentages), "percent": list(percentages.values())})

    # -- inside -------------------------------------------------------------------------------------------

    def _acts_on(self, event: QKeyEvent) -> bool:
        kept = event.modifiers() & (Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier)
        known = (*ARROWS, *ZOOMS, Qt.Key.Key_Home, Qt.Key.Key_W, Qt.Key.Key_Comma, Qt.Key.Key_Period)
        return not kept and event.key() in known

    def _arrow(self, x: int, y: int, *, shift: bool) -> None:
        assert self.camera is not None
        moved = (
            self.camera.pan(-x * PAN_PER_KEY, -y * PAN_PER_KEY)
            if shift
            else self.camera.orbit(x * PER_KEY, y * PER_KEY)
        )
        self.look(camera=moved)

    def _lay_out(self, theme: Theme) -> None:
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(160, 90)  # so that a window of 1024x700 has room for two heads and keys
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setToolTip(tr(HINT))
        self.setAccessibleName(tr("Head"))
        self._message.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._message.setWordWrap(True)
        self._message.setMargin(16)
        self._message.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._message.setStyleSheet(f"color: {theme.faint}; background: {theme.base}")
        self._stack = QStackedLayout(self)
        self._stack.addWidget(self._message)

    def _begin_drawing(self) -> None:
        self._begin(
            head_surface.GlSurface(self._scene)
            if head_surface.has_graphics_card()
            else head_surface.PictureSurface(self._scene)
        )

    def _begin(self, surface: head_surface.GlSurface | head_surface.PictureSurface) -> None:
        """Draw on this one from now on; a failure comes while it paints, and is dealt with afterwards."""
        self.surface = surface
        surface.error.connect(self._fall_back, Qt.ConnectionType.QueuedConnection)
        self._stack.addWidget(surface)
        self._stack.setCurrentWidget(surface)

    def _fall_back(self, sentence: str) -> None:
        """Have pictures drawn where the window's OpenGL failed; say so where these fail as well."""
        failed, self.surface = self.surface, None
        if failed is None:
            return
        self._stack.removeWidget(failed)
        failed.deleteLater()
        if isinstance(failed, head_surface.GlSurface):
            self._begin(head_surface.PictureSurface(self._scene))
            return
        self._give_up(sentence)

    def _give_up(self, sentence: str) -> None:
        self.trouble = tr("The head cannot be shown: {sentence}.").format(sentence=tr_engine(sentence))
        self._message.setText(self.trouble)
        self._stack.setCurrentWidget(self._message)

    def _take_face(self) -> None:
        morph_mesh = self._head.face.morph_mesh
        if morph_mesh is not None and morph_mesh is not self._morph_mesh:
            self._morph_mesh, self.trouble = morph_mesh, ""  # another one may be drawn
            self.look(camera=Camera.facing(morph_mesh.mesh))

    def _scene(self) -> head_surface.Scene | None:
        morph_mesh = self._head.face.morph_mesh
        if morph_mesh is None or self.camera is None:
            return None
        return head_surface.Scene(
            morph_mesh,
            self._head.face.positions(),
            self._head.pose,
            self.camera,
            self.light,
            self._background,
            self.wireframe,
        )


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
        head = self.main.view
        self.wireframe = named(QCheckBox(tr("Wireframe")), tip=tr("Draw only the edges of the mesh (W)"))
        self.light_left = spoken_button(
            "☀ ◂", tr("Move the light to the left (,)"), partial(head.move_light, -LIGHT_STEP)
        )
        self.light_right = spoken_button(
            "▸", tr("Move the light to the right (.)"), partial(head.move_light, LIGHT_STEP)
        )
        self.framings = {
            framing: tool_button(words, tip, act=partial(head.go_home, framing))
            for framing, words, tip in (
                (Framing.MOUTH, tr("Mouth"), tr("Show the mouth from the front")),
                (Framing.FACE, tr("Face"), tr("Show the whole head from the front (Home or double-click)")),
                (Framing.BUST, tr("Bust"), tr("Show head and shoulders from the front")),
            )
        }
        self.looks = (self.wireframe, self.light_left, self.light_right, *self.framings.values())
        self.wireframe.toggled.connect(lambda on: head.look(wireframe=on))
        head.looked.connect(lambda: self.wireframe.setChecked(head.wireframe))
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
