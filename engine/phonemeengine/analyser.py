"""The way of a sound, on one page: samples -> frames -> spectra -> features -> phonemes.

Live and offline are the same: live pushes the few samples since the last tick, a file pushes blocks of 512
frames, and the result does not depend on how the sound was cut.
"""

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from phonemeengine.arrays import Float32Array, Float64Array, ShortRepr, UInt8Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.resampling import SampleIntake
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.mel import spread_mel
from phonemeengine.errors import SettingsError
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.features import front_end
from phonemeengine.features.variables import Features
from phonemeengine.labels.visemes import STANDARD_VISEMES, VisemeSet
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import for_files, for_live_use, recogniser_for, while_played
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.plug_ins import completed
from phonemeengine.recognition.scores import Recognition, scores_in, separations_of
from phonemeengine.recognition.segments import PhonemeSmoother, VisemeSmoother, intensities_of
from phonemeengine.recognition.spec import Finishing, Joining, Recogniser, spec_of
from phonemeengine.settings import BIN_WIDTH, FRAME_PERIOD, HOP, SAMPLE_RATE, WINDOW, AnalysisSettings

BLOCK = 512
"""Most frames that are worked on at once: the arrays of one block stay in the processor's cache."""

HELD_FRAMES = 8
"""Frames for which a single window is taken to last: with fewer or more, the network is right less often."""

_NONE_ARRIVED = np.zeros((0, WINDOW), np.float32)
_SILENCE = int(Phoneme.SILENCE)  # which compares faster than the member does
_BY_FRAME = ("recognised", "phonemes", "visemes", "intensities", "confidences")


@dataclass(frozen=True, repr=False)
class Analysis(ShortRepr):
    """What was found in a block of frames.

    Attributes
    ----------
    start : number of the first frame, counted from the beginning of the sound.
    frames : what was measured.
    recognised : uint8, shape (n_frames,): codes of `Phoneme`, as the recogniser says.
    phonemes : uint8, shape (n_frames,): the same after the statistics.
    visemes : uint8, shape (n_frames,): codes of the visemes of the set that go with the phonemes, or `NO_VISEME`.
    intensities : float32, shape (n_frames,): 0..1 from the peak level; 0 where the phoneme is silence.
    confidences : float32, shape (n_frames,): the confidence of the phonemes: the share of such answers that are
        right, 0..1; NaN where that is not known, see `sure_of`.
    settings : with which all of this was found.
    viseme_scores : float32, shape (n_frames, n_visemes): how likely each viseme is; None where the recogniser tells
        none apart.
    viseme_set : the visemes that it tells apart; of the usual set the codes are those of `Viseme`.
    arrived : of live sound, the samples of the frames that have come since the last block, float32, shape
        (n_arrived, 2048): newer than `frames` by the look-ahead. Empty in a `part`, and where sound is not live.
    """

    start: int
    frames: front_end.FrameBlock
    recognised: UInt8Array
    phonemes: UInt8Array
    visemes: UInt8Array
    intensities: Float32Array
    confidences: Float32Array
    settings: AnalysisSettings
    viseme_scores: Float32Array | None = None
    viseme_set: VisemeSet = STANDARD_VISEMES
    arrived: Float32Array = field(default_factory=lambda: _NONE_ARRIVED)

    def __len__(self) -> int:
        return len(self.phonemes)

    @property
    def spectra(self) -> Float32Array:
        """Amplitudes after all filters, float32, shape (n_frames, n_bins), bin k at k x 21.53 Hz."""
        return self.frames.spectra

    @property
    def mel(self) -> Float32Array | None:
        """The same through the mel bank, float32, shape (n_frames, n_bands), or None while it is off."""
        return self.frames.mel

    @property
    def linear_spectra(self) -> Float32Array:
        """The amplitudes on the linear axis, also while the mel bank is on, float32, shape (n_frames, n_bins)."""
        return self.spectra if self.mel is None else spread_mel(self.mel, self.spectra.shape[1], BIN_WIDTH)

    @property
    def waveforms(self) -> Float32Array:
        """The windows after the filters of the time domain, float32, shape (n_frames, n_samples)."""
        return self.frames.waveforms

    @property
    def features(self) -> Features:
        """The measured variables."""
        return self.frames.features

    @property
    def times(self) -> Float64Array:
        """Middle of each frame in seconds, shape (n_frames,)."""
        return (self.start + np.arange(len(self), dtype=float) + 0.5) * FRAME_PERIOD

    @property
    def viseme_phones(self) -> list[str]:
        """For each frame the letter of a sound that looks as it does; empty where its phoneme says as much."""
        return self.viseme_set.phones_of(self.visemes)

    def part(self, frames: slice) -> "Analysis":
        """Return some of the frames of the block, as a block."""
        first, last, _ = frames.indices(len(self))
        return replace(
            self,
            start=self.start + first,
            frames=self.frames.part(slice(first, last)),
            viseme_scores=None if self.viseme_scores is None else self.viseme_scores[first:last],
            arrived=_NONE_ARRIVED,
            **{name: getattr(self, name)[first:last] for name in _BY_FRAME},
        )


