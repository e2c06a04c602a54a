"""Draws a head with OpenGL 3.3, in a window or into a picture."""

import sys
from contextlib import ExitStack
from dataclasses import dataclass
from functools import lru_cache
from types import TracebackType
from typing import Any

import moderngl
import numpy as np

from phonemeanalyser.rendering import RenderingError, draws_in_software, passes
from phonemeanalyser.rendering.camera import (
    LIGHT,
    BoundingSphere,
    Camera,
    Light,
    NeckPivot,
    direction_of,
    rotation_of,
)
from phonemeanalyser.rendering.materials import KINDS, MaterialPass, draw_calls_of, with_pixels
from phonemeanalyser.rendering.surface import Surface, specular_mask
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.mesh import AlphaMode
from phonemeengine.mouth.morph_mesh import MorphMesh

PROGRAMS = {
    "wire": ("head", "wire"),
    "plain": ("plain", "plain"),
    "inside": ("inside", "inside"),
    "shadow": ("plain", "plain"),
}
"""The vertex and the fragment shader of each; those that draw skin are more, one for each finish."""
FILL, RIMS = (0.9, 0.1), ((2.35, 0.25), (-2.2, 0.35))
"""Azimuth and elevation of the other lights, radians, as the viewer sees them."""
INSIDE = (0.13, 0.055, 0.05)
"""What is seen from its back, such as the cheeks through an open mouth."""
LINES = ((0.10, 0.12, 0.16), (0.90, 0.92, 0.96))
"""Wires on a bright and on a dark background."""
LIFT = 0.01
"""How far above the skin its shadow is looked up, as a share of the radius of all: skin casts none on itself."""
EXPOSURES = (1.0, 0.62)
"""How much light is seen: on the heads of the program, and on faces of a file, which may be white."""
BLENDING = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA, moderngl.ONE, moderngl.ONE_MINUS_SRC_ALPHA
"""What is blended, with how much of what is behind it: colours, and how opaque the picture is."""
STILL = HeadPose()
NOTHING = (0.0, 0.0, 0.0)
"""The colour behind heads in pictures that are transparent there."""

Colour = tuple[float, float, float]
"""Red, green, blue in 0..1 (sRGB)."""


@dataclass(frozen=True)
class RenderQuality:
    """How much trouble is taken over a picture.

    Attributes
    ----------
    name : of its program.
    samples : of each pixel, against jagged edges; 0 for one, whose edges are smoothed afterwards.
    shadow : pixels along the edge of the key light's shadow.
    taps : how often each point looks whether it lies in the shadow, as few as can be.
    penumbra : radius of the places where it looks, as a share of the shadow's edge.
    """

    name: str
    samples: int
    shadow: int
    taps: int
    penumbra: float

    @property
    def constants(self) -> str:
        """What fragment shaders know of it."""
        return passes.taps_of(self.taps, self.penumbra)


QUICK, FINE = RenderQuality("quick", 0, 384, 2, 0.0025), RenderQuality("fine", 4, 1024, 8, 0.0055)


def colour_of(text: str) -> Colour:
    """Return the colour that #rrggbb stands for."""
    red, green, blue = bytes.fromhex(text.removeprefix("#"))
    return red / 255, green / 255, blue / 255


