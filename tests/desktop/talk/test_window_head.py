"""The head in the window, by mouse and keyboard."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, QSettings, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDockWidget
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.talk.head.head_view import HeadView
from phonemeanalyser.desktop.talk.pictures import PICTURE_RATES
from phonemeanalyser.desktop.window import MainWindow
from phonemeanalyser.rendering.camera import Camera
from phonemeengine.audio.output import ClockOutput
from phonemeengine.mouth.idle_motion import EYES
from phonemeengine.mouth.morph_mesh import Framing
from phonemeengine.mouth.movestate import Mode
from phonemeengine.mouth.table import TABLES, load_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import THESIS_PRESET
from tests.desktop.hands import LEFT, FileAnswers, click, press, settle, shown, turn_wheel, wav
from tests.desktop.stage import AN_A
from tests.desktop.talk.desk import drawn
from tests.sounds import vowel

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


def picture(head: HeadView) -> np.ndarray:
    """What the view shows, shape (height, width, 3)."""
    image = head.grab().toImage().convertToFormat(QImage.Format.Format_RGBX8888)
    return np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.width(), 4)[..., :3].copy()


def dock(window: MainWindow) -> QDockWidget:
    return next(d for d in window.findChildren(QDockWidget) if d.objectName() == "Head")


def jaw(desktop: Desktop) -> float:
    return desktop.talking.percentages["jawOpen"]


def open_mouth(desktop: Desktop, qtbot: QtBot, least: float = 15) -> None:
    qtbot.waitUntil(lambda: jaw(desktop) > least)


def closed_mouth(desktop: Desktop, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: jaw(desktop) < 1)


# -- page and dock ------------------------------------------------------------------------------------


def test_the_dock_is_hidden_at_first_and_f7_shows_and_hides_it(desktop, qtbot, graphics):
    window = shown(desktop, qtbot)
    assert not dock(window).isVisible()
    press(window, Qt.Key.Key_F7)
    assert dock(window).isVisible()
    drawn(window.talk_parts.heads.by_name["dock"], qtbot)
    press(window, Qt.Key.Key_F7)
    assert not dock(window).isVisible()
    qtbot.waitUntil(lambda: not desktop.talking.watched)


def test_the_page_shows_a_head_in_the_middle_and_no_docks(window):
    drawn = picture(window.talk.head).astype(int)
    height, width, _ = drawn.shape
    red, green, blue = drawn[height // 2, width // 2]
    assert red > green > blue  # skin
    np.testing.assert_array_equal(drawn[4, 4], drawn[4, -4])  # background
    assert len(np.unique(drawn.reshape(-1, 3), axis=0)) > 1000
    press(window, Qt.Key.Key_1, CONTROL)
    before = {d.objectName() for d in window.findChildren(QDockWidget) if d.isVisible()}
    assert {"Filters", "Phoneme", "Thresholds"} <= before
    for key in (Qt.Key.Key_3, Qt.Key.Key_2, Qt.Key.Key_3):
        press(window, key, CONTROL)
        assert not any(d.isVisible() for d in window.findChildren(QDockWidget))
    press(window, Qt.Key.Key_1, CONTROL)
    assert {d.objectName() for d in window.findChildren(QDockWidget) if d.isVisible()} == before


@pytest.mark.usefixtures("no_opengl", "own_desktop")
def test_without_opengl_a_sentence_stands_where_the_head_would_be(desktop, qtbot, tmp_path):
    window = shown(desktop, qtbot, wav(tmp_path, AN_A))
    press(window, Qt.Key.Key_3, CONTROL)
    qtbot.waitUntil(lambda: bool(window.talk.head.trouble))
    assert window.talk.head.trouble.startswith("The head cannot be shown: pictures need OpenGL 3.3, ")
    press(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: desktop.session.history.n > 20)


@pytest.mark.usefixtures("own_desktop")
@pytest.mark.long
def test_a_theme_changes_the_colours_and_nothing_else(window, desktop, qtbot):
    window.talk.head.setFocus()
    press(window, Qt.Key.Key_Right)
    press(window, Qt.Key.Key_W)
    window.talk.visemes.sliders["o"].setValue(40)
    camera, width = window.talk.head.camera, window.width()
    desktop.set_theme("dark")
    head = desktop.window.talk.head
    drawn(head, qtbot)
    assert desktop.window.pages.currentIndex() == 2
    assert head.camera == camera
    assert head.wireframe
    assert desktop.window.talk.heads.wireframe.isChecked()
    assert desktop.window.talk.visemes.sliders["o"].value() == 40
    assert picture(head)[4, 4].max() < 60
    for key in (Qt.Key.Key_1, Qt.Key.Key_3, Qt.Key.Key_2, Qt.Key.Key_1):
        press(desktop.window, key, CONTROL)
        settle()
    assert abs(desktop.window.width() - width) <= 2


# -- looking at it ------------------------------------------------------------------------------------


def test_the_head_is_looked_at_from_all_sides_by_mouse_and_keys(window):
    head, heads, actions = window.talk.head, window.talk.heads, window.menus.actions
    front, light = head.camera, head.light.azimuth
    before = picture(head)
    dragged(head, LEFT)
    assert head.camera.azimuth < front.azimuth
    assert head.camera.centre == front.centre
    assert np.abs(picture(head).astype(int) - before).mean() > 1
    press(window, Qt.Key.Key_Home)
    assert head.camera == front
    for mouse, options in ((Qt.MouseButton.RightButton, {}), (LEFT, {"modifier": SHIFT})):
        dragged(head, mouse, **options)
        assert head.camera.azimuth == 0
        assert head.camera.centre[0] < 0  # the camera goes left, and so the head right
        QTest.mouseDClick(head, LEFT)
        assert head.camera.centre == head.camera.home
    head.setFocus()
    turn_wheel(head, 1)
    near = head.camera.distance
    assert near < front.distance
    press(window, Qt.Key.Key_Plus)
    assert head.camera.distance < near
    press(window, Qt.Key.Key_Minus)
    press(window, Qt.Key.Key_Minus)
    assert head.camera.distance == pytest.approx(front.distance)
    press(window, Qt.Key.Key_Left)
    press(window, Qt.Key.Key_Up)
    assert head.camera.azimuth < 0 < head.camera.elevation
    press(window, Qt.Key.Key_Right, SHIFT)
    assert head.camera.centre != head.camera.home
    press(window, Qt.Key.Key_Period)
    assert head.light.azimuth > light
    click(heads.light_left)
    assert head.light.azimuth == pytest.approx(light)
    actions["Move Light Right (.)"].trigger()
    assert head.light.azimuth > light
    click(heads.framings[Framing.FACE])
    assert head.camera == Camera.facing(window.talk_parts.model.face.morph_mesh.mesh)
    head.setFocus()
    solid = picture(head)
    press(window, Qt.Key.Key_W)
    assert heads.wireframe.isChecked()
    assert np.abs(picture(head).astype(int) - solid).mean() > 5
    click(heads.wireframe)
    assert not head.wireframe
    actions["Wireframe (W)"].trigger()
    assert heads.wireframe.isChecked()
    actions["Wireframe (W)"].trigger()
    assert not head.wireframe


def dragged(head: HeadView, mouse: Qt.MouseButton, modifier: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier):
    middle = QPoint(head.width() // 2, head.height() // 2)
    QTest.mousePress(head, mouse, modifier, middle)
    head.mouseMoveEvent(_moved(head, middle + QPoint(60, 0), mouse, modifier))
    QTest.mouseRelease(head, mouse, modifier, middle + QPoint(60, 0))


def _moved(head, to, mouse, modifier):
    from PySide6.QtCore import QEvent
    from PySide6.QtGui import QMouseEvent

    place = QPointF(to)
    return QMouseEvent(QEvent.Type.MouseMove, place, head.mapToGlobal(place), mouse, mouse, modifier)


# -- what it says -------------------------------------------------------------------------------------


def test_the_mouth_opens_when_the_file_says_an_a_and_silence_or_stop_closes_it(window, desktop, qtbot):
    session, bars = desktop.session, window.talk.bars
    window.set_frozen(True)  # as the menu does: its letter acts on the page Analyse only
    revision = desktop.talking.head.revision
    press(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: session.source.position > 0.3)
    assert desktop.talking.head.revision == revision
    window.set_frozen(False)
    open_mouth(desktop, qtbot)
    qtbot.waitUntil(lambda: max(map(max, bars._shown), default=0) > 10)
    qtbot.waitUntil(lambda: window.talk.chip.phoneme.label == "a")
    closed_mouth(desktop, qtbot)
    qtbot.waitUntil(lambda: not session.source.playing)
    press(window, Qt.Key.Key_Space)
    open_mouth(desktop, qtbot)
    press(window, Qt.Key.Key_Escape)
    closed_mouth(desktop, qtbot)
    assert session.source.position == 0


def test_a_key_a_button_and_a_slider_open_the_mouth_until_they_are_let_go(window, desktop, qtbot):
    visemes, head = window.talk.visemes, window.talk.head
    held, slider = visemes.buttons["a"], visemes.sliders["a"]
    head.setFocus()
    QTest.keyPress(head, Qt.Key.Key_A)
    assert held.isDown()
    open_mouth(desktop, qtbot, 40)
    QTest.keyRelease(head, Qt.Key.Key_A)
    window.talk.keys.settling.timeout.emit()
    assert not held.isDown()
    closed_mouth(desktop, qtbot)
    QTest.mousePress(held, LEFT)
    open_mouth(desktop, qtbot, 40)
    QTest.mouseRelease(held, LEFT)
    closed_mouth(desktop, qtbot)
    slider.setFocus()
    assert not visemes.leave.isEnabled()
    for _ in range(6):
        press(window, Qt.Key.Key_PageUp)
    assert slider.value() == 60
    open_mouth(desktop, qtbot, 25)
    click(visemes.leave)
    assert slider.value() == 0
    closed_mouth(desktop, qtbot)


def test_the_page_has_the_choice_of_what_becomes_of_other_shapes(window, desktop):
    visemes = window.talk.visemes

    def values_after(mode: Mode) -> tuple[int, int]:
        visemes.mode.setCurrentIndex(visemes.mode.findData(mode.value))
        visemes.mode.activated.emit(visemes.mode.currentIndex())
        click(visemes.leave)
        visemes.sliders["a"].setValue(80)
        visemes.sliders["o"].setValue(60)
        return visemes.sliders["a"].value(), visemes.sliders["o"].value()

    assert visemes.mode.currentData() == Mode.INTERACT
    assert values_after(Mode.INTERACT) == (40, 60)
    assert values_after(Mode.NONE) == (80, 60)
    assert values_after(Mode.RESET) == (0, 60)
    assert values_after(Mode.FORCE_RESET) == (0, 60)
    QTest.mousePress(visemes.buttons["e"], LEFT)
    assert (visemes.sliders["e"].value(), visemes.sliders["o"].value()) == (100, 0)
    QTest.mouseRelease(visemes.buttons["e"], LEFT)
    assert (visemes.sliders["e"].value(), visemes.sliders["o"].value()) == (0, 60)


def test_another_table_brings_its_own_shapes(window, desktop, qtbot):
    table = window.talk.choices.table
    table.setCurrentIndex(table.findData("five"))
    table.activated.emit(table.currentIndex())
    assert set(window.talk.visemes.buttons) == {"open", "wide", "round", "closed", "slightly open"}
    QTest.keyPress(window.talk.head, Qt.Key.Key_A)
    qtbot.waitUntil(lambda: jaw(desktop) > 40)
    assert window.talk.visemes.buttons["open"].isDown()
    QTest.keyRelease(window.talk.head, Qt.Key.Key_A)
    window.talk.keys.settling.timeout.emit()


def test_a_card_opens_a_recording_beside_the_head_where_only_the_demo_is_open(window, desktop, tmp_path):
    other = wav(tmp_path, AN_A, "other.wav")
    window.files.show = FileAnswers(other)
    desktop.demo = desktop.session.path
    window.show_page(0)
    window.welcome.show_cards()
    window.welcome.cards[3].click()
    assert desktop.session.path == other
    assert window.talk.isVisible()


def test_left_and_right_go_one_picture_at_every_rate(window, desktop):
    box, session = window.talk.pictures.rate, desktop.session
    for rate in (PICTURE_RATES[0], PICTURE_RATES[-1]):
        box.setCurrentIndex(box.findData(rate))
        box.activated.emit(box.currentIndex())
        window.talk.lanes.line.setFocus()
        for picture in range(1, 4):
            press(window, Qt.Key.Key_Right)
            assert desktop.talking.pictures.number == picture
            assert picture / rate <= session.source.position + 1e-6 < (picture + 1) / rate
        window.talk.pictures.refresh()
        assert window.talk.pictures.place.text().endswith("picture 3")
        press(window, Qt.Key.Key_Left)
        assert desktop.talking.pictures.number == 2
        session.seek(0.0)
        press(window, Qt.Key.Key_Left)
        assert desktop.talking.pictures.number == 0


def test_the_page_shows_how_fast_the_mouth_is_for_which_sound(window, desktop, tmp_path, qtbot):
    times, choices = window.talk.choices.times, window.talk.choices
    assert times.milliseconds(Phoneme.M) == ("58", "150")
    assert times.milliseconds(Phoneme.A) == ("100", "200")
    assert "a: attack 100 ms, release 200 ms" in times.toolTip()
    before = times.grab().toImage()
    choices.attack.setValue(150)
    choices.release.setValue(200)
    assert times.milliseconds(Phoneme.A) == ("150", "400")
    assert "a: attack 150 ms, release 400 ms" in times.toolTip()
    assert times.grab().toImage() != before
    text = (TABLES / "arkit.toml").read_text(encoding="utf-8").replace("a = { attack = 0.10", "a = { attack = 0.20")
    (tmp_path / "mine.toml").write_text(text, encoding="utf-8")
    desktop.talking.set_table(str(tmp_path / "mine.toml"))
    qtbot.waitUntil(lambda: times.milliseconds(Phoneme.A) == ("300", "400"))
    assert times.milliseconds(Phoneme.M) == ("87", "300")


# -- the next start -----------------------------------------------------------------------------------


def test_choices_come_back_at_the_next_start(qapp, settings: QSettings, no_microphone: Microphone, qtbot, tmp_path):
    def start() -> Desktop:
        return Desktop(qapp, settings, lambda _n: ClockOutput(), no_microphone, PresetModel(THESIS_PRESET))

    desktop = start()
    window = shown(desktop, qtbot, None)
    press(window, Qt.Key.Key_3, CONTROL)
    choices = window.talk.choices
    desktop.talking.set_table("five")
    for box in (choices.blinks, choices.random):
        click(box)
    choices.attack.setValue(200)
    choices.release.setValue(50)
    desktop.talking.set_mode(Mode.NONE)
    desktop.talking.osc.set_address("127.0.0.1:9000")
    desktop.close()
    again = start()
    talking = again.talking
    assert (talking.table_name, talking.idle.blinks, talking.random, talking.idle.head) == (
        "five",
        False,
        False,
        True,
    )
    assert again.window.talk.visemes.mode.currentData() == Mode.NONE
    a, written = talking.table.times[Phoneme.A], load_table("five").times[Phoneme.A]
    assert (a.attack, a.release) == pytest.approx((2 * written.attack, written.release / 2))
    assert again.window.talk.choices.attack.value() == 200
    assert again.window.talk.osc.fields.address.text() == "127.0.0.1:9000"
    assert not talking.osc.on
    again.close()


# -- the microphone -----------------------------------------------------------------------------------


def test_the_head_says_what_the_microphone_hears(open_booth, mic, graphics):
    booth = open_booth(mic)
    booth.listen()
    press(booth.window, Qt.Key.Key_3, CONTROL)
    booth.until(lambda: booth.desktop.talking.face.states is not None)
    booth.feed(mic, vowel((700, 1200, 2500), 0.3))
    booth.until(lambda: jaw(booth.desktop) > 15)
    booth.until(lambda: jaw(booth.desktop) < 1, mic)


def test_the_eyes_look_about_unless_blinks_are_off(desktop, qtbot):
    desktop.window.show()
    head = desktop.talking.head
    desktop.talking.face.wake()
    qtbot.waitUntil(lambda: head.face.states is not None)
    seen = set()
    for k in range(200):
        head.move(k * 0.2)
        seen.add(tuple(round(head.face.states.percentage(name), 3) for name in EYES))
    assert len(seen) > 5
    head.configure(load_table("arkit"), replace(desktop.talking.idle, blinks=False))
    head.move(41.0)
    assert all(head.face.states.percentage(name) == 0 for name in EYES)
