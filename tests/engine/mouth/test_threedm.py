import struct
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.io import load_morph_targets, save_morph_targets
from phonemeengine.mouth.files.threedm import format_3dm, format_3dma, parse_3dm, parse_3dma
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphTargets, morph_targets_of
from phonemeengine.mouth.movestate import movestate_at
from tests.meshes import morph_mesh_of_cube

HUGE = 0xFFFF_FFFF
NAN = float("nan")


def block(numbers: tuple[int, ...] = (), *vectors: float, n: int | None = None) -> bytes:
    """A count, vertex numbers and vectors, as the thesis has them; the count may lie."""
    return struct.pack(f"<I{len(numbers)}I{len(vectors)}f", len(numbers) if n is None else n, *numbers, *vectors)


def state(name: bytes, *rest: bytes, length: int | None = None) -> bytes:
    """A movestate; the length of its name may lie."""
    return struct.pack("<I", len(name) if length is None else length) + name + b"".join(rest)


def file(*states: bytes, n: int | None = None, moving: bytes = b"") -> bytes:
    """A whole file; the number of states may lie."""
    return b"3dm01\0" + struct.pack("<I", len(states) if n is None else n) + b"".join(states) + moving


ONE = state(b"smile", block((3, 5), 1, 2, 3, 4, 5, 6))
MOVING = block((3, 5), 10, 20, 30, 40, 50, 60)
GOOD = file(ONE, moving=MOVING)


def faces() -> st.SearchStrategy[MorphTargets]:
    """Faces of a mesh of twenty vertices."""
    generator = np.random.default_rng(0)
    mesh = mesh_of(generator.standard_normal((20, 3)))
    numbers = st.lists(st.integers(0, 19), unique=True, max_size=8)
    shape = st.tuples(st.text("aäß 字:", min_size=1, max_size=9).map(lambda t: f"n{t}n"), numbers)
    return st.lists(shape, max_size=4, unique_by=lambda s: s[0]).map(
        lambda shapes: morph_targets_of(
            mesh, [movestate_at(name, n, generator.standard_normal((len(n), 3))) for name, n in shapes]
        )
    )


def same(a: MorphTargets, b: MorphTargets) -> bool:
    """Whether two faces are equal to the last bit."""
    return (
        [s.name for s in a.states] == [s.name for s in b.states]
        and all(np.array_equal(s.numbers, t.numbers) for s, t in zip(a.states, b.states, strict=True))
        and all(np.array_equal(s.offsets, t.offsets) for s, t in zip(a.states, b.states, strict=True))
        and np.array_equal(a.numbers, b.numbers)
        and np.array_equal(a.positions, b.positions)
    )


class TestTheLayout:
    def test_a_file_of_the_thesis_is_read_with_z_turned_round(self):
        face = parse_3dm(GOOD)
        (smile,) = face.states
        assert (smile.name, smile.numbers.tolist()) == ("smile", [3, 5])
        assert smile.offsets.tolist() == [[1, 2, -3], [4, 5, -6]]
        assert face.numbers.tolist() == [3, 5]
        assert face.positions.tolist() == [[10, 20, -30], [40, 50, -60]]

    def test_what_is_written_is_the_thesis_layout_to_the_byte(self):
        assert format_3dm(parse_3dm(GOOD)) == GOOD

    def test_a_name_of_an_old_windows_and_a_nul_at_its_end_are_read(self):
        read = parse_3dm(file(state("größer".encode("cp1252") + b"\0", block()), moving=block()))
        assert read.states[0].name == "größer"

    def test_text_says_the_same_with_captions(self):
        lines = format_3dma(parse_3dm(GOOD)).decode().splitlines()
        assert [line for line in lines if line] == [
            "3dma01",
            "number of movestates: 1",
            "movestate: smile",
            "vertices: 2",
            "3 1.0 2.0 3.0",
            "5 4.0 5.0 6.0",
            "all vertices that move: 2",
            "3 10.0 20.0 30.0",
            "5 40.0 50.0 60.0",
        ]

    @given(face=faces())
    def test_both_formats_keep_every_bit(self, face: MorphTargets):
        assert same(parse_3dm(format_3dm(face)), face)
        assert same(parse_3dma(format_3dma(face)), face)

    @pytest.mark.parametrize("kind", [".3dm", ".3dma", ".glb"])
    def test_what_is_saved_is_loaded(self, tmp_path: Path, kind: str):
        morph_mesh = morph_mesh_of_cube()
        face = morph_targets_of(morph_mesh.mesh, morph_mesh.states)
        save_morph_targets(face, tmp_path / f"face{kind}")
        assert same(load_morph_targets(tmp_path / f"face{kind}"), face)
        assert [path.name for path in tmp_path.iterdir()] == [f"face{kind}"]


