"""Recorded faces in the window: a table says what is said, beside other drivers, and plays what it was made of."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QWidget

from phonemeanalyser.colours import LIGHT
from phonemeanalyser.desktop.talk.drivers.performance_model import FaceInHand
from phonemeanalyser.desktop.talk.words.voice_panel import VoicePanel
from phonemeengine.analyser import analyse_file
from phonemeengine.audio.files import SoundReader
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.mouth.animation import FaceDriver
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.transcript import Transcript, scripted_transcript_of
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.corpus import build_table
from phonemeengine.performance.driver import FACE
from phonemeengine.performance.style_fit import fit_style
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.track import PerformanceTrack, face_table, format_units
from tests.desktop.stage import START
from tests.desktop.talk.desk import SAID, Desk
from tests.engine.performance.corpora import write_recording
from tests.engine.performance.test_track import recorded

JAW = ARKIT.index("jawOpen")
LOUDER = 0.13
"""By how much loudness opens or shuts a jaw that is 0.4 open."""


@pytest.fixture
def table(tmp_path: Path) -> Path:
    """A table of what the voice says, whose jaw is 40 % open all the time."""
    write_table(tmp_path / "ann.sqlite", [recorded("so so.so", jaw=0.4)])
    return tmp_path / "ann.sqlite"


def settle(desk: Desk) -> None:
    """Wait until all is looked up."""
    performance = desk.texts.drivers.performance
    desk.qtbot.waitUntil(
        lambda: not (performance._opening.busy or performance._work.busy or performance._preparing.busy)
    )
    desk.wait()


def use(desk: Desk, table: Path) -> None:
    """Open a table."""
    desk.texts.drivers.performance.open(table)
    settle(desk)


def labelled(desk: Desk, folder: Path) -> None:
    """Have a sound in hand of which it is known what is said."""
    (folder / "said.TextGrid").write_text(format_utterance(SAID), encoding="utf-8")
    desk.open(folder)
    settle(desk)
    desk.stage.look()


def shown(desk: Desk) -> np.ndarray:
    """The weights of the first head now."""
    return desk.stage.talking.performer.at(desk.stage.now - START).weights


def test_a_table_that_is_opened_moves_the_head_and_is_named(desk: Desk, table: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    assert desk.stage.talking.head.caption == ""
    use(desk, table)
    assert desk.texts.drivers.main is FaceDriver.TABLE
    desk.stage.play(0.8)
    assert shown(desk)[JAW] == pytest.approx(0.4, abs=LOUDER)
    assert desk.stage.talking.head.caption == "ann"
    assert desk.stage.jaw == pytest.approx(40, abs=100 * LOUDER)
    assert desk.failed == []


def test_the_window_shows_what_commands_and_the_engine_show(desk: Desk, table: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    use(desk, table)
    with SoundReader(tmp_path / "said.wav") as reader:
        analyses = analyse_file(reader, desk.session.preset.in_force, pitch=True)
        utterance, speech = scripted_transcript_of(analyses, SAID, "said.wav", reader.duration)
    with PerformanceTable.open(table) as opened:
        track = PerformanceTrack(utterance, speech, opened)
        mouth, expected, seen = track.mouth(), [], []

        def look() -> None:
            if desk.session.source.playing:
                seen.append(shown(desk))
                expected.append(mouth.weights(desk.session.source.position))

        desk.stage.play(1.5, look)
        assert format_units(desk.texts.drivers.performance.units) == format_units(track.units())
    assert len(seen) > 50
    np.testing.assert_allclose(seen, expected, atol=1e-4)


def test_shoulders_and_tongue_are_moved_and_sent_where_a_table_moves_the_face(
    desk: Desk, table: Path, tmp_path: Path
) -> None:
    labelled(desk, tmp_path)
    assert desk.stage.talking.osc.performer.table.movestates == ARKIT
    use(desk, table)
    talking = desk.stage.talking
    assert {talking.performer.table.movestates, talking.osc.performer.table.movestates} == {FACE}
    assert talking.performer.table.shapes == face_table().shapes
    desk.texts.drivers.choose(FaceDriver.RULES)
    assert talking.osc.performer.table.movestates == ARKIT


def test_a_spoken_text_is_looked_up_before_it_is_heard(desk: Desk, table: Path) -> None:
    use(desk, table)
    desk.stage.look()
    desk.say("So. So so.")
    desk.stage.play(0.25)
    assert shown(desk)[JAW] == pytest.approx(0.4, abs=LOUDER)
    assert {unit.recording for unit in desk.texts.drivers.performance.units} == {"so so.so"}
    assert desk.failed == []


def test_two_heads_that_say_a_spoken_text_are_compared_by_numbers(desk: Desk, table: Path) -> None:
    use(desk, table)
    comparison = desk.stage.talking.comparison
    desk.texts.drivers.compare(FaceDriver.RULES)
    assert comparison.words == "Open a recording or speak a text to see where both heads differ"
    desk.say("So. So so.")
    desk.stage.play(0.25)
    desk.qtbot.waitUntil(lambda: comparison.found is not None)
    assert comparison.words.startswith("Difference (RMS): 0.")
    place = comparison.places[0]
    assert 0 < place.time < 1
    comparison.go_to(0)
    assert desk.session.source.position == pytest.approx(place.time, abs=0.01)
    assert desk.failed == []


def test_a_table_that_comes_while_a_text_is_spoken_is_for_the_next_one(desk: Desk, table: Path) -> None:
    desk.stage.look()
    desk.say("So. So so.")
    desk.stage.play(0.1)
    use(desk, table)
    assert any("press Speak" in sentence for sentence in desk.told)
    assert desk.stage.talking.head.caption == FaceDriver.RULES.caption or not desk.stage.talking.head.caption


def test_a_table_of_a_person_is_chosen_by_the_language_of_the_text(desk: Desk, tmp_path: Path) -> None:
    performance = desk.texts.drivers.performance
    for language in ("de", "en-us"):
        write_table(tmp_path / f"{language}.sqlite", [recorded("so")], person="Ann", language=language)
        use(desk, tmp_path / f"{language}.sqlite")
    button = QWidget()
    desk.qtbot.addWidget(button)
    box = VoicePanel(desk.texts.voice, desk.texts.drivers, LIGHT, button).table
    assert [box.itemText(k) for k in (1, 3)] == ["Ann, by the language of the text", "en-us, Ann, en-us"]
    box.setCurrentIndex(1)
    box.activated.emit(1)
    for tag in ("de", "en-gb", "fr"):
        desk.texts.set_language(tag)
        settle(desk)
        assert performance.name == {"de": "de", "en-gb": "en-us", "fr": "en-us"}[tag]
        assert desk.texts.drivers.exported.performance == (performance.chosen,)
        assert (box.currentIndex(), desk.failed) == (1, [])
    assert desk.told[-1].startswith("Ann has no table, or several, in the language of the text; en-us moves")
    performance.choose(tmp_path / "de.sqlite")
    settle(desk)
    assert (box.currentText(), performance.person) == ("de, Ann, de", "")


def test_what_the_table_lacks_is_said(desk: Desk, tmp_path: Path) -> None:
    write_table(tmp_path / "few.sqlite", [recorded("ma")])
    use(desk, tmp_path / "few.sqlite")
    desk.stage.look()
    desk.say("So. So so.")
    desk.stage.play(0.1)
    assert desk.told[0].startswith("few: the recordings have no [")
    assert len(desk.stage.talking.head.notes) == 2
    assert len(desk.told) == 1


def test_a_stopped_head_is_at_rest(desk: Desk, table: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    use(desk, table)
    desk.stage.play(0.8)
    desk.session.stop()
    desk.stage.wait(1.0)
    assert shown(desk)[JAW] < 0.02


def test_two_heads_say_the_same_in_step_by_other_means(desk: Desk, table: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    use(desk, table)
    talking, drivers = desk.stage.talking, desk.texts.drivers
    drivers.compare(FaceDriver.RULES)
    assert (talking.head.caption, talking.beside.caption) == ("ann", FaceDriver.RULES.caption)
    desk.stage.play(0.8)
    one, other = (head.performer.at(desk.stage.now - START) for head in (talking.head, talking.beside))
    assert one.weights[JAW] == pytest.approx(0.4, abs=LOUDER)
    assert one.weights[JAW] != other.weights[JAW] > 0
    assert one.blink == other.blink
    assert talking.beside.revision > 0
    drivers.choose(FaceDriver.RULES)
    drivers.compare(FaceDriver.TABLE)
    settle(desk)
    desk.stage.play(0.1)
    assert (talking.head.caption, talking.beside.caption) == (FaceDriver.RULES.caption, "ann")
    drivers.compare(None)
    assert (talking.comparing, talking.head.caption) == (False, "")
    assert desk.failed == []


def test_letters_have_nothing_to_go_by_where_nobody_speaks_chinese(desk: Desk, table: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    use(desk, table)
    desk.texts.drivers.compare(FaceDriver.PINYIN)
    (sentence,) = desk.failed
    assert "Chinese" in sentence
    assert desk.stage.talking.beside.caption == FaceDriver.RULES.caption


def test_another_choice_of_examples_is_looked_up_anew(desk: Desk, tmp_path: Path) -> None:
    write_table(tmp_path / "many.sqlite", [recorded("so", jaw=k / 20) for k in range(15)])
    labelled(desk, tmp_path)
    use(desk, tmp_path / "many.sqlite")
    performance = desk.texts.drivers.performance
    before = performance.units
    performance.set_choice(ExampleChoice.RANDOM)
    settle(desk)
    assert performance.units != before


def test_no_table_leaves_the_head_to_the_sounds_again(desk: Desk, table: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    use(desk, table)
    performance = desk.texts.drivers.performance
    performance.choose(None)
    assert (desk.texts.drivers.main, performance.units, performance.name) == (FaceDriver.RULES, (), "")
    performance.choose(table)
    settle(desk)
    assert desk.texts.drivers.main is FaceDriver.TABLE


# -- bad tables ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("content", [b"", b"SQLite format 3\0" + bytes(200), b"not a table"])
def test_what_is_no_table_is_refused_in_a_sentence(desk: Desk, tmp_path: Path, table: Path, content: bytes) -> None:
    use(desk, table)
    (tmp_path / "bad.sqlite").write_bytes(content)
    use(desk, tmp_path / "bad.sqlite")
    (sentence,) = desk.failed
    assert sentence.startswith("bad.sqlite: ")
    assert desk.texts.drivers.performance.chosen == table


def test_a_table_that_fails_while_it_is_used_is_told_and_the_sounds_go_on(
    desk: Desk, table: Path, tmp_path: Path
) -> None:
    labelled(desk, tmp_path)
    use(desk, table)
    opened = desk.texts.drivers.performance.table
    assert opened is not None
    opened.close()  # as if its disk were gone
    desk.texts.drivers.performance.set_choice(ExampleChoice.RANDOM)
    settle(desk)
    (sentence,) = desk.failed
    assert sentence.startswith("ann.sqlite: ")
    desk.stage.play(0.8)
    assert desk.texts.drivers.performance.face is None
    assert shown(desk)[JAW] > 0.02


def test_a_face_that_fails_in_the_middle_is_at_rest_and_says_why(desk: Desk, table: Path, tmp_path: Path) -> None:
    with PerformanceTable.open(table) as opened:
        face = FaceInHand(PerformanceTrack(SAID, Transcript("", SAID.duration), opened).mouth())
    assert not face.weights(0.8).any()
    assert face.head(0.8) is None
    assert face.failure.startswith("ann.sqlite: ")
    labelled(desk, tmp_path)
    use(desk, table)
    desk.texts.drivers.performance.face = face
    desk.stage.talking.tick()
    assert desk.failed == [face.failure]
    assert desk.texts.drivers.performance.face is None


# -- the recordings themselves ------------------------------------------------------------------------


@pytest.fixture
def corpus(tmp_path: Path) -> Path:
    """A table with its recording: the word "mami" with a jaw that opens from 0 to 1 within a second."""
    folder = tmp_path / "corpus"
    folder.mkdir()
    write_recording(folder)
    build_table(folder, tmp_path / "corpus.sqlite", name="mia")
    return tmp_path / "corpus.sqlite"


def test_a_unit_is_heard_and_seen_as_it_was_recorded(desk: Desk, corpus: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    use(desk, corpus)
    desk.session.play()
    unit = desk.texts.drivers.performance.units[0]
    original, talking = desk.texts.original, desk.stage.talking
    with desk.qtbot.waitSignal(original.changed):
        desk.texts.original.play(unit, whole=True)
    assert not desk.session.source.playing
    assert talking.head.caption == "mami, original recording from mia"
    output = desk.stage.outputs.last
    desk.qtbot.waitUntil(lambda: output.n_written > 22050)
    output.move(22050)
    talking.tick()
    assert original.position == pytest.approx(0.5, abs=0.01)
    assert shown(desk)[JAW] == pytest.approx(0.5, abs=0.02)
    desk.qtbot.waitUntil(lambda: output.n_written >= 44100)
    output.move(22050)
    talking.tick()
    assert original.face is None
    assert talking.head.caption == "mia"


def test_the_sound_in_hand_goes_before_a_recording(desk: Desk, corpus: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    use(desk, corpus)
    with desk.qtbot.waitSignal(desk.texts.original.changed):
        desk.texts.original.play(desk.texts.drivers.performance.units[1])
    desk.session.play()
    assert desk.texts.original.face is None


def test_a_recording_without_its_sound_is_seen_and_that_is_said(desk: Desk, corpus: Path, tmp_path: Path) -> None:
    labelled(desk, tmp_path)
    use(desk, corpus)
    (tmp_path / "corpus").rename(tmp_path / "elsewhere")
    original = desk.texts.original
    with desk.qtbot.waitSignal(original.changed):
        desk.texts.original.play(desk.texts.drivers.performance.units[1])
    (sentence,) = desk.failed
    assert "put the recordings back" in sentence

    def over() -> bool:
        desk.stage.talking.tick()
        return original.face is None

    desk.qtbot.waitUntil(over)


def test_a_style_is_fitted_to_the_recordings_in_use(desk: Desk, table: Path) -> None:
    performance, styles = desk.texts.drivers.performance, desk.stage.talking.styles
    performance.fit_style(styles.take)
    assert desk.failed[0].startswith("There are no recorded faces to fit the style to")
    use(desk, table)
    performance.fit_style(styles.take)
    desk.qtbot.waitUntil(lambda: "a mouth that moves" in desk.failed[-1])
    write_recording(table.parent)
    build_table(table.parent, table.with_name("mami.sqlite"))
    use(desk, table.with_name("mami.sqlite"))
    performance.fit_style(styles.take)
    desk.qtbot.waitUntil(lambda: any(words.startswith("The style is fitted to 1 s") for words in desk.told))
    with PerformanceTable.open(table.with_name("mami.sqlite")) as opened:
        fitted = fit_style((found for _, found in opened.recordings()), "neutral").style
    assert (styles.style, styles.is_edited("neutral")) == (replace(fitted, notes=styles.style.notes), True)
    desk.session.preset.undo_stack.undo()
    assert not styles.is_edited("neutral")
