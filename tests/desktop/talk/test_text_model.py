"""The words of a sound: from files beside it, an aligner or a voice, all as one utterance that the head says."""

import numpy as np
import pytest

from phonemeanalyser.cli.window import DEMO
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.words.scripts import words_beside
from phonemeanalyser.desktop.talk.words.sound_words import POOR, fits_badly
from phonemeanalyser.desktop.talk.words.written_text import WrittenText
from phonemeengine.analyser import Analysis
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.labels.utterance import UNKNOWN_WORD, LabelUnit, Utterance, spans_of
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.phonemes import Phoneme
from tests.desktop.talk.desk import DURATION, SAID
from tests.desktop.talk.voices import syllable, word

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
        ("so", 0.2, 0.5),
        ("oh", 0.6, 0.9),
    ]
    desk.align("so oh oh")
    assert desk.aligner.asked[-1].timed == ()


MFA = {
    "mary - words": [(0.2, 0.5, "so")],
    "mary - phones": [(0.2, 0.3, "s"), (0.3, 0.5, "o")],
    "john - words": [(0.6, 0.9, "oh")],
    "john - phones": [(0.6, 0.9, "o")],
}


def test_of_labels_of_several_people_one_is_chosen(desk, tmp_path):
    (tmp_path / "said.TextGrid").write_text(format_tiers(MFA, DURATION), encoding="utf-8")
    desk.open(tmp_path)
    assert desk.texts.speakers == ("mary", "john")
    assert (desk.texts.utterance, desk.failed) == (None, [])
    assert "several speakers" in desk.told[-1]
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
    assert "No audio file is open" in desk.failed[-1]
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
    assert desk.failed[0].startswith("No audio file is open")


def test_words_that_nobody_says_are_told(desk, tmp_path):
    desk.open(tmp_path)
    desk.aligner.found = Utterance(SAID.words, DURATION, "en-us", ("never", "ever"))
    desk.align()
    assert desk.told == ["Not spoken in the recording: never ever."]


def test_another_text_is_said_to_be_one_and_changes_nothing(desk, tmp_path):
    desk.open(tmp_path)
    desk.aligner.found = Utterance((word(UNKNOWN_WORD, 0.6, 1.1),), DURATION, "en-us", ("never",))
    desk.align()
    assert "doesn’t match this text" in desk.failed[0]
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


