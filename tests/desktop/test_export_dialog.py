"""The dialog that turns sounds into files: one, or a folder of them."""

import shutil
from pathlib import Path

import numpy as np
import pytest
import soundfile
from PySide6.QtCore import QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog, QLineEdit

from phonemeanalyser.cli.main import main
from phonemeanalyser.desktop.export_dialog import BESIDE, ExportDialog
from phonemeanalyser.desktop.session.exports import ExportState
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.words.sound_words import KnownWords
from phonemeanalyser.desktop.talk.words.text_model import TextTools
from phonemeanalyser.desktop.talk.words.voice_model import VoiceChoice
from phonemeengine import Channel, SoundReader, convert, load_preset, save_preset
from phonemeengine.conversion.spoken_texts import NO_TEXTS
from phonemeengine.labels.files import write_labels
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.mouth.animation import FaceDriver
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, THESIS_PRESET
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.spoken_text import spoken_text
from tests.desktop.hands import CARDS, LEFT, shown
from tests.desktop.talk.voices import FakeVoice
from tests.tables import outputs_in

PRESET = load_preset("thesis")


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "in" / "deep").mkdir(parents=True)
    shutil.copy(CARDS, tmp_path / "in" / "one.flac")
    shutil.copy(CARDS, tmp_path / "in" / "deep" / "two.flac")
    (tmp_path / "in" / "notes.md").write_text("nothing to hear")
    return tmp_path / "in"


@pytest.fixture
def dialog(desktop, qtbot, folder, tmp_path):
    settings = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    dialog = ExportDialog(PRESET, Channel.MIX, [folder], settings, desktop.window)
    dialog.open()
    yield dialog
    dialog.queue.close()
    dialog.close()


def choose(dialog, kind):
    dialog.choices.kind.setCurrentIndex(dialog.choices.kind.findData(kind))


def cells(dialog, row):
    return [dialog.files.item(row, k).text() for k in range(4)]


def test_a_folder_becomes_files_beside_its_sounds_which_are_seen_before(dialog, folder, qtbot):
    choose(dialog, "phonemes-csv")
    with qtbot.waitSignal(dialog.queue.previewed):
        QTest.mouseClick(dialog.look, LEFT)
    assert dialog.preview.toPlainText().startswith("start_s,end_s,phoneme")
    choose(dialog, "rhubarb-json")
    assert dialog.preview.toPlainText() == ""
    assert not list(folder.rglob("*.csv"))
    assert [cells(dialog, row)[0] for row in range(2)] == ["two.flac", "one.flac"]
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    expected = folder / "expected.json"
    convert(folder / "one.flac", expected, "rhubarb-json", PRESET)
    assert (folder / "deep" / "two.rhubarb.json").read_text().count("mouthCues") == 1
    assert (folder / "one.rhubarb.json").read_bytes() == expected.read_bytes()
    assert dialog.told.text() == "2 done"
    assert cells(dialog, 0)[1:3] == ["0:03.5", "done"]
    assert dialog.bar.value() == 1000
    choose(dialog, "phonemes-csv")
    assert (dialog.told.text(), dialog.bar.value()) == ("", 0)


def test_files_go_where_the_user_says_and_what_fails_is_said(dialog, folder, tmp_path, qtbot, hand):
    def choose_out(asked: QFileDialog) -> None:
        asked.findChild(QLineEdit).setText(str(tmp_path / "out"))
        asked.accept()

    (tmp_path / "out").mkdir()
    (folder / "bad.wav").write_bytes(b"RIFF nonsense")
    dialog.add([folder])
    choose(dialog, "phonemes-csv")
    hand.act = choose_out
    QTest.mouseClick(dialog.folder, LEFT)
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    states = {job.source.name: job.state for job in dialog.queue.jobs}
    assert states == {"one.flac": ExportState.DONE, "two.flac": ExportState.DONE, "bad.wav": ExportState.FAILED}
    assert dialog.told.text() == "2 done, 1 failed"
    row = next(r for r in range(3) if cells(dialog, r)[0] == "bad.wav")
    assert "bad.wav" in cells(dialog, row)[3]
    assert outputs_in(tmp_path / "out") == ["one.csv", "two.csv"]
    hand.act = QFileDialog.reject
    QTest.mouseClick(dialog.folder, LEFT)
    assert dialog.folder.text() == BESIDE
    blocked = folder / "blocked"
    blocked.write_text("a file, no folder")
    dialog.write_into(Path(blocked))
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    assert dialog.told.text() == "3 failed"
    assert blocked.read_text() == "a file, no folder"


