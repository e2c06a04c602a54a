"""The renderer: what a head looks like is known from optics, before any picture is taken."""

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.ndimage import binary_fill_holes

from phonemeanalyser.rendering import RenderingError, draws_in_software
from phonemeanalyser.rendering.camera import Camera, Light
from phonemeanalyser.rendering.renderer import INSIDE, HeadRenderer, OffscreenRenderer, colour_of, offscreen_context
from phonemeanalyser.rendering.surface import subdivided
from phonemeengine.arrays import Float32Array
from phonemeengine.errors import EngineError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.expression.streams import expression_presets, held_expression
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import Framing, Head, MorphMesh, load_head
from phonemeengine.mouth.movestate import MovestateSet
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import Phoneme
from tests.graphics import DARK, LIGHT, MAGENTA, Picture, ball, context, joined, offscreen, seen
from tests.meshes import cube, morph_mesh_of_cube

__all__ = ["context", "offscreen"]  # fixtures
EYES, TEETH, TONGUE, LASHES = (1, 3), (2, 5), (4,), 7
"""The numbers of these parts in the head's file."""
Hire = Callable[..., OffscreenRenderer]


@pytest.fixture(scope="module")
def head() -> MorphMesh:
    return load_head("man")


@pytest.fixture(scope="module")
def plain(head: MorphMesh) -> MorphMesh:
    """The head without lashes and brows, which have a back, and are as dark as what is inside."""
    with np.load(Head.MAN.path, allow_pickle=False) as file:
        kept = file["part"][head.mesh.triangles[:, 0]] != LASHES
    mesh = mesh_of(head.mesh.positions, head.mesh.triangles[kept], colours=head.mesh.colours)
    return MorphMesh(mesh, head.states)


def test_renderers_that_are_programs_are_told_from_graphics_cards() -> None:
    names = "llvmpipe (LLVM 15.0.6, 256 bits)", "Google SwiftShader", "NVIDIA GeForce RTX 3060", "Mesa Intel(R) UHD"
    assert [draws_in_software(name) for name in names] == [True, True, False, False]


def saying(head: MorphMesh, phoneme: Phoneme) -> Float32Array:
    table, face = load_table("arkit"), MovestateSet(head.mesh, head.states)
    shape = table.weights()[phoneme] * 100
    face.set_percentages(dict(zip(table.movestates, shape.tolist(), strict=True)))
    return face.morphed()


def painted(head: MorphMesh, *colours: tuple[tuple[int, ...], tuple[float, float, float]]) -> MorphMesh:
    """The head with some of its parts, by their numbers in its file, in other colours."""
    with np.load(Head.MAN.path, allow_pickle=False) as file:
        part = file["part"]
    looks = head.mesh.colours.copy()
    for parts, colour in colours:
        looks[np.isin(part, parts)] = colour
    return replace(head, mesh=replace(head.mesh, colours=looks))


def expressing(head: MorphMesh, names: tuple[str, ...], blink: float) -> Float32Array:
    """Where the head's vertices are when it shows some expressions at once, each wholly."""
    weights = np.array(held_expression(dict.fromkeys(names, 1.0)).weights(0.0)) * 100
    lids = [ARKIT.index("eyeBlinkLeft"), ARKIT.index("eyeBlinkRight")]
    weights[lids] = np.maximum(weights[lids], blink * 100)
    face = MovestateSet(head.mesh, head.states)
    face.set_percentages(dict(zip(ARKIT, weights.tolist(), strict=True)))
    return face.morphed()


def darkness(picture: Picture, part: tuple[slice, slice]) -> int:
    return int((picture[part].max(axis=2) < 90).sum())


