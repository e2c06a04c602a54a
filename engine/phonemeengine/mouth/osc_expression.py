"""What other programs ask a face to express, by OSC messages.

=========================  ======================  ================================================================
address                    arguments               means
=========================  ======================  ================================================================
``/expression``            name, weight 0..1       a preset such as ``smile``, or a blend shape of ARKit
``/VMC/Ext/Blend/Val``     blend shape, 0..1       the same, as face trackers send it (VMC protocol)
=========================  ======================  ================================================================
"""

import contextlib
import math
import threading
import time
from collections.abc import Callable

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.execution import Closing
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.expression.streams import held_expression
from phonemeengine.mouth.osc import OscAddress

ADDRESSES = ("/expression", "/VMC/Ext/Blend/Val")
POLL = 0.05
"""Seconds after which closing is noticed."""
KEPT = 2.0
"""Seconds for which an expression stays after the last message: whoever sends one says so again before."""
FADE = 0.5
"""Seconds in which it goes back to rest then."""


class OscExpression(Closing):
    """Listens until it is closed, in a thread of its own; an `ExpressionStream` of what was sent last.

    Messages that say nothing about a face are passed over. Once nothing has come for `KEPT` seconds, the face goes
    back to rest within `FADE` seconds.

    Parameters
    ----------
    address : where it listens, such as 127.0.0.1:39540.
    clock : by which it is told how long nothing has come, seconds.

    Raises
    ------
    MouthError : another program listens there, or there is no such place.
    """

    def __init__(self, address: OscAddress, *, clock: Callable[[], float] = time.monotonic) -> None:
        from pythonosc.dispatcher import Dispatcher  # noqa: PLC0415 - with asyncio, for which few have a use
        from pythonosc.osc_server import BlockingOSCUDPServer  # noqa: PLC0415

        self._clock, self._heard_at = clock, -math.inf
        self._shares: dict[str, float] = {}
        self._weights: Float32Array = np.zeros(len(ARKIT), np.float32)
        dispatcher = Dispatcher()
        for known in ADDRESSES:
            dispatcher.map(known, self._take)
        try:
            self._server = BlockingOSCUDPServer((address.host, address.port), dispatcher)
        except (OSError, UnicodeError) as error:
            raise MouthError(
                f"nobody can be heard on {address.host}:{address.port} ({error}); choose another port"
            ) from error
        self._thread = threading.Thread(
            target=self._server.serve_forever, kwargs={"poll_interval": POLL}, name="osc expression", daemon=True
        )
        self._thread.start()

    @property
    def port(self) -> int:
        """Where it listens; the system's choice, where 0 was asked for."""
        return int(self._server.server_address[1])

    @property
    def names(self) -> tuple[str, ...]:
        """What was heard so far, presets and blend shapes, the newest last; none once its sender has stopped."""
        return tuple(self._shares) if self._share_kept() else ()

    @property
    def stopped(self) -> bool:
        """Whether something was heard, and its sender has stopped."""
        return bool(self._shares) and not self._share_kept()

    def weights(self, _time: float) -> Float32Array:
        """Return the weights of the 52 blend shapes of `ARKIT` now, float32, 0..1."""
        weights: Float32Array = self._weights * np.float32(self._share_kept())
        return weights

    def close(self) -> None:
        """Listen no more."""
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()

    def _share_kept(self) -> float:
        """Return how much is left of what was sent, 1 while its sender goes on, along half a cosine to 0."""
        gone = min(max((self._clock() - self._heard_at - KEPT) / FADE, 0.0), 1.0)
        return 0.5 + 0.5 * math.cos(math.pi * gone)

    def _take(self, _address: str, *arguments: object) -> None:
        match arguments:
            case (str(name), int() | float() as share):
                before = self._shares if self._share_kept() else {}
                wanted = before | {name: min(max(0.0, share), 1.0)}
                with contextlib.suppress(MouthError):  # of a name that no face has
                    self._weights = held_expression(wanted).weights(0.0)
                    self._shares, self._heard_at = wanted, self._clock()
