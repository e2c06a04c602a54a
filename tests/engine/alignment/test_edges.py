"""Edges of sounds lie where one becomes the next, finer than frames, and where speech has faded before a pause."""

from itertools import pairwise

import numpy as np
import pytest

from phonemeengine.alignment.aligner import Aligner
from phonemeengine.alignment.evidence import Evidence, joined
from phonemeengine.labels.utterance import Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from tests.engine.alignment.speaking import LOUD_SPEECH, heard, words


def found(evidence: Evidence, text: str) -> tuple[Word, ...]:
    aligner = Aligner(words(text), len(evidence))
    aligner.push(evidence)
    return aligner.finish(len(evidence) * FRAME_PERIOD).words


@pytest.mark.parametrize("share", [0.2, 0.4, 0.6, 0.8])
def test_an_edge_between_two_sounds_moves_with_their_likelihoods(share: float):
    """The later the i suits the frame before the edge less than the a after it, the later the edge."""
    evidence = heard(".sia.")
    evidence.probabilities[24, [Phoneme.I, Phoneme.A]] = share, 1 - share
    (word,) = found(evidence, "sia")
    edge = word.phones[1].end / FRAME_PERIOD
    assert edge == word.phones[2].start / FRAME_PERIOD
    assert abs(edge - round(edge)) > 1e-3
    assert abs(edge - (24 + share)) < 0.6


def test_edges_grow_with_the_share_of_the_first_sound():
    edges = []
    for share in (0.2, 0.4, 0.6, 0.8):
        evidence = heard(".sia.")
        evidence.probabilities[24, [Phoneme.I, Phoneme.A]] = share, 1 - share
        edges.append(found(evidence, "sia")[0].phones[1].end)
    assert edges == sorted(edges)
    assert edges[-1] - edges[0] > 0.002


@pytest.mark.parametrize("n_fading", [0, 3, 6, 9])
def test_a_word_ends_where_it_has_faded_though_silence_is_heard_before(n_fading: int):
    """28 dB below loud speech it has: a sound that falls by 3 dB a frame lasts while it is above that."""
    evidence = joined([heard(".sima"), heard("...."), heard("lupo.")])
    evidence.levels[40 : 40 + n_fading, 0] = LOUD_SPEECH - 14
    evidence.levels[40 + n_fading : 64, 0] = LOUD_SPEECH - 55
    first, second = found(evidence, "sima lupo")
    assert first.end / FRAME_PERIOD == pytest.approx(40 + n_fading, abs=0.51)
    assert second.start / FRAME_PERIOD == pytest.approx(72, abs=0.51)


def test_words_never_overlap_their_successors():
    evidence = joined([heard(".sima"), heard(".", 6), heard("lupo.")])
    evidence.levels[:, 0] = LOUD_SPEECH
    said = found(evidence, "sima lupo")
    assert all(one.end <= other.start for one, other in pairwise(said))
    assert np.isfinite([word.end for word in said]).all()
