"""The likeliest course of phonemes behind answers or scores: a Viterbi search that looks a few frames ahead.

Rules err in known ways, so each answer is evidence for several phonemes, by a table of confusions; scores are
evidence themselves. A change of phoneme costs something; with the statistics of a language, some changes cost less
than others. All costs are whole parts of a nat, so every machine finds the same course.
"""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from typing_extensions import override

from phonemeengine.arrays import BoolArray, Float32Array, IndexArray, UInt8Array
from phonemeengine.errors import PresetError
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import PHONEMES_BY_LABEL, Phoneme
from phonemeengine.recognition.rules import RuleRecogniser
from phonemeengine.recognition.scores import LEAST_SHARE, Recognition, Trace
from phonemeengine.settings import FRAME_PERIOD, Decoding

Int32Array = NDArray[np.int32]
Answers = NDArray[Any]
"""Codes of what rules say of each frame (uint8), or what `evidence_in` makes of scores (int32)."""
Confusions = Mapping[Phoneme, tuple[float, ...]]
"""By phoneme that is spoken, how likely each answer is, in nats below certainty."""

PER_NAT = 32
"""Parts of a nat in which costs are counted."""
LEAST_EVIDENCE = -20.0
NOTHING = len(Phoneme)
"""The answer that is evidence for no phoneme; the search ends with as many as it looks ahead."""
BIGRAMS = Path(__file__).with_name("bigrams.toml")
"""By language and phoneme, how much less a change to each phoneme costs, nats."""
_PAST_BITS = 20
_PAST = (1 << _PAST_BITS) - 1
"""The phonemes of the last five frames, the newest lowest, four bits each: that many frames it may look ahead."""
_STEPS = 64
"""Frames of the parts of sounds that are searched beside one another."""
_MANY = 256
"""Answers at once from which on a sound is cut into such parts."""


def check_confusions(confusions: Confusions) -> None:
    """Refuse a table of confusions that is not one.

    Raises
    ------
    PresetError : silence has no row, or a row does not have a number within -20..0 for each answer.
    """
    if confusions and Phoneme.SILENCE not in confusions:
        raise PresetError("confusions lacks silence, with which every sound begins; add it")
    for phoneme, row in confusions.items():
        if len(row) != len(Phoneme) or not all(LEAST_EVIDENCE <= value <= 0 for value in row):
            raise PresetError(
                f"confusions of {phoneme.label} are {len(Phoneme)} numbers in {LEAST_EVIDENCE:g}..0 nats, one for "
                f"each answer; found {len(row)}"
            )


@dataclass(frozen=True)
class Decoder:
    """What a search goes by.

    Attributes
    ----------
    confusions : the phonemes that it may find, and what the rules say while each is spoken.
    change_cost : what a change of phoneme costs, nats.
    language : whose statistics make some changes cheaper; ``none`` for none.
    """

    confusions: Confusions
    change_cost: float
    language: Decoding = Decoding.NONE

    @property
    def phonemes(self) -> UInt8Array:
        """The codes of the phonemes that it may find."""
        return np.array(sorted(self.confusions), np.uint8)

    @property
    def evidence(self) -> Int32Array:
        """What each answer says of each phoneme, shape (n_found, n_phonemes), in parts of a nat, 0 or less."""
        rows = [self.confusions[Phoneme(code)] for code in self.phonemes.tolist()]
        evidence: Int32Array = np.rint(PER_NAT * np.array(rows)).astype(np.int32)
        return evidence

    @property
    def costs(self) -> Int32Array:
        """What a change from each phoneme to each other costs, shape (n_found, n_found), in parts of a nat."""
        found = self.phonemes
        less = bigrams_of(self.language)[np.ix_(found, found)]
        costs: Int32Array = np.rint(PER_NAT * np.maximum(self.change_cost - less, 0)).astype(np.int32)
        return costs

    def trellis(self, lag: int) -> "Trellis":
        """Return the search that looks some frames ahead."""
        return Trellis(self, lag)


