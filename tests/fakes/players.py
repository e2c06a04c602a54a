"""A player on an output that is moved by hand, and what it must give."""

import threading
from pathlib import Path

import numpy as np

from phonemeengine.analyser import Analysis, analyse_blocks
from phonemeengine.analyser import concatenate_analyses as joined
from phonemeengine.audio.files import SoundReader
from phonemeengine.live.player import Player
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import HOP, AnalysisSettings, Channel
from tests.fakes.outputs import HandDrivenOutput
from tests.sounds import noise, silence, tone, vowel
from tests.waiting import PATIENCE, wait_for

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


class EagerPlayer(Player):
    """Looks for a card whenever it comes round."""

    retry_period = 0.0
    wake_timeout = 0.02


class ForgetfulPlayer(Player):
    """Drops what is not taken soon."""

    most_waiting = 5


class Rig:
    """A player on outputs that the test moves.

    Attributes
    ----------
    sleepy : whether cards that are opened from now on sleep first.
    """

    def __init__(
        self, sound: Path | SoundReader, preset: Preset = PRESET, kind: type[Player] = Player, **options: Channel
    ) -> None:
        self.outputs: list[HandDrivenOutput] = []
        self.sleepy = False
        reader = sound if isinstance(sound, SoundReader) else SoundReader(sound, **options)
        self.player = kind(reader, preset, self._open)

    def _open(self, n_channels: int) -> HandDrivenOutput:
        self.outputs.append(HandDrivenOutput(n_channels))
        self.outputs[-1].alive = not self.sleepy
        return self.outputs[-1]

    @property
    def output(self) -> HandDrivenOutput:
        return self.outputs[-1]

    def settle(self) -> None:
        """Wait until the thread has followed all commands and written as much as it may."""
        wait_for(self.player.catch_up, "the analysis thread")

    def go_round(self) -> None:
        """Wait until the thread has followed all commands, and has gone round once more."""
        go_round(self.player)

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


def go_round(player: Player) -> None:
    """Wait until a player's thread has followed all commands, and has gone round once more."""
    for _ in range(2):
        followed = threading.Event()
        player._do(followed.set)
        assert followed.wait(PATIENCE)


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
