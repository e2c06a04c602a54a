"""Files that come by drag and drop, from the list of recent ones, or broken."""

import os
import subprocess
import sys
from itertools import cycle

import pytest
from PySide6.QtCore import QMimeData, Qt, QUrl
from PySide6.QtGui import QAction, QFileOpenEvent
from PySide6.QtWidgets import QApplication, QWidget

from phonemeanalyser.desktop.app import FileRequests
from phonemeengine.presets.files import FACTORY, THESIS_PRESET, load_preset, save_preset
from tests.bad_files import BAD_FILES, DAMAGED, ODD_FILES
from tests.desktop.hands import CARDS, DEMO, click, drop, drop_data, followed, menu, press, shown, wav
from tests.glb_faces import face_with_targets
from tests.sounds import tone

STARTED = """
import sys
from pathlib import Path
from PySide6.QtCore import QTimer
from phonemeanalyser.cli.window import DEMO
from phonemeanalyser.desktop import app as program

def look(desktop):
    if desktop.session.path is None:
        return QTimer.singleShot(50, lambda: look(desktop))
    print(desktop.preset.path.name, desktop.session.path.name, flush=True)
    desktop.window.welcome.hide()
    program.QApplication.quit()

begin = program._begin
program._begin = lambda desktop, *rest: (begin(desktop, *rest), look(desktop))
sys.exit(program.run(Path(sys.argv[1]) if sys.argv[1:] else None, DEMO))
"""


@pytest.fixture
def window(desktop, qtbot):
    return shown(desktop, qtbot)


def test_dropped_sounds_and_presets_are_opened_links_and_text_are_not(desktop, window, tmp_path):
    for k, name in enumerate(("mine.toml", "mine.phonemedata", "mine.txt", "MINE.TOML")):
        desktop.preset.tune("sz_s1", 3.5 + k)
        save_preset(desktop.preset.preset, tmp_path / name)
        desktop.preset.undo_stack.undo()
        assert drop(window, tmp_path / name)
        assert desktop.preset.preset.thresholds.sz_s1 == 3.5 + k
    assert desktop.session.path == CARDS
    assert drop(window, DEMO, FACTORY / "thesis-anti-aliased.toml")
    assert desktop.session.path == DEMO
    assert desktop.preset.path.name == "thesis-anti-aliased.toml"
    assert window.windowTitle().startswith("demo.flac - ")
    assert desktop.session.source.position == 0
    mime = QMimeData()
    mime.setUrls([QUrl("https://example.org/sound.wav")])
    drop_data(window, mime)
    assert desktop.session.path == DEMO
    assert window.banner.label.text().startswith("https://example.org/sound.wav cannot be opened, since only files")
    words = QMimeData()
    words.setText("hello")
    assert not drop_data(window, words)


def test_a_face_of_ones_own_is_shown_where_it_speaks(desktop, window, tmp_path, qtbot):
    (tmp_path / "own.glb").write_bytes(face_with_targets(("smile",)))
    assert not window.opens_as_sound(tmp_path / "own.glb")
    window.open_files([tmp_path / "own.glb"])
    qtbot.waitUntil(lambda: list(desktop.talking.percentages) == ["smile"], timeout=20_000)
    assert window.talk.isVisible()


def test_a_file_that_macos_asks_for_comes_as_an_event(qapp):
    asked = []
    requests = FileRequests(qapp)
    requests.asked.connect(asked.append)
    QApplication.sendEvent(qapp, QFileOpenEvent(QUrl.fromLocalFile(str(DEMO))))
    qapp.removeEventFilter(requests)
    assert asked == [DEMO]