def test_cancelling_leaves_no_half_file(dialog, folder, qtbot, monkeypatch):
    choose(dialog, "phonemes-csv")
    QTest.mouseClick(dialog.start, LEFT)
    QTest.mouseClick(dialog.cancel, LEFT)
    qtbot.waitUntil(lambda: not dialog.queue.busy and dialog.start.isEnabled())
    qtbot.waitUntil(lambda: not list(folder.rglob("*.part")))  # the one at work ends a moment later
    written = {path.name for path in folder.rglob("*.csv")}
    done = {job.target.name for job in dialog.queue.jobs if job.state is ExportState.DONE}
    assert written == done
    assert ExportState.CANCELLED in {job.state for job in dialog.queue.jobs}


def test_of_a_long_sound_the_beginning_is_seen(dialog, folder, qtbot):
    for path in folder.rglob("*.flac"):
        soundfile.write(path, np.zeros(40 * SAMPLE_RATE), SAMPLE_RATE)
    choose(dialog, "phonemes-csv")
    with qtbot.waitSignal(dialog.queue.previewed):
        QTest.mouseClick(dialog.look, LEFT)
    *rows, last = dialog.preview.toPlainText().splitlines()
    assert last == "…"
    assert float([row for row in rows if row][-1].split(",")[1]) == pytest.approx(30.0, abs=0.03)


def test_only_choices_that_make_a_difference_to_the_format_are_shown_and_impossible_ones_refused(dialog):
    shown_in = {
        "rhubarb-json": {"timing", "table", "minimum", "anticipation"},
        "oculus-csv": {"timing", "table", "rate", "anticipation", "detail", "seed"},
        "livelink-csv": {"timing", "table", "rate", "anticipation", "detail", "seed", "blinks", "head"},
        "frames-csv": set(),
    }
    names = ("timing", "driver", "table", "mesh", "expression", "rate", "minimum", "anticipation", "detail", "seed")
    for kind, expected in shown_in.items():
        choose(dialog, kind)
        assert {name for name in (*names, "blinks", "head") if getattr(dialog.choices, name).isVisible()} == expected
    choose(dialog, "phonemes-csv")
    assert not dialog.choices.table.isEnabled()
    choose(dialog, "rhubarb-json")
    assert dialog.choices.table.isEnabled()
    dialog.choices.table.setCurrentText("ARKit 52")
    QTest.mouseClick(dialog.start, LEFT)
    assert dialog.told.text()
    assert dialog.queue.jobs == []
    dialog.choices.table.setCurrentIndex(0)
    dialog.choices.minimum.setValue(0.2)
    dialog.choices.head.setChecked(False)
    order = dialog.choices.order()
    assert (order.options.minimum, order.options.table, order.options.idle.head) == (0.2, None, False)
    dialog.files.selectRow(0)
    QTest.mouseClick(dialog.remove, LEFT)
    assert dialog.files.rowCount() == 1


def test_the_menu_and_a_dropped_folder_open_it_and_another_preset_is_chosen(desktop, qtbot, folder):
    window = shown(desktop, qtbot)
    window.menus.actions["Export…"].trigger()
    (dialog,) = window.findChildren(ExportDialog)
    assert cells(dialog, 0)[0] == CARDS.name
    dialog.close()
    window.dialogs.show_export([folder])
    (dialog,) = (d for d in window.findChildren(ExportDialog) if d.isVisible())
    assert dialog.files.rowCount() == 2
    assert dialog.choices.order().preset == desktop.preset.in_force
    QTest.mouseClick(dialog.choices.preset, LEFT)
    QTest.keyClicks(dialog.choices.preset.list.search, "learned")
    QTest.keyClick(dialog.choices.preset.list.search, Qt.Key.Key_Return)
    assert dialog.choices.preset.text() == "Learned ▾"
    assert dialog.choices.order().preset == load_preset(DEFAULT_PRESET)
    assert dialog.choices.order().preset != desktop.preset.in_force
    dialog.choices.preset.choose(folder / "gone.toml")
    QTest.mouseClick(dialog.start, LEFT)
    assert "gone.toml" in dialog.told.text()
    assert dialog.queue.jobs == []
    dialog.close()


def said_in(sound, word="ma"):
    """Write a TextGrid of one word, as the window saves it, and give what it says."""
    with SoundReader(sound) as reader:
        duration = reader.duration
    words, phones = [(0.0, 1.0, ""), (1.0, 1.4, word), (1.4, duration, "")], [(1.0, 1.2, "m"), (1.2, 1.4, "a")]
    phones = [(0.0, 1.0, ""), *phones, (1.4, duration, "")]
    path = sound.with_suffix(".TextGrid")
    path.write_text(format_tiers({"words": words, "phones": phones}, duration))
    return read_utterance(path, duration)


def made(dialog, qtbot):
    choose(dialog, "rhubarb-tsv")
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    return {job.source.stem: (job.target.read_text(), job.notes) for job in dialog.queue.jobs}


