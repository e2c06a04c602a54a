"""The words of a sound: from files beside it, an aligner or a voice, all as one utterance that the head says."""

import shlex
import sys
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.words.scripts import words_beside
from phonemeanalyser.desktop.talk.words.sound_words import KnownWords
from phonemeanalyser.desktop.talk.words.text_model import POOR, TextTools, fits_badly
from phonemeanalyser.desktop.talk.words.voice_model import FASTEST, VoiceModel
from phonemeengine.analyser import Analysis
from phonemeengine.errors import VoiceError
from phonemeengine.labels.boundaries import LabelUnit, spans_of
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.labels.utterance import UNKNOWN_WORD, Phone, Syllable, Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.phonemes import Phoneme
from tests.desktop.sessions import settled
from tests.desktop.stage import AN_A
from tests.desktop.talk.desk import DURATION, SAID, Desk
from tests.desktop.talk.voices import SENTENCE, word


def syllable(text: str, pinyin: str, start: float, end: float) -> Word:
    """A Chinese character: one syllable of an h and an a."""
    turn = (start + end) / 2
    phones = (Phone(start, turn, "x", Phoneme.UNIDENTIFIED), Phone(turn, end, "aʊ", Phoneme.A))
    return Word(text, (Syllable(phones, 0, pinyin),))


# -- labels and scripts beside a sound ----------------------------------------------------------------


def test_labels_beside_a_sound_are_its_words(desk, tmp_path):
    (tmp_path / "said.TextGrid").write_text(format_utterance(SAID), encoding="utf-8")
    desk.open(tmp_path)
    assert desk.words() == ["so", "oh"]
    assert np.allclose(spans_of(desk.texts.utterance, LabelUnit.WORD), spans_of(SAID, LabelUnit.WORD), atol=1e-6)


def test_a_script_beside_a_sound_is_its_text(desk, tmp_path):
    (tmp_path / "said.txt").write_text("so oh\n", encoding="utf-8")
    desk.open(tmp_path)
    assert desk.texts.text.strip() == "so oh"
    assert desk.texts.utterance is None


def test_words_with_times_beside_a_sound_are_aligned_in_these_until_the_text_is_edited(desk, tmp_path):
    words = {"words": [(0.2, 0.5, "so"), (0.6, 0.9, "oh")]}
    (tmp_path / "said.TextGrid").write_text(format_tiers(words, DURATION), encoding="utf-8")
    desk.open(tmp_path)
    assert (desk.texts.text, desk.texts.utterance) == ("so oh", None)
    desk.align()
    assert [(word.text, word.start, word.end) for word in desk.aligner.asked[-1].timed] == [
        ("so", 0.2, 0.5), ("oh", 0.6, 0.9),
    ]  # fmt: skip
    desk.align("so oh oh")
    assert desk.aligner.asked[-1].timed == ()


MFA = {
    "mary - words": [(0.2, 0.5, "so")], "mary - phones": [(0.2, 0.3, "s"), (0.3, 0.5, "o")],
    "john - words": [(0.6, 0.9, "oh")], "john - phones": [(0.6, 0.9, "o")],
}  # fmt: skip


def test_of_labels_of_several_people_one_is_chosen(desk, tmp_path):
    (tmp_path / "said.TextGrid").write_text(format_tiers(MFA, DURATION), encoding="utf-8")
    desk.open(tmp_path)
    assert desk.texts.speakers == ("mary", "john")
    assert (desk.texts.utterance, desk.failed) == (None, [])
    assert "Several people speak" in desk.told[-1]
    for name, said in (("john", "oh"), ("mary", "so")):
        desk.texts.choose_speaker(name)
        desk.wait()
        assert (desk.words(), desk.texts.text, desk.texts.speaker) == ([said], said, name)
    desk.session.preset.undo_stack.undo()
    assert desk.words() == ["oh"]


