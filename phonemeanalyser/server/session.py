"""One stream: a client's sound comes in, and what is said in it goes out."""

import asyncio
import logging
import math
import time
from collections import deque
from collections.abc import Awaitable, Callable, Sequence
from contextlib import suppress

import numpy as np
from aiohttp import WSMsgType, web

from phonemeanalyser.server import messages
from phonemeanalyser.server.access import AHEAD, FAILED, PER_MESSAGE, RefusedError, ServerLimits
from phonemeanalyser.server.repertoire import Repertoire
from phonemeanalyser.server.turns import Turns
from phonemeengine import EngineError, GrownWords, ScriptWord
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.incoming import PIECE
from phonemeengine.live.incoming_speech import IncomingSpeech, RecognisedPiece
from phonemeengine.settings import SAMPLE_RATE

# How fast a stream is read: as fast as it is spoken some times over, and a little ahead at any time.


class Pace:
    """Says how long to wait before more is read (a token bucket, whose tokens are seconds of sound).

    Parameters
    ----------
    speed : seconds of sound for each second.
    ahead : seconds of sound that may come at once.
    clock : gives seconds.
    """

    def __init__(self, speed: float, ahead: float, clock: Callable[[], float] = time.monotonic) -> None:
        self._speed, self._ahead, self._clock = speed, ahead, clock
        self._left, self._looked = ahead, clock()

    def wait_after(self, seconds: float) -> float:
        """Take so much sound; return how long nothing more may be taken, seconds."""
        now = self._clock()
        self._left = min(self._ahead, self._left + (now - self._looked) * self._speed) - seconds
        self._looked = now
        return max(0.0, -self._left / self._speed)


_log = logging.getLogger(__name__)
MOST_AT_ONCE = round(PIECE * SAMPLE_RATE)
"""Samples that are analysed in one turn."""
MOST_WAITING = SAMPLE_RATE
"""Samples that may wait for the analysis; then no more are read."""
MOST_UNSENT = 64
"""Answers that may wait to be sent; then no more sound is analysed."""
REFUSED = 1008
"""The code with which a stream is closed after a sentence that says why (RFC 6455: policy violation)."""
LOOKS = 4
"""How often it is looked, in the time that a client may be idle, whether it is."""
LONGEST_REASON = 123
"""Bytes that a WebSocket may be closed with."""

WordsOfText = Callable[[str, str], Awaitable[Sequence[ScriptWord]]]
"""Gives the words of a text in a language."""


class GoneError(Exception):
    """The client has closed the stream, or takes no answers."""


