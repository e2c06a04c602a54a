"""A server on a free port of this machine, in a thread of its own, and a client of its streams."""

import asyncio
import json
import threading
from collections.abc import Awaitable, Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import Any, TypeVar

import aiohttp
import numpy as np

from phonemeanalyser.server.service import ServerSettings, serving
from phonemeengine import EngineError

T = TypeVar("T")
PATIENCE = 300.0
"""Seconds after which something hangs."""


@contextmanager
def served(settings: ServerSettings) -> Iterator[str]:
    """Serve meanwhile; gives the address."""
    began: Future[tuple[int, asyncio.AbstractEventLoop, asyncio.Event]] = Future()

    async def serve() -> None:
        try:
            async with serving(settings) as port:
                end = asyncio.Event()
                began.set_result((port, asyncio.get_running_loop(), end))
                await end.wait()
        except EngineError as error:
            began.set_exception(error)

    thread = threading.Thread(target=asyncio.run, args=(serve(),))
    thread.start()
    try:
        port, loop, end = began.result(PATIENCE)
        try:
            yield f"http://127.0.0.1:{port}"
        finally:
            loop.call_soon_threadsafe(end.set)
    finally:
        thread.join(PATIENCE)
        assert not thread.is_alive()


@dataclass
class Told:
    """What a client was told.

    Attributes
    ----------
    messages : all of it, in order.
    code : with which the stream was closed.
    """

    messages: list[dict[str, Any]] = field(default_factory=list)
    code: int | None = None

    @property
    def frames(self) -> list[dict[str, Any]]:
        return [message for message in self.messages if "phonemes" in message]

    @property
    def error(self) -> str:
        """The sentence that it ends with; one without line breaks."""
        sentence = self.messages[-1]["error"]
        assert isinstance(sentence, str)
        assert "\n" not in sentence
        return sentence

    def column(self, name: str) -> list[Any]:
        """What was told of all frames under a name."""
        return [value for message in self.frames for value in message[name]]

    def words(self) -> list[dict[str, Any]]:
        """The words that were settled."""
        return [word for message in self.messages for word in message.get("words", ())]


def spoken_to(
    address: str, act: Callable[[aiohttp.ClientWebSocketResponse], Awaitable[None]], **options: Any
) -> Told:
    """Open a stream, do something, and give what was told until it closed."""

    async def speak() -> Told:
        told = Told()
        async with (
            aiohttp.ClientSession() as session,
            session.ws_connect(f"{address}/stream", max_msg_size=0, **options) as socket,
        ):
            doing = asyncio.create_task(_done(act, socket))
            async for message in socket:
                told.messages.append(json.loads(message.data))
            told.code = socket.close_code
            doing.cancel()
            await asyncio.gather(doing, return_exceptions=True)
        return told

    return run(speak())


def streamed(address: str, start: dict[str, Any], blocks: Iterable[bytes], **options: Any) -> Told:
    """Send a sound in blocks to its end, and give what was told."""

    async def send(socket: aiohttp.ClientWebSocketResponse) -> None:
        await socket.send_json(start)
        for block in blocks:
            await socket.send_bytes(block)
        await socket.send_json({"end": True})

    return spoken_to(address, send, **options)


def run(act: Awaitable[T]) -> T:
    """Run something to its end, as long as it does not hang."""

    async def ended() -> T:
        async with asyncio.timeout(PATIENCE):
            return await act

    return asyncio.run(ended())


def cut(data: bytes, sizes: Sequence[int]) -> Iterator[bytes]:
    """Cut bytes into blocks of these sizes, again and again."""
    at, k = 0, 0
    while at < len(data):
        yield data[at : at + sizes[k % len(sizes)]]
        at += sizes[k % len(sizes)]
        k += 1


def as_s16(sound: np.ndarray) -> bytes:
    """Give samples ±1 as integers of 16 bits."""
    return np.rint(np.clip(sound, -1, 1) * 32767).astype("<i2").tobytes()


async def _done(act: Callable[[aiohttp.ClientWebSocketResponse], Awaitable[None]], socket: Any) -> None:
    with suppress(ConnectionError):  # the server may have closed the stream meanwhile
        await act(socket)
