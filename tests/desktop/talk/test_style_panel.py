"""Styles on the page of the head: the face speaks in them at once, and edits are kept, saved and renamed."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.talk.expression.style_model import StyleModel
from phonemeanalyser.desktop.talk.expression.style_panel import StylePanel
from phonemeanalyser.desktop.theme import LIGHT
from phonemeengine.mouth.style import load_style
from tests.desktop.stage import Stage


@pytest.fixture
def panel(stage: Stage, qtbot: QtBot) -> StylePanel:
    panel = StylePanel(stage.talking.styles, LIGHT)
    qtbot.addWidget(panel)
    return panel


def choose(panel: StylePanel, side: str, name: str) -> None:
    box = panel.lists[side]
    box.setCurrentIndex(box.findData(name))
    box.activated.emit(box.currentIndex())


def write(panel: StylePanel, part: str, row: int, column: int, words: str) -> None:
    panel.part.setCurrentIndex(panel.part.findData(part))
    item = panel.table.item(row, column)
    assert item is not None
    item.setText(words)


def test_the_head_changes_in_the_next_picture_while_it_speaks(stage: Stage, panel: StylePanel) -> None:
    stage.play(0.95)
    jaw = stage.jaw
    analysed = stage.talking.session.history.n
    panel.sliders["mumbling"].setValue(100)
    stage.talking.tick()
    assert 0 < stage.jaw < 0.6 * jaw
    assert stage.talking.session.history.n == analysed
    assert stage.talking.in_use.options.style.mumbling == 1


def test_a_blend_is_between_two_styles_of_which_either_is_edited(panel: StylePanel, stage: Stage) -> None:
    styles = stage.talking.styles
    choose(panel, "B", "theatrical")
    assert (styles.side, panel.sliders["theatrical"].value()) == ("B", 80)
    panel.blend.setValue(50)
    assert styles.style.theatrical == pytest.approx(0.4)
    panel.edits["A"].click()
    panel.sliders["asymmetry"].setValue(100)
    assert styles.style.asymmetry == pytest.approx((1 + 0.15) / 2)
    assert panel.lists["A"].currentText() == "Neutral *"
    panel.revert.click()
    assert styles.of_side("A") == load_style("neutral")
    choose(panel, "B", "")
    assert styles.style == load_style("neutral")


def test_edits_are_undone_a_drag_at_a_time(panel: StylePanel, stage: Stage) -> None:
    styles, undo = stage.talking.styles, stage.session.preset.undo_stack
    slider = panel.sliders["mumbling"]
    for values in ((10, 30), (50, 70)):
        slider.sliderPressed.emit()
        for value in values:
            slider.setValue(value)
    write(panel, "gestures", 1, 1, "4")
    assert (undo.count(), undo.undoText()) == (3, "change of the style neutral")
    panel.revert.click()
    assert styles.style == load_style("neutral")
    undo.undo()
    assert (styles.style.gestures.nod, slider.value()) == (4, 70)
    undo.undo()
    undo.undo()
    assert (slider.value(), styles.style.mumbling) == (30, 0.3)
    undo.redo()
    assert slider.value() == 70
    choose(panel, "A", "theatrical")
    undo.undo()  # the style is on no side any more
    assert styles.style == load_style("theatrical")


def test_poses_and_numbers_are_edited_in_the_table(panel: StylePanel, stage: Stage, qtbot: QtBot) -> None:
    styles = stage.talking.styles
    write(panel, "closures", 0, 2, "1,5")
    write(panel, "closures", 1, 4, "jawOpen 9, mouthPress 20")
    write(panel, "gestures", 1, 1, "4")
    write(panel, "reductions", 0, 1, "0.7")
    closures = styles.style.closures
    assert closures.phones["p"].width == 1.5
    assert closures.shapes[closures.phones["b"].shape]["mouthPressRight"] == 20
    assert (styles.style.gestures.nod, styles.style.reductions) == (4, {"eyeBlinkLeft": 0.7})
    panel.part.setCurrentIndex(panel.part.findData("closures"))
    firm = panel.table.item(0, 3)
    assert firm is not None
    firm.setCheckState(Qt.CheckState.Unchecked)
    assert not styles.style.closures.phones["p"].firm
    for part, words, told in (("movement", "9", "reach must lie in 0..2"), ("gestures", "much", "write a number")):
        with qtbot.waitSignal(styles.error) as said:
            write(panel, part, 0, 1, words)
        assert told in said.args[0]


def test_styles_are_saved_renamed_and_kept_with_their_edits(panel: StylePanel, stage: Stage, tmp_path: Path) -> None:
    styles = stage.talking.styles
    panel.sliders["mumbling"].setValue(30)
    assert styles.save(tmp_path / "calm.toml")
    assert (load_style(tmp_path / "calm.toml").mumbling, panel.save.isEnabled()) == (0.3, False)
    assert styles.rename("calmer")
    assert [path.name for path in tmp_path.glob("*.toml")] == ["calmer.toml"]
    assert not styles.rename("calmer")
    panel.sliders["asymmetry"].setValue(20)
    again = StyleModel()
    again.restore(styles.kept)
    assert (again.style, again.is_edited(again.names["A"])) == (styles.style, True)
    panel.save.click()
    assert load_style(tmp_path / "calmer.toml").asymmetry == 0.2
