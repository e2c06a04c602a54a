"""The controls of microphone and tone: found by mouse, keyboard and screen reader, and never clipped."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QAbstractSpinBox, QApplication, QComboBox, QLabel, QSlider, QWidget

from phonemeanalyser.desktop.help import ShortcutsDialog
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.audio.stream import Device
from phonemeengine.audio.tone import ToneKind
from phonemeengine.presets.files import DEFAULT_PRESET
from tests.desktop.hands import lies_behind, press, settle
from tests.desktop.studio import Booth, choose
from tests.desktop.test_window_sizes import name_of, room_and_need
from tests.fakes.microphones import HandDrivenMicrophone
from tests.sounds import tone

SIZES = [(1280, 800), pytest.param((1920, 1080), marks=pytest.mark.long)]
PAGES = ["Microphone", *ToneKind]
LONG = Device("A Very Long Name of a Microphone With Eight Channels", "Windows WASAPI", 8, 0, 96_000, is_default=True)

Open = Callable[..., Booth]


def turned_to(booth: Booth, page: str) -> MainWindow:
    """Choose the microphone, or a kind of tone."""
    choose(booth.window.transport.source, "Microphone" if page == "Microphone" else "Tone")
    if page != "Microphone":
        choose(booth.window.transport.tone.kind, page.replace("_", " "))
    return booth.window


def controls(window: MainWindow) -> list[QWidget]:
    kinds = QAbstractButton | QComboBox | QAbstractSpinBox | QSlider
    return [w for w in window.transport.findChildren(QWidget) if isinstance(w, kinds) and w.isVisible()]


def test_every_control_has_a_tip_and_a_name_and_is_reached_with_tab(booth: Booth):
    for page in PAGES:
        window = turned_to(booth, page)
        assert len(controls(window)) >= 8
        assert [w for w in controls(window) if not (w.toolTip() and w.accessibleName())] == [], page
        assert window.transport.microphone.meter.toolTip()
        assert window.transport.microphone.meter.accessibleName()
        window.transport.source.setFocus()
        reached: list[QWidget] = [window.transport.source]
        for _ in range(60):
            QTest.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_Tab)
            reached.append(QApplication.focusWidget())
        missed = [w for w in controls(window) if w.isEnabled() and w not in reached]
        assert [name_of(w) if hasattr(w, "text") else w.accessibleName() for w in missed] == [], page


def test_invitation_keys_and_status_line_fit_the_source_and_none_needs_more_than_1280_pixels(
    booth: Booth, mic: HandDrivenMicrophone
):
    window = booth.window
    booth.until(lambda: "Latency" in booth.status, mic)
    invitations = {}
    for source in ("Tone", "File", "Microphone"):
        choose(window.transport.source, source)
        invitations[source] = window.analysis.scroll_view._hint.toPlainText()
    assert "R to record" in invitations["Microphone"]
    assert "tone" in invitations["Tone"]
    assert invitations["File"] == "Press Space to play"
    booth.desktop.preset.load(DEFAULT_PRESET)
    window.status.refresh(frozen=False)
    assert "Model: encoder, look-ahead 20 ms" in window.status.left.text()
    for page in PAGES:
        turned_to(booth, page)
        assert window.minimumSizeHint().width() <= 1280, page
        assert window.transport.minimumSizeHint().width() <= 1280, page
    press(window, Qt.Key.Key_F1)
    dialog = window.findChild(ShortcutsDialog)
    assert dialog.width() <= dialog.screen().availableSize().width()
    text = dialog.list.text()
    for name, key in {"Record": "R", "Rescan Audio Devices": "F5", "Measure Latency with Clicks": "Ctrl+M"}.items():
        assert f"<td>{name}&nbsp;&nbsp;&nbsp;</td><td>{key}</td>" in text
    dialog.close()


@pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size[0]}x{size[1]}")
def test_every_text_has_room_while_it_records_and_says_the_most(open_booth: Open, size: tuple[int, int]):
    mic = HandDrivenMicrophone(name=LONG.label)
    booth = open_booth(mic)
    booth.studio.devices.append(LONG)
    window = booth.window
    window.resize(*size)
    booth.record()
    booth.until(lambda: window.transport.microphone.device.count() == 4)
    booth.feed(mic, tone(1000, 0.3, 1.0))
    booth.until(lambda: "Latency" in booth.status, mic)
    for page in PAGES:
        if page != "Microphone":
            turned_to(booth, page)
            booth.until(lambda: booth.banner.startswith("Recorded "))
        settle()
        assert (window.width(), window.height()) == size
        kinds = QLabel | QAbstractButton | QComboBox | QAbstractSpinBox
        shown = [w for w in window.findChildren(QWidget) if isinstance(w, kinds) and w.isVisible()]
        texts = [w for w in shown if not lies_behind(w)]
        texts.remove(window.transport.microphone.device) if page == "Microphone" else None  # its tip tells the rest
        clipped = {name_of(w): room_and_need(w) for w in texts if room_and_need(w)[0] < room_and_need(w)[1]}
        outside = [name_of(w) for w in texts if not w.parentWidget().rect().contains(w.geometry())]
        assert (clipped, outside) == ({}, []), page
