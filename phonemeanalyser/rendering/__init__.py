"""Pictures of a head: one renderer for the window and for files."""

from phonemeengine.errors import EngineError


class RenderingError(EngineError):
    """A head cannot be drawn, or its picture cannot be written."""
