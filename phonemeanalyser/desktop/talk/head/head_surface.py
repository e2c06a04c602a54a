"""What a head is drawn on in the window: its OpenGL where there is a graphics card, else pictures."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QImage, QOffscreenSurface, QOpenGLContext, QPainter, QSurfaceFormat
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QWidget
from typing_extensions import override

from phonemeanalyser.rendering import RenderingError, draws_in_software
from phonemeanalyser.rendering.camera import Camera, Light
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.morph_mesh import MorphMesh

GL_RENDERER = 0x1F01
WITHOUT_GL = ("offscreen", "minimal", "vnc", "linuxfb")
"""Qt's platforms that have no OpenGL in their windows."""
MOST_SHARE = 0.7
"""Of the time that goes into pictures which the processor draws: the sound comes first."""
REST_MS = 300
"""Without a change for so long, a picture is drawn again without jagged edges."""
MOST_QUICK_PIXELS, MOST_PIXELS = 200_000, 2_100_000
"""A picture that the processor draws is no larger, while something moves and while nothing does."""


@dataclass(frozen=True, eq=False)
class Scene:
    """What is drawn: a mesh's vertices, how the head is turned, and how it is looked at."""

    morph_mesh: MorphMesh
    positions: Float32Array
    pose: HeadPose
    camera: Camera
    light: Light
    background: tuple[float, float, float]
    wireframe: bool


class _Renderer(Protocol):
    """A `HeadRenderer`, whose module takes a second to load the first time; a window should not stand still then."""

    def draw(
        self,
        camera: Camera,
        positions: Float32Array,
        pose: HeadPose,
        *,
        size: tuple[int, int],
        background: tuple[float, float, float],
        wireframe: bool,
        light: Light,
        glow: bool,
    ) -> None: ...

    def release(self) -> None: ...


class _PictureTaker(Protocol):
    """An `OffscreenRenderer`, which is loaded with that."""

    def resize(self, size: tuple[int, int]) -> None: ...

    def picture(
        self,
        camera: Camera,
        positions: Float32Array,
        pose: HeadPose,
        *,
        background: tuple[float, float, float],
        wireframe: bool,
        light: Light,
        fine: bool,
        glow: bool,
    ) -> UInt8Array: ...

    def release(self) -> None: ...


def load_rendering() -> tuple[Callable[[MorphMesh], _Renderer], Callable[[MorphMesh], _PictureTaker]]:
    """Return what makes a renderer in the OpenGL context that is current, and what makes one without a window."""
    from phonemeanalyser.rendering.renderer import HeadRenderer, OffscreenRenderer, window_context  # noqa: PLC0415

    return lambda morph_mesh: HeadRenderer(window_context(), morph_mesh), OffscreenRenderer


def has_graphics_card() -> bool:
    """Return whether the windows' OpenGL is one that a graphics card draws."""
    if QGuiApplication.platformName() in WITHOUT_GL:
        return False
    context, surface = QOpenGLContext(), QOffscreenSurface()
    surface.create()
    if not (context.create() and surface.isValid() and context.makeCurrent(surface)):
        return False
    name = str(context.functions().glGetString(GL_RENDERER))
    context.doneCurrent()
    return not draws_in_software(name)


class GlSurface(QOpenGLWidget):
    """Draws with the window's OpenGL.

    Signals
    -------
    error : a sentence; nothing can be drawn here.
    """

    error = Signal(str)

    def __init__(self, scene: Callable[[], Scene | None]) -> None:
        super().__init__()
        form = QSurfaceFormat()
        form.setVersion(3, 3)
        form.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
        form.setDepthBufferSize(24)
        self.setFormat(form)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.n_drawn = 0
        self.due = 0.0
        self._scene = scene
        self._morph_mesh: MorphMesh | None = None
        self._renderer: _Renderer | None = None

    @override
    def initializeGL(self) -> None:
        self._morph_mesh, self._renderer = None, None
        self.context().aboutToBeDestroyed.connect(self._leave)

    @override
    def paintGL(self) -> None:
        scene = self._scene()
        if scene is None:
            return
        scale = self.devicePixelRatio()
        size = (max(1, round(self.width() * scale)), max(1, round(self.height() * scale)))
        try:
            self._renderer_of(scene.morph_mesh).draw(
                scene.camera,
                scene.positions,
                scene.pose,
                size=size,
                background=scene.background,
                wireframe=scene.wireframe,
                light=scene.light,
                glow=True,
            )
            self.n_drawn += 1
        except RenderingError as error:
            self.error.emit(str(error))

    def redraw(self) -> None:
        """Draw anew, since something is different."""
        self.update()

    def release_gl(self) -> None:
        """Free all that the graphics driver holds."""
        if self._renderer is not None:
            self.makeCurrent()
            self._leave()
            self.doneCurrent()

    def _leave(self) -> None:
        if self._renderer is not None:
            self._renderer.release()
        self._renderer = self._morph_mesh = None

    def _renderer_of(self, morph_mesh: MorphMesh) -> _Renderer:
        if self._renderer is None or morph_mesh is not self._morph_mesh:
            self._leave()
            in_window, _ = load_rendering()
            self._renderer, self._morph_mesh = in_window(morph_mesh), morph_mesh
        return self._renderer