class StreamSession:
    """Recognises the sound of one client.

    Parameters
    ----------
    socket : the open WebSocket.
    repertoire, limits : those of the server.
    turns : of all its streams.
    words_of_text : how texts are pronounced.

    Attributes
    ----------
    speech : what is analysed, once the client has said what it sends.
    refused : the sentence with which it was refused; empty where it was not.
    """

    speech: IncomingSpeech

    def __init__(
        self,
        socket: web.WebSocketResponse,
        repertoire: Repertoire,
        limits: ServerLimits,
        turns: Turns,
        words_of_text: WordsOfText,
    ) -> None:
        self._socket, self._repertoire, self._limits, self._turns = socket, repertoire, limits, turns
        self._words_of_text = words_of_text
        self._pace = Pace(limits.max_speed, AHEAD)
        self._language, self._n_text = "", 0
        self.refused = ""
        self._waiting: deque[Float32Array] = deque()
        self._n_waiting, self._has_ended = 0, False
        self._room = asyncio.Event()
        self._unsent: asyncio.Queue[str | EngineError | None] = asyncio.Queue()
        self._receives_since = self._sends_since = math.inf

    async def run(self) -> None:
        """Speak with the client until the sound has ended, the client has gone, or something is refused."""
        try:
            async with asyncio.timeout(self._limits.idle_timeout):
                await self._begin()
            self._turns.join(self)
            await self._converse()
            await self._socket.close()
        except EngineError as error:
            await self._refuse(error)
        except TimeoutError:
            await self._refuse(self._nothing_came())
        except GoneError:  # the client that would get it has gone
            pass
        except Exception:  # noqa: BLE001 - a bug in one stream ends no other one
            _log.exception("a stream has failed")
            await self._refuse(EngineError(FAILED))
        finally:
            self._turns.leave(self)

    # -- its turns ----------------------------------------------------------------------------------------

    def next_piece(self) -> Float32Array | None:
        """Return the samples to analyse now, a fifth of a second at the most."""
        if self._unsent.qsize() >= MOST_UNSENT:
            return None
        if not self._waiting:
            self._conclude()
            return None
        parts, n = [], 0
        while self._waiting and n < MOST_AT_ONCE:
            parts.append(self._waiting.popleft())
            n += len(parts[-1])
        self._n_waiting -= n
        self._room.set()
        return np.concatenate(parts) if len(parts) > 1 else parts[0]

    def use_encoder(self, *, on: bool) -> None:
        """Change the model, and tell the client, unless it gets nothing but events of a service."""
        self.speech.use_encoder(on=on)
        if not self._start.events:
            self._unsent.put_nowait(messages.recogniser(self.speech))

    def tell(self, found: RecognisedPiece) -> None:
        """Have the client told what is known of a piece."""
        answers = [messages.frames(found, self._start)] if len(found.analysis) and not self._start.events else []
        for answer in (*answers, *found.events):
            self._unsent.put_nowait(answer)
        if found.words is not None:
            self.tell_words(found.words)

    def tell_words(self, words: GrownWords) -> None:
        """Have the client told what is known of its text, if there is anything."""
        if words != GrownWords():
            self._unsent.put_nowait(messages.words(words))

    def fail(self, error: EngineError) -> None:
        """Tell the client why no more is analysed, after all that is known."""
        self._unsent.put_nowait(error)
        self._turns.leave(self)

    def _conclude(self) -> None:
        """Say what is known of the end, once the sound has ended and all of it was analysed."""
        if not self._has_ended:
            return
        self._turns.leave(self)
        try:
            for found in self.speech.finish():
                self.tell(found)
        except EngineError as error:
            self.fail(error)
        else:
            self._unsent.put_nowait(messages.end(self.speech))
            self._unsent.put_nowait(None)

    # -- what the client says -----------------------------------------------------------------------------

    async def _begin(self) -> None:
        message = await self._next_message()
        if not isinstance(message, str):
            raise RefusedError("the first message must say in JSON what is sent, such as its encoding and rate")
        start = self._start = await asyncio.to_thread(messages.start_of, message, self._repertoire)
        self.speech = IncomingSpeech(
            start.preset,
            start.form,
            start.table,
            with_text=bool(start.language),
            felt=start.felt,
            service=start.events,
        )
        self._language = start.language
        await self._add_text(start.text)
        await self._send(messages.ready(start, self.speech))

    async def _converse(self) -> None:
        receiving, sending = asyncio.create_task(self._receive_all()), asyncio.create_task(self._send_all())
        try:
            while not sending.done() and not (receiving.done() and receiving.exception()):
                under_way = [task for task in (receiving, sending) if not task.done()]
                looks = self._limits.idle_timeout / LOOKS
                await asyncio.wait(under_way, timeout=looks, return_when=asyncio.FIRST_EXCEPTION)
                self._check_patience()
        finally:
            for task in (receiving, sending):
                task.cancel()
            await asyncio.wait((receiving, sending))
        for task in (receiving, sending):
            if not task.cancelled():
                task.result()

    async def _receive_all(self) -> None:
        try:
            while not self._has_ended:
                message = await self._next_message()
                if isinstance(message, str):
                    later = messages.later_words_of(message)
                    await self._add_text(later.text)
                    await self._slow_down(PER_MESSAGE)
                    self._has_ended = later.end
                else:
                    await self._add_sound(message)
        except EngineError as error:
            await self._analyse_rest()
            self.fail(error)
        self._turns.wake()

    async def _next_message(self) -> str | bytes:
        self._receives_since = time.monotonic()
        message = await self._socket.receive()
        self._receives_since = math.inf
        if message.type not in {WSMsgType.TEXT, WSMsgType.BINARY}:
            raise GoneError
        content: str | bytes = message.data
        return content

    async def _add_sound(self, data: bytes) -> None:
        began = self.speech.seconds
        for piece in self.speech.pieces(data):
            while self._n_waiting >= MOST_WAITING:
                self._room.clear()
                await self._room.wait()
            self._waiting.append(piece)
            self._n_waiting += len(piece)
            self._turns.wake()
            await self._slow_down(self.speech.seconds - began)
            began = self.speech.seconds
        await self._slow_down(PER_MESSAGE)

    async def _analyse_rest(self) -> None:
        """Wait until all that came before has been analysed."""
        while self._waiting:
            self._room.clear()
            await self._room.wait()

    async def _slow_down(self, seconds: float) -> None:
        """Take some seconds of sound, and wait if that is more than the client may send."""
        wait = self._pace.wait_after(seconds)
        if wait:
            await asyncio.sleep(wait)

    async def _add_text(self, text: str) -> None:
        if not text:
            return
        if not self._language:
            raise RefusedError("the text has no language; name it in the first message, such as en-us or de")
        self._n_text += len(text)
        if self._n_text > self._limits.max_text:
            raise RefusedError(
                f"a stream may have a text of {self._limits.max_text} characters; begin another stream"
            )
        self.speech.add_words(await self._words_of_text(text, self._language))

    # -- messages of the client ---------------------------------------------------------------------------

    async def _send_all(self) -> None:
        while (answer := await self._unsent.get()) is not None:
            if isinstance(answer, EngineError):
                raise answer
            await self._send(answer)
            if self._waiting or self._has_ended:
                self._turns.wake()

    async def _send(self, answer: str) -> None:
        self._sends_since = time.monotonic()
        try:
            await self._socket.send_str(answer)
        except ConnectionError:
            raise GoneError from None
        self._sends_since = math.inf

    def _check_patience(self) -> None:
        """Give up a client that sends nothing, or takes nothing; a watch for each message would cost far more."""
        now, idle = time.monotonic(), self._limits.idle_timeout
        if now - self._sends_since > idle:
            raise GoneError
        if now - self._receives_since > idle:
            raise self._nothing_came()

    def _nothing_came(self) -> RefusedError:
        words = "say when the sound has ended, or send silence"
        return RefusedError(f"nothing came for {self._limits.idle_timeout:g} s; {words}")

    async def _refuse(self, error: EngineError) -> None:
        self.refused = str(error)
        with suppress(GoneError, TimeoutError):
            async with asyncio.timeout(self._limits.idle_timeout):
                await self._send(messages.error(str(error)))
            reason = str(error).encode()[:LONGEST_REASON].decode(errors="ignore")
            await self._socket.close(code=REFUSED, message=reason.encode())
