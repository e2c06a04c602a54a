"""Whose turn it is: the sounds of all streams are heard in one thread, a little of each at a time."""

import asyncio
import logging
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Protocol, TypeVar

from phonemeanalyser.server.refused import FAILED
from phonemeengine import EngineError
from phonemeengine.arrays import Float32Array
from phonemeengine.live.incoming_speech import HeardPiece, IncomingSpeech, hear_together

GATHER = 0.004
"""Seconds from the first piece that waits to the turn, so that what comes meanwhile is heard in the same one."""


_T = TypeVar("_T")
_log = logging.getLogger(__name__)


class Hearing(Protocol):
    """A stream that takes turns."""

    @property
    def speech(self) -> IncomingSpeech:
        """What it hears."""

    def next_piece(self) -> Float32Array | None:
        """Return what shall be heard now, not much at once; None where nothing waits, or nobody takes the answers."""

    def tell(self, heard: HeardPiece) -> None:
        """Take what is known of that piece."""

    def fail(self, error: EngineError) -> None:
        """Take why it cannot be heard."""


class Turns:
    """Gives all streams their turns, as long as something waits in any."""

    def __init__(self) -> None:
        self._streams: dict[Hearing, None] = {}
        self._is_planned = False

    def join(self, stream: Hearing) -> None:
        """Have a stream take part."""
        self._streams[stream] = None

    def leave(self, stream: Hearing) -> None:
        """Have it take part no more."""
        self._streams.pop(stream, None)

    def wake(self) -> None:
        """Plan the next turn, since something waits in a stream."""
        if not self._is_planned:
            self._is_planned = True
            asyncio.get_running_loop().call_later(GATHER, self._take)

    def _take(self) -> None:
        self._is_planned = False
        found = [(stream, _safely(stream, stream.next_piece)) for stream in [*self._streams]]
        pieces = {stream: piece for stream, piece in found if piece is not None}
        if not pieces:
            return
        self.wake()
        for stream, known in zip(pieces, _heard(pieces), strict=True):
            if isinstance(known, EngineError):
                stream.fail(known)
            else:
                _safely(stream, partial(stream.tell, known))


def _safely(stream: Hearing, act: Callable[[], _T]) -> _T | None:
    """Do something for a stream; a bug in it ends that one with a word, and no other."""
    try:
        return act()
    except Exception:  # noqa: BLE001 - see above
        _log.exception("a stream has failed")
        stream.fail(EngineError(FAILED))
        return None


def _heard(pieces: Mapping[Hearing, Float32Array]) -> Sequence[HeardPiece | EngineError]:
    try:
        return hear_together([(stream.speech, piece) for stream, piece in pieces.items()])
    except Exception:  # noqa: BLE001 - a bug ends these streams with a word, and no others
        _log.exception("sounds could not be heard")
        return [EngineError(FAILED)] * len(pieces)
