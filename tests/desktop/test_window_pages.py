"""What the window makes at the start, and what it leaves for later."""

import subprocess
import sys

from PySide6.QtCore import Qt

from phonemeanalyser.desktop.app import FirstPaint
from phonemeanalyser.desktop.calibrate.page import CalibrationPage
from phonemeanalyser.desktop.talk.page import TalkPage
from tests.desktop.hands import click, press, shown

CONTROL = Qt.KeyboardModifier.ControlModifier


def test_a_page_is_made_when_it_is_first_looked_at_and_stays(desktop, qtbot):
    window = shown(desktop, qtbot)
    assert not window.findChildren(TalkPage)
    assert not window.findChildren(CalibrationPage)
    press(window, Qt.Key.Key_3, CONTROL)
    (page,) = window.findChildren(TalkPage)
    assert page.isVisible()
    assert not window.findChildren(CalibrationPage)
    desktop.set_theme("dark")  # another window, with the page that is seen and no other
    window, (page,) = desktop.window, desktop.window.findChildren(TalkPage)
    assert page.isVisible()
    assert not window.findChildren(CalibrationPage)
    click(window.switch.buttons[1])
    assert window.calibration.isVisible()
    assert [window.pages.indexOf(p) for p in (window.analysis, window.calibration, page)] == [0, 1, 2]
    click(window.switch.buttons[2])
    assert window.findChildren(TalkPage) == [page]
    assert page.isVisible()


def test_the_sound_is_opened_after_the_window_has_been_painted(desktop, qtbot):
    waiting = FirstPaint(desktop.window)
    said = []
    waiting.painted.connect(lambda: said.append(desktop.window.isVisible()))
    qtbot.wait(50)
    assert said == []
    desktop.window.show()
    qtbot.waitUntil(lambda: said == [True])
    desktop.window.repaint()
    qtbot.wait(50)
    assert said == [True]


def test_the_first_picture_does_not_wait_for_the_calibration(tmp_path):
    program = (
        "import sys; from PySide6.QtCore import QSettings; from phonemeanalyser.desktop.app import Desktop, "
        "make_application; app = make_application(); settings = QSettings(sys.argv[1], QSettings.Format.IniFormat); "
        "desktop = Desktop(app, settings); desktop.window.show(); name = 'phonemeanalyser.desktop.calibrate.model'; "
        "print(name in sys.modules); desktop.calibration; print(name in sys.modules); desktop.close()"
    )
    words = [sys.executable, "-c", program, str(tmp_path / "settings.ini")]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "True"]