def test_words_that_talk_knows_of_the_sound_in_hand_are_its_timing(desktop, qtbot, tmp_path):
    sound = Path(shutil.copy(CARDS, tmp_path))
    said, window = said_in(sound), shown(desktop, qtbot, sound)
    desktop.talking.text.words.put(KnownWords(said))
    window.dialogs.show_export()
    (dialog,) = (d for d in window.findChildren(ExportDialog) if d.isVisible())
    assert dialog.choices.timing.currentText() == "Aligned words (1)"
    assert dialog.choices.preset.path is None
    assert dialog.choices.preset.text().startswith(desktop.preset.in_force.name)
    content, _ = made(dialog, qtbot)[sound.stem]
    convert(sound, tmp_path / "api.tsv", "rhubarb-tsv", desktop.preset.in_force, script=said)
    assert content == (tmp_path / "api.tsv").read_text()
    dialog.choices.timing.setCurrentIndex(0)
    assert dialog.choices.order().texts == NO_TEXTS
    choose(dialog, "frames-csv")
    assert not dialog.choices.timing.isEnabled()
    dialog.close()


def test_a_batch_takes_the_words_beside_each_sound_and_says_where_there_are_none(dialog, folder, qtbot, tmp_path):
    said = said_in(folder / "one.flac")
    assert dialog.choices.timing.currentText() == "Recognition only"
    dialog.choices.timing.setCurrentIndex(dialog.choices.timing.findText("Text or labels beside each file"))
    found = made(dialog, qtbot)
    for name, script in (("one", said), ("deep/two", None)):
        convert(folder / f"{name}.flac", tmp_path / "api.tsv", "rhubarb-tsv", PRESET, script=script, overwrite=True)
        assert found[Path(name).name][0] == (tmp_path / "api.tsv").read_text()
    assert found["one"][1] == ()
    assert found["two"][1] == ("no text or TextGrid beside the file",)
    assert "no text or TextGrid beside the file" in cells(dialog, 0)[3]


def exporting(window):
    window.dialogs.show_export()
    return next(d for d in window.findChildren(ExportDialog) if d.isVisible())


def test_a_face_is_exported_as_talk_shows_it(desktop, qtbot, tmp_path):
    sound = Path(shutil.copy(CARDS, tmp_path))
    said, window, talking = said_in(sound), shown(desktop, qtbot, sound), desktop.talking
    talking.text.words.put(KnownWords(said))
    talking.set_speed(0.5, 2.0)
    talking.set_random(False)
    talking.set_blinks(False)
    talking.expression.set_share("smile", 0.6)
    talking.text.drivers.choose(FaceDriver.RULES)
    dialog = exporting(window)
    choose(dialog, "livelink-csv")
    assert dialog.choices.table.currentText() == "Same as Talk: ARKit 52"
    assert dialog.choices.driver.currentText() == "Same as Talk: Phonemes (rules)"
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    preset, grid, expected = tmp_path / "preset.toml", sound.with_suffix(".TextGrid"), tmp_path / "cli.csv"
    save_preset(desktop.preset.in_force, preset)
    words = ["--attack", "0.5", "--release", "2", "--steady", "--no-blinks", "--expression", "smile=0.6"]
    words += ["--text-driver", "rules", "--script", str(grid), "--preset", str(preset), "-o", str(expected)]
    assert main(["export", str(sound), "--format", "livelink-csv", *words]) == 0
    (job,) = dialog.queue.jobs
    assert job.target.read_bytes() == expected.read_bytes()
    dialog.close()


@pytest.mark.usefixtures("own_desktop")
def test_a_text_in_hand_is_exported_as_its_voice_says_it(desktop, qtbot, tmp_path):
    window, text = shown(desktop, qtbot, None), desktop.talking.text
    text.tools = TextTools(speak=FakeVoice().speak)
    desktop.session.set_source(SourceKind.TEXT)
    text.set_text("Guten Abend.")
    text.set_language("de")
    dialog = exporting(window)
    assert cells(dialog, 0)[0] == "Text on the Talk page"
    assert not dialog.choices.timing.isVisible()
    assert dialog.choices.kind.findData("phonemes-csv") < 0
    dialog.write_into(tmp_path)
    choose(dialog, "livelink-csv")
    with qtbot.waitSignal(dialog.queue.previewed):
        QTest.mouseClick(dialog.look, LEFT)
    assert dialog.preview.toPlainText().startswith("Timecode")
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    assert (dialog.told.text(), cells(dialog, 0)[1]) == ("1 done", "0:00.5")
    said = spoken_text(FakeVoice().speak("Guten Abend.", "de", VoiceChoice()), language="de").transcript
    expected = b"".join(Exporter("livelink-csv").chunks_of(said))
    assert (tmp_path / "text.livelink.csv").read_bytes() == expected
    dialog.close()


