"""What pictures are drawn on before they are shown: with several samples in each pixel, against jagged edges."""

import moderngl

from phonemeanalyser.rendering.errors import RenderingError


class Canvas:
    """Gives a framebuffer of the size that is wanted.

    Parameters
    ----------
    context : of OpenGL.
    samples : of each pixel; as many as the driver has, where it has fewer. With 0, what was drawn is a texture.
    """

    def __init__(self, context: moderngl.Context, samples: int) -> None:
        self._context = context
        self._samples = min(samples, context.max_samples)
        self._made: moderngl.Framebuffer | None = None

    def of(self, size: tuple[int, int]) -> moderngl.Framebuffer:
        """Return it with a width and a height, pixels.

        Raises
        ------
        RenderingError : the driver has no room for it.
        """
        if self._made is not None and self._made.size == size:
            return self._made
        self.release()
        try:
            colours = self._colours_of(size)
            depths = self._context.depth_renderbuffer(size, samples=self._samples)
            self._made = self._context.framebuffer(colours, depths)
        except moderngl.Error as error:
            raise RenderingError(
                f"the graphics driver has no room for a picture of {size[0]}x{size[1]} pixels; make it smaller"
            ) from error
        return self._made

    def _colours_of(self, size: tuple[int, int]) -> moderngl.Texture | moderngl.Renderbuffer:
        if self._samples:
            return self._context.renderbuffer(size, 4, samples=self._samples)
        texture = self._context.texture(size, 4)
        texture.repeat_x = texture.repeat_y = False
        return texture

    def release(self) -> None:
        """Return it back to the graphics driver."""
        if self._made is not None:
            for part in (*self._made.color_attachments, self._made.depth_attachment, self._made):
                part.release()
        self._made = None
