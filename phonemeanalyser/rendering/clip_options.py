"""How a clip looks."""

from dataclasses import dataclass

from phonemeanalyser.colours import LIGHT, Theme
from phonemeanalyser.rendering import Framing

USUAL_CLIP_RATE = 30.0
"""Frames per second."""
USUAL_CLIP_SIZE = 640, 640
"""Pixels."""
SMALLEST_CLIP, LARGEST_CLIP = 16, 4096
"""Pixels along an edge."""


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

    size: tuple[int, int] = USUAL_CLIP_SIZE
    rate: float = USUAL_CLIP_RATE
    theme: Theme = LIGHT
    framing: Framing = Framing.FACE
    transparent: bool = False


USUAL_CLIP = ClipOptions()
