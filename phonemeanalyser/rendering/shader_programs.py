"""The programs that run on the graphics card, and how they are fed."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import moderngl
import numpy as np

from phonemeanalyser.rendering.errors import RenderingError

SHADERS = Path(__file__).with_name("shaders")
VERSION = "#version 330 core\n"
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
    turned, *texts = [
        (SHADERS / f"{name}.glsl").read_text() for name in ("turned", f"{vertex}_vertex", f"{fragment}_fragment")
    ]
    try:
        return context.program(vertex_shader=VERSION + turned + texts[0], fragment_shader=VERSION + known + texts[1])
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
