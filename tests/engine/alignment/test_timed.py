"""Words with times keep them, and their phones are found in them."""

from dataclasses import replace
from itertools import pairwise

import pytest

from phonemeengine.alignment.align import align_timed
from phonemeengine.alignment.evidence import Evidence, joined
from phonemeengine.labels.timed_words import TimedWord
from phonemeengine.labels.utterance import Utterance
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.text.pronunciation import ScriptWord, timed_words_of
from tests.engine.alignment.speaking import heard, words

SAID = heard(".sima.lupo.")
"""8 frames each: sima from 0.08 to 0.40 s, lupo from 0.48 to 0.80 s."""


def placed(evidence: Evidence, *script: tuple[str, float, float], block: int = 7) -> Utterance:
    timed: list[ScriptWord] = [
        replace(one, interval=(start, end)) for text, start, end in script for one in words(text)
    ]
    blocks = (evidence.part(slice(k, k + block)) for k in range(0, len(evidence), block))
    return align_timed(blocks, timed, len(evidence) * FRAME_PERIOD, "xx")


def spans(utterance: Utterance) -> list[tuple[str, float, float]]:
    return [(word.text, round(word.start, 6), round(word.end, 6)) for word in utterance.words]


def phones(utterance: Utterance) -> list[tuple[str, float]]:
    return [(phone.ipa, round(phone.start, 3)) for phone in utterance.phones]


def test_words_keep_their_times_and_their_phones_lie_where_they_are_heard() -> None:
    found = placed(SAID, ("sima", 0.081, 0.401), ("lupo", 0.479, 0.799))
    assert spans(found) == [("sima", 0.081, 0.401), ("lupo", 0.479, 0.799)]
    assert phones(found) == [
        ("s", 0.081),
        ("i", 0.161),
        ("m", 0.241),
        ("a", 0.321),
        ("l", 0.479),
        ("u", 0.559),
        ("p", 0.639),
        ("o", 0.719),
    ]
    assert found.language == "xx"
    assert all(one.end == other.start for word in found.words for one, other in pairwise(word.phones))


def test_long_quiet_at_the_edge_of_a_word_is_not_of_the_word() -> None:
    quiet = joined([heard(".", 20), heard("sima"), heard(".", 20)])
    assert spans(placed(quiet, ("sima", 0.0, 0.72))) == [("sima", 0.2, 0.52)]


def test_several_words_may_share_one_time() -> None:
    assert spans(placed(SAID, ("sima lupo", 0.08, 0.8))) == [("sima", 0.08, 0.4), ("lupo", 0.48, 0.8)]


def test_a_word_that_is_shorter_than_its_sounds_shares_its_time_among_them() -> None:
    found = placed(SAID, ("sima", 0.1, 0.12))
    assert phones(found) == [("s", 0.1), ("i", 0.105), ("m", 0.11), ("a", 0.115)]
    assert spans(found) == [("sima", 0.1, 0.12)]


def test_a_word_after_the_last_frame_keeps_its_time_too() -> None:
    assert spans(placed(SAID, ("sima", 0.08, 0.4), ("lupo", 0.875, 0.88)))[1] == ("lupo", 0.875, 0.88)


def test_a_long_recording_is_aligned_in_stretches_however_it_is_cut() -> None:
    sound = joined([SAID] * 30)
    script = [
        (word, start + 0.88 * k, end + 0.88 * k)
        for k in range(30)
        for word, start, end in (("sima", 0.08, 0.4), ("lupo", 0.48, 0.8))
    ]
    found = placed(sound, *script)
    assert spans(found) == [(word, round(start, 6), round(end, 6)) for word, start, end in script]
    assert [round(p.start - 20 * 0.88, 2) for p in found.words[40].phones] == [0.08, 0.16, 0.24, 0.32]
    assert placed(sound, *script, block=1000).words == found.words


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        (["Hello,", "world."], ["Hello", "world"]),
        (["On", "—", "7", "May"], ["On", "7", "May"]),
        (["New York", "is"], ["New", "York", "is"]),
    ],
)
def test_words_of_other_programs_are_pronounced_in_their_times(texts: list[str], expected: list[str]) -> None:
    timed = [TimedWord(float(k), k + 0.5, text) for k, text in enumerate(texts)]
    script = timed_words_of(timed, "en-us")
    assert [word.text for word in script] == expected
    owners = [next(k for k, text in enumerate(texts) if word in text) for word in expected]
    assert [word.interval for word in script] == [(float(k), k + 0.5) for k in owners]
