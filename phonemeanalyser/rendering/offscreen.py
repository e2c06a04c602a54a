"""Pictures of a head, drawn with an OpenGL that needs no window."""

import sys
from contextlib import ExitStack
from types import TracebackType
from typing import Any

import moderngl
import numpy as np

from phonemeanalyser.rendering import RenderingError, draws_in_software
from phonemeanalyser.rendering.camera import LIGHT, Camera, Light
from phonemeanalyser.rendering.renderer import STILL, Colour, HeadRenderer
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.morph_mesh import MorphMesh

# OpenGL itself: the window's own, or one without a window.


def offscreen_context() -> moderngl.Context:
    """Make an OpenGL context without a window: by EGL on Linux, which needs no display.

    Raises
    ------
    RenderingError : there is no OpenGL 3.3 on this machine, not even in software.
    """
    backend: dict[str, Any] = {"backend": "egl"} if sys.platform.startswith("linux") else {}
    try:
        return moderngl.create_context(standalone=True, require=330, **backend)
    except Exception as error:
        raise RenderingError(
            f"pictures need OpenGL 3.3, in software at least, and there is none ({_reason(error)}); install a "
            "graphics driver, on Linux the packages libegl1 and libgl1-mesa-dri"
        ) from error


def window_context() -> moderngl.Context:
    """Take the OpenGL context that is current, as in a window's ``initializeGL``.

    Raises
    ------
    RenderingError : the window's OpenGL is older than 3.3.
    """
    try:
        return moderngl.create_context(require=330)
    except Exception as error:
        raise RenderingError(
            f"the window's OpenGL cannot be used ({_reason(error)}); update the graphics driver"
        ) from error


def _reason(error: Exception) -> str:
    return (str(error).strip() or type(error).__name__).splitlines()[0]


USUAL_SIZE = (640, 640)


class OffscreenRenderer:
    """Takes pictures of a mesh; give the graphics back with `release`, or use it in a ``with``.

    Parameters
    ----------
    morph_mesh : whose pictures are taken.
    size : width and height, pixels.

    Attributes
    ----------
    in_software : whether the processor draws, not a graphics card.

    Raises
    ------
    RenderingError : there is no OpenGL 3.3 on this machine, or no room for pictures of this size.
    """

    def __init__(self, morph_mesh: MorphMesh, size: tuple[int, int] = USUAL_SIZE) -> None:
        self._context = offscreen_context()
        with ExitStack() as unless_ready:
            unless_ready.callback(self._context.release)
            with self._context:
                self.in_software = draws_in_software(self._context.info["GL_RENDERER"])
                self._sheet = _sheet(self._context, size)
                self._renderer = HeadRenderer(self._context, morph_mesh)
            unless_ready.pop_all()

    def __enter__(self) -> "OffscreenRenderer":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()

    def resize(self, size: tuple[int, int]) -> None:
        """Take pictures of another width and height, pixels.

        Raises
        ------
        RenderingError : there is no room for pictures of this size.
        """
        if size != self._sheet.size:
            with self._context:
                old, self._sheet = self._sheet, _sheet(self._context, size)
                _let_go(old)

    def picture(
        self,
        camera: Camera,
        positions: Float32Array,
        pose: HeadPose = STILL,
        *,
        background: Colour | None,
        wireframe: bool = False,
        light: Light = LIGHT,
        fine: bool = True,
        glow: bool = False,
    ) -> UInt8Array:
        """Take a picture; the arguments are those of `HeadRenderer.draw`.

        Returns
        -------
        uint8, shape (height, width, 3), where the background is None, with a fourth: how opaque it is.
        """
        width, height = self._sheet.size
        with self._context:
            self._renderer.draw(
                camera,
                positions,
                pose,
                size=(width, height),
                background=background,
                wireframe=wireframe,
                light=light,
                fine=fine,
                glow=glow,
                target=self._sheet,
            )
            n = 4 if background is None else 3
            rows = np.frombuffer(self._sheet.read(components=n, alignment=1), np.uint8)
        picture: UInt8Array = rows.reshape(height, width, n)[::-1]
        return picture if background else _separated(picture)

    def release(self) -> None:
        """Free all that the graphics driver holds."""
        with self._context:
            self._renderer.release()
            _let_go(self._sheet)
        self._context.release()


def _separated(picture: UInt8Array) -> UInt8Array:
    """Return a picture whose colours at edges are those of what is seen, which were mixed with nothing, black."""
    opaque = np.maximum(picture[..., 3:], 1)
    colours = np.minimum(picture[..., :3] * np.float32(255) / opaque, 255)
    return np.concatenate((np.round(colours).astype(np.uint8), picture[..., 3:]), axis=2)


def _sheet(context: moderngl.Context, size: tuple[int, int]) -> moderngl.Framebuffer:
    try:
        return context.framebuffer(context.renderbuffer(size, 4))
    except moderngl.Error as error:
        raise RenderingError(
            f"pictures of {size[0]}x{size[1]} pixels are too large for OpenGL here; make them smaller"
        ) from error


def _let_go(sheet: moderngl.Framebuffer) -> None:
    sheet.color_attachments[0].release()
    sheet.release()
