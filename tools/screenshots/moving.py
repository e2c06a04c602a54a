"""Makes the moving picture of the README, of the window while it plays the demo: run by screenshots.py."""

import sys
from pathlib import Path

from PIL import Image
from PySide6.QtGui import QImage

from phonemeanalyser.desktop.app import Desktop
from phonemeengine.audio.output import ClockOutput
from tools.bench.desktop import live_for
from tools.screenshots.desktops import ANALYSE, DEMO, TALK, shown_desktop

WINDOW, SHOWN = (1280, 800), (960, 600)
SCENES = ((ANALYSE, 0.4, 4.0), (TALK, 4.3, 7.3))
"""Page, and from when to when it is shown, seconds of the demo."""
PERIOD = 0.1
"""From one picture to the next, seconds."""
REDRAWING = 0.2
"""Seconds in which the window draws what has just been played, on a busy machine too."""
N_COLOURS = 96


class Clock:
    """The time of the playing: it passes picture by picture, however long the window draws.

    Attributes
    ----------
    now : seconds.
    """

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


def main(out: Path) -> None:
    """Play the demo on the pages in turn, and save what the window shows meanwhile."""
    pictures: list[Image.Image] = []
    clock = Clock()
    with shown_desktop(WINDOW, output=lambda: ClockOutput(clock=clock)) as (desktop, _):
        desktop.session.open(DEMO)
        for page, start, end in SCENES:
            desktop.window.show_page(page)
            live_for(1.0)
            while desktop.session.busy or (page == TALK and desktop.talking.face.states is None):
                live_for(0.1)
            desktop.window.banner.show_error("")
            desktop.session.seek(start)
            desktop.session.play()
            for _ in range(round((end - start) / PERIOD)):
                clock.now += PERIOD
                live_for(REDRAWING)
                pictures.append(_picture_of(desktop))
            desktop.session.pause()
    _save(out, pictures)


def _picture_of(desktop: Desktop) -> Image.Image:
    image = desktop.window.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    size = image.width(), image.height()
    picture = Image.frombuffer("RGB", size, bytes(image.constBits()), "raw", "RGB", image.bytesPerLine(), 1)
    return picture.resize(SHOWN, Image.Resampling.LANCZOS)


def _save(out: Path, pictures: list[Image.Image]) -> None:
    """Save with one palette for all pictures, so that what does not move takes no bytes."""
    ends = Image.new("RGB", (SHOWN[0], 2 * SHOWN[1]))
    ends.paste(pictures[0])
    ends.paste(pictures[-1], (0, SHOWN[1]))
    palette = ends.quantize(N_COLOURS, method=Image.Quantize.MAXCOVERAGE, kmeans=2)
    first, *others = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    duration = round(1000 * PERIOD)
    first.save(out, "GIF", save_all=True, append_images=others, duration=duration, loop=0, optimize=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