class Analyser:
    """Follows one sound: push its samples as they come, get what was found in the frames they complete.

    A recogniser that looks ahead lets its last frames wait for the next samples, or for `finish`.

    Parameters
    ----------
    preset : what to recognise with.
    rate : of the samples, Hz, 1000..768000; what is not at 44.1 kHz is resampled.
    live : for live sound: look ahead only as far as the preset's ``live_look_ahead``, and resample with an even
        delay, as `Listener` and the shipped runtime do.
    pitch : measure ``f0`` too, which no rule needs; without it ``f0`` reads 0.
    start : number of the first frame, where the samples begin in the midst of a longer sound.
    phonemes_only : leave spectra, waveforms and variables out where the recogniser needs none; `volume` stays.
    recogniser : what is asked instead of the preset's, made for this sound; an object with `recognise` is enough.

    Raises
    ------
    AudioError : the rate lies outside its range.
    EngineError : the preset's recogniser cannot be made.
    """

    def __init__(
        self,
        preset: Preset,
        *,
        rate: int = SAMPLE_RATE,
        live: bool = False,
        pitch: bool = False,
        start: int = 0,
        phonemes_only: bool = False,
        recogniser: object | None = None,
    ) -> None:
        self._live = live
        self._intake = SampleIntake(rate, steady=live)
        preset = self._in_force(preset)
        self._pitch = pitch
        self._phonemes_only = phonemes_only
        self._preset = preset
        self._framer = Framer()
        self._path = self._path_of(preset)
        self._use(recogniser_for(preset) if recogniser is None else completed(recogniser))
        self._statistics, self._visemes = PhonemeSmoother(*_smoothing_of(preset)), VisemeSmoother()
        self._waiting = front_end.LookAheadBuffer()
        self._arrived = _NONE_ARRIVED
        self._unasked = False
        self._next = start

    @property
    def preset(self) -> Preset:
        """What is recognised with."""
        return self._preset

    @property
    def recogniser(self) -> Recogniser:
        """The recogniser in use; its `explain` says why."""
        return self._recogniser

    @property
    def n_replaced(self) -> int:
        """Samples that were NaN or infinite, and were taken for 0."""
        return self._intake.n_replaced

    @property
    def delay(self) -> float:
        """Delay of the resampler now, seconds."""
        return self._intake.delay

    def set_preset(self, preset: Preset) -> None:
        """Go on with another preset from the next frame; what need not change remembers its past.

        Raises
        ------
        EngineError : its recogniser cannot be made; everything stays as it was.
        """
        preset = self._in_force(preset)
        old, recogniser = self._preset, self._recogniser
        if _recogniser_key(preset) != _recogniser_key(old):
            recogniser = recogniser_for(preset)
        self._preset = preset
        if self._path_key(preset) != self._path_key(old):
            self._change_path(preset)
        if (preset.settings.statistics, _smoothing_of(preset)) != (old.settings.statistics, _smoothing_of(old)):
            self._statistics = PhonemeSmoother(*_smoothing_of(preset))
        if recogniser is not self._recogniser:
            self._change_recogniser(recogniser)

    def push(self, samples: ArrayLike) -> Analysis:
        """Take the next samples, and return the analysis of the frames that they complete.

        Parameters
        ----------
        samples : shape (n,), or (n, n_channels), of which the mean is analysed; float32 within ±1, int16 or int32.
            NaN and infinity are taken for 0, and counted.

        Raises
        ------
        AudioError : they are of another type or shape, or lie far beyond ±1.
        """
        return self._analyse(self._frames_of(samples))

    def finish(self) -> Analysis:
        """Analyse the last frames, with silence after the end of the sound."""
        rest_of_sound = self._framer.cut_frames(self._intake.finish())
        last = self._analyse(np.concatenate([rest_of_sound, self._framer.finish()]))
        n = self._recogniser.look_ahead
        if n == 0:
            return last
        if isinstance(self._recogniser, Finishing):
            rest = self._answered(self._path.nothing(), self._recogniser.finish())
        else:
            rest = self._recognise(self._path.measure(np.zeros((n, WINDOW), np.float32)))
        return concatenate_analyses([last, self._with_arrived(rest, _NONE_ARRIVED)])

    def _in_force(self, preset: Preset) -> Preset:
        return for_live_use(preset) if self._live else preset

    def _frames_of(self, samples: ArrayLike) -> Float32Array:
        return self._framer.cut_frames(self._intake.take(samples))

    def _analyse(self, frames: Float32Array) -> Analysis:
        if 0 < len(frames) <= BLOCK and not self._unasked:
            return self._with_arrived(self._recognise(self._path.measure(frames)), frames)
        waiting, self._unasked = self._waiting.clear() if self._unasked else None, False
        ready = [] if waiting is None else [self._recognise(waiting)]
        pushed = [self._path.measure(frames[k : k + BLOCK]) for k in range(0, len(frames), BLOCK)]
        found = [*ready, *(self._recognise(block) for block in pushed)] or [self._recognise(self._path.nothing())]
        return self._with_arrived(concatenate_analyses(found), frames)

    def _with_arrived(self, found: Analysis, frames: Float32Array) -> Analysis:
        """Return a block of live sound with the frames that came; they go with the next one if it has no answers."""
        if not self._live:
            return found
        frames = np.concatenate((self._arrived, frames)) if len(self._arrived) else frames
        self._arrived = _NONE_ARRIVED if len(found) else frames
        return replace(found, arrived=frames) if len(found) else found

    def _recognise(self, measured: front_end.FrameBlock) -> Analysis:
        return self._answered(measured, self._recogniser.recognise(measured.windows, measured.features))

    def _answered(self, measured: front_end.FrameBlock, recognition: Recognition) -> Analysis:
        """Return the frames that the recogniser has spoken of, of those that came now or wait."""
        if self._recogniser.look_ahead:
            measured = self._waiting.delay(measured, len(recognition.phonemes))
        return self._completed(measured, recognition)

    def _completed(self, measured: front_end.FrameBlock, recognition: Recognition) -> Analysis:
        settings = self._preset.settings
        phonemes = recognised = recognition.phonemes
        levels = measured.features["volume"]
        if recognition.scores is not None:
            measured = measured.with_columns(self._recogniser.scores, recognition.scores)
        has_deficits = spec_of(self._preset.recogniser).has_deficits
        found = recognised if recognition.decoded is None else recognition.decoded
        wavers = settings.statistics and self._statistics.has_change(found)
        by_rules = self._preset.is_measured and recognition.scores is None and has_deficits
        deficits = self._recogniser.deficits(measured.features) if wavers or by_rules else None
        if settings.statistics:
            phonemes = self._statistics.smooth(found, deficits if wavers else None)
        intensities = intensities_of(levels, settings.intensity_low, settings.intensity_high)
        intensities *= phonemes != _SILENCE
        start, self._next = self._next, self._next + len(recognised)
        visemes = self._visemes.follow(phonemes, recognition.visemes, recognition.viseme_set)
        sure = sure_of(self._preset, phonemes, scores_in(measured.features), deficits if by_rules else None)
        seen, kind = recognition.visemes, recognition.viseme_set
        return Analysis(start, measured, recognised, phonemes, visemes, intensities, sure, settings, seen, kind)

    def _path_of(self, preset: Preset) -> front_end.FrontEnd | front_end.LevelFrontEnd | front_end.PitchSetFrontEnd:
        if self._leaves_features_out(preset):
            return front_end.LevelFrontEnd()
        if preset.pitch_ranges:
            return front_end.PitchSetFrontEnd(
                [p.settings for p in preset.by_pitch], preset.pitch_ranges, preset.variables
            )
        return front_end.FrontEnd(preset.settings, preset.variables, pitch=self._pitch)

    def _path_key(self, preset: Preset) -> object:
        settings = [p.settings for p in preset.by_pitch]
        return self._leaves_features_out(preset), settings, preset.pitch_ranges, preset.variables

    def _leaves_features_out(self, preset: Preset) -> bool:
        return self._phonemes_only and not spec_of(preset.recogniser).needs_features

    def _change_path(self, preset: Preset) -> None:
        old, self._path = self._path, self._path_of(preset)
        waiting = self._waiting.clear()
        if waiting is not None:
            self._waiting.delay(self._path.measure(waiting.windows), 0)
        self._path.resume(old)

    def _change_recogniser(self, recogniser: Recogniser) -> None:
        """Have the new one asked, with the next frames, about those of which the old one has not said anything."""
        self._use(recogniser)
        self._unasked = True

    def _use(self, recogniser: Recogniser) -> None:
        self._recogniser = recogniser
        # asked here, since asking is slow, and each block of each sound wants to know
        self._joining = recogniser if isinstance(recogniser, Joining) else None


