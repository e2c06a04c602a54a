"""An output whose time only moves when a test says so."""

import math
from collections import deque
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.audio.output import ClockOutput, Output
from phonemeengine.live.sound import Sound
from phonemeengine.settings import SAMPLE_RATE


class HandDrivenOutput:
    """Plays to nobody; a test sets what has been heard, and sees what was written.

    Attributes
    ----------
    ahead : samples that are written at most before they are heard.
    played : what was written and not skipped, block by block.
    """

    name = "moved by hand"

    def __init__(self, n_channels: int = 1, ahead: int = SAMPLE_RATE // 4) -> None:
        self.n_channels = n_channels
        self.ahead = ahead
        self.is_card = True
        self.gain = 1.0
        self.n_written = 0
        self.heard = 0.0
        self.lost = False
        self.alive = True
        self.running = False
        self.closed = False
        self.played: list[NDArray[np.float32]] = []

    @property
    def room(self) -> int:
        """Samples that can be written now."""
        return self.ahead - (self.n_written - int(self.heard))

    def write(self, block: NDArray[np.float32]) -> None:
        """Take a block."""
        assert block.shape[1] == self.n_channels
        assert len(block) <= self.room
        self.played.append(block.copy())
        self.n_written += len(block)

    def skip(self) -> None:
        """Pass over everything that is written."""
        self.heard = float(self.n_written)

    def run(self, running: bool) -> None:
        """Go on, or hold still; time moves by hand all the same."""
        self.running = running

    def close(self) -> None:
        """Let go."""
        self.closed = True

    def move(self, samples: float) -> None:
        """Have time pass, as far as there is sound."""
        self.heard = min(self.heard + samples, float(self.n_written))


class HandDrivenSound(Sound):
    """A sound on outputs that a test opens."""

    def __init__(self, open_device: Callable[[int], Output], *arguments: Any, **options: Any) -> None:
        self._open = open_device
        super().__init__(*arguments, **options)

    def _open_device(self, n_channels: int) -> Output:
        return self._open(n_channels)

    def catch_up(self) -> bool:
        """Say whether as much is played as may be."""
        return self._player.catch_up()


class Outputs:
    """Opens outputs that the test moves, and remembers them.

    Attributes
    ----------
    alive : whether those that are opened from now on ask for sound; a card that is gone does not.
    """

    def __init__(self) -> None:
        self.opened: list[HandDrivenOutput] = []
        self.alive = True

    def __call__(self, n_channels: int) -> HandDrivenOutput:
        self.opened.append(HandDrivenOutput(n_channels, ahead=10 * SAMPLE_RATE))
        self.opened[-1].alive = self.alive
        return self.opened[-1]

    @property
    def last(self) -> HandDrivenOutput:
        return self.opened[-1]


class SelfMovingOutput(HandDrivenOutput):
    """A card on which time passes whenever somebody looks, and that goes away once so many samples were heard."""

    def __init__(self, n_channels: int = 1, lost_after: float = math.inf) -> None:
        self._heard = 0.0
        self._lost_after = lost_after
        super().__init__(n_channels)

    @property
    def heard(self) -> float:
        """Number of the sample that is heard now."""
        self._heard = min(self._heard + 441, float(self.n_written))
        self.lost = self._heard >= self._lost_after
        return self._heard

    @heard.setter
    def heard(self, heard: float) -> None:
        self._heard = heard


class Cards:
    """Opens the cards that are there, in turn; where there is none, the clock."""

    def __init__(self, *cards: HandDrivenOutput) -> None:
        self.there = deque(cards)
        self.n_asked = 0

    def __call__(self, _n_channels: int) -> Output:
        self.n_asked += 1
        return self.there.popleft() if self.there else ClockOutput("the sound card is not there")
