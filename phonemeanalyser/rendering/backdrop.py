"""What is behind a head: the colour of the background, with a soft glow amid it."""

import moderngl
import numpy as np

from phonemeanalyser.rendering.shader_programs import program_of, set_uniforms

GLOW, SHARE = (0.55, 0.62, 0.74), 0.26
"""The colour of the glow, and how much of it there is amid the picture."""
CORNERS = (-1.0, -1.0, 3.0, -1.0, -1.0, 3.0)
"""One triangle that covers the picture."""


class Backdrop:
    """Paints a picture before anything else is drawn into it; the corners keep the colour of the background."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._corners = context.buffer(np.array(CORNERS, "f4").tobytes())
        self._program = program_of(context, "backdrop", "backdrop")
        self._array = context.vertex_array(self._program, [(self._corners, "2f", "in_corner")])

    def draw(self, background: tuple[float, float, float]) -> None:
        """Paint all of the framebuffer in use; `background` is sRGB, 0..1."""
        glow = [(1 - SHARE) * one + SHARE * other for one, other in zip(background, GLOW, strict=True)]
        set_uniforms(self._program, {"background": background, "glow": glow})
        self._context.disable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        self._array.render(moderngl.TRIANGLES)
        self._context.enable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)

    def release(self) -> None:
        """Return everything back to the graphics driver."""
        for part in (self._array, self._program, self._corners):
            part.release()
