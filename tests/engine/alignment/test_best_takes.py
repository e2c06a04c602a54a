"""One line in several takes: the one that says it best is found."""

from pathlib import Path

from phonemeengine.alignment.align import best_marked, scored_take
from phonemeengine.labels.utterance import UNKNOWN_WORD, Phone, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme


def said(*words: tuple[str, float], skipped: tuple[str, ...] = ()) -> Utterance:
    """Return words of a second each, with their scores."""
    spoken = tuple(
        Word(text, (Syllable((Phone(float(k), k + 1.0, "a", Phoneme.A, score),)),))
        for k, (text, score) in enumerate(words)
    )
    return Utterance(spoken, float(len(words)), "de", skipped)


def best_of(*utterances: Utterance, text: str = "ja nein") -> list[bool]:
    takes = [scored_take(Path(f"{k}.wav"), text, utterance) for k, utterance in enumerate(utterances)]
    return [take.is_best for take in best_marked(takes)]


def test_the_take_that_fits_its_line_best_is_the_best():
    assert best_of(said(("ja", 0.3), ("nein", 0.3)), said(("ja", 0.1), ("nein", 0.2))) == [False, True]


def test_a_word_too_few_or_too_many_is_worse_than_any_score():
    whole = said(("ja", 0.4), ("nein", 0.4))
    assert best_of(said(("ja", 0.0), skipped=("nein",)), whole) == [False, True]
    assert best_of(said(("ja", 0.0), (UNKNOWN_WORD, 0.0), ("nein", 0.0)), whole) == [False, True]


def test_each_line_has_a_best_take_of_its_own_and_one_that_nobody_says_has_none():
    line, other = said(("ja", 0.2)), said(("nein", 0.2))
    takes = [scored_take(Path("a.wav"), "ja", line), scored_take(Path("b.wav"), "nein", other)]
    assert [take.is_best for take in best_marked(takes)] == [True, True]
    assert best_of(Utterance((), 2.0, "de", ("ja", "nein"))) == [False]
