"""What the triangles of a mesh are made of: textures, in which order they are drawn, and by which program."""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from io import BytesIO
from itertools import count
from typing import Any

import moderngl
import numpy as np
from PIL import Image

from phonemeanalyser.rendering import RenderingError
from phonemeanalyser.rendering.passes import program_of, set_uniforms
from phonemeengine.arrays import BoolArray, Float32Array, IndexArray
from phonemeengine.mouth.mesh import AlphaMode, Material, Mesh, Texture, ToonShading

LARGEST = 2048
"""Pixels along an edge: a face that fills a large screen has no more."""
MOST_PIXELS = 32 << 20
"""Of all textures of a face together, in 4 bytes each; where there would be more, all are scaled down."""


def with_pixels(mesh: Mesh) -> Mesh:
    """Return a mesh with its textures decoded, of the materials that its triangles have; it may be so already.

    Raises
    ------
    RenderingError : a texture is damaged.
    """
    used = {*np.unique(mesh.material_of).tolist()} if mesh.materials else set()
    todo = {id(t): t for k in used for t in textures_of(mesh.materials[k]) if t.pixels is None}
    if not todo:
        return mesh
    edge = LARGEST
    while sum(np.prod(_size(texture, edge)) for texture in todo.values()) > MOST_PIXELS:
        edge //= 2
    with ThreadPoolExecutor(2) as pool:
        done = dict(zip(todo, pool.map(lambda texture: _decoded(texture, edge), todo.values()), strict=True))

    def decoded(material: Material) -> Material:
        swapped: dict[str, Any] = {name: _swapped(getattr(material, name), done) for name in MAPS.values()}
        toon = material.toon and replace(material.toon, texture=_swapped(material.toon.texture, done))
        return replace(material, **swapped, toon=toon)

    return replace(mesh, materials=tuple(map(decoded, mesh.materials)))


MAPS = {"BASE_MAP": "texture", "SURFACE_MAP": "surface", "NORMAL_MAP": "normal", "GLOW_MAP": "glow_texture"}
"""What shaders call the textures of a material."""


def maps_of(material: Material) -> dict[str, Texture]:
    """Return the textures of a material, by what shaders call them."""
    found = {key: getattr(material, name) for key, name in MAPS.items()}
    if material.toon is not None:
        found["SHADE_MAP"] = material.toon.texture
        del found["SURFACE_MAP"]
    return {key: texture for key, texture in found.items() if texture is not None}


def textures_of(material: Material) -> Iterable[Texture]:
    """Return the textures of a material that are drawn."""
    return maps_of(material).values()


def upload(context: moderngl.Context, texture: Texture) -> moderngl.Texture:
    """Give a decoded texture to the graphics card, with all smaller ones that distance needs."""
    assert texture.pixels is not None
    height, width, _ = texture.pixels.shape
    made = context.texture((width, height), 4, np.ascontiguousarray(texture.pixels))
    made.build_mipmaps()
    made.filter = moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR
    return made


def _swapped(texture: Texture | None, done: dict[int, Texture]) -> Texture | None:
    return None if texture is None else done.get(id(texture), texture)


def _size(texture: Texture, edge: int) -> tuple[int, int]:
    less = min(1.0, edge / max(texture.width, texture.height, 1))
    return max(1, round(texture.width * less)), max(1, round(texture.height * less))


def _decoded(texture: Texture, edge: int) -> Texture:
    size = _size(texture, edge)
    try:
        with Image.open(BytesIO(texture.content), formats=("PNG", "JPEG")) as image:
            image.draft("RGB", size)  # a JPEG is decoded smaller from the start
            indexed = image.mode == "P" or "transparency" in image.info
            found = image.convert("RGBA") if indexed else image.convert()
        if found.size != size:
            found = found.resize(size, Image.Resampling.BOX, reducing_gap=2.0)
        pixels = np.asarray(found.convert("RGBA"))
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise RenderingError(f"the texture {texture.name!r} cannot be read ({reason}); export it again") from error
    return replace(texture, pixels=pixels)


