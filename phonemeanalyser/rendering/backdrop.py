"""What is behind a head: the colour of the background, with a soft glow amid it."""

import moderngl

from phonemeanalyser.rendering.shader_programs import full_screen, program_of, set_uniforms

GLOW, SHARE = (0.55, 0.62, 0.74), 0.26
"""The colour of the glow, and how much of it there is amid the picture."""


class Backdrop:
    """Paints what nothing hides, after all else is drawn; the corners keep the colour of the background."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._program = program_of(context, "backdrop", "backdrop")
        self._corners, self._array = full_screen(context, self._program)

    def draw(self, background: tuple[float, float, float]) -> None:
        """Paint what is empty of the framebuffer in use; `background` is sRGB, 0..1."""
        glow = [(1 - SHARE) * one + SHARE * other for one, other in zip(background, GLOW, strict=True)]
        set_uniforms(self._program, {"background": background, "glow": glow})
        self._context.depth_func, self._context.cull_face = "<=", "back"  # it lies as far away as can be
        self._array.render(moderngl.TRIANGLES)

    def release(self) -> None:
        """Return everything back to the graphics driver."""
        for part in (self._array, self._program, self._corners):
            part.release()
