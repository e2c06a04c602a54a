"""The way of a sound, on one page: samples -> frames -> spectra -> features -> phonemes.

Live and offline are the same: live pushes the few samples since the last tick, a file pushes blocks of 512
frames, and the result does not depend on how the sound was cut.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from engine.audio.files import SoundReader
from engine.dsp.filters import (
    FrequencyShaper,
    TimeSmoother,
    denoise,
    high_pass_gains,
    low_pass_gains,
    normalise,
)
from engine.dsp.framing import Framer
from engine.dsp.mel import mel_edges, mel_spectra_of
from engine.dsp.pitch import fundamental_of
from engine.dsp.spectrum import Transform
from engine.features.measure import BandMeter, Features, peak_levels_of, zero_crossings_of
from engine.features.variables import BAND_VARIABLES, ENERGY_VARIABLES, WHOLE_FRAME_VARIABLES, Spectrum, Variable
from engine.presets.preset import Preset
from engine.recognition.intensity import intensities_of
from engine.recognition.recogniser import Recogniser, recogniser_of
from engine.recognition.statistics import Statistics
from engine.settings import BIN_WIDTH, FRAME_PERIOD, HOP, AnalysisSettings, Filter

BLOCK = 512
"""Most frames that are worked on at once: the arrays of one block stay in the processor's cache."""

PRE_ROLL = 40
"""Frames before a place in a sound that are analysed unseen, so that the filters know their past."""

ZERO_CROSSINGS, VOLUME, F0 = (WHOLE_FRAME_VARIABLES.index(name) for name in ("zero_crossings", "volume", "f0"))
MAX_ENERGY = slice(WHOLE_FRAME_VARIABLES.index("max_energy"), WHOLE_FRAME_VARIABLES.index("max_energy") + 1)

Block = NDArray[np.float32]


@dataclass(frozen=True)
class Analysis:
    """What was found in a block of frames.

    Attributes
    ----------
    start : number of the first frame, counted from the beginning of the sound.
    spectra : float32, shape (n_frames, n_bins): amplitudes after all filters, bin k at k x 21.53 Hz.
    mel : float32, shape (n_frames, n_bands): the same through the mel bank, or None while it is off.
    waveforms : float32, shape (n_frames, n_samples): the windows after the filters of the time domain.
    features : the measured variables.
    recognised : uint8, shape (n_frames,): codes of `Phoneme`, as the recogniser says.
    phonemes : uint8, shape (n_frames,): the same after the statistics.
    intensities : float32, shape (n_frames,): 0..1 from the peak level.
    """

    start: int
    spectra: Block
    mel: Block | None
    waveforms: Block
    features: Features
    recognised: NDArray[np.uint8]
    phonemes: NDArray[np.uint8]
    intensities: Block

    def __len__(self) -> int:
        return len(self.phonemes)

    @property
    def times(self) -> NDArray[np.float64]:
        """Middle of each frame in seconds, shape (n_frames,)."""
        return (self.start + np.arange(len(self), dtype=float) + 0.5) * FRAME_PERIOD

    def part(self, frames: slice) -> "Analysis":
        """Give some of the frames of the block, as a block."""
        first, last, _ = frames.indices(len(self))
        return replace(
            self,
            start=self.start + first,
            spectra=self.spectra[first:last],
            mel=None if self.mel is None else self.mel[first:last],
            waveforms=self.waveforms[first:last],
            features=Features(self.features.names, self.features.values[first:last]),
            recognised=self.recognised[first:last],
            phonemes=self.phonemes[first:last],
            intensities=self.intensities[first:last],
        )