@dataclass(frozen=True)
class ScoreSearch:
    """What a search through scores goes by.

    Attributes
    ----------
    change_cost : what a change of phoneme costs, 0..15 nats.
    """

    change_cost: float

    def trellis(self, lag: int) -> "ScoreTrellis":
        """Return the search that looks some frames ahead."""
        return ScoreTrellis(self.change_cost, lag)


def evidence_in(scores: Float32Array) -> Int32Array:
    """Return what probabilities, shape (n_frames, n_phonemes), tell a `ScoreTrellis`."""
    told: Int32Array = np.rint(PER_NAT * np.log(np.maximum(scores, LEAST_SHARE))).astype(np.int32)
    return told << _PAST_BITS


@cache
def bigrams_of(language: Decoding) -> NDArray[np.float64]:
    """Return how much less a change from each phoneme to each other costs, nats, shape (n_phonemes, n_phonemes)."""
    less = np.zeros((len(Phoneme), len(Phoneme)))
    if language not in {Decoding.OFF, Decoding.NONE}:
        rows: dict[str, Any] = tomllib.loads(BIGRAMS.read_text(encoding="utf-8"))[language]
        for label, row in rows.items():
            less[PHONEMES_BY_LABEL[label]] = row
    return less


class Trellis:
    """The search over any number of sounds at once, a frame at a time.

    Its state is a number for each phoneme: how good the best course is that ends there, and above which phonemes it
    came. Both are one whole number, so the larger one is the better course, and equal ones need no further rule.

    Parameters
    ----------
    decoder : what it goes by.
    lag : frames that it looks ahead, 0..5.
    """

    def __init__(self, decoder: Decoder, lag: int) -> None:
        self.lag = lag
        self._phonemes = decoder.phonemes
        self._own = self._phonemes.astype(np.int32)[:, np.newaxis]
        evidence = decoder.evidence << _PAST_BITS
        self._evidence = np.concatenate([evidence, np.zeros_like(evidence[:, :1])], axis=1)
        costs = decoder.costs << _PAST_BITS
        self._costs = costs[:, :, np.newaxis]
        self._cost = int(costs[0, 0]) if (costs == costs[0, 0]).all() else None
        self.start: Int32Array = np.where(self._own == Phoneme.SILENCE, 0, -costs[:1].T).astype(np.int32)

    def nothing(self, n_frames: int) -> Answers:
        """Return what tells nothing of as many frames of one sound."""
        return np.full(n_frames, NOTHING, np.uint8)

    def _evidence_of(self, answer: NDArray[Any]) -> NDArray[Any]:
        """Return what an answer of each sound says of each phoneme, shape (n_found, n_sounds)."""
        return np.take(self._evidence, answer, axis=1, mode="clip")

    def run(self, answers: Answers, states: Int32Array) -> tuple[UInt8Array, Int32Array]:
        """Go on with the next answers; return what was said `lag` frames before each, and the states after them.

        Parameters
        ----------
        answers : codes of `Phoneme`, or `NOTHING`, shape (n_frames, n_sounds).
        states : of each sound, shape (n_found, n_sounds).
        """
        out = np.empty((len(answers), answers.shape[-1]), np.uint8)
        states = states.copy()
        past = np.empty_like(states)
        for said, answer in zip(out, answers, strict=True):
            np.bitwise_and(states, _PAST, out=past)
            states -= past
            past <<= 4
            past |= self._own
            past &= _PAST
            states |= past
            if self._cost is not None:  # the same for all, so the best course of all is the best one to come from
                entered = states.max(axis=0) - self._cost
            else:
                entered = (states[:, np.newaxis] - self._costs).max(axis=0)
            np.maximum(states, entered, out=states)
            states += self._evidence_of(answer)
            best = states.max(axis=0)
            if self.lag:
                said[:] = best >> 4 * (self.lag - 1) & 15
            else:
                said[:] = self._phonemes[states.argmax(axis=0)]
            best &= ~_PAST
            states -= best
        return out, states

    def run_in_lanes(
        self,
        answers: Answers,
        follows: BoolArray,
        todo: IndexArray,
        starts: Int32Array,
        found: tuple[UInt8Array, Int32Array],
    ) -> None:
        """Run parts of sounds beside one another, each again until it begins as the one before it ends.

        Parameters
        ----------
        answers : of each part, shape (n_frames, n_parts), or (n_frames, n_phonemes, n_parts) of a `ScoreTrellis`.
        follows : which parts go on with the sound of the one before, shape (n_parts,).
        todo : the parts to run; what is known of others holds.
        starts : the state with which each begins, at first a guess where it follows another, shape
            (n_found, n_parts).
        found : what is said, shape (n_frames, n_parts), and the states at the ends, as `starts`; both are written to.
        """
        said, ends = found
        while len(todo):
            said[:, todo], ends[:, todo] = self.run(answers[..., todo], starts[:, todo])
            after = todo[todo < len(follows) - 1] + 1
            after = after[follows[after]]
            todo = after[(ends[:, after - 1] != starts[:, after]).any(axis=0)]
            starts[:, todo] = ends[:, todo - 1]


