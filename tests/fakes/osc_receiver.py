"""A program that listens to OSC on the loopback address, with python-osc's own server."""

import threading
from typing import Any

from pythonosc.dispatcher import Dispatcher
from pythonosc.osc_server import BlockingOSCUDPServer

from phonemeengine.mouth.osc import OscAddress

Message = tuple[str, tuple[object, ...]]
SAME_TIME = 1e-4
"""Seconds: times come as floats of 32 bits."""


class _Server(BlockingOSCUDPServer):
    """Notes the size of each packet."""

    sizes: list[int]

    def verify_request(self, request: Any, client_address: Any) -> bool:
        self.sizes.append(len(request[0]))
        return super().verify_request(request, client_address)


class Receiver:
    """A VTuber program: takes every message, with python-osc's own server.

    Attributes
    ----------
    messages : as they came.
    sizes : bytes of each packet that came.
    pictures : each mouth that came, from its time to its ``Apply``: seconds of the sender, and the weights.
    """

    def __init__(self) -> None:
        self.messages: list[Message] = []
        self.sizes: list[int] = []
        self.pictures: list[tuple[float, dict[str, float]]] = []
        self._coming: dict[str, float] = {}
        self._sent_at = 0.0
        dispatcher = Dispatcher()
        dispatcher.set_default_handler(self._take)
        self._server = _Server(("127.0.0.1", 0), dispatcher)
        self._server.sizes = self.sizes
        self.address = OscAddress("127.0.0.1", self._server.server_address[1])
        self._thread = threading.Thread(
            target=self._server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True
        )
        self._thread.start()

    def of(self, address: str) -> list[tuple[object, ...]]:
        return [arguments for name, arguments in self.messages if name == address]

    def weights(self) -> dict[str, float]:
        """Give the newest weight of each movestate."""
        return {str(name): float(value) for name, value in self.of("/VMC/Ext/Blend/Val")}  # type: ignore[arg-type]

    def weights_at(self, seconds: float) -> dict[str, float] | None:
        """Give the newest mouth, if it was sent at this time of the sender and nothing of it is missing."""
        sent_at, weights = self.pictures[-1] if self.pictures else (-1.0, {})
        whole = len(weights) == max((len(known) for _, known in self.pictures), default=0)
        return weights if whole and abs(sent_at - seconds) < SAME_TIME else None

    def _take(self, address: str, *arguments: Any) -> None:
        self.messages.append((address, arguments))
        if address == "/VMC/Ext/T":
            self._sent_at, self._coming = arguments[0], {}
        elif address == "/VMC/Ext/Blend/Val":
            self._coming[arguments[0]] = arguments[1]
        elif address == "/VMC/Ext/Blend/Apply":
            self.pictures.append((self._sent_at, self._coming))

    def close(self) -> None:
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()
