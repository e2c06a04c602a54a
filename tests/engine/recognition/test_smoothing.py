"""The statistics step: a phoneme stays a while, and what is unidentified takes the likeliest successor."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.analyser import Analyser
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.segments import PhonemeSmoother
from phonemeengine.settings import AnalysisSettings
from tests.sounds import noise, silence, vowel

CODES = {"_": Phoneme.SILENCE, "?": Phoneme.UNIDENTIFIED, "a": Phoneme.A, "e": Phoneme.E, "m": Phoneme.M}
STAY = {p: p for p in Phoneme}
NAMES = {code: letter for letter, code in CODES.items()}
phonemes = st.lists(st.sampled_from(list(Phoneme)), max_size=60)


def calmed(text: str, minimum_hold: float, successors: dict[Phoneme, Phoneme] | None = None) -> str:
    raw = np.array([CODES[letter] for letter in text], np.uint8)
    out = PhonemeSmoother(minimum_hold, successors or STAY).smooth(raw)
    return "".join(NAMES[Phoneme(code)] for code in out.tolist())


def runs_of(codes: list[int]) -> list[int]:
    changes = np.flatnonzero(np.diff(codes)) + 1
    return [len(run) for run in np.split(np.array(codes), changes)]


@pytest.mark.parametrize(
    ("hold", "raw", "expected"),
    [
        (0.0, "_aea_", "_aea_"),
        (0.01, "_aea_", "_aea_"),
        (0.02, "aemmm", "aammm"),
        (0.03, "aemeeee", "aaaeeee"),
        (0.03, "aeaeaeae", "aaaeeeaa"),
    ],
)
def test_a_phoneme_stays_its_minimum_time(hold: float, raw: str, expected: str):
    assert calmed(raw, hold) == expected


def test_the_first_phoneme_need_not_wait():
    assert calmed("aaaa", 0.1) == "aaaa"


def test_what_is_unidentified_keeps_the_phoneme_before_it():
    assert calmed("aa??ee?", 0.0) == "aaaaeee"


def test_what_is_unidentified_takes_the_successor_from_the_table():
    assert calmed("a?m?", 0.0, {Phoneme.A: Phoneme.M, Phoneme.M: Phoneme.SILENCE}) == "amm_"


def test_a_successor_is_that_of_what_was_identified_last_not_of_what_was_filled_in():
    assert calmed("a??", 0.0, {Phoneme.A: Phoneme.M, Phoneme.M: Phoneme.E}) == "amm"


def test_a_successor_waits_too_until_the_minimum_time_is_over():
    assert calmed("a????", 0.03, {Phoneme.A: Phoneme.M}) == "aaamm"


@given(raw=phonemes, frames=st.integers(0, 8))
def test_no_phoneme_but_the_last_is_shorter_than_the_minimum(raw: list[Phoneme], frames: int):
    out = PhonemeSmoother(frames * 0.01).smooth(np.array(raw, np.uint8)).tolist()
    assert len(out) == len(raw)
    assert Phoneme.UNIDENTIFIED not in out
    after_the_silence_before = out[next((k for k, p in enumerate(out) if p != Phoneme.SILENCE), len(out)) :]
    assert all(run >= frames for run in runs_of(after_the_silence_before)[:-1])


@given(raw=phonemes, cuts=st.lists(st.integers(0, 60), max_size=6), frames=st.integers(0, 8))
def test_calming_does_not_depend_on_how_the_frames_were_cut(raw: list[Phoneme], cuts: list[int], frames: int):
    codes = np.array(raw, np.uint8)
    statistics = PhonemeSmoother(frames * 0.01)
    parts = [statistics.smooth(part) for part in np.split(codes, sorted(cuts))]
    np.testing.assert_array_equal(np.concatenate(parts), PhonemeSmoother(frames * 0.01).smooth(codes))


@given(raw=phonemes)
def test_frames_are_calmed_without_looking_ahead(raw: list[Phoneme]):
    codes = np.array(raw, np.uint8)
    whole = PhonemeSmoother(0.03).smooth(codes)
    for n in range(len(codes)):
        np.testing.assert_array_equal(PhonemeSmoother(0.03).smooth(codes[:n]), whole[:n])


def test_without_the_statistics_the_rules_have_the_last_word():
    sound = np.concatenate((silence(0.1), vowel((700, 1200), 0.2), noise(0.2, 0.2), silence(0.1)))
    off = Analyser(Preset(settings=AnalysisSettings(statistics=False))).push(sound)
    on = Analyser(Preset(settings=AnalysisSettings(statistics=True, minimum_hold=0.05))).push(sound)
    np.testing.assert_array_equal(off.phonemes, off.recognised)
    np.testing.assert_array_equal(on.recognised, off.recognised)
    np.testing.assert_array_equal(on.phonemes, PhonemeSmoother(0.05).smooth(on.recognised))
