"""Materials of a glTF after its metallic-roughness model, with the pictures that they name."""

import base64
import binascii
import struct
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from urllib.parse import unquote

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.gltf_document import Document, Table, numbers_of, table_of, text_of, whole_of
from phonemeengine.mouth.files.vrm import material_properties
from phonemeengine.mouth.mesh import MOST_MATERIALS, AlphaMode, Material, Texture, ToonShading

LONGEST_EDGE = 8192
"""Pixels of a texture."""
UNLIT_SHADE = 0.75
"""How bright the shade of a material without light is, so that a white face is seen on a white ground."""
_PNG, _JPEG = b"\x89PNG\r\n\x1a\n", b"\xff\xd8"
_NO_SIZES = {0xC4, 0xC8, 0xCC}
"""Markers of JPEG among those of frames that tell no size."""


def materials_of(document: Document) -> list[Material]:
    """Return the materials of a file; pictures in other formats than PNG and JPEG are left out.

    Raises
    ------
    MeshError : a texture is too large or not there, or a material says something impossible.
    """

    @cache
    def texture(place: int) -> Texture | None:
        return _texture_of(document, place)

    def named(table: Table, key: str) -> Texture | None:
        entry = table_of(table, key)
        return texture(whole_of(entry, "index")) if entry else None

    made = []
    toons = material_properties(document)
    for place, table in enumerate(document.list_of("materials")[:MOST_MATERIALS]):
        surface, extensions = table_of(table, "pbrMetallicRoughness"), table_of(table, "extensions")
        *colour, alpha = numbers_of(surface, "baseColorFactor", [1.0] * 4)
        mode = text_of(table, "alphaMode", "OPAQUE")
        strength = _number(table_of(extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0)
        red, green, blue = (max(strength * n, 0.0) for n in numbers_of(table, "emissiveFactor", [0.0] * 3))
        base = Material(
            text_of(table, "name", "")[:255],
            _rgb(srgb_of(np.array(colour, np.float32))),
            _share(alpha),
            named(surface, "baseColorTexture"),
            _factor(surface, "metallicFactor", 1.0),
            _factor(surface, "roughnessFactor", 1.0),
            AlphaMode(mode) if mode in set(AlphaMode) else AlphaMode.OPAQUE,
            _factor(table, "alphaCutoff", 0.5),
            table.get("doubleSided") is True,
            named(surface, "metallicRoughnessTexture"),
            named(table, "normalTexture"),
            _number(table_of(table, "normalTexture"), "scale", 1.0),
            (red, green, blue),
            named(table, "emissiveTexture"),
        )
        toon = _mtoon1(extensions, named) or _mtoon0(toons[place] if place < len(toons) else {}, texture)
        if toon is None and "KHR_materials_unlit" in extensions:
            shade = srgb_of(UNLIT_SHADE * linear_of(np.array(base.colour, np.float32)))
            toon = ToonShading(_rgb(shade), base.texture, toony=0.5)
        made.append(replace(base, toon=toon))
    return made


def _mtoon1(extensions: Table, named: Callable[[Table, str], Texture | None]) -> ToonShading | None:
    """Return the shading that ``VRMC_materials_mtoon`` of VRM 1 has."""
    if "VRMC_materials_mtoon" not in extensions:
        return None
    table = table_of(extensions, "VRMC_materials_mtoon")
    shade = numbers_of(table, "shadeColorFactor", [0.0] * 3)
    return ToonShading(
        _rgb(srgb_of(np.array(shade, np.float32))),
        named(table, "shadeMultiplyTexture"),
        _number(table, "shadingShiftFactor", 0.0),
        _factor(table, "shadingToonyFactor", 0.9),
    )


def _mtoon0(table: Table, texture: Callable[[int], Texture | None]) -> ToonShading | None:
    """Return the shading that MToon of VRM 0 has, with the numbers that VRM 1 has for it, as UniVRM converts them."""
    if text_of(table, "shader", "") != "VRM/MToon":
        return None
    numbers, pictures = table_of(table, "floatProperties"), table_of(table, "textureProperties")
    red, green, blue, _ = numbers_of(table_of(table, "vectorProperties"), "_ShadeColor", [0.97, 0.81, 0.86, 1.0])
    toony, shift = _factor(numbers, "_ShadeToony", 0.9), _number(numbers, "_ShadeShift", 0.0)
    place = pictures.get("_ShadeTexture")
    shade = None if place is None else texture(whole_of(pictures, "_ShadeTexture"))
    rising = toony + (1 - toony) * (0.5 + 0.5 * shift)
    return ToonShading((_share(red), _share(green), _share(blue)), shade, -shift - (1 - rising), rising)


def linear_of(colours: Float32Array) -> Float32Array:
    """Turn sRGB colours into the linear ones that glTF has (IEC 61966-2-1)."""
    return np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4).astype(np.float32)


def srgb_of(colours: Float32Array) -> Float32Array:
    """Turn linear colours into sRGB (IEC 61966-2-1)."""
    bounded = np.clip(np.nan_to_num(colours), 0, 1)
    return np.where(bounded <= 0.0031308, bounded * 12.92, 1.055 * bounded ** (1 / 2.4) - 0.055).astype(np.float32)


def picture_size(content: bytes) -> tuple[int, int] | None:
    """Return width and height of a PNG or JPEG file, pixels, by its header; None where it is neither."""
    if content.startswith(_PNG) and len(content) >= 24:
        width, height = struct.unpack_from(">II", content, 16)
        return width, height
    at = len(_JPEG)
    while content.startswith(_JPEG) and at + 9 <= len(content) and content[at] == 0xFF:
        marker, length = content[at + 1], struct.unpack_from(">H", content, at + 2)[0]
        if 0xC0 <= marker <= 0xCF and marker not in _NO_SIZES:
            height, width = struct.unpack_from(">HH", content, at + 5)
            return width, height
        at += 1 if marker == 0xFF else 2 + length
    return None


def _texture_of(document: Document, place: int) -> Texture | None:
    texture = document.entry("textures", place)
    if "source" not in texture:
        return None  # an extension has it, such as one of WebP
    image = document.entry("images", whole_of(texture, "source"))
    name, content = text_of(image, "name", "")[:60] or f"image {place}", _bytes_of(document, image)
    size = picture_size(content)
    if size is None:
        return None
    if max(size) > LONGEST_EDGE:
        raise MeshError(
            f"its texture {name!r} has {size[0]} x {size[1]} pixels, and at most {LONGEST_EDGE} along an edge are "
            "read; make it smaller"
        )
    return Texture(name, content, *size)


def _bytes_of(document: Document, image: Table) -> bytes:
    if "bufferView" in image:
        return document.view(whole_of(image, "bufferView"))
    uri = text_of(image, "uri", "")
    if uri.startswith("data:"):
        try:
            return base64.b64decode(uri.partition(",")[2], validate=True)
        except (binascii.Error, ValueError) as error:
            raise MeshError("a picture in its text is no base64; export it again") from error
    return document.beside(unquote(uri)) or b""


def _rgb(colour: Float32Array) -> tuple[float, float, float]:
    red, green, blue = colour.tolist()
    return red, green, blue


def _number(table: Table, key: str, default: float) -> float:
    return numbers_of({key: [table.get(key, default)]}, key, [default])[0]


def _factor(table: Table, key: str, default: float) -> float:
    return _share(_number(table, key, default))


def _share(number: float) -> float:
    return min(max(number, 0.0), 1.0)