REFUSED = {
    "empty": (b"", "begins with 3dm01"),
    "another magic": (b"3dm02\0" + GOOD[6:], "begins with 3dm01"),
    "only the magic": (b"3dm01\0", "ends before the number of movestates"),
    "more states than there is room": (file(ONE, n=HUGE, moving=MOVING), "movestates is said to be 4294967295"),
    "one state more": (file(ONE, n=2, moving=MOVING), "the name of movestate 1|is said to be"),
    "one state less": (file(ONE, ONE, n=1, moving=MOVING), "lacks|is said to be|follow its end"),
    "endless name": (file(state(b"smile", length=HUGE)), "name of movestate 0 is said to be 4294967295"),
    "more vertices than there is room": (
        file(state(b"s", block((3,), 1, 2, 3, n=HUGE)), moving=MOVING),
        "'s' is said to be 4294967295, .* space for 3",
    ),
    "more moving vertices": (file(ONE, moving=block((3, 5), 1, 2, 3, n=1 << 20)), "that move is said to be 1048576"),
    "one byte less": (GOOD[:-1], "space for 1"),
    "one byte more": (GOOD + b"x", "1 bytes follow its end"),
    "a NaN": (file(state(b"s", block((3,), 1, NAN, 3)), moving=MOVING), "'s' holds an offset that is no finite"),
    "a signalling NaN": (
        file(state(b"s", struct.pack("<II", 1, 3) + b"\x01\x00\xa0\x7f" * 3), moving=MOVING),
        "'s' holds an offset that is no finite",
    ),
    "an infinity": (file(ONE, moving=block((3, 5), *[1] * 5, float("inf"))), "no finite number"),
    "a vertex beyond any mesh": (file(state(b"s", block((HUGE,), 1, 2, 3)), moving=MOVING), "vertex 4294967295"),
    "a vertex twice": (file(state(b"s", block((3, 3), *[1] * 6)), moving=MOVING), "vertex 3 twice"),
    "a vertex that is not listed": (file(state(b"s", block((4,), 1, 2, 3)), moving=MOVING), "vertex 4, which the"),
    "two states of one name": (file(ONE, ONE, moving=MOVING), "two movestates are called 'smile'"),
    "no name": (file(state(b"", block()), moving=block()), "got ''"),
    "a name of two lines": (file(state(b"a\nb", block()), moving=block()), "the name of a movestate is"),
    "a name in no alphabet": (file(state(b"\x81\x8d", block()), moving=block()), "movestate 0 is no text"),
}


@pytest.mark.parametrize(("content", "said"), REFUSED.values(), ids=REFUSED)
def test_a_wrong_3dm_file_is_refused_with_what_is_wrong(content: bytes, said: str):
    with pytest.raises(MeshError, match=said) as refusal:
        parse_3dm(content)
    assert len(str(refusal.value)) < 300


def test_a_3dm_file_that_is_cut_off_is_refused_wherever_it_is_cut():
    for length in range(len(GOOD)):
        with pytest.raises(MeshError):
            parse_3dm(GOOD[:length])


