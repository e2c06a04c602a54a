"""A program that listens to OSC on the loopback address, with python-osc's own server."""

import threading

from pythonosc.dispatcher import Dispatcher
from pythonosc.osc_server import BlockingOSCUDPServer

from phonemeengine.mouth.osc import OscAddress

Message = tuple[str, tuple[object, ...]]


class Receiver:
    """A VTuber program: takes every message, with python-osc's own server."""

    def __init__(self) -> None:
        self.messages: list[Message] = []
        dispatcher = Dispatcher()
        dispatcher.set_default_handler(lambda address, *arguments: self.messages.append((address, arguments)))
        self._server = BlockingOSCUDPServer(("127.0.0.1", 0), dispatcher)
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

    def close(self) -> None:
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()