def sure_of(
    preset: Preset, phonemes: UInt8Array, scores: Float32Array | None, deficits: Float32Array | None
) -> Float32Array:
    """Return the confidence of phonemes, float32, shape (n_frames,): the share of such answers that are right, 0..1.

    Parameters
    ----------
    preset : whose curve turns scores into shares; rules say how far they are from naming another phoneme.
    phonemes : what is named, shape (n_frames,).
    scores : of a recogniser that has them, shape (n_frames, n_phonemes).
    deficits : of one by rules, shape (n_frames, n_phonemes). With neither, or where rules were not measured on
        labelled speech, all is NaN.
    """
    if scores is not None:
        return preset.curve.of(scores[np.arange(len(phonemes)), phonemes])
    if deficits is not None and preset.is_measured:
        return preset.curve.of(separations_of(deficits, phonemes))
    return np.full(len(phonemes), np.nan, np.float32)


def push_together(pushes: Sequence[tuple[Analyser, Float32Array]]) -> list[Analysis]:
    """Push the next samples of several sounds, each to its own analyser; many at once cost far less than one by one.

    Networks of one model are asked together; what each analyser says is as if it were alone, but for rounding.
    """
    frames = [analyser._frames_of(samples) for analyser, samples in pushes]
    found: dict[int, Analysis] = {}
    groups: defaultdict[object, dict[int, Joining]] = defaultdict(dict)
    for k, ((analyser, _), cut) in enumerate(zip(pushes, frames, strict=True)):
        joining = analyser._joining
        if joining is not None and not analyser._unasked and 0 < len(cut) <= joining.most_together:
            groups[k if joining.kin is None else joining.kin][k] = joining
        else:
            found[k] = analyser._analyse(cut)
    for group in groups.values():
        first, *others = group.values()
        recognised = first.recognise_with(others, [frames[k] for k in group])
        for k, recognition in zip(group, recognised, strict=True):
            analyser = pushes[k][0]
            answered = analyser._answered(analyser._path.measure(frames[k]), recognition)
            found[k] = analyser._with_arrived(answered, frames[k])
    return [found[k] for k in range(len(pushes))]


