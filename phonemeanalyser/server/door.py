"""The door of a server: how many connections may be open, and how long one may stand there without a word."""

import asyncio
import logging

from aiohttp import web

from phonemeanalyser.server import messages
from phonemeanalyser.server.limits import ServerLimits
from phonemeanalyser.server.refused import FAILED

CLOSING = 2.0
"""Seconds that a client has to take what it is told last."""
FULL = "there are as many connections as this server takes; try later"

_log = logging.getLogger(__name__)


def refusal(sentence: str, status: int) -> web.Response:
    """Return the answer that says why something is refused."""
    return web.Response(text=messages.error(sentence), status=status, content_type="application/json")


class Door:
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

    def __call__(self) -> asyncio.Protocol:
        """Return the protocol of a new connection."""
        if len(self._server.connections) + len(self._arriving) >= self._limits.most_connections:
            return _Full()
        loop = asyncio.get_running_loop()
        handler = _Handler(self._server, loop=loop, lingering_time=CLOSING)
        self._arriving.add(handler)
        loop.call_soon(self._arriving.discard, handler)  # by then the server counts it
        self._silent[handler] = loop.call_later(self._limits.idle, self._let_go, handler)
        return handler

    def enter(self, request: web.BaseRequest) -> None:
        """Let a connection stay, since it has asked for something."""
        timer = self._silent.pop(request.protocol, None)
        if timer is not None:
            timer.cancel()

    def _let_go(self, handler: web.RequestHandler) -> None:
        del self._silent[handler]
        if handler.transport is not None:
            handler.transport.abort()


class _Handler(web.RequestHandler):
    """Answers what is no request of HTTP in one sentence, too."""

    def handle_error(
        self,
        request: web.BaseRequest,  # noqa: ARG002 - the library gives it
        status: int = 500,
        exc: BaseException | None = None,
        message: str | None = None,  # noqa: ARG002 - several lines of its own
    ) -> web.StreamResponse:
        """Return what is answered."""
        if status >= 500:
            _log.error("a request has failed", exc_info=exc)
        answer = refusal(FAILED if status >= 500 else "this is no request of HTTP/1.1; send one", status)
        answer.force_close()
        return answer


class _Full(asyncio.Protocol):
    """Says that there is no room, and closes."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        body = messages.error(FULL)
        head = f"HTTP/1.1 503 Service Unavailable\r\nContent-Type: application/json\r\nContent-Length: {len(body)}"
        assert isinstance(transport, asyncio.Transport)
        transport.write(f"{head}\r\nConnection: close\r\n\r\n{body}".encode())
        transport.close()