class SpectrumPath:
    """The filters of one front end, from raw frames to measured variables; remembers the time smoothing."""

    def __init__(self, preset: Preset, *, pitch: bool) -> None:
        settings = preset.settings
        variables = (*BAND_VARIABLES, *preset.variables)
        blur = settings.frequency_smooth if settings.has(Filter.FREQUENCY_SMOOTH) else 0.0
        self.names = (*WHOLE_FRAME_VARIABLES, *(v.name for v in variables))
        self.smoother = TimeSmoother(settings.time_smooth)
        self._pitch = pitch
        self._n_bins = settings.n_bins
        self._transform = Transform(settings)
        self._shaper = FrequencyShaper(blur, _gains_of(settings), self._transform.scale[0])
        self._smooths = settings.has(Filter.TIME_SMOOTH) and settings.time_smooth > 0
        self._denoises = settings.has(Filter.DENOISE) and settings.denoise_threshold > 0
        self._threshold = np.array(settings.denoise_threshold, np.float32)
        self._normalises = settings.has(Filter.NORMALISE)
        self._mel_bands = settings.mel_bands if settings.has(Filter.MEL) else 0
        self._make_meters((*ENERGY_VARIABLES, *variables))

    def _make_meters(self, variables: tuple[Variable, ...]) -> None:
        bins = np.arange(self._n_bins, dtype=float) * BIN_WIDTH
        bands = mel_edges(self._mel_bands, self._n_bins * BIN_WIDTH)[1:-1]
        raw, mel = ([v for v in variables if v.source is source] for source in (Spectrum.RAW, Spectrum.MEL))
        self._meter = BandMeter(self.names, [v for v in variables if v not in (*raw, *mel)], bins)
        self._filtered = self._meter.weights(Spectrum.FILTERED)
        self._normalised = self._meter.weights(Spectrum.NORMALISED)
        self._raw_meter = BandMeter(self.names, raw, bins) if raw else None
        self._mel_meter = BandMeter(self.names, mel, bands) if mel and self._mel_bands else None

    def push(self, frames: Block) -> tuple[Block, Block | None, Block, Features]:
        """Give the final spectra, the mel spectra, the waveforms and the features of raw frames."""
        waves = self._transform.waveforms_of(frames)
        raw = self._transform.magnitudes_of(waves)
        if self._smooths:
            smooth = self.smoother.push(raw)
        else:
            smooth, self.smoother.last = raw, raw[-1]
        spectra = self._meter.room_for(len(frames))
        self._shaper.shape(smooth, spectra[:, : self._n_bins])  # over frequency, so it may well come after time
        self._meter.add_maxima(spectra)
        values: Block = spectra.dot(self._filtered)
        if self._raw_meter is not None:
            values += self._raw_meter.widen(raw * self._transform.scale).dot(self._raw_meter.weights(Spectrum.RAW))
        values[:, ZERO_CROSSINGS] = zero_crossings_of(frames)
        values[:, VOLUME] = peak_levels_of(frames)
        if self._pitch:
            values[:, F0] = fundamental_of(frames)
        if self._denoises:
            spectra = denoise(spectra, self._threshold)
        mel = self._mel_of(spectra) if self._mel_bands else None
        if self._normalises:
            spectra = normalise(spectra, values[:, MAX_ENERGY])
        values += spectra.dot(self._normalised)
        if self._mel_meter is not None and mel is not None:
            values += self._mel_meter.widen(mel).dot(self._mel_meter.weights(Spectrum.MEL))
        return spectra[:, : self._n_bins], mel, waves, Features(self.names, values)

    def _mel_of(self, spectra: Block) -> Block:
        mel = mel_spectra_of(spectra[:, : self._n_bins], self._mel_bands, BIN_WIDTH)
        return normalise(mel) if self._normalises else mel


def _gains_of(settings: AnalysisSettings) -> Block:
    gains = np.ones(settings.n_bins, np.float32)
    if settings.has(Filter.HIGH_PASS):
        gains *= high_pass_gains(len(gains), BIN_WIDTH, settings.high_pass_start, settings.high_pass_end)
    if settings.has(Filter.LOW_PASS):
        gains *= low_pass_gains(len(gains), BIN_WIDTH, settings.low_pass_start, settings.low_pass_end)
    return gains