ALL, NEARLY, HARDLY = 2.0, 0.98, 1 / 255
"""How opaque something is: more than anything, as good as wholly, and so little that it is not seen."""
AROUND = 4
"""Texels around a triangle that are looked at, too: smaller pictures of the texture mix them in."""
KINDS = (AlphaMode.OPAQUE, AlphaMode.MASK, AlphaMode.BLEND)


@dataclass(frozen=True)
class DrawCall:
    """Triangles that are drawn at once.

    Attributes
    ----------
    material : what they are made of; None for skin, whose vertices have all its colours.
    first, n : the place of its first corner, and how many corners there are.
    """

    material: Material | None
    first: int
    n: int

    @property
    def mode(self) -> AlphaMode:
        """How transparent it may be."""
        return AlphaMode.OPAQUE if self.material is None else _mode_of(self.material)

    @property
    def two_sided(self) -> bool:
        """Whether it is seen from behind, too."""
        return self.material is not None and self.material.two_sided


def draw_calls_of(mesh: Mesh) -> tuple[IndexArray, list[DrawCall]]:
    """Return the order in which triangles are drawn, shape (n_triangles,), and what is drawn at once of them.

    Skin comes first, then what else is opaque, cut out, and blended.
    """
    materials, material_of = _split_at_alpha(mesh)
    ranks = [*_ranked(materials)] or [SKIN]
    kinds = sorted({*ranks})
    of_material = np.array([kinds.index(rank) for rank in ranks])
    rank_of = of_material[material_of] if materials else np.zeros(len(mesh.triangles), np.intp)
    order = np.argsort(rank_of, kind="stable")
    ends = 3 * np.cumsum(np.bincount(rank_of, minlength=len(kinds)))
    starts = np.concatenate(([0], ends[:-1]))
    made = [
        DrawCall(materials[number - 1] if number else None, int(start), int(end - start))
        for (_, _, number), start, end in zip(kinds, starts, ends, strict=True)
    ]
    return order, [call for call in made if call.n]


SKIN = 0, 0, 0


def _split_at_alpha(mesh: Mesh) -> tuple[tuple[Material, ...], IndexArray]:
    """Return the materials, and which one each triangle has: what could be blended and never is, is cut out instead.

    What is blended is drawn twice, and avatars often have whole faces so, for a few lashes.
    """
    materials, material_of = [*mesh.materials], mesh.material_of.astype(np.intp)
    for number, material in enumerate(mesh.materials):
        mine = np.flatnonzero(mesh.material_of == number)
        if material.alpha_mode is AlphaMode.BLEND and len(mine):
            material_of[mine[_lets_nothing_through(material, mesh.uvs[mesh.triangles[mine]])]] = len(materials)
            materials.append(replace(material, alpha_mode=AlphaMode.MASK, alpha_cutoff=NEARLY))
    return tuple(materials), material_of


def _lets_nothing_through(material: Material, places: Float32Array) -> BoolArray:
    """Tell which triangles are opaque all over, by the places of their corners in the texture, shape (n, 3, 2)."""
    pixels = None if material.texture is None else material.texture.pixels
    if pixels is None or material.alpha < NEARLY:
        return np.zeros(len(places), bool)
    clear = pixels[..., 3] < 255 * NEARLY
    if not clear.any():
        return np.ones(len(places), bool)
    sums = np.pad(clear.cumsum(axis=0, dtype=np.int32).cumsum(axis=1, dtype=np.int32), ((1, 0), (1, 0)))
    most = np.array(clear.shape[::-1])
    found = np.nan_to_num(places, nan=-1.0) * most
    low, high = np.floor(found.min(axis=1)) - AROUND, np.ceil(found.max(axis=1)) + AROUND
    inside = np.all((low >= 0) & (high <= most), axis=1)
    (left, top), (right, bottom) = (np.clip(edge, 0, most).astype(np.intp).T for edge in (low, high))
    n_clear = sums[bottom, right] - sums[top, right] - sums[bottom, left] + sums[top, left]
    opaque: BoolArray = inside & (n_clear == 0)
    return opaque


def _mode_of(material: Material) -> AlphaMode:
    """Return how transparent a material may be; nothing can be cut out without a texture."""
    masked = material.alpha_mode is AlphaMode.MASK and material.texture is None
    return AlphaMode.OPAQUE if masked else material.alpha_mode


