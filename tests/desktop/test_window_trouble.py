"""A microphone that is missing, vanishes, hangs or is late: what the window says."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt

from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.errors import EngineError
from tests.desktop.hands import press
from tests.desktop.session.test_microphone_trouble import MEASURED
from tests.desktop.studio import DESK, Booth, choose
from tests.fakes.microphones import HandDrivenMicrophone
from tests.sounds import noise

Open = Callable[..., Booth]

CONTROL = Qt.KeyboardModifier.ControlModifier


def test_a_missing_microphone_is_said_in_banner_and_status_line_and_its_coming_too(
    open_booth: Open, mic: HandDrivenMicrophone
):
    booth = open_booth()
    booth.listen()
    booth.until(lambda: booth.banner == "The microphone is not there; plug it in; trying again every 2 s.")
    booth.until(lambda: "Microphone: the microphone is not there" in booth.status)
    booth.until(lambda: "Latency" not in booth.window.status.chips.words())
    booth.studio.openers.waiting.append(mic)
    booth.until(lambda: booth.banner.startswith("The microphone is back: Desk · ALSA."), mic)
    booth.until(lambda: "Microphone: Desk · ALSA, 44 100 Hz" in booth.status, mic)


def test_a_microphone_that_vanishes_in_mid_recording_is_waited_for_and_the_loss_is_counted(
    booth: Booth, mic: HandDrivenMicrophone
):
    back = HandDrivenMicrophone(name=DESK.label)
    booth.record()
    booth.feed(mic, noise(0.3))
    assert "s lost" not in booth.status
    mic.lost = True
    booth.until(lambda: booth.banner.endswith("; the recording continues once the signal is back."))
    booth.until(lambda: booth.window.transport.time.text().startswith("waiting "))
    booth.until(lambda: booth.window.analysis.phoneme.accessibleName() == "No signal")
    assert booth.window.analysis.phoneme.trace is None
    assert booth.window.analysis.phoneme.intensity == 0
    assert booth.window.transport.record.isChecked()
    booth.until(lambda: booth.studio.model.listener.lost_seconds > 0.5)
    booth.until(lambda: "s lost" in booth.status)
    booth.studio.openers.waiting.append(back)
    booth.until(lambda: booth.banner.startswith("The microphone is back"), back)
    booth.until(lambda: booth.window.transport.time.text().startswith("● "), back)
    booth.until(lambda: booth.window.analysis.phoneme.accessibleName() != "No signal", back)
    lost = booth.studio.model.listener.lost_seconds
    assert lost > 0.1
    booth.until(lambda: f"{lost:.2f} s lost" in booth.status, back)
    booth.record()
    booth.until(lambda: booth.banner.startswith("Recorded "), back)
    assert booth.banner.endswith(f"s to {booth.studio.take}, with 1 gap of {lost:.2f} s marked in it")
    assert len(booth.studio.files) == 1


@pytest.mark.usefixtures("open_own_booth")
def test_the_window_lives_while_a_microphone_hangs_and_another_source_can_be_chosen(
    open_booth: Open, mic: HandDrivenMicrophone
):
    booth = open_booth(mic)
    booth.studio.openers.may_answer.clear()
    booth.listen()
    ticks = booth.window.redraw.n_ticks
    booth.until(lambda: booth.banner == "Opening the microphone.")
    booth.until(lambda: booth.window.redraw.n_ticks > ticks + 30)
    choose(booth.window.transport.source, "File")
    assert booth.desktop.session.source.kind is SourceKind.FILE
    press(booth.window, Qt.Key.Key_Space)
    booth.until(lambda: booth.desktop.session.history.n > 10)
    assert booth.window.close()
    booth.desktop.session.close()
    assert booth.studio.openers.hangs
    booth.studio.openers.may_answer.set()
    booth.until(mic.closed.is_set)


def test_a_recogniser_that_fails_while_it_listens_lets_the_microphone_go_with_a_sentence(
    booth: Booth, mic: HandDrivenMicrophone
):
    booth.feed(mic, noise(0.2))
    mic.fault = EngineError("it cannot be recognised; choose another recogniser")
    booth.until(lambda: booth.banner == "it cannot be recognised; choose another recogniser")
    assert not booth.desktop.session.source.playing
    booth.until(mic.closed.is_set)


# -- latency ------------------------------------------------------------------------------------------


def shares(booth: Booth) -> dict[str, int]:
    """The parts of the latency as the chip's tip gives them, ms."""
    tip = booth.window.status.chips.late.toolTip()
    words = tip[tip.index(": ") + 2 : tip.index(" ms.")].split(" + ")
    return {name: int(number) for name, number in (word.split(" ") for word in words)}


def test_the_latency_is_the_sum_of_its_parts_and_judged_while_something_comes(
    booth: Booth, mic: HandDrivenMicrophone
):
    status = booth.window.status
    mic.delay = 0.033
    booth.until(lambda: "capture 33" in status.chips.late.toolTip(), mic)
    parts = shares(booth)
    assert list(parts) == ["capture", "window", "hop", "analysis", "display"]
    assert (parts["window"], parts["hop"]) == (23, 5)
    assert status.latency_ms == pytest.approx(sum(parts.values()), abs=2.6)
    assert f"Latency {status.latency_ms:.0f} ms" in booth.status
    for seconds, words, colour in (
        (0.045, "not noticeable", "good"),
        (0.0451, "noticeable", "faint"),
        (0.09, "noticeable", "faint"),
        (0.0901, "too high", "bad"),
    ):
        assert status.judged(seconds) == (words, getattr(booth.window.theme, colour))
    mic.delay = 0.1
    booth.until(lambda: "ms (too high)" in booth.status, mic)
    assert booth.window.theme.bad in status.chips.late.styleSheet()
    assert "ITU-R BT.1359" in status.chips.late.toolTip()
    booth.until(lambda: "Latency" not in status.chips.words())
    assert status.latency_ms is None
    assert status.chips.late.toolTip().endswith("being measured")
    choose(booth.window.transport.source, "File")
    booth.until(lambda: "late" not in booth.status)
    assert "lost" not in booth.status


@pytest.mark.usefixtures("portaudio")
def test_without_a_device_a_measurement_by_clicks_says_so_in_one_sentence(open_booth: Open):
    booth = open_booth()
    press(booth.window, Qt.Key.Key_M, CONTROL)
    assert booth.banner.startswith("Measuring latency: playing")
    booth.until(
        lambda: booth.banner.startswith("The latency could not be measured: no microphone was found; connect one")
    )
    assert booth.banner.count(". ") == 0


def test_a_measurement_by_clicks_is_told_and_counts_from_then_on(open_booth: Open, mic: HandDrivenMicrophone):
    back = HandDrivenMicrophone(name=DESK.label)
    booth = open_booth(mic, back)
    booth.studio.measure = lambda _choice: MEASURED
    booth.listen()
    booth.until(lambda: "capture 20" in booth.status, mic)
    booth.window.menus.actions["Measure Latency with Clicks"].trigger()
    booth.until(lambda: booth.banner.startswith("Round-trip latency 120 ms"))
    booth.until(lambda: "capture 31" in booth.status, back)
