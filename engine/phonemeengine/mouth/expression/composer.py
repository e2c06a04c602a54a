"""Speech and expressions on one face.

Each channel i has class weights cS + cE = 1, each of N streams n priorities pS and pE, of which each class sums to 1.
Then

    M(n, i) = min(1, N (cS(i) pS(n) + cE(i) pE(n)))
    out(i)  = min(1, sum over n of M(n, i) x(n, i) (1 - h r(i) if n is an expression))

where h is how far speech holds expressions back, see `Inhibition`, and r(i) how much of the channel that concerns.
With equal priorities all M are 1; with pS = 1 for the speech, it has the channels of speech for itself. Classes,
priorities, sum and inhibition are those of a patent text on real-time speech animation; its formula for M is lost,
this one is ours.
"""

import math
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass, field, replace

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.mouth.expression.felt import FeelingAmounts, FeltFace
from phonemeengine.mouth.expression.streams import ExpressionChannels, ExpressionStream, shipped_channels

# How much speech holds expressions back.


@dataclass(frozen=True)
class InhibitionTimes:
    """How speech begins and ends to hold expressions back.

    Attributes
    ----------
    onset : seconds from the start of speech until expressions are inhibited wholly.
    release : seconds from its end until they are free.
    pause : silences that are shorter, seconds, do not end speech.
    """

    onset: float = 0.1
    release: float = 0.5
    pause: float = 0.5


class Inhibition:
    """Follows speech: 0 in silence, 1 during speech, along half a cosine from wherever it stands.

    Times are seconds of one clock, and never go back.

    Parameters
    ----------
    times : how fast it is.
    """

    def __init__(self, times: InhibitionTimes | None = None) -> None:
        self._times = times or InhibitionTimes()
        self._coming: deque[tuple[float, float]] = deque()
        self._from = self._to = 0.0
        self._since = -math.inf
        self._speaks, self._silent_since, self._knows_all = False, -math.inf, False

    def expect(self, speech: Iterable[tuple[float, float]]) -> None:
        """Take all speech that there will be, as start and end of what is said, in order: it ends when it ends.

        What follows says nothing new.
        """
        joined: list[list[float]] = []
        for start, end in speech:
            if joined and start - joined[-1][1] < self._times.pause:
                joined[-1][1] = end
            else:
                joined.append([start, end])
        self._knows_all = True
        self._coming = deque((time, goal) for start, end in joined for time, goal in ((start, 1.0), (end, 0.0)))

    def add(self, time: float, *, speaks: bool) -> None:
        """Take whether there is speech from a time on: speech has ended once there was none for a pause."""
        if self._knows_all:
            return
        if speaks:
            if not self._speaks:
                self._coming.append((time, 1.0))
            self._speaks, self._silent_since = True, math.inf
        elif self._speaks:
            self._silent_since = min(self._silent_since, time)
            if time - self._silent_since >= self._times.pause:
                self._coming.append((time, 0.0))
                self._speaks = False

    def at(self, time: float) -> float:
        """Return how far expressions are inhibited, 0..1."""
        if self._speaks and time - self._silent_since >= self._times.pause:
            self._coming.append((self._silent_since + self._times.pause, 0.0))
            self._speaks = False
        while self._coming and self._coming[0][0] <= time:
            begin, goal = self._coming.popleft()
            self._from, self._to, self._since = self._value(begin), goal, begin
        return self._value(time)

    def _value(self, time: float) -> float:
        lasts = self._times.onset if self._to else self._times.release
        share = min(1.0, (time - self._since) / lasts) if lasts > 0 else 1.0
        return self._from + (self._to - self._from) * (1 - math.cos(math.pi * share)) / 2


ONE = np.float32(1)


@dataclass(frozen=True, eq=False)
class Expression:
    """What a face expresses beside its speech.

    Attributes
    ----------
    streams : at least one, unless a feeling is followed.
    speech_priority : of the speech on channels of speech, pS, 0..1; the streams share the rest equally. None gives
        speech and every stream the same.
    other_priority : of the speech on all other channels, pE, in the same way.
    channels : on which speech and expressions meet.
    times : how speech holds expressions back.
    feeling : how far the face follows the feeling in the voice, as one more stream; None for not at all.

    Raises
    ------
    MouthError : there is no stream, or a priority is out of range.
    """

    streams: tuple[ExpressionStream, ...]
    speech_priority: float | None = None
    other_priority: float | None = None
    channels: ExpressionChannels = field(default_factory=shipped_channels)
    times: InhibitionTimes = field(default_factory=InhibitionTimes)
    feeling: FeelingAmounts | None = None

    def __post_init__(self) -> None:
        if not (self.streams or self.feeling):
            raise MouthError("an expression needs a stream; name a preset such as smile")
        for priority in (self.speech_priority, self.other_priority):
            if priority is not None and not 0 <= priority <= 1:
                raise MouthError(f"a priority lies in 0..1, found {priority:g}; correct it")

    def check_fits(self, movestates: tuple[str, ...], table: str) -> None:
        """Refuse a mouth table, by its name, that does not begin with the blend shapes of ARKit.

        Raises
        ------
        MouthError : it does.
        """
        if movestates[: len(self.channels.names)] != self.channels.names:
            raise MouthError(
                f"expressions move the blend shapes of ARKit, which are not those of the table {table!r}; choose "
                "another table, such as arkit"
            )


def with_stream(expression: Expression | None, stream: ExpressionStream) -> Expression:
    """Return an expression with one more stream."""
    if expression is None:
        return Expression((stream,))
    return replace(expression, streams=(*expression.streams, stream))


class Composer:
    """Adds expressions to the weights of a speaking face.

    Parameters
    ----------
    expression : what is expressed.

    Attributes
    ----------
    felt : the stream that follows the feeling in the voice; None where none does.
    """

    def __init__(self, expression: Expression) -> None:
        self.felt = FeltFace(expression.feeling) if expression.feeling else None
        felt = () if self.felt is None else (self.felt,)
        self._streams: tuple[ExpressionStream, ...] = (*expression.streams, *felt)
        channels = expression.channels
        n_streams = 1 + len(self._streams)
        given = (expression.speech_priority, expression.other_priority)
        of_speech, of_others = ((1 / n_streams if own is None else own) for own in given)
        rest = [(1 - share) / len(self._streams) for share in (of_speech, of_others)]
        self._speech = _multipliers(channels, n_streams, of_speech, of_others)
        self._expressions = _multipliers(channels, n_streams, *rest)
        self._reductions = channels.reductions

    def composed(self, speech: Float32Array, time: float, inhibition: float) -> Float32Array:
        """Return what the face shows, float32, shape (n_channels,), 0..1 where speech is not exaggerated.

        Parameters
        ----------
        speech : the weights of the speech, shape (n_channels,).
        time : of the expressions, seconds.
        inhibition : how far speech holds expressions back, 0..1.
        """
        expressed: Float32Array = np.sum([stream.weights(time) for stream in self._streams], axis=0, dtype=np.float32)
        left: Float32Array = ONE - np.float32(inhibition) * self._reductions
        shown: Float32Array = self._speech * speech + self._expressions * left * expressed
        return np.clip(shown, 0, np.maximum(ONE, speech), out=shown)


def _multipliers(channels: ExpressionChannels, n_streams: int, speech: float, other: float) -> Float32Array:
    """Return the multipliers of a stream with these priorities, shape (n_channels,)."""
    weighted = channels.speech * np.float32(speech) + (ONE - channels.speech) * np.float32(other)
    return np.minimum(ONE, np.float32(n_streams) * weighted)
