"""What can go wrong with pictures."""

from phonemeengine.errors import EngineError


class RenderingError(EngineError):
    """A head cannot be drawn, or its picture cannot be written."""
