"""What a text says of feeling on Talk: a lane whose edits are directions in the text, and a face that shows it."""

import pytest
from PySide6.QtGui import QUndoStack
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.talk.words.felt_text import FeltText
from phonemeanalyser.desktop.talk.words.sound_words import KnownWords
from phonemeanalyser.desktop.talk.words.spoken_lanes import lane_of_feelings
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme
from tests.desktop.stage import Stage

WORDS = ("We", "left", "today", "They", "lost")


@pytest.fixture
def felt(stage: Stage) -> FeltText:
    texts = stage.talking.text
    texts.set_text("[smile 0.6] We left today.\nThey lost.")
    texts.set_language("en-us")
    words = tuple(
        Word(text, (Syllable((Phone(0.2 * k + 0.2, 0.2 * k + 0.4, "a", Phoneme.A),)),))
        for k, text in enumerate(WORDS)
    )
    texts.words.put(KnownWords(Utterance(words, stage.session.source.duration), text=texts.text))
    return stage.talking.felt_text


def spans(felt: FeltText) -> list[tuple[float, str]]:
    return [(round(span.start, 3), span.words) for span in felt.spans if span.directed]


def test_feelings_are_moved_changed_deleted_added_and_taken_back(stage: Stage, felt: FeltText) -> None:
    texts, undo = stage.talking.text, stage.session.preset.undo_stack
    assert isinstance(undo, QUndoStack)
    assert spans(felt) == [(0.2, "smile 0.6")]
    felt.move(0, is_end=False, seconds=0.41)
    assert (texts.text, spans(felt)) == ("We [smile 0.6] left today.\nThey lost.", [(0.4, "smile 0.6")])
    felt.move(0, is_end=True, seconds=0.62)
    assert texts.text == "We [smile 0.6] left [neutral] today.\nThey lost."
    assert felt.spans[0].end == pytest.approx(0.6)
    felt.write(felt.spans[0], "anger 0.3, fear 0.2")
    assert spans(felt) == [(0.4, "anger 0.3, fear 0.2")]
    felt.write(felt.spans[0], "")
    assert texts.text == "We left [neutral] today.\nThey lost."
    felt.insert(0.8, "surprise")
    assert texts.text == "We left [neutral] today.\n[surprise] They lost."
    assert not texts.stale  # directions are no words, so there is nothing to align again
    for _ in range(5):
        undo.undo()
    assert texts.text == "[smile 0.6] We left today.\nThey lost."


def test_a_span_grows_with_what_is_spoken(stage: Stage, felt: FeltText) -> None:
    texts, said = stage.talking.text, stage.talking.text.utterance
    assert said is not None
    texts.set_text("We left today. [smile 0.6] They lost.")
    for n, found in ((3, []), (5, [(0.8, "smile 0.6")])):  # the second sentence begins where the first one ends
        part = Utterance(said.words[:n], said.words[n - 1].end)
        texts.words.put(KnownWords(part, text=texts.text))
        assert spans(felt) == found


def test_a_direction_that_cannot_be_followed_is_refused(stage: Stage, felt: FeltText, qtbot: QtBot) -> None:
    with qtbot.waitSignal(stage.talking.error) as said:
        felt.write(felt.spans[0], "smiel 0.6")
    assert "did you mean smile" in said.args[0]
    assert stage.talking.text.text.startswith("[smile 0.6]")


def test_the_face_shows_it_and_exports_tell_it(stage: Stage, felt: FeltText) -> None:
    talking = stage.talking
    assert talking.idle.expression is None
    talking.expression.set_text_feeling(0.5)
    assert talking.idle.expression is not None
    in_use = talking.in_use
    assert (in_use.options.text_feeling, [*in_use.texts.values()]) == (0.5, [talking.text.text])
    assert in_use.options.idle.expression is None  # the text that is exported tells it
    shown = talking.shown.options.idle.expression  # of which curves of keys and the second head are generated
    assert shown is not None
    assert shown.streams[0].weights(0.5).any()
    lane = lane_of_feelings(felt.spans)
    assert lane.texts[0] == "smile 60 %"
    talking.expression.clear()
    assert talking.idle.expression is None
