"""Avatars: VRM 0 and 1, their bones, expressions and textures."""

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.gltf import parse_gltf, parse_vrm
from phonemeengine.mouth.files.gltf_materials import picture_size
from phonemeengine.mouth.files.gltf_writing import format_glb
from phonemeengine.mouth.files.io import FaceFiles, load_morph_mesh
from phonemeengine.mouth.mesh import AlphaMode
from phonemeengine.mouth.morph_mesh import MorphMesh, bust_of, load_head
from tests.avatars import HEIGHT, JAW, avatar, eye_at, png
from tests.glb_faces import face_with_targets

VERSIONS = pytest.mark.parametrize("version", [0, 1])
MOUTH = ("jawOpen", "mouthSmileLeft", "eyeBlinkLeft")


@cache
def face_of(version: int, only: tuple[str, ...] | None = None) -> MorphMesh:
    return parse_vrm(avatar(version) if only is None else avatar(version, only=only))


def offsets_of(face: MorphMesh, name: str) -> Any:
    state = next(state for state in face.states if state.name == name)
    dense = np.zeros((len(face.mesh), 3))
    dense[state.numbers] = state.offsets
    return dense


@VERSIONS
def test_an_avatar_is_where_its_bones_put_it_and_faces_the_viewer(version: int) -> None:
    face, head = face_of(version), load_head()
    np.testing.assert_allclose(face.mesh.positions, head.mesh.positions + np.array([0, HEIGHT, 0]), atol=1e-5)
    assert float(np.mean(np.sum(face.mesh.normals * head.mesh.normals, axis=1))) > 0.999
    assert face.neck == pytest.approx((0, HEIGHT, 0))
    np.testing.assert_allclose(offsets_of(face, "jawOpen"), offsets_of(head, "jawOpen"), atol=2e-4)


@VERSIONS
def test_the_expressions_of_an_avatar_are_movestates(version: int) -> None:
    face = face_of(version)
    names = ("aa", "ih", "blinkLeft") if version else ("A", "I", "Blink_L")
    first, second, _ = (state.name for state in face.states[:3])
    np.testing.assert_allclose(offsets_of(face, names[0]), offsets_of(face, first), atol=1e-6)
    np.testing.assert_allclose(offsets_of(face, names[1]), offsets_of(face, second) / 2, atol=1e-6)


@VERSIONS
def test_a_jaw_that_is_a_bone_opens_by_its_rotation(version: int) -> None:
    face = face_of(version, MOUTH)
    moved = offsets_of(face, "bone jawOpen")
    chin = int(np.argmin(offsets_of(face, "jawOpen")[:, 1]))
    joint = np.array([0, HEIGHT - 0.1, 0.1])
    away, opened = face.mesh.positions[chin] - joint, face.mesh.positions[chin] + moved[chin] - joint
    assert moved[chin, 1] < -0.1  # downwards
    assert np.degrees(np.arctan2(away[1], away[2]) - np.arctan2(opened[1], opened[2])) == pytest.approx(20, abs=1)
    assert np.linalg.norm(opened) == pytest.approx(np.linalg.norm(away), rel=0.02)


@VERSIONS
def test_eyes_that_are_bones_look_to_all_sides(version: int) -> None:
    face = face_of(version, MOUTH)
    pupil = int(np.argmin(np.linalg.norm(face.mesh.positions - np.add(eye_at(1), [0, HEIGHT, 0.15]), axis=1)))
    assert offsets_of(face, "bone eyeLookOutLeft")[pupil, 0] > 0.01
    assert offsets_of(face, "bone eyeLookInLeft")[pupil, 0] < -0.01
    assert offsets_of(face, "bone eyeLookUpLeft")[pupil, 1] > 0.01
    assert offsets_of(face, "bone eyeLookDownLeft")[pupil, 1] < -0.01
    assert not offsets_of(face, "bone eyeLookOutRight")[pupil].any()