def test_a_clip_is_the_one_that_the_command_makes(dialog, folder, tmp_path, qtbot):
    (folder / "deep" / "two.flac").unlink()
    dialog.files.selectAll()
    QTest.mouseClick(dialog.remove, LEFT)
    soundfile.write(folder / "one.flac", soundfile.read(CARDS, frames=SAMPLE_RATE)[0], SAMPLE_RATE)
    dialog.add([folder / "one.flac"])
    assert not dialog.choices.isRowVisible(dialog.choices.width)
    choose(dialog, "clip-gif")
    assert dialog.choices.isRowVisible(dialog.choices.width)
    dialog.choices.width.setValue(120)
    dialog.choices.height.setValue(90)
    for box, words in ((dialog.choices.view, "Mouth"), (dialog.choices.ground, "Transparent (GIF, PNG)")):
        box.setCurrentText(words)
    dialog.choices.rate.setValue(1)
    dialog.choices.head.setChecked(False)
    QTest.mouseClick(dialog.look, LEFT)
    qtbot.waitUntil(lambda: dialog.preview.toPlainText().startswith("Clips have no preview"))
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    assert dialog.told.text() == "1 done"
    other, preset = tmp_path / "other.gif", str(THESIS_PRESET)
    words = [str(folder / "one.flac"), "-o", str(other), "--fps", "1", "--preset", preset, "--no-head"]
    assert main(["preview", *words, "--size", "120x90", "--view", "mouth", "--transparent"]) == 0
    assert (folder / "one.gif").read_bytes() == other.read_bytes()
    before = (folder / "one.gif").read_bytes()
    dialog.choices.rate.setValue(2)
    QTest.mouseClick(dialog.start, LEFT)
    assert dialog.question.text() == "one.gif already exists."
    dialog.question.reject()
    assert not dialog.queue.busy
    assert (folder / "one.gif").read_bytes() == before
    choose(dialog, "clip-png")
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    (folder / "one-pictures" / "000999.png").write_bytes((folder / "one-pictures" / "000000.png").read_bytes())
    QTest.mouseClick(dialog.start, LEFT)
    assert dialog.question.text() == "one-pictures already exists."
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.replace, LEFT)
    assert (folder / "one-pictures" / "000000.png").is_file()
    assert not (folder / "one-pictures" / "000999.png").exists()
    choose(dialog, "clip-mp4")
    QTest.mouseClick(dialog.start, LEFT)
    assert dialog.told.text().startswith("an .mp4 cannot have a transparent background")


def test_better_work_of_the_command_line_is_not_replaced_unasked(dialog, folder, qtbot):
    target = folder / "one.livelink.csv"
    words = ["--format", "livelink-csv", "--fps", "30", "--anticipation", "0"]
    assert main(["export", str(folder / "one.flac"), *words, "-o", str(target)]) == 0
    before = target.read_bytes()
    choose(dialog, "livelink-csv")
    QTest.mouseClick(dialog.start, LEFT)
    assert dialog.question.text() == "one.livelink.csv already exists."
    assert not dialog.queue.busy
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.keep, LEFT)
    assert dialog.told.text() == "1 done"
    assert target.read_bytes() == before
    QTest.mouseClick(dialog.start, LEFT)
    assert dialog.question.text() == "2 files already exist, such as two.livelink.csv."
    assert not dialog.keep.isVisible()
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.replace, LEFT)
    assert target.read_bytes() != before
    assert dialog.told.text() == "2 done"


def test_the_same_export_into_a_folder_is_not_asked_about_and_another_one_is(dialog, folder, qtbot, tmp_path):
    dialog.write_into(tmp_path / "out")
    choose(dialog, "rhubarb-tsv")
    for told in ("2 done", "2 already done"):
        with qtbot.waitSignal(dialog.queue.finished):
            QTest.mouseClick(dialog.start, LEFT)
        assert dialog.told.text() == told
    assert dialog.question is None
    dialog.choices.minimum.setValue(0.5)
    QTest.mouseClick(dialog.start, LEFT)
    assert dialog.question.text() == "2 files already exist, such as two.rhubarb.tsv."
    dialog.question.reject()
    assert not dialog.queue.busy


def test_a_report_says_how_right_the_preset_is_by_the_labels_beside_the_sound(dialog, folder, qtbot):
    choose(dialog, "report-html")
    labels = [Label(0.0, 2.0, "a", Phoneme.A), Label(2.0, 3.5, "", Phoneme.SILENCE)]
    write_labels(labels, folder / "one.csv", duration=3.5)
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    states = {job.source.name: job.state for job in dialog.queue.jobs}
    assert states == {"one.flac": ExportState.DONE, "two.flac": ExportState.FAILED}
    assert "Macro F1" in (folder / "one.report.html").read_text()
    assert "no label file beside this sound" in cells(dialog, 0)[3]
