"""The table of the 21 numbers: typed, taken from measured values, fitted, compared; and sets chosen by the pitch."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from phonemeanalyser.desktop.calibrate.workbench.phoneme_data_panel import FIRST, OTHER, VALUE, PhonemeDataPanel
from phonemeanalyser.desktop.session.preset import PresetDocument
from phonemeengine.calibration.workbench.phoneme_data_table import number_rows
from phonemeengine.presets.files import FACTORY, load_preset, save_preset
from tests.desktop.calibrate.calibrating import CONTROL, Calibrator, corpus
from tests.desktop.hands import LEFT, FileAnswers, click, press
from tests.desktop.studio import Booth
from tests.fakes.microphones import HandDrivenMicrophone


@pytest.fixture
def calibrator(open_booth: Callable[..., Booth], mic: HandDrivenMicrophone) -> Calibrator:
    found = Calibrator(open_booth(mic), mic)
    found.booth.desktop.preset.load(FACTORY / "thesis.toml")
    found.page.workbench.upper.setCurrentIndex(1)
    return found


@pytest.fixture
def loaded(calibrator: Calibrator, tmp_path: Path) -> Calibrator:
    """Two speakers' recordings are loaded."""
    calibrator.model.recordings.load([corpus(tmp_path / "corpus")])
    settle(calibrator)
    return calibrator


def settle(calibrator: Calibrator) -> None:
    calibrator.settle()
    model = calibrator.model.phoneme_data
    calibrator.until(lambda: not model.measuring.busy and not model.fitting.busy)
    calibrator.settle()


def panel_of(calibrator: Calibrator) -> PhonemeDataPanel:
    return calibrator.page.workbench.phoneme_data


def line_of(calibrator: Calibrator, name: str) -> int:
    table = panel_of(calibrator).table
    return next(k for k in range(table.rowCount()) if table.verticalHeaderItem(k).text() == name)


def text(calibrator: Calibrator, name: str, column: int, side: int = 0) -> str:
    return panel_of(calibrator).table.item(line_of(calibrator, name) + side, column).text()


def number(calibrator: Calibrator, name: str) -> float:
    return getattr(calibrator.booth.desktop.preset.preset.phoneme_data, name)


def test_the_table_shows_what_the_engine_measures_for_each_speaker_and_a_click_takes_a_value(
    loaded: Calibrator,
) -> None:
    table, before, compare = panel_of(loaded).table, number(loaded, "szsch_szsch1"), loaded.page.workbench.compare
    heads = [table.horizontalHeaderItem(k).text().replace("\n", " ") for k in range(FIRST, table.columnCount())]
    assert heads == [f"{who} {part}" for who in ("all", "ann", "bob") for part in ("min", "mean", "max")]
    rows = {row.name: row for row in number_rows(loaded.model.workbench.features)}
    bob = rows["szsch_szsch1"].by_speaker["bob"]
    for side, found in enumerate((bob.holds, bob.fails)):
        shown = [text(loaded, "szsch_szsch1", FIRST + 6 + k, side) for k in range(3)]
        assert shown == [f"{value:.4g}" for value in (found.least, found.mean, found.greatest)]
    assert text(loaded, "a_a1", FIRST, side=1) == "–"  # no recording has an e
    line = line_of(loaded, "szsch_szsch1")
    table.scrollToItem(table.item(line, FIRST))
    QTest.mouseClick(table.viewport(), LEFT, pos=table.visualItemRect(table.item(line, FIRST)).center())
    assert number(loaded, "szsch_szsch1") == float(text(loaded, "szsch_szsch1", FIRST)) != before
    press(loaded.booth.window, Qt.Key.Key_Z, CONTROL)
    assert number(loaded, "szsch_szsch1") == before
    table.setCurrentCell(line, FIRST + 2)
    QTest.keyClick(table, Qt.Key.Key_Return)
    assert number(loaded, "szsch_szsch1") == float(text(loaded, "szsch_szsch1", FIRST + 2))
    assert table.isColumnHidden(OTHER)
    loaded.booth.desktop.preset.set_other(PresetDocument.read(FACTORY / "thesis-calm.toml"))
    settle(loaded)
    loaded.until(lambda: loaded.model.comparison.result is not None)
    other = load_preset(FACTORY / "thesis-calm.toml").phoneme_data
    assert text(loaded, "time_smooth", OTHER) == f"{other.time_smooth:.4g}"
    counts = loaded.model.comparison.result.changed
    assert compare.changes.item(0, 1).text() == str(counts[0].sum())
    assert compare.changes.item(0, 2).text() == str(counts[:, 0].sum())