MTOON0 = {
    "shader": "VRM/MToon",
    "floatProperties": {"_ShadeToony": 0.8, "_ShadeShift": 0.2},
    "vectorProperties": {"_ShadeColor": [0.5, 0.4, 0.3, 1]},
    "textureProperties": {"_ShadeTexture": 0},
}
MTOON1 = {
    "shadeColorFactor": [0.21404, 0.13287, 0.07324],  # 0.5, 0.4, 0.3 in sRGB
    "shadeMultiplyTexture": {"index": 0},
    "shadingToonyFactor": 0.92,
    "shadingShiftFactor": -0.28,
}


@VERSIONS
def test_mtoon_is_the_same_in_both_versions(version: int) -> None:
    def toon(document: dict[str, Any]) -> None:
        if version:
            document["materials"][0]["extensions"] = {"VRMC_materials_mtoon": MTOON1}
        else:
            document["extensions"]["VRM"]["materialProperties"] = [MTOON0]

    (material,) = parse_vrm(avatar(version, picture=png(2, 2), only=(), change=toon)).mesh.materials
    shading = material.toon
    assert shading is not None
    assert shading.texture is material.texture is not None
    assert shading.shade == pytest.approx((0.5, 0.4, 0.3), abs=1e-3)
    assert (shading.shift, shading.toony) == pytest.approx((-0.28, 0.92))


def test_maps_glow_and_moved_places_of_a_material_are_read() -> None:
    def more(document: dict[str, Any]) -> None:
        material, base = document["materials"][0], {"offset": [0.5, 0.25], "scale": [2, 1], "rotation": np.pi / 2}
        material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {"KHR_texture_transform": base}
        material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {"index": 0}
        material |= {"normalTexture": {"index": 0, "scale": 0.5}, "emissiveTexture": {"index": 0}}
        material |= {"emissiveFactor": [1, 0.5, 0]}
        material["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": 3}}

    moved = parse_vrm(avatar(1, picture=png(2, 2), only=(), change=more)).mesh
    plain = parse_vrm(avatar(1, picture=png(2, 2), only=())).mesh
    (material,) = moved.materials
    assert material.surface is material.normal is material.glow_texture is material.texture is not None
    assert (material.glow, material.normal_scale) == ((3.0, 1.5, 0.0), 0.5)
    u, v = plain.uvs.T
    np.testing.assert_allclose(moved.uvs, np.column_stack((v + 0.5, 0.25 - 2 * u)), atol=1e-5)


def test_what_has_no_light_has_a_shade_of_its_own_colour() -> None:
    def unlit(document: dict[str, Any]) -> None:
        document["materials"][0]["extensions"] = {"KHR_materials_unlit": {}}

    (material,) = parse_vrm(avatar(1, picture=png(2, 2), only=(), change=unlit)).mesh.materials
    assert material.toon is not None
    assert material.toon.texture is material.texture
    assert max(material.toon.shade) < min(material.colour)


def test_bones_without_vrm_are_known_by_their_names() -> None:
    def only_names(document: dict[str, Any]) -> None:
        del document["extensions"]
        for node, name in zip(document["nodes"][2:], ("mixamorig:Head", "CC_Base_JawRoot", "Eye.L"), strict=False):
            node["name"] = name

    names = {state.name for state in parse_gltf(avatar(1, change=only_names)).states}
    assert {"bone jawOpen", "bone eyeLookUpLeft"} <= names
    assert "bone eyeLookUpRight" not in names


def test_a_texture_and_its_material_come_with_the_mesh() -> None:
    picture = png(4, 2)
    mesh = parse_vrm(avatar(0, picture=picture)).mesh
    (skin,) = mesh.materials
    assert skin.texture is not None
    assert (skin.texture.content, skin.texture.width, skin.texture.height) == (picture, 4, 2)
    assert (skin.alpha_mode, skin.two_sided, skin.metallic, skin.roughness) == (AlphaMode.MASK, True, 0, 0.4)
    assert mesh.uvs.min() == 0
    assert mesh.uvs.max() == 1


def test_the_size_of_a_jpeg_is_known_by_its_header() -> None:
    header = b"\xff\xd8\xff\xe0\0\x04ab\xff\xc4\0\x03x\xff\xc2\0\x0b\x08\x10\0\x20\0"
    assert picture_size(header) == (0x2000, 0x1000)
    assert picture_size(b"GIF89a") is None
    assert picture_size(header[:14]) is None


