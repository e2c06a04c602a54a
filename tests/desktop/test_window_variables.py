"""A user's own variables: marked on the averaged spectrum, named, shown, saved, removed."""

import tomllib

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QInputDialog

from engine.features.variables import Kind, Spectrum, Variable
from engine.presets.files import load_preset
from engine.settings import BIN_WIDTH
from phonemeanalyser.views.variable_dialog import VariableDialog
from tests.desktop.hands import LEFT, click, followed, place, press


@pytest.fixture
def window(desktop, qtbot):
    return followed(desktop, qtbot, seconds=2.0)


def will_answer(monkeypatch, name, *, kind="sum", accepted=True):
    """Fill in the dialog for a new variable, and say OK or Cancel; gives the ranges that it offered."""
    offered = []

    def answer(dialog: VariableDialog) -> int:
        offered.append((dialog.low.value(), dialog.high.value()))
        dialog.name.setText(name)
        dialog.kind.setCurrentText(kind)
        return int(accepted)

    monkeypatch.setattr(VariableDialog, "exec", answer)
    return offered


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
    QTest.qWait(30)
    QTest.mousePress(viewport, LEFT, pos=places[0])
    for to in places[1:]:
        QTest.mouseMove(viewport, to)
        QTest.qWait(15)
    QTest.mouseRelease(viewport, LEFT, pos=places[-1])
    QTest.mouseMove(viewport, QPoint(3, 3))


def chosen(window) -> list[str]:
    box = window.analysis.time_view.variable
    return [box.itemText(k) for k in range(box.count())]


def test_a_marked_range_becomes_a_variable_that_is_chosen_and_measured(desktop, window, qtbot, monkeypatch):
    offered = will_answer(monkeypatch, "my_hiss")
    mark(window, 2500, 4000)
    width = 5513 / window.analysis.averaged.item.vb.width()
    assert offered[0] == pytest.approx((2500, 4000), abs=3 * width + BIN_WIDTH)
    assert chosen(window)[-1] == "my_hiss"
    assert window.analysis.time_view.variable.currentText() == "my_hiss"
    assert not window.analysis.averaged.region.isVisible()
    assert window.isWindowModified()
    click(window.transport.play)
    qtbot.waitUntil(lambda: desktop.session.history.extremes("my_hiss") is not None)
    assert desktop.session.history.extremes("my_hiss")[0] > 0


def test_a_variable_is_in_the_saved_preset(desktop, window, monkeypatch, tmp_path):
    will_answer(monkeypatch, "my_hiss", kind="max")
    click(window.analysis.averaged.measure)
    click(window.analysis.averaged.measure)
    desktop.preset.save(tmp_path / "mine.toml")
    (entry,) = tomllib.loads((tmp_path / "mine.toml").read_text())["variables"]
    assert entry["name"] == "my_hiss"
    assert entry["kind"] == "max"
    (variable,) = load_preset(tmp_path / "mine.toml").variables
    assert variable.kind is Kind.MAX
    assert variable.source is Spectrum.NORMALISED
    assert (variable.low, variable.high) == pytest.approx((1000, 1500), abs=BIN_WIDTH / 2 + 0.1)


def test_a_name_that_cannot_be_is_refused_with_a_sentence(desktop, window, monkeypatch):
    before, names = desktop.preset.preset, chosen(window)
    for name in ("9 lives", "", "ä", "energy", "m_s1", "phoneme", "a-b"):
        will_answer(monkeypatch, name)
        click(window.analysis.averaged.measure)
        click(window.analysis.averaged.measure)
        assert window.banner.isVisible()
        assert repr(name) in window.banner.label.text() or f"{name} exists already" in window.banner.label.text()
        assert "\n" not in window.banner.label.text()
        assert desktop.preset.preset == before
        assert chosen(window) == names
        window.banner.say("")


def test_cancel_adds_nothing(desktop, window, monkeypatch):
    will_answer(monkeypatch, "my_hiss", accepted=False)
    click(window.analysis.averaged.measure)
    click(window.analysis.averaged.measure)
    assert not desktop.preset.preset.variables
    assert not window.banner.isVisible()


def test_the_key_v_marks_too(desktop, window, monkeypatch):
    will_answer(monkeypatch, "my_hiss")
    press(window, Qt.Key.Key_V)
    assert window.analysis.averaged.region.isVisible()
    press(window, Qt.Key.Key_V)
    assert [v.name for v in desktop.preset.preset.variables] == ["my_hiss"]


def test_a_region_dragged_over_the_edge_is_still_a_range(desktop, window, monkeypatch):
    will_answer(monkeypatch, "my_hiss")
    click(window.analysis.averaged.measure)
    window.analysis.averaged.region.setRegion((-500, 99_999))
    click(window.analysis.averaged.measure)
    assert not window.banner.isVisible()
    (variable,) = desktop.preset.preset.variables
    assert 0 <= variable.low <= variable.high <= 22_050


def test_a_variable_is_removed_through_the_menu_and_comes_back_by_undo(desktop, window, monkeypatch):
    desktop.preset.add_variable(Variable("my_hiss", 3000, 5000))
    desktop.preset.add_variable(Variable("my_hum", 50, 200))
    window.analysis.time_view.variable.setCurrentText("my_hiss")
    monkeypatch.setattr(QInputDialog, "getItem", lambda *a, **_k: (a[3][0], True))
    window.menus.actions["Remove Variable…"].trigger()
    assert "my_hiss" not in chosen(window)
    assert window.analysis.time_view.variable.currentText() == "energy"
    press(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert chosen(window)[-2:] == ["my_hiss", "my_hum"]


def test_without_variables_of_one_s_own_there_is_nothing_to_remove(window):
    window.menus.actions["Remove Variable…"].trigger()
    assert window.banner.label.text().startswith("There are no variables of your own yet")
