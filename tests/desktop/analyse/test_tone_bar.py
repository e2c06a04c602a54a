"""The tone generator's controls say what they show, and show only what applies."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QWidget
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.analyse.transport.source_bars import OF_KIND, SLIDER_STEPS, ToneBar
from phonemeanalyser.desktop.theme import DARK
from phonemeengine.audio.tone import VOWEL_FORMANTS, Formant, Tone, ToneKind
from tests.desktop.hands import type_number

Shown = Callable[[Tone], ToneBar]


@pytest.fixture
def told() -> list[Tone]:
    return []


@pytest.fixture
def shown(qapp: QApplication, qtbot: QtBot, told: list[Tone]) -> Shown:
    """Show a bar with a tone; what it signals goes to `told`."""

    def show(tone: Tone) -> ToneBar:
        bar = ToneBar(DARK)
        qtbot.addWidget(bar)
        bar.show_tone(tone)
        bar.tone_changed.connect(told.append)
        with qtbot.waitExposed(bar):
            bar.show()
        return bar

    return show


def choose(box: QComboBox, text: str) -> None:
    """Choose with the keyboard, as a person does."""
    box.setFocus()
    step = Qt.Key.Key_Down if box.findText(text) > box.currentIndex() else Qt.Key.Key_Up
    while box.currentText() != text:
        QTest.keyClick(box, step)


@pytest.mark.parametrize("kind", ToneKind)
def test_only_what_applies_to_the_kind_is_seen(shown: Shown, kind: ToneKind):
    bar = shown(Tone(kind))
    assert {name for name, box in bar.numbers.items() if box.isVisible()} == {*OF_KIND[kind], "level"}
    assert bar.slider.isVisible() == (kind is ToneKind.SINE)
    assert bar.vowel.isVisible() == (kind is ToneKind.VOWEL)
    assert bar.minimumSizeHint().height() <= 34


def test_showing_a_tone_says_nothing_and_changes_nothing(shown: Shown, told: list[Tone]):
    tone = Tone(ToneKind.VOWEL, -33.0, 441.3, 33, 4444, 7.5, 99, (Formant(333, 44), Formant(2222, 55)))
    bar = shown(tone)
    bar.show_tone(tone)
    assert not told
    assert bar.tone == tone
    assert bar.vowel.currentText() == "custom"
    assert not bar.numbers["F3"].isVisible()


@pytest.mark.parametrize("kind", ToneKind)
def test_every_kind_can_be_chosen_with_the_keyboard(shown: Shown, told: list[Tone], kind: ToneKind):
    bar = shown(Tone(ToneKind.SINE if kind is not ToneKind.SINE else ToneKind.VOWEL))
    choose(bar.kind, kind.value.replace("_", " "))
    assert told[-1] == bar.tone == Tone(kind)


@pytest.mark.parametrize(
    ("kind", "name", "text", "value"),
    [
        (ToneKind.SINE, "frequency", "990.5", 990.5),
        (ToneKind.SWEEP, "low", "100", 100.0),
        (ToneKind.SWEEP, "high", "5000", 5000.0),
        (ToneKind.SWEEP, "sweep_seconds", "2.5", 2.5),
        (ToneKind.VOWEL, "f0", "210", 210.0),
        (ToneKind.PINK_NOISE, "level", "-30", -30.0),
    ],
)
def test_a_typed_number_is_told_once(
    shown: Shown, told: list[Tone], kind: ToneKind, name: str, text: str, value: float
):
    bar = shown(Tone(kind))
    type_number(bar.numbers[name], text)
    assert [getattr(tone, name) for tone in told] == [value]


def test_the_slider_goes_from_20_hz_to_20_khz_by_equal_intervals(shown: Shown, told: list[Tone]):
    bar = shown(Tone())
    heard = []
    for step in (0, SLIDER_STEPS // 3, 2 * SLIDER_STEPS // 3, SLIDER_STEPS):
        bar.slider.setValue(step)
        heard.append(told[-1].frequency)
        assert bar.numbers["frequency"].value() == told[-1].frequency
    assert heard == pytest.approx([20, 200, 2000, 20_000], rel=0.01)


def test_a_page_key_on_the_slider_goes_by_an_octave(shown: Shown, told: list[Tone]):
    bar = shown(Tone(frequency=440.0))
    QTest.keyClick(bar.slider, Qt.Key.Key_PageUp)
    assert told[-1].frequency == pytest.approx(880, rel=0.01)
    QTest.keyClick(bar.slider, Qt.Key.Key_Left)
    assert told[-1].frequency == pytest.approx(880 * 2 ** (-1.2 / 12), rel=0.01)


def test_a_typed_frequency_moves_the_slider_and_stays_as_typed(shown: Shown, told: list[Tone]):
    bar = shown(Tone())
    type_number(bar.numbers["frequency"], "12345.6")
    assert told == [Tone(frequency=12345.6)]
    assert bar.slider.value() == 930


@pytest.mark.parametrize("name", [v for v in VOWEL_FORMANTS if v != "a"])
def test_a_vowel_brings_its_formants(shown: Shown, told: list[Tone], name: str):
    bar = shown(Tone(ToneKind.VOWEL))
    choose(bar.vowel, name)
    assert told[-1].formants == VOWEL_FORMANTS[name]
    assert [bar.numbers[f].value() for f in ("F1", "F2", "F3")] == [f.frequency for f in VOWEL_FORMANTS[name][:3]]


def test_another_formant_makes_the_vowel_an_own_one(shown: Shown, told: list[Tone]):
    bar = shown(Tone(ToneKind.VOWEL))
    type_number(bar.numbers["F2"], "1500")
    assert bar.vowel.currentText() == "custom"
    assert told[-1].formants == (VOWEL_FORMANTS["a"][0], Formant(1500, 70), *VOWEL_FORMANTS["a"][2:])


def test_choosing_own_leads_to_the_first_formant_and_changes_no_sound(shown: Shown, told: list[Tone]):
    bar = shown(Tone(ToneKind.VOWEL, formants=VOWEL_FORMANTS["u"]))
    bar.vowel.setFocus()
    QTest.keyClick(bar.vowel, Qt.Key.Key_Down)
    assert bar.vowel.currentText() == "custom"
    assert bar.focusWidget() is bar.numbers["F1"]
    assert not told


def test_a_sweep_that_would_fall_pushes_its_other_end(shown: Shown, told: list[Tone]):
    bar = shown(Tone(ToneKind.SWEEP, low=100, high=1000))
    type_number(bar.numbers["low"], "3000")
    assert (told[-1].low, told[-1].high) == (3000, 3001)
    type_number(bar.numbers["high"], "20")
    assert (told[-1].low, told[-1].high) == (20, 21)
    type_number(bar.numbers["low"], "20000")
    assert (told[-1].low, told[-1].high) == (19_999, 20_000)
    assert bar.numbers["low"].value() == 19_999


def test_every_control_has_a_name_and_a_tip(shown: Shown):
    bar = shown(Tone())
    controls: tuple[QWidget, ...] = (bar.kind, bar.slider, bar.vowel, *bar.numbers.values())
    assert all(control.accessibleName() and control.toolTip() for control in controls)