class HeadRenderer:
    """Draws a mesh; lives as long as its context.

    Parameters
    ----------
    context : of OpenGL 3.3 core or newer: ``moderngl.create_context(require=330)`` in a window.
    morph_mesh : whose mesh is drawn.

    Raises
    ------
    RenderingError : the mesh has no triangles, or the graphics driver refuses the shaders.
    """

    def __init__(self, context: moderngl.Context, morph_mesh: MorphMesh) -> None:
        self._context, self._mesh = context, with_pixels(morph_mesh.mesh)
        if not len(morph_mesh.mesh.triangles):
            raise RenderingError("the mesh has no triangles, so there is nothing to be seen; choose another one")
        self._room = BoundingSphere.around(morph_mesh.mesh)
        self._surface, self._neck = Surface(morph_mesh.mesh), NeckPivot.of(morph_mesh.mesh)
        self._canvases = {finish: passes.Canvas(context, finish.samples) for finish in (QUICK, FINE)}
        self._shadows: dict[RenderQuality, passes.Shadow] = {}
        self._moving = context.buffer(reserve=len(morph_mesh.mesh) * 24, dynamic=True)
        self._looks = context.buffer(reserve=len(morph_mesh.mesh) * 20)
        order, self._calls = draw_calls_of(self._mesh)
        self._corners = context.buffer(self._mesh.triangles[order].astype("u4").tobytes())
        self._places = context.buffer(self._mesh.uvs.astype("f4").tobytes())
        self._programs = {name: passes.program_of(context, *shaders) for name, shaders in PROGRAMS.items()}
        for finish in (QUICK, FINE):
            self._programs[finish.name] = passes.program_of(context, "head", "head", finish.constants)
        self._backdrop, self._smoothing = passes.Backdrop(context), passes.EdgeSmoothing(context)
        self._arrays = {name: self._array_of(program) for name, program in self._programs.items()}
        self._materials = MaterialPass(context, self._array_of)
        self._look_at_mesh()

    def draw(
        self,
        camera: Camera,
        positions: Float32Array,
        pose: HeadPose = STILL,
        *,
        size: tuple[int, int],
        background: Colour | None,
        wireframe: bool = False,
        light: Light = LIGHT,
        fine: bool = True,
        glow: bool = False,
        target: moderngl.Framebuffer | None = None,
    ) -> None:
        """Draw one picture, over whatever was there.

        Parameters
        ----------
        camera : where it is looked at from.
        positions : float32, shape (n_vertices, 3): what `MovestateSet.morphed` gives.
        pose : how the head is turned.
        size : width and height, pixels of the framebuffer (not of the screen's logical ones).
        background : behind the head; None for nothing, so that the picture is transparent there.
        wireframe : the edges of the triangles alone, those that nothing hides.
        light : the light that it stands in.
        fine : with several samples a pixel and soft shadows, which takes longer where there is no graphics card.
        glow : whether a soft light stands behind the head, which ends before the picture does.
        target : what the picture goes to; the framebuffer that is bound, where it is None (right for a
            QOpenGLWidget).

        Raises
        ------
        RenderingError : the driver has no memory for a picture of this size.
        """
        target = target or self._context.detect_framebuffer()
        finish = FINE if fine else QUICK
        canvas = self._canvases[finish].of(size)
        self._move(positions)
        lit = self._set_uniforms(camera, pose, size, light, background or NOTHING, finish)
        self._context.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        self._context.depth_func, self._context.cull_face = "<", "back"
        if not wireframe:
            self._cast_shadow(finish, lit)
        canvas.use()
        canvas.clear(*(background or NOTHING), float(background is not None), depth=1.0)
        if wireframe:
            self._draw_wires(background or NOTHING)
        else:
            self._draw_solid(finish, lit)
            if glow and background is not None:
                self._backdrop.draw(background)
            self._draw_blended(finish, lit, canvas)
        if finish.samples:
            self._context.copy_framebuffer(target, canvas)
        else:
            self._smoothing.paint(canvas, target, camera.place_of(positions, size))
        target.use()

    def release(self) -> None:
        """Free all that the graphics driver holds; its context must be current."""
        for array, program in zip(self._arrays.values(), self._programs.values(), strict=True):
            array.release()
            program.release()
        self._materials.release()
        for buffer in (self._corners, self._moving, self._looks, self._places):
            buffer.release()
        self._backdrop.release()
        self._smoothing.release()
        for shadow in self._shadows.values():
            shadow.release()
        for canvas in self._canvases.values():
            canvas.release()

    def _look_at_mesh(self) -> None:
        """Find out what stays: colours, where it is wet, and how open it is to the light."""
        mesh = self._mesh
        self._move(mesh.positions)
        self._context.enable_only(moderngl.DEPTH_TEST)
        passes.set_uniforms(
            self._programs["shadow"], {"turn": np.eye(3), "pivot": self._neck.pivot, "stem": self._neck.stem}
        )
        openness = passes.ambient_occlusion(
            self._context, self._arrays["shadow"], mesh, self._n_corners(AlphaMode.BLEND)
        )
        looks = np.column_stack((np.square(mesh.colours), specular_mask(mesh), openness))
        self._looks.write(looks.astype("f4").tobytes())

    def _move(self, positions: Float32Array) -> None:
        moved = np.empty((len(positions), 6), np.float32)
        moved[:, :3], moved[:, 3:] = positions, self._surface.normals(positions)
        self._moving.write(moved)

    def _n_corners(self, mode: AlphaMode) -> int:
        """Return how many corners are drawn before those of a kind of transparency, and of what comes after it."""
        later = KINDS[KINDS.index(mode) :]
        return sum(call.n for call in self._calls if call.mode not in later)

    def _cast_shadow(self, finish: RenderQuality, lit: dict[str, Any]) -> None:
        if finish not in self._shadows:
            self._shadows[finish] = passes.Shadow(self._context, finish.shadow)
        self._shadows[finish].open()
        if opaque := self._n_corners(AlphaMode.MASK):
            self._arrays["shadow"].render(vertices=opaque)
        for call in self._calls:
            if call.mode is AlphaMode.MASK:
                self._materials.cut_out(call, lit | {"camera": lit["key_view"]})
        self._shadows[finish].use()

    def _draw_solid(self, finish: RenderQuality, lit: dict[str, Any]) -> None:
        """Draw all that lets nothing through, and the inside of what has one side and can be looked into."""
        for call in self._calls:
            if call.material is None:
                self._arrays[finish.name].render(vertices=call.n, first=call.first)
            else:
                self._materials.draw(call, finish.constants, lit)
        self._context.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        self._context.cull_face = "front"
        if hollow := sum(one.n for one in self._calls if one.mode is AlphaMode.OPAQUE and not one.two_sided):
            self._arrays["inside"].render(vertices=hollow)
        self._context.cull_face = "back"

    def _draw_blended(self, finish: RenderQuality, lit: dict[str, Any], canvas: moderngl.Framebuffer) -> None:
        """Draw what something shines through, over all else, in the order of the file."""
        self._context.depth_func = "<"
        self._context.blend_func = BLENDING  # type: ignore[assignment] # four numbers are right, too
        canvas.depth_mask = False
        for call in self._calls:
            if call.mode is AlphaMode.BLEND:
                self._materials.draw(call, finish.constants, lit, blended=True)
        canvas.depth_mask = True
        self._context.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)

    def _draw_wires(self, background: Colour) -> None:
        """Draw the edges that nothing hides: the skin itself has the colour of the background."""
        passes.set_uniforms(self._programs["plain"], {"paint": background})
        self._context.polygon_offset = 1.0, 1.0
        self._arrays["plain"].render()
        self._context.polygon_offset = 0.0, 0.0
        self._context.wireframe = True
        self._arrays["wire"].render()
        self._context.wireframe = False

    def _array_of(self, program: moderngl.Program) -> moderngl.VertexArray:
        buffers = [
            (self._moving, {"in_position": "3f", "in_normal": "3f"}),
            (self._looks, {"in_colour": "3f", "in_wetness": "1f", "in_openness": "1f"}),
            (self._places, {"in_place": "2f"}),
        ]
        parts = [passes.fields_of(buffer, fields, set(program)) for buffer, fields in buffers]
        used = [part for part in parts if len(part) > 2]
        return self._context.vertex_array(program, used, self._corners, index_element_size=4)

    def _set_uniforms(
        self,
        camera: Camera,
        pose: HeadPose,
        size: tuple[int, int],
        light: Light,
        background: Colour,
        finish: RenderQuality,
    ) -> dict[str, Any]:
        """Give all programs what a picture has in common, and return it, for those of materials."""
        view, lights = camera.matrix(size[0] / size[1]), _lights_of(camera, light, self._room)
        turning = {"turn": rotation_of(pose).T, "pivot": self._neck.pivot, "stem": self._neck.stem}
        seen = turning | {"camera": view.T}
        exposure = EXPOSURES[bool(self._mesh.materials)]
        lit = seen | lights | {"lift": LIFT * self._room.radius, "exposure": exposure}
        passes.set_uniforms(self._programs[finish.name], lit)
        passes.set_uniforms(self._programs["plain"], seen)
        passes.set_uniforms(self._programs["inside"], seen | {"paint": INSIDE, "eye": camera.eye})
        passes.set_uniforms(self._programs["wire"], seen | {"paint": LINES[sum(background) < 1.5]})
        passes.set_uniforms(self._programs["shadow"], turning | {"camera": lights["key_view"]})
        return lit


@lru_cache(maxsize=4)
def _lights_of(camera: Camera, light: Light, room: BoundingSphere) -> dict[str, Any]:
    """Return the uniforms of the light, which stay while the camera does not move."""
    key = direction_of(camera, light.azimuth, light.elevation)
    return {
        "key": key,
        "key_view": room.seen_from(key).T,
        "fill": direction_of(camera, *FILL),
        "eye": camera.eye,
        "rims": [direction_of(camera, *rim) for rim in RIMS],
        "strength": light.strength,
    }


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
