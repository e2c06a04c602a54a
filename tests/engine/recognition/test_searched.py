"""The search through the scores of files: what it finds, and that it finds the same however the sound is cut."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.analyser import Analysis, analyse_blocks, concatenate_analyses
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.model_choice import for_files, for_live_use
from phonemeengine.recognition.decoder import ScoreSearch, SoundsDecoder, evidence_in
from phonemeengine.recognition.scores import SCORES, Recognition, ScoredRecogniser
from phonemeengine.recognition.searched import SEARCH_LAG, SearchedRecogniser
from phonemeengine.settings import SAMPLE_RATE, WINDOW, ModelKind
from tests.corpora import speech

OFFLINE = for_files(load_preset(DEFAULT_PRESET), ModelKind.OFFLINE)
SEARCH = ScoreSearch(1.5)
SOUND = speech()


def scores_of(*said: tuple[Phoneme, float, int]) -> np.ndarray:
    """Return scores of runs of a phoneme, its probability, and how many frames it lasts."""
    rows = np.concatenate([np.full((n, len(SCORES)), (1 - share) / 10, np.float32) for _, share, n in said])
    rows[np.arange(len(rows)), np.repeat([p for p, _, _ in said], [n for _, _, n in said])] = np.repeat(
        [share for _, share, _ in said], [n for _, _, n in said]
    )
    return rows


class Told(ScoredRecogniser):
    """Says scores that it was told, with no look-ahead."""

    look_ahead = 0

    def __init__(self, scores: np.ndarray) -> None:
        self._scores = scores

    def recognise(self, windows: np.ndarray, _features: Features) -> Recognition:
        new, self._scores = self._scores[: len(windows)], self._scores[len(windows) :]
        return Recognition(new.argmax(axis=1).astype(np.uint8), new, new[:, :3])


def said_of(scores: np.ndarray, step: int) -> Recognition:
    searched = SearchedRecogniser(Told(scores), SEARCH)
    nothing = Features((), np.zeros((step, 0), np.float32))
    found = [
        searched.recognise(np.zeros((step, WINDOW), np.float32), nothing) for _ in range(-(-len(scores) // step))
    ]
    assert all(len(part.decoded) == len(part.phonemes) for part in found)
    last = searched.finish()
    return replace(last, decoded=np.concatenate([part.decoded for part in (*found, last)]))


A, E, M, SILENCE = Phoneme.A, Phoneme.E, Phoneme.M, Phoneme.SILENCE


@pytest.mark.parametrize(
    ("said", "found"),
    [
        (((A, 0.9, 9), (E, 0.5, 1), (A, 0.9, 9)), ((A, 19),)),  # a blip that costs more than it tells
        (((A, 0.9, 9), (E, 0.97, 4), (A, 0.9, 9)), ((A, 9), (E, 4), (A, 9))),  # one that lasts is on time
        (((A, 0.9, 9), (E, 0.4, 3), (E, 0.9, 9)), ((A, 9), (E, 12))),  # hesitation belongs to what follows
        (((SILENCE, 0.9, 9), (M, 0.9, 300), (A, 0.9, 3)), ((SILENCE, 9), (M, 300), (A, 3))),
    ],
    ids=["blip", "change", "hesitation", "end"],
)
def test_what_does_not_last_is_left_out_and_what_lasts_comes_on_time(said, found):
    expected = np.repeat([p for p, _ in found], [n for _, n in found])
    for step in (1, 7, 400):
        np.testing.assert_array_equal(said_of(scores_of(*said), step).decoded, expected)


def test_a_batch_of_sounds_is_searched_as_each_alone_also_once_some_of_it_changes():
    rng = np.random.default_rng(2)
    sounds = [rng.dirichlet(np.full(len(SCORES), 0.3), n).astype(np.float32) for n in (1, 130, 0, 700)]
    batch = SoundsDecoder(np.cumsum([0, *(len(s) for s in sounds)]))
    for change in (1.0, 0.5):
        sounds[1] = sounds[1] ** change
        together = batch.decode(SEARCH, SEARCH_LAG, evidence_in(np.concatenate(sounds)))
        alone = np.concatenate([said_of(sound, 50).decoded for sound in sounds if len(sound)])
        np.testing.assert_array_equal(together, alone)


def analysed(step: int, preset=OFFLINE) -> Analysis:
    return concatenate_analyses(list(analyse_blocks(np.split(SOUND, range(step, len(SOUND), step)), preset)))


def test_files_change_less_often_by_it_and_any_cutting_finds_the_same():
    bare = replace(OFFLINE, settings=replace(OFFLINE.settings, hysteresis=0.0))
    found, without = analysed(SAMPLE_RATE), analysed(SAMPLE_RATE, bare)
    np.testing.assert_array_equal(found.phonemes, analysed(3001).phonemes)
    np.testing.assert_array_equal(found.recognised, without.phonemes)
    np.testing.assert_allclose(found.features.values, without.features.values, atol=1e-6)
    changes = [np.count_nonzero(np.diff(each.phonemes)) for each in (found, without)]
    assert 0 < changes[0] < changes[1]


def test_only_whole_sounds_are_searched_as_far_as_stability_says():
    assert OFFLINE.search == SEARCH
    assert for_files(OFFLINE, ModelKind.REAL_TIME).search is None
    assert for_live_use(load_preset(DEFAULT_PRESET)).search is None
    steadier = replace(OFFLINE, settings=replace(OFFLINE.settings, hysteresis=0.2))
    assert steadier.search == ScoreSearch(3.0)
    for off in ({"hysteresis": 0.0}, {"statistics": False}):
        assert replace(OFFLINE, settings=replace(OFFLINE.settings, **off)).search is None
