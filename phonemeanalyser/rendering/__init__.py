"""Pictures of a head: one renderer for the window and for files."""

from enum import StrEnum

from phonemeengine.errors import EngineError


class RenderingError(EngineError):
    """A head cannot be drawn, or its picture cannot be written."""


class Framing(StrEnum):
    """How much of a person is in the picture."""

    MOUTH = "mouth"
    FACE = "face"
    BUST = "bust"
