"""DirectX ``.x`` files as text: meshes, normals, materials, and the frames that place them; left-handed.

No living library reads them; the templates are those of the DirectX SDK (rmxftmpl.x).
"""

import math
import re
from array import array
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float64Array, Int64Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import GREY, MOST_MATERIALS, MOST_TRIANGLES, MOST_VERTICES, Material, mesh_of, summed_at
from phonemeengine.mouth.morph_mesh import MorphMesh

# The words of a DirectX .x text file: names, numbers, texts and braces.

WORD = re.compile(r'(?://|#)[^\n]*|"[^"\n]{0,4096}"|<[^<>\n]{0,64}>|[{}\[\]]|[^\s;,{}\[\]"<>#/]+|[^\s;,]')
"""Commas and semicolons only separate; comments begin with // or #."""
SHORTEST_NUMBER = 2
"""Characters of the shortest number and what ends it."""
DEEPEST = 64


class Tokenizer:
    """Hands out the words of a text one after the other, without making a list of them."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0

    def next_word(self) -> str:
        """Return the next word; empty at the end."""
        while found := WORD.search(self._text, self._at):
            self._at = found.end()
            word = found.group()
            if not word.startswith(("//", "#")):
                return word
        return ""

    def expect(self, word: str) -> None:
        """Take a word that must be the next."""
        if (found := self.next_word()) != word:
            raise MeshError(f"{self.place}: expected {word!r}, found {found[:40]!r}; export it again")

    def number(self) -> float:
        """Take a number."""
        word = self.next_word()
        try:
            value = float(word)
        except ValueError:
            value = math.nan
        if not abs(value) < 1e18:
            raise MeshError(f"{self.place}: expected a finite number, found {word[:40]!r}; export it again")
        return value

    def whole(self, most: int) -> int:
        """Take a whole number of 0..most."""
        value = self.number()
        if not 0 <= value <= most or value != int(value):
            raise MeshError(f"{self.place}: expected a whole number of 0..{most}, found {value:g}; export it again")
        return int(value)

    def count(self, most: int, numbers_each: int) -> int:
        """Take a number of things, which the rest of the text must have room for."""
        n = self.whole(most)
        room = (len(self._text) - self._at) // (SHORTEST_NUMBER * numbers_each) + 1
        if n > room:
            raise MeshError(
                f"{self.place}: {n} entries are announced, and there is space for {room}; export it again"
            )
        return n

    def numbers(self, n: int, width: int) -> Float64Array:
        """Take n rows of numbers, shape (n, width)."""
        return np.fromiter((self.number() for _ in range(n * width)), np.float64, n * width).reshape(n, width)

    def wholes(self, n: int, most: int) -> Sequence[int]:
        """Take n whole numbers of 0..most."""
        return [self.whole(most) for _ in range(n)]

    def head(self) -> str:
        """Take a block's name, if it has one, and its opening brace; gives the name."""
        word = self.next_word()
        if word == "{":
            return ""
        self.expect("{")
        return word

    def leave(self) -> None:
        """Pass over the rest of a block, up to its closing brace."""
        depth = 1
        while depth:
            match self.next_word():
                case "{":
                    depth += 1
                case "}":
                    depth -= 1
                case "":
                    raise MeshError(f"{self.place}: a block is not closed; it is cut off, export it again")

    @property
    def place(self) -> str:
        """Where the reading is, for people."""
        return f"line {self._text.count(chr(10), 0, self._at) + 1}"


MAGIC = b"xof 03"
MIRROR = np.array([1.0, 1.0, -1.0])
MOST_CORNERS = 1024
MOST_MESHES = 4096
MATRIX = np.eye(4)


