"""The guided calibration: it hears a person out, says what to repeat, and gives a preset that knows the voice."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import Qt

from phonemeanalyser.cli.main import main
from phonemeanalyser.desktop.calibrate.guide.guide_model import QUIET, SOUNDS, Phase
from phonemeengine.calibration.calibrate import CalibrationResult, calibrate, loss_of
from phonemeengine.calibration.scores.comparison import Gain, Gains
from phonemeengine.calibration.scores.corpus import LabelledUtterance, read_recordings
from phonemeengine.calibration.takes.sentences import LANGUAGES, SENTENCES, onset_in
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.calibrate.calibrating import Calibrator, in_room, said
from tests.desktop.hands import FileAnswers, click, press
from tests.desktop.studio import Booth
from tests.fakes.microphones import HandDrivenMicrophone
from tests.reading import english_read
from tests.sounds import noise, silence, tone

Open = Callable[..., Booth]
STEPS = (QUIET, *SOUNDS)
READING = len(STEPS)
"""The number of the step after the single sounds: the sentence to judge by."""
SPEAKING = np.concatenate((silence(0.5), tone(440, 0.4, 0.3), silence(1.6)))


@pytest.fixture
def guided(open_booth: Open, mic: HandDrivenMicrophone) -> Calibrator:
    """Somebody who has been heard being quiet, and is asked for the first sound."""
    calibrator = Calibrator(open_booth(mic), mic)
    press(calibrator.booth.window, Qt.Key.Key_G)
    press(calibrator.booth.window, Qt.Key.Key_Return)
    calibrator.until(lambda: calibrator.model.guide.index == 1, silently=False)
    return calibrator


@pytest.fixture
def by_sounds(guided: Calibrator) -> Calibrator:
    """Somebody who says single sounds, in place of the sentence to learn from."""
    click(guided.page.guide.sounds)
    return guided


def give(calibrator: Calibrator, sound: np.ndarray) -> None:
    calibrator.booth.give(calibrator.mic, in_room(sound))


def answer(calibrator: Calibrator, k: int, *, loud: float = 1.0) -> None:
    """Say the sound of a step when it is asked for, and wait until it was judged."""
    guide = calibrator.model.guide
    calibrator.until(lambda: (guide.index, guide.phase) == (k, Phase.WAITING), silently=False)
    give(calibrator, silence(0.2))
    give(calibrator, np.clip(loud * said(STEPS[k].phoneme, 1.8), -1, 1))
    calibrator.until(lambda: guide.phase is Phase.SHOWING, silently=False)


def read_aloud(calibrator: Calibrator, sound: np.ndarray, k: int = READING) -> None:
    """Read a sentence when it is asked for, and wait until it was judged."""
    guide = calibrator.model.guide
    calibrator.until(lambda: (guide.index, guide.phase) == (k, Phase.WAITING), silently=False)
    give(calibrator, silence(0.7))
    give(calibrator, sound)
    calibrator.until(lambda: guide.phase is Phase.SHOWING, silently=False)


@pytest.mark.parametrize("n_said", [4, pytest.param(len(SOUNDS), marks=pytest.mark.long)])
def test_who_follows_gets_a_better_preset_for_his_voice_and_undo_brings_the_old_one_back(
    by_sounds: Calibrator, n_said: int
):
    guide, preset, view = by_sounds.model.guide, by_sounds.booth.desktop.preset, by_sounds.page.guide
    before = preset.preset
    n_given = by_sounds.booth.studio.given[by_sounds.mic]
    for k in range(1, 1 + n_said):
        answer(by_sounds, k)
        assert guide.advice == "", STEPS[k].say
    by_sounds.until(lambda: guide.index == 1 + n_said, silently=False)
    while not guide.reading:
        guide.skip()
    asked = (by_sounds.booth.studio.given[by_sounds.mic] - n_given) / SAMPLE_RATE
    assert asked + 2 < 60  # in under a minute
    guide.skip()
    by_sounds.until(lambda: guide.phase is Phase.DONE, silently=False)
    assert [take.phoneme for take in by_sounds.takes] == [step.phoneme for step in STEPS[: 1 + n_said]]
    outcome = guide.outcome
    assert outcome is not None
    assert outcome.after.macro_f1 > outcome.before.macro_f1
    clear, unclear = (Gain(0.05, low, 0.1) for low in (0.01, -0.01))
    for gain, title in ((clear, "Your voice is now recognised better"), (unclear, "No clear change")):
        is_clear = gain is clear
        guide.outcome = replace(outcome, gained=Gains(gain, gain))
        guide.changed.emit()
        assert title in view.title.text()
        assert ("may be due to chance" in view.hint.text()) is not is_clear
        item = view.figures.item(0, 2)
        assert item.text().endswith(f" ±{5 - 100 * gain.low:.1f}")
        assert item.toolTip().endswith(f"{100 * gain.low:+.1f} to +10.0")
    guide.outcome = replace(outcome, preset=outcome.start)
    guide.changed.emit()
    assert view.figures.columnCount() == 1  # of the old preset, where nothing was gained
    guide.outcome = outcome
    guide.changed.emit()
    assert view.figures.item(0, 1).text() == f"{outcome.after.macro_f1:.1%}"
    seconds = sum(take.end - take.start for take in by_sounds.takes)
    for told in (
        f"Learned from: {n_said} single sounds, background noise ({seconds:.1f} s).",
        "each quarter of your recordings",
        "Background noise recognised as silence: ",
        "The new preset is not saved yet",
    ):
        assert told in view.hint.text()
    assert view.head.isHidden()  # nothing was read that it could say
    assert preset.preset == before
    click(view.accept)
    assert preset.preset.thresholds == outcome.preset.thresholds != before.thresholds
    assert not guide.running
    assert by_sounds.booth.banner == "The calibrated preset is in use but not saved yet."
    assert by_sounds.booth.window.banner.action.text() == "Save As…"
    press(by_sounds.booth.window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert preset.preset == before


@pytest.mark.parametrize("recogniser", ["templates", pytest.param("learned", marks=pytest.mark.long)])
def test_one_sentence_that_is_read_teaches_the_voice_and_the_head_says_it_with_the_old_and_the_new_preset(
    guided: Calibrator, recogniser: str, tmp_path: Path
):
    guide, preset, view = guided.model.guide, guided.booth.desktop.preset, guided.page.guide
    preset.load(DEFAULT_PRESET)
    preset.set_recogniser(recogniser)
    before = preset.preset
    better = load_preset(DEFAULT_PRESET)  # in place of what the takes give: this model recognises the voice better
    alone = "x.onnx: is no real-time model; until then the small network recognises live sound, and it alone learned."
    learned_from: list[LabelledUtterance] = []

    def learn(preset: Preset, takes: Sequence[LabelledUtterance], **given: Any) -> CalibrationResult:
        learned_from.extend(takes)
        return replace(calibrate(preset, takes, **given), preset=better, warning=alone)

    guide.learn = learn
    assert "Read aloud in your normal voice" in view.title.text()
    assert SENTENCES[0].text in view.hint.text()
    read_aloud(guided, noise(4.0, 0.1), 1)
    assert "this sentence; read" in guide.advice
    read_aloud(guided, english_read()[0], 1)
    guided.until(lambda: guide.index == 2, silently=False)
    assert "Now read this test sentence" in view.title.text()
    assert SENTENCES[1].text in view.hint.text()
    guide.skip()
    guided.until(lambda: guide.phase is Phase.DONE, silently=False)
    outcome, spoken = guide.outcome, guide.spoken
    assert outcome.cross_validated
    assert "Learned from: one sentence, background noise (" in view.hint.text()
    assert "each quarter of your recordings" in view.hint.text()
    assert outcome.after.macro_f1 >= outcome.before.macro_f1
    assert loss_of(outcome.before, outcome.after) == ""
    folder = guided.model.takes.folder
    assert spoken.path == folder / "read" / "me" / "english-1.flac"
    assert [take.phoneme for take in guided.takes] == [Phoneme.SILENCE]
    # the command `adapt` learns from the same: the test below compares what it makes of that
    again = (*read_recordings(folder), *read_recordings(spoken.path))
    assert [(u.path, u.labels) for u in learned_from] == [(u.path, u.labels) for u in again]
    assert view.head.isVisibleTo(view)
    assert alone in view.advice.text()
    session, heard = guided.booth.desktop.session, list[object]()
    session.analysed.connect(heard.extend)
    for button, expected in ((view.play_old, before), (view.play_new, better)):
        click(button)
        assert session.path == spoken.path
        assert session.source.playing
        assert preset.in_force == expected
        assert preset.preset == before  # hearing it changes nothing
        heard.clear()
        guided.until(lambda: len(heard) > 2)
    assert guided.booth.desktop.talking.watched  # the head follows it
    saved = tmp_path / "mine.toml"
    guided.booth.window.files.show = FileAnswers(saved)
    click(view.save)
    assert not guide.running
    assert preset.path == saved
    assert load_preset(saved).recogniser == "learned"
    assert preset.in_force == preset.preset


@pytest.mark.parametrize(
    ("recogniser", "others"),
    [
        pytest.param("templates", (), marks=pytest.mark.long),
        pytest.param("learned", ("templates", "brightness"), marks=pytest.mark.long),
    ],
)
def test_window_api_and_command_line_make_the_same_of_a_voice(
    request: pytest.FixtureRequest, by_sounds: Calibrator, tmp_path: Path, recogniser: str, others: tuple[str, ...]
):
    if "brightness" in others:
        request.getfixturevalue("brightness")
    guide, preset = by_sounds.model.guide, by_sounds.booth.desktop.preset
    preset.set_recogniser(recogniser)
    for k in range(1, 5):
        answer(by_sounds, k)
    while guide.index < READING:
        guide.skip()
    read_aloud(by_sounds, english_read()[0])
    by_sounds.until(lambda: guide.phase is Phase.DONE, silently=False)
    outcome, spoken, folder = guide.outcome, guide.spoken, by_sounds.model.takes.folder
    assert outcome is not None
    assert spoken is not None
    assert folder is not None
    # the sentence is no take, teaches nothing, and tells what was gained
    assert spoken in by_sounds.model.workbench.utterances
    assert len(by_sounds.takes) == 5
    assert not outcome.cross_validated
    hint = by_sounds.page.guide.hint.text()
    assert "Measured on the test sentence only (" in hint
    assert " s), whose labels were aligned with its known text." in hint
    takes, held_out = read_recordings(folder), read_recordings(spoken.path)
    for name in (recogniser, *others):  # rules are compared in test_calibrate_learning
        start, mine = tmp_path / "start.toml", tmp_path / f"{name}.toml"
        preset.set_recogniser(name)
        save_preset(preset.preset, start)
        found = outcome if name == recogniser else calibrate(preset.preset, takes, held_out=held_out)
        assert loss_of(found.before, found.after) == ""
        words = ["adapt", str(folder), "--preset", str(start), "--held-out", str(spoken.path), "-o", str(mine)]
        assert main(words) == 0
        assert replace(load_preset(mine), name="", notes="") == replace(found.preset, name="", notes="")
    preset.set_recogniser(recogniser)  # the package of another one ends with this test


def test_the_room_is_measured_outside_the_guide_for_every_recogniser_unless_somebody_speaks(open_booth: Open, mic):
    calibrator = Calibrator(open_booth(mic), mic)
    preset = calibrator.booth.desktop.preset
    preset.load(DEFAULT_PRESET)
    before, told, failed = preset.preset, list[str](), list[str]()
    calibrator.model.info.connect(told.append)
    calibrator.model.error.connect(failed.append)
    click(calibrator.page.takes.room)
    calibrator.until(lambda: calibrator.booth.studio.model.listening, silently=False)
    give(calibrator, SPEAKING)
    calibrator.until(lambda: failed, silently=False)
    assert "keep quiet and measure it again" in failed[0]
    assert preset.preset == before
    told.clear()
    click(calibrator.page.takes.room)
    calibrator.until(lambda: len(told) == 2, silently=False)
    assert told[0].startswith("Keep quiet")
    assert told[1].startswith("Background noise -6")
    assert " % (" in told[1]
    assert "Background noise recognised as silence: " in told[1]
    assert preset.preset.settings.denoise_threshold > before.settings.denoise_threshold
    press(calibrator.booth.window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert preset.preset == before


def test_a_clipped_sound_is_asked_for_again_and_sounds_are_said_once_more_or_skipped_by_keys(guided: Calibrator):
    guide, view, window = guided.model.guide, guided.page.guide, guided.booth.window
    recording = guided.booth.studio.model
    click(view.sounds)
    assert view.sounds.isChecked()
    assert (guide.step, guide.index) == (SOUNDS[0], 1)
    assert f"Sound 1 of {len(SOUNDS)}" in view.title.text()
    for _ in range(2):  # it is asked for once more, and R does not wait for that
        answer(guided, 1, loud=5.0)
        assert "The recording is clipped: " in view.advice.text()
        assert all(take.phoneme is not Phoneme.A for take in guided.takes)
    press(window, Qt.Key.Key_R)
    assert (guide.index, guide.phase, guide.advice) == (1, Phase.WAITING, "")
    assert not recording.recording
    answer(guided, 1)
    assert guide.advice == ""
    guided.until(lambda: guide.index == 2, silently=False)
    before = guided.takes[-1].number
    press(window, Qt.Key.Key_Backspace)
    assert guide.index == 1
    answer(guided, 1)
    guided.settle()
    assert [take.phoneme for take in guided.takes] == [Phoneme.SILENCE, Phoneme.A]
    assert guided.takes[-1].number == before + 1
    guided.until(lambda: guide.index == 2, silently=False)
    press(window, Qt.Key.Key_Right)
    assert guide.index == 3
    while guide.index < READING:  # the sentence to judge by
        guide.skip()
    assert guide.reading
    for language in (1, 0):
        view.language.activated.emit(language)
        assert view.hint.text().count(SENTENCES[2 * language].text) == 1
    click(view.sounds)  # the sentence to learn from comes back
    assert guide.index == 1
    assert guide.step.sentence == SENTENCES[0]
    assert guide.numbers.keys() <= {0}
    view.language.activated.emit(2)
    assert "Papa a mis la soupe" in view.hint.text()
    click(view.cancel)
    press(window, Qt.Key.Key_R)  # Record is a key of the page Analyse
    assert not recording.recording


def test_who_says_nothing_is_asked_again_and_escape_ends_the_guide_without_a_take_of_the_room(guided: Calibrator):
    guide, microphone, window = guided.model.guide, guided.booth.studio.model, guided.booth.window
    guided.until(lambda: guide.advice, silently=False)
    assert "No voice was detected" in guide.advice
    assert (guide.index, guide.phase) == (1, Phase.WAITING)
    guided.settle()
    assert [take.phoneme for take in guided.takes] == [Phoneme.SILENCE]
    press(window, Qt.Key.Key_Escape)
    guided.settle()
    assert guided.takes == ()
    assert not guide.running
    assert microphone.active
    press(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    guided.settle()
    assert [take.phoneme for take in guided.takes] == [Phoneme.SILENCE]
    press(window, Qt.Key.Key_Escape)  # now it is Stop again
    assert not microphone.active


def test_too_little_to_learn_from_is_said_and_beside_its_page_the_guide_has_no_keys(by_sounds: Calibrator):
    guide, before = by_sounds.model.guide, by_sounds.booth.desktop.preset.preset
    window, microphone = by_sounds.booth.window, by_sounds.booth.studio.model
    for _ in range(1, len(STEPS) + 1):
        guide.skip()
    by_sounds.until(lambda: guide.phase is Phase.DONE, silently=False)
    gains = guide.outcome is not None and guide.outcome.gains  # by silence alone, on some machines
    assert by_sounds.page.guide.accept.isHidden() is not gains
    assert by_sounds.booth.desktop.preset.preset == before
    assert len(by_sounds.takes) == 1
    press(window, Qt.Key.Key_1, Qt.KeyboardModifier.ControlModifier)
    press(window, Qt.Key.Key_R)
    assert microphone.recording
    press(window, Qt.Key.Key_Escape)
    assert not microphone.active
    assert guide.running


def test_the_room_is_measured_after_start_and_a_countdown_and_again_where_it_is_not_quiet(open_booth: Open, mic):
    calibrator = Calibrator(open_booth(mic), mic)
    guide, view = calibrator.model.guide, calibrator.page.guide
    click(calibrator.page.takes.guide)
    calibrator.until(lambda: calibrator.booth.studio.model.listening, silently=False)
    calibrator.until(lambda: calibrator.booth.desktop.session.source.position > 3.0, silently=False)
    assert guide.phase is Phase.READY
    calibrator.until(lambda: "Nothing is recorded until you press Start" in view.hint.text())
    click(view.start)
    assert guide.phase is Phase.COUNTING
    give(calibrator, tone(440, 1.0, 0.3))  # the rest of a word, or a key, which is not the room
    calibrator.until(lambda: guide.phase is Phase.RECORDING, silently=False)
    give(calibrator, SPEAKING)
    calibrator.until(lambda: guide.phase is Phase.SHOWING, silently=False)
    assert "quiet" in guide.advice
    assert guide.room is None
    calibrator.until(lambda: guide.index == 1, silently=False)
    assert guide.room is not None
    assert 20 * np.log10(guide.room.level) == pytest.approx(20 * np.log10(0.0006), abs=1)


@pytest.mark.usefixtures("open_own_booth")
def test_a_german_window_offers_german_lines_until_another_language_is_chosen(open_booth: Open, mic):
    calibrator = Calibrator(open_booth(mic), mic)
    calibrator.booth.desktop.set_language("de")
    guide = calibrator.model.guide
    calibrator.model.begin_guide()
    calibrator.booth.window.show_page(1)
    assert guide.steps[1].sentence.language == "German"
    assert calibrator.page.guide.language.currentIndex() == LANGUAGES.index("German")
    guide.choose("Italian", by_sounds=False)
    guide.cancel()
    guide.begin()
    assert guide.steps[1].sentence.language == "Italian"


def test_a_voice_begins_after_quiet_and_where_it_stays_loud():
    room = noise(0.5, 0.0006)
    click_ = np.where(np.arange(SAMPLE_RATE // 100) < 100, 0.5, 0).astype(np.float32)
    sound = np.concatenate((tone(300, 0.3, 0.2), room, click_, room, tone(300, 0.5, 0.2)))
    assert onset_in(sound, SAMPLE_RATE, 0.004) == pytest.approx(0.3 + 0.5 + 0.01 + 0.5, abs=0.011)
    assert onset_in(np.tile(room, 4), SAMPLE_RATE, 0.004) is None
    assert onset_in(tone(300, 1.0, 0.2), SAMPLE_RATE, 0.004) is None  # it was there before anybody asked
