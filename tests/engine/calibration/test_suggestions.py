"""Suggested variables: where phonemes differ is known from how they were made."""

from dataclasses import replace

import numpy as np
import pytest
import soundfile

from phonemeengine.calibration.fits.suggestions import (
    MOST_FRAMES,
    MOST_SUGGESTIONS,
    sampled_spectra,
    suggested_variables,
    suggestions_from,
)
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.workbench.distributions import distribution_of, separability
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Cancelled
from phonemeengine.features.variables import Spectrum, Variable, check_user_variables
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.settings import SAMPLE_RATE, Filter
from tests.labelled import recordings
from tests.sounds import noise, tone

THESIS = load_preset(FACTORY / "thesis.toml")
A, E, I, M, U = Phoneme.A, Phoneme.E, Phoneme.I, Phoneme.M, Phoneme.U  # noqa: E741


def tones(folder, **frequencies: float) -> LabelledUtterance:
    """A recording of 1 s for each phoneme: a tone of its own beside one of 300 Hz and a hiss that all have."""
    sounds, labels = [], []
    for k, (name, frequency) in enumerate(frequencies.items()):
        sounds.append(tone(300, 1.0, 0.3) + tone(frequency, 1.0, 0.2) + noise(1.0, 0.05, k))
        labels.append(Label(k, k + 1.0, name, Phoneme[name.upper()]))
    soundfile.write(folder / "tones.wav", np.concatenate(sounds), SAMPLE_RATE, subtype="FLOAT")
    return LabelledUtterance(folder / "tones.wav", tuple(labels), "nobody", "made")


@pytest.fixture
def bench(tmp_path) -> LabelledFeatures:
    return LabelledFeatures([tones(tmp_path, a=1000, e=2000)], THESIS)


def test_the_best_ranges_lie_where_the_phonemes_differ(bench):
    found = suggested_variables(bench, THESIS, A, E)
    assert 1 <= len(found) <= MOST_SUGGESTIONS
    best = found[0]
    assert best.separation > 0.99
    assert best.variable.low <= 1000 <= best.variable.high or best.variable.low <= 2000 <= best.variable.high


def test_a_suggestion_that_is_added_separates_as_it_says_with_its_threshold(bench):
    found = suggested_variables(bench, THESIS, A, E)
    preset = replace(THESIS, variables=tuple(s.variable for s in found))
    measured = LabelledFeatures(bench.utterances, preset, known=bench)
    for suggestion in found:
        name = suggestion.variable.name
        assert distribution_of(measured, name).separations[A, E] == pytest.approx(suggestion.separation, abs=1e-4)
        own, other = (measured.values(name)[measured.labels.phonemes == p] for p in (A, E))
        parted = [abs((own > t).mean() - (other > t).mean()) for t in (suggestion.threshold, *own, *other)]
        assert parted[0] == pytest.approx(max(parted), abs=0.021)  # two frames, since its digits are few


def test_ranges_that_overlap_with_no_better_one_come_first(tmp_path):
    bench = LabelledFeatures(recordings(tmp_path), THESIS)
    found = suggested_variables(bench, THESIS, I, U)
    n_apart = next(
        (
            k
            for k, s in enumerate(found)
            if any(s.variable.low < t.variable.high and t.variable.low < s.variable.high for t in found[:k])
        ),
        len(found),
    )
    assert n_apart >= 2
    separations = [s.separation for s in found[:n_apart]]
    assert separations == sorted(separations, reverse=True)
    assert separations[0] == max(s.separation for s in found)


def test_one_phoneme_is_parted_from_all_others(tmp_path):
    bench = LabelledFeatures([tones(tmp_path, a=1000, e=2000, u=3000)], THESIS)
    best = suggested_variables(bench, THESIS, U)[0]
    assert best.separation > 0.99
    assert best.variable.low <= 3000 <= best.variable.high
    assert best.variable.name.startswith("u_rest_")


def test_names_are_free_and_whoever_adds_all_suggestions_is_not_refused(bench):
    first = suggested_variables(bench, THESIS, A, E)
    taken = replace(THESIS, variables=tuple(s.variable for s in first))
    again = suggested_variables(bench, taken, A, E)
    assert [s.separation for s in again] == [s.separation for s in first]
    check_user_variables((*taken.variables, *(s.variable for s in again)))


def test_a_sample_holds_spectra_as_the_variables_see_them(tmp_path):
    utterances = recordings(tmp_path)
    whole = (Variable("all_f", 0, 20000, source=Spectrum.FILTERED), Variable("all_n", 0, 20000))
    filters = THESIS.settings.filters | {Filter.DENOISE, Filter.TIME_SMOOTH}
    settings = replace(THESIS.settings, filters=filters, denoise_threshold=0.001, time_smooth=0.5)
    preset = replace(THESIS, settings=settings, variables=whole)
    bench, sample = LabelledFeatures(utterances, preset), sampled_spectra(utterances, preset)
    for name, source in (("all_f", Spectrum.FILTERED), ("all_n", Spectrum.NORMALISED)):
        for phoneme in (A, Phoneme.SILENCE):
            expected = bench.values(name)[bench.labels.phonemes == phoneme]
            assert sample.of(source, [phoneme]).sum(axis=1) == pytest.approx(expected, rel=1e-3, abs=1e-5)


def test_a_sample_takes_at_most_so_many_frames_of_a_phoneme(tmp_path):
    (first, *_) = recordings(tmp_path)
    sample = sampled_spectra([first] * 100, THESIS)  # 6000 frames of silence
    counts = np.bincount(sample.phonemes, minlength=len(Phoneme))
    assert counts[Phoneme.SILENCE] == MOST_FRAMES
    assert counts[M] == 0


def test_a_phoneme_that_nobody_says_is_told(bench):
    with pytest.raises(CorpusError, match="labelled m"):
        suggested_variables(bench, THESIS, A, M)
    with pytest.raises(CorpusError, match="labelled m"):
        suggested_variables(bench, THESIS, M)


def test_equal_sounds_give_no_suggestion(tmp_path):
    same = tones(tmp_path, a=1000)
    halves = (Label(0.0, 0.5, "a", A), Label(0.5, 1.0, "e", E))
    sample = sampled_spectra([replace(same, labels=halves)], THESIS)
    shuffled = replace(sample, phonemes=np.random.default_rng(1).permutation(sample.phonemes))
    for suggestion in suggestions_from(shuffled, THESIS, A, E):
        assert suggestion.separation < 0.75  # chance alone, over thousands of ranges
    assert separability(sample.of(Spectrum.NORMALISED, [A])[:, 0], sample.of(Spectrum.NORMALISED, [E])[:, 0]) < 0.75


def test_a_search_says_how_far_it_is_and_ends_when_it_shall(bench):
    told: list[float] = []
    suggested_variables(bench, THESIS, A, E, progress=lambda share: told.append(share) is None)
    assert told == sorted(told)
    for last in (0.2, 0.7):
        with pytest.raises(Cancelled):
            suggested_variables(bench, THESIS, A, E, progress=lambda share, last=last: share < last)
