"""``.obj`` files (Wavefront): a mesh as text; the order of the vertices is the file's."""

import io
from array import array
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth import mesh
from phonemeengine.mouth.morph_mesh import MorphMesh

LONGEST_LINE = 1 << 16
MOST_LIBRARIES = 16
Beside = Callable[[str], bytes | None]
"""Gives the content of a file beside the one that is read, or None if there is none."""


def parse_obj(content: bytes, beside: Beside = lambda _name: None) -> MorphMesh:
    """Read an .obj file: positions, normals, colours of vertices, polygons, and materials.

    Parameters
    ----------
    beside : finds the materials' files that it names; without them all is grey.

    Raises
    ------
    MeshError : it is no .obj file, or says something impossible; names the line.
    """
    reader = _ObjReader(beside)
    for number, line in _lines_of(content):
        try:
            reader.read_statement(line.split())
        except MeshError as error:
            raise MeshError(f"line {number}: {error}") from error
        except (ValueError, OverflowError) as error:
            raise MeshError(
                f"line {number} holds {_shown(line)}, which is no number of a mesh; correct it"
            ) from error
    return MorphMesh(reader.mesh())


class _ObjReader:
    """Gathers what the lines of a file say."""

    def __init__(self, beside: Beside) -> None:
        self._beside = beside
        self._name = ""
        self._n_libraries = 0
        self._positions, self._colours, self._normals = array("d"), array("d"), array("d")
        self._triangles, self._corners, self._corner_normals = array("l"), array("l"), array("l")
        self._material_of = array("H")
        self._materials: dict[str, tuple[float, float, float]] = {}
        self._places: dict[str, int] = {}
        self._place = 0
        self._acts: dict[bytes, Callable[[list[bytes]], None]] = {
            b"v": self._vertex,
            b"vn": self._normal,
            b"f": self._face,
            b"usemtl": self._use,
            b"mtllib": self._library,
            b"o": self._called,
        }

    def read_statement(self, words: list[bytes]) -> None:
        """Take a line's words."""
        if words and (act := self._acts.get(words[0])):
            act(words[1:])

    def mesh(self) -> mesh.Mesh:
        """Return the mesh that all lines make."""
        n = len(self._positions) // 3
        colours = _vectors(self._colours).astype(np.float32) if len(self._colours) == 3 * n and n else None
        materials = tuple(mesh.Material(name, self._materials.get(name, mesh.GREY)) for name in self._places)
        return mesh.mesh_of(
            _vectors(self._positions),
            _vectors(self._triangles),
            name=self._name,
            normals=self._vertex_normals(n),
            colours=colours,
            materials=materials,
            material_of=np.array(self._material_of, np.uint16),
        )

    def _vertex(self, words: list[bytes]) -> None:
        if len(self._positions) >= 3 * mesh.MOST_VERTICES:
            raise MeshError(f"a mesh has at most {mesh.MOST_VERTICES} vertices; make it coarser")
        x, y, z = map(float, words[:3])
        self._positions.extend((x, y, z))
        if len(words) >= 6:
            red, green, blue = map(float, words[3:6])
            self._colours.extend((red, green, blue))

    def _normal(self, words: list[bytes]) -> None:
        if len(self._normals) >= 3 * mesh.MOST_TRIANGLES:
            raise MeshError(f"a mesh has at most {mesh.MOST_TRIANGLES} normals; make it coarser")
        x, y, z = map(float, words[:3])
        self._normals.extend((x, y, z))

    def _face(self, words: list[bytes]) -> None:
        corners = [word.split(b"/") for word in words]
        vertices = [_place_of(corner[0], len(self._positions) // 3, "vertex") for corner in corners]
        if len(self._triangles) + 3 * len(corners) > 3 * mesh.MOST_TRIANGLES:
            raise MeshError(f"a mesh has at most {mesh.MOST_TRIANGLES} triangles; make it coarser")
        for corner, vertex in zip(corners, vertices, strict=True):
            if len(corner) > 2 and corner[2]:
                self._corners.append(vertex)
                self._corner_normals.append(_place_of(corner[2], len(self._normals) // 3, "normal"))
        if len(vertices) > 2 and not self._places:
            self._use([b"default"])
        for k in range(1, len(vertices) - 1):
            self._triangles.extend((vertices[0], vertices[k], vertices[k + 1]))
            self._material_of.append(self._place)

    def _use(self, words: list[bytes]) -> None:
        name = _text(words)
        if name not in self._places and len(self._places) >= mesh.MOST_MATERIALS:
            raise MeshError(f"a mesh has at most {mesh.MOST_MATERIALS} materials; join some")
        self._place = self._places.setdefault(name, len(self._places))

    def _library(self, words: list[bytes]) -> None:
        self._n_libraries += 1
        content = self._beside(_text(words)) if self._n_libraries <= MOST_LIBRARIES else None
        if content is not None:
            self._materials.update(_materials_of(content))

    def _called(self, words: list[bytes]) -> None:
        self._name = self._name or _text(words)

    def _vertex_normals(self, n: int) -> Float32Array | None:
        if not len(self._corners):
            return None
        given = _vectors(self._normals)[np.array(self._corner_normals)]
        if not np.all(np.abs(given) < 1e30):
            return None
        return mesh.summed_at(np.array(self._corners), given, n).astype(np.float32)


def _materials_of(content: bytes) -> Iterator[tuple[str, tuple[float, float, float]]]:
    """Return the names and diffuse colours of an .mtl file; what is no colour is passed over."""
    name = ""
    for _, line in _lines_of(content):
        match line.split():
            case [b"newmtl", *words]:
                name = _text(words)
            case [b"Kd", red, green, blue]:
                try:
                    colour = tuple(min(1.0, max(0.0, float(word))) for word in (red, green, blue))
                except ValueError:
                    continue
                yield name, (colour[0], colour[1], colour[2])


def _lines_of(content: bytes) -> Iterator[tuple[int, bytes]]:
    for goes_on in (b"\\\n", b"\\\r\n"):
        if goes_on in content:
            content = content.replace(goes_on, b" ")
    text, number = io.BytesIO(content), 0
    while line := text.readline(LONGEST_LINE + 1):
        number += 1
        if len(line) > LONGEST_LINE:
            raise MeshError(f"line {number} is longer than {LONGEST_LINE} bytes; this is no .obj file")
        yield number, line


def _place_of(word: bytes, n: int, what: str) -> int:
    """Return the place of a vertex or normal; in the file they count from 1, or backwards from the last one, -1."""
    number = int(word)
    place = number - 1 if number > 0 else n + number
    if number == 0 or not 0 <= place < n:
        raise MeshError(f"it names {what} {word[:12].decode()}, and so far there are {n}; export it again")
    return place


def _vectors(numbers: array) -> NDArray[np.generic]:  # type: ignore[type-arg]
    return np.array(numbers).reshape(-1, 3)


def _text(words: list[bytes]) -> str:
    return b" ".join(words).decode(errors="replace")[:255]


def _shown(line: bytes) -> str:
    return repr(line.decode(errors="replace").strip()[:40])
