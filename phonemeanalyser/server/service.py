"""The server: its addresses, who answers at each, and how it begins and ends."""

import asyncio
import errno
import logging
import socket
from collections import Counter
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import AsyncExitStack, asynccontextmanager, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from aiohttp import web
from typing_extensions import override

from phonemeanalyser.server import messages
from phonemeanalyser.server.access import (
    FAILED,
    MEGABYTE,
    PROTOCOL,
    USUAL_HOST,
    USUAL_PORT,
    Access,
    RefusedError,
    ServerLimits,
    WrongTokens,
    tokens_of,
)
from phonemeanalyser.server.activity import Activity, Happening, Report, no_report
from phonemeanalyser.server.files import FileExporter
from phonemeanalyser.server.repertoire import Repertoire
from phonemeanalyser.server.session import StreamSession
from phonemeanalyser.server.turns import Turns
from phonemeengine import FORMATS, EngineError, ScriptWord, __version__, words_of
from phonemeengine.audio.incoming import Encoding, StreamFormat
from phonemeengine.live.incoming_speech import IncomingSpeech
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.presets.model_choice import model_in_words
from phonemeengine.settings import WINDOW
from phonemeengine.storage.files import reason_of

CLOSING = 2.0
"""Seconds that a client has to take the last message."""
ARRIVING = 5.0
"""Seconds from a connection to the end of its request's head."""
FULL = "there are as many connections as this server takes; try later"


def refusal(sentence: str, status: int) -> web.Response:
    """Return the answer that says why something is refused."""
    return web.Response(text=messages.error(sentence), status=status, content_type="application/json")


class Connections:
    """Makes what speaks on each new connection.

    Parameters
    ----------
    server : makes it.
    limits : how many there may be, and how long they may wait.
    """

    def __init__(self, server: web.Server, limits: ServerLimits) -> None:
        self._server, self._limits = server, limits
        self._arriving: set[asyncio.BaseProtocol] = set()
        self._silent: dict[asyncio.BaseProtocol, asyncio.TimerHandle] = {}
        self._n_of: Counter[str] = Counter()

    def __call__(self) -> asyncio.Protocol:
        """Return the protocol of a new connection."""
        n = len(self._server.connections) + len(self._arriving)
        if n >= self._limits.max_connections and not self._make_room():
            return _Full()
        loop = asyncio.get_running_loop()
        handler = _Handler(self, self._server, loop=loop, lingering_time=CLOSING)
        self._arriving.add(handler)
        loop.call_soon(self._arriving.discard, handler)  # by then the server counts it
        self._silent[handler] = loop.call_later(min(ARRIVING, self._limits.idle_timeout), self._let_go, handler)
        return handler

    def enter(self, request: web.BaseRequest) -> None:
        """Let a connection stay, since it has asked for something."""
        self.forget(request.protocol)

    def forget(self, handler: asyncio.BaseProtocol) -> None:
        """Watch a connection no more."""
        timer = self._silent.pop(handler, None)
        if timer is not None:
            timer.cancel()

    @contextmanager
    def place_of(self, client: str) -> Iterator[None]:
        """Count a connection of a client meanwhile.

        Raises
        ------
        RefusedError : it has as many as one may have.
        """
        if self._n_of[client] >= self._limits.max_per_address:
            raise RefusedError(
                f"your address has {self._n_of[client]} connections, as many as one may have; close one first", 429
            )
        self._n_of[client] += 1
        try:
            yield
        finally:
            self._n_of[client] -= 1
            if not self._n_of[client]:
                del self._n_of[client]

    def _make_room(self) -> bool:
        """Close the connection that has been silent for longest: a client with a request sends it at once."""
        oldest = next(iter(self._silent), None)
        if oldest is not None:
            self._let_go(oldest)
        return oldest is not None

    def _let_go(self, handler: asyncio.BaseProtocol) -> None:
        self.forget(handler)
        assert isinstance(handler, _Handler)
        handler.let_go()


class _Handler(web.RequestHandler):
    """Can be let go before it has asked for anything; answers what is no request of HTTP in one sentence, too."""

    def __init__(self, connections: Connections, *words: Any, **options: Any) -> None:
        super().__init__(*words, **options)
        self._connections, self._is_let_go = connections, False

    def let_go(self) -> None:
        """Break the connection, as soon as there is one."""
        self._is_let_go = True
        if self.transport is not None:
            self.transport.abort()

    @override
    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        super().connection_made(transport)
        if self._is_let_go:
            self.let_go()

    @override
    def connection_lost(self, exc: BaseException | None) -> None:
        super().connection_lost(exc)
        self._connections.forget(self)

    @override
    def handle_error(
        self,
        request: web.BaseRequest,
        status: int = 500,
        exc: BaseException | None = None,
        message: str | None = None,
    ) -> web.StreamResponse:
        if status >= 500:
            _log.error("a request has failed", exc_info=exc)
        answer = refusal(FAILED if status >= 500 else "this is no request of HTTP/1.1; send one", status)
        answer.force_close()
        return answer


