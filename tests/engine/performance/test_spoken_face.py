"""A face that is looked up sentence by sentence, while a voice still speaks, is that of the whole text."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.labels.utterance import shifted
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.driver import PerformanceOptions
from phonemeengine.performance.recording import HEAD
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.track import PerformanceTrack, SpokenFace
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.spoken_text import spoken_text
from phonemeengine.speech.voice import SpokenSentence
from tests.engine.performance.test_track import recorded, utterance_of

JAW = ARKIT.index("jawOpen")


@pytest.fixture
def table(tmp_path: Path) -> Iterator[PerformanceTable]:
    plain = [recorded(words, jaw=k / 10) for k, words in enumerate(("ma", "mi.ta", "ma tu", "ti", "tu.ma", "mi"))]
    channels = (*HEAD, *plain[0].channels[1:])
    rng = np.random.default_rng(1)
    turned = []
    for recording in plain:
        turns = rng.normal(0, 4, (1, 3)) + np.sin(np.arange(len(recording.weights)) / 20)[:, None] * [5, 3, 2]
        weights = np.hstack([turns, recording.weights[:, 1:]]).astype(np.float32)
        turned.append(replace(recording, channels=channels, weights=weights))
    write_table(tmp_path / "t.sqlite", turned)
    with PerformanceTable.open(tmp_path / "t.sqlite") as opened:
        yield opened


def spoken(n: int, pause: float = 0.3) -> list[SpokenSentence]:
    """Give sentences as a voice speaks them: a hum, with the silence after it."""
    texts = (("ma", "ti"), ("mi.ta",), ("tu", "ma", "mi"))
    sentences = []
    for k in range(n):
        said = utterance_of(*texts[k % 3], length=0.08, pause=0.02, gap=0.0)
        end = said.words[-1].end + pause
        hum = (
            0.1
            * (1 + k % 3)
            * np.sin(2 * np.pi * (110 + 10 * (k % 5)) * np.arange(round(end * SAMPLE_RATE)) / SAMPLE_RATE)
        )
        hum[round(said.words[-1].end * SAMPLE_RATE) :] = 0
        sentences.append(SpokenSentence(hum.astype(np.float32), said.words, " ".join(texts[k % 3])))
    return sentences


def test_sentence_by_sentence_a_face_is_that_of_the_whole_text(table: PerformanceTable) -> None:
    sentences = spoken(8)
    options = PerformanceOptions(ExampleChoice.RANDOM, seed=3)  # numbers of sentences count
    face = SpokenFace(table, "en", options)
    assert list(face.follow(sentences)) == sentences
    whole = spoken_text(sentences, language="en")
    track = PerformanceTrack(whole.utterance, whole.transcript, table, options)
    mouth = track.mouth()
    assert face.units == tuple(track.units())
    assert face.notes == tuple(note for note in track.notes if "the recordings have no" in note)
    for time in np.arange(0, whole.utterance.duration - 0.1, 0.05).tolist():
        assert np.array_equal(face.weights(time), mouth.weights(time))
        assert face.head(time) == mouth.head(time)


def test_each_sentence_is_looked_up_before_its_sound_is_handed_on(table: PerformanceTable) -> None:
    face, end = SpokenFace(table, "en"), 0.0
    assert not face.weights(0.2).any()
    for sentence in face.follow(spoken(3)):
        said = sentence.words[0]
        assert face.weights(end + said.start + 0.1).any()
        end += sentence.duration


def test_what_was_spoken_long_ago_is_forgotten_and_the_rest_is_as_it_was(table: PerformanceTable) -> None:
    remembered, sentences = 20.0, spoken(12, pause=4.0)
    face = SpokenFace(table, "en", PerformanceOptions(ExampleChoice.BAND, seed=2), remembered)
    for _ in face.follow(sentences):
        pass
    words, at = [], 0.0
    for sentence in sentences:
        words += [shifted(word, at) for word in sentence.words]
        at += sentence.duration
    assert at > 2 * remembered
    whole = spoken_text(sentences, language="en")
    track = PerformanceTrack(whole.utterance, whole.transcript, table, PerformanceOptions(ExampleChoice.BAND, seed=2))
    kept = face.units
    assert at - 2 * remembered < kept[0].start < at - remembered + 5
    assert [*track.units()][-len(kept) + 1 :] == list(kept[1:])
    mouth = track.mouth()
    for time in (at - 15.0, at - 7.3, at - 1.0):
        assert np.array_equal(face.weights(time), mouth.weights(time))


def test_a_language_without_key_words_moves_the_head_all_the_same(table: PerformanceTable) -> None:
    face = SpokenFace(table, "")
    for _ in face.follow(spoken(2)):
        pass
    assert any(pose.yaw for pose in map(face.head, (0.1, 0.2, 0.3)) if pose is not None)