TEXT = format_3dma(parse_3dm(GOOD)).decode()
CHANGES = {
    "another title": ("3dma01", "3dma02", "begins with a line '3dma01'"),
    "more states": ("movestates: 1", "movestates: 2", "line 9 must begin with 'movestate:'"),
    "endless states": ("movestates: 1", "movestates: 99999999999", "must be a whole number"),
    "more states than room": ("movestates: 1", "movestates: 1000", "is said to be 1000, and there is space for"),
    "more vertices than room": ("vertices: 2", "vertices: 900000", "is said to be 900000, and there is space for"),
    "one vertex less": ("vertices: 2", "vertices: 1", "must begin with 'all vertices that move:'"),
    "one vertex more": ("vertices: 2", "vertices: 3", "must each be a vertex number and three coordinates"),
    "a word as a count": ("vertices: 2", "vertices: two", "'vertices' must be a whole number, found 'two'"),
    "a NaN": ("1.0 2.0 3.0", "1.0 nan 3.0", "lines 6..7 hold a number that is not finite"),
    "beyond float32": ("1.0 2.0 3.0", "1.0 1e39 3.0", "not finite"),
    "four coordinates": ("1.0 2.0 3.0", "1.0 2.0 3.0 4.0", "must each be a vertex number and three coordinates"),
    "a fraction of a vertex": ("3 1.0", "3.5 1.0", "must begin with vertex numbers"),
    "a vertex below 0": ("3 1.0", "-3 1.0", "must begin with vertex numbers"),
    "a vertex far beyond": ("3 1.0", "1e19 1.0", "must begin with vertex numbers"),
    "a word": ("1.0 2.0", "one 2.0", "must each be a vertex number and three coordinates"),
    "no caption": ("movestate: smile", "smile", "must begin with 'movestate:', found 'smile'"),
    "more lines": ("40.0 50.0 60.0", "40.0 50.0 60.0\nthe end", "line 12 is beyond the end"),
    "an endless line": ("smile", "smile" * 1000, "longer than 4096 bytes"),
}


@pytest.mark.parametrize(("old", "new", "said"), CHANGES.values(), ids=CHANGES)
def test_a_wrong_3dma_file_is_refused_with_the_line(old: str, new: str, said: str):
    assert old in TEXT
    with pytest.raises(MeshError, match=said):
        parse_3dma(TEXT.replace(old, new, 1).encode())


def test_a_3dma_file_is_read_whatever_an_editor_does_to_line_breaks_and_spaces():
    edited = "\ufeff" + TEXT.replace("\n", "\r\n\r\n").replace("1.0 2.0", "\t1    2.0 ")
    assert same(parse_3dma(edited.encode()), parse_3dm(GOOD))


@pytest.mark.parametrize("kind", [".3dm", ".3dma", ".obj", ".glb", ".gltf", ".x"])
def test_a_huge_file_is_refused_before_it_is_read(tmp_path: Path, kind: str):
    path = tmp_path / f"huge{kind}"
    with path.open("wb") as content:
        content.truncate(10**12)
    with pytest.raises(MeshError, match=rf"^huge{kind}: such a file has at most \d+ MB, this has [0-9.]+ MB"):
        load_morph_targets(path)


@pytest.mark.parametrize("kind", [".3dm", ".3dma", ".obj", ".glb", ".gltf", ".x"])
def test_what_is_no_file_is_refused(tmp_path: Path, kind: str):
    (tmp_path / f"folder{kind}").mkdir()
    for name in ("missing", "folder"):
        with pytest.raises(MeshError, match=rf"^{name}{kind}: (there is no such file|this is a folder);"):
            load_morph_targets(tmp_path / f"{name}{kind}")


def test_a_folder_that_cannot_be_written_keeps_the_old_file(tmp_path: Path):
    with pytest.raises(MeshError, match=r"^face\.3dm: cannot be written \(.*\); choose another folder"):
        save_morph_targets(parse_3dm(GOOD), tmp_path / "missing" / "face.3dm")
    with pytest.raises(MeshError, match=r"its ending must be one of \.3dm, \.3dma, \.glb"):
        save_morph_targets(parse_3dm(GOOD), tmp_path / "face.obj")
    assert not list(tmp_path.iterdir())
