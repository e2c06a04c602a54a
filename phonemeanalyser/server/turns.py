"""Whose turn it is: the sounds of all streams are analysed in one thread, a little of each at a time."""

import asyncio
import logging
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Protocol, TypeVar

from phonemeanalyser.server.access import FAILED
from phonemeengine import EngineError, GrownWords
from phonemeengine.arrays import Float32Array
from phonemeengine.live.incoming_speech import LOOK, IncomingSpeech, RecognisedPiece, recognise_together

LOOKING = 0.004
"""Seconds of a turn after which no more words are looked for."""
GATHER, GATHER_OF_MANY = 0.004, 0.02
"""Seconds from the first chunk that waits to the turn, so that what comes meanwhile is analysed in the same one; the
second from `MANY` streams on: each then has a chunk in every turn, and all together cost half as much as in parts."""
MANY = 8
HALVED = 32
"""Streams from which on two halves of them alternate: each then has two chunks in every other turn, and all together
cost a third less; a frame comes 20 ms later, of the 40 ms that are left of a tenth of a second."""
LATE, LATE_FOR = 0.02, 0.3
"""Seconds by which turns begin late, and for which they do, until half of the streams give the real-time model up."""
AT_FIRST = 16
"""Streams that may have it when the server begins."""
ONE_MORE, ONE_MORE_LATER = 1.0, 60.0
"""Seconds without a late turn after which one stream more may have it, before the first late turn and after it."""
_T = TypeVar("_T")
_log = logging.getLogger(__name__)


class Stream(Protocol):
    """A stream that takes turns."""

    @property
    def speech(self) -> IncomingSpeech:
        """What analyses it."""

    def use_encoder(self, *, on: bool) -> None:
        """Go on with the real-time model, or with the small network alone."""

    def next_piece(self) -> Float32Array | None:
        """Return what to analyse now, not much at once; None where nothing waits, or the answers are not taken."""

    def tell(self, found: RecognisedPiece) -> None:
        """Take what is known of that piece."""

    def tell_words(self, words: GrownWords) -> None:
        """Take what is known of its text."""

    def fail(self, error: EngineError) -> None:
        """Take why it cannot be analysed."""


class EncoderQuota:
    """Says how many streams may have the real-time model: slowly more, and half as many while turns are late.

    That is additive increase and multiplicative decrease, as networks share a line (D. Chiu and R. Jain, Computer
    Networks and ISDN Systems 17(1), 1989). It begins with few, since a server that has fallen behind takes long to
    catch up.

    Parameters
    ----------
    clock : gives seconds.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock, self._most, self._pause = clock, AT_FIRST, ONE_MORE
        self._late_since: float | None = None
        self._calm_since = clock()

    def after(self, late: float, n: int) -> int:
        """Return how many streams may have it after a turn that began `late` seconds behind, while `n` have it."""
        now = self._clock()
        if late <= LATE:
            self._late_since = None
            if n >= self._most and now - self._calm_since >= self._pause:
                self._most, self._calm_since = self._most + 1, now
            return self._most
        self._calm_since = now
        if self._late_since is None:
            self._late_since = now
        elif now - self._late_since >= LATE_FOR and n:
            self._most, self._pause, self._late_since = n // 2, ONE_MORE_LATER, now
        return self._most


class Turns:
    """Gives all streams their turns, as long as something waits in any.

    Parameters
    ----------
    looking : seconds of a turn after which no more words are looked for.
    quota : how many streams may have the real-time model; the oldest ones have it.
    """

    def __init__(self, looking: float = LOOKING, quota: EncoderQuota | None = None) -> None:
        self._looking, self._quota = looking, quota or EncoderQuota()
        self._streams: dict[Stream, bool] = {}
        self._half = self._is_planned = False
        self._due = 0.0

    @property
    def with_encoder(self) -> list[Stream]:
        """The streams that the real-time model recognises, the newest last."""
        return [stream for stream in self._streams if stream.speech.has_encoder]

    def join(self, stream: Stream) -> None:
        """Have a stream take part."""
        self._streams[stream] = 2 * sum(self._streams.values()) < len(self._streams)

    def leave(self, stream: Stream) -> None:
        """Have it take part no more."""
        self._streams.pop(stream, None)

    def wake(self) -> None:
        """Plan the next turn, since something waits in a stream."""
        if not self._is_planned:
            self._is_planned = True
            seconds = GATHER if len(self._streams) < MANY else GATHER_OF_MANY
            loop = asyncio.get_running_loop()
            self._due = loop.time() + seconds
            loop.call_at(self._due, self._take)

    def _take(self) -> None:
        self._is_planned = False
        self._share_encoder(asyncio.get_running_loop().time() - self._due)
        is_halved = len(self._streams) >= HALVED
        pieces = self._next_pieces(is_halved) or (self._next_pieces(is_halved) if is_halved else {})
        if not pieces:
            return
        self.wake()
        for stream, known in zip(pieces, _recognised(pieces), strict=True):
            if isinstance(known, EngineError):
                stream.fail(known)
            else:
                _safely(stream, partial(stream.tell, known))
        self._look(pieces)

    def _share_encoder(self, late: float) -> None:
        """Give the oldest streams the real-time model, and take it from the newest, as far as turns are in time."""
        may = [stream for stream in self._streams if stream.speech.may_have_encoder]
        most = MANY  # a few that send faster than they speak may well keep the server busy
        if len(self._streams) >= MANY:
            most = self._quota.after(late, len(self.with_encoder))
        changed = [stream for k, stream in enumerate(may) if stream.speech.has_encoder is not (k < most)]
        if changed and late > LATE:
            _log.warning("turns are late: %d of %d streams have the real-time model", min(most, len(may)), len(may))
        for stream in changed:
            _safely(stream, partial(stream.use_encoder, on=not stream.speech.has_encoder))

    def _next_pieces(self, is_halved: bool) -> dict[Stream, Float32Array]:
        """Return what waits, of all streams or of the other half than before."""
        self._half = not self._half
        asked = [stream for stream, half in self._streams.items() if not is_halved or half is self._half]
        found = [(stream, _safely(stream, stream.next_piece)) for stream in asked]
        return {stream: piece for stream, piece in found if piece is not None}

    def _look(self, streams: Iterable[Stream]) -> None:
        """Look for the words of texts where that was not done for longest, as long as phonemes may wait for it."""
        began = time.monotonic()
        due = [stream for stream in streams if stream.speech.n_unlooked >= LOOK]
        for stream in sorted(due, key=lambda stream: -stream.speech.n_unlooked):
            words = _safely(stream, stream.speech.look)
            if words is not None:
                _safely(stream, partial(stream.tell_words, words))
            if time.monotonic() - began > self._looking:
                return


def _safely(stream: Stream, act: Callable[[], _T]) -> _T | None:
    """Do something for a stream; a bug in it ends that one with a word, and no other."""
    try:
        return act()
    except Exception:  # noqa: BLE001 - see above
        _log.exception("a stream has failed")
        stream.fail(EngineError(FAILED))
        return None


def _recognised(pieces: Mapping[Stream, Float32Array]) -> Sequence[RecognisedPiece | EngineError]:
    try:
        return recognise_together([(stream.speech, piece) for stream, piece in pieces.items()])
    except Exception:  # noqa: BLE001 - a bug ends these streams with a word, and no others
        _log.exception("sounds could not be recognised")
        return [EngineError(FAILED)] * len(pieces)