def test_a_script_is_opened_for_the_sound_in_hand(desk, tmp_path):
    text, words, labels = (tmp_path / name for name in ("a.txt", "a.json", "b.TextGrid"))
    text.write_text("oh so", encoding="utf-8")
    words.write_text('{"words": [{"word": "Oh,", "start": 0.2, "end": 0.5}]}', encoding="utf-8")
    labels.write_text(format_utterance(SAID), encoding="utf-8")
    desk.texts.open_script(text)
    assert "There is no sound file in hand" in desk.failed[-1]
    desk.open(tmp_path)
    for script, shown, said in ((text, "oh so", []), (words, "Oh,", []), (labels, "so oh", ["so", "oh"])):
        desk.texts.open_script(script)
        desk.wait()
        assert (desk.texts.text, desk.words()) == (shown, said)
    (tmp_path / "c.json").write_text("{}", encoding="utf-8")
    desk.texts.open_script(tmp_path / "c.json")
    desk.wait()
    assert "c.json: there is no word with a time in it" in desk.failed[-1]
    assert (desk.texts.text, desk.words()) == ("so oh", ["so", "oh"])


def test_damaged_labels_beside_a_sound_are_said_and_the_sound_is_in_hand(desk, tmp_path):
    (tmp_path / "said.TextGrid").write_text("nonsense", encoding="utf-8")
    desk.open(tmp_path)
    assert "said.TextGrid" in desk.failed[0]
    assert desk.session.path == tmp_path / "said.wav"


def test_labels_that_were_made_meanwhile_are_found_when_the_sound_is_opened_again(desk, tmp_path):
    (tmp_path / "said.txt").write_text("so oh", encoding="utf-8")
    desk.open(tmp_path)
    desk.texts.set_text("what I write")
    (tmp_path / "said.TextGrid").write_text(format_utterance(SAID), encoding="utf-8")
    desk.open(tmp_path)
    assert desk.words() == ["so", "oh"]
    assert desk.texts.text == "what I write"


def test_another_sound_has_other_words(desk, tmp_path):
    (tmp_path / "said.TextGrid").write_text(format_utterance(SAID), encoding="utf-8")
    desk.open(tmp_path)
    (tmp_path / "other").mkdir()
    desk.open(tmp_path / "other")
    assert desk.texts.utterance is None


