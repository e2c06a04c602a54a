"""Where something else was recognised than was said."""

import numpy as np

from phonemeengine.calibration.scores.corpus import frame_labels_of
from phonemeengine.calibration.scores.scoring import label_errors
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme

LABELS = (
    Label(0.0, 0.2, "a", Phoneme.A),
    Label(0.2, 0.4, "ə", Phoneme.E, "ambiguous"),
    Label(0.4, 0.6, "t", Phoneme.UNIDENTIFIED),
    Label(0.6, 0.8, "o", Phoneme.O),
)


def errors(codes: np.ndarray, **options: float) -> list[tuple[float, float, Phoneme, Phoneme]]:
    found = label_errors(frame_labels_of(LABELS), codes, **options)
    return [(round(e.start, 3), round(e.end, 3), e.said, e.recognised) for e in found]


def test_only_sure_labels_can_be_missed() -> None:
    assert errors(np.full(80, Phoneme.U, np.uint8)) == [
        (0.0, 0.2, Phoneme.A, Phoneme.U),
        (0.6, 0.8, Phoneme.O, Phoneme.U),
    ]


def test_an_error_is_seen_at_the_end_of_the_first_frame_that_is_recognised_so() -> None:
    codes = frame_labels_of(LABELS).phonemes.copy()
    codes[5], codes[6:12] = Phoneme.M, Phoneme.P
    (found,) = label_errors(frame_labels_of(LABELS), codes)
    assert (found.recognised, round(found.start, 3), round(found.seen_at, 3)) == (Phoneme.P, 0.05, 0.07)


def test_what_is_shorter_than_labels_are_exact_is_no_error() -> None:
    codes = frame_labels_of(LABELS).phonemes.copy()
    assert errors(codes) == []
    codes[5:7] = codes[15:18] = Phoneme.P
    assert errors(codes) == [(0.15, 0.18, Phoneme.A, Phoneme.P)]
    assert len(errors(codes, least=0.02)) == 2


def test_fewer_frames_than_labels_are_compared_as_far_as_they_go() -> None:
    assert errors(np.full(10, Phoneme.O, np.uint8)) == [(0.0, 0.1, Phoneme.A, Phoneme.O)]
    assert errors(np.zeros(0, np.uint8)) == []
