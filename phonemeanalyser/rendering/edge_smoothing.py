"""Pictures with one sample a pixel, made smooth at their edges: a third of what more samples cost a processor."""

import moderngl

from phonemeanalyser.rendering.shader_programs import full_screen, program_of


class EdgeSmoothing:
    """Paints what was drawn into another framebuffer, blurred along its edges and nowhere else."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._program = program_of(context, "backdrop", "smoothing")
        self._corners, self._array = full_screen(context, self._program)

    def paint(self, picture: moderngl.Texture, target: moderngl.Framebuffer) -> None:
        """Paint all of the target, which is as large as the picture."""
        target.use()
        picture.use(0)
        self._context.disable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        self._array.render(moderngl.TRIANGLES)

    def release(self) -> None:
        """Return everything back to the graphics driver."""
        for part in (self._array, self._program, self._corners):
            part.release()
