"""Heads side by side: where each stands, and that captions keep to their own."""

import numpy as np
import pytest

from phonemeanalyser.rendering.clip import SideBySide
from tests.graphics import Picture

INK, PAPER = "#000000", "#ffffff"


def blank(sheet: SideBySide, grey: int) -> Picture:
    return np.full((*sheet.head_size[::-1], 3), grey, np.uint8)


def whole(captions: tuple[str, ...], size: tuple[int, int] = (400, 240)) -> Picture:
    sheet = SideBySide(size, captions, INK, PAPER)
    return sheet.picture([blank(sheet, 255)] * max(len(captions), 1))


def test_a_single_head_is_the_whole_picture() -> None:
    sheet = SideBySide((40, 30), (), INK, PAPER)
    assert sheet.head_size == (40, 30)
    assert np.array_equal(sheet.picture([blank(sheet, 7)]), blank(sheet, 7))


def test_heads_stand_from_left_to_right_above_their_captions() -> None:
    sheet = SideBySide((400, 240), ("one", "two"), INK, PAPER)
    assert sheet.head_size == (200, 220)
    picture = sheet.picture([blank(sheet, 7), blank(sheet, 9)])
    assert (picture[:220, :200] == 7).all()
    assert (picture[:220, 200:] == 9).all()
    assert picture[220:].max() == 255
    assert picture[220:, :200].min() < 60 > picture[220:, 200:].min()


@pytest.mark.parametrize("size", [(16, 16), (17, 31), (401, 241), (4096, 16), (16, 4096)])
def test_a_picture_of_any_size_is_filled(size: tuple[int, int]) -> None:
    assert whole(("one", "two"), size).shape == (size[1], size[0], 3)


def test_the_middle_of_a_caption_is_that_of_its_head() -> None:
    for half in np.split(whole(("HOH", "H"))[220:], 2, axis=1):
        columns = np.argwhere(half.min(axis=(0, 2)) < 128)
        assert (columns.min() + columns.max()) / 2 == pytest.approx(99.5, abs=1.5)


def test_a_long_caption_becomes_smaller_and_then_is_shortened() -> None:
    def letters(text: str) -> tuple[int, int]:
        rows, columns = np.nonzero(whole((text, ""), (400, 480))[440:, :200].min(axis=2) < 128)
        assert 0 < columns.min() < columns.max() < 199
        return int(np.ptp(rows)), int(np.ptp(columns))

    (tall, _), (small, _), (least, wide), (cut, _) = (letters(n * "H") for n in (3, 15, 60, 900))
    assert tall > small > least == cut
    assert wide > 150


def test_a_caption_that_is_shortened_keeps_its_end() -> None:
    ends = (" (synthetic performer)", " (a person who moved)")
    synthetic, other = (whole((100 * "H" + end, "")) for end in ends)
    assert np.array_equal(synthetic, whole((9999 * "H" + " (synthetic performer)", "")))
    assert not np.array_equal(synthetic, other)


def test_letters_that_no_font_has_are_question_marks() -> None:
    assert np.array_equal(whole(("\U0001e2c0nna", "c")), whole(("?nna", "c")))


def test_a_caption_is_one_line() -> None:
    assert np.array_equal(whole(("a\nb", "c")), whole(("a?b", "c")))
