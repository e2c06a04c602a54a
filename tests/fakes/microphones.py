"""A microphone that hears what a test gives it, and an opener that may refuse."""

import queue
import threading
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.analyser import Analysis, analyse_blocks
from phonemeengine.audio.stream import InputChoice
from phonemeengine.dsp.framing import LEAD
from phonemeengine.errors import DeviceError
from phonemeengine.live.listener import Listener
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, WINDOW
from tests.fakes.players import PRESET, joined
from tests.waiting import wait_for

SILENCE = np.zeros(SAMPLE_RATE // 10, np.float32)
REFUSAL = "the microphone is not there; plug it in"


class HandDrivenMicrophone:
    """Hears what it is given, when it is given.

    Attributes
    ----------
    fault : raised to who reads from now on, unless it is None.
    """

    def __init__(self, rate: int = SAMPLE_RATE, n_channels: int = 1, name: str = "moved by hand") -> None:
        self.name = name
        self.rate = rate
        self.n_channels = n_channels
        self.lost = False
        self.quiet = 0.0
        self.delay = 0.02
        self.n_lost = 0
        self.begun = 1000.0
        self.fault: Exception | None = None
        self.closed = threading.Event()
        self._given: queue.Queue[NDArray[np.float32]] = queue.Queue()
        self._in_hand = False

    def give(self, samples: NDArray[np.float32], n: int = HOP) -> None:
        """Have it hear samples, shape (m,) or (m, n_channels), in blocks of `n`."""
        block = samples.reshape(len(samples), -1)
        assert block.shape[1] == self.n_channels
        for k in range(0, len(block), n):
            self._given.put(block[k : k + n])

    @property
    def n_waiting(self) -> int:
        """How many blocks it was given with which who reads is not done yet."""
        return self._given.unfinished_tasks

    def read(self, timeout: float) -> NDArray[np.float32]:
        """Give the next block; who asks for it is done with the last one."""
        if self._in_hand:
            self._given.task_done()
        self._in_hand = False
        if self.fault is not None:
            raise self.fault
        try:
            block = self._given.get(timeout=min(timeout, 0.01))
        except queue.Empty:
            return np.zeros((0, self.n_channels), np.float32)
        self._in_hand = True
        return block

    def time_of(self, sample: float) -> float:
        """Say when a sample was captured."""
        return self.begun + sample / self.rate

    def close(self) -> None:
        """Let go."""
        self.closed.set()


class Microphones:
    """Opens microphones in turn; where there is none, and where None stands for one, it refuses.

    It hangs until it may answer, and for a minute at most: who waited for it would find it hanging no more.
    """

    def __init__(self, *microphones: HandDrivenMicrophone | None) -> None:
        self.waiting = deque(microphones)
        self.asked: list[InputChoice] = []
        self.may_answer = threading.Event()
        self.may_answer.set()
        self.hangs = False

    def __call__(self, choice: InputChoice) -> HandDrivenMicrophone:
        self.asked.append(choice)
        self.hangs = True
        answers = self.may_answer.wait(60)
        self.hangs = False
        assert answers
        found = self.waiting.popleft() if self.waiting else None
        if found is None:
            raise DeviceError(REFUSAL)
        return found


class HandDrivenListener(Listener):
    """A listener to microphones that a test drives, which soon tries again for one that is missing."""

    def __init__(
        self,
        openers: Microphones,
        *arguments: Any,
        retry_period: float = 0.01,
        most_waiting: int = 500,
        **options: Any,
    ) -> None:
        self._openers = openers
        self.retry_period, self.most_waiting = retry_period, most_waiting
        super().__init__(*arguments, **options)

    def _open_input(self, choice: InputChoice) -> HandDrivenMicrophone:
        return self._openers(choice)


class Hearing:
    """A listener to microphones that a test drives, and what it took from it."""

    def __init__(self, *microphones: HandDrivenMicrophone | None, preset: Preset = PRESET, **options: object) -> None:
        self.openers = Microphones(*microphones)
        self.taken: list[Analysis] = []
        self.listener = HandDrivenListener(self.openers, preset, **options)

    def has(self, n_frames: int) -> bool:
        """Take what there is; whether so many frames were taken altogether."""
        self.taken += self.listener.take_analyses()
        assert sum(map(len, self.taken)) <= n_frames
        return sum(map(len, self.taken)) == n_frames

    def wait(self, n_frames: int) -> None:
        """Wait until so many frames were taken altogether."""
        wait_for(lambda: self.has(n_frames), f"{n_frames} frames")

    def wait_samples(self, n_samples: int) -> None:
        """Wait until so many samples at 44.1 kHz were listened to, also those that complete no frame yet."""
        self.wait(frames_in(n_samples))
        wait_for(lambda: self.listener.seconds >= n_samples / SAMPLE_RATE, f"{n_samples} samples")

    def wait_words(self, words: str) -> None:
        """Wait until the status says so."""
        wait_for(lambda: words in self.listener.status.words, words)


Hear = Callable[..., Hearing]
"""Makes a `Hearing` that the fixture closes."""


def frames_in(n_samples: int) -> int:
    """Count the frames that are complete when so many samples at 44.1 kHz have come."""
    return max(0, (LEAD + n_samples - WINDOW) // HOP + 1)


def offline(samples: NDArray[np.float32], preset: Preset = PRESET, start: int = 0) -> Analysis:
    """The analysis of a whole sound, its frames numbered from `start`."""
    return replace(joined(list(analyse_blocks([samples], preset, pitch=True))), start=start)


def middle_of(frame: int) -> float:
    """Seconds from the beginning to the middle of a frame."""
    return (frame + 0.5) * FRAME_PERIOD
