"""Pictures of a head: one renderer for the window and for files."""

from phonemeengine.errors import EngineError


class RenderingError(EngineError):
    """A head cannot be drawn, or its picture cannot be written."""


SOFTWARE = ("llvmpipe", "softpipe", "swrast", "software", "swiftshader", "gdi generic", "basic render")
"""What the names of renderers hold that draw with the processor."""


def draws_in_software(renderer: str) -> bool:
    """Return whether OpenGL's renderer of this name is a program, not a graphics card."""
    return any(word in renderer.lower() for word in SOFTWARE)