def concatenate_analyses(analyses: Sequence[Analysis]) -> Analysis:
    """Return consecutive blocks as one; there must be at least one."""
    blocks = [a for a in analyses if len(a)] or analyses  # an empty one may lack the scores of visemes
    of_visemes = [a.viseme_scores for a in blocks if a.viseme_scores is not None]
    return Analysis(
        analyses[0].start,
        front_end.concatenate([a.frames for a in analyses]),
        settings=analyses[-1].settings,
        viseme_scores=np.concatenate(of_visemes) if len(of_visemes) == len(blocks) else None,
        viseme_set=analyses[-1].viseme_set,
        arrived=np.concatenate([a.arrived for a in analyses]),
        **{name: np.concatenate([getattr(a, name) for a in analyses]) for name in _BY_FRAME},
    )


class Reading(NamedTuple):
    """A phoneme, how loud it is, 0..1, and its confidence: the share of such answers that are right, 0..1, or None.

    None says that this is not known: the recogniser has no scores, or is one by rules that was not measured.
    """

    phoneme: Phoneme = Phoneme.SILENCE
    intensity: float = 0.0
    confidence: float | None = 0.0


def latest_reading(newest: Analysis | None) -> Reading:
    """Return the last frame of a block; silence where there is none yet."""
    if newest is None or len(newest) == 0:
        return Reading()
    last = newest.part(slice(len(newest) - 1, None))
    sure = float(last.confidences[0])
    return Reading(Phoneme(int(last.phonemes[0])), float(last.intensities[0]), None if math.isnan(sure) else sure)


