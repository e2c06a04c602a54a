"""Choosing a recogniser in the window: the example of a plug-in at work, and what happens when one fails."""

import subprocess
import sys
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, FACTORY, THESIS_PRESET, load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import FILTER_FIELDS, PhonemeData
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, Filter
from tests.desktop.hands import DEMO, click, drag, followed, press, shown, type_number, wait_for_results
from tests.fakes.plug_ins import Shelf, environment_with
from tests.tables import rows_of

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier

FAILS_LATER = """
class Own(Plain):
    def recognise(self, windows, features):
        raise ValueError("no more")
"""
MADE_ONCE = """
made = []

class Own(Plain):
    def __init__(self, thresholds):
        made.append(self)
        if len(made) > 1:
            raise MemoryError("one is all that fits")
"""
UP_TO_ONE = """
class Own(Plain):
    used_thresholds = ("sz_s1",)
    def __init__(self, thresholds):
        if thresholds.sz_s1 > 100:
            raise ValueError("sz_s1 goes up to 100")
"""


def choose(window, name: str) -> None:
    """Choose a recogniser of another package in the list of presets."""
    picker = window.preset_box.list
    window.preset_box.open_list()
    QTest.keyClicks(picker.search, name)
    QTest.keyClick(picker.search, Qt.Key.Key_Return)


def told(window) -> str:
    return window.banner.label.text()


@pytest.fixture
def desktop(desktop):
    yield desktop
    desktop.preset.load(THESIS_PRESET)  # a plug-in that is in use ends with its test


@pytest.fixture
def sentences(session: Session) -> list[str]:
    kept: list[str] = []
    session.error.connect(kept.append)
    return kept


# -- the example --------------------------------------------------------------------------------------------


def test_a_recogniser_that_is_installed_acts_at_once_is_shown_and_tuned_and_undo_takes_it_back(
    loudness, desktop, qtbot
):
    window = followed(desktop, qtbot, DEMO, 3.6)
    window.preset_box.open_list()
    groups = {heading.text(0): lines for heading, lines in window.preset_box.list._groups if heading is not None}
    assert [line.text(1) for line in groups["Recognisers of other packages"]] == ["brightness", "loudness"]
    window.preset_box.list.hide()
    history = desktop.session.history
    mouth = {Phoneme.A, Phoneme.SILENCE}
    newest = history.indices(0, history.n)
    assert set(history.phonemes[newest].tolist()) > mouth
    choose(window, "loudness")
    wait_for_results(desktop, qtbot)
    newest = history.indices(0, history.n)
    assert set(history.phonemes[newest].tolist()) == mouth
    window.redraw.refresh_all()
    assert window.analysis.phoneme.phoneme is Phoneme.A
    assert [c.rule for c in window.analysis.phoneme.trace.comparisons] == ["opens", "stays"]
    assert not window.analysis.phoneme.grab().isNull()
    assert desktop.preset.undo_stack.undoText() == "switch to recogniser loudness"
    assert window.isWindowModified()
    desktop.preset.undo_stack.undo()
    assert desktop.preset.preset.recogniser == "thesis"
    desktop.preset.undo_stack.redo()
    assert desktop.preset.preset.recogniser == "loudness"
    view = window.analysis.thresholds
    expected = {
        "loudness": {"silence_energy", "minimum_hold", *FILTER_FIELDS},
        "learned": {"minimum_hold", "hysteresis", *(f"sensitivity_{p.label}" for p in Phoneme)},
        "thesis": {"minimum_hold", "hysteresis", *(f.name for f in fields(PhonemeData))},
    }
    for name, controls in expected.items():
        desktop.preset.set_recogniser(name)
        window.redraw.refresh_all()
        assert view.rows.keys() == controls
        assert all(row.slider.isEnabled() for row in view.rows.values())
    assert view.rows["silence_energy"].slider.live is not None


