"""What the tests in Blender share: the add-on, installed from its zip, and faces."""

import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tests.homes import home_of_this_run

# What people have installed and set is left alone: Blender looks at the first before anything else.
os.environ["BLENDER_USER_RESOURCES"] = tempfile.mkdtemp()
os.environ |= home_of_this_run()

import bpy

ROOT = Path(__file__).resolve().parents[2]
ADDON = "bl_ext.user_default.phonemeanalyser"
PROGRAM = Path(os.environ.get("PHONEMEANALYSER", ROOT / ".venv" / "bin" / "phonemeanalyser"))


@pytest.fixture(scope="session", autouse=True)
def addon() -> None:
    """Install the add-on that `make blender` has built."""
    (zipped,) = (ROOT / "build" / "blender").glob("*.zip")
    bpy.ops.extensions.package_install_files(filepath=str(zipped), repo="user_default", enable_on_install=True)
    assert ADDON in bpy.context.preferences.addons


@pytest.fixture(autouse=True)
def empty_scene() -> None:
    """Begin each test with nothing, at 25 frames a second."""
    for data in (bpy.data.objects, bpy.data.meshes, bpy.data.actions, bpy.data.shape_keys, bpy.data.sounds):
        if hasattr(data, "remove"):
            for block in list(data):
                data.remove(block)
    scene = bpy.context.scene
    scene.sequence_editor_clear()
    scene.render.fps, scene.render.fps_base, scene.frame_end = 25, 1.0, 250


@pytest.fixture(scope="session")
def head_glb(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The program's head as a .glb file."""
    from phonemeengine.mouth.files.gltf_writing import format_glb
    from phonemeengine.mouth.morph_mesh import load_head

    path = tmp_path_factory.mktemp("head") / "head.glb"
    path.write_bytes(format_glb(load_head()))
    return path


@pytest.fixture
def head(head_glb: Path) -> bpy.types.Object:
    """The program's head as Blender imports it, with its shape keys."""
    bpy.ops.import_scene.gltf(filepath=str(head_glb))
    return bpy.context.object


@pytest.fixture
def cube() -> bpy.types.Object:
    """A cube without shape keys."""
    bpy.ops.mesh.primitive_cube_add()
    return bpy.context.object


@pytest.fixture
def mouth(cube: bpy.types.Object) -> bpy.types.Object:
    """A cube whose shape keys are called like some of ARKit's, and one that is not."""
    for name in ("Basis", "JawOpen", "mouthClose", "mouthFunnel", "Bart"):
        key = cube.shape_key_add(name=name, from_mix=False)
        key.value = 0.0
    return cube


@pytest.fixture
def speaking() -> Iterator[bpy.types.AddonPreferences]:
    """Have the add-on find the program that `make setup` installs, and return the preferences that name it."""
    found = bpy.context.preferences.addons[ADDON].preferences
    before, found.program = found.program, str(PROGRAM)
    yield found
    found.program = before


def positions_of(points: object) -> np.ndarray:
    """Return where some vertices are, or those of a shape key, shape (n, 3)."""
    found = np.empty(3 * len(points), np.float32)
    points.foreach_get("co", found)
    return found.reshape(-1, 3)


def value_at(face: bpy.types.Object, key: str, frame: float) -> float:
    """Return the value of a shape key on a frame."""
    bpy.context.scene.frame_set(int(frame), subframe=frame % 1)
    return face.data.shape_keys.key_blocks[key].value