class ScoreTrellis(Trellis):
    """The search through scores: each frame brings evidence of its own, as `evidence_in` gives it.

    Parameters
    ----------
    change_cost : what a change of phoneme costs, nats.
    lag : frames that it looks ahead, 0..5.
    """

    def __init__(self, change_cost: float, lag: int) -> None:
        super().__init__(Decoder(dict.fromkeys(Phoneme, (0.0,) * len(Phoneme)), change_cost), lag)

    @override
    def nothing(self, n_frames: int) -> Int32Array:
        """Return evidence that tells nothing of as many frames of one sound."""
        return np.zeros((n_frames, len(Phoneme)), np.int32)

    @override
    def _evidence_of(self, answer: NDArray[Any]) -> NDArray[Any]:
        return answer


class SoundDecoder:
    """The search over one sound, whose answers come in chunks.

    Parameters
    ----------
    trellis : the search.
    """

    def __init__(self, trellis: Trellis) -> None:
        self._trellis = trellis
        self._state = trellis.start
        self._early = trellis.lag

    def decode(self, answers: Answers) -> UInt8Array:
        """Take the next answers, or evidence, and return what is known by now: nothing about the newest frames."""
        n_lanes = len(answers) // _STEPS if len(answers) >= _MANY else 0
        laid = answers[: n_lanes * _STEPS].reshape(n_lanes, _STEPS, *answers.shape[1:])
        said = [self._decode_lanes(np.moveaxis(laid, 0, -1))] if n_lanes else []
        rest, self._state = self._trellis.run(answers[n_lanes * _STEPS :, ..., np.newaxis], self._state)
        known = np.concatenate([*said, rest[:, 0]])[self._early :]
        self._early = max(0, self._early - len(answers))
        return known

    def finish(self) -> UInt8Array:
        """Return what is said of the last frames, since no answers follow."""
        return self.decode(self._trellis.nothing(self._trellis.lag))

    def _decode_lanes(self, answers: Answers) -> UInt8Array:
        n = answers.shape[-1]
        starts = np.repeat(self._state, n, axis=1)
        said, ends = np.empty((len(answers), n), np.uint8), np.empty_like(starts)
        self._trellis.run_in_lanes(answers, np.arange(n) > 0, np.arange(n), starts, (said, ends))
        self._state = ends[:, -1:]
        return said.T.reshape(-1)


