"""Words and phones that are changed by hand, on the timeline or in files."""

import os

from PySide6.QtGui import QUndoStack

from phonemeanalyser.desktop.talk.words.sound_words import KnownWords, SoundWords
from phonemeengine.labels.utterance import LabelUnit, Utterance
from tests.desktop.talk.desk import SAID
from tests.desktop.talk.voices import word


def test_words_and_phones_are_renamed_inserted_split_and_deleted_and_each_is_undone(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    edits, stack = desk.texts.edits, desk.session.preset.undo_stack
    told: list[tuple[str, str]] = []
    edits.name_asked.connect(lambda span, name: told.append((f"{span.start:.2f}-{span.end:.2f}", name)))

    def phones(k: int) -> str:
        return "".join(phone.ipa for phone in desk.texts.utterance.words[k].phones)

    def done() -> None:
        desk.qtbot.waitUntil(lambda: not edits._work.busy)

    edits.choose((LabelUnit.WORD, 0))
    edits.ask_rename()
    assert told == [("0.60-0.90", "so")]
    edits.name("see /siː/")
    done()
    assert desk.words() == ["see", "oh"]
    assert phones(0) == "si"
    assert stack.undoText() == "renaming of a word"
    assert desk.texts.words.has_unsaved_changes
    edits.choose((LabelUnit.PHONE, 1))
    edits.ask_rename()
    edits.name("ə")
    assert phones(0) == "sə"
    edits.choose((LabelUnit.WORD, 1))
    edits.delete()
    assert desk.words() == ["see"]
    assert edits.chosen is None
    desk.session.seek(1.0)
    edits.ask_insert()
    edits.name("/a/")
    done()
    assert desk.words() == ["see", "a"]
    edits.choose((LabelUnit.WORD, 0))
    desk.session.seek(0.85)
    edits.split()
    assert desk.words() == ["see", "ə", "a"]
    edits.choose((LabelUnit.WORD, 2))
    edits.realign()
    done()
    assert stack.undoText() == "alignment of a word"
    assert desk.words() == ["see", "ə", "a"]
    for _ in range(6):
        stack.undo()
    assert desk.texts.utterance is SAID
    assert desk.failed == []


def test_what_cannot_be_changed_is_told_in_one_sentence_and_loses_nothing(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.edits.realign()
    desk.align()
    before = desk.texts.utterance
    desk.session.seek(0.1)
    desk.texts.edits.delete()
    desk.session.seek(0.7)
    desk.texts.edits.ask_insert()
    desk.texts.edits.choose((LabelUnit.PHONE, 0))
    desk.texts.edits.ask_rename()
    desk.texts.edits.name("!")
    assert [sentence.split(".")[0] for sentence in desk.failed] == [
        "No words are known of this sound",
        "No word is selected",
        "There is no pause at the cursor for another word",
        "'!' is no sound of IPA; write one, such as ə, or delete the phone",
    ]
    assert desk.texts.utterance is before


def test_words_are_not_those_of_a_file_that_was_written_to_meanwhile(tmp_path):
    sound, words = tmp_path / "talk.wav", SoundWords(QUndoStack())
    sound.write_bytes(b"one")
    words.follow(sound)
    words.put(KnownWords(Utterance((word("so", 0.2, 0.5),), 1.0)))
    assert words.is_of(sound, 1.0)
    sound.write_bytes(b"two")
    os.utime(sound, ns=(1, 1))
    assert not words.is_of(sound, 1.0)
