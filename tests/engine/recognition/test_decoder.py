"""The search behind the answers of rules: what it finds, and that it finds the same however a sound comes."""

from dataclasses import replace
from itertools import pairwise, product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from phonemeengine import Analyser, PresetError, load_preset
from phonemeengine.analyser import concatenate_analyses
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import for_live_use, frames_ahead, model_in_words
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.decoder import PER_NAT, Decoder, SoundDecoder, SoundsDecoder, Trellis, bigrams_of
from phonemeengine.settings import DECODINGS, Decoding
from tests.sounds import noise, tone

A, E, SZ, SILENCE = Phoneme.A, Phoneme.E, Phoneme.SZ, Phoneme.SILENCE
LANGUAGES = [value for _, value in DECODINGS if value not in {Decoding.OFF, Decoding.NONE}]
EXTENDED = load_preset("extended")


def decoder(language: Decoding = Decoding.NONE, change_cost: float = 4.0) -> Decoder:
    return Decoder(EXTENDED.confusions, change_cost, language)


def heard(answers: np.ndarray, lag: int, cuts: list[int], by: Decoder) -> np.ndarray:
    search = SoundDecoder(Trellis(by, lag))
    return np.concatenate([*map(search.decode, np.split(answers, cuts)), search.finish()])


@hypothesis_settings(max_examples=8)
@given(
    seed=st.integers(0, 99),
    lengths=st.lists(st.sampled_from([0, 1, 3, 40, 300]), min_size=1, max_size=4),
    lag=st.integers(0, 5),
    language=st.sampled_from([Decoding.NONE, Decoding.GERMAN]),
)
def test_a_sound_cut_anywhere_and_many_sounds_at_once_are_decoded_alike(
    seed: int, lengths: list[int], lag: int, language: Decoding
) -> None:
    chance, edges = np.random.default_rng(seed), np.concatenate([[0], np.cumsum(lengths)])
    answers = np.repeat(chance.integers(0, 11, edges[-1]), 3)[: edges[-1]].astype(np.uint8)
    whole, by = SoundsDecoder(edges), decoder(language)
    for _ in range(2):  # the second time only what changed is searched
        found = whole.decode(by, lag, answers)
        for first, end in pairwise(edges):
            cuts = np.sort(chance.integers(0, end - first + 1, 5)).tolist()
            assert found[first:end].tolist() == heard(answers[first:end], lag, cuts, by).tolist()
        answers = np.where(chance.random(edges[-1]) < 0.02, np.uint8(A), answers)


def test_it_finds_the_best_of_all_courses() -> None:
    by = decoder(Decoding.GERMAN, 1.0)
    codes, evidence, costs = by.phonemes, by.evidence, by.costs
    answers = np.array([A, E, A, SZ], np.uint8)

    def worth(course: tuple[int, ...]) -> int:
        changes = sum(int(costs[one, other]) for one, other in pairwise((0, *course)) if one != other)
        return sum(int(evidence[k, a]) for k, a in zip(course, answers, strict=True)) - changes

    best = max(product(range(len(codes)), repeat=len(answers)), key=worth)
    assert heard(answers, 5, [], by).tolist() == codes[list(best)].tolist()


def test_a_single_frame_is_passed_over_and_a_long_one_is_not() -> None:
    answers = np.repeat(np.array([A, SZ, A, SZ], np.uint8), [20, 1, 20, 10])
    assert heard(answers, 5, [], decoder()).tolist() == [A] * 41 + [SZ] * 10


def test_every_language_has_statistics_that_make_changes_cheaper_and_dearer() -> None:
    for language in LANGUAGES:
        less, costs = bigrams_of(language), decoder(language).costs
        assert less.min() < -0.5, language
        assert less.max() > 0.5, language
        assert costs.max() <= 13 * PER_NAT, "what the runtime in C accepts is more than that"


def test_it_waits_no_longer_than_the_preset_says_and_keeps_the_answers_of_the_rules() -> None:
    sound = np.concatenate([tone(300, 0.3), noise(0.3, 0.1)])
    bare = replace(EXTENDED, settings=replace(EXTENDED.settings, statistics=False))
    for live, n in ((True, 2), (False, 5)):
        analyser = Analyser(EXTENDED, live=live)
        early = analyser.push(sound)
        whole = concatenate_analyses([early, analyser.finish()])
        plain = Analyser(bare, live=live)
        rules = concatenate_analyses([first := plain.push(sound), plain.finish()])
        assert len(first) - len(early) == n
        assert whole.recognised.tolist() == rules.recognised.tolist()
        assert whole.phonemes.tolist() != rules.phonemes.tolist()
        assert np.array_equal(whole.features["volume"], rules.features["volume"])
    assert frames_ahead(for_live_use(EXTENDED)) == 2
    assert model_in_words(EXTENDED) == "rules with a decoder, look-ahead 50 ms"
    assert model_in_words(EXTENDED.with_decoder(Decoding.OFF)) == "rules"


def test_what_is_no_table_of_confusions_is_refused_and_so_is_a_decoder_without_one() -> None:
    row = EXTENDED.confusions[A]
    for bad in ({A: row}, {SILENCE: row[:-1]}, {SILENCE: (*row[:-1], 0.5)}, {SILENCE: (*row[:-1], float("nan"))}):
        with pytest.raises(PresetError, match=r"^confusions "):
            Preset(confusions=bad)
    with pytest.raises(PresetError, match="has no decoder"):
        load_preset("templates").with_decoder(Decoding.ENGLISH)
    assert load_preset("templates").with_decoder(None) == load_preset("templates")
