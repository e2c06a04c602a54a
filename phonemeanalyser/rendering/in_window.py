"""A head in a window: drawn by the window's own OpenGL, or beside it into pictures that the window shows."""

import moderngl
import numpy as np

from engine.mouth.face import Figure
from engine.mouth.head_motion import HeadPose
from engine.mouth.mesh import Vectors
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.errors import RenderingError
from phonemeanalyser.rendering.light import LIGHT, Light
from phonemeanalyser.rendering.pictures import offscreen_context
from phonemeanalyser.rendering.renderer import STILL, Colour, HeadRenderer


def renderer_in_window(figure: Figure) -> HeadRenderer:
    """Make a renderer in the OpenGL context that is current, as in a window's `initializeGL`.

    Raises
    ------
    RenderingError : the window's OpenGL is older than 3.3, or refuses the shaders.
    """
    try:
        context = moderngl.create_context(require=330)
    except Exception as error:
        reason = (str(error).strip() or type(error).__name__).splitlines()[0]
        raise RenderingError(f"the window's OpenGL cannot be used ({reason}); update the graphics driver") from error
    return HeadRenderer(context, figure)


class Sketcher:
    """Draws a figure into pictures of any size, one after another, with an OpenGL that needs no window.

    Parameters
    ----------
    figure : who is drawn.

    Raises
    ------
    RenderingError : there is no OpenGL 3.3 on this machine, not even in software.
    """

    def __init__(self, figure: Figure) -> None:
        self._context = offscreen_context()
        self._figure = figure
        self._sheet: moderngl.Framebuffer | None = None
        with self._context:
            self._quick = HeadRenderer(self._context, figure, samples=0)
            self._fine: HeadRenderer | None = None

    def sketch(
        self,
        camera: Camera,
        positions: Vectors,
        pose: HeadPose = STILL,
        *,
        size: tuple[int, int],
        background: Colour,
        wireframe: bool = False,
        light: Light = LIGHT,
        fine: bool = False,
    ) -> bytes:
        """Draw a picture; the arguments are those of `HeadRenderer.draw`.

        Parameters
        ----------
        fine : without jagged edges, which takes longer.

        Returns
        -------
        four bytes for each pixel, red, green, blue and 255; the upper row first.

        Raises
        ------
        RenderingError : the driver has no room for a picture of this size.
        """
        with self._context:
            sheet = self._sheet_of(size)
            if fine and self._fine is None:
                self._fine = HeadRenderer(self._context, self._figure)
            renderer = self._fine if fine and self._fine is not None else self._quick
            renderer.draw(
                camera, positions, pose, size=size, background=background,
                wireframe=wireframe, light=light, target=sheet,
            )  # fmt: skip
            rows = np.frombuffer(sheet.read(components=4, alignment=1), np.uint8)
        return rows.reshape(size[1], -1)[::-1].tobytes()

    def release(self) -> None:
        """Give everything back to the graphics driver."""
        with self._context:
            for renderer in (self._quick, self._fine):
                if renderer is not None:
                    renderer.release()
            self._let_go()
        self._context.release()

    def _sheet_of(self, size: tuple[int, int]) -> moderngl.Framebuffer:
        if self._sheet is None or self._sheet.size != size:
            self._let_go()
            try:
                self._sheet = self._context.framebuffer(self._context.renderbuffer(size, 4))
            except moderngl.Error as error:
                raise RenderingError(
                    f"the graphics driver has no room for {size[0]}x{size[1]} pixels; make the view smaller"
                ) from error
        return self._sheet

    def _let_go(self) -> None:
        if self._sheet is not None:
            self._sheet.color_attachments[0].release()
            self._sheet.release()
            self._sheet = None