def test_a_number_is_typed_without_labels_too_and_what_is_none_is_refused(calibrator: Calibrator) -> None:
    panel, table, said = panel_of(calibrator), panel_of(calibrator).table, list[str]()
    calibrator.model.error.connect(said.append)
    assert panel.state.text() == "Record takes or load labelled recordings first."
    assert not panel.fit_all.isEnabled()
    assert panel.add.isEnabled()  # a file needs no labels
    table.item(line_of(calibrator, "sz_s1"), VALUE).setText("12,5")
    assert number(calibrator, "sz_s1") == 12.5
    table.item(line_of(calibrator, "sz_s1"), VALUE).setText("much")
    assert number(calibrator, "sz_s1") == 12.5
    assert text(calibrator, "sz_s1", VALUE) == "12.5"
    table.item(line_of(calibrator, "time_smooth"), VALUE).setText("7")
    assert number(calibrator, "time_smooth") == 0
    assert [sentence.split()[0] for sentence in said] == ["sz_s1", "time_smooth"]
    table.setFocus()
    table.setCurrentCell(line_of(calibrator, "sz_s1") + 1, VALUE)  # the lower of its two lines
    press(table, Qt.Key.Key_Return)
    QTest.keyClicks(QApplication.focusWidget(), "9.5")
    press(QApplication.focusWidget(), Qt.Key.Key_Return)
    QApplication.processEvents()  # Qt commits what was typed a moment later
    assert number(calibrator, "sz_s1") == 9.5
    calibrator.booth.desktop.preset.load(FACTORY / "extended.toml")
    assert not panel.add.isEnabled()


def test_one_number_is_fitted_and_all_are_each_in_one_step_of_undo(loaded: Calibrator) -> None:
    panel, preset = panel_of(loaded), loaded.booth.desktop.preset
    loaded.model.phoneme_data.set_number("silence_energy", 0.0)
    spoilt = preset.preset
    panel.table.setCurrentCell(line_of(loaded, "silence_energy"), VALUE)
    click(panel.fit_row)
    settle(loaded)
    assert number(loaded, "silence_energy") > 0
    assert "Macro F1 on what is loaded: " in panel.state.text()
    press(loaded.booth.window, Qt.Key.Key_Z, CONTROL)
    assert preset.preset == spoilt
    click(panel.fit_all)
    settle(loaded)
    assert preset.preset.thresholds != spoilt.thresholds
    assert preset.preset.successors == spoilt.successors  # which no PhonemeData file holds
    press(loaded.booth.window, Qt.Key.Key_Z, CONTROL)
    assert preset.preset == spoilt


def test_a_set_is_added_for_a_speaker_edited_and_removed(loaded: Calibrator) -> None:
    panel, model, preset = panel_of(loaded), loaded.model.phoneme_data, loaded.booth.desktop.preset
    own = preset.preset
    panel.add.menu().aboutToShow.emit()
    assert [action.text() for action in panel.add.menu().actions()] == ["ann", "bob", "Numbers of a File…"]
    panel.add.menu().actions()[1].trigger()
    settle(loaded)
    (bob,) = preset.preset.pitch_sets
    assert (bob.name, bob.low < 200 < bob.high) == ("bob", True)
    assert preset.preset.thresholds == own.thresholds
    assert (panel.sets.currentText(), panel.low.value(), panel.high.value()) == ("bob", bob.low, bob.high)
    panel.table.item(line_of(loaded, "sz_s1"), VALUE).setText("3")
    assert preset.preset.pitch_sets[0].data.sz_s1 == 3
    assert preset.preset.thresholds == own.thresholds
    preset.set_recogniser("templates")
    model.set_number("sz_s1", 4.0)  # another recogniser does not use the set, and the other numbers in it stay
    assert preset.preset.pitch_sets[0].data == replace(bob.data, sz_s1=4.0)
    preset.set_recogniser("thesis")
    panel.high.setValue(300)
    panel.high.editingFinished.emit()
    assert preset.preset.pitch_sets[0].high == 300
    said = []
    loaded.model.error.connect(said.append)
    panel.high.setValue(bob.low)
    panel.high.editingFinished.emit()
    assert "must range upwards" in said[0]
    assert panel.high.value() == preset.preset.pitch_sets[0].high == 300
    assert "until the pitch of the voice is known" in model.in_use()
    click(panel.remove)
    assert (preset.preset.pitch_sets, preset.preset.thresholds) == ((), own.thresholds)
    assert model.in_use() == ""
    press(loaded.booth.window, Qt.Key.Key_Z, CONTROL)
    assert len(preset.preset.pitch_sets) == 1


def test_a_file_becomes_a_set_and_a_bad_one_is_refused(calibrator: Calibrator, tmp_path: Path) -> None:
    preset, said = calibrator.booth.desktop.preset, []
    calibrator.model.error.connect(said.append)
    save_preset(load_preset(FACTORY / "thesis-calm.toml"), tmp_path / "child.phonemedata")
    (tmp_path / "bad.phonemedata").write_text("1, 2, many")
    panel = panel_of(calibrator)
    panel.add.menu().aboutToShow.emit()
    for name in ("child", "bad"):
        calibrator.booth.window.files.show = FileAnswers(tmp_path / f"{name}.phonemedata")
        panel.add.menu().actions()[-1].trigger()
    (child,) = preset.preset.pitch_sets
    assert (child.name, child.low, child.high) == ("child", 60, 500)
    assert child.data == load_preset(tmp_path / "child.phonemedata").phoneme_data
    assert said[0].startswith("bad.phonemedata: line 1: ")
