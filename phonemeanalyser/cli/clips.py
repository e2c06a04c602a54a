"""What the commands that make clips have in common: their look, and a bar of progress."""

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from tqdm import tqdm

from phonemeanalyser.colours import DARK, LIGHT
from phonemeanalyser.rendering import Framing
from phonemeanalyser.rendering.clip_options import USUAL_CLIP_RATE, ClipOptions
from phonemeengine.execution import Progress


def clip_options(options: argparse.Namespace) -> ClipOptions:
    """Return how the clip of a command line with the arguments of `add_clip` looks."""
    rate = USUAL_CLIP_RATE if options.fps is None else options.fps
    theme = {"light": LIGHT, "dark": DARK}[options.theme]
    return ClipOptions(options.size, rate, theme, Framing(options.view), options.transparent)


@contextmanager
def frames_bar(n_frames: int) -> Iterator[Progress]:
    """Show a bar at terminals."""
    with tqdm(total=n_frames, unit="frame", disable=None, leave=False, file=sys.stderr) as bar:

        def show(share: float) -> bool:
            bar.update(round(share * n_frames) - bar.n)
            return True

        yield show
