"""Background noise: what a microphone records while there is no speech, and what distinguishes it from speech.

The denoise threshold is set for every recogniser. Silence is found by the thresholds of the thesis rules; a preset
with rules of its own gets one before them; recognisers by templates or scores get what `silence_level_for` or
`sensitivity_for` finds.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from typing_extensions import override

from phonemeengine.analyser import BLOCK, Analyser
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.mel import log_mels
from phonemeengine.errors import TakeError
from phonemeengine.features.front_end import FrontEnd, concatenate
from phonemeengine.features.variables import Features
from phonemeengine.labels.utterance import CORE
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Condition, Rule, Thresholds
from phonemeengine.recognition.scores import MOST_LOG_ODDS, scores_in
from phonemeengine.recognition.spec import Tuning, spec_of
from phonemeengine.recognition.templates import levels_of
from phonemeengine.settings import FRAME_PERIOD, HOP, PARAMETERS, SAMPLE_RATE, WINDOW, Filter

# What makes a room silence for recognisers by scores: a sensitivity of the learned one, a level of templates.
#
# Both only rise: a room that is silence already changes nothing. Where there is speech, they rise no further than it
# bears.

SILENT_SHARE = 0.99
"""Share of the room's frames that shall be silence, and of the speech's that shall not."""
MARGIN_LOG_ODDS = 1.1
"""By how much silence is likelier in the room than anything else: three to one, in nats."""
MARGIN_LEVEL = 3.0
"""By how much the level of silence lies above the room, and below speech, dB."""
HIGHEST_LEVEL = -10.0
"""No room is so loud that what reaches this level is silence, dB."""
LEAST_LIKELY = 1e-7


def sensitivity_for(room: Float32Array, preset: Preset, speech: Float32Array | None = None) -> float:
    """Return the sensitivity for silence, nats, with which the learned recogniser takes a room for silence.

    Parameters
    ----------
    room : float32, shape (n,), 44.1 kHz.
    preset : of the learned recogniser; the sensitivity that it has is the least.
    speech : without pauses, in the same form.
    """
    now = preset.sensitivities.get(Phoneme.SILENCE, 0.0)
    found = MARGIN_LOG_ODDS - float(np.quantile(_log_odds_of(room, preset), 1 - SILENT_SHARE))
    if speech is not None and len(speech):
        found = min(found, -float(np.quantile(_log_odds_of(speech, preset), SILENT_SHARE)))
    return round(min(max(now, found), MOST_LOG_ODDS), 2)


def silence_level_for(room: Float32Array, now: float, speech: Float32Array | None = None) -> float:
    """Return the level below which templates take a frame for silence, dB; at least what it is `now`."""
    found = float(np.quantile(_levels_in(room), SILENT_SHARE)) + MARGIN_LEVEL
    if speech is not None and len(speech):
        found = min(found, float(np.quantile(_levels_in(speech), 1 - SILENT_SHARE)) - MARGIN_LEVEL)
    return round(min(max(now, found), HIGHEST_LEVEL), 1)


def _log_odds_of(sound: Float32Array, preset: Preset) -> Float64Array:
    """Return how much likelier silence is than the likeliest other phoneme, nats, without its own sensitivity."""
    others = {**preset.sensitivities, Phoneme.SILENCE: 0.0}
    analyser = Analyser(replace(preset, sensitivities=others), phonemes_only=True)
    parts = [scores_in(a.features) for a in (analyser.push(sound), analyser.finish())]
    scores = np.log(np.maximum(np.concatenate([p for p in parts if p is not None]), LEAST_LIKELY), dtype=np.float64)
    silence = scores[:, Phoneme.SILENCE].copy()
    scores[:, Phoneme.SILENCE] = -np.inf
    return np.asarray(silence - scores.max(axis=1))


def _levels_in(sound: Float32Array) -> Float32Array:
    return levels_of(log_mels(Framer().cut_frames(sound)))


LEAST_SECONDS = 1.0
"""A measurement needs this much silence, seconds."""
SHARE = 0.99
"""Share of the room's frames that must stay below a threshold."""
MARGIN = 1.5
"""A threshold lies above what the room reaches by this factor: rooms are not equally loud all day."""
LEAST_AMPLITUDE = 1e-5
"""The least amplitude of a bin that a threshold names (-100 dB): a microphone that delivers zeros sets none."""
SPREAD = 3.0
"""How many standard deviations of resampling lie on each side of a value: with steady white noise, what a long
measurement gives lies between in at least eight of ten cases of two seconds."""
CONFIDENT = 1.96
"""Standard deviations that hold 95 %."""
N_RESAMPLES = 400
CORRELATED = WINDOW // HOP + 1
"""Frames whose windows overlap: they are drawn together, since they say nearly the same."""
DISTURBED = 12.0
"""Where the loudest 10 ms lie this much above the usual ones, the room was not silent, dB."""
LOUDEST = -30.0
"""What is as loud as this all the time is no silence, dB below full scale (RMS)."""
SILENT = 1e-6
"""Where all samples stay below this amplitude, a microphone delivers nothing (24 bits reach 1.2e-7)."""

