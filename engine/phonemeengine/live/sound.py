"""A sound file as a game uses it: played, looked into, and recognised while it plays."""

import os
from collections import deque

import numpy as np
from typing_extensions import override

from phonemeengine.analyser import Analysis, Reading, latest_reading
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader, mono_of
from phonemeengine.audio.output import AHEAD, Output, open_output
from phonemeengine.dsp.spectrum import SpectrumAnalyser
from phonemeengine.execution import Closing
from phonemeengine.live.player import STEP, Player
from phonemeengine.presets.model_choice import while_played
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.model import MOST_FRAMES_AROUND
from phonemeengine.settings import HOP, SAMPLE_RATE, WINDOW, AnalysisSettings, Channel

N_BINS = 512
"""Bins of `Sound.spectrum`."""
KEPT = (SAMPLE_RATE + MOST_FRAMES_AROUND * HOP + AHEAD + 2 * WINDOW) // STEP + 2
"""Blocks that are kept after they were read: what is analysed and written ahead, a card's delay of up to a
second, and windows."""


class RecentSamples:
    """Passes a reader on, and keeps what was read last."""

    def __init__(self, reader: SoundReader) -> None:
        self.channel = reader.channel
        self.n_channels = reader.n_channels
        self.n_samples = reader.n_samples
        self.duration = reader.duration
        self._reader = reader
        self._read: deque[tuple[int, Float32Array]] = deque(maxlen=KEPT)
        self.mono = reader.mono
        self.seek = reader.seek
        self.close = reader.close

    def read(self, n: int) -> Float32Array:
        """Read on."""
        start = self._reader.position
        block = self._reader.read(n)
        self._read.append((start, block))
        return block

    def around(self, sample: int) -> Float32Array:
        """Return the window around a sample, shape (2048, n_channels); silence where nothing was read."""
        first = sample - WINDOW // 2
        window = np.zeros((WINDOW, self.n_channels), np.float32)
        for start, block in tuple(self._read):
            low, high = max(first, start), min(first + WINDOW, start + len(block))
            if low < high:
                window[low - first : high - first] = block[low - start : high - start]
        return window


class Sound(Closing):
    """Plays a sound file and gives what is playing: `poll` gives the phoneme and the intensity.

    No call waits for sound or disk, once the file is open.

    Parameters
    ----------
    path : the sound file.
    preset : what to recognise with, by the model that it has for files which play.
    channel : what is recognised of a file of several channels.

    Raises
    ------
    AudioError : the file cannot be read.
    """

    def __init__(self, path: str | os.PathLike[str], preset: Preset, channel: Channel = Channel.MIX) -> None:
        self._tap = RecentSamples(SoundReader(path, channel))
        self._player = Player(self._tap, while_played(preset), self._open_device)
        self._preset = preset
        self._transform = SpectrumAnalyser(AnalysisSettings(filters=frozenset()))
        self._newest: Analysis | None = None
        self._stopped = False
        self._volume = 0.0

    def play(self, *, loop: bool = False) -> None:
        """Go on from the position; with `loop`, begin again at the end."""
        if self._stopped:
            self._stopped, self._newest = False, None
        self._player.loop = loop
        self._player.play()

    def pause(self) -> None:
        """Hold still, and keep the position."""
        self._player.pause()

    def stop(self) -> None:
        """Hold still, at the beginning."""
        self._player.pause()
        self._player.seek(0)
        self._stopped = True

    def seek(self, seconds: float) -> None:
        """Go to a position, rounded down to 10 ms."""
        self._player.seek(seconds)

    @property
    def playing(self) -> bool:
        """Whether it plays: from `play` until its end, `pause` or `stop`."""
        return self._player.playing and not self._player.finished

    @property
    def position(self) -> float:
        """Seconds from the beginning to what is playing now."""
        return min(self._player.position, self.duration)

    @property
    def duration(self) -> float:
        """Length of the sound, seconds."""
        return self._tap.duration

    @property
    def volume(self) -> float:
        """Loudness of the playback, dB; 0 as in the file, -inf silent. The recognition does not change."""
        return self._volume

    @volume.setter
    def volume(self, decibels: float) -> None:
        self._volume = min(float(decibels), 0.0)
        self._player.set_gain(10 ** (self._volume / 20))

    @property
    def preset(self) -> Preset:
        """What it recognises with; `set_preset` takes another one."""
        return self._preset

    def set_preset(self, preset: Preset) -> None:
        """Recognise with another preset from the next 20 ms on."""
        self._preset = preset
        self._player.set_preset(while_played(preset))

    def poll(self) -> Reading:
        """Return the phoneme and the intensity of what is playing now; AudioError where the file is damaged there.

        In a pause they stay as they were; after the end, and after `stop`, there is silence.
        """
        taken = self._player.take_analyses()
        if taken:
            self._newest = taken[-1]
        return latest_reading(None if self._stopped or self._player.finished else self._newest)

    def spectrum(self, channel: Channel = Channel.LEFT) -> Float32Array:
        """Return the amplitudes of what is playing now, 0..1, shape (512,): bin k lies at k x 21.53 Hz."""
        frames = mono_of(self._tap.around(self._at()), channel)[np.newaxis]
        amplitudes: Float32Array = (self._transform.magnitudes_of(frames) * self._transform.scale)[0, :N_BINS]
        return amplitudes

    def analysis_buffer(self, channel: Channel = Channel.LEFT) -> Float32Array:
        """Return the 2048 samples around what is playing now, ±1, silence beyond the sound's ends."""
        return mono_of(self._tap.around(self._at()), channel)

    @override
    def close(self) -> None:
        self._player.close()

    def _open_device(self, n_channels: int) -> Output:
        """Open what is played on; a subclass plays elsewhere."""
        return open_output(n_channels)

    def _at(self) -> int:
        return round(self._player.position * SAMPLE_RATE)
