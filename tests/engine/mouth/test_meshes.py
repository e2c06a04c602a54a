from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.gltf import parse_gltf
from phonemeengine.mouth.files.gltf_writing import format_glb
from phonemeengine.mouth.files.io import FaceFiles, load_morph_mesh
from phonemeengine.mouth.files.obj import parse_obj
from phonemeengine.mouth.files.x_file import parse_x
from phonemeengine.mouth.mesh import Material, mesh_of, normals_of
from phonemeengine.mouth.morph_mesh import MorphMesh
from tests.meshes import (
    CORNERS,
    CUBE_OBJ,
    CUBE_X,
    FRAMES_X,
    GLTF_TEXT,
    LIBRARY,
    TRIANGLES,
    cube,
    format_obj,
    morph_mesh_of_cube,
    volume,
)

RED, BLUE = Material("red", (1.0, 0.0, 0.0)), Material("blue", (0.0, 0.0, 1.0))


class TestAMesh:
    def test_the_normals_of_a_cube_point_away_from_its_middle(self):
        inward = np.einsum("ij,ij->i", normals_of(CORNERS, TRIANGLES.astype(np.uint32)), CORNERS)
        assert np.all(inward > 1)

    def test_normals_have_length_1_even_where_no_triangle_is(self):
        mesh = mesh_of(np.vstack((CORNERS, [(5, 5, 5)])), TRIANGLES)
        np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, rtol=1e-6)

    def test_a_vertex_has_the_colour_of_its_material(self):
        mesh = mesh_of(CORNERS, [(0, 1, 2), (4, 5, 6)], materials=[RED, BLUE], material_of=[0, 1])
        assert mesh.colours[[0, 4]].tolist() == [[1, 0, 0], [0, 0, 1]]

    @pytest.mark.parametrize(
        ("positions", "triangles", "said"),
        [
            (np.empty((0, 3)), (), "1..1048576 vertices, this has 0"),
            ([(0, np.nan, 0)], (), "vertex 0 has no finite position"),
            ([(0, 0, 0), (1e39, 0, 0)], (), "vertex 1 has no finite position"),
            (CORNERS, [(0, 1, 8)], "names vertex 8, and there are 8"),
            (CORNERS, [(0, 1, -1)], "names vertex -1"),
        ],
    )
    def test_what_is_no_mesh_is_refused(self, positions: object, triangles: object, said: str):
        with pytest.raises(MeshError, match=said):
            mesh_of(positions, triangles)


@pytest.mark.parametrize(
    ("morph_mesh", "scale", "middle"),
    [
        (parse_obj(CUBE_OBJ), 1, (0, 0, 0)),
        (parse_obj(format_obj(cube())), 1, (0, 0, 0)),
        (parse_x(CUBE_X), 1, (0, 0, 0)),
        (parse_x(FRAMES_X), 2, (20, 0, -10)),
        (parse_gltf(GLTF_TEXT), 2, (10, 0, 0)),
        (parse_gltf(format_glb(morph_mesh_of_cube())), 1, (0, 0, 0)),
    ],
    ids=["obj", "obj with normals", "x", "x in frames", "gltf", "glb of ours"],
)
class TestEveryFormat:
    def test_has_the_cube_where_it_is_with_its_vertices_in_order(
        self, morph_mesh: MorphMesh, scale: float, middle: tuple
    ):
        np.testing.assert_allclose(morph_mesh.mesh.positions, scale * CORNERS + middle, atol=1e-6)

    def test_has_a_cube_that_is_seen_from_outside(self, morph_mesh: MorphMesh, scale: float, middle: tuple):
        assert volume(morph_mesh.mesh) == pytest.approx(8 * scale**3)

    def test_has_normals_that_point_outwards(self, morph_mesh: MorphMesh, scale: float, middle: tuple):
        corners = (morph_mesh.mesh.positions - np.array(middle)) / scale
        assert np.all(np.einsum("ij,ij->i", morph_mesh.mesh.normals, corners) > 0.9)


