"""OpenGL without a window, for tests: skipped where there is none at all, but never in continuous integration."""

import os
from collections.abc import Callable, Iterator
from io import BytesIO

import moderngl
import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray
from PIL import Image

from phonemeanalyser.rendering import RenderingError
from phonemeanalyser.rendering.renderer import OffscreenRenderer, offscreen_context
from phonemeengine.mouth.mesh import Material, Mesh, Texture, mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh

Picture = NDArray[np.uint8]
LIGHT, DARK, MAGENTA = (0.95, 0.955, 0.965), (0.12, 0.13, 0.16), (1.0, 0.0, 1.0)


def context_or_skip() -> moderngl.Context:
    """Give a context, or skip the test."""
    try:
        return offscreen_context()
    except RenderingError as error:
        if "CI" in os.environ:
            raise
        pytest.skip(str(error))


@pytest.fixture
def context() -> Iterator[moderngl.Context]:
    """An OpenGL context."""
    context = context_or_skip()
    with context:
        yield context
    context.release()


@pytest.fixture
def offscreen() -> Iterator[Callable[..., OffscreenRenderer]]:
    """Makes photographers of figures, who leave at the end."""
    context_or_skip().release()
    made: list[OffscreenRenderer] = []

    def make(morph_mesh: MorphMesh, size: tuple[int, int] = (240, 240)) -> OffscreenRenderer:
        made.append(OffscreenRenderer(morph_mesh, size))
        return made[-1]

    yield make
    for one in made:
        one.release()


def ball(radius: float = 1.0, *, inwards: bool = False, n: int = 24) -> Mesh:
    """A ball about the origin; its poles are vertices that lie on each other."""
    polar, around = np.meshgrid(np.linspace(0, np.pi, n // 2 + 1), np.linspace(0, 2 * np.pi, n + 1), indexing="ij")
    points = radius * np.stack((np.sin(polar) * np.sin(around), np.cos(polar), np.sin(polar) * np.cos(around)), -1)
    k = np.arange((n // 2 + 1) * (n + 1)).reshape(n // 2 + 1, n + 1)
    a, b, c, d = k[:-1, :-1].ravel(), k[1:, :-1].ravel(), k[1:, 1:].ravel(), k[:-1, 1:].ravel()
    triangles = np.concatenate((np.stack((a, b, c), 1), np.stack((a, c, d), 1)))
    return mesh_of(points.reshape(-1, 3), triangles[:, ::-1] if inwards else triangles, name="ball")


def panel(*materials: Material, depth: float = 0.3) -> MorphMesh:
    """Squares behind each other, the first at the back, that face the viewer; each with a whole texture."""
    n = len(materials)
    corners = np.float32([(-1, 1, 0), (-1, -1, 0), (1, -1, 0), (1, 1, 0)])
    points = np.concatenate([corners + np.float32((0, 0, k * depth)) for k in range(n)])
    triangles = np.concatenate([np.array([(0, 1, 2), (0, 2, 3)]) + 4 * k for k in range(n)])
    uvs = np.tile(np.float32([(0, 0), (0, 1), (1, 1), (1, 0)]), (n, 1))
    return MorphMesh(mesh_of(points, triangles, materials=materials, material_of=np.repeat(np.arange(n), 2), uvs=uvs))


def texture_of(pixels: ArrayLike, name: str = "picture") -> Texture:
    """A PNG of colours, shape (height, width, 3 or 4), 0..255."""
    file, colours = BytesIO(), np.asarray(pixels, np.uint8)
    Image.fromarray(colours).save(file, "PNG")
    return Texture(name, file.getvalue(), colours.shape[1], colours.shape[0])


def joined(*meshes: Mesh) -> Mesh:
    """Several meshes as one."""
    starts = np.cumsum([0, *(len(mesh) for mesh in meshes)])
    return mesh_of(
        np.concatenate([mesh.positions for mesh in meshes]),
        np.concatenate([mesh.triangles + start for mesh, start in zip(meshes, starts, strict=False)]),
    )


def seen(picture: Picture) -> NDArray[np.bool_]:
    """Tell which pixels are not of the colour in the upper left corner."""
    return np.any(picture != picture[0, 0], axis=2)