class SoundsDecoder:
    """The search over whole sounds that follow one another, again and again: only what changed is searched anew.

    Parameters
    ----------
    edges : the first frame of each sound, and the number of all frames, shape (n_sounds + 1,).
    """

    def __init__(self, edges: IndexArray) -> None:
        self._edges = edges
        self._key: object = None
        self._laid: Answers | None
        self._found: tuple[UInt8Array, Int32Array]

    def decode(self, decoder: Decoder | ScoreSearch, lag: int, answers: Answers) -> UInt8Array:
        """Return what a search says of each frame, shape (n_frames,).

        Parameters
        ----------
        decoder : what it goes by.
        lag : as of `Trellis`.
        answers : codes of `Phoneme`, shape (n_frames,), or what `evidence_in` tells, shape (n_frames, n_phonemes).
        """
        if self._key != (decoder, lag):
            self._begin(decoder.trellis(lag))
            self._key = decoder, lag
        laid = np.moveaxis(np.concatenate((answers, self._trellis.nothing(1)))[self._places], 1, -1)
        new = np.True_ if self._laid is None else laid != self._laid
        todo = np.flatnonzero(np.broadcast_to(new, laid.shape).any(axis=tuple(range(laid.ndim - 1))))
        self._laid = laid
        self._trellis.run_in_lanes(laid, self._follows, todo, self._starts, self._found)
        said: UInt8Array = self._found[0].T.reshape(-1)[self._said_at]
        return said

    def _begin(self, trellis: Trellis) -> None:
        """Cut every sound, with nothing after it, into parts of equal length."""
        self._trellis = trellis
        lengths = np.diff(self._edges)
        n_all = int(self._edges[-1])
        steps = _STEPS
        n_parts = -(-(lengths + trellis.lag) // steps) * (lengths > 0)
        first_parts = np.cumsum(n_parts) - n_parts
        total = int(n_parts.sum())
        self._said_at = np.repeat(first_parts * steps + trellis.lag - self._edges[:-1], lengths) + np.arange(n_all)
        places = np.full(total * steps, n_all, np.intp)
        places[self._said_at - trellis.lag] = np.arange(n_all)
        self._places = places.reshape(total, steps).T
        self._follows = np.ones(total, bool)
        self._follows[first_parts[lengths > 0]] = False
        self._laid = None
        self._starts = np.repeat(trellis.start, total, axis=1)
        self._found = np.empty((steps, total), np.uint8), np.empty_like(self._starts)


class DecodedRules:
    """Rules whose answers a search goes through; it says what both the rules and the search say.

    Parameters
    ----------
    rules : whose answers they are.
    decoder : what the search goes by.
    look_ahead : how far it may look ahead, seconds.
    """

    scores: tuple[str, ...] = ()

    def __init__(self, rules: RuleRecogniser, decoder: Decoder, look_ahead: float) -> None:
        self.look_ahead = lag_of(look_ahead)
        self._rules = rules
        self._search = SoundDecoder(Trellis(decoder, self.look_ahead))
        self._answers = np.zeros(0, np.uint8)

    @property
    def used_thresholds(self) -> frozenset[str]:
        """The fields of `Thresholds` that the rules compare with."""
        return self._rules.used_thresholds

    def recognise(self, _windows: Float32Array, features: Features) -> Recognition:
        """Recognise a block; the answers are about the frames `look_ahead` before."""
        answers = self._rules.phonemes_of(features)
        self._answers = np.concatenate([self._answers, answers])
        return self._taken(self._search.decode(answers))

    def finish(self) -> Recognition:
        """Return the answers for the last frames."""
        return self._taken(self._search.finish())

    def deficits(self, features: Features) -> Float32Array:
        """Return by what share the limits fall short of naming each phoneme, shape (n_frames, n_phonemes)."""
        return self._rules.deficits(features)

    def explain(self, features: Features, k: int) -> Trace:
        """Return why the rules say what they say of frame `k` of a block."""
        return self._rules.explain(features, k)

    def _taken(self, decoded: UInt8Array) -> Recognition:
        answers, self._answers = self._answers[: len(decoded)], self._answers[len(decoded) :]
        return Recognition(answers, decoded=decoded)


def lag_of(look_ahead: float) -> int:
    """Return how many frames a search looks ahead in a time in seconds."""
    return int(look_ahead / FRAME_PERIOD + 1e-6)