def test_words_that_fit_badly_are_gone_through(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    assert [said.text for said in desk.texts.edits.poor] == ["oh"]
    desk.texts.edits.show_poor(1)
    assert desk.session.source.position == 0.9


def test_lanes_are_stale_once_other_words_are_written_and_not_for_marks_alone(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    assert not desk.texts.stale
    desk.texts.set_text("So, oh!")
    assert not desk.texts.stale
    desk.texts.set_text("so what")
    assert desk.texts.stale
    desk.align("so what")
    assert not desk.texts.stale
    desk.session.preset.undo_stack.undo()
    assert desk.texts.stale


def test_a_text_belongs_to_its_sound_and_comes_back_with_it(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.set_text("so oh")
    desk.texts.set_language("en-us")
    (tmp_path / "other").mkdir()
    desk.open(tmp_path / "other")
    assert desk.texts.text == ""
    desk.texts.set_text("und das ist nicht der Text")
    assert desk.texts.written.spoken_in == "de"
    desk.stage.open(tmp_path)
    desk.texts.follow_sound()  # once more, and the settings are saved, before the text is found
    desk.texts.written.remember()
    desk.wait()
    assert (desk.texts.text, desk.texts.written.language) == ("so oh", "en-us")


def test_a_text_that_was_written_before_a_sound_was_open_waits_for_it(desk, tmp_path):
    desk.texts.set_text("so oh")
    desk.open(tmp_path)
    assert desk.texts.text == "so oh"


def test_a_text_from_a_file_that_was_changed_is_unsaved(desk, tmp_path):
    (tmp_path / "said.txt").write_text("so oh", encoding="utf-8")
    desk.open(tmp_path)
    assert desk.texts.text == "so oh"
    assert not desk.texts.written.has_unsaved_changes
    desk.texts.set_text("so what")
    assert desk.texts.written.has_unsaved_changes


@pytest.mark.parametrize(
    ("spoken", "file"), [("Hello you there.", "so oh"), ("so oh!", "so oh!")], ids=["another text", "the script"]
)
def test_a_text_that_is_spoken_is_the_sounds_script_only_where_it_is_like_it(desk, tmp_path, spoken, file):
    (tmp_path / "said.txt").write_text("so oh", encoding="utf-8")
    desk.open(tmp_path)
    desk.align()
    desk.say(spoken)
    assert desk.texts.text == spoken
    assert desk.texts.written.has_unsaved_changes == (spoken == file)
    desk.session.set_source(SourceKind.FILE)
    desk.wait()
    assert (desk.texts.text, desk.words()) == (file, ["so", "oh"])


def test_the_text_of_the_demo_is_where_to_begin_and_no_file_to_save_to(qapp):
    written = WrittenText()
    for expected in ("She sells", "Hello"):
        written.leave(DEMO)
        written.take("She sells", None)
        assert written.text == expected
        written.set_text("Hello")
        assert not written.has_unsaved_changes
        written.leave(None)


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
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.95)
    desk.stage.play(10, lambda: jaws.append(desk.stage.jaw))
    assert max(jaws) > 5


# -- by hand ------------------------------------------------------------------------------------------


def test_a_dragged_boundary_is_undone_and_done_again(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    stack = desk.session.preset.undo_stack
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.8)
    assert stack.undoText() == "move of a boundary (word)"
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
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.5)
    assert desk.texts.utterance is SAID
    assert "leave nothing" in desk.failed[0]


def test_what_was_dragged_is_what_is_saved(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.8)
    assert desk.texts.edits.save(tmp_path / "said.TextGrid")
    written = read_utterance(tmp_path / "said.TextGrid", DURATION)
    assert np.allclose(spans_of(written, LabelUnit.WORD), spans_of(desk.texts.utterance, LabelUnit.WORD), atol=1e-6)
    assert "said.TextGrid" in desk.told[-1]


def test_what_was_moved_by_hand_is_unsaved_until_it_is_saved_or_taken_back(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    assert not desk.texts.words.has_unsaved_changes  # the program finds it again
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.8)
    assert desk.texts.words.has_unsaved_changes
    desk.session.preset.undo_stack.undo()
    assert not desk.texts.words.has_unsaved_changes
    desk.session.preset.undo_stack.redo()
    assert desk.texts.edits.save(tmp_path / "said.TextGrid")
    assert not desk.texts.words.has_unsaved_changes
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.7)
    assert desk.texts.words.has_unsaved_changes


def test_words_that_cannot_be_saved_stay_unsaved(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.8)
    assert not desk.texts.edits.save(tmp_path / "gone" / "said.TextGrid")
    assert "said.TextGrid" in desk.failed[0]
    assert desk.texts.words.has_unsaved_changes


def test_a_text_that_is_spoken_meanwhile_leaves_moved_boundaries_as_they_are(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.8)
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
    desk.texts.edits.save(tmp_path / "said.TextGrid")
    again = words_beside(tmp_path / "said.wav", DURATION).utterance
    assert again is not None
    assert [said.text for spoken in again.words for said in spoken.syllables] == ["hao3"]


def test_a_word_that_is_played_ends_where_it_ends(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    heard: list[Analysis] = []
    desk.session.analysed.connect(heard.extend)
    desk.texts.edits.play(0.6, 0.9)
    assert desk.session.source.playing
    desk.stage.play(2.0)
    assert not desk.session.source.playing
    assert (heard[0].start, heard[-1].start + len(heard[-1])) == (60, 90)
    assert desk.session.source.position == 0.6
