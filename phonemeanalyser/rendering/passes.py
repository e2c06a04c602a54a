"""The passes in which a picture is drawn: the programs of the graphics card, shadow, backdrop and smooth edges."""

import math
from collections.abc import Mapping
from functools import lru_cache
from hashlib import blake2b
from pathlib import Path
from typing import Any

import moderngl
import numpy as np

from phonemeanalyser.rendering import RenderingError
from phonemeanalyser.rendering.camera import BoundingSphere
from phonemeengine.arrays import BoolArray, Float32Array, Float64Array
from phonemeengine.mouth.mesh import Mesh

# The programs that run on the graphics card, and how they are fed.

SHADERS = Path(__file__).with_name("shaders")
VERSION = "#version 330 core\n"
LIT = {"head", "material"}
"""Fragment shaders that stand in the light of the studio."""
CORNERS = (-1.0, -1.0, 3.0, -1.0, -1.0, 3.0)
"""One triangle that covers the picture."""


def program_of(context: moderngl.Context, vertex: str, fragment: str, known: str = "") -> moderngl.Program:
    """Build a program of a vertex and a fragment shader, which both know how the head turns.

    Parameters
    ----------
    known : constants that the fragment shader uses.

    Raises
    ------
    RenderingError : the graphics driver refuses it.
    """
    turned, above, below = [
        (SHADERS / f"{name}.glsl").read_text() for name in ("turned", f"{vertex}_vertex", f"{fragment}_fragment")
    ]
    if fragment in LIT:
        below = (SHADERS / "studio.glsl").read_text() + below
    try:
        return context.program(vertex_shader=VERSION + turned + above, fragment_shader=VERSION + known + below)
    except moderngl.Error as error:
        raise RenderingError(
            f"the graphics driver refuses the program's shaders ({str(error).splitlines()[0]}); update the driver"
        ) from error


def full_screen(context: moderngl.Context, program: moderngl.Program) -> tuple[moderngl.Buffer, moderngl.VertexArray]:
    """Return the corners of a triangle that covers the picture, and how a program whose vertex has one draws it."""
    corners = context.buffer(np.array(CORNERS, "f4").tobytes())
    return corners, context.vertex_array(program, [(corners, "2f", "in_corner")])


def fields_of(buffer: moderngl.Buffer, fields: Mapping[str, str], known: set[str]) -> tuple[Any, ...]:
    """Return which attributes of a program a buffer's fields are; those that it does not use are skipped."""
    layout = " ".join(kind if name in known else f"{4 * int(kind[0])}x" for name, kind in fields.items())
    return (buffer, layout, *(name for name in fields if name in known))


def set_uniforms(program: moderngl.Program, values: Mapping[str, Any]) -> None:
    """Set those of some uniforms that a program uses; a matrix is given with its columns as rows."""
    for name, value in values.items():
        uniform = program.get(name, None)
        if isinstance(uniform, moderngl.Uniform):
            uniform.write(np.ascontiguousarray(value, "f4").tobytes())


# What pictures are drawn on before they are shown: with several samples in each pixel, against jagged edges.


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
                f"the graphics driver has no memory for a picture of {size[0]}x{size[1]} pixels; make it smaller"
            ) from error
        return self._made

    def _colours_of(self, size: tuple[int, int]) -> moderngl.Texture | moderngl.Renderbuffer:
        if self._samples:
            return self._context.renderbuffer(size, 4, samples=self._samples)
        texture = self._context.texture(size, 4)
        texture.repeat_x = texture.repeat_y = False
        return texture

    def release(self) -> None:
        """Free what the graphics driver holds."""
        if self._made is not None:
            for part in (*self._made.color_attachments, self._made.depth_attachment, self._made):
                part.release()
        self._made = None


# What is behind a head: the colour of the background, with a soft glow amid it.

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
        """Free all that the graphics driver holds."""
        for part in (self._array, self._program, self._corners):
            part.release()


