"""What recordings say of the preset: distributions, the matrix while a threshold is dragged, fit and comparison."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from phonemeanalyser.desktop.calibrate.model import AROUND
from phonemeanalyser.desktop.calibrate.page import MappingDialog
from phonemeanalyser.desktop.calibrate.workbench.confusion_view import SAID, TAKEN
from phonemeanalyser.desktop.calibrate.workbench.fit_panel import ComparePanel
from phonemeanalyser.desktop.calibrate.workbench.workbench_view import WorkbenchView
from phonemeanalyser.desktop.engine_words import recogniser_title
from phonemeengine.analyser import Analysis
from phonemeengine.calibration.scores.corpus import read_recordings
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.features.variables import readable_name
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, FACTORY, load_preset
from phonemeengine.recognition.rules import Condition, Rule
from phonemeengine.settings import FRAME_PERIOD
from tests.desktop.calibrate.calibrating import CONTROL, Calibrator, corpus
from tests.desktop.hands import LEFT, FileAnswers, click, copied, press, settle
from tests.desktop.hands import choose as choose_entry
from tests.desktop.studio import Booth, choose
from tests.fakes.microphones import HandDrivenMicrophone

Open = Callable[..., Booth]


@pytest.fixture
def calibrator(open_booth: Open, mic: HandDrivenMicrophone) -> Calibrator:
    return Calibrator(open_booth(mic), mic)


@pytest.fixture
def loaded(calibrator: Calibrator, tmp_path: Path) -> Calibrator:
    """Two speakers' recordings are loaded."""
    calibrator.model.recordings.load([corpus(tmp_path / "corpus")])
    calibrator.settle()
    return calibrator


def bench_of(calibrator: Calibrator) -> WorkbenchView:
    return calibrator.page.workbench


def show(calibrator: Calibrator, variable: str) -> None:
    """Choose a variable in the list."""
    table = bench_of(calibrator).variables.table
    row = next(k for k in range(table.rowCount()) if table.item(k, 0).toolTip().endswith(f"({variable})"))
    table.scrollToItem(table.item(row, 0))
    QTest.mouseClick(table.viewport(), LEFT, pos=table.visualItemRect(table.item(row, 0)).center())
    calibrator.settle()


def drag_line(calibrator: Calibrator, name: str, to: float, *, release: bool = True) -> None:
    """Drag a threshold to a value."""
    view = bench_of(calibrator).distribution
    line = next(line for line in view.lines if line.name == name)
    start, end, y = round(view.x_of(line.value)), round(view.x_of(to)), view.height() // 2
    QTest.mousePress(view, LEFT, pos=QPoint(start, y))
    for x in np.linspace(start, end, 6)[1:]:
        QTest.mouseMove(view, QPoint(round(x), y))
    if release:
        QTest.mouseRelease(view, LEFT, pos=QPoint(end, y))


# -- loading ------------------------------------------------------------------------------------------


