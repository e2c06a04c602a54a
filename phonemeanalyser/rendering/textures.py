"""The pictures on a mesh: decoded, scaled down where they are large, and given to the graphics card."""

from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from io import BytesIO
from typing import Any

import moderngl
import numpy as np
from PIL import Image

from phonemeanalyser.rendering import RenderingError
from phonemeengine.mouth.mesh import Material, Mesh, Texture

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