class PictureSurface(QWidget):
    """Has pictures drawn without the window's OpenGL, and shows them.

    Signals
    -------
    error : a sentence; nothing can be drawn here.

    Attributes
    ----------
    due : when the next picture may be drawn, on the clock of `time.monotonic`.
    """

    error = Signal(str)

    def __init__(self, scene: Callable[[], Scene | None]) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.n_drawn = 0
        self.due = 0.0
        self._stale, self._fine = True, False
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(self._draw_finely)
        self._scene = scene
        self._morph_mesh: MorphMesh | None = None
        self._offscreen: _PictureTaker | None = None
        self._image: QImage | None = None

    def redraw(self) -> None:
        """Draw anew, since something is different."""
        self._stale = True
        self.update()

    @override
    def resizeEvent(self, _event: Any) -> None:
        self._stale = True

    @override
    def paintEvent(self, _event: Any) -> None:
        """Draw what is different quickly, and finely once nothing moves any more; else show the same again."""
        fine = not self._stale and self._fine
        if self._stale or fine:
            self._stale = self._fine = False
            began = time.monotonic()
            scene = self._scene()
            self._image = self._image_of(scene, fine=fine) if scene is not None else None
            now = time.monotonic()
            self.due = now + (now - began) * (1 / MOST_SHARE - 1)
            if not fine and self._image is not None:
                self._rest.start(REST_MS)
        painter = QPainter(self)
        if self._image is None:
            painter.fillRect(self.rect(), self.palette().base())
            return
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(self.rect(), self._image)

    def _draw_finely(self) -> None:
        self._fine = True
        self.update()

    def release_gl(self) -> None:
        """Free all that the graphics driver holds."""
        self._rest.stop()
        if self._offscreen is not None:
            self._offscreen.release()
        self._offscreen = self._morph_mesh = None

    def _image_of(self, scene: Scene, *, fine: bool) -> QImage | None:
        width, height = self._size(MOST_PIXELS if fine else MOST_QUICK_PIXELS)
        try:
            offscreen = self._offscreen_of(scene.morph_mesh)
            offscreen.resize((width, height))
            picture = offscreen.picture(
                scene.camera,
                scene.positions,
                scene.pose,
                background=scene.background,
                wireframe=scene.wireframe,
                light=scene.light,
                fine=fine,
                glow=True,
            )
        except RenderingError as error:
            self.error.emit(str(error))
            return None
        self.n_drawn += 1
        image = QImage(picture.tobytes(), width, height, 3 * width, QImage.Format.Format_RGB888)
        return image.convertToFormat(QImage.Format.Format_RGB32)  # which is painted in half the time

    def _size(self, most: int) -> tuple[int, int]:
        scale = self.devicePixelRatio()
        width, height = max(1.0, self.width() * scale), max(1.0, self.height() * scale)
        less = min(1.0, (most / (width * height)) ** 0.5)
        return max(1, round(width * less)), max(1, round(height * less))

    def _offscreen_of(self, morph_mesh: MorphMesh) -> _PictureTaker:
        if self._offscreen is None or morph_mesh is not self._morph_mesh:
            self.release_gl()
            _, without_window = load_rendering()
            self._offscreen, self._morph_mesh = without_window(morph_mesh), morph_mesh
        return self._offscreen
