"""Every sound of the phonetic alphabet has a kind that is listened for, and sounds as its manner does."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.alignment.evidence import (
    KINDS,
    MANNERS,
    SHARES,
    Evidence,
    Manner,
    kind_of,
    least_frames_of,
    levels_of,
    log_likelihoods,
    measured_of,
    shortfalls_of,
    spoken_in,
)
from phonemeengine.labels.phone_sets import IPA, ipa_phoneme
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import HOP, WINDOW
from tests.engine.alignment.speaking import heard
from tests.sounds import noise, silence, tone

EVERY_SOUND = [name for _, certainty, names in IPA if certainty != "affricate" for name in names.split()]


def test_every_sound_of_the_phonetic_alphabet_is_listened_for():
    kinds = {ipa: KINDS[kind_of(ipa)] for ipa in EVERY_SOUND}
    assert {ipa: kind.phoneme for ipa, kind in kinds.items()} == {ipa: ipa_phoneme(ipa) for ipa in EVERY_SOUND}
    assert [ipa for ipa, kind in kinds.items() if kind.manner is Manner.SILENCE] == []
    assert [ipa for ipa in EVERY_SOUND if not 3 <= least_frames_of(ipa) <= 7] == []


def test_a_sound_that_nobody_knows_is_listened_for_as_an_unidentified_one():
    kind = KINDS[kind_of("𝕏")]
    assert (kind.phoneme, kind.manner) == (Phoneme.UNIDENTIFIED, Manner.APPROXIMANT)


def test_shares_of_phonemes_are_shares():
    assert set(SHARES) == set(Phoneme)
    assert sum(SHARES.values()) == pytest.approx(1.0, abs=0.03)
    assert all(sum(blob.weight for blob in MANNERS[manner]) == pytest.approx(1.0, abs=0.011) for manner in Manner)


def windows_of(sound: np.ndarray) -> np.ndarray:
    return np.lib.stride_tricks.sliding_window_view(sound, WINDOW)[::HOP]


def test_a_tone_is_as_loud_as_its_power_and_the_duller_the_deeper():
    deep, high = (levels_of(windows_of(tone(f, 0.2, 0.5)))[5] for f in (200.0, 4000.0))
    assert deep[0] == pytest.approx(10 * np.log10(0.5**2 / 2), abs=0.5)
    assert high[1] - high[0] > deep[1] - deep[0] + 20


def test_hiss_is_a_sibilant_a_deep_tone_a_nasal_and_quiet_silence():
    sound = np.concatenate([tone(200.0, 0.5, 0.3), noise(0.5, 0.1), silence(0.5)])
    levels = levels_of(windows_of(sound))
    speaks = np.repeat([1.0, 1.0, 0.0], 50)[: len(levels)].astype(np.float32)
    likely = log_likelihoods(measured_of(levels, speaks)).argmax(axis=1)
    assert [Manner(int(likely[k])) for k in (20, 65, 125)] == [Manner.NASAL, Manner.SIBILANT, Manner.SILENCE]


def test_what_suits_best_falls_short_of_nothing():
    probabilities = np.full((3, len(Phoneme)), 0.01, np.float32)
    probabilities[[0, 1, 2], [Phoneme.SILENCE, Phoneme.A, Phoneme.SZ]] = 0.9
    levels = np.array([[-80, -83], [-20, -41], [-31, -35]], np.float32)
    short = shortfalls_of(Evidence(probabilities, levels))
    best = [KINDS[k].phoneme for k in short.argmax(axis=1)]
    assert best == [Phoneme.SILENCE, Phoneme.A, Phoneme.SZ]
    assert (short.max(axis=1) == 0).all()


def test_what_is_seen_tells_unidentified_sounds_apart():
    """The recogniser calls n, k and f alike; the visemes that it hears tell which one it is."""
    evidence = heard("nkf")
    visemes = np.full((len(evidence), len(Viseme)), 0.01, np.float32)
    for k, viseme in enumerate((Viseme.NN, Viseme.KK, Viseme.FF)):
        visemes[8 * k : 8 * k + 8, viseme] = 0.86
    seen = shortfalls_of(replace(evidence, visemes=visemes))
    heard_alone = shortfalls_of(evidence)
    for k, (ipa, other) in enumerate((("n", "ŋ"), ("k", "t"), ("f", "θ"))):
        frames = slice(8 * k, 8 * k + 8)
        assert seen[frames, kind_of(ipa)] == pytest.approx(heard_alone[frames, kind_of(ipa)], abs=0.01)
        assert (seen[frames, kind_of(other)] < heard_alone[frames, kind_of(other)] - 1).all()


def test_where_there_is_no_sound_for_long_there_is_silence_whatever_the_recogniser_says():
    """A closure of a stop may be as quiet, but is short."""
    evidence = heard("sima" + 2 * "p" + 4 * "p" + "sima")
    evidence.levels[32:80] = -90.0
    evidence.levels[48:50] = -30.0
    spoken = spoken_in(evidence)
    assert spoken[:50].all()
    assert not spoken[50:80].any()
    assert spoken[80:].all()
    assert shortfalls_of(evidence)[50:80].argmax(axis=1).tolist() == [0] * 30
