"""A user's own variables: marked on the averaged spectrum, named, shown, saved, removed."""

import tomllib
from dataclasses import dataclass

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QPushButton

from phonemeanalyser.desktop.analyse.recognition.variable_panel import VariableDialog
from phonemeengine.features.variables import Kind, Spectrum, Variable
from phonemeengine.presets.files import load_preset
from phonemeengine.settings import BIN_WIDTH
from tests.desktop.hands import LEFT, back_in, click, followed, place, press


@dataclass(frozen=True)
class Seen:
    """What the dialog offered, whether it stayed after Add, what it said, and the name in it."""

    range: tuple[float, float]
    stays: bool
    trouble: str
    name: str


@pytest.fixture
def window(desktop, qtbot):
    return followed(desktop, qtbot, seconds=2.0)


def will_answer(hand, name, *, kind="sum", accepted=True):
    """Fill in the dialog for a new variable, and choose Add, and Cancel if it stays; gives what was seen of it."""
    seen = []

    def answer(dialog: VariableDialog) -> None:
        offered = dialog.low.value(), dialog.high.value()
        dialog.name.setText(name)
        dialog.kind.setCurrentText(kind)
        if accepted:
            next(button for button in dialog.findChildren(QPushButton) if button.text() == "Add").click()
        stays = dialog.isVisible()
        seen.append(Seen(offered, stays, dialog.trouble.text() * dialog.trouble.isVisible(), dialog.name.text()))
        if stays:
            dialog.reject()

    hand.act = answer
    return seen


def mark(window, low: float, high: float) -> None:
    """Click on `variable`, drag the region's edges, and click again."""
    view = window.analysis.averaged
    click(view.measure)
    assert view.region.isVisible()
    for edge, target in zip(view.region.lines, (low, high), strict=True):
        pull(view, edge.value(), target)
    click(view.measure)


def pull(view, start: float, end: float) -> None:
    """Drag with the mouse from one frequency to another."""
    viewport = view.graphics.viewport()
    places = [place(view.graphics, view.item, start + k / 8 * (end - start), 0.5) for k in range(9)]
    QTest.mouseMove(viewport, places[0])
    QTest.mousePress(viewport, LEFT, pos=places[0])
    for to in places[1:]:
        QTest.mouseMove(viewport, to)
    QTest.mouseRelease(viewport, LEFT, pos=places[-1])
    QTest.mouseMove(viewport, QPoint(3, 3))


def chosen(window) -> list[str]:
    box = window.analysis.variable.variable
    return [box.itemData(k) for k in range(box.count())]


def test_a_marked_range_becomes_a_variable_that_is_chosen_and_measured(desktop, window, qtbot, hand):
    offered = will_answer(hand, "my_hiss")
    mark(window, 2500, 4000)
    width = 5513 / window.analysis.averaged.item.vb.width()
    assert offered[0].range == pytest.approx((2500, 4000), abs=3 * width + BIN_WIDTH)
    assert chosen(window)[-1] == "my_hiss"
    assert window.analysis.courses.chosen == "my_hiss"
    assert not window.analysis.averaged.region.isVisible()
    assert window.isWindowModified()
    click(window.transport.play)
    qtbot.waitUntil(lambda: desktop.session.history.extremes("my_hiss") is not None)
    assert desktop.session.history.extremes("my_hiss")[0] > 0


def test_a_variable_is_in_the_saved_preset_and_one_dragged_over_the_edge_is_still_a_range(
    desktop, window, hand, qtbot, tmp_path
):
    will_answer(hand, "my_hiss", kind="max")
    press(window, Qt.Key.Key_V)
    assert window.analysis.averaged.region.isVisible()
    press(window, Qt.Key.Key_V)
    desktop.preset.save(tmp_path / "mine.toml")
    (entry,) = tomllib.loads((tmp_path / "mine.toml").read_text())["variables"]
    assert entry["name"] == "my_hiss"
    assert entry["kind"] == "max"
    (variable,) = load_preset(tmp_path / "mine.toml").variables
    assert variable.kind is Kind.MAX
    assert variable.source is Spectrum.NORMALISED
    assert (variable.low, variable.high) == pytest.approx((1000, 1500), abs=BIN_WIDTH / 2 + 0.1)
    back_in(window, qtbot)
    will_answer(hand, "wide")
    click(window.analysis.averaged.measure)
    window.analysis.averaged.region.setRegion((-500, 99_999))
    click(window.analysis.averaged.measure)
    assert not window.banner.isVisible()
    assert 0 <= desktop.preset.preset.variables[-1].low <= desktop.preset.preset.variables[-1].high <= 22_050


