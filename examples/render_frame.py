"""A frame of a face, rendered by Blender without its window: `python render_frame.py talk.glb 0.9 talk.png`.

Python needs the module of Blender (`pip install bpy`); with Blender itself it is
`blender -b -P render_frame.py -- talk.glb 0.9 talk.png`.
"""

import sys
from pathlib import Path
from typing import Any

import bpy

face, seconds, picture = sys.argv[-3:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=str(Path(face).resolve()))
scene = bpy.context.scene
mesh = next(thing.data for thing in scene.objects if thing.type == "MESH")
if mesh.color_attributes:  # the colours of the program's heads are those of their vertices
    tree = mesh.materials[0].node_tree
    skin = next(node for node in tree.nodes if node.type == "BSDF_PRINCIPLED")
    tree.links.new(tree.nodes.new("ShaderNodeVertexColor").outputs["Color"], skin.inputs["Base Color"])


def add(data: Any, place: tuple[float, float, float], turn: tuple[float, float, float]) -> Any:
    """Put a camera or a light into the scene; it looks downwards until it is turned, radians."""
    thing = bpy.data.objects.new(data.name, data)
    thing.location, thing.rotation_euler = place, turn
    scene.collection.objects.link(thing)
    return data


camera = bpy.data.cameras.new("camera")
camera.lens = 70
add(camera, (0.8, -8.2, 0.3), (1.57, 0, 0.1))
scene.camera = bpy.data.objects["camera"]
for side, watts in ((-1, 600), (1, 250)):
    light = add(bpy.data.lights.new(f"light {side}", "AREA"), (3.0 * side, -4, 2.5), (1.1, 0, 0.64 * side))
    light.energy, light.size = watts, 3
scene.render.engine, scene.cycles.device, scene.cycles.samples = "CYCLES", "CPU", 8
scene.render.resolution_x = scene.render.resolution_y = 480
scene.frame_set(round(float(seconds) * scene.render.fps))
scene.render.filepath = str(Path(picture).resolve())
bpy.ops.render.render(write_still=True)
