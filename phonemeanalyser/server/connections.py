"""Connections of a server: how many may be open, and how long one may stay silent."""

import asyncio
import logging
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from aiohttp import web
from typing_extensions import override

from phonemeanalyser.server import messages
from phonemeanalyser.server.limits import FAILED, RefusedError, ServerLimits

CLOSING = 2.0
"""Seconds that a client has to take the last message."""
ARRIVING = 5.0
"""Seconds from a connection to the end of its request's head."""
FULL = "there are as many connections as this server takes; try later"

_log = logging.getLogger(__name__)


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