def irises(picture: Picture) -> NDArray[np.int_]:
    """Rows and columns of blue pixels, of which a face above its chin has none but there, shape (n, 2)."""
    picture = picture[: len(picture) * 2 // 3]
    red, _, blue = (picture[..., k].astype(int) for k in range(3))
    return np.argwhere((blue > red + 12) & seen(picture))


def test_closed_lips_hide_the_dark_of_the_mouth_and_open_ones_show_it(head: MorphMesh, offscreen: Hire):
    camera = Camera.facing(head.mesh)
    shown = {
        phoneme: offscreen(head).picture(camera, saying(head, phoneme), background=LIGHT)
        for phoneme in (Phoneme.SILENCE, Phoneme.M, Phoneme.E, Phoneme.A)
    }
    mouth = slice(140, 172), slice(95, 145)
    dark = {phoneme: darkness(picture, mouth) for phoneme, picture in shown.items()}
    assert dark[Phoneme.A] > 1.2 * dark[Phoneme.E] > 0
    assert dark[Phoneme.E] > 4 * max(dark[Phoneme.M], dark[Phoneme.SILENCE])
    forehead = slice(0, 70)
    assert np.array_equal(shown[Phoneme.M][forehead], shown[Phoneme.SILENCE][forehead])


def test_from_the_other_side_the_head_is_its_mirror_image(head: MorphMesh, offscreen: Hire):
    camera, shown = Camera.facing(head.mesh), []
    for side in (1, -1):
        picture = offscreen(head).picture(camera.orbit(side * 0.7, 0.1), head.mesh.positions, background=DARK)
        shown.append(seen(picture))
    right, left = shown[0], shown[1][:, ::-1]
    assert (right & left).sum() > 0.985 * (right | left).sum()
    assert (right & left[:, ::-1]).sum() < 0.9 * (right | left[:, ::-1]).sum()


@pytest.mark.parametrize("yaw", [-4.5, 5.5])
def test_no_speck_of_the_inside_shows_along_an_outline(yaw: float, plain: MorphMesh, offscreen: Hire):
    hired, camera = offscreen(plain, (536, 446)), Camera.facing(plain.mesh)
    for nod in (-1, 0, 1, 2):
        pose = HeadPose(yaw=yaw, pitch=nod * yaw / 3)
        picture = hired.picture(camera, plain.mesh.positions, pose, background=LIGHT, fine=False)
        assert np.abs(picture - np.multiply(255, INSIDE)).max(axis=2).min() > 3


def test_nobody_looks_through_an_open_mouth(head: MorphMesh, offscreen: Hire):
    positions, camera = saying(head, Phoneme.A), Camera.facing(head.mesh).zoom(6)
    hired = offscreen(head, (320, 320))
    for azimuth in (-1.2, 0.0, 1.2):
        for elevation in (-0.5, 0.5):
            picture = hired.picture(camera.orbit(azimuth, elevation), positions, background=MAGENTA)
            head_alone = np.any(picture != (255, 0, 255), axis=2)
            face = slice(120, 280), slice(40, 280)
            assert np.array_equal(binary_fill_holes(head_alone)[face], head_alone[face])


def test_wires_let_the_background_through_and_reach_no_farther_than_the_skin(head: MorphMesh, offscreen: Hire):
    hired, camera = offscreen(head, (640, 640)), Camera.facing(head.mesh)
    skin, wires = (
        seen(hired.picture(camera, head.mesh.positions, background=LIGHT, wireframe=wireframe))
        for wireframe in (False, True)
    )
    assert 0.2 * skin.sum() < wires.sum() < 0.95 * skin.sum()
    assert (wires & ~skin).sum() < 0.02 * skin.sum()


@pytest.mark.parametrize("size", [(16, 16), (101, 57), (57, 101)])
def test_a_picture_has_the_size_that_was_asked_for_and_all_of_the_head(
    size: tuple[int, int], head: MorphMesh, offscreen: Hire
):
    picture = offscreen(head, size).picture(Camera.facing(head.mesh), head.mesh.positions, background=DARK)
    assert picture.shape == (size[1], size[0], 3)
    shown = seen(picture)
    above_the_shoulders = shown[: 2 * size[1] // 3]
    edges = np.concatenate((above_the_shoulders[0], above_the_shoulders[:, 0], above_the_shoulders[:, -1]))
    assert not edges.any()
    rows, columns = np.argwhere(above_the_shoulders).T
    assert max(np.ptp(rows) / size[1], np.ptp(columns) / size[0]) > 0.4


def test_a_transparent_picture_shows_the_head_alone_with_its_own_colours(head: MorphMesh, offscreen: Hire):
    camera, hired = Camera.facing(head.mesh), offscreen(head, (160, 160))
    clear = hired.picture(camera, head.mesh.positions, background=None, glow=True)
    bright, dark = (hired.picture(camera, head.mesh.positions, background=ground) for ground in (LIGHT, DARK))
    assert clear.shape == (160, 160, 4)
    opaque = clear[..., 3:] / 255
    assert {0, 255} < {*np.unique(clear[..., 3]).tolist()}
    for ground, picture in ((LIGHT, bright), (DARK, dark)):
        laid = opaque * clear[..., :3] + (1 - opaque) * 255 * np.array(ground)
        assert np.abs(laid - picture).max() <= 3


def test_mouth_face_and_bust_show_less_and_more(head: MorphMesh, offscreen: Hire):
    red = painted(head, (TEETH, MAGENTA))
    hired, positions = offscreen(red, (200, 200)), saying(red, Phoneme.I)
    teeth, shown = [], []
    for framing in (Framing.MOUTH, Framing.FACE, Framing.BUST):
        picture = hired.picture(Camera.facing(head.mesh, framing), positions, background=DARK)
        teeth.append(_n_magenta(picture))
        shown.append(np.argwhere(seen(picture))[:, 0].min())
    assert teeth[0] > 5 * teeth[1] > 5 * teeth[2]
    assert shown[0] == 0 < shown[1]
    assert seen(picture)[-1].any()  # the lower edge of the bust is below the picture


def test_pictures_may_change_their_size(head: MorphMesh, offscreen: Hire):
    camera, positions = Camera.facing(head.mesh), head.mesh.positions
    hired = offscreen(head, (64, 48))
    for size in ((80, 101), (64, 48)):
        hired.resize(size)
        wanted = offscreen(head, size).picture(camera, positions, background=DARK)
        assert np.array_equal(hired.picture(camera, positions, background=DARK), wanted)


def test_closed_lips_hide_the_teeth_and_open_ones_show_them(head: MorphMesh, offscreen: Hire):
    """Teeth, which are the whitest of all but the eyes, are painted magenta."""
    magenta = painted(head, (TEETH, MAGENTA))
    for morph_mesh in (magenta, subdivided(magenta)):
        hired, camera = offscreen(morph_mesh, (300, 300)), Camera.facing(morph_mesh.mesh).zoom(10).pan(0.0, -0.16)
        n_seen = {
            phoneme: max(
                _n_magenta(hired.picture(camera.orbit(azimuth, 0.0), positions, background=DARK))
                for positions in [saying(morph_mesh, phoneme)]
                for azimuth in (0.0, 0.7)
            )
            for phoneme in (Phoneme.SILENCE, Phoneme.M, Phoneme.P, Phoneme.U, Phoneme.SZ)
        }
        closed = max(n_seen[phoneme] for phoneme in (Phoneme.SILENCE, Phoneme.M, Phoneme.P))
        assert closed < 0.005 * n_seen[Phoneme.SZ]
        assert n_seen[Phoneme.U] < 0.25 * n_seen[Phoneme.SZ]


def test_the_tongue_is_seen_for_th_and_neither_at_rest_nor_for_f(head: MorphMesh, offscreen: Hire):
    """As the head is looked at in the window; the tongue is painted magenta."""
    table, magenta = load_table("arkit"), painted(head, (TONGUE, MAGENTA))
    shapes = dict(zip(table.shapes, table.shape_weights() * 100, strict=True))
    hired, camera, n_seen = offscreen(magenta, (480, 480)), Camera.facing(head.mesh), {}
    for name in ("silence", "th", "f", "m"):
        face = MovestateSet(magenta.mesh, magenta.states)
        face.set_percentages(dict(zip(table.movestates, shapes[name].tolist(), strict=True)))
        n_seen[name] = _n_magenta(hired.picture(camera, face.morphed(), background=DARK))
    assert n_seen["th"] > 250
    assert max(n_seen[name] for name in ("silence", "f", "m")) == 0


@pytest.mark.parametrize("blink", [0.0, 0.6])
def test_no_expression_nor_two_of_them_tear_the_lids(blink: float, plain: MorphMesh, offscreen: Hire):
    """Eyes are painted as bright as skin, so that all that is nearly black is an inside."""
    names = [*expression_presets()]
    shown = [(), *((name,) for name in names), *combinations(names, 2)]
    faces = [expressing(plain, kept, blink) for kept in shown]
    hired = offscreen(painted(plain, (EYES, (0.9, 0.85, 0.8))), (600, 200))
    camera = Camera.facing(plain.mesh).zoom(14).pan(0.0, 0.28)  # eyes and brows
    for azimuth in (0.0, 0.7):
        turned = camera.orbit(azimuth, 0.0)
        n_dark = [
            int((hired.picture(turned, face, background=LIGHT, fine=False).max(axis=2) < 50).sum()) for face in faces
        ]
        assert max(n_dark) <= n_dark[0] + 3, shown[int(np.argmax(n_dark))]


def _n_magenta(picture: Picture) -> int:
    red, green, blue = (picture[..., k].astype(int) for k in range(3))
    return int(((blue > 2 * green) & (red > 2 * green)).sum())


@pytest.mark.parametrize("colour", ["#1f2228", "#ffffff"])
def test_the_background_has_exactly_the_colour_of_the_theme(colour: str, head: MorphMesh, offscreen: Hire):
    picture = offscreen(head, (64, 64)).picture(
        Camera.facing(head.mesh), head.mesh.positions, background=colour_of(colour)
    )
    assert bytes(picture[0, 0]).hex() == bytes(picture[0, -1]).hex() == colour[1:]


def test_the_same_head_looks_the_same_in_every_picture(head: MorphMesh, offscreen: Hire):
    camera, positions = Camera.facing(head.mesh).orbit(0.3, 0.1), saying(head, Phoneme.O)
    hired = offscreen(head)
    first = hired.picture(camera, positions, background=DARK)
    other = hired.picture(camera, saying(head, Phoneme.I), background=DARK)
    again = hired.picture(camera, saying(head, Phoneme.O), background=DARK)
    assert np.array_equal(first, again)
    assert np.array_equal(first, offscreen(head).picture(camera, positions, background=DARK))
    assert not np.array_equal(first, other)


@pytest.mark.parametrize(("pose", "axis", "sign"), [(HeadPose(yaw=15), 1, 1), (HeadPose(pitch=-12), 0, 1)])
def test_a_head_that_turns_takes_its_eyes_along(
    pose: HeadPose, axis: int, sign: int, head: MorphMesh, offscreen: Hire
):
    hired, camera = offscreen(head), Camera.facing(head.mesh)
    ahead, turned = (
        irises(hired.picture(camera, head.mesh.positions, how, background=LIGHT)).mean(axis=0)
        for how in (HeadPose(), pose)
    )
    assert sign * (turned - ahead)[axis] > 5


def test_a_head_that_rolls_to_its_left_shoulder_lowers_its_left_eye(head: MorphMesh, offscreen: Hire):
    camera = Camera.facing(head.mesh)
    picture = offscreen(head).picture(camera, head.mesh.positions, HeadPose(roll=12), background=LIGHT)
    rows, columns = irises(picture).T
    left_eye = columns > columns.mean()  # it is on the viewer's right
    assert rows[left_eye].mean() > rows[~left_eye].mean() + 5


def test_the_neck_stays_where_it_is_when_the_head_turns(head: MorphMesh, offscreen: Hire):
    hired, camera = offscreen(head), Camera.facing(head.mesh)
    ahead, turned = (
        seen(hired.picture(camera, head.mesh.positions, how, background=LIGHT))
        for how in (HeadPose(), HeadPose(15, 8, 5))
    )
    lowest = slice(int(np.argwhere(ahead)[:, 0].max()) - 4, None)
    assert (ahead[lowest] != turned[lowest]).sum() <= 0.03 * ahead[lowest].sum()
    assert (ahead != turned).sum() > 0.03 * ahead.sum()


@pytest.mark.parametrize("azimuth", [-1.2, 1.2])
def test_the_side_that_the_light_comes_from_is_the_bright_one(azimuth: float, offscreen: Hire):
    hired = offscreen(MorphMesh(ball()))
    camera = Camera.facing(ball())
    picture = hired.picture(camera, ball().positions, background=DARK, light=Light(azimuth, 0.0)).astype(float)
    left, right = picture[60:180, 60:120].mean(), picture[60:180, 120:180].mean()
    assert (right - left) * azimuth > 10


def test_without_light_everything_is_black_but_the_background(offscreen: Hire):
    picture = offscreen(MorphMesh(ball())).picture(
        Camera.facing(ball()), ball().positions, background=LIGHT, light=Light(strength=0.0)
    )
    assert picture[120, 120].max() == 0
    assert picture[0, 0].min() > 200


LARGE, SMALL = ball(), ball(0.2)
ASKANCE = replace(Camera.facing(LARGE), azimuth=0.9)


def darkened(offscreen: Hire, *, fine: bool) -> NDArray[np.int_]:
    """Tell by how much a small ball between a large one and the light darkens it; the camera looks past it."""
    scene = joined(LARGE, replace(SMALL, positions=SMALL.positions + np.float32((0.0, 0.0, 1.6))))
    aside = scene.positions.copy()
    aside[len(LARGE) :] -= np.float32((0.0, 0.0, 3.4))
    hired, light = offscreen(MorphMesh(scene)), Light(-0.9, 0.0, 0.7)  # so weak that no tone is compressed
    shadowed, plain = (
        hired.picture(ASKANCE, positions, background=DARK, light=light, fine=fine).astype(int).sum(axis=2)
        for positions in (scene.positions, aside)
    )
    alone = seen(offscreen(MorphMesh(LARGE)).picture(ASKANCE, LARGE.positions, background=DARK))
    return np.where(alone, plain - shadowed, 0)


def test_the_edge_of_a_shadow_is_soft_in_a_fine_picture(offscreen: Hire):
    """Its soft edge is the part of it that is neither dark nor bright."""
    shares = []
    for fine in (False, True):
        dark = darkened(offscreen, fine=fine)
        shadow = dark > 0.1 * dark.max()
        shares.append((dark[shadow] < 0.8 * dark.max()).mean())
    assert shares[1] > 1.5 * shares[0]


@pytest.mark.parametrize("fine", [False, True])
def test_what_stands_in_the_light_casts_a_shadow(offscreen: Hire, fine: bool):
    dark = darkened(offscreen, fine=fine)
    alone = seen(offscreen(MorphMesh(LARGE)).picture(ASKANCE, LARGE.positions, background=DARK))
    rows, columns = np.argwhere(dark > 60).T
    middle, radius = 119.5, np.ptp(np.argwhere(alone)[:, 0]) / 2
    assert len(rows) > 100
    assert rows.mean() == pytest.approx(middle, abs=3)
    assert columns.mean() == pytest.approx(middle - radius * math.sin(0.9), abs=0.15 * radius)


@pytest.mark.parametrize("fine", [False, True])
def test_between_the_head_and_what_is_behind_it_lie_colours_of_both(head: MorphMesh, offscreen: Hire, fine: bool):
    black = Light(strength=0.0)
    picture = offscreen(head).picture(
        Camera.facing(head.mesh), head.mesh.positions, background=LIGHT, light=black, fine=fine
    )
    red = picture[:60, :, 0].astype(int)  # the crown, an arc
    inside = red < 20
    edge = np.diff(inside, axis=0).sum() + np.diff(inside, axis=1).sum()
    assert ((red > 20) & (red < 225)).sum() > 0.3 * edge


def test_what_is_seen_from_its_back_is_dark(offscreen: Hire):
    """A box without its front: its inside is seen, and it is neither the background nor in the light."""
    whole = cube()
    box = mesh_of(whole.positions, whole.triangles[2:])
    picture = offscreen(MorphMesh(box), (120, 120)).picture(Camera.facing(box), box.positions, background=MAGENTA)
    assert picture[60, 60].max() < 50
    closed = offscreen(MorphMesh(whole), (120, 120)).picture(
        Camera.facing(whole), whole.positions, background=MAGENTA
    )
    assert closed[60, 60].min() > 120


def test_any_mesh_can_be_drawn_from_any_side(offscreen: Hire):
    morph_mesh = morph_mesh_of_cube()
    camera = Camera.facing(morph_mesh.mesh)
    hired = offscreen(morph_mesh, (120, 120))
    areas = [
        int(seen(hired.picture(camera.orbit(azimuth, elevation), morph_mesh.mesh.positions, background=DARK)).sum())
        for azimuth in (0.0, math.pi / 2, math.pi)
        for elevation in (-1.4, 0.0, 1.4)
    ]
    assert min(areas) > 0.5 * max(areas) > 1000


def test_a_renderer_leaves_its_framebuffer_bound_and_can_be_made_again(context, head: MorphMesh):
    camera = Camera.facing(head.mesh)
    for size in ((50, 40), (80, 80)):
        target = context.framebuffer(context.renderbuffer(size, 4))
        renderer = HeadRenderer(context, head)
        target.use()
        renderer.draw(camera, head.mesh.positions, size=size, background=MAGENTA)
        picture = np.frombuffer(target.read(components=3, alignment=1), np.uint8).reshape(size[1], size[0], 3)
        assert picture[-1, 0].tolist() == [255, 0, 255]  # OpenGL begins below, where the shoulders are
        assert seen(picture).sum() > 100
        assert context.error == "GL_NO_ERROR"
        renderer.release()


def test_a_mesh_without_triangles_is_refused(offscreen: Hire):
    with pytest.raises(RenderingError, match="the mesh has no triangles, so there is nothing to be seen"):
        offscreen(MorphMesh(mesh_of([(0, 0, 0), (1, 1, 1)])))


@pytest.mark.parametrize("scale", [1e-4, 1e5])
def test_the_unit_of_a_mesh_does_not_matter(scale: float, head: MorphMesh, offscreen: Hire):
    mesh = head.mesh
    other = mesh_of(mesh.positions * np.float32(scale), mesh.triangles, colours=mesh.colours)
    shown = [
        offscreen(MorphMesh(one)).picture(Camera.facing(one).orbit(0.4, 0.0), one.positions, background=DARK)
        for one in (mesh, other)
    ]
    assert np.mean(np.abs(shown[0].astype(int) - shown[1]) > 8) < 0.01


def test_a_picture_too_large_for_the_driver_is_refused_in_one_sentence(head: MorphMesh, offscreen: Hire):
    with pytest.raises(RenderingError, match=r"make them smaller$"):
        offscreen(head, (200_000, 200_000))


@pytest.mark.usefixtures("no_opengl")
def test_a_machine_without_opengl_is_told_in_one_sentence():
    with pytest.raises(
        RenderingError, match=r"there is none \(libEGL.so.1 not loaded\); install a graphics"
    ) as caught:
        offscreen_context()
    assert isinstance(caught.value, EngineError)
    assert "\n" not in str(caught.value)
