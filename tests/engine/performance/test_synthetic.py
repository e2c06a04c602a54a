from itertools import islice
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import Cancelled, PerformanceError, PerformanceTable, TextError, build_table, make_corpus
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.performance.making import RATE, perform, sentences
from phonemeengine.text.pronunciation import words_of
from tests.engine.performance.corpora import saying
from tests.engine.performance.sentences import phones_in


def _weight(words: str, at: int, channel: str, seed: int = 1) -> float:
    """The weight of a channel in the middle of a phone, each of which lasts 0.15 s."""
    weights = perform(phones_in(words, 0.15), (seed,)).weights
    return float(weights[round((at + 0.5) * 0.15 * RATE), ARKIT.index(channel)])


def test_the_performer_opens_its_jaw_for_a_and_shuts_its_lips_for_p() -> None:
    for seed in range(5):
        assert _weight("apa", 1, "jawOpen", seed) > 3 * _weight("apa", 2, "jawOpen", seed)
        assert _weight("apa", 2, "mouthPressLeft", seed) > 3 * _weight("apa", 1, "mouthPressLeft", seed)


def test_the_performer_rounds_its_lips_for_u_and_spreads_them_for_i() -> None:
    assert _weight("tuti", 2, "mouthPucker") > 3 * _weight("tuti", 4, "mouthPucker")
    assert _weight("tuti", 4, "mouthStretchLeft") > 1.5 * _weight("tuti", 2, "mouthStretchLeft")


def test_a_sound_looks_different_beside_others() -> None:
    assert _weight("iti", 2, "jawOpen") < _weight("ata", 2, "jawOpen")


def test_two_takes_differ_a_little_and_one_seed_gives_one_take() -> None:
    phones = phones_in("ma.ta.pu", 0.1)
    first, second = perform(phones, (1,)).weights, perform(phones, (2,)).weights
    assert np.array_equal(first, perform(phones, (1,)).weights)
    jaw = ARKIT.index("jawOpen")
    assert 0.002 < np.sqrt(np.mean((first[:, jaw] - second[:, jaw]) ** 2)) < 0.1


def test_the_performer_moves_all_channels_and_its_head_within_bounds() -> None:
    animation = perform(phones_in("ma.ta.pu " * 20), (1,))
    assert animation.movestates == ARKIT
    assert animation.weights.min() >= 0
    assert animation.weights.max() <= 1
    assert (animation.weights.std(axis=0) > 0).all()
    assert (animation.head.std(axis=0) > 0.2).all()
    assert np.abs(animation.head).max() < 20
    assert animation.weights[:, ARKIT.index("eyeBlinkLeft")].max() > 0.9


def test_hundreds_of_sentences_are_all_different_and_hold_every_sound() -> None:
    said = [*islice(sentences(1), 500)]
    assert len(set(said)) == 500
    assert said == [*islice(sentences(1), 500)]
    words = words_of(" ".join(said[:150]), "en-us")
    sounds = {phone for word in words for phone in word.pronunciations[0].phones}
    assert {*"pbtdkɡmnŋfvszʃʒhlɹjwθðæɛɪʊiu", "aɪ", "aʊ", "eɪ", "oʊ", "ɔɪ"} <= sounds


def test_a_synthetic_corpus_becomes_a_table_that_says_so(tmp_path: Path) -> None:
    made = make_corpus(tmp_path / "c", ["one two", "three", "four five six", "never"], saying(), seconds=2.4)
    assert made.n_recordings == 3
    assert made.duration == pytest.approx(6 * 0.2 + 3 * 0.55)
    built = build_table(tmp_path / "c", tmp_path / "t.sqlite")
    assert (built.left_out, built.notes) == ((), ())
    assert (built.about.n_recordings, built.about.synthetic, built.about.name) == (3, True, "c")
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        performance = table.recording(1)
        assert performance.words == ("one", "two")
        assert [phone.stress for phone in performance.phones] == [0, 1, 1, 1, 1, 0]


def test_a_text_that_ends_early_makes_a_shorter_corpus(tmp_path: Path) -> None:
    assert make_corpus(tmp_path / "c", ["one two"], saying(), seconds=60).n_recordings == 1


def test_a_corpus_never_lands_among_other_files(tmp_path: Path) -> None:
    (tmp_path / "mine.wav").touch()
    with pytest.raises(PerformanceError, match="there are files in this folder already"):
        make_corpus(tmp_path, ["one"], saying(), seconds=1)
    with pytest.raises(PerformanceError, match="cannot be written"):
        make_corpus(tmp_path / "mine.wav", ["one"], saying(), seconds=1)
    assert [*tmp_path.iterdir()] == [tmp_path / "mine.wav"]


def test_a_voice_that_refuses_is_heard(tmp_path: Path) -> None:
    def refuse(_text: str) -> None:
        raise TextError("there is nothing to speak; write something")

    with pytest.raises(TextError, match="nothing to speak"):
        make_corpus(tmp_path / "c", ["…"], refuse, seconds=1)  # type: ignore[arg-type]
    with pytest.raises(Cancelled):
        make_corpus(tmp_path / "d", ["one"], saying(), seconds=1, progress=lambda _share: False)
