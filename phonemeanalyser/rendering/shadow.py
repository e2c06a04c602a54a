"""The key light's shadow: how far it is from the light to the first thing that it meets."""

import math

import moderngl

GOLDEN = math.pi * (3 - math.sqrt(5))


class Shadow:
    """What the key light sees.

    Parameters
    ----------
    context : of OpenGL.
    size : pixels along its edge.
    """

    def __init__(self, context: moderngl.Context, size: int) -> None:
        self._texture = context.depth_texture((size, size))
        self._texture.compare_func, self._texture.repeat_x, self._texture.repeat_y = "<=", False, False
        self._dark_room = context.framebuffer(depth_attachment=self._texture)

    def cast(self, array: moderngl.VertexArray) -> None:
        """See what an array draws."""
        self._dark_room.use()
        self._dark_room.clear(depth=1.0)
        array.render()

    def use(self) -> None:
        """Have shaders find it as texture 0."""
        self._texture.use(0)

    def release(self) -> None:
        """Return it back to the graphics driver."""
        self._dark_room.release()
        self._texture.release()


def taps_of(n: int, radius: float) -> str:
    """Return places that are spread evenly over a disc (Vogel's spiral), as a constant of a shader."""
    away = [radius * math.sqrt((k + 0.5) / n) for k in range(n)]
    places = (f"vec2({r * math.cos(k * GOLDEN):.6f}, {r * math.sin(k * GOLDEN):.6f})" for k, r in enumerate(away))
    return f"const vec2 TAPS[{n}] = vec2[]({', '.join(places)});\n"
