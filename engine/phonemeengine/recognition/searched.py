"""The recogniser of files, by whose scores a search looks for the likeliest course of phonemes.

Live sound has hysteresis: a phoneme stays while it is nearly as good as the best one, so each change comes late. A
file can wait to see whether a change lasts: it changes as seldom, and on time.
"""

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.features.variables import Features
from phonemeengine.recognition.decoder import ScoreSearch, SoundDecoder, evidence_in
from phonemeengine.recognition.scores import SCORES, Recognition, ScoredRecogniser
from phonemeengine.recognition.spec import Finishing, Recogniser
from phonemeengine.settings import WINDOW

SEARCH_LAG = 5
"""Frames that the search looks ahead; more gain nothing."""


class SearchedRecogniser(ScoredRecogniser):
    """Says what a recogniser by scores says, and what a search finds behind that.

    Parameters
    ----------
    recogniser : whose scores they are.
    search : what the search goes by.
    """

    def __init__(self, recogniser: Recogniser, search: ScoreSearch) -> None:
        self.look_ahead = recogniser.look_ahead + SEARCH_LAG
        self._recogniser = recogniser
        self._search = SoundDecoder(search.trellis(SEARCH_LAG))
        self._waiting: list[Recognition] = []

    def recognise(self, windows: Float32Array, features: Features) -> Recognition:
        """Recognise the next frames; the answers are about those before of which nothing was said yet."""
        return self._found(self._recogniser.recognise(windows, features))

    def finish(self) -> Recognition:
        """Return the answers for all frames that are left."""
        rest = self._recogniser
        if isinstance(rest, Finishing):
            last = rest.finish()
        else:
            silence = np.zeros((rest.look_ahead, WINDOW), np.float32)
            last = rest.recognise(silence, Features((), np.zeros((len(silence), 0), np.float32)))
        return self._found(last, ended=True)

    def _found(self, new: Recognition, *, ended: bool = False) -> Recognition:
        """Return what is known by now of the frames that wait."""
        scores = np.zeros((0, len(SCORES)), np.float32) if new.scores is None else new.scores
        decoded = self._search.decode(evidence_in(scores))
        if ended:
            decoded = np.concatenate((decoded, self._search.finish()))
        waiting = [each for each in (*self._waiting, new) if len(each.phonemes)] or [new]
        joined = waiting[0] if len(waiting) == 1 else _joined(waiting)
        n = len(decoded)
        self._waiting = [_part(joined, slice(n, None))]
        return _part(joined, slice(0, n), decoded)


def searched(recogniser: Recogniser, search: ScoreSearch | None) -> Recogniser:
    """Return a recogniser with a search behind its scores; None for none."""
    return recogniser if search is None else SearchedRecogniser(recogniser, search)


def _joined(parts: list[Recognition]) -> Recognition:
    scores = [part.scores for part in parts if part.scores is not None]
    visemes = [part.visemes for part in parts if part.visemes is not None]
    return Recognition(
        np.concatenate([part.phonemes for part in parts]),
        np.concatenate(scores) if scores else None,
        np.concatenate(visemes) if visemes else None,
        parts[-1].viseme_set,
    )


def _part(of: Recognition, frames: slice, decoded: UInt8Array | None = None) -> Recognition:
    scores, visemes = (None if values is None else values[frames] for values in (of.scores, of.visemes))
    return Recognition(of.phonemes[frames], scores, visemes, of.viseme_set, decoded)
