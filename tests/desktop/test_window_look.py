"""Light and dark, the list of keys, and what comes back at the next start."""

import re
from collections import Counter
from html import unescape
from itertools import groupby

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QAction, QImage
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QComboBox, QDockWidget, QLabel, QMenu, QWidget

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.calibrate.page import MappingDialog
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.help import ShortcutsDialog
from phonemeanalyser.desktop.preset_dialogs import IN_USE, NOT_IN_USE
from phonemeanalyser.desktop.session.preset import PresetDocument
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.audio.output import ClockOutput
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset, preset_path, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel
from tests.desktop.hands import click, followed, menu, press, settle, shown, type_number


def pixels(window) -> np.ndarray:
    image = window.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    return np.frombuffer(image.constBits(), np.uint32).reshape(image.height(), image.width()).copy()


def lightness(image: np.ndarray) -> float:
    """The median of the green channel, 0..255."""
    return float(np.median((image >> 8) & 255))


# -- themes -------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("own_desktop")
def test_another_theme_changes_the_colours_and_nothing_else(desktop, settings, qtbot, tmp_path):
    others = {*QApplication.topLevelWidgets()} - {desktop.window}  # such as the one that is lent
    window, session = followed(desktop, qtbot, seconds=2.0), desktop.session
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "3.5")
    session.curves.add([session.averages.save(tmp_path / "voice.csv")])
    press(window, Qt.Key.Key_F)
    known, images = (session.history.n, session.path), [pixels(window)]
    next(a for a in menu(window, "&View").actions() if a.text() == "Theme: Dark").trigger()
    new = desktop.window
    assert (new is window, new.isVisible(), window.isVisible()) == (False, True, False)
    assert marked_theme(desktop, settings) == ("Theme: Dark", "dark", "dark")
    new.resize(window.size())  # Qt holds a restored window within the screen, and the offscreen one is small
    settle()
    images.append(pixels(new))
    assert all(len(np.unique(image)) > 500 for image in images)
    assert lightness(images[0]) > 200
    assert lightness(images[1]) < 60
    assert np.mean(images[0] != images[1]) > 0.7
    assert (session.history.n, session.path) == known
    assert new.isWindowModified()
    assert new.redraw.frozen
    assert new.menus.actions["Freeze Views"].isChecked()
    assert new.analysis.thresholds.rows["sz_s1"].number.value() == 3.5
    assert len(new.analysis.averaged.item.curves) == 2
    assert [label.text for _, label in new.analysis.averaged.legend.items] == ["voice Δ 0.0 dB"]
    qtbot.waitUntil(new.isActiveWindow)
    press(new, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert not new.isWindowModified()

    press(new, Qt.Key.Key_F)
    session.playback.set_loop(True)  # however long the window takes, the sound goes on
    click(new.transport.play)
    desktop.set_theme("system")
    assert session.source.playing
    n = session.history.n
    qtbot.waitUntil(lambda: session.history.n > n + 20)
    assert desktop.window.analysis.phoneme.meters
    assert marked_theme(desktop, settings) == ("Theme: System", "system", desktop.theme.name)
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert {w for w in QApplication.topLevelWidgets() if isinstance(w, MainWindow)} - others == {desktop.window}


def marked_theme(desktop, settings) -> tuple[str, object, str]:
    """Give the theme that the menu marks, the one that is kept, and that of the window."""
    (marked,) = [
        a for a in menu(desktop.window, "&View").actions() if a.text().startswith("Theme: ") and a.isChecked()
    ]
    return marked.text(), settings.value("theme"), desktop.window.theme.name


# -- keys ---------------------------------------------------------------------------------------------


def keys_of(window) -> dict[str, list[str]]:
    return {
        action.text().replace("&", ""): [key.toString() for key in action.shortcuts()]
        for title in window.menuBar().actions()
        for action in title.menu().actions()
    }


def test_everything_frequent_has_a_key_of_its_own_and_the_dialog_lists_them(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    keys = keys_of(window)
    frequent = ("Open Audio File…", "Save Preset", "Undo", "Redo", "Play/Pause", "Stop", "Loop", "Clear")
    assert all(keys[name][0] for name in (*frequent, "Freeze Views"))
    for page in (0, 1):
        window.show_page(page)
        acting = [action for action in window.findChildren(QAction) if action.isVisible()]
        counts = Counter(key.toString() for action in acting for key in action.shortcuts())
        assert len(counts) > 20
        assert [key for key, n in counts.items() if key and n > 1] == []
    press(window, Qt.Key.Key_F1)
    dialog = window.findChild(ShortcutsDialog)
    assert dialog.isVisible()
    text = dialog.list.text()
    for name, of_it in keys_of(window).items():
        if of_it and of_it[0]:
            assert f"<td>{name}&nbsp;&nbsp;&nbsp;</td><td>{of_it[0]}</td>" in text
    for key in ("Backspace", "R", "Right", "Return", "Esc"):  # of the guide
        assert f"<td>{key}</td>" in text.split("<b>Guided calibration</b>")[1]
    assert dialog.width() <= 1016
    assert dialog.height() <= 660
    dialog.close()


def test_each_sound_has_one_name_on_all_pages_and_what_talk_does_with_files_is_in_a_menu_too(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    names = set(map(sound_name, Phoneme))
    boxes = (*window.calibration.findChildren(QComboBox), *window.talk.findChildren(QComboBox))
    of_sounds = [box for box in boxes if isinstance(box.itemData(0), Phoneme)]
    shown_names = {box.itemText(k) for box in of_sounds for k in range(box.count())} - {"all others"}
    assert {"s", "sh"} < shown_names <= names
    mapping = MappingDialog({"zh": 3}, window)
    qtbot.addWidget(mapping)
    assert {mapping.boxes["zh"].itemText(k) for k in range(len(Phoneme))} == names
    for phoneme, record in window.calibration.takes.record.buttons.items():
        assert record.accessibleName() == f"Record a take of {sound_name(phoneme)}"
    page = window.talk
    bars = page.text.script, page.text.lexicon, page.key_panel.save, page.choices.own, page.choices.map
    for place in (page.export, page.save_words, *bars, *page.choices.heads.values(), *page.heads.framings.values()):
        assert any(place.text().rstrip("…") in entry for entry in window.menus.actions), place.text()


def test_no_menu_has_more_than_seven_entries_without_a_line(desktop, qtbot):
    window = shown(desktop, qtbot)
    desktop.preset.load(preset_path("extended"))  # whose rules have a menu
    for page in range(3):
        window.show_page(page)
    menus = window.findChildren(QMenu)
    for each in menus:
        each.aboutToShow.emit()  # some are filled then
    lists = [(m.title() or type(m.parent()).__name__, m.actions()) for m in menus]
    kept = len(lists)
    for widget in window.findChildren(QWidget):
        if widget.contextMenuPolicy() == Qt.ContextMenuPolicy.ActionsContextMenu:
            lists.append((type(widget).__name__, widget.actions()))
        if widget.contextMenuPolicy() == Qt.ContextMenuPolicy.CustomContextMenu:
            widget.customContextMenuRequested.emit(QPoint())
            popup = QApplication.activePopupWidget()
            assert isinstance(popup, QMenu)
            lists.append((type(widget).__name__, popup.actions()))
            popup.close()
    assert {"CurveList", "FileView", "RuleTree"} <= {name for name, _ in lists[kept:]}
    assert [name for name, actions in lists if max(groups_of(actions), default=0) > 7] == []
    told = [action.text() for _, actions in lists[kept:] for action in actions]
    assert [text for text in told if LOWER_CASE.search(text)] == []
    play = [action.text() for action in menu(window, "&Play").actions()]
    assert play[-4:] == ["Louder", "Quieter", "Slower", "Faster"]


LOWER_CASE = re.compile(r" (?!(?:a|as|at|by|for|from|in|of|on|or|the|to|with)\b)[a-z]")
"""A word of an entry that has no capital, though it is none of the short ones."""


def groups_of(actions: list[QAction]) -> list[int]:
    """Give how many entries stand between two lines of a menu."""
    kinds = groupby(actions, lambda action: action.isSeparator())
    return [len(list(group)) for separator, group in kinds if not separator]


def test_every_number_has_a_tip(desktop, qtbot):
    window = shown(desktop, qtbot)
    for page in range(3):
        window.show_page(page)
        window.redraw.refresh_all()
    labels = [each for each in window.findChildren(QLabel) if re.search(r"\d", re.sub(r"<[^>]*>", "", each.text()))]
    numbers = [*labels, *window.findChildren(QAbstractSpinBox)]
    assert len(numbers) > 30
    assert [(each.accessibleName(), type(each.parent()).__name__) for each in numbers if not has_tip(each)] == []


def has_tip(widget: QWidget | None) -> bool:
    """Say whether a widget, or what it lies in, has a tool tip."""
    while widget is not None and not widget.isWindow():
        if widget.toolTip():
            return True
        widget = widget.parentWidget()
    return False


def test_about_says_what_it_is(desktop, qtbot, hand):
    shown(desktop, qtbot, None).menus.actions["About PhonemeAnalyser"].trigger()
    assert "MIT" in hand.texts[0]
    preset = load_preset(DEFAULT_PRESET)
    assert "left out of a training, but not of the choice of its settings" in " ".join(preset.notes.split())
    assert preset.summary in unescape(hand.texts[0])


# -- the next start -----------------------------------------------------------------------------------


@pytest.fixture
def start_again(desktop, qapp, settings):
    """Close the window and start the program a second time."""
    others = []

    def start() -> Desktop:
        assert desktop.window.close()
        settings.sync()
        others.append(Desktop(qapp, settings, lambda _n: ClockOutput()))
        return others[-1]

    yield start
    for other in others:
        other.close()


@pytest.mark.usefixtures("own_desktop")
def test_layout_choices_and_both_presets_come_back(desktop, qtbot, start_again, tmp_path):
    window = shown(desktop, qtbot)
    window.resize(1500, 900)
    settle()
    window.analysis.rows.setSizes([300, 100, 300])
    window.analysis.spectra.setSizes([300, 600])
    window.findChild(QDockWidget, "Filters").close()
    window.transport.volume.setValue(-20)
    click(window.transport.loop)
    desktop.session.set_channel(Channel.LEFT)
    window.analysis.courses.choose("m_s1")
    sonagram = window.analysis.sonagram
    sonagram.colours.setCurrentText("magma")
    sonagram.low.setValue(-80)
    sonagram.high.setValue(-10)
    for switch in (
        window.analysis.spectrum.decibels,
        window.analysis.averaged.coarse,
        window.analysis.waveform.coarse,
    ):
        click(switch)
    desktop.preset.save(tmp_path / "mine.toml")
    window.dialogs.presets.load(tmp_path / "mine.toml")
    desktop.preset.set_other(PresetDocument.read(preset_path("extended")))
    desktop.preset.switch()
    settle()
    sizes = window.analysis.rows.sizes(), window.analysis.spectra.sizes()
    again = start_again()
    new = again.window
    new.show()
    new.resize(1500, 900)  # Qt holds a restored window within the screen, and the offscreen one is small
    settle()
    assert new.analysis.rows.sizes() == pytest.approx(sizes[0], abs=25)
    assert new.analysis.spectra.sizes() == pytest.approx(sizes[1], abs=25)
    docks = {name: new.findChild(QDockWidget, name).isVisible() for name in ("Filters", "Thresholds")}
    assert docks == {"Filters": False, "Thresholds": True}
    assert new.transport.volume.value() == again.session.playback.volume == -20
    assert again.session.playback.loop
    assert new.transport.loop.isChecked()
    assert again.session.channel is Channel.LEFT
    assert new.transport.channel.currentText() == "Left"
    assert new.analysis.courses.chosen == "m_s1"
    assert new.analysis.sonagram.colours.currentText() == "magma"
    assert (new.analysis.sonagram.low.value(), new.analysis.sonagram.high.value()) == (-80, -10)
    assert again.session.sonagram.level_range == (-80, -10)
    coarse = [
        view.coarse.isChecked() for view in (new.analysis.spectrum, new.analysis.averaged, new.analysis.waveform)
    ]
    assert coarse == [False, True, True]
    assert new.analysis.spectrum.decibels.isChecked()
    new.dialogs.presets.restore()
    assert again.preset.letter == "B"
    assert [preset.name for preset in again.preset.sides.values()] == ["mine", "Extended rules"]
    assert new.banner.label.text() == ""
    assert not new.isWindowModified()


def test_f6_goes_from_the_file_to_each_dock_in_front_and_back_and_a_closed_one_comes_back(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    window.analysis.main_view.setFocus()
    docks = [dock for dock in window.findChildren(QDockWidget) if not dock.visibleRegion().isEmpty()]
    found = []
    for _ in docks:
        press(window, Qt.Key.Key_F6)
        found += [dock for dock in docks if dock.isAncestorOf(window.focusWidget())]
    assert sorted(map(id, found)) == sorted(map(id, docks))
    press(window, Qt.Key.Key_F6)
    assert window.focusWidget() is window.analysis.main_view
    press(window, Qt.Key.Key_F6, Qt.KeyboardModifier.ShiftModifier)
    assert found[-1].isAncestorOf(window.focusWidget())
    for name in ("Filters", "Phoneme", "Thresholds"):
        dock = window.findChild(QDockWidget, name)
        dock.close()
        toggle = next(a for a in menu(window, "&View").actions() if a.text() == name)
        assert not toggle.isChecked()
        toggle.trigger()
        assert dock.isVisible()


@pytest.mark.parametrize("gone", ["a", "b", "ab"])
def test_a_preset_whose_file_is_gone_is_said_once_in_one_sentence(desktop, settings, qtbot, tmp_path, gone):
    presets, banner = shown(desktop, qtbot, None).dialogs.presets, desktop.window.banner
    for key, name in ((IN_USE, "a"), (NOT_IN_USE, "b")):
        save_preset(Preset(name=name), tmp_path / f"{name}.toml")
        settings.setValue(key, str(tmp_path / f"{name}.toml"))
    for name in gone:
        (tmp_path / f"{name}.toml").unlink()
    before = desktop.preset.preset.name
    presets.restore()
    assert all(str(tmp_path / f"{name}.toml") in banner.label.text() for name in gone)
    assert list(desktop.preset.sides) == ["A"]
    assert desktop.preset.preset.name == {"a": "b", "b": "a", "ab": before}[gone]
    banner.show_error("")
    presets.restore()
    assert banner.label.text() == ""


def test_settings_of_nonsense_do_not_keep_the_window_from_opening(qapp, settings, qtbot):
    nonsense = {
        "volume": "loud",
        "loop": "maybe",
        "channel": "middle",
        "variable": "none",
        "colours": "rainbow",
        "darkest": "black",
        "brightest": "white",
        "recent": "3",
        "theme": "pink",
        "geometry": "x",
        "rows": "y",
    }
    for key, value in nonsense.items():
        settings.setValue(key, value)
    desktop = Desktop(qapp, settings, lambda _n: ClockOutput())
    desktop.window.show()
    qtbot.waitExposed(desktop.window)
    assert desktop.session.channel is Channel.MIX
    assert desktop.session.playback.volume == 0
    desktop.session.close()
    desktop.window.close_without_asking()