def recognise_window(buffer: ArrayLike, preset: Preset) -> Reading:
    """Return the phoneme and the intensity of one analysis buffer at once, as the engine of the thesis did.

    Nothing is waited for and nothing remembered. Recognisers that look at frames alone (``thesis``, ``extended``,
    ``templates``) answer as in running speech, but for its calming; the network ``learned`` lives on what came
    before, takes the window for a sound that holds, and is right far less often than with `Analyser.push`.

    Parameters
    ----------
    buffer : 2048 samples, mono, 44.1 kHz, shape (2048,), as `Analyser.push` takes them; the answer is about their
        middle.
    preset : what to recognise with.

    Raises
    ------
    SettingsError : the buffer has another shape.
    EngineError : the preset's recogniser cannot be used.
    """
    samples = np.asarray(buffer)
    if samples.shape != (WINDOW,):
        raise SettingsError(f"an analysis buffer has the shape ({WINDOW},), got {samples.shape}; give one of mono")
    window = SampleIntake(SAMPLE_RATE).take(samples)
    at_once = replace(preset, settings=replace(preset.settings, look_ahead=0.0))
    held = np.repeat(window[np.newaxis], HELD_FRAMES, axis=0)
    return latest_reading(Analyser(at_once, phonemes_only=True)._analyse(held))


def _recogniser_key(preset: Preset) -> object:
    return preset.recogniser, preset.config, preset.model_kind, preset.live_encoder, preset.search


def _smoothing_of(preset: Preset) -> tuple[float, Mapping[Phoneme, Phoneme], float]:
    hysteresis = preset.settings.hysteresis if preset.decoder is None and preset.search is None else 0.0
    return preset.settings.minimum_hold, preset.successors, hysteresis


def analyse_blocks(
    blocks: Iterable[ArrayLike],
    preset: Preset,
    *,
    rate: int = SAMPLE_RATE,
    pitch: bool = False,
    start: int = 0,
    recogniser: object | None = None,
) -> Iterator[Analysis]:
    """Analyse a whole sound, given as blocks for an `Analyser` with these options; ends with its last frames."""
    analyser = Analyser(preset, rate=rate, pitch=pitch, start=start, recogniser=recogniser)
    yield from filter(len, map(analyser.push, blocks))
    if len(rest := analyser.finish()):
        yield rest


def analyse_file(
    reader: SoundReader, preset: Preset, *, pitch: bool = False, progress: Progress = no_progress
) -> Iterator[Analysis]:
    """Analyse the rest of a sound file with the best model that the preset has for files, a few seconds at a time.

    Raises
    ------
    AudioError : the sound cannot be read.
    Cancelled : `progress`, which is called with the share that is done, did not want to go on.
    """
    for analysis in analyse_blocks(reader.blocks(BLOCK * HOP), for_files(preset), pitch=pitch):
        report_progress(progress, min(1.0, (analysis.start + len(analysis)) * HOP / max(1, reader.n_samples)))
        yield analysis


def analyse_range(
    reader: SoundReader, first: int, last: int, preset: Preset, *, pitch: bool = False
) -> Iterator[Analysis]:
    """Analyse frames first..last-1 of a file as if it had been played from its beginning.

    The frames before `first` that the filters remember are analysed too, but not given.
    """
    start = max(0, first - preset.pre_roll)
    reader.seek(start * HOP)
    for analysis in analyse_blocks(reader.blocks(BLOCK * HOP), while_played(preset), pitch=pitch, start=start):
        wanted = analysis.part(slice(max(0, first - analysis.start), max(0, last - analysis.start)))
        if len(wanted):
            yield wanted
        if analysis.start + len(analysis) >= last:
            return
