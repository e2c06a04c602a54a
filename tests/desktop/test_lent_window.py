"""The window that tests use in turn is as new each time, or another one."""

import pytest
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QDockWidget

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.window import TALK
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.settings import Filter
from tests.desktop.hands import click, followed, press
from tests.desktop.lent_window import WindowLender


def test_a_window_is_lent_again_as_it_was_at_first(lender: WindowLender, desktop: Desktop, qtbot) -> None:
    desktop.window.show_page(TALK)
    desktop = lender.lend()  # another one unless all pages were made before
    window = followed(desktop, qtbot)
    click(window.analysis.spectrum.decibels)
    press(window, Qt.Key.Key_L)
    window.analysis.waveform.scale.setValue(20)
    desktop.preset.load(DEFAULT_PRESET)  # whose controls are others
    desktop.preset.set_filter(Filter.DENOISE, on=True)
    window.findChild(QDockWidget).close()
    window.show_page(TALK)
    desktop.talking.text.set_text("Not of the next one.")
    assert desktop.preset.undo_stack.canUndo()
    again = lender.lend()
    assert (again.session.path, again.session.playback.loop, again.session.history.n) == (None, False, 0)
    assert not again.window.analysis.spectrum.decibels.isChecked()
    assert again.window.analysis.waveform.scale.value() == 0
    assert not again.preset.undo_stack.canUndo()
    assert window.findChild(QDockWidget).isVisible()
    assert desktop.talking.text.text == ""
    assert lender.lend() is again is desktop


class Paints(QObject):
    """Counts how often something is painted."""

    n = 0

    def eventFilter(self, _painted: QObject, event: QEvent) -> bool:
        self.n += event.type() == QEvent.Type.Paint
        return False


def test_what_was_to_be_painted_when_a_window_was_brought_back_is_painted(lender, desktop, qtbot) -> None:
    part, paints = desktop.window.transport, Paints()
    desktop.window.update()  # Qt asks to paint it while the window is tidied, which has none painted
    assert lender.lend() is desktop
    part.installEventFilter(paints)
    part.update()
    qtbot.waitUntil(lambda: paints.n > 0)


@pytest.mark.long
def test_a_window_that_cannot_be_brought_back_costs_a_new_one(lender: WindowLender, desktop: Desktop) -> None:
    desktop.window.close()
    assert lender.lend() is not desktop
