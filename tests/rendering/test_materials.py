"""Materials and textures: what glTF's model and MToon say of simple surfaces is seen."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import binary_dilation, binary_erosion, distance_transform_edt

from phonemeanalyser.rendering import RenderingError
from phonemeanalyser.rendering.camera import Camera, Light
from phonemeanalyser.rendering.materials import LARGEST, MOST_PIXELS, draw_calls_of, with_pixels
from phonemeanalyser.rendering.renderer import OffscreenRenderer
from phonemeengine.mouth.mesh import AlphaMode, Material, Mesh, Texture, ToonShading
from phonemeengine.mouth.morph_mesh import MorphMesh
from tests.graphics import DARK, LIGHT, Picture, ball, context, offscreen, panel, seen, texture_of

__all__ = ["context", "offscreen"]  # fixtures
Hire = Callable[..., OffscreenRenderer]
SIZE = 96, 96
WHITE, RED, GREEN, BLUE, GREY = (1.0, 1.0, 1.0), (255, 0, 0), (0, 255, 0), (0, 0, 255), (128, 128, 128)
AHEAD, NIGHT = Light(0.0, 0.0), Light(strength=0.0)
RESTING = Material("resting", WHITE, roughness=0.9)


def shot(offscreen: Hire, face: MorphMesh, light: Light = AHEAD, **how: object) -> Picture:
    return offscreen(face, SIZE).picture(
        Camera.facing(face.mesh), face.mesh.positions, light=light, **({"background": DARK} | how)
    )


def of_ball(material: Material) -> MorphMesh:
    mesh = ball()
    return MorphMesh(
        replace(mesh, materials=(material,), colours=np.tile(np.float32(material.colour), (len(mesh), 1)))
    )


def middle(picture: Picture) -> list[int]:
    return [int(value) for value in picture[SIZE[1] // 2, SIZE[0] // 2]]


def test_a_texture_lies_as_gltf_says_from_its_upper_left_corner(offscreen: Hire):
    picture = shot(offscreen, panel(replace(RESTING, texture=texture_of([[RED, GREEN], [BLUE, GREY]]))))
    rows, columns = np.argwhere(seen(picture)).T
    corners = [
        picture[y, x].astype(int)
        for y in (rows.min() + 6, rows.max() - 6)
        for x in (columns.min() + 6, columns.max() - 6)
    ]
    assert [int(np.argmax(corner)) for corner in corners[:3]] == [0, 1, 2]
    assert np.ptp(corners[3]) < 30


def test_fine_patterns_neither_shimmer_nor_vanish(offscreen: Hire):
    """A checkerboard finer than pixels is an even grey, wherever the camera is."""
    board = np.repeat(255 * (np.indices((512, 512)).sum(axis=0) % 2)[..., np.newaxis], 3, axis=2)
    face = panel(replace(RESTING, texture=texture_of(board)))
    hired, camera = offscreen(face, SIZE), Camera.facing(face.mesh)
    for moved in (camera, camera.orbit(0.01, 0.0), camera.pan(0.003, 0.001)):
        inner = hired.picture(moved, face.mesh.positions, background=DARK, light=AHEAD)[36:60, 36:60]
        assert 90 < inner.mean() < 220
        assert inner.std() < 6


def test_only_triangles_through_which_something_shines_are_blended() -> None:
    picture = np.full((64, 64, 4), 255, np.uint8)
    picture[:, 32:, 3] = 100
    face = panel(replace(RESTING, texture=texture_of(picture), alpha_mode=AlphaMode.BLEND))
    uvs = np.array([[0.2, 0.2], [0.3, 0.2], [0.2, 0.3], [0.3, 0.4]], np.float32)[: len(face.mesh)]
    modes = {}
    for name, moved in (("opaque", 0.0), ("beyond the edge", 0.2), ("outside", 1.0), ("none", np.nan)):
        mesh = replace(with_pixels(face.mesh), uvs=uvs + np.float32(moved))
        modes[name] = {call.mode for call in draw_calls_of(mesh)[1]}
    assert modes.pop("opaque") == {AlphaMode.MASK}
    assert all(found == {AlphaMode.BLEND} for found in modes.values())


def test_alpha_cuts_out_blends_or_is_ignored(offscreen: Hire):
    half = texture_of([[(255, 255, 255, 102)] * 4] * 4)
    back = Material("back", (1.0, 0.0, 0.0), roughness=0.9)
    shown = {}
    for mode in AlphaMode:
        shown[mode] = middle(shot(offscreen, panel(back, replace(RESTING, texture=half, alpha_mode=mode))))
    assert min(shown[AlphaMode.OPAQUE]) > 180
    assert shown[AlphaMode.MASK][0] > 150
    assert shown[AlphaMode.MASK][1] < 60
    assert shown[AlphaMode.MASK][1] + 40 < shown[AlphaMode.BLEND][1] < shown[AlphaMode.OPAQUE][1] - 40
    clear = shot(offscreen, panel(replace(RESTING, texture=half, alpha_mode=AlphaMode.BLEND)), background=None)
    assert middle(clear)[3] == pytest.approx(102, abs=2)


def test_what_is_blended_by_name_alone_hides_what_is_behind_it(offscreen: Hire):
    front, back = replace(RESTING, alpha_mode=AlphaMode.BLEND), Material("back", (1.0, 0.0, 0.0), roughness=0.9)
    turned = MorphMesh(
        replace(panel(front, back).mesh, positions=panel(front, back).mesh.positions[[4, 5, 6, 7, 0, 1, 2, 3]])
    )
    assert np.ptp(middle(shot(offscreen, turned))) < 30


def test_a_surface_is_seen_from_behind_where_it_has_two_sides(offscreen: Hire):
    shown = []
    for two_sided in (False, True):
        face = panel(replace(RESTING, two_sided=two_sided))
        camera = Camera.facing(face.mesh).orbit(np.pi, 0.0)
        shown.append(middle(offscreen(face, SIZE).picture(camera, face.mesh.positions, background=DARK, light=AHEAD)))
    assert max(shown[0]) < 60
    assert min(shown[1]) > 150


def test_metal_has_a_coloured_highlight_and_what_is_rough_a_wide_one(offscreen: Hire):
    smooth, rough = (replace(RESTING, colour=(0.2, 0.2, 0.2), roughness=roughness) for roughness in (0.25, 0.8))
    bright = [shot(offscreen, of_ball(material))[..., 1].astype(int) for material in (smooth, rough)]
    assert bright[0].max() > bright[1].max() + 40
    gold = shot(offscreen, of_ball(Material("gold", (1.0, 0.6, 0.2), metallic=1.0, roughness=0.4)))
    red, _, blue = middle(gold)
    assert red > 1.5 * blue
    pixels = texture_of([[(0, 255, 255)] * 2] * 2)  # rough and metal
    as_texture = shot(
        offscreen, panel(Material("gold", (1.0, 0.6, 0.2), metallic=1.0, roughness=0.4, surface=pixels))
    )
    as_numbers = shot(offscreen, panel(Material("gold", (1.0, 0.6, 0.2), metallic=1.0, roughness=0.4)))
    assert np.abs(as_texture.astype(int) - as_numbers).max() <= 1


def test_what_glows_is_seen_without_light(offscreen: Hire):
    lamp = replace(RESTING, glow=(0.0, 0.5, 0.0))
    assert middle(shot(offscreen, panel(lamp), NIGHT))[1] > 150 > max(middle(shot(offscreen, panel(RESTING), NIGHT)))
    dark = replace(lamp, glow_texture=texture_of([[(0, 0, 0)] * 2] * 2))
    assert max(middle(shot(offscreen, panel(dark), NIGHT))) < 5


def test_normals_of_a_texture_turn_the_surface_to_the_light(offscreen: Hire):
    """Normals that lean to the viewer's right: bright in light from the right, dark in that from the left."""
    leaning = replace(RESTING, normal=texture_of([[(218, 128, 218)] * 2] * 2))
    right, left, flat = (
        middle(shot(offscreen, panel(material), Light(azimuth, 0.0)))[1]
        for material, azimuth in ((leaning, 0.8), (leaning, -0.8), (RESTING, 0.8))
    )
    assert right > flat > left + 30