@pytest.mark.parametrize(
    "given", ["preset", *(pytest.param(given, marks=pytest.mark.long) for given in ("sound", "nothing"))]
)
def test_a_program_that_is_started_with_a_preset_has_a_sound_too(tmp_path, given):
    save_preset(load_preset(THESIS_PRESET), tmp_path / "mine.toml")
    words = {"preset": [str(tmp_path / "mine.toml")], "sound": [str(CARDS)], "nothing": []}[given]
    places = {name: str(tmp_path / name) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    done = subprocess.run(
        [sys.executable, "-c", STARTED, *words],
        env=os.environ | places | {"QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert (
        done.stdout.split()
        == {
            "preset": ["mine.toml", "demo.flac"],
            "sound": ["learned.toml", CARDS.name],
            "nothing": ["learned.toml", "demo.flac"],
        }[given]
    ), done.stderr


def test_a_sound_may_be_dropped_onto_any_view(desktop, window, tmp_path):
    sounds = cycle([wav(tmp_path, tone(1000, 0.05), name) for name in ("one.wav", "other.wav")])
    for view in (
        window.analysis.spectrum,
        window.analysis.averaged,
        window.analysis.waveform,
        window.analysis.scroll_view,
        window.filters,
        window.analysis.thresholds,
    ):
        for target in {type(w): w for w in (view, *view.findChildren(QWidget)) if w.isVisible()}.values():
            sound = next(sounds)
            assert (drop(target, sound), desktop.session.path) == (True, sound), (view, target)


# -- recent files -------------------------------------------------------------------------------------


def recent(window) -> list[str]:
    return [action.text() for action in recent_actions(window)]


def recent_actions(window) -> list[QAction]:
    return next(
        action.menu() for action in menu(window, "&File").actions() if action.text() == "Open Recent"
    ).actions()


def test_recent_sounds_are_listed_newest_first_and_once_and_opened(desktop, window, tmp_path):
    assert recent(window) == [str(CARDS)]
    window.dialogs.open_sound(DEMO)
    recent_actions(window)[1].trigger()
    assert desktop.session.path == CARDS
    assert recent(window) == [str(CARDS), str(DEMO)]
    for k in range(9):
        window.dialogs.open_sound(wav(tmp_path, tone(1000, 0.1), f"{k}.wav"))
    assert recent(window) == [str(tmp_path / f"{k}.wav") for k in range(8, 0, -1)]
    (tmp_path / "7.wav").unlink()
    recent_actions(window)[1].trigger()
    assert window.banner.label.text().startswith("7.wav: there is no such file")
    assert desktop.session.path == tmp_path / "8.wav"


# -- broken files -------------------------------------------------------------------------------------


def is_one_sentence(window) -> bool:
    text = window.banner.label.text()
    return window.banner.isVisible() and 15 < len(text) < 300 and "\n" not in text and "Traceback" not in text


def test_a_bad_sound_gives_one_sentence_and_leaves_everything(desktop, qtbot, tmp_path):
    window = followed(desktop, qtbot, seconds=0.3)
    before = window.windowTitle(), desktop.session.history.n, desktop.session.source.position, recent(window)
    for name in BAD_FILES.keys() - DAMAGED.keys():
        window.dialogs.open_any(BAD_FILES[name](tmp_path))
        assert is_one_sentence(window), name
        assert desktop.session.path == CARDS, name
        after = window.windowTitle(), desktop.session.history.n, desktop.session.source.position, recent(window)
        assert after == before, name
        window.banner.show_error("")
    desktop.session.averages.save(tmp_path / "voice.csv")
    assert drop(window, tmp_path / "voice.csv")  # a curve lies beside the averaged spectrum
    assert [curve.name for curve in desktop.session.curves.curves] == ["voice"]
    press(window, Qt.Key.Key_Space)
    assert desktop.session.source.playing


def test_damage_met_while_playing_stops_with_one_sentence(desktop, window, qtbot, tmp_path):
    for name, write in DAMAGED.items():
        window.dialogs.open_sound(write(tmp_path))
        desktop.session.seek(max(0.0, min(1.6, desktop.session.source.duration - 0.5)))
        click(window.transport.play)
        qtbot.waitUntil(lambda: not desktop.session.source.playing)
        assert is_one_sentence(window), name
        window.dialogs.open_sound(CARDS)
        assert not window.banner.isVisible()
    click(window.transport.play)
    n = desktop.session.history.n
    qtbot.waitUntil(lambda: desktop.session.history.n > n + 5)


def test_unusual_sounds_are_opened_without_complaint(desktop, window, qtbot, tmp_path):
    for name, write in ODD_FILES.items():
        window.dialogs.open_sound(write(tmp_path))
        assert not window.banner.isVisible(), (name, window.banner.label.text())
        desktop.session.analyse_until(0.3)
        window.redraw.refresh_all()
        assert desktop.session.history.n > 0, name


BROKEN_PRESETS = {
    "words.phonemedata": "this is a diary, not a preset",
    "few.phonemedata": "1,2,3",
    "nan.phonemedata": ",".join(["nan"] + ["1"] * 20),
    "negative_smooth.phonemedata": ",".join(["-5"] + ["1"] * 20),
    "garbage.toml": "[[[",
    "other.toml": 'title = "something else"\n',
    "empty.toml": "",
    "empty.phonemedata": "",
    "binary.toml": "\x00\x01\x02",
    "truncated.toml": THESIS_PRESET.read_text()[:400],
    "endless.toml": THESIS_PRESET.read_text().replace("sz_s1 = ", "sz_s1 = inf #"),
}


def test_a_broken_preset_gives_one_sentence_and_leaves_everything(desktop, window, tmp_path):
    before, title = desktop.preset.preset, window.windowTitle()
    for name, text in BROKEN_PRESETS.items():
        (tmp_path / name).write_text(text)
        window.dialogs.open_any(tmp_path / name)
        assert is_one_sentence(window), name
        assert window.banner.label.text().startswith(name + ": ")
        assert desktop.preset.preset == before
        assert desktop.preset.path == THESIS_PRESET
        assert window.windowTitle() == title
        window.banner.show_error("")


def test_the_banner_has_the_lines_that_it_needs_and_goes_by_a_click_and_after_the_next_success(
    desktop, window, qtbot, tmp_path
):
    line = window.banner.label.fontMetrics().height()
    window.dialogs.open_sound(tmp_path / "missing.wav")
    qtbot.waitUntil(lambda: 0 < window.banner.height() < 2.5 * line)
    window.dialogs.open_sound(tmp_path / ("a very long name indeed " * 9 + ".wav"))
    label = window.banner.label
    assert "a very long name" in label.text()
    qtbot.waitUntil(lambda: label.heightForWidth(label.width()) <= label.height())
    assert window.width() == 1280
    click(window.banner.findChildren(QWidget)[-1])
    assert not window.banner.isVisible()
    window.dialogs.open_sound(tmp_path / "missing.wav")
    window.dialogs.open_sound(DEMO)
    assert not window.banner.isVisible()
