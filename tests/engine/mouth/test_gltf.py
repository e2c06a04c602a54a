import json
import struct
from collections.abc import Callable
from copy import deepcopy

import numpy as np
import pygltflib
import pytest

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.gltf import parse_gltf
from phonemeengine.mouth.files.gltf_materials import linear_of, srgb_of
from phonemeengine.mouth.files.gltf_writing import format_glb, format_points
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh, morph_targets_of
from phonemeengine.mouth.movestate import movestate_of
from tests.meshes import CORNERS, GLTF, GLTF_TEXT, TRIANGLES, morph_mesh_of_cube, moved_by, volume


def gltf(change: Callable[[dict], object]) -> bytes:
    """The cube's glTF with a change."""
    document = deepcopy(GLTF)
    change(document)
    return json.dumps(document).encode()


NO_GLTF: dict[str, tuple[Callable[[dict], object], str]] = {
    "glTF 1": (lambda g: g.update(asset={"version": "1.0"}), "version '1.0', and this program reads glTF 2"),
    "compressed": (
        lambda g: g.update(extensionsRequired=["KHR_draco_mesh_compression"]),
        "compressed with KHR_draco",
    ),
    "no meshes": (lambda g: g.pop("meshes"), "number 0 of its meshes, and there are 0"),
    "too long": (lambda g: g["accessors"][0].update(count=9), "needs 108 bytes at 0, and its buffer has"),
    "endless": (lambda g: g["accessors"][0].update(count=2**31), "at most 6291456 entries, got 2147483648"),
    "more than a mesh has": (
        lambda g: g["accessors"][2].update(count=6_000_000),
        "at most 1048576 vertices|is of shape",
    ),
    "negative": (lambda g: g["accessors"][0].update(count=-1), "'count' must be a whole number from 0, found -1"),
    "a fraction": (lambda g: g["accessors"][0].update(count=8.5), "'count' must be a whole number from 0, found 8.5"),
    "begins far behind": (lambda g: g["accessors"][0].update(byteOffset=2**31), "its buffer has"),
    "a view too long": (lambda g: g["bufferViews"][0].update(byteLength=2**31), "its buffer has"),
    "a row too short": (lambda g: g["bufferViews"][4].update(byteStride=4), "its buffer has"),
    "an unknown type": (lambda g: g["accessors"][1].update(componentType=9), "of type 9 'SCALAR'"),
    "corners that are fractions": (
        lambda g: g["accessors"][1].update(componentType=5126, count=18),
        "are no whole numbers",
    ),
    "more changes than entries": (lambda g: g["accessors"][2]["sparse"].update(count=9), "changes 9 of 8 entries"),
    "changes beyond the end": (
        lambda g: g["accessors"][2]["sparse"]["indices"].update(bufferView=0),
        "changes entry",
    ),
    "too short": (lambda g: g["accessors"][3].update(count=7), "is of shape .7, 3., and there are 8 vertices"),
    "a loop": (lambda g: g["nodes"][1].update(children=[0]), "go in a circle"),
    "twice below": (lambda g: g["nodes"][0].update(children=[1, 1]), "below two others"),
    "two scales": (lambda g: g["nodes"][0].update(scale=[1e30] * 2), "'scale' must be 3 numbers"),
    "a huge scale": (lambda g: g["nodes"][0].update(scale=[1e29] * 3), "no finite number"),
    "no base64": (lambda g: g["buffers"][0].update(uri="data:x;base64,!!"), "is no base64"),
    "a file elsewhere": (lambda g: g["buffers"][0].update(uri="../secret.bin"), "'../secret.bin' is not beside it"),
    "a table as list": (lambda g: g.update(meshes={"a": 1}), "'meshes' must be a list of tables"),
}


