"""Several heads in one picture, side by side, each with a caption below it."""

from collections.abc import Sequence
from contextlib import suppress

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from phonemeengine.arrays import UInt8Array
from phonemeengine.files import printable

STRIP, LETTERS = 1 / 12, 0.55
"""The height of captions as a share of the picture's, and of their letters as a share of that."""
WIDEST = 0.94
"""The share of a head's width that a caption takes at most; it becomes smaller, and then loses its middle."""
LONGEST, END = 200, 12
"""Characters of a caption, and those that stay of its end, which tells whether a performer is synthetic."""
SMALLEST = 9.0
"""Pixels: smaller letters cannot be read."""
FONTS = (
    "DejaVuSans.ttf", "NotoSansCJK-Regular.ttc", "wqy-microhei.ttc", "DroidSansFallback.ttf", "segoeui.ttf",
    "msyh.ttc", "Arial Unicode.ttf",
)  # fmt: skip
"""Of Linux, Windows and macOS, for what the font that Pillow brings lacks: it has the letters of English alone."""
NO_LETTER = "\U0010ffff"

Font = ImageFont.FreeTypeFont | ImageFont.ImageFont


class SideBySide:
    """Puts pictures of heads into one; a head without a caption is the whole picture.

    Parameters
    ----------
    size : width and height of the whole, pixels.
    captions : of the heads, from left to right; none for a single head.
    ink, background : the colours of captions and of what is behind them, as #rrggbb.

    Attributes
    ----------
    head_size : width and height of the picture of each head.
    """

    def __init__(self, size: tuple[int, int], captions: Sequence[str], ink: str, background: str) -> None:
        strip = round(size[1] * STRIP) if captions else 0
        self.head_size = (size[0] // max(len(captions), 1), size[1] - strip)
        self._whole = np.array(Image.new("RGB", size, background))
        for number, caption in enumerate(captions if strip else ()):
            line = _line_of(caption, (self.head_size[0], strip), ink, background)
            self._whole[-strip:, self._columns(number)] = line

    def picture(self, heads: Sequence[UInt8Array]) -> UInt8Array:
        """Return the whole: uint8, shape (height, width, 3).

        Parameters
        ----------
        heads : as many as captions, each of the `head_size`.
        """
        whole = self._whole.copy()
        for number, head in enumerate(heads):
            whole[: self.head_size[1], self._columns(number)] = head
        return whole

    def _columns(self, number: int) -> slice:
        return slice(number * self.head_size[0], (number + 1) * self.head_size[0])


def _line_of(text: str, size: tuple[int, int], ink: str, background: str) -> UInt8Array:
    """Return the picture of a line of text in its middle."""
    image = Image.new("RGB", size, background)
    letters, room, middle = max(LETTERS * size[1], 1.0), WIDEST * size[0], (size[0] / 2, size[1] / 2)
    text, name = _with_font(printable(text))
    length = max(_font(name, letters).getlength(text[:LONGEST]), 1.0)
    font = _font(name, max(letters * min(room / length, 1.0), min(letters, SMALLEST)))
    ImageDraw.Draw(image).text(middle, _fitting(text, font, room), ink, font, anchor="mm")
    return np.array(image)


def _with_font(text: str) -> tuple[str, str]:
    """Return a text, and a font of the system that has all its letters; with ? for those that none has."""
    if text.isascii():
        return text, ""
    for name in FONTS:
        with suppress(OSError):
            font = ImageFont.truetype(name, SMALLEST)
            if bytes(font.getmask(NO_LETTER)) not in {bytes(font.getmask(letter)) for letter in {*text}}:
                return text, name
    return text.encode("ascii", "replace").decode(), ""


def _font(name: str, letters: float) -> Font:
    return ImageFont.truetype(name, letters) if name else ImageFont.load_default(letters)


def _fitting(text: str, font: Font, room: float) -> str:
    """Return a text without what is too much of it before its end."""
    if len(text) <= LONGEST and font.getlength(text) <= room:
        return text
    begin, end = text[:LONGEST][:-END], text[-END:]
    while begin and font.getlength(f"{begin}…{end}") > room:
        begin = begin[:-1]
    return f"{begin}…{end}"
