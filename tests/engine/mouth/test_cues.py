"""Cues for animators: long enough to be seen, on time, and never losing lips that meet."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from phonemeengine.errors import MouthError
from phonemeengine.mouth.cues import Cue, cues_of, joined_by_shape
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.recognition.segments import Segment

TABLE = load_table("eleven")
FIVE = load_table("five")
A, E, M, P, S = Phoneme.A, Phoneme.E, Phoneme.M, Phoneme.P, Phoneme.SZ
SILENCE = Phoneme.SILENCE


def said(*parts: tuple[Phoneme, int]) -> list[Segment]:
    """Give runs of phonemes, each of so many milliseconds."""
    runs, at = [], 0
    for phoneme, length in parts:
        runs.append(Segment(at / 1000, (at + length) / 1000, phoneme, 0.5))
        at += length
    return runs


def shown(cues: tuple[Cue, ...]) -> list[tuple[Phoneme, int]]:
    return [(cue.phoneme, round(1000 * cue.duration)) for cue in cues]


def test_what_is_long_enough_stays_as_it_is() -> None:
    parts = ((SILENCE, 300), (M, 60), (A, 200), (S, 90), (SILENCE, 400))
    assert shown(cues_of(said(*parts), TABLE)) == list(parts)


def test_a_flicker_gives_its_time_to_both_sides() -> None:
    assert shown(cues_of(said((A, 200), (S, 20), (Phoneme.O, 200)), TABLE)) == [(A, 210), (Phoneme.O, 210)]


def test_a_flicker_within_a_phoneme_is_gone() -> None:
    assert shown(cues_of(said((A, 200), (E, 10), (A, 150)), TABLE)) == [(A, 360)]


def test_two_that_are_too_short_make_one_that_is_not() -> None:
    assert shown(cues_of(said((A, 200), (E, 30), (Phoneme.I, 40), (Phoneme.O, 200)), TABLE)) == [
        (A, 200),
        (Phoneme.I, 70),
        (Phoneme.O, 200),
    ]


@pytest.mark.parametrize("lips", [M, P])
def test_lips_that_meet_briefly_stay_shut_for_long_enough(lips: Phoneme) -> None:
    assert shown(cues_of(said((A, 200), (lips, 20), (Phoneme.O, 200)), TABLE)) == [
        (A, 180),
        (lips, 60),
        (Phoneme.O, 180),
    ]
    assert shown(cues_of(said((A, 70), (lips, 20), (Phoneme.O, 200)), TABLE)) == [
        (A, 60),
        (lips, 60),
        (Phoneme.O, 170),
    ]


def test_a_breath_is_no_pause() -> None:
    assert shown(cues_of(said((A, 200), (SILENCE, 30), (A, 200)), TABLE)) == [(A, 430)]
    assert shown(cues_of(said((A, 200), (SILENCE, 80), (A, 200)), TABLE)) == [(A, 200), (SILENCE, 80), (A, 200)]


def test_a_sound_that_is_too_short_is_one_cue() -> None:
    assert shown(cues_of(said((A, 20)), TABLE)) == [(A, 20)]
    assert shown(cues_of(said((A, 20), (E, 10)), TABLE)) == [(A, 30)]
    assert cues_of([], TABLE) == ()


def test_the_mouth_is_ahead_of_vowels_and_of_lips_that_meet_but_not_of_consonants() -> None:
    cues = cues_of(said((SILENCE, 500), (A, 300), (S, 300), (M, 300), (S, 300)), TABLE, anticipation=0.1)
    closed = 1.1 - TABLE.times[M].to_shape  # the lips have met when the m is heard
    assert [cue.start for cue in cues] == pytest.approx([0, 0.4, 0.8, closed, 1.4])


def test_anticipation_leaves_half_of_what_comes_before() -> None:
    cues = cues_of(said((S, 160), (A, 300)), TABLE, anticipation=0.12)
    assert [round(1000 * cue.start) for cue in cues] == [0, 80]
    cues = cues_of(said((S, 80), (A, 300)), TABLE, anticipation=0.12)
    assert [round(1000 * cue.start) for cue in cues] == [0, 60]


def test_a_drawing_that_stays_is_one() -> None:
    cues = joined_by_shape(cues_of(said((Phoneme.O, 200), (Phoneme.U, 100), (A, 100)), FIVE))
    assert [(cue.shape, round(1000 * cue.duration)) for cue in cues] == [("round", 300), ("open", 100)]


def test_intensities_are_means_over_time() -> None:
    runs = [Segment(0, 0.3, A, 0.9), Segment(0.3, 0.31, S, 0.0), Segment(0.31, 0.41, A, 0.5)]
    (cue,) = cues_of(runs, TABLE)
    assert cue.intensity == pytest.approx((0.305 * 0.9 + 0.105 * 0.5) / 0.41)


def test_a_silence_that_swallowed_a_flicker_has_no_intensity() -> None:
    (cue,) = cues_of(
        [Segment(0, 0.3, SILENCE, 0.0), Segment(0.3, 0.31, A, 0.9), Segment(0.31, 0.41, SILENCE, 0.0)], TABLE
    )
    assert (cue.phoneme, cue.intensity) == (SILENCE, 0)


phonemes = st.sampled_from(list(Phoneme))
speech = st.lists(st.tuples(phonemes, st.integers(1, 40).map(lambda n: 10 * n)), min_size=1, max_size=60)


@settings(deadline=None)
@given(speech, st.sampled_from([0.0, 0.02, 0.06, 0.15]), st.sampled_from([0.0, 0.05, 0.12]))
def test_cues_cover_the_sound_and_none_is_too_short(
    parts: list[tuple[Phoneme, int]], minimum: float, anticipation: float
) -> None:
    runs = said(*parts)
    cues = cues_of(runs, TABLE, minimum=minimum, anticipation=anticipation)
    assert cues[0].start == 0
    assert cues[-1].end == pytest.approx(runs[-1].end)
    assert all(one.end == pytest.approx(other.start) for one, other in pairwise(cues))
    assert all(one.phoneme != other.phoneme for one, other in pairwise(cues))
    assert len(cues) == 1 or min(cue.duration for cue in cues) > minimum - 1e-6
    assert all(0 <= cue.intensity <= 1 for cue in cues)


@settings(deadline=None)
@given(speech)
def test_cues_that_are_clean_stay_as_they_are(parts: list[tuple[Phoneme, int]]) -> None:
    once = cues_of(said(*parts), TABLE)
    runs = [Segment(cue.start, cue.end, cue.phoneme, cue.intensity) for cue in once]
    again = cues_of(runs, TABLE)
    assert [(c.phoneme, round(c.start, 9), round(c.end, 9)) for c in again] == [
        (c.phoneme, round(c.start, 9), round(c.end, 9)) for c in once
    ]


@settings(deadline=None)
@given(speech)
def test_the_mouth_is_never_late_nor_more_than_120_ms_early(parts: list[tuple[Phoneme, int]]) -> None:
    runs = said(*parts)
    late, early = cues_of(runs, TABLE), cues_of(runs, TABLE, anticipation=0.12)
    assert [cue.phoneme for cue in early] == [cue.phoneme for cue in late]
    for one, other in zip(late, early, strict=True):
        assert -1e-9 <= one.start - other.start <= 0.12 + 1e-9
        if one.phoneme not in {*VOWELS, *TABLE.closed_phonemes}:
            assert one.start == other.start


def test_an_hour_has_no_cue_that_is_too_short() -> None:
    generator = np.random.default_rng(0)
    parts = [(Phoneme(int(generator.integers(0, 11))), int(generator.integers(1, 20)) * 10) for _ in range(36_000)]
    cues = cues_of(said(*parts), TABLE)
    assert min(cue.duration for cue in cues) > 0.0599


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"minimum": -0.1}, "minimum must lie in 0..1 s, got -0.1; choose another value"),
        ({"minimum": float("nan")}, "minimum must lie in 0..1 s, got nan; choose another value"),
        ({"anticipation": 0.2}, "anticipation must lie in 0..0.12 s, got 0.2; choose another value"),
    ],
)
def test_impossible_times_are_refused(options: dict[str, float], sentence: str) -> None:
    with pytest.raises(MouthError) as refusal:
        cues_of([], TABLE, **options)
    assert str(refusal.value) == sentence
