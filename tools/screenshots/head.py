"""Makes pictures of the heads: `python -m tools.screenshots.head OUT THEME visemes|shapes`.

The one of the woman who says a, e, i, o, u and m; and all mouth shapes of both heads, with some expressions.
"""

import sys
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from PIL import Image

from phonemeanalyser.colours import DARK, LIGHT, Theme
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.clip import SideBySide
from phonemeanalyser.rendering.renderer import OffscreenRenderer, colour_of
from phonemeanalyser.rendering.surface import subdivided
from phonemeengine.arrays import UInt8Array
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.morph_mesh import Head, load_head
from phonemeengine.mouth.movestate import MovestateSet
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import Phoneme

SAID = (Phoneme.A, Phoneme.E, Phoneme.I, Phoneme.O, Phoneme.U, Phoneme.M)
N_COLUMNS, SIZE = 3, 400
N_SMALL, SMALL = 7, 240
"""Pictures in a row of all shapes, and their size."""
AZIMUTH, ELEVATION, STEPS, DOWN = 0.3, 0.04, 4.0, -0.05
"""Where the camera is: a little to the side, and near enough for the mouth to be seen."""
SMILE = {"mouthSmile": 100, "cheekSquint": 60}
FELT = {
    "blink": {"eyeBlink": 100},
    "smile": SMILE,
    "smile, blink": {**SMILE, "eyeBlink": 100},
    "disgust": {"noseSneer": 100, "mouthUpperUp": 60, "browDown": 80, "eyeSquint": 60, "mouthFrown": 50},
    "surprise": {"eyeWide": 100, "browInnerUp": 100, "browOuterUp": 80, "jawOpen": 30},
    "look aside": {"eyeLookOutLeft": 80, "eyeLookInRight": 80},
}
"""Expressions, in percent; a name without Left or Right stands for both sides."""


def visemes(colours: Theme) -> UInt8Array:
    """Return the picture of the woman's."""
    table = load_table("arkit")
    shapes = {phoneme.label: table.shapes[table.phonemes[phoneme]] for phoneme in SAID}
    return _sheet(Head.WOMAN, shapes, colours, SIZE, N_COLUMNS)


def shapes(colours: Theme) -> UInt8Array:
    """Return the picture of all shapes of both heads."""
    wanted = {**load_table("arkit").shapes, **FELT}
    return np.concatenate([_sheet(head, wanted, colours, SMALL, N_SMALL) for head in Head])


def _sheet(
    head: Head, shapes: Mapping[str, Mapping[str, float]], colours: Theme, size: int, n_columns: int
) -> UInt8Array:
    morph_mesh = subdivided(load_head(head))
    face = MovestateSet(morph_mesh.mesh, morph_mesh.states)
    camera = Camera.facing(morph_mesh.mesh).orbit(AZIMUTH, ELEVATION).zoom(STEPS).pan(0.0, DOWN)
    background, shown = colour_of(colours.window), []
    sheets = [SideBySide((size, size), [name], colours.text, colours.window) for name in shapes]
    with OffscreenRenderer(morph_mesh, sheets[0].head_size) as offscreen:
        for sheet, shape in zip(sheets, shapes.values(), strict=True):
            wanted = {state: shape.get(state, shape.get(_both(state), 0.0)) for state in ARKIT}
            face.set_percentages(wanted)
            picture = offscreen.picture(camera, face.morphed(), HeadPose(), background=background, glow=True)
            shown.append(sheet.picture([picture]))
    blank = np.full_like(shown[0], np.round(255 * np.array(background)))
    shown += [blank] * (-len(shown) % n_columns)
    rows = [np.concatenate(shown[k : k + n_columns], axis=1) for k in range(0, len(shown), n_columns)]
    return np.concatenate(rows)


def _both(state: str) -> str:
    return state.removesuffix("Left").removesuffix("Right")


if __name__ == "__main__":
    made = {"visemes": visemes, "shapes": shapes}[sys.argv[3]]({"light": LIGHT, "dark": DARK}[sys.argv[2]])
    Image.fromarray(made).quantize(kmeans=1, dither=Image.Dither.NONE).save(Path(sys.argv[1]), optimize=True)