def parse_x(content: bytes) -> MorphMesh:
    """Read a .x text file; all its meshes become one.

    Raises
    ------
    MeshError : it is no .x file, is binary or compressed, or says something impossible; names the line.
    """
    if not content.startswith(MAGIC):
        raise MeshError("a .x file begins with 'xof 03', this does not; choose another file")
    if content[8:12] != b"txt ":
        kind = content[8:12].decode("ascii", "replace").strip()
        raise MeshError(f"this .x file is of the kind {kind!r}, and only text can be read; save it as text")
    reader = _XReader(Tokenizer(content[16:].decode(errors="replace")))
    with np.errstate(all="ignore"):  # what overflows is refused as infinite
        reader.blocks(MATRIX, 0)
        return reader.morph_mesh()


@dataclass
class _Part:
    """A mesh of the file, right-handed."""

    name: str
    points: Float64Array
    normals: Float64Array
    triangles: Int64Array
    materials: list[Material] = field(default_factory=list)
    material_of: NDArray[np.uint16] = field(default_factory=lambda: np.zeros(0, np.uint16))


class _XReader:
    """Walks through the blocks, and gathers the meshes."""

    def __init__(self, words: Tokenizer) -> None:
        self._words = words
        self._materials: dict[str, Material] = {}
        self._parts: list[_Part] = []
        self._n = 0
        self._n_triangles = 0

    def blocks(self, above: Float64Array, depth: int) -> None:
        """Read blocks until the one that holds them ends, or the file."""
        if depth > DEEPEST:
            raise MeshError(f"{self._words.place}: frames lie in more than {DEEPEST} others; export it flatter")
        while (kind := self._words.next_word()) not in {"", "}"}:
            above = self._block(kind, above, depth)

    def morph_mesh(self) -> MorphMesh:
        """Return all meshes as one."""
        if not self._parts:
            raise MeshError("there is no mesh in it; export one with it")
        starts = np.cumsum([0, *(len(part.points) for part in self._parts)])
        materials: list[Material] = []
        kinds = []
        for part in self._parts:
            kinds.append(part.material_of + len(materials))
            materials += part.materials or [Material("default", GREY)]
        if len(materials) > MOST_MATERIALS:
            raise MeshError(f"a mesh has at most {MOST_MATERIALS} materials, this has {len(materials)}; join some")
        mesh = mesh_of(
            np.concatenate([part.points for part in self._parts]),
            np.concatenate([part.triangles + at for part, at in zip(self._parts, starts, strict=False)]),
            name=self._parts[0].name,
            normals=np.concatenate([p.normals for p in self._parts]).astype(np.float32),
            materials=materials,
            material_of=np.concatenate(kinds),
        )
        return MorphMesh(mesh)

    def _block(self, kind: str, above: Float64Array, depth: int) -> Float64Array:
        words = self._words
        if kind == "template":
            words.head()
            words.leave()
        elif kind == "Frame":
            words.head()
            self.blocks(above, depth + 1)
        elif kind == "FrameTransformMatrix":
            words.head()
            above = words.numbers(4, 4) @ above
            words.expect("}")
        elif kind == "Mesh":
            self._mesh(words.head(), above)
        elif kind == "Material":
            self._material(words.head())
        elif kind == "{":  # a reference to another block
            words.leave()
        else:
            words.head()
            words.leave()
        return above

    def _mesh(self, name: str, above: Float64Array) -> None:
        words = self._words
        n = words.count(MOST_VERTICES - self._n, 3)
        points = words.numbers(n, 3)
        faces = _Faces(words, n, MOST_TRIANGLES - self._n_triangles)
        if len(self._parts) >= MOST_MESHES:
            raise MeshError(f"it has more than {MOST_MESHES} meshes; join them")
        self._n, self._n_triangles = self._n + n, self._n_triangles + len(faces.triangles)
        part = _Part(name, _moved(points, above), np.zeros((n, 3)), faces.triangles[:, ::-1])
        part.material_of = np.zeros(len(faces.triangles), np.uint16)
        inner: dict[str, Callable[[], None]] = {
            "MeshNormals": lambda: self._normals(part, faces, above),
            "MeshMaterialList": lambda: self._material_list(part, faces),
        }
        while (kind := words.next_word()) != "}":
            if not kind:
                raise MeshError(f"{words.place}: the mesh is not closed; it is cut off, export it again")
            if kind == "{":
                words.leave()
                continue
            words.head()
            inner.get(kind, words.leave)()
        self._parts.append(part)

    def _normals(self, part: _Part, faces: "_Faces", above: Float64Array) -> None:
        """Read normals; they belong to the corners of faces, and a vertex gets the sum of those of its corners."""
        words = self._words
        n = words.count(MOST_TRIANGLES, 3)
        vectors = words.numbers(n, 3)
        corners = _Faces(words, n, MOST_TRIANGLES)
        if corners.sizes != faces.sizes:
            raise MeshError(f"{words.place}: the faces of normals are not those of the mesh; export it again")
        words.leave()
        if not len(corners.corners):
            return
        turned = vectors @ _cofactors(above[:3, :3]) * MIRROR
        given = turned[np.array(corners.corners)]
        part.normals = summed_at(np.array(faces.corners), given, len(part.points))

    def _material_list(self, part: _Part, faces: "_Faces") -> None:
        words = self._words
        n = words.whole(MOST_MATERIALS)
        n_faces = words.count(MOST_TRIANGLES, 1)
        places = np.array([*words.wholes(n_faces, max(0, n - 1)), 0])
        while (kind := words.next_word()) not in {"", "}"}:
            if kind == "Material":
                part.materials.append(self._material(words.head()))
            elif kind == "{":
                part.materials.append(self._materials.get(words.next_word(), Material("", GREY)))
                words.expect("}")
            else:
                words.head()
                words.leave()
        while len(part.materials) < n:
            part.materials.append(Material("", GREY))
        which = np.minimum(faces.face_of, max(0, n_faces - 1))
        part.material_of = places[which].astype(np.uint16)

    def _material(self, name: str) -> Material:
        red, green, blue = (min(1.0, max(0.0, self._words.number())) for _ in range(3))
        self._words.leave()
        made = Material(name[:255], (red, green, blue))
        if name and len(self._materials) < MOST_MATERIALS:
            self._materials[name] = made
        return made


