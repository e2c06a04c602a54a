"""The courses of variables with their thresholds, and the panel that tells of the chosen variable."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDockWidget

from phonemeanalyser.desktop.session.time_view import Scope, TimeSpan
from phonemeengine.calibration.workbench.distributions import separability
from phonemeengine.features.variables import BUILT_IN_NAMES, Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from tests.conftest import ROOT
from tests.desktop.hands import LEFT, click, drag, followed, press, shown, type_number

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
CONTROL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def window(desktop, qtbot):
    """The demo, which is known whole, and the panel of the variable in front."""
    window = shown(desktop, qtbot, DEMO)
    qtbot.waitUntil(lambda: not desktop.session.whole.busy)
    dock = window.findChild(QDockWidget, "Variable")
    dock.raise_()
    yield window
    dock.show()
    window.findChild(QDockWidget, "Phoneme").raise_()
    panel = window.analysis.variable
    panel.scope.setCurrentIndex(0)
    panel.one.setCurrentIndex(panel.one.findData(Phoneme.SZ))
    panel.other.setCurrentIndex(panel.other.findData(Phoneme.SCH))


def found(window, qtbot):
    """What the panel knows once it has looked."""
    study = window.analysis.variable.study
    qtbot.waitUntil(lambda: not study._timer.isActive() and not study._work.busy)
    return study.found


def values_in(desktop, name: str, span: TimeSpan | None = None) -> np.ndarray:
    values = desktop.session.whole.tracks.features[name].astype(float)
    middles = (np.arange(len(values)) + 0.5) * FRAME_PERIOD
    return values if span is None else values[(middles >= span.start) & (middles < span.end)]


def touch(window, name: str) -> None:
    row = window.analysis.thresholds.rows[name]
    window.analysis.thresholds.ensureWidgetVisible(row.number)
    QTest.mouseClick(row.number, LEFT, pos=QPoint(4, 4))


def pull(view, x: float, y: float, to: float) -> None:
    """Drag with the mouse from one height to another."""
    no = Qt.KeyboardModifier.NoModifier
    held, kinds = Qt.MouseButton.LeftButton, QEvent.Type
    for kind, at in ((kinds.MouseButtonPress, y), (kinds.MouseMove, (y + to) / 2), (kinds.MouseMove, to)):
        place = QPointF(x, at)
        QApplication.sendEvent(view, QMouseEvent(kind, place, view.mapToGlobal(place), held, held, no))
    place = QPointF(x, to)
    QApplication.sendEvent(
        view, QMouseEvent(kinds.MouseButtonRelease, place, view.mapToGlobal(place), held, Qt.MouseButton.NoButton, no)
    )


def y_of(desktop, view, variable: str, value: float) -> float:
    """Where a value lies in the lane of its variable: from 0 to the greatest that is seen, and a little room."""
    row, seen = view.course_rows()[variable], desktop.session.view.seen
    high = 1.08 * values_in(desktop, variable, seen).max()
    return row.bottom() - value / high * row.height()


def test_touching_a_threshold_shows_the_courses_of_its_rule_and_brings_its_panel_forward(desktop, window):
    window.findChild(QDockWidget, "Phoneme").raise_()
    touch(window, "p_p1")
    assert list(window.analysis.file.view.course_rows()) == ["m_p1", "max_energy", "energy_n", "m_p2"]
    assert window.analysis.variable.isVisible()
    touch(window, "szsch_szsch1")  # which stands in two rules
    assert list(window.analysis.file.view.course_rows()) == ["m_szsch1", "m_s1"]
    touch(window, "denoise_threshold")  # with which no variable is compared
    assert list(window.analysis.file.view.course_rows()) == ["m_szsch1", "m_s1"]
    rows = [*window.analysis.file.view.course_rows().values()]
    assert rows[0].bottom() < rows[1].top()
    dock = window.findChild(QDockWidget, "Variable")
    dock.close()
    touch(window, "sz_s1")
    assert window.analysis.courses.chosen == "m_s1"
    assert dock.isHidden()  # what was closed stays so


def test_a_threshold_is_dragged_in_the_course_or_its_slider_clicked_or_typed(desktop, window, qtbot):
    touch(window, "sz_s1")
    view, preset, row = window.analysis.file.view, desktop.preset, window.analysis.thresholds.rows["sz_s1"]
    before = preset.preset.thresholds.sz_s1
    greatest = values_in(desktop, "m_s1", desktop.session.view.seen).max()
    target = round(0.5 * greatest, 2)
    x = view.course_rows()["m_s1"].center().x()
    pull(view, x, y_of(desktop, view, "m_s1", before), y_of(desktop, view, "m_s1", target))
    pixel = 1.08 * greatest / view.course_rows()["m_s1"].height()
    assert preset.preset.thresholds.sz_s1 == pytest.approx(target, abs=pixel)
    assert row.slider.value == preset.preset.thresholds.sz_s1
    assert desktop.session.view.seen.start == 0  # the sound was not scrolled
    press(window, Qt.Key.Key_Z, CONTROL)  # the whole drag
    assert preset.preset.thresholds.sz_s1 == before
    looked = found(window, qtbot)
    click(window.analysis.variable.values["seen", 2])
    assert preset.preset.thresholds.sz_s1 == pytest.approx(looked.seen.greatest, rel=1e-3)
    press(window, Qt.Key.Key_Z, CONTROL)
    assert preset.preset.thresholds.sz_s1 == before
    window.analysis.thresholds.ensureWidgetVisible(row.slider)
    view.grab()
    drawn = view._lanes._kept["m_s1"]
    drag(row.slider, 20, 40)
    view.grab()
    assert view._lanes._kept["m_s1"] is drawn  # the line alone has moved
    found(window, qtbot)
    type_number(row.number, "12.5")
    assert [line.value for line in window.analysis.variable.distribution.lines] == [12.5]


def test_least_mean_and_greatest_are_those_of_what_is_seen_and_selected(desktop, window, qtbot):
    panel, time = window.analysis.variable, desktop.session.view
    window.analysis.courses.choose("m_szsch1")
    time.show(TimeSpan(1.0, 3.0))
    assert found(window, qtbot).selection is None
    assert panel.values["selection", 0].text() == "–"
    panel.scope.setCurrentIndex(panel.scope.findData(Scope.SELECTION))
    assert found(window, qtbot).distribution is None
    assert panel.distribution._words == "Nothing is selected. Shift+drag over the file to select a segment."
    time.select(TimeSpan(1.5, 2.0))
    looked = found(window, qtbot)
    for name, span in (("seen", TimeSpan(1.0, 3.0)), ("selection", TimeSpan(1.5, 2.0))):
        values = values_in(desktop, "m_szsch1", span)
        expected = [values.min(), values.mean(), values.max()]
        assert getattr(looked, name) == pytest.approx(expected, rel=1e-5)
        shown_values = [float(panel.values[name, k].text()) for k in range(3)]
        assert shown_values == pytest.approx(expected, rel=6e-3)
    touch(window, "p_p1")
    time.select(TimeSpan(0.0, 6.0))
    spread = found(window, qtbot).distribution.spreads[Phoneme.A]
    view = panel.distribution
    places = [QPointF(x, y) for x in range(4, view.width(), 9) for y in range(4, view.height(), 5)]
    place = next(at for at in places if (hit := view.number_at(at)) and hit[:2] == (Phoneme.A, 2))
    QTest.mouseClick(view, LEFT, pos=place.toPoint())  # a number of a phoneme becomes the threshold
    assert desktop.preset.preset.thresholds.p_p1 == pytest.approx(spread.maximum, rel=1e-3)


def test_since_clear_is_what_was_played(desktop, qtbot):
    window = followed(desktop, qtbot, seconds=1.0)
    window.findChild(QDockWidget, "Variable").raise_()
    panel, history = window.analysis.variable, desktop.session.history
    for name in BUILT_IN_NAMES:
        window.analysis.courses.choose(name)
        panel.refresh()
        values = history.features(history.indices(0, history.n))[name].astype(float)
        numbers = [float(panel.values["clear", k].text()) for k in range(3)]
        assert numbers == pytest.approx([values.min(), values.mean(), values.max()], rel=6e-3, abs=1e-9)
    press(window, Qt.Key.Key_C)
    panel.refresh()
    assert [panel.values["clear", k].text() for k in range(3)] == ["–"] * 3
    window.findChild(QDockWidget, "Phoneme").raise_()


def test_the_distribution_is_by_the_labels_where_there_are_any_and_says_so(desktop, window, qtbot):
    window.analysis.courses.choose("m_s1")
    said = desktop.session.labels.said_frames()
    n = min(len(said.phonemes), desktop.session.whole.tracks.n_frames)
    certain = (said.phonemes == Phoneme.SZ)[:n] & said.certain[:n]
    spread = found(window, qtbot).distribution.spreads[Phoneme.SZ]
    assert spread.n == certain.sum()
    assert spread.maximum == pytest.approx(values_in(desktop, "m_s1")[:n][certain].max())
    assert window.analysis.variable.phonemes.text() == "Phonemes of the labels"
    desktop.session.labels.show((), None)
    recognised = desktop.session.whole.tracks.phonemes == Phoneme.SZ
    assert found(window, qtbot).distribution.spreads[Phoneme.SZ].n == recognised.sum()
    assert window.analysis.variable.phonemes.text() == "Phonemes as recognised"


def test_the_variable_that_separates_two_sounds_best_comes_first_and_is_found_by_what_it_measures(
    desktop, window, qtbot
):
    panel, courses = window.analysis.variable, window.analysis.courses
    panel.one.setCurrentIndex(panel.one.findData(Phoneme.A))
    panel.other.setCurrentIndex(panel.other.findData(Phoneme.I))
    found(window, qtbot)
    said = desktop.session.labels.said_frames()
    n = min(len(said.phonemes), desktop.session.whole.tracks.n_frames)
    one, other = ((said.phonemes == p)[:n] & said.certain[:n] for p in (Phoneme.A, Phoneme.I))
    features = desktop.session.whole.tracks.features
    expected = {name: separability(features[name][:n][one], features[name][:n][other]) for name in BUILT_IN_NAMES}
    offered = [panel.variable.itemData(k) for k in range(panel.variable.count())]
    separations = [expected[name] for name in offered]
    assert separations == sorted(separations, reverse=True)
    assert panel.variable.itemText(0).endswith(f"{separations[0]:.0%}")
    assert "energy 3768–5168 Hz  ·  m_s1" in " ".join(panel.variable.itemText(k) for k in range(len(offered)))
    completer = panel.variable.completer()
    completer.setCompletionPrefix("peak 1077")
    assert completer.completionCount() == 1
    assert "m_ae1" in completer.currentCompletion()
    panel.one.setCurrentIndex(panel.one.findData(Phoneme.O))
    found(window, qtbot)
    assert panel.about.text() == "Without frames of o, the variables are not sorted by separation."
    panel.one.setCurrentIndex(panel.one.findData(Phoneme.A))
    found(window, qtbot)
    desktop.preset.add_variable(Variable("above", 9000, 10_000))
    courses.choose("above")
    sentence = "above reads 0, since it begins at 9000 Hz and the spectrum ends at 5512 Hz; quantise less."
    assert panel.about.text() == sentence
    courses.choose("m_s1")
    assert not panel.about.isVisible()
    courses.choose("above")
    desktop.preset.remove_variable("above")
    assert courses.variables == ("energy",)
