import threading
from collections.abc import Iterator

import numpy as np
import pytest

from phonemeengine import EngineError, TextError, Voice
from phonemeengine.labels.utterance import Phone, Syllable, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.spooled import AHEAD, KEPT, SpooledSpeech
from phonemeengine.speech.voice import SpokenSentence

SECOND = SAMPLE_RATE


def _sentence(k: int, n: int = SECOND) -> SpokenSentence:
    word = Word(str(k), (Syllable((Phone(0.1, 0.4, "a", Phoneme.A),)),))
    return SpokenSentence(np.full(n, k / 1000, np.float32), (word,), f"{k}.")


def test_what_is_read_is_what_was_spoken_however_it_is_cut() -> None:
    with SpooledSpeech([_sentence(1), _sentence(2)]) as speech:
        blocks = [speech.read(30_000) for _ in range(4)]
        assert [len(block) for block in blocks] == [30_000, 30_000, 28_200, 0]
        assert np.array_equal(np.concatenate(blocks)[:, 0], np.repeat(np.float32([0.001, 0.002]), SECOND))


def test_what_is_read_may_be_read_again() -> None:
    with SpooledSpeech([_sentence(1), _sentence(2)]) as speech:
        speech.read(2 * SECOND)
        speech.seek(SECOND - 1)
        assert speech.read(2)[:, 0] == pytest.approx([0.001, 0.002])


def test_who_reads_waits_for_what_is_still_being_spoken() -> None:
    may_go_on = threading.Event()

    def sentences() -> Iterator[SpokenSentence]:
        yield _sentence(1)
        may_go_on.wait()
        yield _sentence(2)

    with SpooledSpeech(sentences()) as speech:
        assert len(speech.read(SECOND)) == SECOND
        may_go_on.set()
        assert len(speech.read(SECOND)) == SECOND


def test_a_text_without_end_is_spoken_only_a_while_ahead() -> None:
    spoken: list[int] = []

    def sentences() -> Iterator[SpokenSentence]:
        k = 0
        while True:
            spoken.append(k)
            yield _sentence(k)
            k += 1

    with SpooledSpeech(sentences()) as speech:
        for _ in range(200):
            speech.read(SECOND)
        assert 200 <= len(spoken) <= 200 + AHEAD // SECOND + 2


def test_it_is_known_what_is_said_when_and_forgotten_long_after() -> None:
    n = 2 * KEPT // SECOND
    with SpooledSpeech(_sentence(k) for k in range(n)) as speech:
        speech.read(SECOND)
        track = speech.track_at(0.5)
        assert track is not None
        assert (track.text, track.start, track.words[0].start) == ("0.", 0.0, 0.1)
        for _ in range(n - 1):
            speech.read(SECOND)
        assert speech.track_at(0.5) is None
        last = speech.track_at(n - 0.5)
        assert last is not None
        assert last.words[0].start == pytest.approx(n - 1 + 0.1)
        assert speech.track_at(n + 1.0) is None


def test_a_voice_that_fails_is_heard_until_then() -> None:
    def sentences() -> Iterator[SpokenSentence]:
        yield _sentence(1)
        raise TextError("no more")

    with SpooledSpeech(sentences()) as speech:
        assert len(speech.read(2 * SECOND)) == SECOND
        with pytest.raises(EngineError, match="no more"):
            speech.read(1)


def test_closing_ends_a_voice_that_has_much_to_say() -> None:
    with SpooledSpeech(Voice("en-us").speak("A sentence that is long enough. " * 30_000)) as speech:
        assert len(speech.read(1000)) == 1000


def test_a_megabyte_without_a_mark_or_a_space_begins_with_a_short_sentence() -> None:
    first = next(iter(Voice("en-us").speak("a" * 1_000_000)))
    assert len(first.text) <= 400