def test_a_sensitivity_is_dragged_while_its_live_value_shows(desktop, qtbot):
    window = followed(desktop, qtbot, DEMO, 3.6)
    desktop.preset.set_recogniser("learned")
    wait_for_results(desktop, qtbot)
    desktop.session.analyse_until(3.7)
    window.redraw.refresh_all()
    history = desktop.session.history
    named = Phoneme(int(history.newest.recognised[-1]))
    for phoneme in Phoneme:
        slider = window.analysis.thresholds.rows[f"sensitivity_{phoneme.label}"].slider
        assert (slider.live < slider.value) == (phoneme is named)
    slider = window.analysis.thresholds.rows["sensitivity_m"].slider
    window.analysis.thresholds.ensureWidgetVisible(slider)
    drag(slider, slider.width() / 2, slider.width() - 6)
    assert desktop.preset.preset.sensitivities == {Phoneme.M: 5.0}
    wait_for_results(desktop, qtbot)
    shown_then = history.phonemes[history.indices(0, history.n)]
    assert np.mean(shown_then == Phoneme.M) > 0.2  # the seconds before the cursor are recognised anew
    press(window, Qt.Key.Key_Z, CONTROL)
    assert not desktop.preset.preset.sensitivities


def test_choosing_a_recogniser_takes_its_factory_preset(model):
    model.load(DEFAULT_PRESET)
    for name, path in (("thesis", THESIS_PRESET), ("templates", FACTORY / "templates.toml")):
        model.set_recogniser(name)
        found, factory = model.preset, load_preset(path)
        assert (found.thresholds, found.settings) == (factory.thresholds, factory.settings)
        assert dict(found.successors) == dict(factory.successors)


def test_thresholds_of_one_s_own_come_back_with_their_recogniser(desktop, qtbot, tmp_path):
    window = shown(desktop, qtbot, None)
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "7.25")
    desktop.preset.set_filter(Filter.WINDOW_FUNCTION, True)
    desktop.preset.set_recogniser("learned")
    type_number(window.analysis.thresholds.rows["sensitivity_a"].number, "-1.5")
    desktop.preset.set_recogniser("thesis")
    assert desktop.preset.preset.thresholds.sz_s1 == 7.25
    assert desktop.preset.preset.settings.has(Filter.WINDOW_FUNCTION)
    desktop.preset.set_recogniser("learned")
    assert desktop.preset.preset.sensitivities == {Phoneme.A: -1.5}
    desktop.preset.save(tmp_path / "mine.toml")
    desktop.preset.load(tmp_path / "mine.toml")
    desktop.preset.set_recogniser("thesis")
    assert desktop.preset.preset.thresholds.sz_s1 == 7.25


def test_the_filter_column_says_what_the_recogniser_does_not_use_and_a_strength_that_is_typed_ticks_it(
    desktop, qtbot
):
    filters = shown(desktop, qtbot, None).filters
    assert filters.unused.text() == "Not used by “Thesis”: Mel, Look-ahead"
    assert "does not use it" not in filters.switches["denoise"].toolTip()
    box, field = filters.switches["time_smooth"], filters.fields["time_smooth"]
    assert not box.isChecked()
    click(box)
    assert field.value() > 0
    type_number(field, "0")
    assert not box.isChecked()
    type_number(field, "0.25")
    assert box.isChecked()
    desktop.preset.set_recogniser("learned")
    assert filters.unused.text() == "“Learned” uses the unfiltered signal; filters affect the display only"
    assert "The recogniser “Learned” does not use it" in filters.switches["denoise"].toolTip()


def test_the_course_shows_no_limit_that_the_recogniser_does_not_use(shelf, desktop, qtbot):
    shelf.offer("")
    window = followed(desktop, qtbot)
    assert len(window.analysis.scroll_view._limits) == 1
    choose(window, "own")
    assert window.analysis.scroll_view._limits == {}


def test_analyse_uses_an_installed_recogniser(loudness: Path, tmp_path: Path):
    save_preset(Preset(recogniser="loudness"), tmp_path / "loud.toml")
    command = [sys.executable, "-m", "phonemeanalyser", "analyse", str(DEMO), "--preset", str(tmp_path / "loud.toml")]
    done = subprocess.run(
        command, env=environment_with(loudness), capture_output=True, text=True, timeout=240, check=True
    )
    assert {row["phoneme"] for row in rows_of(done.stdout)} == {"a", "silence"}
    done = subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode != 0
    (line,) = done.stderr.splitlines()
    assert "loud.toml: there is no recogniser named 'loudness'" in line


