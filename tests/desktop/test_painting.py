"""Letters on a painter."""

from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.theme import AT_LEFT, AT_RIGHT, CENTRED, draw_text, size_that_fills

WIDTH, HEIGHT = 200, 40
BOX = QRectF(40, 0, 120, HEIGHT)
WHITE = 255


@pytest.fixture
def paper(qtbot: QtBot) -> QImage:
    image = QImage(WIDTH, HEIGHT, QImage.Format.Format_Grayscale8)
    image.fill(WHITE)
    return image


@pytest.fixture
def painter(paper: QImage) -> Iterator[QPainter]:
    painter = QPainter(paper)
    yield painter
    painter.end()


def inked(paper: QImage) -> NDArray[np.intp]:
    """The columns that have ink."""
    pixels = np.frombuffer(paper.constBits(), np.uint8).reshape(HEIGHT, paper.bytesPerLine())[:, :WIDTH]
    return np.flatnonzero((pixels < WHITE).any(axis=0))


@pytest.mark.parametrize(
    ("align", "place"), [(AT_LEFT, BOX.left()), (AT_RIGHT, BOX.right()), (CENTRED, BOX.center().x())]
)
def test_words_stand_where_they_shall(paper: QImage, painter: QPainter, align: object, place: float) -> None:
    draw_text(painter, BOX, "mama", "#000000", 12, align)  # type: ignore[arg-type]
    columns = inked(paper)
    ends = {AT_LEFT: columns[0], AT_RIGHT: columns[-1] + 1, CENTRED: (columns[0] + columns[-1] + 1) / 2}
    assert abs(ends[align] - place) <= 2  # type: ignore[index]


@pytest.mark.parametrize("align", [AT_LEFT, AT_RIGHT, CENTRED])
def test_words_that_have_no_room_stay_in_their_box(paper: QImage, painter: QPainter, align: object) -> None:
    draw_text(painter, BOX, "mama " * 20, "#000000", 12, align)  # type: ignore[arg-type]
    columns = inked(paper)
    assert columns[0] >= BOX.left() - 1
    assert columns[-1] <= BOX.right() + 1
    assert np.ptp(columns) > 0.8 * BOX.width()


@pytest.mark.parametrize("width", [60.0, 120.0])
def test_a_word_fills_its_place(painter: QPainter, width: float) -> None:
    size = size_that_fills(painter, "mmmm", width, 4, 100)
    draw_text(painter, QRectF(0, 0, WIDTH, HEIGHT), "mmmm", "#000000", size)
    assert 0.85 * width < painter.fontMetrics().horizontalAdvance("mmmm") <= 1.05 * width


def test_a_word_is_never_smaller_or_larger_than_told(painter: QPainter) -> None:
    assert size_that_fills(painter, "mmmm" * 20, 100.0, 12, 64) == 12
    assert size_that_fills(painter, "m", 1000.0, 12, 64) == 64
