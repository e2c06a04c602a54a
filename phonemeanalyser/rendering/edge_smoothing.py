"""Pictures with one sample a pixel, made smooth at their edges: a third of what more samples cost a processor."""

import moderngl

from phonemeanalyser.rendering.shader_programs import full_screen, program_of


class EdgeSmoothing:
    """Paints what was drawn into another framebuffer, blurred along its edges and nowhere else."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._program = program_of(context, "backdrop", "smoothing")
        self._corners, self._array = full_screen(context, self._program)

    def paint(
        self, picture: moderngl.Framebuffer, target: moderngl.Framebuffer, place: tuple[int, int, int, int]
    ) -> None:
        """Paint all of the target, which is as large as the picture, a texture; edges lie within a place of it.

        Parameters
        ----------
        place : left, lower edge, width and height, pixels: elsewhere nothing is smoothed.
        """
        self._context.copy_framebuffer(target, picture)
        target.use()
        target.scissor = place
        texture = picture.color_attachments[0]
        assert isinstance(texture, moderngl.Texture)
        texture.use(0)
        self._context.disable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        self._array.render(moderngl.TRIANGLES)
        target.scissor = (0, 0, *target.size)

    def release(self) -> None:
        """Return everything back to the graphics driver."""
        for part in (self._array, self._program, self._corners):
            part.release()