class TestGltf:
    def test_sparse_and_interleaved_morph_targets_are_movestates(self):
        lid, wide = parse_gltf(GLTF_TEXT).states
        assert (lid.name, lid.numbers.tolist()) == ("lid up", [0, 1, 4, 5])
        np.testing.assert_allclose(lid.offsets, np.tile((0, 1, 0.5), (4, 1)), atol=1e-6)
        assert (wide.name, wide.numbers.tolist()) == ("wide", [1, 3])
        np.testing.assert_allclose(wide.offsets, np.tile((0.2, 0, 0), (2, 1)), atol=1e-6)

    def test_targets_without_names_are_numbered(self):
        nameless = parse_gltf(gltf(lambda g: g["meshes"][0].pop("extras")))
        assert [state.name for state in nameless.states] == ["target_0", "target_1"]

    def test_targets_of_one_name_in_two_parts_are_one_state(self):
        twice = parse_gltf(gltf(lambda g: g["meshes"][0]["primitives"].append(g["meshes"][0]["primitives"][0])))
        assert len(twice.mesh) == 16
        assert [state.name for state in twice.states] == ["lid up", "wide"]
        assert twice.states[1].numbers.tolist() == [1, 3, 9, 11]

    def test_what_bones_carry_stays_where_it_is(self):
        skinned = parse_gltf(gltf(lambda g: g["nodes"][1].update(skin=0)))
        np.testing.assert_array_equal(skinned.mesh.positions, CORNERS)

    def test_a_quarter_turn_about_y_brings_the_front_to_the_right(self):
        half = 0.5**0.5
        turned = parse_gltf(gltf(lambda g: g.update(nodes=[{"mesh": 0, "rotation": [0, half, 0, half]}])))
        by_matrix = [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]
        same = parse_gltf(gltf(lambda g: g.update(nodes=[{"mesh": 0, "matrix": by_matrix}])))
        for morph_mesh in (turned, same):
            np.testing.assert_allclose(morph_mesh.mesh.positions[0], (1, 1, 1), atol=1e-6)  # was (-1, 1, 1)
            assert volume(morph_mesh.mesh) == pytest.approx(8)

    def test_strips_and_fans_are_triangles(self):
        quad = {
            "asset": {"version": "2.0"},
            "nodes": [],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        }
        for mode, square in ((5, [(0, 0), (1, 0), (0, 1), (1, 1)]), (6, [(0, 0), (1, 0), (1, 1), (0, 1)])):
            points = np.array([(*corner, 0) for corner in square], "<f4")
            quad["meshes"][0]["primitives"][0]["mode"] = mode
            quad |= {
                "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}],
                "bufferViews": [{"buffer": 0, "byteLength": 48}],
                "buffers": [{"byteLength": 48, "uri": "a.bin"}],
            }
            mesh = parse_gltf(json.dumps(quad).encode(), {"a.bin": points.tobytes()}.get).mesh
            assert len(mesh.triangles) == 2
            np.testing.assert_allclose(mesh.normals, np.tile((0, 0, 1), (4, 1)), atol=1e-6)

    def test_colours_turn_linear_and_back(self):
        colours = np.linspace(0, 1, 30, dtype=np.float32).reshape(10, 3)
        np.testing.assert_allclose(srgb_of(linear_of(colours)), colours, atol=1e-6)
        assert float(linear_of(np.full(1, 0.5, np.float32))[0]) == pytest.approx(0.21404, abs=1e-4)

    @pytest.mark.parametrize(("change", "said"), NO_GLTF.values(), ids=NO_GLTF)
    def test_what_is_no_gltf_is_refused(self, change: Callable[[dict], object], said: str):
        with pytest.raises(MeshError, match=said) as refusal:
            parse_gltf(gltf(change))
        assert len(str(refusal.value)) < 300

    def test_many_targets_that_share_one_array_are_refused_before_they_fill_the_memory(self):
        def change(document: dict) -> None:
            document["accessors"] = [{"componentType": 5126, "count": 1 << 20, "type": "VEC3"}]
            targets = [{"POSITION": 0}] * 1000
            document["meshes"][0]["primitives"] = [{"attributes": {"POSITION": 0}, "targets": targets}]

        with pytest.raises(MeshError, match="all morph targets have at most 33554432 vertices together"):
            parse_gltf(gltf(change))

    @pytest.mark.parametrize("content", [b"", b"{", b"[]", b"{}", b"[" * 100_000, b"glTF", b"glTF" + bytes(40), b"3"])
    def test_garbage_is_refused(self, content: bytes):
        with pytest.raises(MeshError):
            parse_gltf(content)


