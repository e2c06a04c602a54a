"""The head: one frame with its morphing, drawn in software, in processor time of all threads."""

import statistics
import time
from collections.abc import Callable
from dataclasses import replace
from io import BytesIO

import moderngl
import numpy as np
from PIL import Image

from phonemeanalyser.desktop.talk.head.head_surface import MOST_QUICK_PIXELS
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.renderer import HeadRenderer, OffscreenRenderer, offscreen_context
from phonemeanalyser.rendering.surface import subdivided
from phonemeengine.mouth.mesh import AlphaMode, Material, Texture
from phonemeengine.mouth.morph_mesh import MorphMesh, load_head
from phonemeengine.mouth.movestate import MovestateSet
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import Phoneme
from tools.bench.figures import Absolute, Figure

GREY = (0.5, 0.5, 0.5)
SPOKEN = (Phoneme.A, Phoneme.M, Phoneme.I, Phoneme.SCH, Phoneme.U)
LARGEST = round(MOST_QUICK_PIXELS**0.5)
"""Pixels along the edge of the largest picture of something that moves."""
N_ROUNDS, N_FRAMES = 7, 10
FRAME = 1 / 50
"""What one frame of 50 fps may take where a core has nothing else to do, seconds."""


def figures() -> list[Figure]:
    """Measure a frame as small and large windows draw it while it moves, and one of a preview."""
    context = offscreen_context()
    with context:
        renderer = context.info["GL_RENDERER"].split(" (")[0]
        found = [_window(context, load_head(), size, f"head by {renderer}") for size in (320, LARGEST)]
        found += [_window(context, _textured(mode), LARGEST, f"textured face, {mode}") for mode in AlphaMode]
    context.release()
    return [*found, _preview(renderer)]


def _textured(mode: AlphaMode) -> MorphMesh:
    """Return the woman's head with one material and a texture, of which a fifth lets light through."""
    head, file = load_head(), BytesIO()
    pixels = np.full((1024, 1024, 4), (200, 160, 140, 255), np.uint8)
    pixels[:, :205, 3] = 120
    Image.fromarray(pixels).save(file, "PNG")
    texture = Texture("skin", file.getvalue(), *pixels.shape[:2])
    low, high = head.mesh.positions.min(axis=0), head.mesh.positions.max(axis=0)
    uvs = ((head.mesh.positions - low) / (high - low))[:, :2]
    material = Material("skin", texture=texture, alpha_mode=mode)
    material_of = np.zeros(len(head.mesh.triangles), np.uint16)
    return replace(head, mesh=replace(head.mesh, materials=(material,), material_of=material_of, uvs=uvs))


def _window(context: moderngl.Context, head: MorphMesh, size: int, name: str) -> Figure:
    drawing, talking = HeadRenderer(context, head), _Talking(MovestateSet(head.mesh, head.states))
    target, camera = context.framebuffer(context.renderbuffer((size, size), 4)), Camera.facing(head.mesh)

    def draw() -> None:
        drawing.draw(camera, talking.positions(), size=(size, size), background=GREY, fine=False, target=target)
        context.finish()

    seconds = _processor_time(draw)
    drawing.release()
    target.release()
    return _figure(f"{name}, {size}x{size}", seconds)


def _preview(renderer: str) -> Figure:
    head = subdivided(load_head())
    talking, camera = _Talking(MovestateSet(head.mesh, head.states)), Camera.facing(head.mesh)
    with OffscreenRenderer(head, (640, 640)) as offscreen:
        seconds = _processor_time(lambda: offscreen.picture(camera, talking.positions(), background=GREY, fine=False))
    return Figure(f"preview 640x640 by {renderer}", f"{seconds * 1e3:.1f} ms", "20 ms", seconds / FRAME)


class _Talking:
    """Moves a face through some phonemes, one each frame."""

    def __init__(self, face: MovestateSet) -> None:
        table = load_table("arkit")
        self._face, self._frame = face, 0
        rows = 100.0 * table.weights()
        self._shapes = [dict(zip(table.movestates, rows[phoneme], strict=True)) for phoneme in SPOKEN]

    def positions(self) -> np.ndarray:
        self._face.set_percentages(self._shapes[self._frame % len(self._shapes)])
        self._frame += 1
        return self._face.morphed()


def _processor_time(act: Callable[[], object]) -> float:
    """Give the median of the processor time that it takes once, seconds."""
    act()
    found = []
    for _ in range(N_ROUNDS):
        began = time.process_time()
        for _ in range(N_FRAMES):
            act()
        found.append((time.process_time() - began) / N_FRAMES)
    return statistics.median(found)


def _figure(name: str, seconds: float) -> Figure:
    return Figure(name, f"{seconds * 1e3:.1f} ms", "20 ms", seconds / FRAME, 1.0, absolute=Absolute.WORK)