def test_recordings_are_counted_as_the_engine_counts_them_copied_and_played(loaded: Calibrator, tmp_path: Path):
    preset = loaded.booth.desktop.preset.preset
    expected = LabelledFeatures(read_recordings(tmp_path / "corpus"), preset).confusion(preset)
    bench, counts = bench_of(loaded), expected.counts
    np.testing.assert_array_equal(bench.confusion.counts, counts)
    assert f"{expected.agreement.macro_f1:.1%}" in bench.figures.text()
    assert f"labels {expected.agreement.label_changes_per_s:.1f}" in bench.figures.text()
    assert "Model: Thesis" in bench.about.text()  # the model for live sound, whichever files use
    assert loaded.page.takes.recordings.text() == "2 from 2 speakers"
    rows = copied(bench.confusion.menu, QPoint(9, 9))
    assert rows[0][:2] == ["said", "recognised as silence (frames of 10 ms)"]
    assert sum(int(cell) for row in rows[1:] for cell in row[1:]) == counts.sum()
    rows = copied(bench.timeline.menu, QPoint(9, 9))
    assert rows[0] == ["recording", "time (s)", "said", "recognised"]
    assert len(rows) > 50
    loaded.booth.window.files.remember("picture", tmp_path)
    loaded.booth.window.files.show = FileAnswers(as_suggested=True)
    for plot in (bench.distribution, bench.confusion, bench.timeline):
        choose_entry(plot.menu, "Save Picture…")
    saved = sorted(path.name for path in tmp_path.glob("*.png"))
    assert saved == ["confusion matrix.png", "distribution.png", "said and recognised.png"]
    # a cell lists its stretches, and a click plays one to its end
    truth, answer = max(
        ((t, a) for t in SAID for a in TAKEN if t is not Phoneme.SILENCE), key=lambda cell: counts[cell]
    )
    box = bench.confusion.cell_rect(SAID.index(truth), TAKEN.index(answer))
    QTest.mouseClick(bench.confusion, LEFT, pos=box.center().toPoint())
    table, rows = bench.segments, bench.segments.rows
    assert sum(round((row.end - row.start) * 100) for row in rows) == counts[truth, answer]
    session, heard = loaded.booth.desktop.session, list[Analysis]()
    session.analysed.connect(heard.extend)
    QTest.mouseClick(table.viewport(), LEFT, pos=table.visualItemRect(table.item(0, 0)).center())
    assert session.path == rows[0].path
    assert session.source.playing
    loaded.until(lambda: not session.source.playing)
    assert (heard[-1].start + len(heard[-1])) * FRAME_PERIOD == pytest.approx(rows[0].end + AROUND, abs=0.02)
    # a click in the lanes plays what was said there
    lanes = bench.timeline.lanes
    second = lanes.confusion.edges[1]
    lanes.scale = 1.0
    bench.timeline.show_frame(1, 0.5)
    x = 76 + (second + 50 - lanes.first) * lanes.scale
    QTest.mouseClick(bench.timeline, LEFT, pos=QPoint(round(x), 20))
    assert session.path == loaded.model.workbench.utterances[1].path
    assert session.source.position == pytest.approx(0.15, abs=0.06)  # a begins at 0.3 s


def test_the_page_fits_takes_count_beside_the_recordings_and_the_cross_forgets_these(loaded: Calibrator):
    window, page = loaded.booth.window, bench_of(loaded)
    for size in ((1280, 600), (1920, 1080)):
        window.resize(*size)
        settle()
        assert (window.width(), window.height()) == size
        assert page.confusion.height() >= 190
        assert page.distribution.height() >= 170
        assert page.timeline.lanes.height() >= 55
        wave = loaded.page.takes.wave
        for part in (page.confusion, page.distribution, page.tabs, page.variables, page.timeline, wave):
            assert part.isVisible()
            assert part.parentWidget().rect().contains(part.geometry()), (size, part)
    loaded.keep(Phoneme.A)
    assert len(loaded.model.workbench.utterances) == 3
    click(loaded.page.takes.clear)
    loaded.settle()
    assert len(loaded.model.workbench.utterances) == 1


def test_where_one_sound_is_loaded_nothing_is_made_up(calibrator: Calibrator):
    calibrator.booth.desktop.preset.load(DEFAULT_PRESET)  # which keeps calm in silence
    calibrator.keep(Phoneme.SILENCE)
    bench, text = bench_of(calibrator), bench_of(calibrator).figures.text()
    assert "(1 of 10 phonemes)" in text
    assert "macro F1 is of these: silence." in bench.figures.toolTip()
    assert bench.about.text().startswith("Recordings: 1 (")
    assert "nan" not in text
    assert ">0.0</b>" in text
    assert bench._theme.bad not in text
    assert "Model: Learned, look-ahead 50 ms" in bench.about.text()
    shares = {bench.variables.table.item(k, 1).text() for k in range(bench.variables.table.rowCount())}
    assert shares == {"–"}


def test_unknown_names_are_asked_for_and_then_read_and_a_folder_without_labels_is_said(
    calibrator: Calibrator, tmp_path: Path
):
    (tmp_path / "empty").mkdir()
    calibrator.model.recordings.load([tmp_path / "empty"])
    calibrator.settle()
    assert "no labelled sound was found here" in calibrator.booth.banner
    folder = corpus(tmp_path / "corpus", {Phoneme.SZ: "hiss", Phoneme.I: "iota"})
    asked = []

    def answer() -> None:
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, MappingDialog)
        asked.extend(dialog.boxes)
        for name, phoneme in (("hiss", Phoneme.SZ), ("iota", Phoneme.I)):
            box = dialog.boxes[name]
            box.setCurrentIndex(box.findData(phoneme))
        QTest.keyClick(dialog, Qt.Key.Key_Return)

    timer = QTimer()
    timer.timeout.connect(lambda: isinstance(QApplication.activeModalWidget(), MappingDialog) and answer())
    timer.start(50)
    calibrator.model.recordings.load([folder])
    calibrator.until(lambda: calibrator.model.recordings.utterances)
    timer.stop()
    assert sorted(asked) == ["hiss", "iota"]
    phonemes = {label.phoneme for u in calibrator.model.recordings.utterances for label in u.labels}
    assert phonemes == {Phoneme.SILENCE, Phoneme.A, Phoneme.I, Phoneme.SZ, Phoneme.U}