class TestGlbOfOurs:
    """What we write, read by a library that we do not use to write it."""

    def document(self, content: bytes) -> tuple[pygltflib.GLTF2, bytes]:
        read = pygltflib.GLTF2.load_from_bytes(content)
        return read, read.binary_blob()

    def vectors(self, read: pygltflib.GLTF2, blob: bytes, place: int) -> np.ndarray:
        accessor = read.accessors[place]
        view = read.bufferViews[accessor.bufferView]
        width = {"VEC3": 3, "SCALAR": 1}[accessor.type]
        kind = {5126: "<f4", 5125: "<u4"}[accessor.componentType]
        return np.frombuffer(blob, kind, accessor.count * width, view.byteOffset).reshape(-1, width)

    def test_another_reader_finds_the_mesh_and_each_target(self):
        morph_mesh = morph_mesh_of_cube()
        read, blob = self.document(format_glb(morph_mesh))
        (mesh,) = read.meshes
        (primitive,) = mesh.primitives
        assert mesh.extras["targetNames"] == ["lid up", "größer", "still"]
        assert mesh.weights == [0, 0, 0]
        np.testing.assert_array_equal(self.vectors(read, blob, primitive.attributes.POSITION), CORNERS)
        np.testing.assert_array_equal(self.vectors(read, blob, primitive.indices).reshape(-1, 3), TRIANGLES)
        targets = [self.vectors(read, blob, target["POSITION"]) for target in primitive.targets]
        np.testing.assert_array_equal(targets[0], moved_by((0, 1, 4, 5), (0, 0.5, 0.25)))
        np.testing.assert_array_equal(targets[2], np.zeros((8, 3)))
        assert read.accessors[primitive.attributes.POSITION].min == [-1, -1, -1]
        assert len(blob) == read.buffers[0].byteLength

    def test_it_is_padded_and_measured_as_the_format_asks(self):
        content = format_glb(morph_mesh_of_cube())
        size, text = struct.unpack_from("<II", content, 8)
        assert size == len(content)
        assert size % 4 == text % 4 == 0

    def test_reading_it_gives_the_same_figure(self):
        colours = np.random.default_rng(0).random((8, 3)).astype(np.float32)
        mesh = mesh_of(CORNERS, TRIANGLES, name="cube", colours=colours)
        for sparse in (False, True):
            read = parse_gltf(format_glb(MorphMesh(mesh, morph_mesh_of_cube().states), sparse=sparse))
            assert read.mesh.name == "cube"
            np.testing.assert_array_equal(read.mesh.triangles, TRIANGLES)
            np.testing.assert_allclose(read.mesh.colours, colours, atol=1e-6)
            assert [s.numbers.tolist() for s in read.states] == [[0, 1, 4, 5], [1, 3], []]

    def test_points_keep_their_numbers_where_the_mesh_is_not_known(self):
        mesh = mesh_of(np.arange(300).reshape(100, 3))
        state = movestate_of("s", np.where(np.arange(100)[:, np.newaxis] % 40 == 39, 1.0, 0.0) * np.ones(3))
        read = parse_gltf(format_points(morph_targets_of(mesh, [state])))
        assert read.states[0].numbers.tolist() == [39, 79]
        np.testing.assert_array_equal(read.mesh.positions[[39, 79]], mesh.positions[[39, 79]])