def test_head_and_shoulders_are_cut_from_a_whole_body() -> None:
    body = face_of(1)
    centred = bust_of(body)  # it is a head with shoulders, of which nothing is cut
    np.testing.assert_allclose(centred.mesh.positions, body.mesh.positions - np.array([0, HEIGHT, 0]), atol=1e-5)
    low = body.mesh.positions[:, 1].min()
    far = body.mesh.positions.copy()
    feet = np.flatnonzero(far[:, 1] < low + 0.2)
    far[feet, 1] -= 10
    whole = MorphMesh(body.mesh.with_vertices(feet, far[feet]), body.states, body.neck)
    bust = bust_of(whole)
    assert 0.9 * len(body.mesh) < len(bust.mesh) <= len(body.mesh) - len(feet)
    assert bust.neck == (0, 0, 0)
    assert bust.mesh.positions[:, 1].min() > -5
    assert {state.name for state in bust.states} == {state.name for state in body.states}
    chin = int(np.argmin(offsets_of(bust, "jawOpen")[:, 1]))
    same = int(np.argmin(offsets_of(body, "jawOpen")[:, 1]))
    np.testing.assert_allclose(bust.mesh.positions[chin] + [0, HEIGHT, 0], body.mesh.positions[same], atol=1e-5)


def test_an_avatar_of_30_megabytes_with_other_things_in_it_can_be_opened(tmp_path: Path) -> None:
    (tmp_path / "big.vrm").write_bytes(avatar(0, filling=24 << 20, picture=png(2048, 2048)))
    assert (tmp_path / "big.vrm").stat().st_size > 30e6
    face = FaceFiles(tmp_path / "big.vrm").load()
    assert len(face.states) > 52


def circle(document: dict[str, Any]) -> None:
    document["nodes"][JAW]["children"] = [2]


BAD: dict[str, tuple[Callable[[], bytes], str]] = {  # made where they are used: test files are read by each process
    "no VRM": (lambda: format_glb(load_head()), "this is no VRM"),
    "cut off": (lambda: b"glTF\2\0\0\0", "ends within its header"),
    "text": (lambda: b"hello", "its JSON cannot be read"),
    "a circle": (lambda: avatar(0, change=circle), "below two others|in a circle"),
    "a ring": (
        lambda: avatar(1, change=lambda d: d["nodes"].extend([{"children": [7]}, {"children": [6]}])),
        "the bones of its skeleton go in a circle",
    ),
    "a large texture": (
        lambda: avatar(1, picture=png(16384, 1)),
        "texture 'skin' has 16384 x 1 pixels, and at most 8192",
    ),
    "no such bone": (
        lambda: avatar(1, change=lambda d: d["skins"][0].update(joints=[2])),
        "a skin of 1|its skin has 1",
    ),
    "no such node": (
        lambda: avatar(1, change=lambda d: d["nodes"][1].update(children=[99])),
        "number 99 of its nodes",
    ),
    "few matrices": (
        lambda: avatar(1, change=lambda d: d["skins"][0].update(inverseBindMatrices=0)),
        "a skin of 4 bones has",
    ),
}


@pytest.mark.parametrize(("write", "said"), BAD.values(), ids=BAD)
def test_a_bad_avatar_is_refused_in_one_sentence(tmp_path: Path, write: Callable[[], bytes], said: str) -> None:
    (tmp_path / "bad.vrm").write_bytes(write())
    with pytest.raises(MeshError, match=said) as refusal:
        load_morph_mesh(tmp_path / "bad.vrm")
    assert str(refusal.value).startswith("bad.vrm: ")
    assert "\n" not in str(refusal.value)


def test_five_thousand_shapes_are_refused_in_one_sentence() -> None:
    with pytest.raises(MeshError, match="at most 1024 morph targets; leave some out"):
        parse_gltf(face_with_targets([f"shape {k}" for k in range(5000)]))


def test_of_fbx_the_way_through_blender_is_said(tmp_path: Path) -> None:
    with pytest.raises(MeshError, match=r"face.fbx: FBX cannot be read; open it in Blender, .* glTF"):
        load_morph_mesh(tmp_path / "face.fbx")
