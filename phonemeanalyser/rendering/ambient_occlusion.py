"""How open each place of a mesh is to the light around it: not at all in a closed mouth, little in a nostril."""

import math

import moderngl
import numpy as np

from phonemeanalyser.rendering.light import BoundingSphere
from phonemeanalyser.rendering.shader_programs import set_uniforms
from phonemeengine.arrays import BoolArray, Float32Array, Float64Array
from phonemeengine.mouth.mesh import Mesh

N_DIRECTIONS = 40
SIZE = 192
"""Pixels along the edge of what is seen from each direction."""
THICKNESS = 0.012
"""What lies no deeper than this, as a share of the depth of all, is seen."""


def ambient_occlusion(context: moderngl.Context, array: moderngl.VertexArray, mesh: Mesh) -> Float32Array:
    """Look at a mesh from all around, and say how much of what each vertex faces it can see.

    Parameters
    ----------
    array : draws the mesh at rest with the matrix `camera`.

    Returns
    -------
    float32, shape (n_vertices,), 0..1.
    """
    depths = context.depth_texture((SIZE, SIZE))
    dark_room, room = context.framebuffer(depth_attachment=depths), BoundingSphere.around(mesh)
    seen, faced = np.zeros(len(mesh)), np.full(len(mesh), 1e-6)
    dark_room.use()
    for towards in _directions():
        view = room.seen_from(towards)
        cosines = np.maximum(mesh.normals @ towards, 0.0)
        dark_room.clear(depth=1.0)
        set_uniforms(array.program, {"camera": view.T})
        array.render()
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
