"""A tone in place of a sound file: a stream at 44.1 kHz that has no end and can be changed while it plays."""

from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, Int64Array
from phonemeengine.audio.tone.settings import Tone, ToneKind
from phonemeengine.audio.tone.waveforms import Waveform, waveform_of
from phonemeengine.settings import SAMPLE_RATE, Channel

FADE = 220
"""Samples from one tone to the next (5 ms)."""


@dataclass(frozen=True)
class _Oscillator:
    """A waveform that goes round at a steady rate, so that it is known at every sample.

    Attributes
    ----------
    since, phase : a sample, and the share of a round that has passed there.
    """

    kind: ToneKind
    wave: Waveform
    gain: float
    since: int = 0
    phase: float = 0.0

    def cycles(self, samples: Int64Array) -> Float64Array:
        """Return how many rounds have passed at samples, but for whole ones.

        Whole seconds are reduced before they are multiplied, so that days later the phase is as exact as at first.
        """
        seconds, rest = np.divmod(samples - self.since, SAMPLE_RATE)
        whole = (self.wave.rate % 1.0) * seconds % 1.0
        return self.phase + whole + self.wave.rate * rest / SAMPLE_RATE

    def at(self, samples: Int64Array) -> Float64Array:
        """Return the sound at samples."""
        return self.gain * self.wave.at(self.cycles(samples))

    def begun(self, sample: int, phase: float) -> "_Oscillator":
        """Return the same with a given phase at a sample."""
        return _Oscillator(self.kind, self.wave, self.gain, sample, phase % 1.0)


class _Change:
    """The way from one voice to the next: a fade, during which one rate glides into the other if the kind stays."""

    def __init__(self, old: _Oscillator, new: _Oscillator, start: int) -> None:
        self._old = old
        self._start = start
        self._glides = old.kind is new.kind
        self._phase = float(old.cycles(np.array([start]))[0])
        self._rise = (new.wave.rate - old.wave.rate) / (2 * FADE)
        self.end = start + FADE
        end_phase = float(self._glided(np.array([float(FADE)]))[0])
        self.new = new.begun(self.end, end_phase) if self._glides else new.begun(start, 0.0)

    def at(self, samples: Int64Array) -> Float64Array:
        """Return the sound at samples from the start to the end."""
        steps = (samples - self._start).astype(float)
        share = 0.5 - 0.5 * np.cos(np.pi * steps / FADE)
        if not self._glides:
            return (1 - share) * self._old.at(samples) + share * self.new.at(samples)
        cycles = self._glided(steps)
        old, new = (voice.gain * voice.wave.at(cycles) for voice in (self._old, self.new))
        return (1 - share) * old + share * new

    def _glided(self, steps: Float64Array) -> Float64Array:
        """Integrate a rate that goes evenly from the old to the new within the fade."""
        return np.asarray(self._phase + (self._old.wave.rate + self._rise * steps) * steps / SAMPLE_RATE)


class ToneReader:
    """Gives a tone as a stream, in the manner of `SoundReader`.

    `set_tone` may be called from another thread than the rest. Until a tone is changed, the value of a sample
    depends on the sample only, however the stream was cut and wherever it was entered.

    Attributes
    ----------
    tone : what was asked for last.
    channel : always the mix; there is one channel.
    n_channels : 1.
    n_samples : where the stream ends: after 288 days.
    position : the next sample that `read` gives.
    """

    n_channels = 1
    n_samples = 1 << 40
    channel = Channel.MIX

    def __init__(self, tone: Tone) -> None:
        self.tone = tone
        self.position = 0
        self._asked = self._taken = self._voice = _voice_of(tone)
        self._change: _Change | None = None

    @property
    def duration(self) -> float:
        """Length of the stream, seconds: 288 days."""
        return self.n_samples / SAMPLE_RATE

    def set_tone(self, tone: Tone) -> None:
        """Go over to another tone within 5 ms from the next `read` on, without a click.

        A tone of the same kind goes on where the other was: its frequency glides, and so do level and formants. A
        tone of another kind begins at its beginning.
        """
        self._asked, self.tone = _voice_of(tone), tone

    def read(self, n: int) -> Float32Array:
        """Return the next samples, fewer than `n` only at the end.

        Returns
        -------
        float32, shape (n, 1), ±1.
        """
        n = max(0, min(n, self.n_samples - self.position))
        block = np.empty((n, 1), np.float32)
        done = 0
        while done < n:
            done += self._fill(block[done:, 0])
        return block

    def mono(self, block: Float32Array) -> Float32Array:
        """Return the one channel of a block, shape (n,)."""
        return block[:, 0]

    def seek(self, sample: int) -> None:
        """Go to a sample, beyond the ends meaning the ends; a change under way is over."""
        self.position = min(max(sample, 0), self.n_samples)
        self._change = None

    def close(self) -> None:
        """Do nothing: a tone holds no file."""

    def _fill(self, room: Float32Array) -> int:
        """Fill room up to its end or to where a change is over; returns how much was filled."""
        if self._change is not None and self.position >= self._change.end:
            self._change = None
        asked = self._asked  # read once: `set_tone` may set it at any moment
        if self._change is None and asked is not self._taken:
            self._change = _Change(self._voice, asked, self.position)
            self._taken, self._voice = asked, self._change.new
        source = self._change or self._voice
        n = min(len(room), self._change.end - self.position) if self._change else len(room)
        room[:n] = source.at(np.arange(self.position, self.position + n))
        self.position += n
        return n


def _voice_of(tone: Tone) -> _Oscillator:
    return _Oscillator(tone.kind, waveform_of(tone), 10 ** (tone.level / 20))
