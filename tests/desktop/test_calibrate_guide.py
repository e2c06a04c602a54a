"""The guided calibration: it hears a person out, says what to repeat, and gives a preset that knows the voice."""

from collections.abc import Callable

import numpy as np
import pytest
from PySide6.QtCore import Qt

from engine.phonemes import Phoneme
from engine.settings import SAMPLE_RATE
from phonemeanalyser.models.calibration_guide import STEPS, Phase, onset_in
from tests.desktop.calibrating import Calibrator, in_room, said
from tests.desktop.hands import click, press
from tests.desktop.studio import Booth
from tests.microphones import HandDrivenMicrophone
from tests.sounds import noise, silence, tone

Open = Callable[..., Booth]


@pytest.fixture
def guided(open_booth: Open, mic: HandDrivenMicrophone) -> Calibrator:
    """Somebody who has been heard being quiet, and is asked for the first sound."""
    calibrator = Calibrator(open_booth(mic), mic)
    press(calibrator.booth.window, Qt.Key.Key_G)
    calibrator.until(lambda: calibrator.model.guide.index == 1, silently=False)
    return calibrator


def give(calibrator: Calibrator, sound: np.ndarray) -> None:
    calibrator.booth.give(calibrator.mic, in_room(sound))


def answer(calibrator: Calibrator, k: int, *, loud: float = 1.0) -> None:
    """Say the sound of a step when it is asked for, and wait until it was judged."""
    guide = calibrator.model.guide
    calibrator.until(lambda: (guide.index, guide.phase) == (k, Phase.WAITING), silently=False)
    give(calibrator, silence(0.2))
    give(calibrator, np.clip(loud * said(STEPS[k].phoneme, 1.8), -1, 1))
    calibrator.until(lambda: guide.phase is Phase.SHOWING, silently=False)