# The key light's shadow: how far it is from the light to the first thing that it meets.

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

    def open(self) -> None:
        """Have what is drawn next cast it."""
        self._dark_room.use()
        self._dark_room.clear(depth=1.0)

    def use(self) -> None:
        """Have shaders find it as texture 0."""
        self._texture.use(0)

    def release(self) -> None:
        """Free what the graphics driver holds."""
        self._dark_room.release()
        self._texture.release()


def taps_of(n: int, radius: float) -> str:
    """Return places that are spread evenly over a disc (Vogel's spiral), as a constant of a shader."""
    away = [radius * math.sqrt((k + 0.5) / n) for k in range(n)]
    places = (f"vec2({r * math.cos(k * GOLDEN):.6f}, {r * math.sin(k * GOLDEN):.6f})" for k, r in enumerate(away))
    return f"const vec2 TAPS[{n}] = vec2[]({', '.join(places)});\n"


# How open each place of a mesh is to the light around it: not at all in a closed mouth, little in a nostril.

N_DIRECTIONS = 40
SIZE = 192
"""Pixels along the edge of what is seen from each direction."""
THICKNESS = 0.012
"""What lies no deeper than this, as a share of the depth of all, is seen."""


def ambient_occlusion(
    context: moderngl.Context, array: moderngl.VertexArray, mesh: Mesh, n_corners: int
) -> Float32Array:
    """Look at a mesh from all around, and say how much of what each vertex faces it can see.

    Parameters
    ----------
    array : draws the mesh at rest with the matrix `camera`.
    n_corners : of its triangles, the first ones, that hide anything.

    Returns
    -------
    float32, shape (n_vertices,), 0..1; of a mesh that was looked at lately, what was seen then.
    """
    content = b"".join(part.tobytes() for part in (mesh.positions, mesh.normals, mesh.triangles))
    kept = _kept(blake2b(content).digest(), n_corners)
    if not kept:
        kept.append(_look_around(context, array, mesh, n_corners))
    return kept[0]


@lru_cache(maxsize=4)
def _kept(_digest: bytes, _n_corners: int) -> list[Float32Array]:
    """Return the place for what is seen of a mesh, empty at first."""
    return []


def _look_around(context: moderngl.Context, array: moderngl.VertexArray, mesh: Mesh, n_corners: int) -> Float32Array:
    depths = context.depth_texture((SIZE, SIZE))
    dark_room, room = context.framebuffer(depth_attachment=depths), BoundingSphere.around(mesh)
    seen, faced = np.zeros(len(mesh)), np.full(len(mesh), 1e-6)
    dark_room.use()
    for towards in _directions():
        view = room.seen_from(towards)
        cosines = np.maximum(mesh.normals @ towards, 0.0)
        dark_room.clear(depth=1.0)
        set_uniforms(array.program, {"camera": view.T})
        array.render(vertices=n_corners)
        picture = np.frombuffer(depths.read(), np.float32).reshape(SIZE, SIZE)
        seen += cosines * _in_front(picture, mesh.positions, view)
        faced += cosines
    dark_room.release()
    depths.release()
    return np.asarray(seen / faced, np.float32)


def _directions() -> Float64Array:
    """Return directions that are spread evenly (a Fibonacci lattice), shape (N_DIRECTIONS, 3)."""
    place = np.arange(N_DIRECTIONS) + 0.5
    height = 1 - 2 * place / N_DIRECTIONS
    turn = place * math.pi * (3 - math.sqrt(5))
    flat = np.sqrt(1 - height**2)
    return np.column_stack((flat * np.cos(turn), height, flat * np.sin(turn)))


def _in_front(picture: Float32Array, positions: Float32Array, view: Float32Array) -> BoolArray:
    """Tell which points nothing hides in a picture of depths."""
    x, y, depth = (positions @ view[:3, :3].T + view[:3, 3]).T * 0.5 + 0.5
    column, row = (np.clip(at * SIZE, 0, SIZE - 1).astype(np.intp) for at in (x, y))
    return np.asarray(depth <= picture[row, column] + THICKNESS)


# Pictures with one sample a pixel, made smooth at their edges: a third of what more samples cost a processor.


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
        """Free all that the graphics driver holds."""
        for part in (self._array, self._program, self._corners):
            part.release()
