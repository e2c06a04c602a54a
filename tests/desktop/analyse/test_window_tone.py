"""The tone generator in place of a sound, by mouse and keyboard."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.audio.tone import VOWEL_FORMANTS, ToneKind
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import BIN_WIDTH
from tests.desktop.hands import CARDS, TimeEyes, click, drag, press, shown, type_number
from tests.desktop.studio import choose

CONTROL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def window(desktop, qtbot) -> MainWindow:
    window = shown(desktop, qtbot)
    choose(window.transport.source, "Tone")
    return window


@pytest.fixture
def heard(desktop, window, qtbot):
    """Play, wait until some more frames were analysed, and give the spectra of the newest ones."""

    def wait(n: int = 30) -> np.ndarray:
        if not desktop.session.source.playing:
            desktop.session.play()
        until = desktop.session.history.n + n + 40  # what was written before a change is still to be heard
        qtbot.waitUntil(lambda: desktop.session.history.n >= until)
        window.redraw.refresh_all()
        return desktop.session.history.newest.spectra

    return wait


def peak(window: MainWindow) -> float:
    """The frequency at which the drawn spectrum is highest, Hz."""
    x, y = window.analysis.spectrum.item.curves[0].getData()
    return float(x[np.argmax(y)])


def settled(desktop, window, qtbot, frequency: float) -> None:
    """Wait until the drawn spectrum has its peak at a frequency."""
    qtbot.waitUntil(lambda: peak(window) == pytest.approx(frequency, abs=BIN_WIDTH))


def test_a_tone_waits_until_it_is_played_and_is_seen_at_its_frequency_and_level(desktop, window, heard, qtbot):
    session = desktop.session
    assert session.source.kind is SourceKind.TONE
    assert not session.source.playing
    press(window, Qt.Key.Key_Space)
    assert session.source.playing
    heard()
    assert peak(window) == pytest.approx(1000, abs=BIN_WIDTH)
    window.resize(1280, 1100)  # so that a pixel of the sonagram is less than two bins high
    assert TimeEyes(window).brightest(-0.1) == pytest.approx(1000, abs=2 * BIN_WIDTH)
    assert window.windowTitle().startswith("Tone - ")
    qtbot.waitUntil(lambda: window.status.left.text().strip().startswith("Tone: sine"))
    type_number(window.transport.tone.numbers["level"], "-20")
    heard()
    assert float(window.analysis.phoneme.meters["vol"]) == pytest.approx(0.1, abs=0.005)
    press(window, Qt.Key.Key_Down, CONTROL)  # the volume is only what is heard
    heard()
    assert session.playback.volume == -3
    assert float(window.analysis.phoneme.meters["vol"]) == pytest.approx(0.1, abs=0.005)
    window.analysis.spectrum.setFocus()
    press(window, Qt.Key.Key_Space)
    assert not session.source.playing
    click(window.transport.play)
    heard(1)
    assert session.source.playing


def test_whatever_is_chosen_of_a_tone_starts_nothing_and_it_has_less_than_a_file(desktop, window):
    transport, session = window.transport, desktop.session
    choices = (
        lambda: transport.source.activated.emit(transport.source.currentIndex()),
        lambda: choose(transport.tone.kind, "vowel"),
        lambda: choose(transport.tone.vowel, "e"),
        lambda: type_number(transport.tone.numbers["F1"], "500"),
    )
    for act in choices:
        act()
        assert not session.source.playing
    assert session.playback.tone.formants[0].frequency == 500
    session.play()
    assert not any(widget.isVisible() for widget in (transport.loop, transport.channel, transport.position_slider))
    assert transport.volume.isVisible()
    assert transport.tone.isVisible()
    assert " / " not in transport.time.text()
    press(window, Qt.Key.Key_Right, CONTROL)
    assert session.source.position < 1


def test_slider_and_number_move_what_is_seen(desktop, window, heard, qtbot):
    heard()
    slider = window.transport.tone.slider
    handle = slider.width() * slider.value() / slider.maximum()
    drag(slider, handle, handle + slider.width() * 0.15)
    assert 2000 < window.transport.tone.tone.frequency < 4000
    settled(desktop, window, qtbot, window.transport.tone.tone.frequency)
    type_number(window.transport.tone.numbers["frequency"], "440")
    settled(desktop, window, qtbot, 440)
    assert desktop.session.source.playing


def test_every_kind_shows_its_own_numbers_and_a_vowel_brings_its_formants_to_the_ear(desktop, window, heard):
    bar = window.transport.tone
    desktop.session.play()
    for kind in (*ToneKind, ToneKind.SINE, ToneKind.VOWEL):
        choose(bar.kind, kind.value.replace("_", " "))
        assert desktop.session.playback.tone.kind is kind
        assert bar.slider.isVisible() == (kind is ToneKind.SINE)
        assert bar.vowel.isVisible() == bar.unit.isVisible() == (kind is ToneKind.VOWEL)
        assert desktop.session.source.playing
    heard()
    assert window.analysis.phoneme.phoneme is Phoneme.A
    assert float(window.analysis.phoneme.meters["f(g)"].removesuffix(" Hz")) == pytest.approx(120, abs=2)
    choose(bar.vowel, "u")
    assert desktop.session.playback.tone.formants == VOWEL_FORMANTS["u"]
    heard()
    x, y = window.analysis.spectrum.item.curves[0].getData()
    below, above = y[(x > 200) & (x < 900)].max(), y[(x > 1100) & (x < 1500)].max()
    assert below > 10 * above


@pytest.mark.long
def test_white_noise_is_flat_and_pink_noise_falls(desktop, window, heard):
    window.filters.bypass.setChecked(True)
    slopes = {}
    for kind in ("white noise", "pink noise"):
        choose(window.transport.tone.kind, kind)
        heard()
        desktop.session.averages.begin("Clear", "sound")
        heard(60)
        mean = desktop.session.averages.current().amplitudes
        low, high = (np.mean(mean[round(at / BIN_WIDTH) : round(2 * at / BIN_WIDTH)]) for at in (300, 1200))
        slopes[kind] = 20 * np.log10(high / low) / 2
    assert slopes["white noise"] == pytest.approx(0, abs=1)
    assert slopes["pink noise"] == pytest.approx(-3, abs=1)


@pytest.mark.long
def test_a_sweep_rises(desktop, window, heard):
    choose(window.transport.tone.kind, "sweep")
    type_number(window.transport.tone.numbers["low"], "500")
    type_number(window.transport.tone.numbers["high"], "4000")
    type_number(window.transport.tone.numbers["sweep_seconds"], "120")
    heard()
    first = peak(window)
    heard(250)
    assert 480 <= first < peak(window) < 800


def test_the_file_is_not_lost_by_a_tone(desktop, qtbot):
    window = shown(desktop, qtbot)
    desktop.session.seek(1.25)
    choose(window.transport.source, "Tone")
    desktop.session.play()
    qtbot.waitUntil(lambda: desktop.session.source.position > 0.2)
    assert desktop.session.path == CARDS
    choose(window.transport.source, "File")
    assert desktop.session.path == CARDS
    assert desktop.session.source.position == pytest.approx(1.25, abs=0.01)
    assert window.transport.time.text().startswith("0:01.2")
    press(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: desktop.session.source.position > 1.4)


@pytest.mark.long
@pytest.mark.usefixtures("own_desktop")
def test_another_theme_keeps_the_tone(desktop, window, heard, qtbot):
    choose(window.transport.tone.kind, "vowel")
    choose(window.transport.tone.vowel, "o")
    desktop.session.play()
    desktop.set_theme("dark" if window.theme.name == "light" else "light")
    assert desktop.session.source.playing
    bar = desktop.window.transport.tone
    assert (bar.kind.currentText(), bar.vowel.currentText()) == ("vowel", "o")
    assert bar.isVisible()
    assert bar.vowel.isVisible()
    assert bar.tone == desktop.session.playback.tone
