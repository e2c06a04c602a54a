"""Moving boundaries: to where the evidence changes, no farther than is allowed, and not between like sounds."""

import numpy as np
import pytest

from phonemeengine.calibration.fine_tuning import N_SOFT_LABELS
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemetraining.realignment import FARTHEST, evidence_of, moves_of, realigned

SIL, A, SZ, U = Phoneme.SILENCE, Phoneme.A, Phoneme.SZ, Phoneme.UNIDENTIFIED


def heard(*said: tuple[Phoneme, float]) -> np.ndarray:
    """What a sure listener hears, every 5 ms, in sounds that last so many seconds."""
    rows = []
    for phoneme, seconds in said:
        row = np.full(N_SOFT_LABELS, 0.01)
        row[phoneme] = 0.9
        rows += [row] * round(seconds / 0.01)
    found = np.array(rows)
    return evidence_of(found.astype(np.float16))


def labels(*said: tuple[str, Phoneme, float]) -> tuple[Label, ...]:
    found, at = [], 0.0
    for phone, phoneme, end in said:
        found.append(Label(at, end, phone, phoneme))
        at = end
    return tuple(found)


@pytest.mark.parametrize("off", [-0.03, -0.01, 0.0, 0.02])
def test_a_boundary_moves_to_where_the_sound_changes(off: float):
    told = labels(("SIL", SIL, 0.2), ("a", A, 0.4 + off), ("s", SZ, 0.6))
    found = realigned(told, heard((SIL, 0.2), (A, 0.2), (SZ, 0.2)))
    assert [label.end for label in found] == pytest.approx([0.2, 0.4, 0.6], abs=0.006)
    assert [label.start for label in found[1:]] == [label.end for label in found[:-1]]
    assert moves_of(told, found) == pytest.approx([0, -off], abs=0.006)


def test_no_boundary_moves_farther_than_allowed_and_no_phone_vanishes():
    told = labels(("SIL", SIL, 0.2), ("a", A, 0.23), ("s", SZ, 0.6))
    found = realigned(told, heard((SIL, 0.4), (SZ, 0.2)))  # nobody says a
    assert np.abs(moves_of(told, found)).max() <= FARTHEST + 1e-9
    assert found[1].end - found[1].start >= 0.0149


def test_between_sounds_that_are_heard_alike_the_boundary_stays():
    told = labels(("SIL", SIL, 0.2), ("l", U, 0.31), ("l", U, 0.4), ("SIL", SIL, 0.6))
    found = realigned(told, heard((SIL, 0.22), (U, 0.2), (SIL, 0.18)))
    assert [label.end for label in found] == pytest.approx([0.22, 0.31, 0.42, 0.6], abs=0.006)


def test_labels_that_leave_gaps_stay():
    told = (Label(0, 0.1, "a", A), Label(0.2, 0.3, "s", SZ))
    assert realigned(told, heard((A, 0.15), (SZ, 0.15))) == told