def test_mtoon_has_two_steps(offscreen: Hire):
    toon = Material("toon", (1.0, 0.8, 0.7), toon=ToonShading((0.3, 0.2, 0.6), toony=0.98))
    picture = shot(offscreen, of_ball(toon), Light(-1.57, 0.0))
    lit, shaded = picture[48, 30].astype(int), picture[48, 66].astype(int)
    assert lit[0] > lit[2]
    assert shaded[2] > shaded[0]


@pytest.mark.parametrize("toon", [None, ToonShading()], ids=["lit", "toon"])
def test_a_white_face_is_seen_on_a_white_ground(toon: ToonShading | None, offscreen: Hire):
    white = of_ball(Material("white", WHITE, roughness=0.6, toon=toon))
    hired, camera = offscreen(white, SIZE), Camera.facing(white.mesh)
    ahead = seen(hired.picture(camera, white.mesh.positions, background=LIGHT, light=NIGHT))
    inside, beyond = binary_erosion(ahead, iterations=3), binary_dilation(ahead, iterations=3)
    for fine in (False, True):
        picture = hired.picture(camera, white.mesh.positions, background=LIGHT, glow=True, fine=fine).mean(axis=2)
        within, without = (edge & ~binary_erosion(edge) for edge in (inside, beyond))
        around = np.argwhere(within)
        near = distance_transform_edt(~without, return_indices=True, return_distances=False)
        across = picture[within] - picture[tuple(near[:, around[:, 0], around[:, 1]])]
        assert np.mean(np.abs(across) > 5) > 0.85
        assert np.ptp(picture[inside]) > (20 if toon else 40)


