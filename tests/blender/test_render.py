"""The head speaks in a picture that Blender renders, which stays in build/blender to be looked at."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from mathutils import Vector

from tests.blender.conftest import ROOT

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
PICTURE = ROOT / "build" / "blender" / "head.png"
SIZE = 480
LIGHTS = (((-3.0, -4.0, 4.0), 420.0, 3.0), ((4.0, -3.0, 1.5), 120.0, 4.0), ((0.5, 4.0, 3.5), 260.0, 2.0))
"""Where they are, watts, and how wide."""


def lit(scene: Any) -> None:
    for place, watts, size in LIGHTS:
        light = bpy.data.lights.new("light", "AREA")
        light.energy, light.size = watts, size
        lamp = bpy.data.objects.new("light", light)
        lamp.location = place
        lamp.rotation_euler = (-Vector(place)).to_track_quat("-Z", "Y").to_euler()
        scene.collection.objects.link(lamp)
    scene.world = bpy.data.worlds.new("world")
    if bpy.app.version < (5, 0):  # later ones always have nodes
        scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.045, 0.05, 0.06, 1)


def seen(scene: Any) -> None:
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.lens = 84
    camera.location = (1.6, -8.2, 0.45)
    camera.rotation_euler = (Vector((0, 0, 0.24)) - camera.location).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera


def coloured(head: Any) -> None:
    """Give the head the colours of its vertices."""
    material = head.data.materials[0]
    nodes = material.node_tree.nodes
    colours = nodes.new("ShaderNodeVertexColor")
    colours.layer_name = head.data.color_attributes[0].name
    skin = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    material.node_tree.links.new(colours.outputs["Color"], skin.inputs["Base Color"])
    skin.inputs["Roughness"].default_value = 0.45
    for polygon in head.data.polygons:
        polygon.use_smooth = True


def rendered(scene: Any, frame: int, path: Path) -> np.ndarray:
    """Render a frame, and return its pixels, shape (height, width, 4), the lowest row first."""
    scene.frame_set(frame)
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(str(path))
    return np.array(picture.pixels[:], np.float32).reshape(SIZE, SIZE, 4)


def test_the_mouth_of_the_head_opens_in_the_picture(head: Any, speaking: Any, tmp_path: Path) -> None:
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.device, scene.cycles.samples = "CYCLES", "CPU", 16
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    coloured(head)
    lit(scene)
    seen(scene)
    bpy.ops.lip_sync.speak_sound(filepath=str(DEMO))
    jaw = head.data.shape_keys.key_blocks["jawOpen"]
    values = []
    for frame in range(1, 100):
        scene.frame_set(frame)
        values.append(jaw.value)
    closed = rendered(scene, 1, tmp_path / "closed.png")
    opened = rendered(scene, int(np.argmax(values)) + 1, PICTURE)
    changed = np.abs(opened - closed)[..., :3].max(axis=2) > 0.2
    rows, columns = np.nonzero(changed)
    assert changed.sum() > 100
    assert 0.2 * SIZE < np.median(rows) < 0.5 * SIZE  # the mouth lies in the lower half, in the middle
    assert 0.35 * SIZE < np.median(columns) < 0.65 * SIZE


def test_the_example_renders_a_frame_of_an_exported_face(head_glb: Path, tmp_path: Path) -> None:
    command = [
        sys.executable,
        str(ROOT / "examples" / "render_frame.py"),
        str(head_glb),
        "0",
        str(tmp_path / "a.png"),
    ]
    subprocess.run(command, check=True, timeout=300)
    picture = bpy.data.images.load(str(tmp_path / "a.png"))
    light = np.array(picture.pixels[:], np.float32).reshape(*picture.size, 4)[..., :3].mean(axis=2)
    assert light[200:300, 200:300].mean() > 0.15  # the face
    assert light[-20:, :20].mean() < 0.05  # nothing beside it