# -- distributions ------------------------------------------------------------------------------------


def test_thresholds_sensitivities_and_limits_are_lines_that_the_matrix_follows_while_they_are_dragged(
    loaded: Calibrator, tmp_path: Path
):
    show(loaded, "m_szsch1")
    preset, bench, spread = loaded.booth.desktop.preset, bench_of(loaded), bench_of(loaded).distribution
    before, counts = preset.preset, bench.confusion.counts
    highest = float(loaded.model.workbench.distribution.edges[-1])
    drag_line(loaded, "szsch_szsch1", highest, release=False)
    loaded.settle()
    during = preset.preset
    assert during.thresholds.szsch_szsch1 == pytest.approx(highest, rel=0.02)
    assert not np.array_equal(bench.confusion.counts, counts)
    expected = LabelledFeatures(read_recordings(tmp_path / "corpus"), during).confusion(during)
    np.testing.assert_array_equal(bench.confusion.counts, expected.counts)
    np.testing.assert_array_equal(bench.timeline.lanes.confusion.predicted, expected.predicted)
    QTest.mouseRelease(spread, LEFT)
    press(loaded.booth.window, Qt.Key.Key_Z, CONTROL)
    loaded.settle()
    assert preset.preset == before  # one drag, one undo
    np.testing.assert_array_equal(bench.confusion.counts, counts)
    spread.setFocus()
    values = {line.name: line.value for line in spread.lines}
    QTest.keyClick(spread, Qt.Key.Key_Right)
    after = {line.name: line.value for line in spread.lines}
    (moved,) = [name for name in values if after[name] != values[name]]
    assert after[moved] > values[moved]
    assert getattr(preset.preset.thresholds, moved) == after[moved]
    # limits of own rules
    own = (
        Rule(Phoneme.SZ, (Condition("zero_crossings", ">", limit=300.0),)),
        Rule(Phoneme.A, (Condition("zero_crossings", "<", limit=300.0), Condition("energy", ">", limit=0.1))),
    )
    preset.edit(replace(preset.preset, recogniser="rules", rules=own), "own rules")
    loaded.settle()
    show(loaded, "zero_crossings")
    assert [line.value for line in spread.lines] == [300.0]
    assert [line.label for line in spread.lines] == ["< a; > sz"]
    drag_line(loaded, spread.lines[0].name, 150.0)
    limits = {c.limit for rule in preset.preset.rules for c in rule.conditions if c.variable == "zero_crossings"}
    (limit,) = limits  # both comparisons move together
    assert limit == pytest.approx(150.0, rel=0.05)
    # sensitivities of templates
    preset.set_recogniser("templates")
    loaded.settle()
    show(loaded, "deficit_a")
    medians = {phoneme: s.median for phoneme, s in loaded.model.workbench.distribution.spreads.items()}
    assert min(medians, key=medians.__getitem__) is Phoneme.A
    heard = loaded.model.workbench.confusion.predicted
    drag_line(loaded, "sensitivity_a", 8.0)
    loaded.settle()
    assert preset.preset.sensitivities[Phoneme.A] == pytest.approx(8.0, abs=0.5)
    now = loaded.model.workbench.confusion.predicted
    assert np.count_nonzero(now == Phoneme.A) > np.count_nonzero(heard == Phoneme.A)


