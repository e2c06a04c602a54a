"""Looking back at what a microphone heard, while it goes on listening."""

import pytest
from PySide6.QtTest import QTest

from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.settings import FRAME_PERIOD
from tests.desktop.hands import LEFT
from tests.desktop.studio import Booth
from tests.fakes.microphones import HandDrivenMicrophone
from tests.sounds import noise


def test_what_was_heard_is_seen_like_a_file_and_live_goes_on(booth: Booth, mic: HandDrivenMicrophone, tmp_path):
    window, session = booth.window, booth.desktop.session
    booth.feed(mic, noise(2.0))
    QTest.mouseClick(window.analysis.scroll_view.back, LEFT)
    booth.until(lambda: session.seen.looks_back and not session.busy)
    assert window.analysis.over_time.currentWidget() is window.analysis.file
    assert session.view.duration == pytest.approx(2.0, abs=0.2)
    assert session.whole.tracks.n_frames == pytest.approx(session.view.duration / FRAME_PERIOD, abs=3)
    assert window.menus.actions["Show History"].isChecked()
    session.view.select(TimeSpan(0.5, 1.0))
    target = tmp_path / "piece.wav"
    window.selection.save(target)
    booth.until(target.exists)
    frames = booth.frames
    booth.feed(mic, noise(0.5))
    assert len(booth.frames) > len(frames)
    window.menus.actions["Insert Label"].trigger()
    booth.until(lambda: booth.banner.startswith("The history can't be labelled"))
    QTest.mouseClick(window.analysis.file.live, LEFT)
    assert window.analysis.over_time.currentWidget() is window.analysis.scroll_view
    assert not session.seen.looks_back


def test_what_was_heard_since_clear_is_averaged(booth: Booth, mic: HandDrivenMicrophone):
    session = booth.desktop.session
    booth.feed(mic, noise(0.5))
    session.clear()
    booth.feed(mic, noise(1.0))
    booth.window.dialogs.curves.add_microphone()
    booth.until(lambda: len(session.curves.curves) == 1)
    (curve,) = session.curves.curves
    assert curve.name == session.microphone.name
    assert curve.seconds == pytest.approx(1.0, abs=0.2)
    session.clear()
    session.curves.measure_again([0])
    booth.until(lambda: "cannot be measured again, since" in booth.banner)
    assert session.curves.curves == (curve,)


def test_clear_forgets_it_and_nothing_heard_is_said(booth: Booth, mic: HandDrivenMicrophone):
    session = booth.desktop.session
    booth.feed(mic, noise(0.5))
    session.look_back(True)
    assert session.seen.looks_back
    session.clear()
    assert not session.seen.looks_back
    session.look_back(True)
    booth.until(
        lambda: (
            booth.banner == "The history is empty, since the microphone was not used yet. Press Space "
            "to listen, then try again."
        )
    )