def test_who_follows_gets_a_better_preset_for_his_voice_and_undo_brings_the_old_one_back(guided: Calibrator):
    guide, preset = guided.model.guide, guided.booth.desktop.preset
    before = preset.preset
    n_given = guided.booth.studio.given[guided.mic]
    for k in range(1, len(STEPS)):
        answer(guided, k)
        assert guide.advice == "", STEPS[k].say
    guided.until(lambda: guide.phase is Phase.LEARNING, silently=False)
    asked = (guided.booth.studio.given[guided.mic] - n_given) / SAMPLE_RATE
    assert asked + 2 < 60  # in under a minute
    guided.until(lambda: guide.phase is Phase.DONE, silently=False)
    assert [take.phoneme for take in guided.takes] == [step.phoneme for step in STEPS]
    assert guide.outcome is not None
    assert guide.outcome.after.ten_f1 > guide.outcome.before.ten_f1
    figures = guided.page.guide.figures
    assert figures.item(0, 1).text() == f"{guide.outcome.after.ten_f1:.1%}"
    assert preset.preset == before
    click(guided.page.guide.accept)
    assert preset.preset.thresholds == guide.outcome.preset.thresholds != before.thresholds
    assert not guide.running
    press(guided.booth.window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert preset.preset == before


def test_a_clipped_sound_is_asked_for_once_more_with_what_to_do(guided: Calibrator):
    guide = guided.model.guide
    answer(guided, 1, loud=5.0)
    assert "too loud for the microphone" in guided.page.guide.advice.text()
    assert guided.takes == () or all(take.phoneme is not Phoneme.A for take in guided.takes)
    answer(guided, 1)
    assert guide.advice == ""
    guided.until(lambda: guide.index == 2, silently=False)


def test_a_room_that_is_not_quiet_is_measured_again(open_booth: Open, mic: HandDrivenMicrophone):
    calibrator = Calibrator(open_booth(mic), mic)
    click(calibrator.page.takes.guide)
    calibrator.until(lambda: calibrator.booth.studio.model.listening, silently=False)
    guide = calibrator.model.guide
    give(calibrator, np.concatenate((silence(0.5), tone(440, 0.4, 0.3), silence(1.6))))
    calibrator.until(lambda: guide.phase is Phase.SHOWING, silently=False)
    assert "quiet" in guide.advice
    assert guide.room is None
    calibrator.until(lambda: guide.index == 1, silently=False)
    assert guide.room is not None
    assert 20 * np.log10(guide.room.level) == pytest.approx(20 * np.log10(0.0006), abs=1)


def test_who_says_nothing_is_told_so_and_asked_again(guided: Calibrator):
    guide = guided.model.guide
    guided.until(lambda: guide.advice, silently=False)
    assert "Nothing was heard" in guide.advice
    assert (guide.index, guide.phase) == (1, Phase.WAITING)


def test_back_lets_a_take_make_room_for_a_new_one(guided: Calibrator):
    guide = guided.model.guide
    answer(guided, 1)
    guided.until(lambda: guide.index == 2, silently=False)
    press(guided.booth.window, Qt.Key.Key_Backspace)
    assert guide.index == 1
    answer(guided, 1)
    guided.settle()
    assert [take.phoneme for take in guided.takes] == [Phoneme.SILENCE, Phoneme.A]
    assert guided.takes[-1].number == 3


def test_skipped_sounds_are_left_out_and_cancel_keeps_what_was_recorded(guided: Calibrator):
    guide = guided.model.guide
    press(guided.booth.window, Qt.Key.Key_Right)
    assert guide.index == 2
    answer(guided, 2)
    click(guided.page.guide.cancel)
    guided.settle()
    assert not guide.running
    assert guided.page.workbench.isVisible()
    assert [take.phoneme for take in guided.takes] == [Phoneme.SILENCE, Phoneme.E]


def test_escape_ends_the_guide_and_leaves_the_microphone_alone(guided: Calibrator):
    press(guided.booth.window, Qt.Key.Key_Escape)
    assert not guided.model.guide.running
    assert guided.booth.studio.model.active
    press(guided.booth.window, Qt.Key.Key_Escape)  # now it is Stop again
    assert not guided.booth.studio.model.active


def test_r_asks_for_the_same_sound_again_and_records_nothing(guided: Calibrator):
    guide = guided.model.guide
    answer(guided, 1, loud=5.0)
    press(guided.booth.window, Qt.Key.Key_R)
    assert (guide.index, guide.phase, guide.advice) == (1, Phase.WAITING, "")
    assert not guided.booth.studio.model.recording
    guide.cancel()
    press(guided.booth.window, Qt.Key.Key_R)  # now it is Record again
    assert guided.booth.studio.model.recording


def test_beside_the_page_of_the_guide_escape_and_r_are_the_window_s(guided: Calibrator):
    press(guided.booth.window, Qt.Key.Key_1, Qt.KeyboardModifier.ControlModifier)
    press(guided.booth.window, Qt.Key.Key_R)
    assert guided.booth.studio.model.recording
    press(guided.booth.window, Qt.Key.Key_Escape)
    assert not guided.booth.studio.model.active


def test_too_little_to_learn_from_is_said_and_the_takes_stay(guided: Calibrator):
    guide, before = guided.model.guide, guided.booth.desktop.preset.preset
    for _ in range(1, len(STEPS)):
        guide.skip()
    guided.until(lambda: guide.phase is Phase.DONE, silently=False)
    assert guided.page.guide.accept.isHidden() or guide.outcome is None or not guide.outcome.gains
    assert guided.booth.desktop.preset.preset == before
    assert len(guided.takes) == 1


def test_a_voice_begins_after_quiet_and_where_it_stays_loud():
    room = noise(0.5, 0.0006)
    click_ = np.where(np.arange(SAMPLE_RATE // 100) < 100, 0.5, 0).astype(np.float32)
    sound = np.concatenate((tone(300, 0.3, 0.2), room, click_, room, tone(300, 0.5, 0.2)))
    assert onset_in(sound, SAMPLE_RATE, 0.004) == pytest.approx(0.3 + 0.5 + 0.01 + 0.5, abs=0.011)
    assert onset_in(np.tile(room, 4), SAMPLE_RATE, 0.004) is None
    assert onset_in(tone(300, 1.0, 0.2), SAMPLE_RATE, 0.004) is None  # it was there before anybody asked