def test_a_suggestion_shows_its_range_and_its_distribution_before_it_is_added_and_goes_with_the_recordings(
    loaded: Calibrator,
):
    bench, variables, spread = loaded.model.workbench, bench_of(loaded).variables, bench_of(loaded).distribution
    preset, table = loaded.booth.desktop.preset, bench_of(loaded).variables.table
    choose(variables.one, "i")
    choose(variables.other, "u")
    for name, can in (("extended", True), ("thesis", False)):
        preset.load(FACTORY / f"{name}.toml")
        loaded.settle()
        click(variables.search)
        loaded.until(lambda: bench.searching.busy or bench.suggestions)
        loaded.until(lambda: not bench.searching.busy)
        loaded.settle()
        assert bench.suggestions
        assert variables.words.isVisible()
        recogniser = recogniser_title(preset.preset.recogniser)
        told = f"The recogniser {recogniser} cannot use custom variables" in variables.words.text()
        assert told is not can, name
    best = bench.suggestions[0]
    assert bench.shown is best.distribution
    bounds = f"over {best.variable.low:.0f}–{best.variable.high:.0f} Hz"
    assert f"{best.variable.kind.capitalize()} {bounds}" in variables.words.text()
    assert spread.lines == []
    assert spread.x_of(0) < spread.x_of(best.threshold) < spread.width()
    rows = copied(spread.menu, QPoint(9, 9))
    assert rows[0][2] == f"minimum of {best.variable.name} (amplitude)"
    sounds = {row[0]: float(row[4]) for row in rows[1:]}  # medians
    assert min(sounds["i"], sounds["u"]) < best.threshold < max(sounds["i"], sounds["u"])
    row = next(k for k in range(table.rowCount()) if table.item(k, 0).toolTip().endswith("(m_p2)"))
    table.setCurrentCell(row, 0)
    loaded.settle()
    assert bench.shown is bench.distribution
    assert not variables.words.isVisible()
    assert table.item(0, 0).text() == f"+ {readable_name(best.variable.name, (best.variable,))}"
    table.scrollToTop()
    QTest.mouseClick(table.viewport(), LEFT, pos=table.visualItemRect(table.item(0, 0)).center())
    click(variables.add)
    loaded.settle()
    assert preset.preset.variables == (best.variable,)
    assert best.variable.name in {r.variable for r in bench.ranking}
    press(loaded.booth.window, Qt.Key.Key_Z, CONTROL)
    assert preset.preset.variables == ()
    loaded.model.recordings.clear()
    loaded.settle()
    assert bench.suggestions == ()
    assert not variables.words.isVisible()


# -- the plots' menus ---------------------------------------------------------------------------------


# -- the matrix ---------------------------------------------------------------------------------------


# -- fit and comparison -------------------------------------------------------------------------------


def test_a_fit_is_cancelled_or_shown_accepted_and_undone(loaded: Calibrator):
    fit, preset = bench_of(loaded).fit, loaded.booth.desktop.preset
    bench_of(loaded).tabs.setCurrentIndex(1)
    before = preset.preset
    click(fit.begin, 10)
    click(fit.stop, 10)
    loaded.settle()
    assert loaded.model.fit.report is None
    assert preset.preset == before
    click(fit.begin, 10)
    assert fit.stop.isVisible()
    loaded.settle()
    report = loaded.model.fit.report
    assert report is not None
    assert report.gains
    assert fit.figures.item(0, 1).text() == f"{report.after.macro_f1:.1%}"
    assert fit.figures.item(0, 2).text() == f"{report.held_out.macro_f1:.1%}"
    assert preset.preset == before
    click(fit.accept, 10)
    loaded.settle()
    assert preset.preset.thresholds == report.preset.thresholds
    assert loaded.model.workbench.confusion.agreement.macro_f1 == pytest.approx(report.after.macro_f1)
    press(loaded.booth.window, Qt.Key.Key_Z, CONTROL)
    assert preset.preset == before


def test_a_recogniser_of_another_package_is_fitted_where_it_can_be(
    loaded: Calibrator, loudness: Path, brightness: Path
):
    fit, preset = bench_of(loaded).fit, loaded.booth.desktop.preset
    preset.set_recogniser("loudness")
    assert "The recogniser loudness has no thresholds" in loaded.model.fit.why_not
    preset.set_recogniser("brightness")
    preset.tune("szsch_szsch1", 1000.0)
    loaded.settle()
    bench_of(loaded).tabs.setCurrentIndex(1)
    click(fit.begin, 10)
    loaded.settle()
    report = loaded.model.fit.report
    assert report is not None
    assert report.after.macro_f1 > report.before.macro_f1
    click(fit.accept, 10)
    loaded.settle()
    assert preset.preset.thresholds == report.preset.thresholds
    assert loaded.model.workbench.confusion.agreement.macro_f1 == pytest.approx(report.after.macro_f1)
    preset.set_recogniser("thesis")  # the package of the other one ends with this test
    loaded.settle()


