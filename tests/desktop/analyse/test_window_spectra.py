"""The live and the averaged spectrum and the waveform: what their controls and their cursor do."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QGraphicsPolygonItem, QLabel

from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.inspection.averaged_spectrum import load_averaged_spectrum
from phonemeengine.settings import BIN_WIDTH, Filter
from tests.desktop.hands import LEFT, ON_BIN, FileAnswers, button, choose, click, copied, followed, hover, press, wav
from tests.sounds import noise, tone

SECONDS = 1.0


@pytest.fixture
def window(desktop, qtbot, tmp_path):
    """A window that has heard a tone of half the full scale on a bin, without any filter but quantising."""
    desktop.preset.load(desktop.preset.path)
    for step in desktop.preset.preset.settings.filters - {Filter.QUANTISE}:
        desktop.preset.set_filter(step, on=False)
    return followed(desktop, qtbot, wav(tmp_path, tone(ON_BIN, SECONDS, 0.5)), 0.8)


def curve(view, k: int = 0) -> tuple[np.ndarray, np.ndarray]:
    return view.item.curves[k].getData()


def top(view) -> float:
    return view.item.viewRange()[1][1]


@pytest.fixture(params=["spectrum", "averaged"])
def view(request, window):
    return getattr(window.analysis, request.param)


def test_a_tone_is_a_peak_of_its_amplitude_at_its_frequency_linear_coarse_and_in_db(view):
    x, linear = curve(view)
    assert len(x) == 256
    assert x[linear.argmax()] == pytest.approx(ON_BIN)
    assert linear.max() == pytest.approx(0.5, abs=0.03)
    rows = copied(view.menu, QPoint(9, 9))
    assert rows[0] == ["frequency (Hz)", "amplitude (linear)", "level (dB)"]
    assert len(rows) == 1 + 256
    hertz, amplitude, level = map(float, rows[1 + 46])
    assert (hertz, amplitude) == (pytest.approx(ON_BIN, abs=0.01), pytest.approx(0.5, abs=0.03))
    assert level == pytest.approx(20 * np.log10(amplitude), abs=0.01)
    # coarse draws the highest of eight bins as a step
    click(view.coarse)
    x, y = curve(view)
    assert len(x) == 2 * 256 // 8
    assert np.allclose(y[::2], linear.reshape(-1, 8).max(axis=1))
    assert np.allclose(y[::2], y[1::2])
    assert x[2 * (46 // 8)] <= ON_BIN < x[2 * (46 // 8) + 1]
    click(view.coarse)
    assert np.array_equal(curve(view)[1], linear)
    # decibels on an axis that says so
    assert view.item.getAxis("left").labelText == "Amplitude"
    click(view.decibels)
    _, decibels = curve(view)
    assert decibels.max() == pytest.approx(20 * np.log10(linear.max()), abs=0.01)
    assert decibels.min() >= -100.01
    assert view.item.getAxis("left").labelText == "Level (dB)"
    assert view.item.viewRange()[1][0] == pytest.approx(-100, abs=1)
    assert 6 <= top(view) <= 12  # room above the loudest line
    # the scale enlarges small amplitudes
    click(view.decibels)
    assert top(view) == pytest.approx(1, abs=0.05)
    view.scale.setFocus()
    for _ in range(2):
        press(view, Qt.Key.Key_PageUp)
    assert view.scale.value() == 20
    assert top(view) == pytest.approx(0.1, abs=0.005)
    click(view.decibels)
    assert top(view) == pytest.approx(-11.4, abs=1)


def test_the_mean_says_of_how_much_it_is_since_when_and_empty_plots_how_to_fill_them(desktop, window, tmp_path):
    def said() -> list[list[str]]:
        plots = (window.analysis.spectrum, window.analysis.averaged, window.analysis.waveform)
        return [
            [w.text() for w in plot.findChildren(QLabel) if "No data yet: press Play" in w.text() and w.isVisible()]
            for plot in plots
        ]

    view = window.analysis.averaged
    assert said() == [[], [], []]
    assert view.since.text() == "Mean of 0.8 s since opening"
    assert "80 frames since opening at 0.00 s of sound.wav; quantise 4 plain" in view.heading.toolTip()
    choose_save(window, tmp_path / "curve.csv")
    desktop.session.curves.remove([0])
    press(window, Qt.Key.Key_C)
    assert view.since.text() == ""
    assert "frames" not in view.heading.toolTip()
    window.analysis.refresh_fast()
    window.analysis.refresh_slow()
    assert [len(words) for words in said()] == [1, 1, 1]
    choose_load(window, tmp_path / "curve.csv")
    assert [len(words) for words in said()] == [1, 0, 1]  # a curve fills the averaged spectrum at once
    desktop.session.curves.remove([0])
    assert [len(words) for words in said()] == [1, 1, 1]
    choose_save(window, tmp_path / "nothing")
    assert window.banner.label.text().startswith("There is no averaged spectrum yet")
    assert not list(tmp_path.glob("nothing*"))


def test_the_cursor_reads_out_frequency_amplitude_and_level_inside_the_plot(view, qtbot):
    view.item.setXRange(ON_BIN - 100, ON_BIN + 100, padding=0)
    for hertz in (ON_BIN + 2 * BIN_WIDTH, ON_BIN):
        hover(view.graphics, view.item, hertz, 0.3)
        k = round(hertz / BIN_WIDTH)
        amplitude = curve(view)[1][k]
        level = f"{20 * np.log10(amplitude):.1f}" if amplitude > 0 else "−∞"
        expected = re.compile(rf"(\d+) Hz   {amplitude:.4f}   {level} dB")
        qtbot.waitUntil(lambda e=expected: e.fullmatch(view.cursor_label.text()) is not None)
        assert float(expected.fullmatch(view.cursor_label.text())[1]) == pytest.approx(hertz, abs=2)
    view.draw(np.full(256, 0.25, np.float32))  # it follows the picture under a still mouse
    assert "0.2500   -12.0 dB" in view.cursor_label.text()
    view.item.setXRange(0, 5400, padding=0)
    hover(view.graphics, view.item, 5300, 0.9)
    qtbot.waitUntil(view.cursor_label.isVisible)
    assert view.graphics.rect().contains(view.cursor_label.geometry())
    hover(view.graphics, view.item, -600, -0.2)
    qtbot.waitUntil(lambda: not view.cursor_label.isVisible())


def test_plots_have_a_menu_that_takes_a_zoom_back_and_copies_and_saves_a_picture(window, tmp_path):
    page, files = window.analysis, FileAnswers(tmp_path / "mine")
    window.files.show = files
    for view in (page.spectrum, page.averaged, page.waveform, page.scroll_view):
        viewport = view.menu.parent().viewport()
        at = viewport.rect().center()
        event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, viewport.mapToGlobal(at))
        QApplication.sendEvent(viewport, event)
        assert view.menu.isVisible()
        entries = [a.text() for a in view.menu.actions()]
        assert entries == ["Reset Zoom", "", "Copy Values", "Copy Picture", "Save Picture…"]
        view.menu.close()
        for by_mouse in (True, False) if view is not page.scroll_view else ():
            whole = np.array(view.item.viewRange())
            view.item.vb.scaleBy((0.3, 0.3))
            assert not np.allclose(view.item.viewRange(), whole)
            if by_mouse:
                QTest.mouseDClick(view.graphics.viewport(), LEFT)
            else:
                choose(view.menu, "Reset Zoom")
            assert np.allclose(view.item.viewRange(), whole)
        choose(view.menu, "Copy Picture")
        copy, shown = QApplication.clipboard().image().size(), view.menu.parent().size()
        assert copy == shown
        choose(view.menu, "Save Picture…")
    assert [path.stem for path in files.suggested] == ["spectrum", "averaged spectrum", "waveform", "sonagram"]
    saved = sorted(path.name for path in tmp_path.glob("mine*"))
    assert saved == ["mine (2).png", "mine (3).png", "mine (4).png", "mine.png"]
    picture = QImage(str(tmp_path / "mine (4).png"))
    assert picture.size() == picture.width() // shown.width() * shown
    assert picture.width() >= 1200
    assert not window.banner.isVisible()
    window.files.show = FileAnswers(tmp_path / "nowhere" / "a.png")
    choose(page.spectrum.menu, "Save Picture…")
    assert window.banner.label.text().startswith("a.png: cannot be written (")
    window.menus.actions["Coarse Display"].trigger()
    window.menus.actions["Spectra in dB"].trigger()
    assert all(view.coarse.isChecked() for view in (page.spectrum, page.averaged, page.waveform))
    assert all(view.decibels.isChecked() for view in (page.spectrum, page.averaged))


def test_the_waveform_shows_the_window_with_a_cursor_and_its_scale_enlarges_it(window, qtbot):
    view = window.analysis.waveform
    x, y = curve(view)
    assert len(y) == 512
    assert x[-1] < 46.5
    assert np.abs(y).max() == pytest.approx(0.5, abs=0.01)
    rows = copied(view.menu, QPoint(9, 9))
    assert rows[0] == ["time in the window (ms)", "amplitude (full scale 1)"]
    assert len(rows) == 1 + 512
    assert max(float(row[1]) for row in rows[1:]) == pytest.approx(0.5, abs=0.01)
    assert top(view) == pytest.approx(0.525, abs=0.01)  # it scales itself
    view.auto.setChecked(False)
    assert top(view) == pytest.approx(1.05, abs=0.01)
    view.auto.setChecked(True)
    view.scale.setValue(20)
    assert top(view) == pytest.approx(0.105, abs=0.001)
    assert not view.auto.isChecked()
    click(view.coarse)
    _, coarse = curve(view)
    assert len(coarse) == 512 // 8 * 2
    assert coarse.max() == y.max()
    assert coarse.min() == y.min()
    hover(view.graphics, view.item, 20, 0)
    qtbot.waitUntil(view.cursor_label.isVisible)
    milliseconds, amplitude = re.fullmatch(r"([\d.]+) ms   ([+-][\d.]+)", view.cursor_label.text()).groups()
    assert float(milliseconds) == pytest.approx(20, abs=0.2)
    assert abs(float(amplitude)) <= 0.51
    view.draw(np.full(512, -0.125, np.float32))
    assert view.cursor_label.text().endswith("ms   -0.1250")


def test_other_filters_change_the_axis_and_a_curve_of_before_stands_beside_it_without_a_difference(
    desktop, window, tmp_path
):
    choose_save(window, tmp_path / "tone")
    desktop.preset.set_setting("quantise", 1)
    desktop.session.averages.begin("Clear", "sound")
    desktop.session.analyse_until(0.5)
    window.redraw.refresh_all()
    x, _ = curve(window.analysis.spectrum)
    assert len(x) == 1024
    assert window.analysis.spectrum.item.viewRange()[0][1] == pytest.approx(22050, abs=30)
    assert entries(window) == ["tone"]
    rows = copied(window.analysis.averaged.menu, QPoint(9, 9))
    assert rows[0][3:] == ["1 tone, amplitude (linear)"]
    assert len(rows) == 1 + 1024
    assert float(rows[1 + 46][3]) == pytest.approx(0.5, abs=0.03)
    assert rows[-1][3] == ""


# -- the menu of the plots ----------------------------------------------------------------------------


def test_pictures_are_lines_where_the_name_says_so(desktop, qtbot, tmp_path):
    window = followed(desktop, qtbot)
    page = window.analysis
    desktop.session.view.show(TimeSpan(1.3, 2.1))
    qtbot.waitUntil(lambda: not desktop.session.busy)
    for k, plot in enumerate((page.spectrum.graphics, page.file.view)):
        path = tmp_path / f"{k}.svg"
        window.files.show = FileAnswers(path)
        window.dialogs.ask_save_picture(plot, "plot")
        drawn = ElementTree.parse(path).getroot()
        assert drawn.tag.endswith("svg")
        assert sum(1 for _ in drawn.iter()) > 20
        images = [e for e in drawn.iter() if e.tag.endswith("image")]
        assert all(float(e.get("x")) + float(e.get("width")) <= plot.width() + 1 for e in images)
        assert all(float(e.get("x")) >= 0 for e in images)


# -- curves -------------------------------------------------------------------------------------------


def choose_save(window, path):
    window.files.show = FileAnswers(path)
    next(
        a for a in button(window.analysis.averaged, "Curves").menu().actions() if a.text() == "Save Curve…"
    ).trigger()


def choose_load(window, *paths):
    window.files.show = FileAnswers(*paths)
    next(
        a for a in button(window.analysis.averaged, "Curves").menu().actions() if a.text() == "Load Curve…"
    ).trigger()


def entries(window) -> list[str]:
    return [label.text for _, label in window.analysis.averaged.legend.items]


def test_a_curve_whose_ending_nobody_typed_replaces_nothing_and_a_file_that_is_none_is_said(window, tmp_path):
    (tmp_path / "tone.csv").write_text("milk,2\n")
    choose_load(window, tmp_path / "tone.csv")
    assert window.banner.isVisible()
    assert window.banner.label.text().startswith("tone.csv: a curve begins with")
    assert entries(window) == []
    choose_save(window, tmp_path / "tone")
    assert (tmp_path / "tone.csv").read_text() == "milk,2\n"
    assert load_averaged_spectrum(tmp_path / "tone (2).csv").n_frames == 80


def test_a_saved_curve_lies_on_the_average_at_no_distance_coarse_and_in_db_with_its_spread(
    desktop, window, tmp_path, qtbot
):
    def bands() -> list[QGraphicsPolygonItem]:
        return [i for i in window.analysis.averaged.item.items if isinstance(i, QGraphicsPolygonItem)]

    view = window.analysis.averaged
    choose_save(window, tmp_path / "tone")
    saved = load_averaged_spectrum(tmp_path / "tone.csv")
    assert saved.n_frames == 80
    assert "quantise 4 plain" in saved.front_end
    window.redraw.refresh_all()
    assert entries(window) == ["tone Δ 0.0 dB"]
    assert np.allclose(curve(view, 0)[1], curve(view, 1)[1])
    click(view.coarse)
    (x, y), (mean_x, mean_y) = (curve(view, k) for k in (1, 0))
    assert len(x) == 2 * 256 / 8
    assert np.array_equal(x, mean_x)
    assert np.allclose(y, mean_y)
    click(view.coarse)
    click(view.decibels)
    assert curve(view, 1)[1].max() == pytest.approx(curve(view, 0)[1].max())
    assert curve(view, 1)[1].max() < 0
    (band,) = bands()
    heights = [point.y() for point in band.polygon()]
    assert heights[46] - heights[-1 - 46] == pytest.approx(2 * saved.spread[46], abs=1e-4)
    view.spread.trigger()
    assert bands() == []
    view.spread.trigger()
    click(view.decibels)
    desktop.session.clear()
    window.redraw.refresh_all()
    view.item.setXRange(ON_BIN - 100, ON_BIN + 100, padding=0)
    hover(view.graphics, view.item, ON_BIN, 0.4)  # the curve is read, since it is the nearest
    qtbot.waitUntil(lambda: re.fullmatch(r"tone   99\d Hz   0\.\d+   .* dB", view.cursor_label.text()) is not None)


def test_curves_are_compared_coloured_and_loaded_once(desktop, window, qtbot, tmp_path):
    choose_save(window, tmp_path / "tone")
    window.dialogs.open_sound(wav(tmp_path, noise(SECONDS, 0.1), "noise.wav"))
    desktop.session.analyse_until(0.8)
    choose_save(window, tmp_path / "hiss.csv")
    choose_load(window, tmp_path / "tone.csv", tmp_path / "hiss.csv")
    assert window.banner.label.text() == "This average is in the table already, as hiss"
    window.redraw.refresh_all()
    names = [text.split(" Δ ")[0] for text in entries(window)]
    distances = [float(text.split(" Δ ")[1].removesuffix(" dB")) for text in entries(window)]
    assert names == ["tone", "hiss"]
    assert distances[1] == 0
    assert distances[0] > 5
    assert len(window.analysis.averaged.item.curves) == 3
    pens = [c.opts["pen"].color().name() for c in window.analysis.averaged.item.curves[1:]]
    assert pens == [curve.colour for curve in desktop.session.curves.curves]
    assert len(set(pens)) == 2
    desktop.session.curves.remove([0])
    assert len(window.analysis.averaged.item.curves) == 2