def test_a_name_that_cannot_be_is_refused_in_the_dialog_which_keeps_the_entry(desktop, window, hand):
    before, names = desktop.preset.preset, chosen(window)
    for name in ("9 lives", "", "ä", "energy", "m_s1", "phoneme", "a-b"):
        seen = will_answer(hand, name)
        click(window.analysis.averaged.measure)
        click(window.analysis.averaged.measure)
        (seen,) = seen
        assert (seen.stays, seen.name) == (True, name)
        assert repr(name) in seen.trouble or f"{name} exists already" in seen.trouble
        assert "\n" not in seen.trouble
        assert not window.banner.isVisible()
        assert desktop.preset.preset == before  # cancelled then
        assert chosen(window) == names


def test_what_was_wrong_is_said_no_longer_once_the_name_is_mended(desktop, window, qtbot):
    dialog = VariableDialog(1000, 1500, desktop.preset.add_variable, window)
    qtbot.addWidget(dialog)
    dialog.show()
    QTest.keyClicks(dialog.name, "9 lives")
    QTest.keyClick(dialog.name, Qt.Key.Key_Return)
    assert dialog.isVisible()
    assert dialog.trouble.isVisible()
    QTest.keyClicks(dialog.name, "lives")  # what was wrong is selected
    assert not dialog.trouble.isVisible()
    QTest.keyClick(dialog.name, Qt.Key.Key_Return)
    assert not dialog.isVisible()
    assert [v.name for v in desktop.preset.preset.variables] == ["lives"]


@pytest.mark.parametrize(("start", "end"), [pytest.param(3000, 4500, marks=pytest.mark.long), (4000, 300)])
def test_a_drag_anywhere_in_the_plot_draws_the_range(window, hand, start, end):
    offered = will_answer(hand, "my_hiss", accepted=False)
    view = window.analysis.averaged
    seen = view.item.viewRange()
    click(view.measure)
    pull(view, start, end)
    click(view.measure)
    assert [asked.range for asked in offered] == [pytest.approx(sorted((start, end)), abs=60)]
    assert view.item.viewRange() == seen
    pull(view, start, end)
    assert view.region.getRegion() == pytest.approx(sorted((start, end)), abs=60)  # the drag draws no more


def test_escape_drops_the_range_and_the_sound_goes_on(desktop, window, hand):
    seen = will_answer(hand, "my_hiss")
    press(window, Qt.Key.Key_Space)
    press(window, Qt.Key.Key_V)
    press(window, Qt.Key.Key_Escape)
    assert not window.analysis.averaged.region.isVisible()
    assert not window.analysis.averaged.measure.isChecked()
    assert window.analysis.averaged.measure.text() == "Variable"
    assert seen == []
    assert desktop.session.source.playing
    press(window, Qt.Key.Key_Escape)
    assert not desktop.session.source.playing
    press(window, Qt.Key.Key_V)  # and the next one is asked for
    press(window, Qt.Key.Key_V)
    assert len(seen) == 1


def test_a_variable_is_removed_through_the_menu_and_comes_back_by_undo(desktop, window, hand, qtbot):
    window.menus.actions["Remove Variable…"].trigger()
    assert window.banner.label.text().startswith("There are no custom variables yet")
    desktop.preset.add_variable(Variable("my_hiss", 3000, 5000))
    desktop.preset.add_variable(Variable("my_hum", 50, 200))
    window.analysis.courses.choose("my_hiss")
    hand.act = QDialog.accept
    window.menus.actions["Remove Variable…"].trigger()
    back_in(window, qtbot)
    assert "my_hiss" not in chosen(window)
    assert window.analysis.courses.chosen == "energy"
    press(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert chosen(window)[-2:] == ["my_hiss", "my_hum"]