MEASURED = {
    "denoise_threshold": "max_energy",
    "silence_energy": "energy",
    "silence_max_energy": "max_energy",
    "silence_zero_crossings": "zero_crossings",
}
"""The variable of the room that sets each threshold; none of them changes with the denoise threshold."""


@dataclass(frozen=True)
class ConfidenceInterval:
    """A threshold, and between which values a long measurement would most likely put it."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class SilenceAccuracy:
    """How well a preset tells the room from speech; bounds are of a confidence of 95 %.

    Attributes
    ----------
    room_silent : share of the room's frames that are called silence, 0..1.
    speech_silent : share of the speech's frames that are; None where there was no speech.
    """

    room_silent: ConfidenceInterval
    speech_silent: ConfidenceInterval | None

    @override
    def __str__(self) -> str:
        speech = self.speech_silent
        lost = "" if speech is None else f"; speech in the takes: {_in_words(speech)}"
        return f"Background noise recognised as silence: {_in_words(self.room_silent)}{lost}"


@dataclass(frozen=True)
class RoomNoise:
    """The background noise as a preset's front end measures it.

    Attributes
    ----------
    bounds : by name, denoise_threshold and the silence thresholds of the thesis rules.
    level : RMS amplitude of the room.
    seconds : how much was measured.
    notes : what speaks against the measurement, a sentence each; mostly none.
    samples : what was measured.
    """

    bounds: Mapping[str, ConfidenceInterval]
    level: float
    seconds: float
    notes: tuple[str, ...]
    samples: Float32Array = field(repr=False, compare=False)

    @property
    def decibels(self) -> float:
        """RMS level of the room, dB below full scale."""
        return float(20 * np.log10(max(self.level, SILENT)))

    @override
    def __str__(self) -> str:
        return f"{self.decibels:.0f} dBFS, measured for {self.seconds:.1f} s"

    def set_silence(self, preset: Preset, speech: Float32Array | None = None) -> Preset:
        """Return the preset that takes the room for silence, otherwise the same.

        Parameters
        ----------
        preset : with the front end that the room was measured with.
        speech : takes of speech without pauses, one after the other, float32, shape (n,), 44.1 kHz; sensitivities
            and templates go no further than it bears.
        """
        tuned_by = spec_of(preset.recogniser).tuned_by
        settings = replace(preset.settings, denoise_threshold=self.bounds["denoise_threshold"].value)
        if Tuning.RULES in tuned_by:
            return replace(preset, settings=settings, rules=self._rules_of(preset))
        settings = replace(settings, filters=settings.filters | {Filter.DENOISE})
        preset = self._with_thresholds(replace(preset, settings=settings))
        if Tuning.TEMPLATES in tuned_by and preset.templates is not None:
            level = silence_level_for(self.samples, preset.templates.silence_below, speech)
            return replace(preset, templates=replace(preset.templates, silence_below=level))
        if Tuning.SENSITIVITIES in tuned_by:
            louder = sensitivity_for(self.samples, preset, speech)
            return replace(preset, sensitivities={**preset.sensitivities, Phoneme.SILENCE: louder})
        return preset

    def silence_accuracy(self, preset: Preset, speech: Float32Array | None = None) -> SilenceAccuracy:
        """Return how well a preset tells the room from speech.

        Parameters
        ----------
        preset : as from `set_silence`.
        speech : as there.
        """
        of_speech = None if speech is None or len(speech) < WINDOW else _share_silent(speech, preset)
        return SilenceAccuracy(_share_silent(self.samples, preset), of_speech)

    def _with_thresholds(self, preset: Preset) -> Preset:
        """Set the silence of the thesis rules.

        Where the preset denoises too weakly to clear the room's spectra, `silence_szsch1` rises to what is left
        in them: no frame would be silence otherwise.
        """
        values = {name: bound.value for name, bound in self.bounds.items() if name != "denoise_threshold"}
        preset = replace(preset, thresholds=replace(preset.thresholds, **values))
        left = MARGIN * float(np.quantile(_features_of(self.samples, preset)["m_szsch1"], SHARE))
        highest = max(preset.thresholds.silence_szsch1, left)
        return replace(preset, thresholds=replace(preset.thresholds, silence_szsch1=highest))

    def _rules_of(self, preset: Preset) -> tuple[Rule, ...]:
        """Ask for the room before all other rules; what asked for another room before makes room for it."""
        limits = {MEASURED[name]: bound.value for name, bound in self.bounds.items() if name in MEASURED}
        conditions = tuple(Condition(variable, "<", limit=limit) for variable, limit in limits.items())
        names = [c.variable for c in conditions]
        known = preset.rules and [c.variable for c in preset.rules[0].conditions] == names
        return (Rule(Phoneme.SILENCE, conditions), *(preset.rules[1:] if known else preset.rules))


def measure_room(samples: Float32Array, preset: Preset) -> RoomNoise:
    """Measure the background noise with the front end of a preset.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz, ±1: about two seconds of silence.
    preset : whose front end listens.

    Raises
    ------
    TakeError : it is shorter than a second, or holds NaN or infinity.
    """
    seconds = len(samples) / SAMPLE_RATE
    if seconds < LEAST_SECONDS:
        raise TakeError(
            f"background noise must be measured for {LEAST_SECONDS:g} s or more, got {seconds:.2f} s; keep quiet for "
            "two seconds"
        )
    if not np.isfinite(samples).all():
        raise TakeError(
            "the samples of background noise must be finite numbers, got NaN or infinity; record the silence again"
        )
    features = _features_of(samples, preset)
    least = _least_thresholds(preset)
    bounds = {name: _bound_of(features[variable], least[name]) for name, variable in MEASURED.items()}
    bounds["denoise_threshold"] = _capped(bounds["denoise_threshold"], PARAMETERS["denoise_threshold"].high)
    level = float(np.sqrt(np.mean((samples - samples.mean(dtype=np.float64)) ** 2, dtype=np.float64)))
    return RoomNoise(bounds, level, seconds, tuple(_notes(samples)), samples)


def _bound_of(values: Float32Array, least: float) -> ConfidenceInterval:
    """Return the quantile of a variable in the room with its margin, and how far resampling moves it.

    Blocks of frames that overlap are drawn with replacement (moving-block bootstrap, Künsch 1989).
    """
    n_blocks = max(1, len(values) // CORRELATED)
    starts = np.random.default_rng(0).integers(0, max(1, len(values) - CORRELATED + 1), (N_RESAMPLES, n_blocks))
    drawn = values[np.minimum(starts[..., np.newaxis] + np.arange(CORRELATED), len(values) - 1)]
    doubt = SPREAD * float(np.quantile(drawn.reshape(N_RESAMPLES, -1), SHARE, axis=1).std())
    found = float(np.quantile(values, SHARE))
    value, low, high = (max(least, MARGIN * x) for x in (found, found - doubt, found + doubt))
    return ConfidenceInterval(value, low, high)


def _capped(bound: ConfidenceInterval, most: float) -> ConfidenceInterval:
    return ConfidenceInterval(min(bound.value, most), min(bound.low, most), min(bound.high, most))


def _least_thresholds(preset: Preset) -> dict[str, float]:
    """Return what each threshold is at least, whatever the room: a room that hums hardly crosses zero."""
    return {
        "denoise_threshold": LEAST_AMPLITUDE,
        "silence_energy": LEAST_AMPLITUDE * preset.settings.n_bins,
        "silence_max_energy": LEAST_AMPLITUDE,
        "silence_zero_crossings": Thresholds().silence_zero_crossings,
    }


def _features_of(samples: Float32Array, preset: Preset) -> Features:
    """Measure the frames whose windows lie in the sound, whatever the preset recognises with."""
    front_end = FrontEnd(preset.settings, preset.variables, pitch=False)
    frames = Framer().cut_frames(samples)
    return concatenate([front_end.measure(frames[k : k + BLOCK]) for k in range(0, len(frames), BLOCK)]).features


def _share_silent(samples: Float32Array, preset: Preset) -> ConfidenceInterval:
    """Return the share of frames that are recognised as silence, with Wilson's bounds (1927).

    Frames whose windows overlap say nearly the same, so they count as one observation.
    """
    found = Analyser(preset, phonemes_only=True).push(samples).recognised
    share = float(np.mean(found == Phoneme.SILENCE)) if len(found) else float("nan")
    n = max(1.0, len(found) / CORRELATED)
    middle = (share + CONFIDENT**2 / (2 * n)) / (1 + CONFIDENT**2 / n)
    doubt = CONFIDENT / (1 + CONFIDENT**2 / n) * (share * (1 - share) / n + CONFIDENT**2 / (4 * n**2)) ** 0.5
    return ConfidenceInterval(share, max(0.0, middle - doubt), min(1.0, middle + doubt))


def _in_words(share: ConfidenceInterval) -> str:
    return f"{100 * share.value:.0f} % ({100 * share.low:.0f}–{100 * share.high:.0f} %)"


def _notes(samples: Float32Array) -> list[str]:
    frame = round(FRAME_PERIOD * SAMPLE_RATE)
    n_frames = len(samples) // frame
    parts = samples[: n_frames * frame].reshape(n_frames, frame).astype(np.float64)
    powers = np.mean((parts - samples.mean(dtype=np.float64)) ** 2, axis=1)
    if np.abs(samples).max() < SILENT:
        return [
            "The microphone delivers digital silence, which sets no thresholds; check that it is on and not muted."
        ]
    usual = 10 * np.log10(max(float(np.median(powers)), SILENT**2))
    if usual > LOUDEST:
        return [f"The background noise was as loud as a voice ({usual:.0f} dBFS); keep quiet and measure it again."]
    above = 10 * np.log10(powers.max() / max(float(np.median(powers)), SILENT**2))
    if above > DISTURBED:
        return [f"A sound stood {above:.0f} dB above the background noise; keep quiet and measure it again."]
    return []


# What takes say of the room they were recorded in, and of the speech in it.

BRIEF = frozenset({Phoneme.P, Phoneme.UNIDENTIFIED})
"""What is no speech to measure by: puffs are mostly the room."""


def room_in(takes: Sequence[LabelledUtterance]) -> Float32Array | None:
    """Return the sound of the newest take without speech, float32, shape (n,), 44.1 kHz; None without one.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    for take in reversed(takes):
        phonemes = {label.phoneme for label in take.labels if label.certainty == CORE}
        if phonemes == {Phoneme.SILENCE}:
            room = _joined(_stretches(take))
            if len(room) >= LEAST_SECONDS * SAMPLE_RATE:
                return room
    return None


def speech_in(takes: Sequence[LabelledUtterance]) -> Float32Array | None:
    """Return what is surely said in takes, without pauses and p, one after the other; None where nothing is.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    found = _joined(part for take in takes for part in _stretches(take, without=BRIEF | {Phoneme.SILENCE}))
    return found if len(found) else None


def _stretches(take: LabelledUtterance, without: frozenset[Phoneme] = BRIEF) -> Iterator[Float32Array]:
    """Return the sound of each label that is certain."""
    wanted = [label for label in take.labels if label.certainty == CORE and label.phoneme not in without]
    if not wanted:
        return
    with SoundReader(take.path, as_it_is=True) as reader:
        sound = reader.read_mono()
    for label in wanted:
        yield sound[round(label.start * SAMPLE_RATE) : round(label.end * SAMPLE_RATE)]


def _joined(parts: Iterable[Float32Array]) -> Float32Array:
    return np.concatenate([np.zeros(0, np.float32), *parts])