class TestObj:
    def test_materials_colour_their_faces(self):
        mesh = parse_obj(CUBE_OBJ, {"cube.mtl": LIBRARY}.get).mesh
        assert mesh.materials == (RED, BLUE)
        assert mesh.material_of.tolist() == [0] * 2 + [1] * 10

    def test_vertices_may_be_counted_backwards(self):
        mesh = parse_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n").mesh
        assert mesh.triangles.tolist() == [[0, 1, 2]]

    def test_vertices_may_have_colours(self):
        mesh = parse_obj(b"v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1\n").mesh
        assert mesh.colours.tolist() == [[1, 0.5, 0], [0, 0, 1]]

    def test_a_line_may_go_on_in_the_next(self):
        assert len(parse_obj(b"v 0 0 \\\n 0\nv 1 2\\\r\n 3\n").mesh) == 2

    def test_a_library_is_read_only_beside_the_file(self, tmp_path: Path):
        (tmp_path / "secret.mtl").write_bytes(LIBRARY)
        folder = tmp_path / "meshes"
        folder.mkdir()
        (folder / "a.obj").write_bytes(CUBE_OBJ.replace(b"cube.mtl", b"../secret.mtl"))
        (folder / "b.obj").write_bytes(CUBE_OBJ.replace(b"cube.mtl", b"near.mtl"))
        (folder / "near.mtl").write_bytes(LIBRARY)
        assert load_morph_mesh(folder / "a.obj").mesh.materials[0].colour != RED.colour
        assert load_morph_mesh(folder / "b.obj").mesh.materials[0] == RED

    @pytest.mark.parametrize(
        ("content", "said"),
        [
            (b"", "vertices, this has 0"),
            (bytes(range(256)) * 9, "vertices, this has 0"),
            (b"v 1 2\n", "line 1 holds 'v 1 2', which is no number"),
            (b"v 1 2 x\n", "line 1 holds 'v 1 2 x'"),
            (b"\nv 1 2 nan\n", "vertex 0 has no finite position"),
            (b"v 1 2 1e999\n", "vertex 0 has no finite position"),
            (b"v 0 0 0\nf 1 2 3\n", "line 2: it names vertex 2, and so far there are 1"),
            (b"v 0 0 0\nf 0 1 1\n", "line 2: it names vertex 0"),
            (b"v 0 0 0\nf -2 1 1\n", "line 2: it names vertex -2"),
            (b"v 0 0 0\nf 1//1 1//1 1//1\n", "line 2: it names normal 1, and so far there are 0"),
            (b"v 0 0 0\nf " + b"1 " * 50_000, "longer than 65536 bytes"),
        ],
    )
    def test_what_is_no_obj_file_is_refused(self, content: bytes, said: str):
        with pytest.raises(MeshError, match=said):
            parse_obj(content)


class TestX:
    def test_materials_are_read_and_colour_their_faces(self):
        mesh = parse_x(CUBE_X).mesh
        assert [m.colour for m in mesh.materials] == [RED.colour, BLUE.colour]
        assert mesh.material_of.tolist() == [0] * 2 + [1] * 10

    def test_a_material_may_be_named_that_stands_elsewhere(self):
        assert parse_x(FRAMES_X).mesh.materials == (Material("shared", (0.0, 1.0, 0.0)),)

    def test_normals_are_those_of_the_file(self):
        turned = CUBE_X.replace(b"0;0;-1;, 0;0;1;, 0;1;0;, 0;-1;0;, 1;0;0;, -1;0;0;;", b"0;1;0;, " * 5 + b"0;1;0;;")
        np.testing.assert_allclose(parse_x(turned).mesh.normals, np.tile((0, 1, 0), (8, 1)), atol=1e-6)

    @pytest.mark.parametrize(
        ("old", "new", "said"),
        [
            (b"xof 0302txt 0032", b"xof 0302bin 0032", "of the kind 'bin', and only text can be read"),
            (b"xof 0302", b"xyz 0302", "begins with 'xof 03'"),
            (b" 8; // vertices", b" 900000;", "900000 entries are announced, and there is space for"),
            (b" 8; // vertices", b" 9;", "export it again"),
            (b" 8; // vertices", b" 1e300;", "expected a finite number"),
            (b" 8; // vertices", b" -8;", "expected a whole number of 0..1048576, found -8"),
            (b" 6;\n 4;", b" 700000;\n 4;", "700000 entries are announced"),
            (b" 4;1,3,2,0;", b" 4;1,3,2,8;", "expected a whole number of 0..7, found 8"),
            (b"-1;1;-1;", b"-1;nan;-1;", "line 8: expected a finite number, found 'nan'"),
            (b" 4;5,5,5,5;", b" 3;5,5,5;", "the faces of normals are not those of the mesh"),
            (b"Mesh cube {", b"Shape cube {", "there is no mesh in it"),
            (b"Mesh cube {", b"Frame { " * 70 + b"Mesh cube {", "frames lie in more than 64 others"),
        ],
    )
    def test_what_is_no_x_file_is_refused(self, old: bytes, new: bytes, said: str):
        assert old in CUBE_X
        with pytest.raises(MeshError, match=said):
            parse_x(CUBE_X.replace(old, new, 1))

    def test_a_file_that_is_cut_off_is_refused(self):
        for length in range(0, CUBE_X.rindex(b"}"), 7):
            with pytest.raises(MeshError):
                parse_x(CUBE_X[:length])


def test_several_meshes_are_one_face_with_a_movestate_each(tmp_path: Path) -> None:
    """The mesh at rest is found by its name, or is that of the shortest one; two vertices rise in the other."""
    raised = CUBE_OBJ.replace(b"v -1 1 1\n", b"v -1 1.5 1\n").replace(b"v 1 1 1\n", b"v 1 1.5 1\n")
    assert raised != CUBE_OBJ
    for names in (("a_smile.obj", "mouth_Neutral.obj"), ("face_smile.obj", "face.obj")):
        shape, rest = (tmp_path / name for name in names)
        shape.write_bytes(raised)
        rest.write_bytes(CUBE_OBJ)
        files = FaceFiles.of_meshes([shape, rest])
        assert files == FaceFiles(rest, (shape,))
        (state,) = files.load().states
        assert (state.name, state.reach, len(state)) == (shape.stem, 0.5, 2)
    shape.write_bytes(b"v 0 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n")
    with pytest.raises(MeshError, match=r"^face_smile.obj: it has 3 vertices, and the base has 8; export"):
        files.load()