def _ranked(materials: tuple[Material, ...]) -> Iterator[tuple[int, int, int]]:
    """Return what the triangles of each material are sorted by: kind, sides, and its number from 1; 0 for skin."""
    for number, material in zip(count(1), materials, strict=False):
        if material == Material(material.name, material.colour):
            yield SKIN
        else:
            yield KINDS.index(_mode_of(material)), int(material.two_sided), number


class MaterialPass:
    """Draws what has materials.

    Parameters
    ----------
    context : of OpenGL.
    array_of : returns the array that feeds the mesh to a program.
    """

    def __init__(
        self, context: moderngl.Context, array_of: Callable[[moderngl.Program], moderngl.VertexArray]
    ) -> None:
        self._context, self._array_of = context, array_of
        self._arrays: dict[str, moderngl.VertexArray] = {}
        self._textures: dict[int, moderngl.Texture] = {}

    def draw(self, call: DrawCall, known: str, shared: dict[str, Any], *, blended: bool = False) -> None:
        """Draw a call of a material.

        Parameters
        ----------
        known : constants of the fragment shader.
        shared : uniforms that all materials share.
        blended : whether to draw what lets something through of it, else what does not.
        """
        material = call.material
        assert material is not None
        array = self._array(material, known)
        set_uniforms(array.program, shared | _uniforms(material, blended=blended))
        self._use_textures(array.program, maps_of(material))
        self._context.enable_only(moderngl.DEPTH_TEST | (moderngl.BLEND if blended else 0) | _culling(call))
        array.render(vertices=call.n, first=call.first)

    def cut_out(self, call: DrawCall, shared: dict[str, Any]) -> None:
        """Draw where it is opaque, in depth alone."""
        material = call.material
        assert material is not None
        assert material.texture is not None
        if "cutout" not in self._arrays:
            self._arrays["cutout"] = self._array_of(program_of(self._context, "cutout", "cutout"))
        array = self._arrays["cutout"]
        set_uniforms(array.program, shared | _uniforms(material, blended=False))
        self._use_textures(array.program, {"BASE_MAP": material.texture})
        array.render(vertices=call.n, first=call.first)

    def release(self) -> None:
        """Free all that the graphics driver holds."""
        for array in self._arrays.values():
            program = array.program
            array.release()
            program.release()
        for texture in self._textures.values():
            texture.release()

    def _array(self, material: Material, known: str) -> moderngl.VertexArray:
        names = [*maps_of(material)]
        names += ["TOON"] if material.toon else []
        names += ["CUT"] if _mode_of(material) is not AlphaMode.OPAQUE else []
        known += "".join(f"#define {name}\n" for name in sorted(names))
        if known not in self._arrays:
            self._arrays[known] = self._array_of(program_of(self._context, "head", "material", known))
        return self._arrays[known]

    def _use_textures(self, program: moderngl.Program, maps: dict[str, Texture]) -> None:
        for unit, (name, texture) in enumerate(maps.items(), 1):  # the shadow is texture 0
            if id(texture) not in self._textures:
                self._textures[id(texture)] = upload(self._context, texture)
            self._textures[id(texture)].use(unit)
            program[name.lower()] = unit


def _culling(call: DrawCall) -> int:
    return 0 if call.two_sided else moderngl.CULL_FACE


def _uniforms(material: Material, *, blended: bool) -> dict[str, Any]:
    toon = material.toon or ToonShading()
    opaque = {
        AlphaMode.OPAQUE: (-1.0, ALL),
        AlphaMode.MASK: (material.alpha_cutoff, ALL),
        AlphaMode.BLEND: (HARDLY, NEARLY) if blended else (NEARLY, ALL),
    }
    return {
        "alpha": material.alpha,
        "opaque": opaque[_mode_of(material)],
        "metal_and_roughness": (material.metallic, material.roughness),
        "normal_scale": material.normal_scale,
        "glow": material.glow,
        "shade": np.square(toon.shade),
        "toon": (toon.shift, toon.toony),
    }
