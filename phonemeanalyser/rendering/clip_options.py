"""How a clip looks."""

from dataclasses import dataclass

from phonemeanalyser.colours import LIGHT, Theme

USUAL_CLIP_RATE = 30.0
"""Frames per second."""
USUAL_CLIP_SIZE = 640, 640
"""Pixels."""


@dataclass(frozen=True)
class ClipOptions:
    """How a clip looks.

    Attributes
    ----------
    size : width and height, pixels.
    rate : frames per second.
    theme : the colours of the background and of captions.
    """

    size: tuple[int, int] = USUAL_CLIP_SIZE
    rate: float = USUAL_CLIP_RATE
    theme: Theme = LIGHT


USUAL_CLIP = ClipOptions()
