"""Is a take good enough to calibrate with, what is to be done if not, and which segment of it is steady sound."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.level import FULL
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.settings import FRAME_PERIOD, HOP

LEAST_SOUND = 0.3
"""Seconds of sound that a take needs."""
SILENT_BELOW = -60.0
"""Where the loudest 10 ms stay below this level, there is no sound; dB below full scale (RMS)."""
LOUDER_THAN_ROOM = 6.0
"""A sound lies this much above the background noise, dB."""
SOFTEST_PART = 30.0
"""What lies this much below the loudest 10 ms is not part of the sound, dB."""
MOST_CLIPPED = 0.0005
"""Share of samples at full scale that is let pass."""
LEAST_SNR = {True: 15.0, False: 8.0}
"""How far a vowel (True) or another sound must lie above the room, dB."""
LEAST_LEVEL = -50.0
"""A sound must be as loud as this, dB below full scale (RMS)."""
LOUD_ROOM = -50.0
"""A room from here on is the reason why a sound does not stand out, dB below full scale (RMS)."""
LOUDEST_SILENCE = 10.0
"""In a take of silence nothing may lie this much above the room, dB."""

LONGEST_GAP = 0.15
"""Pauses that do not end a sound, seconds."""
SOFTEST_PUFF = 20.0
"""What lies this much below the loudest 10 ms is no part of a puff of the lips, dB."""
BEFORE_PUFF, AFTER_PUFF = 0.01, 0.02
"""What belongs to a puff besides, seconds: its first movement, and its dying away."""
LEAST_PAUSE = 0.03
"""A pause between two puffs lasts at least this, seconds."""
ATTACK = 0.05
"""What a sound needs to begin, and to end, seconds; it is not steady there."""
STEADY_WITHIN = 6.0
"""The steady part stays this close to its median level, dB."""
LEAST_STEADY = 0.1
"""Seconds; where less is steady, the whole sound counts."""

TINY = 1e-20
NO_SOUND = 1e-6
"""Digital silence counts as so loud, an amplitude: -120 dB below full scale."""


class Fault(StrEnum):
    """What may be wrong with a take."""

    SILENT = "silent"
    TOO_SHORT = "too short"
    TOO_QUIET = "too quiet"
    TOO_NOISY = "too noisy"
    CLIPPED = "clipped"
    NOT_SILENT = "not silent"


TOO_LITTLE = frozenset({Fault.SILENT, Fault.TOO_SHORT})
"""Faults of a take that does not hold what was to be said: it would only mislead."""


@dataclass(frozen=True)
class TakeReport:
    """What was found in a take.

    Attributes
    ----------
    faults : what is wrong, the worst first; for each a sentence that says what to do.
    onset, offset : where the sound begins and ends, seconds; both 0 where there is none.
    start, end : the segment of steady sound, seconds; what should count of the take.
    level : of that segment, dB below full scale (RMS).
    noise : of the room, in the same; -inf where it is not known.
    snr : how far the sound lies above the room, dB; inf where the room is not known.
    clipped : share of samples at full scale, 0..1.
    pauses : between the puffs of a p that is said several times, (start, end) in seconds: silence.
    """

    faults: Mapping[Fault, str]
    onset: float
    offset: float
    start: float
    end: float
    level: float
    noise: float
    snr: float
    clipped: float
    pauses: tuple[tuple[float, float], ...] = ()

    @property
    def good(self) -> bool:
        """Whether nothing is wrong."""
        return not self.faults

    @property
    def too_little(self) -> bool:
        """Whether there is no sound, or one too short to count by itself."""
        return bool(TOO_LITTLE & set(self.faults))

    def within(self, start: float, duration: float) -> "TakeReport":
        """Return the report of this take, as a part of a longer sound without silence."""
        first, last = (self.start, self.end) if self.start < self.end else (0.0, duration)
        pauses = tuple((start + a, start + b) for a, b in self.pauses)
        return replace(self, onset=0.0, offset=math.inf, start=start + first, end=start + last, pauses=pauses)


def check_take(samples: Float32Array, noise: float, phoneme: Phoneme) -> TakeReport:
    """Check a take.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz, ±1.
    noise : RMS level of the room, as an amplitude (`RoomNoise.level`); 0 where it is not known.
    phoneme : what was to be said.
    """
    duration = len(samples) / (HOP / FRAME_PERIOD)
    levels = _levels_of(samples)
    is_silence = phoneme is Phoneme.SILENCE
    sounding = slice(0, len(levels)) if is_silence else _sounding_in(levels, noise, bridged=phoneme is Phoneme.P)
    steady = sounding if phoneme in {Phoneme.SILENCE, Phoneme.P} else _steady_in(levels, sounding)
    measured = levels[steady] if steady.stop > steady.start else levels
    power = float(np.mean(measured**2)) if len(measured) else 0.0
    clean = max(power - noise**2, TINY)
    report = TakeReport(
        faults={},
        onset=min(sounding.start * FRAME_PERIOD, duration),
        offset=duration if sounding.stop == len(levels) else sounding.stop * FRAME_PERIOD,
        start=min(steady.start * FRAME_PERIOD, duration),
        end=duration if steady.stop == len(levels) else steady.stop * FRAME_PERIOD,
        level=_decibels(power**0.5),
        noise=_decibels(noise) if noise > 0 else -np.inf,
        snr=_decibels(clean**0.5 / noise) if noise > 0 else np.inf,
        clipped=float(np.mean(np.abs(samples) >= FULL)) if len(samples) else 0.0,
        pauses=_pauses_in(levels, sounding) if phoneme is Phoneme.P else (),
    )
    loudest = float(levels.max(initial=0.0))
    found = _faults_of_silence(report, loudest) if is_silence else _faults_of_sound(report, loudest, phoneme)
    return replace(report, faults=dict(found))


def _faults_of_sound(report: TakeReport, loudest: float, phoneme: Phoneme) -> Iterator[tuple[Fault, str]]:
    if report.offset <= report.onset or _decibels(loudest) < SILENT_BELOW:
        yield (
            Fault.SILENT,
            f"No sound was recorded: the loudest part is at {_decibels(loudest):.0f} dBFS. Check that the microphone "
            "is on and say it again, louder or closer.",
        )
        return
    if report.clipped > MOST_CLIPPED:
        yield (
            Fault.CLIPPED,
            f"The recording is clipped: {100 * report.clipped:.1f} % of the samples are at full scale. Say it again, "
            "a little further from the microphone, or turn its level down.",
        )
    if report.offset - report.onset < LEAST_SOUND:
        yield (
            Fault.TOO_SHORT,
            f"The sound lasted only {report.offset - report.onset:.2f} s; {LEAST_SOUND:g} s or more are needed. Say "
            "it again and hold it.",
        )
    least = LEAST_SNR[phoneme in VOWELS]
    if report.snr < least and report.noise > LOUD_ROOM:
        yield (
            Fault.TOO_NOISY,
            f"The sound is {report.snr:.0f} dB above the background noise, which is loud ({report.noise:.0f} dBFS); "
            f"{least:g} dB or more are needed. Reduce the noise or move closer to the microphone, and say it again.",
        )
    elif report.snr < least:
        yield (
            Fault.TOO_QUIET,
            f"The sound is {report.snr:.0f} dB above the background noise; {least:g} dB or more are needed. Say it "
            "again, louder or closer to the microphone.",
        )
    elif report.level < LEAST_LEVEL:
        yield (
            Fault.TOO_QUIET,
            f"The sound reached only {report.level:.0f} dBFS; {LEAST_LEVEL:g} dBFS or more are needed. Say it again, "
            "louder or closer, or turn the microphone's level up.",
        )


def _faults_of_silence(report: TakeReport, loudest: float) -> Iterator[tuple[Fault, str]]:
    if report.end - report.start < LEAST_SOUND:
        yield (
            Fault.TOO_SHORT,
            f"The silence lasted only {report.end - report.start:.2f} s; {LEAST_SOUND:g} s or more are needed. Keep "
            "quiet for longer.",
        )
    usual = report.noise if np.isfinite(report.noise) else LOUD_ROOM
    if _decibels(loudest) > usual + LOUDEST_SILENCE:
        yield (
            Fault.NOT_SILENT,
            f"There is a sound of {_decibels(loudest):.0f} dBFS in the silence, whose background noise is at "
            f"{usual:.0f} dBFS. Keep quiet and record it again.",
        )


def _levels_of(samples: Float32Array) -> Float64Array:
    """Return the RMS level of each 10 ms, without a constant offset; what is left at the end counts as well."""
    sound = samples.astype(np.float64)
    sound -= sound.mean() if len(sound) else 0.0
    starts = np.arange(0, len(sound), HOP)
    powers = np.add.reduceat(sound**2, starts) if len(sound) else np.zeros(0)
    return np.sqrt(powers / np.minimum(HOP, len(sound) - starts))


def _sounding_in(levels: Float64Array, noise: float, *, bridged: bool) -> slice:
    """Return the longest segment of sound, over short pauses; over all of them where they belong to the sound."""
    least = max(
        noise * _ratio(LOUDER_THAN_ROOM), levels.max(initial=0.0) * _ratio(-SOFTEST_PART), _ratio(SILENT_BELOW)
    )
    frames = np.flatnonzero(levels > least)
    if not len(frames):
        return slice(0, 0)
    longest_gap = len(levels) if bridged else round(LONGEST_GAP / FRAME_PERIOD)
    parts = np.split(frames, np.flatnonzero(np.diff(frames) > longest_gap) + 1)
    longest = max(parts, key=lambda part: int(part[-1] - part[0]))
    return slice(int(longest[0]), int(longest[-1]) + 1)


def _pauses_in(levels: Float64Array, sounding: slice) -> tuple[tuple[float, float], ...]:
    """Return the pauses between puffs, seconds: what is left when every puff has what belongs to it."""
    loud = (
        np.flatnonzero(levels[sounding] > levels[sounding].max(initial=0.0) * _ratio(-SOFTEST_PUFF)) + sounding.start
    )
    before, after, least = (round(t / FRAME_PERIOD) for t in (BEFORE_PUFF, AFTER_PUFF, LEAST_PAUSE))
    gaps = zip((loud[:-1] + 1 + after).tolist(), (loud[1:] - before).tolist(), strict=True)
    return tuple((first * FRAME_PERIOD, end * FRAME_PERIOD) for first, end in gaps if end - first >= least)


def _steady_in(levels: Float64Array, sounding: slice) -> slice:
    """Leave out how a sound begins and ends: some time, and until it is as loud as in its middle."""
    attack = round(ATTACK / FRAME_PERIOD)
    inner = slice(sounding.start + attack, sounding.stop - attack)
    if inner.stop <= inner.start:
        return sounding
    middle = max(float(np.median(levels[inner])), TINY)
    near = np.flatnonzero(np.abs(20 * np.log10(np.maximum(levels[inner], TINY) / middle)) <= STEADY_WITHIN)
    steady = slice(inner.start + int(near[0]), inner.start + int(near[-1]) + 1)
    return steady if (steady.stop - steady.start) * FRAME_PERIOD >= LEAST_STEADY else sounding


def _ratio(decibels: float) -> float:
    return float(10 ** (decibels / 20))


def _decibels(amplitude: float) -> float:
    return float(20 * np.log10(max(amplitude, NO_SOUND)))