class Analyser:
    """Follows one sound: push its samples as they come, get what was found in the frames they complete.

    Parameters
    ----------
    preset : what to recognise with.
    pitch : measure `f0` too, which no rule needs; without it `f0` reads 0.
    start : number of the first frame, where the samples begin in the midst of a longer sound.
    """

    def __init__(self, preset: Preset, *, pitch: bool = False, start: int = 0) -> None:
        self._pitch = pitch
        self._preset = preset
        self._framer = Framer()
        self._path = SpectrumPath(preset, pitch=pitch)
        self._recogniser = recogniser_of(preset.recogniser, preset.thresholds)
        self._statistics = _statistics_of(preset)
        self._next = start

    @property
    def preset(self) -> Preset:
        """What is recognised with."""
        return self._preset

    @property
    def recogniser(self) -> Recogniser:
        """The recogniser in use; its `explain` says why."""
        return self._recogniser

    def use(self, preset: Preset) -> None:
        """Go on with another preset from the next frame; what need not change remembers its past."""
        old = self._preset
        if (preset.recogniser, preset.thresholds) != (old.recogniser, old.thresholds):
            self._recogniser = recogniser_of(preset.recogniser, preset.thresholds)
        self._preset = preset
        if (preset.settings, preset.variables) != (old.settings, old.variables):
            last = self._path.smoother.last
            self._path = SpectrumPath(preset, pitch=self._pitch)
            self._path.smoother.last = last
        if _statistics_key(preset) != _statistics_key(old):
            self._statistics = _statistics_of(preset)

    def push(self, samples: Block) -> Analysis:
        """Take the next samples (float32, shape (n,), 44.1 kHz, ±1) and analyse the frames they complete."""
        return self._analyse(self._framer.push(samples))

    def push_windows(self, windows: Block) -> Analysis:
        """Analyse windows that the caller cut, shape (n, 2048), as if they followed each other every 10 ms."""
        return self._analyse(windows)

    def finish(self) -> Analysis:
        """Analyse the last frames, with silence after the end of the sound."""
        return self._analyse(self._framer.finish())

    def _analyse(self, frames: Block) -> Analysis:
        if 0 < len(frames) <= BLOCK:
            return self._analyse_block(frames)
        return self._join([self._analyse_block(frames[k : k + BLOCK]) for k in range(0, len(frames), BLOCK)])

    def _analyse_block(self, frames: Block) -> Analysis:
        settings = self._preset.settings
        spectra, mel, waveforms, features = self._path.push(frames)
        recognised = self._recogniser.recognise(features)
        phonemes = self._statistics.push(recognised) if settings.statistics else recognised
        levels = features.values[:, VOLUME]
        intensities = intensities_of(levels, settings.intensity_low, settings.intensity_high)
        start, self._next = self._next, self._next + len(frames)
        return Analysis(start, spectra, mel, waveforms, features, recognised, phonemes, intensities)

    def _join(self, blocks: list[Analysis]) -> Analysis:
        blocks = blocks or [self._nothing()]
        features = Features(self._path.names, np.concatenate([b.features.values for b in blocks]))
        return Analysis(
            start=blocks[0].start,
            spectra=np.concatenate([b.spectra for b in blocks]),
            mel=None if blocks[0].mel is None else np.concatenate([b.mel for b in blocks if b.mel is not None]),
            waveforms=np.concatenate([b.waveforms for b in blocks]),
            features=features,
            recognised=np.concatenate([b.recognised for b in blocks]),
            phonemes=np.concatenate([b.phonemes for b in blocks]),
            intensities=np.concatenate([b.intensities for b in blocks]),
        )

    def _nothing(self) -> Analysis:
        settings = self._preset.settings
        codes = np.zeros(0, np.uint8)
        return Analysis(
            start=self._next,
            spectra=np.zeros((0, settings.n_bins), np.float32),
            mel=np.zeros((0, settings.mel_bands), np.float32) if settings.has(Filter.MEL) else None,
            waveforms=np.zeros((0, settings.n_samples), np.float32),
            features=Features(self._path.names, np.zeros((0, len(self._path.names)), np.float32)),
            recognised=codes,
            phonemes=codes,
            intensities=np.zeros(0, np.float32),
        )


def _statistics_key(preset: Preset) -> object:
    return preset.settings.statistics, preset.settings.minimum_hold, preset.successors


def _statistics_of(preset: Preset) -> Statistics:
    return Statistics(preset.settings.minimum_hold, preset.successors)


def analyses_of(
    blocks: Iterable[Block], preset: Preset, *, pitch: bool = False, start: int = 0
) -> Iterator[Analysis]:
    """Analyse a whole sound, given as consecutive blocks of samples; ends with the frames at its end.

    `start` is the number of the first frame, where the blocks begin in the midst of a longer sound.
    """
    analyser = Analyser(preset, pitch=pitch, start=start)
    for block in blocks:
        analysis = analyser.push(block)
        if len(analysis):
            yield analysis
    analysis = analyser.finish()
    if len(analysis):
        yield analysis


def analyses_between(
    reader: SoundReader, first: int, last: int, preset: Preset, *, pitch: bool = False
) -> Iterator[Analysis]:
    """Analyse frames first..last-1 of a file as if it had been followed from its beginning.

    The frames before `first` that the filters remember are analysed too, but not given.
    """
    start = max(0, first - PRE_ROLL)
    reader.seek(start * HOP)
    for analysis in analyses_of(reader.blocks(BLOCK * HOP), preset, pitch=pitch, start=start):
        wanted = analysis.part(slice(max(0, first - analysis.start), max(0, last - analysis.start)))
        if len(wanted):
            yield wanted
        if analysis.start + len(analysis) >= last:
            return