def test_words_stay_while_another_source_is_heard_for_a_while(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.session.set_source(SourceKind.TONE)
    assert desk.words() == []
    desk.session.set_source(SourceKind.FILE)
    assert desk.words() == ["so", "oh"]


# -- a script and its recording -----------------------------------------------------------------------


def test_a_text_is_aligned_with_the_sound_in_hand(desk, tmp_path):
    desk.open(tmp_path)
    desk.align("so oh", "en-us")
    asked = desk.aligner.asked[0]
    assert (asked.sound, asked.text, asked.language) == (tmp_path / "said.wav", "so oh", "en-us")
    assert desk.words() == ["so", "oh"]


def test_a_text_whose_language_is_not_chosen_is_refused_in_a_sentence(desk, tmp_path):
    desk.open(tmp_path)
    desk.align("so oh", "")
    assert "language" in desk.failed[0]
    assert desk.aligner.asked == []


@pytest.mark.parametrize("text", ["", "  \n\t "])
def test_no_text_is_refused_in_a_sentence(desk, tmp_path, text):
    desk.open(tmp_path)
    desk.align(text)
    desk.say(text)
    assert len(desk.failed) == 2
    assert desk.voice.asked == []


def test_without_a_sound_there_is_nothing_to_align_with(desk):
    desk.align()
    assert "no sound file" in desk.failed[0]


def test_words_that_nobody_says_are_told(desk, tmp_path):
    desk.open(tmp_path)
    desk.aligner.found = Utterance(SAID.words, DURATION, "en-us", ("never", "ever"))
    desk.align()
    assert desk.told == ["Nobody says: never ever."]


def test_another_text_is_said_to_be_one_and_changes_nothing(desk, tmp_path):
    desk.open(tmp_path)
    desk.aligner.found = Utterance((word(UNKNOWN_WORD, 0.6, 1.1),), DURATION, "en-us", ("never",))
    desk.align()
    assert "Another text" in desk.failed[0]
    assert desk.texts.utterance is None


def test_a_refused_text_can_be_aligned_anyway(desk, tmp_path):
    desk.open(tmp_path)
    desk.aligner.found = Utterance((word(UNKNOWN_WORD, 0.6, 1.1),), DURATION, "en-us", ("never",))
    desk.align("so oh")
    assert desk.texts.refused is not None
    desk.aligner.found = SAID
    desk.texts.align_anyway()
    desk.wait()
    assert [asked.accepted for asked in desk.aligner.asked] == [False, True]
    assert (desk.words(), desk.texts.refused) == (["so", "oh"], None)


@pytest.mark.parametrize("change", ["text", "language", "literal", "sound"])
def test_what_was_refused_is_forgotten_when_it_changes(desk, tmp_path, change):
    desk.open(tmp_path)
    desk.aligner.found = Utterance((word(UNKNOWN_WORD, 0.6, 1.1),), DURATION, "en-us", ("never",))
    desk.align("so oh")
    (tmp_path / "other").mkdir()
    changes = {
        "text": lambda: desk.texts.set_text("so"),
        "language": lambda: desk.texts.set_language("de"),
        "literal": lambda: desk.texts.set_literal(True),
        "sound": lambda: desk.open(tmp_path / "other"),
    }
    changes[change]()
    assert desk.texts.refused is None


def test_a_literal_script_is_aligned_and_spoken_as_it_is(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.set_literal(True)
    desk.align()
    assert desk.aligner.asked[0].literal
    assert desk.texts._voice.literal


def test_an_alignment_of_a_sound_that_is_no_longer_in_hand_is_dropped(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.set_text("so oh")
    desk.texts.set_language("en-us")
    desk.texts.align()
    (tmp_path / "other").mkdir()
    desk.open(tmp_path / "other")
    assert desk.texts.utterance is None


def test_words_that_fit_badly_and_those_of_no_script_are_marked():
    assert not fits_badly(word("so", 0, 1, POOR - 0.1))
    assert not fits_badly(word("so", 0, 1, None))
    assert fits_badly(word("so", 0, 1, POOR + 0.1))
    assert fits_badly(word(UNKNOWN_WORD, 0, 1, 0.0))


def test_how_many_words_fit_badly_is_said(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    assert desk.texts.summary == "2 words, 1 fits badly"


# -- the head says what is known ----------------------------------------------------------------------


def test_the_head_says_the_words_rather_than_what_is_recognised(desk, tmp_path):
    """All of it is recognised as an a, whose jaw is open; the words say p."""
    desk.open(tmp_path)
    desk.stage.look()
    shut = word("so", 0.6, 1.1)
    phones = tuple(part.__class__(part.start, part.end, "p", Phoneme.P) for part in shut.phones)
    shut = shut.__class__("p", (shut.syllables[0].__class__(phones),))
    desk.texts.words.edit(Utterance((shut,), DURATION), "shut", by_hand=False)
    jaws: list[float] = []
    desk.stage.play(10, lambda: jaws.append(desk.stage.jaw))
    assert desk.stage.said_an_a
    assert max(jaws) < 10


def test_a_boundary_that_is_dragged_while_the_sound_plays_leaves_the_mouth_moving(desk, tmp_path):
    desk.open(tmp_path)
    desk.stage.look()
    desk.align()
    jaws: list[float] = []
    desk.stage.play(0.4)
    desk.texts.move_boundary(LabelUnit.WORD, 2, 0.95)
    desk.stage.play(10, lambda: jaws.append(desk.stage.jaw))
    assert max(jaws) > 5


# -- by hand ------------------------------------------------------------------------------------------


def test_a_dragged_boundary_is_undone_and_done_again(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    stack = desk.session.preset.undo_stack
    desk.texts.move_boundary(LabelUnit.WORD, 2, 0.8)
    assert stack.undoText() == "boundary of a word"
    assert spans_of(desk.texts.utterance, LabelUnit.WORD)[0] == pytest.approx((0.6, 0.8))
    stack.undo()
    assert desk.texts.utterance is SAID
    stack.redo()
    assert spans_of(desk.texts.utterance, LabelUnit.WORD)[1] == pytest.approx((0.8, 1.1))


def test_an_alignment_is_undone(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.session.preset.undo_stack.undo()
    assert desk.texts.utterance is None


def test_an_edit_of_a_sound_that_is_no_longer_in_hand_changes_nothing(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    (tmp_path / "other").mkdir()
    desk.open(tmp_path / "other")
    desk.session.preset.undo_stack.undo()
    assert desk.texts.utterance is None
    assert not desk.session.preset.undo_stack.canRedo()


def test_a_boundary_cannot_leave_nothing_of_a_word(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.move_boundary(LabelUnit.WORD, 2, 0.5)
    assert desk.texts.utterance is SAID
    assert "leave nothing" in desk.failed[0]


def test_what_was_dragged_is_what_is_saved(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.move_boundary(LabelUnit.WORD, 2, 0.8)
    assert desk.texts.save_words(tmp_path / "said.TextGrid")
    written = read_utterance(tmp_path / "said.TextGrid", DURATION)
    assert np.allclose(spans_of(written, LabelUnit.WORD), spans_of(desk.texts.utterance, LabelUnit.WORD), atol=1e-6)
    assert "said.TextGrid" in desk.told[-1]


def test_what_was_moved_by_hand_is_unsaved_until_it_is_saved_or_taken_back(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    assert not desk.texts.words.has_unsaved_changes  # the program finds it again
    desk.texts.move_boundary(LabelUnit.WORD, 2, 0.8)
    assert desk.texts.words.has_unsaved_changes
    desk.session.preset.undo_stack.undo()
    assert not desk.texts.words.has_unsaved_changes
    desk.session.preset.undo_stack.redo()
    assert desk.texts.save_words(tmp_path / "said.TextGrid")
    assert not desk.texts.words.has_unsaved_changes
    desk.texts.move_boundary(LabelUnit.WORD, 2, 0.7)
    assert desk.texts.words.has_unsaved_changes


def test_words_that_cannot_be_saved_stay_unsaved(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.move_boundary(LabelUnit.WORD, 2, 0.8)
    assert not desk.texts.save_words(tmp_path / "gone" / "said.TextGrid")
    assert "said.TextGrid" in desk.failed[0]
    assert desk.texts.words.has_unsaved_changes


def test_a_text_that_is_spoken_meanwhile_leaves_moved_boundaries_as_they_are(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.move_boundary(LabelUnit.WORD, 2, 0.8)
    moved = desk.texts.utterance
    desk.say("Hello.")
    desk.say("You there.")
    assert desk.texts.words.has_unsaved_changes
    desk.session.set_source(SourceKind.FILE)
    assert desk.texts.utterance is moved


def test_a_sound_that_may_not_be_left_stays_in_hand(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    (tmp_path / "other").mkdir()
    other = tmp_path / "other" / "said.wav"
    other.write_bytes((tmp_path / "said.wav").read_bytes())
    desk.session.may_leave = lambda: False
    assert not desk.session.open(other)
    assert desk.session.path == tmp_path / "said.wav"
    assert desk.words() == ["so", "oh"]


def test_syllables_of_pinyin_are_saved_with_their_pinyin(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.words.edit(Utterance((syllable("好", "hao3", 0.6, 1.1),), DURATION, "cmn"), "pinyin", by_hand=True)
    desk.texts.save_words(tmp_path / "said.TextGrid")
    again = words_beside(tmp_path / "said.wav", DURATION).utterance
    assert again is not None
    assert [said.text for spoken in again.words for said in spoken.syllables] == ["hao3"]


def test_a_word_that_is_played_ends_where_it_ends(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    heard: list[Analysis] = []
    desk.session.heard.connect(heard.extend)
    desk.texts.play(0.6, 0.9)
    assert desk.session.source.playing
    desk.stage.play(2.0)
    assert not desk.session.source.playing
    assert (heard[0].start, heard[-1].start + len(heard[-1])) == (60, 90)
    assert desk.session.source.position == 0.6


# -- a voice ------------------------------------------------------------------------------------------


def test_a_voice_is_a_source_like_a_file(desk):
    desk.say("Hello. You there.")
    assert desk.session.source.kind is SourceKind.TEXT
    assert desk.session.source.playing
    assert desk.voice.asked == [("Hello. You there.", "en-us")]
    desk.stage.play(10)
    assert desk.stage.said_an_a
    assert desk.session.source.duration == pytest.approx(2 * SENTENCE)


def test_what_a_voice_says_is_known_with_its_times(desk):
    desk.stage.look()
    desk.say("Hello. You there.")
    desk.stage.play(10)
    assert desk.words() == ["Hello", "You there"]
    assert spans_of(desk.texts.utterance, LabelUnit.WORD)[1] == pytest.approx((0.6, 0.9))
    assert not desk.texts.editable


def test_the_head_says_what_the_voice_says(desk):
    desk.stage.look()
    jaws: list[float] = []
    desk.say("Hello. You there.")
    desk.stage.play(10, lambda: jaws.append(desk.stage.jaw))
    assert max(jaws) > 5


def test_a_spoken_text_can_be_gone_through(desk):
    desk.say("Hello. You there.")
    desk.stage.play(0.8)
    desk.session.pause()
    desk.session.seek(0.2)
    settled(desk.session, desk.qtbot)
    assert desk.session.source.position == pytest.approx(0.2)
    desk.session.stop()
    settled(desk.session, desk.qtbot)
    assert desk.session.source.position == 0


def test_a_language_that_no_voice_speaks_is_refused_and_the_sound_in_hand_stays(desk, tmp_path):
    desk.open(tmp_path)
    desk.say("Hello.", "xx")
    assert "xx" in desk.failed[0]
    assert desk.session.source.kind is SourceKind.FILE


def test_choosing_the_text_as_source_has_it_said(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.set_text("Hello.")
    desk.texts.set_language("en-us")
    desk.session.set_source(SourceKind.TEXT)
    desk.qtbot.waitUntil(lambda: desk.session.source.playing)
    assert desk.voice.asked == [("Hello.", "en-us")]


def test_a_file_goes_on_from_where_it_was_left_before_a_text_was_spoken(desk, tmp_path):
    desk.open(tmp_path)
    desk.session.seek(0.5)
    settled(desk.session, desk.qtbot)
    desk.say("Hello.")
    desk.session.set_source(SourceKind.FILE)
    settled(desk.session, desk.qtbot)
    assert desk.session.source.position == pytest.approx(0.5)


def test_chinese_characters_tell_their_language(desk):
    desk.say("你好。", "")
    assert desk.voice.asked == [("你好。", "cmn")]


def test_the_voice_that_is_chosen_speaks_at_the_rate_that_is_chosen(desk):
    desk.texts.voice.choose(name="f2", rate=6.0)
    desk.say("Hello.")
    desk.texts.voice.choose(rate=100.0)
    desk.say("Hello.")
    assert [(choice.name, choice.rate) for choice in desk.voice.choices] == [("f2", 6.0), ("f2", FASTEST)]


def test_chinese_moves_the_mouth_by_letters_unless_sounds_are_chosen(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.words.put(KnownWords(Utterance((syllable("好", "hao3", 0.6, 1.1),), DURATION, "cmn")))
    drivers = (FaceDriver.AUTO, FaceDriver.RULES, FaceDriver.PINYIN)
    by_letters = []
    for driver in drivers:
        desk.texts.drivers.choose(driver)
        by_letters.append(desk.texts.drivers.letters is not None)
    assert by_letters == [True, False, True]
    assert desk.failed == []


def test_letters_of_pinyin_for_another_language_are_refused_and_its_sounds_move_the_mouth(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.drivers.choose(FaceDriver.PINYIN)
    assert desk.texts.drivers.letters is None
    assert "pinyin" in desk.failed[0].lower()


def test_a_spoken_text_is_saved_as_a_sound_with_its_words_and_opened_again(desk, tmp_path):
    saved: list[str] = []
    desk.texts.speech_saved.connect(saved.append)
    desk.texts.set_text("Hello. You there.")
    desk.texts.set_language("en-us")
    desk.texts.save_speech(tmp_path / "spoken.wav")
    desk.wait()
    assert saved == [str(tmp_path / "spoken.wav")]
    assert desk.session.open(tmp_path / "spoken.wav")
    desk.wait()
    assert desk.session.source.duration == pytest.approx(2 * SENTENCE)
    assert desk.words() == ["Hello", "You there"]
    assert spans_of(desk.texts.utterance, LabelUnit.WORD)[1] == pytest.approx((0.6, 0.9), abs=1e-6)
    assert desk.texts.editable


def test_labels_of_others_beside_a_spoken_sound_stay(desk, tmp_path):
    diary = tmp_path / "spoken.TextGrid"
    diary.write_text("a diary")
    desk.texts.set_text("Hello. You there.")
    desk.texts.set_language("en-us")
    desk.texts.save_speech(tmp_path / "spoken.wav")
    desk.wait()
    assert desk.failed == [
        "spoken.TextGrid: it is beside the sound and would be replaced; choose another name for the sound"
    ]
    assert diary.read_text() == "a diary"
    diary.unlink()
    for _ in range(2):
        desk.texts.save_speech(tmp_path / "spoken.wav")
        desk.wait()
    assert len(desk.failed) == 1


@pytest.mark.parametrize(
    ("language", "place"), [("xx", "spoken.wav"), ("en-us", "gone/spoken.wav"), ("en-us", "a.mp3")]
)
def test_a_text_that_cannot_be_saved_leaves_nothing_behind(desk, tmp_path, language, place):
    desk.texts.set_text("Hello.")
    desk.texts.set_language(language)
    desk.texts.save_speech(tmp_path / place)
    desk.wait()
    assert len(desk.failed) == 1
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


def test_phonemes_of_a_spoken_text_are_saved_as_those_of_a_file_are(desk, tmp_path):
    desk.say("Hello. You there.")
    spoken = desk.session.source
    desk.session.writer.write(spoken.name, spoken.reopen, desk.session.preset.in_force, tmp_path / "spoken.csv")
    desk.qtbot.waitUntil(lambda: not desk.session.writer.busy)
    labels = read_labels(tmp_path / "spoken.csv")
    assert labels[-1].end == pytest.approx(2 * SENTENCE)
    assert Phoneme.A in {label.phoneme for label in labels}


# -- a program of one's own ---------------------------------------------------------------------------


def own_program(folder: Path, body: str) -> str:
    """Write a text-to-speech program; gives the command that runs it."""
    (folder / "program.py").write_text(f"import sys\nout, text = sys.argv[1:]\n{body}\n", encoding="utf-8")
    python, program = (shlex.quote(str(path)) for path in (sys.executable, folder / "program.py"))
    return f"{python} {program} {{output}} {{text}}"


def test_a_program_of_ones_own_speaks_with_the_words_that_it_writes(desk, tmp_path):
    soundfile.write(tmp_path / "voice.wav", AN_A, 44100)
    (tmp_path / "voice.TextGrid").write_text(format_utterance(SAID), encoding="utf-8")
    body = (
        f"import shutil\nshutil.copy({str(tmp_path / 'voice.wav')!r}, out)\n"
        f"shutil.copy({str(tmp_path / 'voice.TextGrid')!r}, out[:-4] + '.TextGrid')"
    )
    desk.texts.tools = TextTools(desk.aligner.align)
    desk.texts.voice.choose(program=own_program(tmp_path, body), by_program=True)
    desk.say("so oh")
    desk.stage.play(10)
    assert desk.failed == []
    assert desk.words() == ["so", "oh"]
    assert desk.stage.said_an_a


@pytest.mark.parametrize(
    ("body", "reason"), [("sys.exit('no licence')", "no licence"), ("pass", "wrote no sound file")]
)
def test_a_program_that_fails_is_told_in_a_sentence_and_the_sound_in_hand_stays(desk, tmp_path, body, reason):
    desk.open(tmp_path)
    desk.texts.tools = TextTools(desk.aligner.align)
    desk.texts.voice.choose(program=own_program(tmp_path, body), by_program=True)
    desk.say("so oh")
    assert reason in desk.failed[0]
    assert desk.session.source.kind is SourceKind.FILE


def test_the_program_ends_though_a_program_of_ones_own_speaks_for_ever(session, outputs, qtbot, tmp_path):
    desk = Desk(session, outputs, qtbot)
    started, end = tmp_path / "started", tmp_path / "end"
    hangs = (
        "import pathlib, time\n"
        f"pathlib.Path({str(started)!r}).touch()\n"
        f"while not pathlib.Path({str(end)!r}).exists(): time.sleep(0.02)"
    )
    desk.texts.tools = TextTools(desk.aligner.align)
    desk.texts.voice.choose(program=own_program(tmp_path, hangs), by_program=True)
    desk.texts.set_text("so oh")
    desk.texts.say()
    qtbot.waitUntil(started.exists)
    desk.stage.talking.close()
    end.touch()


def test_a_command_without_a_place_for_the_sound_is_refused(desk):
    desk.texts.tools = TextTools(desk.aligner.align)
    desk.texts.voice.choose(program="my-voice", by_program=True)
    desk.say("so oh")
    assert "{output}" in desk.failed[0]


# -- what there is to choose --------------------------------------------------------------------------


def test_the_languages_are_learnt_once_and_of_several_tags_one_is_shown(desk):
    desk.texts.voice.wake()
    desk.texts.voice.wake()
    desk.wait()
    assert {language.tag for language in desk.texts.voice.installed.languages} == {"de", "en-gb", "en-us"}


def test_without_a_voice_a_sentence_says_what_is_missing(qtbot):
    def missing() -> tuple[()]:
        raise VoiceError("there is no voice; install it")

    voice = VoiceModel(missing)
    voice.wake()
    qtbot.waitUntil(lambda: bool(voice.lack))
    assert voice.lack == "there is no voice; install it"
    voice.close()


def test_a_lexicon_goes_before_the_voice_until_it_is_given_up(desk, tmp_path):
    (tmp_path / "mine.csv").write_text("word,ipa\nso,soʊ\n", encoding="utf-8")
    desk.open(tmp_path)
    desk.texts.set_lexicon(tmp_path / "mine.csv")
    desk.wait()
    desk.align()
    desk.texts.set_lexicon(None)
    desk.align()
    assert [asked.lexicon is not None for asked in desk.aligner.asked] == [True, False]


def test_a_voice_reads_by_the_lexicon_too(desk, tmp_path):
    (tmp_path / "mine.csv").write_text("word,ipa\nso,soʊ\n", encoding="utf-8")
    desk.texts.set_lexicon(tmp_path / "mine.csv")
    desk.wait()
    desk.texts.set_text("So.")
    desk.texts.set_language("en-gb")
    desk.texts.say()
    desk.wait()
    assert desk.voice.choices[-1].lexicon is not None


def test_a_lexicon_with_nonsense_is_refused(desk, tmp_path):
    (tmp_path / "mine.csv").write_text("nonsense\n", encoding="utf-8")
    desk.texts.set_lexicon(tmp_path / "mine.csv")
    desk.wait()
    assert "mine.csv" in desk.failed[0]
    assert desk.texts.lexicon_path is None
