"""How a clip looks."""

from dataclasses import dataclass

from phonemeanalyser.colours import DARK, LIGHT, Theme
from phonemeengine.conversion.options import OPTIONS, ConversionOptions
from phonemeengine.mouth.morph_mesh import Framing

USUAL_CLIP_RATE = 30.0
"""Frames per second."""


@dataclass(frozen=True)
class ClipOptions:
    """How a clip looks.

    Attributes
    ----------
    size : width and height, pixels.
    rate : frames per second.
    theme : the colours of the background and of captions.
    framing : how much of a person is in the picture.
    transparent : whether nothing is behind the heads: in pictures and .gif files alone.
    """

    size: tuple[int, int] = OPTIONS["size"].default
    rate: float = USUAL_CLIP_RATE
    theme: Theme = LIGHT
    framing: Framing = OPTIONS["view"].default
    transparent: bool = False

    @classmethod
    def of(cls, asked: ConversionOptions) -> "ClipOptions":
        """Return the look that options ask for."""
        rate = USUAL_CLIP_RATE if asked.fps is None else asked.fps
        theme = DARK if asked.theme == DARK.name else LIGHT
        return cls(asked.size, rate, theme, asked.view, asked.transparent)


USUAL_CLIP = ClipOptions()