def compared_with(loaded: Calibrator, words: str) -> ComparePanel:
    """Choose B in the list of presets, and wait until both are compared."""
    compare, before = bench_of(loaded).compare, loaded.model.comparison.result
    bench_of(loaded).tabs.setCurrentIndex(3)
    click(compare.picker)
    QTest.keyClicks(compare.picker.list.search, words)
    QTest.keyClick(compare.picker.list.search, Qt.Key.Key_Return)
    loaded.until(lambda: not (loaded.model.comparison.result is None or loaded.model.comparison.result is before))
    loaded.settle()
    return compare


def cells(compare: ComparePanel) -> list[list[str]]:
    """Return the rows of the table of figures."""
    table = compare.figures
    return [[table.item(row, k).text() for k in range(3)] for row in range(table.rowCount())]


def test_two_presets_are_compared_and_the_comparison_follows_the_one_in_use(loaded: Calibrator):
    preset, compare, comparison = loaded.booth.desktop.preset, bench_of(loaded).compare, loaded.model.comparison
    assert compare.use.text() == "Use the Better One"
    assert not compare.use.isEnabled()
    preset.set_other(preset.document)
    loaded.until(lambda: comparison.result is not None)
    loaded.settle()
    assert compare.verdict.text() == "Both have the same macro F1."
    assert cells(compare)[0][2] == "+0.0 ±0.0"
    compared_with(loaded, "anti-aliased")
    other = load_preset(FACTORY / "thesis-anti-aliased.toml")
    expected = LabelledFeatures(loaded.model.workbench.utterances, other).confusion(other)
    np.testing.assert_array_equal(comparison.confusion.counts, expected.counts)
    own = loaded.model.workbench.confusion
    one, two = (confusion.agreement.macro_f1 for confusion in (own, expected))
    (macro_f1, *_) = cells(compare)
    assert macro_f1[:2] == [f"{one:.1%}", f"{two:.1%}"]
    gain = comparison.result.gains.macro_f1
    assert gain.difference == pytest.approx(two - one)
    towards_zero = gain.difference - gain.low if gain.difference > 0 else gain.high - gain.difference
    assert gain.is_clear == (abs(gain.difference) > towards_zero)
    assert macro_f1[2] == f"{100 * (two - one):+.1f} ±{100 * towards_zero:.1f}"
    right = own.predicted == own.labels.phonemes
    others = expected.predicted == own.labels.phonemes
    assert int(comparison.result.only_one.sum()) == int(np.sum(right & ~others))
    click(compare.difference)
    share = bench_of(loaded).confusion.share(0, 0)
    shares = [c.counts[0, 0] / c.counts[0].sum() for c in (own, expected)]
    assert share == pytest.approx(shares[0] - shares[1])
    before = comparison.result
    preset.tune("silence_energy", 0.0)
    loaded.until(lambda: comparison.result is not before)


def test_the_better_one_is_named_and_used_by_a_click(loaded: Calibrator):
    preset, compare, comparison = loaded.booth.desktop.preset, bench_of(loaded).compare, loaded.model.comparison
    for name in ("silence_zero_crossings", "silence_energy", "silence_max_energy", "silence_szsch1"):
        preset.tune(name, 1e6)  # with which all is silence
    loaded.settle()
    compared_with(loaded, "learned")
    assert compare.verdict.text().startswith("<b>B is better</b>: macro F1 ")
    assert compare.use.text() == "Use B: Learned"
    before = cells(compare)
    click(compare.use)
    assert (preset.letter, preset.preset.name) == ("B", "Learned")
    loaded.until(lambda: comparison.result is not None)
    loaded.settle()
    assert compare.use.text() == "B: Learned is in use"
    names = {ranked.variable for ranked in loaded.model.workbench.ranking}
    assert names == set(loaded.model.workbench.features.variables)
    assert "deficit_a" in names  # which the rules of A do not have
    assert not compare.use.isEnabled()
    assert cells(compare) == before  # A stays left of B
    assert bench_of(loaded).figures.text().count(before[0][1]) == 1
    click(compare.switch)
    assert preset.letter == "A"
    loaded.model.recordings.clear()
    loaded.settle()
    assert compare.verdict.text() == "Load takes or labelled recordings to compare on."


# -- room ---------------------------------------------------------------------------------------------