# -- plug-ins that fail -------------------------------------------------------------------------------------


def test_a_recogniser_that_is_not_there_or_cannot_be_made_leaves_the_one_before_in_use(
    shelf: Shelf, desktop, qtbot, tmp_path
):
    shelf.offer("import nowhere_at_all\nOwn = 1")
    window = shown(desktop, qtbot, None)
    choose(window, "own")
    assert told(window).startswith("the recogniser 'own' of the package own-package cannot be imported")
    path = tmp_path / "theirs.toml"
    save_preset(Preset(name="theirs"), path)
    path.write_text(path.read_text().replace('recogniser = "thesis"', 'recogniser = "theirs"'))
    window.dialogs.presets.load(path)
    assert told(window).startswith("theirs.toml: there is no recogniser named 'theirs'; known are thesis, ")
    assert (desktop.preset.preset.recogniser, desktop.preset.preset.name) == ("thesis", "Thesis")
    assert not window.isWindowModified()
    assert not desktop.preset.undo_stack.canUndo()


@pytest.mark.parametrize("source", [FAILS_LATER, MADE_ONCE], ids=["recognise", "second making"])
def test_a_recogniser_that_fails_while_playing_is_one_sentence_and_another_goes_on(
    source, shelf: Shelf, session: Session, model: PresetModel, sound: Path, sentences, outputs, qtbot
):
    shelf.offer(source)
    session.open(sound)
    ahead, outputs.last.ahead = outputs.last.ahead, SAMPLE_RATE // 4  # leave something to fail at
    session.play()
    model.set_recogniser("own")
    outputs.last.ahead = ahead
    # The player and the analysis of the whole file fail by themselves; either may be the first.
    qtbot.waitUntil(lambda: bool(session.poll() or sentences) and not session.source.playing)
    for _ in range(30):  # as many pictures
        QApplication.processEvents()
        session.poll()
    assert len(sentences) == 1
    assert sentences[0].startswith("the recogniser 'own' of the package own-package cannot")
    assert not session.source.playing
    model.set_recogniser("thesis")
    session.play()
    qtbot.waitUntil(lambda: outputs.last.n_written - outputs.last.heard > 20_000)
    outputs.last.move(20_000)
    assert session.poll()
    assert len(sentences) == 1


def test_a_recogniser_that_cannot_say_why_is_told_once(
    shelf: Shelf, session: Session, model: PresetModel, sound: Path, sentences
):
    shelf.offer("class Own(Plain):\n    def explain(self, features, k):\n        1 / 0")
    model.set_recogniser("own")
    session.open(sound)
    session.analyse_until(0.5)
    assert [session.results.explain() for _ in range(5)] == [None] * 5
    assert len(sentences) == 1
    assert "cannot say why (ZeroDivisionError" in sentences[0]
    assert session.history.n == round(0.5 / FRAME_PERIOD)


def test_one_recogniser_explains_until_the_preset_changes(
    loudness, session: Session, model: PresetModel, sound: Path
):
    model.set_recogniser("loudness")
    session.open(sound)
    session.analyse_until(0.3)
    before = model.recogniser
    session.results.explain()
    model.set_setting("intensity_low", -40.0)
    assert model.recogniser is before
    model.tune("silence_energy", 0.5)
    assert model.recogniser is not before
    trace = session.results.explain()
    assert trace is not None
    assert [c.limit for c in trace.comparisons] == [0.5, 0.25]


def test_a_threshold_that_a_recogniser_does_not_take_is_refused_and_the_old_one_shown(shelf: Shelf, desktop, qtbot):
    shelf.offer(UP_TO_ONE)
    window = shown(desktop, qtbot, None)
    choose(window, "own")
    number = window.analysis.thresholds.rows["sz_s1"].number
    type_number(number, "50")
    type_number(number, "200")
    assert "cannot be made (ValueError: sz_s1 goes up to 100)" in told(window)
    assert number.value() == desktop.preset.preset.thresholds.sz_s1 == 50
    click(window.analysis.thresholds.rows["sz_s1"].reset)
    assert desktop.preset.preset.thresholds.sz_s1 == desktop.preset.saved_value("sz_s1")
