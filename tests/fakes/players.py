"""A player on an output that is moved by hand, and what it must give."""

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from phonemeengine.analyser import Analysis, analyse_blocks
from phonemeengine.analyser import concatenate_analyses as joined
from phonemeengine.audio.files import SoundReader
from phonemeengine.live import player as live
from phonemeengine.live.player import Player
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import HOP, AnalysisSettings, Channel
from tests.fakes.outputs import HandDrivenOutput
from tests.sounds import noise, silence, tone, vowel

PRESET = Preset(settings=AnalysisSettings(time_smooth=0.4, frequency_smooth=0.3))
SPEECH = np.concatenate(
    (
        silence(0.1),
        vowel((700, 1200, 2500), 0.3),
        noise(0.2, 0.2),
        vowel((310, 800, 2300), 0.25, f0=210),
        tone(900, 0.1533, 0.8),
        vowel((280, 2200, 3000), 0.3),
    )
)
N_FRAMES = -(-len(SPEECH) // HOP)
PATIENCE = 60.0
"""Seconds that only a hang takes."""


def wait_for(truth: Callable[[], object], what: str = "the other thread") -> None:
    """Wait until another thread, or a program, has done its part."""
    end = time.monotonic() + PATIENCE
    while not truth():
        assert time.monotonic() < end, f"waited in vain for {what}"
        time.sleep(0.001)


class Rig:
    """A player on outputs that the test moves.

    Attributes
    ----------
    sleepy : whether cards that are opened from now on sleep first.
    """

    def __init__(self, path: Path, preset: Preset = PRESET, **options: Channel) -> None:
        self.outputs: list[HandDrivenOutput] = []
        self.sleepy = False
        self.player = Player(SoundReader(path, **options), preset, self._open)

    def _open(self, n_channels: int) -> HandDrivenOutput:
        self.outputs.append(HandDrivenOutput(n_channels))
        self.outputs[-1].alive = not self.sleepy
        return self.outputs[-1]

    @property
    def output(self) -> HandDrivenOutput:
        return self.outputs[-1]

    def settle(self) -> None:
        """Wait until the thread has followed all commands and written as much as it may."""
        player = self.player
        player._wake.set()

        def settled() -> bool:
            held = not player.playing or player._at_end or self.output.room < live.STEP
            return player._error is not None or (not player._commands and player._target is None and held)

        wait_for(settled, "the analysis thread")

    def hear(self, n_frames: int) -> list[Analysis]:
        """Have some frames' time pass bit by bit; checks that nothing comes before it is heard."""
        taken: list[Analysis] = []
        for _ in range(n_frames):
            self.settle()
            self.output.move(HOP)
            taken += self.player.take_analyses()
        return taken

    def hear_all(self, most: int = 10 * N_FRAMES) -> list[Analysis]:
        """Play to the end."""
        taken: list[Analysis] = []
        while not self.player.finished and most:
            taken += self.hear(1)
            most -= 1
        return taken


def offline(path: Path, preset: Preset = PRESET, channel: Channel = Channel.MIX) -> Analysis:
    """The analysis of the whole file, as one block."""
    with SoundReader(path, channel) as reader:
        return joined(list(analyse_blocks(reader.blocks(10_000), preset, pitch=True)))


def frames_of(taken: list[Analysis]) -> list[int]:
    return [k for heard in taken for k in range(heard.start, heard.start + len(heard))]


def agree(taken: list[Analysis], whole: Analysis, first: int = 0) -> None:
    """The frames that were handed out are those of the whole file, from `first` to its end."""
    found = joined(taken)
    expected = whole.part(slice(first, first + len(found)))
    np.testing.assert_array_equal(found.phonemes, expected.phonemes)
    np.testing.assert_array_equal(found.recognised, expected.recognised)
    np.testing.assert_allclose(found.features.values, expected.features.values, rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(found.spectra, expected.spectra, rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(found.intensities, expected.intensities, rtol=1e-3, atol=1e-4)
