"""Pictures of a head without a window."""

import sys
from contextlib import ExitStack
from types import TracebackType
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from engine.mouth.face import Figure
from engine.mouth.head_motion import HeadPose
from engine.mouth.mesh import Vectors
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.errors import RenderingError
from phonemeanalyser.rendering.light import LIGHT, Light
from phonemeanalyser.rendering.renderer import STILL, Colour, HeadRenderer

SHADOW = 1024
"""Pixels along the edge of the shadow: more than a window has, since there is time."""

Picture = NDArray[np.uint8]
"""Shape (height, width, 3): red, green, blue (sRGB), the first row at the top."""


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
        reason = (str(error).strip() or type(error).__name__).splitlines()[0]
        raise RenderingError(
            f"pictures need OpenGL 3.3, in software at least, and there is none ({reason}); install a graphics "
            "driver, on Linux the packages libegl1 and libgl1-mesa-dri"
        ) from error


class Photographer:
    """Takes pictures of a figure, antialiased; give the graphics back with `release`, or use it in a ``with``.

    Parameters
    ----------
    figure : whose pictures are taken.
    size : width and height, pixels.

    Raises
    ------
    RenderingError : there is no OpenGL 3.3 on this machine, or no room for pictures of this size.
    """

    def __init__(self, figure: Figure, size: tuple[int, int]) -> None:
        self.size = size
        self._context = offscreen_context()
        with ExitStack() as unless_ready:
            unless_ready.callback(self._context.release)
            with self._context:
                self._plain = _plain(self._context, size)
                self._renderer = HeadRenderer(self._context, figure, shadow=SHADOW)
            unless_ready.pop_all()

    def __enter__(self) -> "Photographer":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()

    def picture(
        self,
        camera: Camera,
        positions: Vectors,
        pose: HeadPose = STILL,
        *,
        background: Colour,
        wireframe: bool = False,
        light: Light = LIGHT,
    ) -> Picture:
        """Take a picture; the arguments are those of `HeadRenderer.draw`."""
        with self._context:
            self._renderer.draw(
                camera, positions, pose, size=self.size, background=background,
                wireframe=wireframe, light=light, target=self._plain,
            )  # fmt: skip
            rows = np.frombuffer(self._plain.read(components=3, alignment=1), np.uint8)
        picture: Picture = rows.reshape(self.size[1], self.size[0], 3)[::-1]
        return picture

    def release(self) -> None:
        """Give everything back to the graphics driver."""
        with self._context:
            self._renderer.release()
        self._context.release()


def _plain(context: moderngl.Context, size: tuple[int, int]) -> moderngl.Framebuffer:
    try:
        return context.framebuffer(context.renderbuffer(size, 4))
    except moderngl.Error as error:
        raise RenderingError(
            f"pictures of {size[0]}x{size[1]} pixels are too large for OpenGL here; make them smaller"
        ) from error
