"""Noise that is added to labelled recordings, to see how much of a recognition is lost in it.

Its music, and the noises of a desk with keyboard, fan and mouse, are made here.
"""

import math
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.errors import AudioError, CorpusError, SettingsError, check_range
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import HOP, SAMPLE_RATE

CHORDS = ((0, 4, 7), (0, 3, 7), (0, 4, 7, 11), (0, 3, 7, 10), (0, 5, 7))
"""Semitones above the root."""
PROGRESSION = (0, 5, 7, 9, 2, 4)
"""Roots of the chords of a key, semitones."""


def music(n: int, generator: np.random.Generator) -> Float32Array:
    """Return music, shape (n,), with a root mean square of 1: chords, a bass, a melody and drums, in a drawn key."""
    beat = int(SAMPLE_RATE * 60 / generator.uniform(70, 150))
    key, sound = generator.uniform(48, 60), np.zeros(n + 4 * beat)
    partials = 1 / np.arange(1, generator.integers(3, 12)) ** generator.uniform(0.8, 2)
    drums, melody = generator.uniform(0, 1.5), generator.uniform(0, 0.6)
    for first in range(0, n, 4 * beat):
        root = key + PROGRESSION[generator.integers(len(PROGRESSION))]
        chord = CHORDS[generator.integers(len(CHORDS))]
        for note in chord:
            _add(sound, first, 0.3 * _note(root + note, 4 * beat, partials, 1.0))
        for k in range(4):
            _add(sound, first + k * beat, 0.6 * _note(root - 12, beat, partials[:3], 0.3))
            _add(sound, first + k * beat, drums * (_kick(generator) if k % 2 == 0 else _snare(generator)))
            _add(sound, first + k * beat + beat // 2, 0.3 * drums * _hat(generator))
            step = chord[generator.integers(len(chord))] + 12 * generator.integers(1, 3)
            _add(sound, first + k * beat, melody * _note(root + step, beat, partials, 0.4))
    return _normal(sound[:n])


def desk(n: int, generator: np.random.Generator) -> Float32Array:
    """Return the noise of a desk, shape (n,), with a root mean square of 1: a fan that hums, and a keyboard."""
    times = np.arange(n) / SAMPLE_RATE
    hum = sum(
        generator.uniform(0, 1) / k * np.sin(2 * np.pi * k * generator.uniform(98, 102) * times) for k in range(1, 6)
    )
    sound = hum + 0.5 * _brown(n, generator)
    sound /= np.sqrt(np.mean(sound**2)) + 1e-12
    for first in np.flatnonzero(generator.random(n) < generator.uniform(0, 6) / SAMPLE_RATE):
        _add(sound, int(first), generator.uniform(3, 12) * _click(generator))
    return _normal(sound)


BACKGROUNDS = (music, desk)


def _add(sound: Float64Array, first: int, part: Float64Array) -> None:
    end = min(first + len(part), len(sound))
    if end > first:
        sound[first:end] += part[: end - first]


def _note(midi: float, n: int, partials: Float64Array, decay: float) -> Float64Array:
    """Return a plucked note: harmonics that decay, the higher ones sooner."""
    times = np.arange(n) / SAMPLE_RATE
    frequency = 440 * 2 ** ((midi - 69) / 12)
    tones = [
        height * np.exp(-times * (1 + 0.3 * k) / decay) * np.sin(2 * np.pi * (k + 1) * frequency * times)
        for k, height in enumerate(partials)
        if (k + 1) * frequency < SAMPLE_RATE / 2
    ]
    attack = np.minimum(times / 0.005, 1)
    return np.asarray(attack * sum(tones), float)


def _kick(_generator: np.random.Generator) -> Float64Array:
    times = np.arange(SAMPLE_RATE // 5) / SAMPLE_RATE
    return np.asarray(np.exp(-times / 0.05) * np.sin(2 * np.pi * 50 * times + 20 * (1 - np.exp(-times / 0.02))))


def _snare(generator: np.random.Generator) -> Float64Array:
    times = np.arange(SAMPLE_RATE // 6) / SAMPLE_RATE
    return np.asarray(
        np.exp(-times / 0.04) * (generator.standard_normal(len(times)) + np.sin(2 * np.pi * 190 * times))
    )


def _hat(generator: np.random.Generator) -> Float64Array:
    noise = generator.standard_normal(SAMPLE_RATE // 12)
    return np.asarray(np.exp(-np.arange(len(noise)) / SAMPLE_RATE / 0.02) * np.diff(noise, prepend=0.0))


def _click(generator: np.random.Generator) -> Float64Array:
    times = np.arange(SAMPLE_RATE // 50) / SAMPLE_RATE
    tone = np.sin(2 * np.pi * generator.uniform(1500, 5000) * times)
    return np.asarray(np.exp(-times / 0.002) * (generator.standard_normal(len(times)) + tone))


def _brown(n: int, generator: np.random.Generator) -> Float64Array:
    """Return noise that is weaker by 6 dB an octave above 100 Hz."""
    from scipy.signal import lfilter  # noqa: PLC0415 - it costs time at the start

    keep = np.exp(-2 * np.pi * 100 / SAMPLE_RATE)
    noise = lfilter([1], [1, -keep], generator.standard_normal(n))
    return np.asarray(noise / (np.sqrt(np.mean(noise**2)) + 1e-12))


def _normal(sound: Float64Array) -> Float32Array:
    return np.asarray(sound / (np.sqrt(np.mean(sound**2)) + 1e-12), np.float32)


LOOP = 12 * SAMPLE_RATE
"""Samples after which a noise begins again, without a seam."""
LOWEST_AUDIBLE = 20.0
"""Pink noise, whose power would grow without end towards 0 Hz, begins here, Hz."""
SEAM = SAMPLE_RATE // 2
"""Samples over which the end of music goes over into its beginning."""
NOT_IN_TRAINING = 14
"""Goes into the seed, so that no training used the same music."""
VOICES = 8
"""Voices that babble at most."""
POOL = 24
"""Recordings that are kept for the babble at most."""
LOWEST_SNR, HIGHEST_SNR = -30.0, 80.0
"""Ratios of speech to noise that are accepted, dB."""
SPEECH_BLOCK = 512 * HOP
"""Samples of which the level is measured at once."""


class NoiseKind(StrEnum):
    """What noise it is: equal power per hertz, equal power per octave, others who speak at once, or made-up music."""

    WHITE = "white"
    PINK = "pink"
    BABBLE = "babble"
    MUSIC = "music"


@dataclass(frozen=True)
class AddedNoise:
    """A noise at a level.

    Attributes
    ----------
    kind : what noise.
    snr : by how much the segments labelled as speech are above it, mean power to mean power, -30..80 dB.
    seed : of what is drawn at random, 0 or more.

    Raises
    ------
    SettingsError : a value lies outside its range.
    """

    kind: NoiseKind
    snr: float
    seed: int = 0

    def __post_init__(self) -> None:
        check_range("the signal-to-noise ratio", self.snr, (LOWEST_SNR, HIGHEST_SNR, "dB"))
        if self.seed < 0:
            raise SettingsError(f"the noise's seed must be 0 or more, got {self.seed}; choose another")


class NoiseAdder:
    """Adds noise to recordings; the same recording always gets the same, whatever else is analysed.

    Parameters
    ----------
    noise : what is added.
    utterances : the corpus, whose other speakers babble.
    """

    def __init__(self, noise: AddedNoise, utterances: Sequence[LabelledUtterance]) -> None:
        self.noise = noise
        if noise.kind is NoiseKind.BABBLE:
            self._pool = _pool_of(utterances, noise.seed)
            self._period: Callable[[str], Float32Array] = lru_cache(maxsize=4)(self._babble_around)
        else:
            loop = _loop(noise.kind, noise.seed)
            self._period = lambda _speaker: loop

    def blocks(self, utterance: LabelledUtterance, n: int) -> Iterator[Float32Array]:
        """Return a recording with the noise in it, in blocks of at most `n` samples at 44.1 kHz.

        Where nothing is labelled as speech, or the speech is digital silence, no noise is added.

        Raises
        ------
        AudioError : the sound cannot be read.
        CorpusError : babble is asked for, and there is no other speaker.
        """
        period = self._period(utterance.speaker)
        gain = speech_level_of(utterance) * 10 ** (-self.noise.snr / 20)
        name = f"{utterance.voice}/{utterance.path.name}"
        place = int(np.random.default_rng([self.noise.seed, zlib.crc32(name.encode())]).integers(LOOP))
        with utterance.opened() as reader:
            for block in reader.blocks(n):
                at = np.arange(place, place + len(block)) % LOOP
                yield block + np.float32(gain) * period[at]
                place += len(block)

    def _babble_around(self, speaker: str) -> Float32Array:
        """Let those speak at once who are not this speaker; RMS 1."""
        others = [sound for who, sound in self._pool if who != speaker][:VOICES]
        if not others:
            raise CorpusError(
                f"babble is made of the corpus's other speakers, and there is none but {speaker}; add one, or choose "
                "white or pink noise"
            )
        generator = np.random.default_rng([self.noise.seed, zlib.crc32(speaker.encode())])
        babble = sum(np.roll(sound, int(generator.integers(LOOP))) for sound in others)
        return _of_level_one(np.asarray(babble))


def speech_level_of(utterance: LabelledUtterance) -> float:
    """Return the RMS of those segments of a recording that are labelled as speech, 0 where there is none.

    Raises
    ------
    AudioError : the sound cannot be read.
    """
    spoken = frame_labels_of(utterance.labels).phonemes != Phoneme.SILENCE
    power, n, frame = 0.0, 0, 0
    with utterance.opened() as reader:
        for block in reader.blocks(SPEECH_BLOCK):
            is_speech = np.repeat(spoken[frame : frame + len(block) // HOP + 1], HOP)[: len(block)]
            speech = block[: len(is_speech)][is_speech]
            power += float(np.sum(speech.astype(float) ** 2))
            n += len(speech)
            frame += SPEECH_BLOCK // HOP
    return math.sqrt(power / n) if n else 0.0


def _loop(kind: NoiseKind, seed: int) -> Float32Array:
    """Draw a period of Gaussian noise or of music, RMS 1."""
    if kind is NoiseKind.MUSIC:
        return _music(seed)
    drawn = np.random.default_rng(seed).standard_normal(LOOP)
    spectrum = np.fft.rfft(drawn)
    spectrum[0] = 0.0
    if kind is NoiseKind.PINK:
        frequencies = np.fft.rfftfreq(LOOP, 1 / SAMPLE_RATE)
        spectrum[frequencies < LOWEST_AUDIBLE] = 0.0
        spectrum[1:] /= np.sqrt(frequencies[1:])
    return _of_level_one(np.fft.irfft(spectrum, LOOP))


def _music(seed: int) -> Float32Array:
    """Make up a period of music, RMS 1; its end goes over into its beginning."""
    drawn = music(LOOP + SEAM, np.random.default_rng([seed, NOT_IN_TRAINING]))
    rising = np.linspace(0, 1, SEAM)
    period = drawn[:LOOP].astype(float)
    period[:SEAM] = np.sqrt(rising) * drawn[:SEAM] + np.sqrt(1 - rising) * drawn[LOOP:]
    return _of_level_one(period)


def _pool_of(utterances: Sequence[LabelledUtterance], seed: int) -> list[tuple[str, Float32Array]]:
    """Choose voices in turn from all speakers; each repeats itself where it is short."""
    generator = np.random.default_rng(seed)
    by_speaker: dict[str, list[LabelledUtterance]] = {}
    for k in generator.permutation(len(utterances)):
        by_speaker.setdefault(utterances[k].speaker, []).append(utterances[k])
    rounds = max((len(theirs) for theirs in by_speaker.values()), default=0)
    in_turn = [theirs[k] for k in range(rounds) for theirs in by_speaker.values() if k < len(theirs)]
    pool = []
    for utterance in in_turn:
        sound = _voice_of(utterance)
        if sound is not None:
            pool.append((utterance.speaker, sound))
        if len(pool) == POOL:
            break
    return pool


def _voice_of(utterance: LabelledUtterance) -> Float32Array | None:
    """Return a recording as a period of noise, or None where it is silent or unreadable, as its scorer tells."""
    try:
        with utterance.opened() as reader:
            block = next(reader.blocks(LOOP), np.zeros(0, np.float32))
    except AudioError:
        return None
    return _of_level_one(np.resize(block, LOOP)) if np.any(block) else None


def _of_level_one(sound: Float64Array | Float32Array) -> Float32Array:
    return np.asarray(sound / np.sqrt(np.mean(sound.astype(float) ** 2)), np.float32)
