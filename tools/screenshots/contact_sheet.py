"""Makes the contact sheet of a sentence beside its labels: `python -m tools.screenshots.contact_sheet OUT THEME`.

One picture for each labelled sound of the demo's first sentence, amid the sound: above it what is said, below it what
was recognised, by which the mouth moves.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from phonemeanalyser.colours import DARK, LIGHT, PHONEME_COLOURS
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.clip import AnimationPlayer, animation_by_rules
from phonemeanalyser.rendering.renderer import OffscreenRenderer, colour_of
from phonemeanalyser.rendering.surface import subdivided
from phonemeengine import ExportOptions, IdleMotion, SoundReader, load_head, load_preset
from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import UInt8Array
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.mouth.transcript import Transcript, transcript_of
from phonemeengine.phonemes import Phoneme

DEMO = Path(__file__).resolve().parents[2] / "phonemeanalyser" / "demo" / "demo.flac"
SENTENCE_END, RATE = 3.9, 100.0
"""Seconds of the first sentence, and pictures a second to choose from."""
N_COLUMNS, SIZE, CAPTION = 7, 200, 44
AZIMUTH, ELEVATION, STEPS, DOWN = 0.38, 0.04, 4.5, -0.045


def contact_sheet(theme: str) -> UInt8Array:
    """Return the sheet, RGB."""
    colours = {"light": LIGHT, "dark": DARK}[theme]
    labels = [label for label in read_labels(DEMO.with_suffix(".csv")) if label.end <= SENTENCE_END][:-1]
    with SoundReader(DEMO) as reader:
        speech = transcript_of(analyse_file(reader, load_preset("learned")), "demo", reader.duration)
    options = ExportOptions(idle=IdleMotion(blinks=False, head=False))
    morph_mesh = subdivided(load_head())
    player = AnimationPlayer(morph_mesh, animation_by_rules(speech, options, RATE))
    camera = Camera.facing(morph_mesh.mesh).orbit(AZIMUTH, ELEVATION).zoom(STEPS).pan(0.0, DOWN)
    wanted = {round((label.start + label.end) / 2 * RATE): label for label in labels}
    shown: list[UInt8Array] = []
    with OffscreenRenderer(morph_mesh, (SIZE, SIZE)) as offscreen:
        for k, (positions, pose) in enumerate(player.scenes()):
            if k in wanted:
                head = offscreen.picture(camera, positions, pose, background=colour_of(colours.window), glow=True)
                said, found = wanted[k], _recognised(speech, k / RATE)
                shown.append(_captioned(head, said, found, colours.window, colours.text))
    blank = np.full_like(shown[0], np.round(np.multiply(colour_of(colours.window), 255)).astype(np.uint8))
    shown += [blank] * (-len(shown) % N_COLUMNS)
    return np.concatenate([np.concatenate(shown[k : k + N_COLUMNS], axis=1) for k in range(0, len(shown), N_COLUMNS)])


def _recognised(speech: Transcript, time: float) -> Phoneme:
    return next((run.phoneme for run in speech.runs if run.start <= time < run.end), Phoneme.SILENCE)


def _captioned(head: UInt8Array, said: Label, found: Phoneme, background: str, text: str) -> UInt8Array:
    """Return the picture with the label above it and what was recognised below, in its colour."""
    image = Image.new("RGB", (SIZE, SIZE + CAPTION), background)
    image.paste(Image.fromarray(head), (0, CAPTION // 2))
    draw, font = ImageDraw.Draw(image), ImageFont.load_default(16)
    draw.text((8, 3), f"{said.phone} ({said.phoneme.label})", font=font, fill=text)
    draw.rectangle((8, SIZE + CAPTION // 2 + 5, 18, SIZE + CAPTION // 2 + 15), fill=PHONEME_COLOURS[found])
    draw.text((24, SIZE + CAPTION // 2 + 1), found.label, font=font, fill=text)
    return np.asarray(image)


if __name__ == "__main__":
    Image.fromarray(contact_sheet(sys.argv[2])).quantize(kmeans=1, dither=Image.Dither.NONE).save(
        Path(sys.argv[1]), optimize=True
    )
