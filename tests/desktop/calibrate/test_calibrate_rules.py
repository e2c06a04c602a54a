"""The tab *Rules* of the calibration: rules found in recordings, shown, applied or discarded."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from phonemeengine.calibration.fits.rule_search import conditions_in
from phonemeengine.features.variables import BUILT_IN_NAMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import rule_lines
from tests.desktop.calibrate.calibrating import CONTROL, Calibrator, corpus
from tests.desktop.hands import click, press
from tests.desktop.studio import Booth, choose
from tests.fakes.microphones import HandDrivenMicrophone

RULES = 2
"""The number of the tab."""


@pytest.fixture
def calibrator(open_booth: Callable[..., Booth], mic: HandDrivenMicrophone) -> Calibrator:
    return Calibrator(open_booth(mic), mic)


@pytest.fixture
def loaded(calibrator: Calibrator, tmp_path: Path) -> Calibrator:
    """Two speakers' recordings are loaded."""
    calibrator.model.recordings.load([corpus(tmp_path / "corpus")])
    calibrator.settle()
    return calibrator


def test_rules_are_found_shown_applied_and_undone_unless_the_search_is_stopped(
    calibrator: Calibrator, tmp_path: Path
):
    panel, preset, finding = (
        calibrator.page.workbench.rules,
        calibrator.booth.desktop.preset,
        calibrator.model.rule_finding,
    )
    assert not panel.begin.isEnabled()
    assert panel.words.text() == "Record takes or load labelled recordings first."
    calibrator.model.recordings.load([corpus(tmp_path / "corpus")])
    calibrator.settle()
    before = preset.preset
    calibrator.page.workbench.tabs.setCurrentIndex(RULES)
    panel.conditions.setValue(6)
    click(panel.begin, 10)
    click(panel.stop, 10)
    calibrator.settle()
    assert finding.report is None
    assert preset.preset == before
    click(panel.begin, 10)
    assert panel.stop.isVisibleTo(panel)
    calibrator.until(lambda: not finding.searching.busy)
    report = finding.report
    assert report is not None
    n = conditions_in(report.preset.rules)
    assert 1 <= n <= 6
    assert f"Rules: {len(report.preset.rules)}, conditions: {n}." in panel.words.text()
    assert panel.rules.toPlainText().splitlines() == rule_lines(report.preset)
    scores = report.before, report.after, report.held_out
    assert [panel.figures.item(0, k).text() for k in range(3)] == [f"{s.macro_f1:.1%}" for s in scores]
    assert report.after.macro_f1 > report.before.macro_f1
    assert preset.preset == before
    click(panel.accept, 10)
    calibrator.settle()
    assert (preset.preset.recogniser, preset.preset.rules) == ("rules", report.preset.rules)
    assert calibrator.model.workbench.confusion.agreement.macro_f1 == pytest.approx(report.after.macro_f1)
    assert not panel.rules.isVisibleTo(panel)
    press(calibrator.booth.window, Qt.Key.Key_Z, CONTROL)
    assert preset.preset == before


def test_rules_of_the_preset_s_variables_ask_for_nothing_else_and_are_discarded(loaded: Calibrator):
    panel, before = loaded.page.workbench.rules, loaded.booth.desktop.preset.preset
    loaded.page.workbench.tabs.setCurrentIndex(RULES)
    choose(panel.variables, "Variables of the preset")
    click(panel.begin, 10)
    loaded.until(lambda: not loaded.model.rule_finding.searching.busy)
    report = loaded.model.rule_finding.report
    assert report is not None
    asked = {condition.variable for rule in report.preset.rules for condition in rule.conditions}
    assert asked <= {*BUILT_IN_NAMES, *(v.name for v in before.variables)}
    assert panel.figures.isVisibleTo(panel)
    preset = loaded.booth.desktop.preset
    preset.set_other(preset.document)
    assert loaded.model.rule_finding.report is report  # a B beside it changes nothing
    preset.switch()
    assert loaded.model.rule_finding.report is None
    assert not panel.figures.isVisibleTo(panel)
    preset.switch()
    preset.set_other(None)
    loaded.model.rule_finding.report = report
    click(panel.refuse, 10)
    assert preset.preset == before
    assert not panel.figures.isVisibleTo(panel)


def test_a_new_rule_is_proposed_for_the_phoneme_of_the_pair_with_the_higher_values(loaded: Calibrator):
    panel, model = loaded.page.workbench.variables, loaded.model.workbench
    asked: list[tuple[str, Phoneme]] = []
    panel.use_asked.disconnect()
    panel.use_asked.connect(lambda *what: asked.append((what[0], what[1])))
    for variable, one, other in (("zero_crossings", "a", "s"), ("zero_crossings", "s", "a"), ("volume", "s", "a")):
        model.choose(variable)
        loaded.settle()
        choose(panel.one, one)
        choose(panel.other, other)
        click(panel.use)
    choose(panel.one, "sh")  # of which nothing is loaded
    choose(panel.other, "all others")
    click(panel.use)
    told = [(variable, phoneme.label) for variable, phoneme in asked]
    assert told == [*[("zero_crossings", "sz")] * 2, ("volume", "a"), ("volume", "sch")]
