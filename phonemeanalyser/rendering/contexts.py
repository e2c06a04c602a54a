"""OpenGL itself: the window's own, or one without a window."""

import sys
from typing import Any

import moderngl

from phonemeanalyser.rendering.errors import RenderingError


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
    """Take the OpenGL context that is current, as in a window's `initializeGL`.

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