class _Full(asyncio.Protocol):
    """Says that there is no room, and closes."""

    @override
    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        body = messages.error(FULL)
        head = f"HTTP/1.1 503 Service Unavailable\r\nContent-Type: application/json\r\nContent-Length: {len(body)}"
        assert isinstance(transport, asyncio.Transport)
        transport.write(f"{head}\r\nConnection: close\r\n\r\n{body}".encode())
        transport.close()


STREAM, EXPORT = "/stream", "/export"
PREFLIGHT = {
    "Access-Control-Allow-Methods": "GET, POST",
    "Access-Control-Allow-Headers": "Authorization, Content-Type",
    "Access-Control-Allow-Private-Network": "true",
    "Access-Control-Max-Age": "600",
}
"""What a page may ask with, whose origin may."""
WRITER_LIMIT = 1 << 14
"""Bytes of answers that are under way to a client before the next one waits."""
BUFFER = 1 << 16
"""Bytes that the system keeps for each connection, either way: what floods is looked through a little at a time."""
TOO_LARGE = 1009
"""The code with which a stream is closed after a message that is too large."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class ServerSettings:
    """What is served, where, and to whom.

    Attributes
    ----------
    presets : the files of the presets that recognise; the first one serves clients that name none.
    tables : files of mouth tables that clients may name beside those that ship with the program.
    host, port : where it can be reached; port 0 takes a free one.
    access, limits : who may ask, and for how much.
    report : told what happens.
    """

    presets: Sequence[Path] = (DEFAULT_PRESET,)
    tables: Sequence[Path] = ()
    host: str = USUAL_HOST
    port: int = USUAL_PORT
    access: Access = field(default_factory=Access)
    limits: ServerLimits = field(default_factory=ServerLimits)
    report: Report = no_report


@asynccontextmanager
async def serving(settings: ServerSettings) -> AsyncIterator[int]:
    """Serve meanwhile; gives the port.

    Raises
    ------
    EngineError : a preset or mouth table cannot be used, the address is not free, or it can be reached from other
        machines and there is no token.
    """
    settings.access.check_host(settings.host)
    service = Service(settings)
    application = web.Application(middlewares=[service.guard])
    application.router.add_get("/", service.tell)
    application.router.add_get(STREAM, service.stream)
    application.router.add_post(EXPORT, service.export)
    application.on_response_prepare.append(service.share)
    runner = web.AppRunner(application, access_log=None, handler_cancellation=True, shutdown_timeout=CLOSING)
    async with AsyncExitStack() as stack:
        stack.callback(service.close)
        await runner.setup()
        stack.push_async_callback(runner.cleanup)
        assert runner.server is not None
        service.connections = Connections(runner.server, settings.limits)
        try:
            listening = await asyncio.get_running_loop().create_server(
                service.connections, settings.host, settings.port
            )
        except OSError as error:
            place = f"{settings.host}:{settings.port}"
            reason = "another program uses it" if error.errno == errno.EADDRINUSE else reason_of(error)
            raise EngineError(f"{place} cannot be served ({reason}); choose another host or port") from error
        stack.callback(listening.close)
        for endpoint in listening.sockets:  # connections inherit it
            endpoint.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER)
            endpoint.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BUFFER)
        yield listening.sockets[0].getsockname()[1]


class Service:
    """Answers requests.

    Attributes
    ----------
    connections : accepts connections.
    """

    connections: Connections

    def __init__(self, settings: ServerSettings) -> None:
        self._access, self._limits, self._report = settings.access, settings.limits, settings.report
        self._repertoire = Repertoire.of_files(settings.presets, settings.tables, settings.limits)
        self._exporter = FileExporter(self._repertoire, settings.limits)
        self._turns, self._wrong_tokens = Turns(), WrongTokens()
        self._readers = ThreadPoolExecutor(1, "reading texts")  # a voice reads one text at a time
        self._n_streams = 0
        preset = self._repertoire.preset
        speech = IncomingSpeech(preset, StreamFormat())
        self._recogniser = model_in_words(speech.analyser.preset)
        for warning in speech.analyser.preset.warnings:
            _log.warning("%s: %s", preset.name, warning)
        speech.push(np.zeros(2 * WINDOW, np.float32))  # so that the first stream need not wait for imports

    def close(self) -> None:
        """Let go of what it holds."""
        self._readers.shutdown(wait=False, cancel_futures=True)

    @web.middleware
    async def guard(
        self, request: web.Request, handler: Callable[[web.Request], Awaitable[web.StreamResponse]]
    ) -> web.StreamResponse:
        """Let in who may come, and say in one sentence why something is refused."""
        self.connections.enter(request)
        client = self._client_of(request)
        try:
            with self.connections.place_of(client):
                if request.method == "OPTIONS":
                    self._access.check_preflight(request.headers)
                    answer: web.StreamResponse = web.Response(status=204, headers=PREFLIGHT)
                else:
                    await self._admit(request, client)
                    answer = await handler(request)
        except EngineError as error:
            self._tell_of(Happening.REFUSED, client, str(error))
            answer = refusal(str(error), error.status if isinstance(error, RefusedError) else 400)
        except web.HTTPException as error:
            answer = refusal(
                f"{request.method} {request.path[:60]!a} is not served; GET / tells what is", error.status
            )
        except Exception:  # noqa: BLE001 - a bug in one request ends no stream
            _log.exception("a request has failed")
            answer = refusal(FAILED, 500)
        if not answer.prepared:
            answer.force_close()
        return answer

    async def share(self, request: web.Request, answer: web.StreamResponse) -> None:
        """Let a page read an answer, if its origin is one that may."""
        origin = request.headers.get("Origin", "")
        if self._access.allows(origin):
            answer.headers["Access-Control-Allow-Origin"] = origin
            answer.headers["Vary"] = "Origin"

    def _client_of(self, request: web.Request) -> str:
        return self._access.client_of(request.remote, request.headers)

    async def _admit(self, request: web.Request, client: str) -> None:
        """Let a request in, or refuse it; who sent wrong tokens before waits."""
        protocols = _protocols_of(request)
        await asyncio.sleep(self._wrong_tokens.wait_of(client))
        try:
            self._access.check(request.headers, protocols)
        except RefusedError:
            if self._access.token is not None and tokens_of(request.headers, protocols):
                n = self._wrong_tokens.add(client)
                if n & (n - 1) == 0:  # the log grows slowly, too
                    _log.warning("%s has sent %d wrong tokens", client, n)
            raise
        self._wrong_tokens.forgive(client)

    async def tell(self, _request: web.Request) -> web.StreamResponse:
        """Say what is served."""
        told = {
            "program": "phonemeanalyser",
            "version": __version__,
            "preset": self._repertoire.preset.name,
            "presets": [*self._repertoire.presets],
            "recogniser": self._recogniser,
            "stream": STREAM,
            "export": EXPORT,
            "encodings": [*Encoding],
            "formats": [*FORMATS],
            "tables": [*self._repertoire.tables],
            "streams": self._n_streams,
            "with_encoder": len(self._turns.with_encoder),
            "most_streams": self._limits.max_streams,
            "files": self._exporter.n_files,
        }
        return web.json_response(told)

    async def export(self, request: web.Request) -> web.StreamResponse:
        """Export a file."""
        client = self._client_of(request)
        answer = await self._exporter.handle(request, client)
        self._tell_of(Happening.EXPORTED, client)
        return answer

    async def stream(self, request: web.Request) -> web.StreamResponse:
        """Recognise a stream."""
        if self._n_streams >= self._limits.max_streams:
            raise RefusedError(f"there are {self._n_streams} streams, as many as this server takes; try later", 503)
        stream = _StreamSocket(
            timeout=CLOSING,
            protocols=[PROTOCOL],
            compress=False,
            writer_limit=WRITER_LIMIT,
            max_msg_size=int(self._limits.max_message * MEGABYTE),
        )
        if not stream.can_prepare(request):
            raise RefusedError(f"{STREAM} is a WebSocket; open it as one", 426)
        client = self._client_of(request)
        self._n_streams += 1
        self._tell_of(Happening.STREAM_BEGAN, client)
        session = StreamSession(stream, self._repertoire, self._limits, self._turns, self._words_of_text)
        try:
            await stream.prepare(request)
            await session.run()
        finally:
            self._n_streams -= 1
            if session.refused:
                self._tell_of(Happening.REFUSED, client, session.refused)
            self._tell_of(Happening.STREAM_ENDED, client)
            if not stream.closed and request.transport is not None:
                request.transport.abort()  # a closing message would not be read
        return stream

    def _tell_of(self, what: Happening, client: str, words: str = "") -> None:
        self._report(Activity(what, words, client, self._n_streams))

    async def _words_of_text(self, text: str, language: str) -> Sequence[ScriptWord]:
        return await asyncio.get_running_loop().run_in_executor(self._readers, words_of, text, language)


class _StreamSocket(web.WebSocketResponse):
    """Says why, too, where the library itself closes a stream."""

    @override
    async def close(self, *, code: int = 1000, message: bytes = b"", drain: bool = True) -> bool:
        if code == TOO_LARGE and not message:
            message = b"the message is larger than a stream's may be; send the sound in smaller pieces"
        elif code != 1000 and not message:
            message = b"this is no message of a stream; send JSON in UTF-8, or bytes of sound"
        return await super().close(code=code, message=message, drain=drain)


def _protocols_of(request: web.Request) -> list[str]:
    return [word.strip() for word in request.headers.get("Sec-WebSocket-Protocol", "").split(",")]
