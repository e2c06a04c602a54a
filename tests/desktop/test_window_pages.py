"""What the window makes at the start, and what it leaves for later."""

import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from phonemeanalyser.desktop.app import FirstPaint
from phonemeanalyser.desktop.calibrate.page import CalibrationPage
from phonemeanalyser.desktop.talk.page import TalkPage
from phonemeanalyser.desktop.widgets.plot import PlotMenu
from tests.desktop.hands import FileAnswers, choose, click, copied, press, settle, shown

CONTROL = Qt.KeyboardModifier.ControlModifier


@pytest.mark.usefixtures("own_desktop")
def test_the_sound_is_opened_after_the_window_was_painted_and_a_page_is_made_when_it_is_looked_at(desktop, qtbot):
    waiting = FirstPaint(desktop.window)
    said = []
    waiting.painted.connect(lambda: said.append(desktop.window.isVisible()))
    settle()
    assert said == []
    desktop.window.show()
    qtbot.waitUntil(lambda: said == [True])
    desktop.window.repaint()
    settle()
    assert said == [True]
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
    assert window.pages.indexOf(window.analysis) == 0
    assert [window.pages.widget(k).widget() for k in (1, 2)] == [window.calibration, page]
    click(window.switch.buttons[2])
    assert window.findChildren(TalkPage) == [page]
    assert page.isVisible()


@pytest.mark.qt_log_ignore("This plugin does not support")  # menus without a display
def test_a_right_click_on_the_head_opens_its_menu_and_a_page_is_scrolled_where_the_window_is_too_small(
    desktop, qtbot
):
    window = shown(desktop, qtbot)
    press(window, Qt.Key.Key_3, CONTROL)
    head, right = window.talk.head, Qt.MouseButton.RightButton
    QTest.mousePress(head, right, pos=QPoint(50, 50))
    QTest.mouseMove(head, QPoint(80, 50))
    QTest.mouseRelease(head, right, pos=QPoint(80, 50))
    assert not head.menu.isVisible()
    QTest.mouseClick(head, right, pos=QPoint(50, 50))
    assert head.menu.isVisible()
    head.menu.close()
    for number in (1, 2):
        window.show_page(number)
        window.resize(960, 540)  # a screen of 1920 x 1080 at twice the scale
        QApplication.processEvents()
        assert (window.width(), window.height()) == (960, 540)
        area = window.pages.currentWidget()
        assert (area.horizontalScrollBar().maximum() > 0) == (
            area.widget().minimumSizeHint().width() > area.viewport().width()
        )


def test_every_view_copies_its_values_and_becomes_a_picture(desktop, qtbot, tmp_path):
    window = shown(desktop, qtbot)
    for key in (Qt.Key.Key_2, Qt.Key.Key_3):
        press(window, key, CONTROL)
    menus = window.findChildren(PlotMenu)
    named = {type(menu.parent()).__name__ for menu in menus}
    assert named >= {"HeadView", "MovestateBars", "PhonemeView", "TakeWaveform", "ConfusionView", "DistributionView"}
    saved: list[Path] = []
    for k, menu in enumerate(menus):
        assert "\t" in copied(menu, QPoint(9, 9))[0] or copied(menu, QPoint(9, 9))[0]
        for kind in ("png", "svg"):
            saved.append(tmp_path / f"{k}.{kind}")
            window.files.show = FileAnswers(saved[-1])
            choose(menu, "Save Picture…")
    assert [path.name for path in saved if not path.is_file() or not path.stat().st_size] == []


def test_the_first_picture_does_not_wait_for_other_pages_and_networks(tmp_path):
    program = (
        "import sys; from PySide6.QtCore import QSettings; from phonemeanalyser.desktop.app import Desktop, "
        "make_application; app = make_application(); settings = QSettings(sys.argv[1], QSettings.Format.IniFormat); "
        "desktop = Desktop(app, settings); desktop.window.show(); "
        "names = [f'phonemeanalyser.desktop.{page}.model' for page in ('calibrate', 'talk')]; "
        "print({*names, 'onnxruntime', 'phonemeengine.conversion'} & {*sys.modules}); "
        "desktop.calibration; desktop.talking; print({*names} <= {*sys.modules}); desktop.close()"
    )
    words = [sys.executable, "-c", program, str(tmp_path / "settings.ini")]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["set()", "True"]
