"""Two presets compared: what each gets right that the other misses, counted and found."""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine.calibration.scores.comparison import DifferingSegment, compare
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, read_corpus
from phonemeengine.calibration.scores.evaluation import CorpusScores, Predictions, group_scores_of, score
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.errors import CorpusError
from phonemeengine.labels.visemes import NO_VISEME
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from tests.corpora import write_corpus

THESIS = load_preset(FACTORY / "thesis.toml")
CLEAN = load_preset(FACTORY / "thesis-anti-aliased.toml")
CODES = {"_": Phoneme.SILENCE, "a": Phoneme.A, "o": Phoneme.O, "m": Phoneme.M, "?": Phoneme.UNIDENTIFIED}


def codes(line: str) -> np.ndarray:
    return np.array([CODES[c] for c in line], np.uint8)


def scores(*lines: tuple[str, str]) -> CorpusScores:
    heard = []
    for k, (truth, guess) in enumerate(lines):
        labels = FrameLabels(codes(truth), np.ones(len(truth), bool), np.full(len(truth), NO_VISEME, np.uint8))
        utterance = LabelledUtterance(Path(f"u{k}.wav"), (), "s", "c")
        heard.append(Predictions(utterance, labels, codes(guess), np.ones(len(truth), np.float32)))
    group = group_scores_of(heard)
    return CorpusScores(Preset(), 0, 0.0, tuple(heard), group, {"c": group}, {"c/s": group})


def test_what_only_one_gets_right_is_counted_by_what_was_said() -> None:
    found = compare(scores(("__aaaoo?", "__aaoom?")), scores(("__aaaoo?", "a_aoaomm")))
    counts = {
        p: [int(part[p]) for part in (found.both, found.only_one, found.only_other, found.neither)] for p in Phoneme
    }
    assert counts[Phoneme.SILENCE] == [1, 1, 0, 0]
    assert counts[Phoneme.A] == [1, 1, 1, 0]
    assert counts[Phoneme.O] == [1, 0, 0, 1]
    assert counts[Phoneme.UNIDENTIFIED] == [0, 1, 0, 0]
    assert sum(map(sum, counts.values())) == 8


def test_frames_whose_phoneme_changes_are_counted_by_what_each_preset_answers() -> None:
    found = compare(scores(("__aaaoo?", "__aaoom?")), scores(("__aaaoo?", "a_aoaomm")))
    changed = found.changed - np.diag(found.changed.diagonal())
    cells = {(Phoneme(i), Phoneme(j)): int(changed[i, j]) for i, j in zip(*changed.nonzero(), strict=True)}
    assert cells == {
        (Phoneme.SILENCE, Phoneme.A): 1,
        (Phoneme.A, Phoneme.O): 1,
        (Phoneme.O, Phoneme.A): 1,
        (Phoneme.UNIDENTIFIED, Phoneme.M): 1,
    }
    assert found.changed.sum() == 8


def test_the_sums_are_those_of_the_confusions(tmp_path: Path) -> None:
    utterances = read_corpus(write_corpus(tmp_path, THESIS))
    one, other = (score(preset, utterances) for preset in (THESIS, CLEAN))
    found = compare(one, other)
    assert found.only_one.sum() > 0
    assert np.array_equal(found.both + found.only_one, one.overall.confusion.diagonal())
    assert np.array_equal(found.both + found.only_other, other.overall.confusion.diagonal())
    labelled = one.overall.confusion.sum(axis=1)
    assert np.array_equal(found.both + found.only_one + found.only_other + found.neither, labelled)
    ten = list(SCORED_PHONEMES)
    assert sum(d.n_one for d in found.differences) == found.only_one[ten].sum()
    assert sum(d.n_other for d in found.differences) == found.only_other[ten].sum()
    assert sum(d.n_frames for d in found.differences) == labelled[ten].sum()
    assert sum(d.n_both for d in found.differences) == found.both[ten].sum()


def test_the_recordings_that_differ_most_come_first() -> None:
    one = scores(("aaaa", "aaaa"), ("aaaa", "aooo"), ("aaaa", "oooo"))
    other = scores(("aaaa", "aaao"), ("aaaa", "oaoo"), ("aaaa", "aaao"))
    found = [(d.utterance.path.name, d.n_one, d.n_other) for d in compare(one, other).differences]
    assert found == [("u2.wav", 0, 3), ("u0.wav", 1, 0), ("u1.wav", 1, 1)]


def test_stretches_say_when_what_was_said_and_what_was_answered() -> None:
    one, other = scores(("_aaaaoo?", "_aaaamo?")), scores(("_aaaaoo?", "moommom?"))
    found = compare(one, other)
    utterance = one.predictions[0].utterance
    assert [(s.start, s.end) for s in found.segments_one] == [
        pytest.approx(times) for times in ((0.01, 0.03), (0.03, 0.05), (0, 0.01), (0.06, 0.07))
    ]
    assert [(s.label, s.wrong) for s in found.segments_one] == [
        (Phoneme.A, Phoneme.O),
        (Phoneme.A, Phoneme.M),
        (Phoneme.SILENCE, Phoneme.M),
        (Phoneme.O, Phoneme.M),
    ]
    assert found.segments_other == (DifferingSegment(utterance, 0.05, pytest.approx(0.06), Phoneme.O, Phoneme.M),)
    assert len(compare(one, other, most=2).segments_one) == 2


def test_what_is_labelled_as_none_of_the_ten_is_no_gain() -> None:
    found = compare(scores(("??aa", "??aa")), scores(("??aa", "aaaa")))
    assert found.segments_one == ()
    assert [(d.n_frames, d.n_one) for d in found.differences] == [(2, 0)]
    assert found.only_one[Phoneme.UNIDENTIFIED] == 2


def test_a_preset_gets_nothing_right_that_it_misses_itself() -> None:
    same = scores(("aaoo", "aaom"))
    found = compare(same, same)
    assert (found.only_one.sum(), found.only_other.sum(), found.both.sum(), found.neither.sum()) == (0, 0, 3, 1)
    assert found.segments_one == found.segments_other == ()


def test_scores_of_other_recordings_are_not_compared() -> None:
    with pytest.raises(CorpusError, match="not scored on the same recordings"):
        compare(scores(("aa", "aa")), scores(("aa", "aa"), ("aa", "aa")))