class _Faces:
    """Reads polygons, and cuts them into triangles.

    Attributes
    ----------
    sizes : corners of each polygon.
    corners : vertex numbers of all corners.
    triangles : shape (m, 3).
    face_of : shape (m,), the polygon that each triangle is of.
    """

    def __init__(self, words: Tokenizer, n: int, most: int) -> None:
        self.sizes, self.corners = array("H"), array("l")
        triangles, face_of = array("l"), array("l")
        for face in range(words.count(MOST_TRIANGLES, 1)):
            corners = words.wholes(words.whole(MOST_CORNERS), max(0, n - 1))
            self.sizes.append(len(corners))
            self.corners.extend(corners)
            for k in range(1, len(corners) - 1):
                triangles.extend((corners[0], corners[k], corners[k + 1]))
                face_of.append(face)
            if len(face_of) > most or len(self.corners) > 3 * MOST_TRIANGLES or (corners and not n):
                raise MeshError(f"{words.place}: a mesh has at most {MOST_TRIANGLES} triangles; make it coarser")
        self.triangles = np.array(triangles, np.int64).reshape(-1, 3)
        self.face_of = np.array(face_of, np.int64)


def _moved(points: Float64Array, matrix: Float64Array) -> Float64Array:
    """Place points with a matrix whose rows are added up, as DirectX has it, and mirror them to the right hand."""
    return np.asarray((points @ matrix[:3, :3] + matrix[3, :3]) * MIRROR)


def _cofactors(matrix: Float64Array) -> Float64Array:
    """Return what turns normals where a matrix moves points."""
    return np.asarray(np.cross(matrix[[1, 2, 0]], matrix[[2, 0, 1]]), np.float64)
