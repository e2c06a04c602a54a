"""Words that still come are found in a sound that does; they settle, and nothing is kept of what is settled."""

import pytest

from phonemeengine.alignment import growing as room
from phonemeengine.alignment.evidence import Evidence
from phonemeengine.alignment.growing import GrowingAligner
from phonemeengine.errors import TextError
from phonemeengine.labels.utterance import Word
from tests.engine.alignment.speaking import heard, words


def followed(
    evidence: Evidence, script: str, block: int = 25
) -> tuple[list[Word], list[tuple[Word, ...]], list[str]]:
    """The words that settled, those that were open at each look, and those that nobody said."""
    aligner = GrowingAligner()
    aligner.add_words(words(script))
    settled, looks, skipped = [], [], []
    for first in range(0, len(evidence), block):
        aligner.push(evidence.part(slice(first, first + block)))
        found = aligner.look()
        settled += found.settled
        skipped += found.skipped
        looks.append(found.open)
    found = aligner.finish(len(evidence) * 0.01)
    return [*settled, *found.settled], looks, [*skipped, *found.skipped]


def spans(found: list[Word]) -> list[tuple[str, int, int]]:
    return [(w.text, round(100 * w.start), round(100 * w.end)) for w in found]


def test_words_settle_where_they_are_said() -> None:
    said = 6 * ".sima.lupo."
    settled, _, skipped = followed(heard(said), " ".join(6 * ["sima lupo"]))
    assert spans(settled) == [
        (text, 88 * k + first, 88 * k + first + 32) for k in range(6) for text, first in (("sima", 8), ("lupo", 48))
    ]
    assert skipped == []


def test_a_word_is_open_as_soon_as_it_is_heard() -> None:
    _, looks, _ = followed(heard(".sima.lupo."), "sima lupo", block=10)
    assert [word.text for word in looks[3]] == ["sima"]
    assert [word.text for word in looks[-1]] == ["sima", "lupo"]


@pytest.mark.parametrize("late", [10, 40])
def test_words_may_come_a_little_after_they_are_said(late: int) -> None:
    evidence, aligner = heard(".sima.lupo."), GrowingAligner()
    aligner.push(evidence.part(slice(late)))
    assert aligner.look().open == ()
    aligner.add_words(words("sima lupo"))
    aligner.push(evidence.part(slice(late, None)))
    assert spans([*aligner.finish(0.88).settled]) == [("sima", 8, 40), ("lupo", 48, 80)]


def test_words_that_nobody_says_are_skipped_and_others_unknown() -> None:
    settled, _, skipped = followed(heard(".sima.lupo."), "sima makufe lupo")
    assert [word.text for word in settled] == ["sima", "lupo"]
    assert skipped == ["makufe"]


def test_nothing_is_kept_of_what_is_settled() -> None:
    aligner, evidence = GrowingAligner(), heard(".sima.lupo.")
    for _ in range(30):
        aligner.add_words(words("sima lupo"))
        aligner.push(evidence)
        aligner.look()
    assert aligner.n_waiting <= room.LONGEST + len(evidence)
    rest = aligner.finish(30 * 0.88)
    assert len(rest.settled) + len(rest.skipped) < 20


def test_sound_without_words_is_forgotten() -> None:
    aligner, evidence = GrowingAligner(), heard(".sima.lupo.")
    for _ in range(30):
        aligner.push(evidence)
        aligner.look()
    assert aligner.n_waiting <= room.LONGEST
    assert aligner.finish(30 * 0.88).settled == ()


def test_a_word_without_end_is_refused() -> None:
    with pytest.raises(TextError, match=r"the word 'aaaaaaaaaaaaaaaaaaaa'\.\.\. has more than 1000 sounds"):
        GrowingAligner().add_words(words("a" * 1001))


def test_only_words_that_can_be_said_in_time_are_looked_for() -> None:
    aligner = GrowingAligner()
    aligner.add_words(words(" ".join(1000 * ["sima"])))
    assert len(aligner._next_words()) == room.MOST_SOUNDS // 4


def test_another_text_is_noticed() -> None:
    right, wrong = GrowingAligner(), GrowingAligner()
    for aligner, script in ((right, "sima lupo"), (wrong, "kefunaso tarile")):
        for _ in range(6):
            aligner.add_words(words(script))
            aligner.push(heard(".sima.lupo."))
            aligner.look()
        aligner.finish(6 * 0.88)
    assert (right.fit.is_wrong, wrong.fit.is_wrong) == (False, True)
