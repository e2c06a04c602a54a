"""Makes the picture of the head that says a, e, i, o, u and m: `python -m tools.screenshots.head OUT THEME`."""

import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from phonemeanalyser.colours import DARK, LIGHT
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.offscreen import OffscreenRenderer
from phonemeanalyser.rendering.renderer import colour_of
from phonemeanalyser.rendering.surface import subdivided
from phonemeengine.arrays import UInt8Array
from phonemeengine.mouth.head import load_head
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.movestate import MovestateSet
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import Phoneme

SAID = (Phoneme.A, Phoneme.E, Phoneme.I, Phoneme.O, Phoneme.U, Phoneme.M)
N_COLUMNS, SIZE, LABEL_AT = 3, 400, (16, 8)
AZIMUTH, ELEVATION, STEPS, DOWN = 0.38, 0.04, 4.5, -0.045
"""Where the camera is: a little to the side, and near enough for the mouth to be seen."""


def visemes(theme: str) -> UInt8Array:
    """Give the picture of all of them."""
    colours = {"light": LIGHT, "dark": DARK}[theme]
    morph_mesh = subdivided(load_head())
    face, table = MovestateSet(morph_mesh.mesh, morph_mesh.states), load_table("arkit")
    camera = Camera.facing(morph_mesh.mesh).orbit(AZIMUTH, ELEVATION).zoom(STEPS).pan(0.0, DOWN)
    shown = []
    with OffscreenRenderer(morph_mesh, (SIZE, SIZE)) as offscreen:
        for phoneme in SAID:
            face.set_percentages(dict(zip(table.movestates, 100.0 * table.weights()[phoneme], strict=True)))
            picture = offscreen.picture(
                camera, face.morphed(), HeadPose(), background=colour_of(colours.window), glow=True
            )
            shown.append(_labelled(picture, phoneme.label, colours.text))
    rows = [np.concatenate(shown[k : k + N_COLUMNS], axis=1) for k in range(0, len(shown), N_COLUMNS)]
    return np.concatenate(rows)


def _labelled(picture: UInt8Array, label: str, colour: str) -> UInt8Array:
    image = Image.fromarray(picture)
    ImageDraw.Draw(image).text(LABEL_AT, label, font=ImageFont.load_default(34), fill=colour)
    return np.asarray(image)


if __name__ == "__main__":
    Image.fromarray(visemes(sys.argv[2])).save(Path(sys.argv[1]), optimize=True)