@pytest.mark.parametrize("toon", [None, ToonShading((0.6, 0.4, 0.4))], ids=["lit", "toon"])
def test_quick_and_fine_pictures_of_a_textured_face_agree(toon: ToonShading | None, offscreen: Hire):
    board = (
        np.kron(np.indices((8, 8)).sum(axis=0) % 2, np.ones((16, 16)))[..., np.newaxis] * np.array((90, 60, 40)) + 120
    )
    mesh = ball()
    uvs = (0.5 + mesh.positions[:, :2] / 2).astype(np.float32)
    textured = replace(RESTING, texture=texture_of(board), normal=texture_of([[(128, 128, 255)] * 2] * 2), toon=toon)
    face = MorphMesh(replace(of_ball(textured).mesh, uvs=uvs))
    quick, fine = (shot(offscreen, face, Light(), fine=fine).astype(int) for fine in (False, True))
    assert np.mean(np.abs(quick - fine).max(axis=2) > 24) < 0.05


def unread(width: int, height: int) -> Texture:
    return replace(texture_of(np.zeros((8, 8, 3))), width=width, height=height)


def test_large_textures_are_scaled_down_and_all_of_them_keep_to_a_limit(offscreen: Hire):
    large = texture_of(np.zeros((16, 2 * LARGEST, 3)))
    mesh = with_pixels(panel(replace(RESTING, texture=large)).mesh)
    (material,) = mesh.materials
    assert material.texture is not None
    assert material.texture.pixels is not None
    assert material.texture.pixels.shape == (8, LARGEST, 4)
    assert with_pixels(mesh) is mesh
    many = panel(*(replace(RESTING, name=str(k), texture=unread(LARGEST, LARGEST)) for k in range(12)))
    assert _n_pixels(with_pixels(many.mesh)) <= MOST_PIXELS


def _n_pixels(mesh: Mesh) -> int:
    return sum(
        m.texture.pixels.size // 4 for m in mesh.materials if m.texture is not None and m.texture.pixels is not None
    )


def test_textures_that_no_triangle_has_are_left_as_they_are():
    face = panel(RESTING, replace(RESTING, name="unused", texture=unread(8, 8)))
    some = replace(face.mesh, material_of=np.zeros_like(face.mesh.material_of))
    assert with_pixels(some) is some


def test_a_damaged_texture_is_refused_in_one_sentence():
    broken = Texture("skin", texture_of([[RED]]).content[:40], 1, 1)
    with pytest.raises(RenderingError, match=r"^the texture 'skin' cannot be read \(.+\); export it again$"):
        with_pixels(panel(replace(RESTING, texture=broken)).mesh)
