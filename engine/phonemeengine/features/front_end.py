"""The way of a block from samples to measured variables: transform, filters, meters; and what a recogniser sees.

Where a preset has sets of PhonemeData for ranges of pitch, the pitch of the voice chooses among them frame by frame:
the median of its fundamental frequency over the last second in which it was voiced. That depends on earlier frames
alone, so live sound and files are measured alike, however they are cut.
"""

from bisect import bisect_left, insort
from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, ShortRepr
from phonemeengine.dsp import spectrum
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.mel import mel_edges, mel_spectra_of, spread_mel
from phonemeengine.dsp.sonagram import FLOOR, SonagramSettings
from phonemeengine.features.variables import (
    BAND_VARIABLES,
    ENERGY_VARIABLES,
    FRAME_MEASURES,
    PITCH,
    PITCH_SET_COLUMNS,
    WHOLE_FRAME_VARIABLES,
    BandFeatures,
    Features,
    Spectrum,
    Variable,
    peak_levels_of,
    reach_of,
)
from phonemeengine.settings import BIN_WIDTH, HOP, WINDOW, AnalysisSettings, Filter

F0 = WHOLE_FRAME_VARIABLES.index(PITCH.name)
MAX_ENERGY = slice(WHOLE_FRAME_VARIABLES.index("max_energy"), WHOLE_FRAME_VARIABLES.index("max_energy") + 1)

FAINTEST = np.array(1e-6, np.float32)
"""What a variable is divided by at the least, so that the quotient is never endless."""


@dataclass(frozen=True, repr=False)
class FrameBlock(ShortRepr):
    """A block of frames before anybody has said what they are.

    Attributes
    ----------
    windows : float32, shape (n_frames, 2048): the samples that were measured.
    spectra : float32, shape (n_frames, n_bins): amplitudes after all filters, bin k at k x 21.53 Hz.
    mel : float32, shape (n_frames, n_bands): the same through the mel bank, or None while it is off.
    waveforms : float32, shape (n_frames, n_samples): the windows after the filters of the time domain.
    features : the measured variables.
    """

    windows: Float32Array
    spectra: Float32Array
    mel: Float32Array | None
    waveforms: Float32Array
    features: Features

    def __len__(self) -> int:
        return len(self.spectra)

    def part(self, frames: slice) -> "FrameBlock":
        """Return some of the frames of the block, as a block."""
        mel = None if self.mel is None else self.mel[frames]
        return FrameBlock(
            self.windows[frames], self.spectra[frames], mel, self.waveforms[frames], self.features.part(frames)
        )

    def with_columns(self, names: tuple[str, ...], values: Float32Array) -> "FrameBlock":
        """Return the same with more features, shape (n_frames, n_more)."""
        more = self.features.with_columns(names, values)
        return FrameBlock(self.windows, self.spectra, self.mel, self.waveforms, more)


class FrontEnd:
    """The filters of one front end, from raw frames to measured variables; remembers the time smoothing.

    Parameters
    ----------
    settings : the filters.
    variables : the user's own variables.
    pitch : measure ``f0`` too; without it ``f0`` reads 0.
    """

    def __init__(self, settings: AnalysisSettings, variables: tuple[Variable, ...], *, pitch: bool) -> None:
        variables = (*BAND_VARIABLES, *variables)
        self.names = (*WHOLE_FRAME_VARIABLES, *(v.name for v in variables))
        self._smoother = spectrum.TimeSmoother(settings.time_smooth if settings.has(Filter.TIME_SMOOTH) else 0.0)
        measured = [m for m in FRAME_MEASURES if pitch or m is not PITCH]
        self._frame_measures = [(self.names.index(m.name), m.measure) for m in measured]
        self._n_bins = settings.n_bins
        self._transform = spectrum.SpectrumAnalyser(settings)
        self._shaper = shaper_of(settings, self._transform.scale[0])
        self._denoises = settings.has(Filter.DENOISE) and settings.denoise_threshold > 0
        self._threshold = np.array(settings.denoise_threshold, np.float32)
        self._normalises = settings.has(Filter.NORMALISE)
        self._mel_bands = settings.mel_bands if settings.has(Filter.MEL) else 0
        self._make_meters((*ENERGY_VARIABLES, *variables))

    def _make_meters(self, variables: tuple[Variable, ...]) -> None:
        # Raw and mel variables look at other spectra than the rest, and have a meter of their own only where a preset
        # asks for them: most do not, and then nothing is computed.
        bins = np.arange(self._n_bins, dtype=float) * BIN_WIDTH
        bands = mel_edges(self._mel_bands, self._n_bins * BIN_WIDTH)[1:-1]
        raw, mel = ([v for v in variables if v.source is source] for source in (Spectrum.RAW, Spectrum.MEL))
        self._meter = BandFeatures(self.names, [v for v in variables if v not in (*raw, *mel)], bins)
        self._filtered = self._meter.weights(Spectrum.FILTERED)
        self._normalised = self._meter.weights(Spectrum.NORMALISED)
        self._raw_meter = BandFeatures(self.names, raw, bins) if raw else None
        self._mel_meter = BandFeatures(self.names, mel, bands) if mel and self._mel_bands else None
        divided = [(self.names.index(v.name), self.names.index(v.per)) for v in variables if v.per]
        self._divided = np.array(divided, np.intp).reshape(-1, 2).T

    def nothing(self) -> FrameBlock:
        """Return a block without frames."""
        silence = np.zeros((1, WINDOW), np.float32)
        waves = self._transform.waveforms_of(silence)
        raw = self._transform.magnitudes_of(waves)
        return self._measured(silence, waves, raw, raw).part(slice(0))

    def measure(self, frames: Float32Array) -> FrameBlock:
        """Measure raw frames, shape (n, 2048), at least one."""
        waves = self._transform.waveforms_of(frames)
        raw = self._transform.magnitudes_of(waves)
        return self._measured(frames, waves, raw, self._smoother.smooth(raw))

    def resume(self, other: object) -> None:
        """Have the time smoothing go on from where another front end stopped."""
        if isinstance(other, FrontEnd):
            self._smoother.resume(other._smoother)

    def _measured(
        self, frames: Float32Array, waves: Float32Array, raw: Float32Array, smooth: Float32Array
    ) -> FrameBlock:
        # From here each step has one array of the whole block, shape (n_frames, n_bins + n_maxima).
        spectra = self._meter.allocate(len(frames))
        self._shaper.shape(smooth, spectra[:, : self._n_bins])  # over frequency, so it may well come after time
        self._meter.fill_maxima(spectra)
        # Energy and its maximum are measured before normalising takes the loudness away. The columns of all other
        # variables are 0 in this product, and are added or set below.
        values: Float32Array = spectra.dot(self._filtered)
        if self._raw_meter is not None:
            values += self._raw_meter.append_maxima(raw * self._transform.scale).dot(
                self._raw_meter.weights(Spectrum.RAW)
            )
        for column, measure in self._frame_measures:
            values[:, column] = measure(frames)
        # The mel bank gets what is denoised and not yet normalised; it is normalised by its own peak, since a band is
        # a mean of bins and never as high as the highest of them.
        if self._denoises:
            spectra = spectrum.denoise(spectra, self._threshold)
        mel = self._mel_of(spectra) if self._mel_bands else None
        if self._normalises:
            # the peak before denoising is the peak after it, or all of the frame was below the threshold
            spectra = spectrum.normalise(spectra, peaks=values[:, MAX_ENERGY])
        values += spectra.dot(self._normalised)
        if self._mel_meter is not None and mel is not None:
            values += self._mel_meter.append_maxima(mel).dot(self._mel_meter.weights(Spectrum.MEL))
        if self._divided.size:
            # quotients come last, when their divisors have their final values; none is divided twice
            divided, divisors = self._divided
            values[:, divided] /= np.maximum(values[:, divisors], FAINTEST)
        return FrameBlock(frames, spectra[:, : self._n_bins], mel, waves, Features(self.names, values))

    def _mel_of(self, spectra: Float32Array) -> Float32Array:
        mel = mel_spectra_of(spectra[:, : self._n_bins], self._mel_bands, BIN_WIDTH)
        return spectrum.normalise(mel) if self._normalises else mel


class LevelFrontEnd:
    """The analysis of a block whose spectra and variables are not needed: its windows, and how loud each is."""

    names = ("volume",)

    def resume(self, _other: object) -> None:
        """Remember nothing: there is nothing to smooth."""

    def nothing(self) -> FrameBlock:
        """Return a block without frames."""
        return self.measure(np.zeros((0, WINDOW), np.float32))

    def measure(self, frames: Float32Array) -> FrameBlock:
        """Measure raw frames, shape (n, 2048)."""
        unseen = np.zeros((len(frames), 0), np.float32)
        return FrameBlock(frames, unseen, None, unseen, Features(self.names, peak_levels_of(frames)[:, np.newaxis]))


def shaper_of(settings: AnalysisSettings, scale: Float32Array) -> spectrum.FrequencyShaper:
    """Return what brings magnitudes to scale, shape (n_bins,), blurs them and applies the pass filters."""
    blur = settings.frequency_smooth if settings.has(Filter.FREQUENCY_SMOOTH) else 0.0
    return spectrum.FrequencyShaper(blur, _gains_of(settings), scale)


def _gains_of(settings: AnalysisSettings) -> Float32Array:
    gains = np.ones(settings.n_bins, np.float32)
    if settings.has(Filter.HIGH_PASS):
        gains *= spectrum.high_pass_gains(len(gains), BIN_WIDTH, settings.high_pass_start, settings.high_pass_end)
    if settings.has(Filter.LOW_PASS):
        gains *= spectrum.low_pass_gains(len(gains), BIN_WIDTH, settings.low_pass_start, settings.low_pass_end)
    return gains


def concatenate(blocks: list[FrameBlock]) -> FrameBlock:
    """Return consecutive blocks as one; there must be at least one."""
    mels = [b.mel for b in blocks if b.mel is not None]
    return FrameBlock(
        windows=np.concatenate([b.windows for b in blocks]),
        spectra=np.concatenate([b.spectra for b in blocks]),
        mel=np.concatenate(mels) if mels else None,
        waveforms=np.concatenate([b.waveforms for b in blocks]),
        features=Features(blocks[0].features.names, np.concatenate([b.features.values for b in blocks])),
    )


class LookAheadBuffer:
    """Holds measured frames until the recogniser has said what they are."""

    def __init__(self) -> None:
        self._blocks: deque[FrameBlock] = deque()

    def delay(self, block: FrameBlock, n: int) -> FrameBlock:
        """Take a block, and give the oldest `n` frames of all."""
        if len(block):
            self._blocks.append(block)
        taken = []
        while n > 0:
            oldest = self._blocks.popleft()
            if len(oldest) > n:
                self._blocks.appendleft(oldest.part(slice(n, None)))
                oldest = oldest.part(slice(n))
            taken.append(oldest)
            n -= len(oldest)
        return taken[0] if len(taken) == 1 else concatenate(taken) if taken else block.part(slice(0))

    def clear(self) -> FrameBlock | None:
        """Return all frames, and hold none; None where there are none."""
        taken, self._blocks = [*self._blocks], deque()
        return concatenate(taken) if taken else None


def why_unmeasured(name: str, settings: AnalysisSettings, mine: Iterable[Variable] = ()) -> str:
    """Return in a sentence why a variable reads 0 in every frame; empty where its range has bins or mel bands.

    Parameters
    ----------
    name : of a variable that is built in or one of `mine`.
    settings : the front end that measures it.
    mine : the user's own variables.
    """
    known = {v.name: v for v in (*BAND_VARIABLES, *ENERGY_VARIABLES, *mine)}
    variable = known.get(name)
    if variable is None:
        return ""
    end = settings.n_bins * BIN_WIDTH
    if variable.source is Spectrum.MEL:
        if not settings.has(Filter.MEL):
            return f"{name} reads 0, since the mel filter bank is off; switch Mel on."
        centres = mel_edges(settings.mel_bands, end)[1:-1]
    else:
        centres = np.arange(settings.n_bins, dtype=float) * BIN_WIDTH
    passed = settings.low_pass_end if settings.has(Filter.LOW_PASS) and variable.source is not Spectrum.RAW else end
    if passed <= variable.low < end:
        return (
            f"{name} reads 0, since it begins at {variable.low:.0f} Hz and the low-pass ends at {passed:.0f} Hz; "
            "raise the low-pass."
        )
    reach = reach_of(variable, centres)
    if reach.stop > reach.start:
        return why_unmeasured(variable.per, settings, mine) if variable.per in known else ""
    if variable.low >= end:
        return (
            f"{name} reads 0, since it begins at {variable.low:.0f} Hz and the spectrum ends at {end:.0f} Hz; "
            "quantise less."
        )
    return f"{name} reads 0, since no band lies within {variable.low:.0f} to {variable.high:.0f} Hz; widen its range."


MOST_VOICED = 100
"""Voiced frames over which the median is taken."""
LEAST_VOICED = 30
"""Voiced frames before the pitch of a voice is known."""
STAY = 2 ** (1 / 12)
"""A set stays while the pitch lies within its range widened by this factor at both ends, a semitone."""

PitchRange = tuple[float, float]
"""From which pitch, and up to which, Hz; the upper end does not belong to it."""


class PitchSetChooser:
    """Follows the pitch of a voice, and chooses the set in whose range it lies.

    Parameters
    ----------
    ranges : of the sets, in their order; of several that hold the pitch, the first is chosen.
    """

    def __init__(self, ranges: Sequence[PitchRange]) -> None:
        self._ranges = tuple(ranges)
        self._newest: deque[float] = deque()
        self._sorted: list[float] = []
        self._chosen = 0

    def choose(self, f0: Float32Array) -> Float32Array:
        """Return the pitch of the voice (Hz, 0 until it is known) and the number of the set, shape (n_frames, 2).

        Sets count from 1; 0 stands for none: the pitch is not known yet, or no range holds it.

        Parameters
        ----------
        f0 : the fundamental frequency of the next frames, Hz; 0 where there is none.
        """
        return np.array([self._follow(value) for value in f0.tolist()], np.float32).reshape(-1, 2)

    def _follow(self, f0: float) -> tuple[float, int]:
        if f0 > 0:
            self._newest.append(f0)
            insort(self._sorted, f0)  # kept in order: a median of each frame anew would sort a hundred each time
            if len(self._newest) > MOST_VOICED:
                del self._sorted[bisect_left(self._sorted, self._newest.popleft())]
        if len(self._sorted) < LEAST_VOICED:
            return 0.0, 0
        pitch = self._sorted[len(self._sorted) // 2]
        if not (self._chosen and self._holds(self._chosen, pitch, STAY)):
            numbers = range(1, len(self._ranges) + 1)
            self._chosen = next((k for k in numbers if self._holds(k, pitch)), 0)
        return pitch, self._chosen

    def _holds(self, number: int, pitch: float, widened: float = 1.0) -> bool:
        low, high = self._ranges[number - 1]
        return low / widened <= pitch < high * widened


class PitchSetFrontEnd:
    """The front ends of several sets as one, which measures each frame with the filters of the set that is chosen.

    Two more columns, `PITCH_SET_COLUMNS`, tell the pitch of the voice and the number of the set.

    Parameters
    ----------
    settings : where no set is chosen, and then those of each set; all give spectra of one size.
    ranges : of the sets.
    variables : the user's own variables.
    """

    def __init__(
        self, settings: Sequence[AnalysisSettings], ranges: Sequence[PitchRange], variables: tuple[Variable, ...]
    ) -> None:
        self._settings = tuple(settings)
        self._front_ends = {s: FrontEnd(s, variables, pitch=True) for s in dict.fromkeys(settings)}
        self._ranges = tuple(ranges)
        self._chooser = PitchSetChooser(ranges)
        self.names = (*self._front_ends[self._settings[0]].names, *PITCH_SET_COLUMNS)

    def nothing(self) -> FrameBlock:
        """Return a block without frames."""
        nothing = self._front_ends[self._settings[0]].nothing()
        return nothing.with_columns(PITCH_SET_COLUMNS, self._chooser.choose(nothing.features[PITCH.name]))

    def measure(self, frames: Float32Array) -> FrameBlock:
        """Measure raw frames, shape (n, 2048), at least one."""
        # all of them each time, since time smoothing needs the frames before, whichever set they were of
        measured = {s: front_end.measure(frames) for s, front_end in self._front_ends.items()}
        own = measured[self._settings[0]]
        chosen = self._chooser.choose(own.features[PITCH.name])
        for settings in list(measured)[1:]:
            numbers = [k for k, s in enumerate(self._settings) if s == settings]
            own = _joined(own, measured[settings], np.isin(chosen[:, 1], numbers)[:, np.newaxis])
        return own.with_columns(PITCH_SET_COLUMNS, chosen)

    def resume(self, other: object) -> None:
        """Have time smoothing and choice go on from where another front end stopped."""
        others = other._front_ends if isinstance(other, PitchSetFrontEnd) else {}
        for settings, front_end in self._front_ends.items():
            front_end.resume(others.get(settings, next(iter(others.values()), other)))
        if isinstance(other, PitchSetFrontEnd) and self._ranges == other._ranges:
            self._chooser = other._chooser


def _joined(one: FrameBlock, other: FrameBlock, from_other: BoolArray) -> FrameBlock:
    """Return the frames of one block, but those of another where `from_other` is true, shape (n_frames, 1)."""
    mel = None if one.mel is None or other.mel is None else np.where(from_other, other.mel, one.mel)
    values = np.where(from_other, other.features.values, one.features.values)
    return replace(
        one,
        spectra=np.where(from_other, other.spectra, one.spectra),
        mel=mel,
        features=Features(one.features.names, values),
    )


ROUNDING = 0.001
"""Samples by which a frame may begin before a column and still belong to it."""
AT_ONCE = 500
"""Frames that are filtered at a time."""


def filtered_sonagram_of(
    samples: Float32Array,
    settings: AnalysisSettings,
    layout: SonagramSettings,
    first: float,
    n_columns: int,
    period: float,
) -> Float32Array:
    """Return the levels of a section of sound after filters, dB of full scale, float32, shape (n_columns, n_rows).

    A column is the mean power of the frames that begin in it; where none does, the frame that began before it. Frames
    are 10 ms apart; what lies beyond the sound is silent, `FLOOR`.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz, beginning at a frame, with enough before the section for filters that
        remember.
    settings : the filters.
    layout : the rows; the window is that of the recogniser.
    first : the sample at which the first column begins.
    n_columns : how many.
    period : samples from one column to the next.
    """
    # It is filtered by the recogniser's own front end, so that what is seen is what was recognised.
    front_end, framer = FrontEnd(settings, (), pitch=False), Framer()
    power = np.zeros((n_columns + 1, layout.n_rows))  # the first one is what begins before the section
    counts = np.zeros(n_columns + 1)
    edges = first + np.arange(n_columns + 1) * period
    parts = (samples[k : k + AT_ONCE * HOP] for k in range(0, len(samples), AT_ONCE * HOP))
    n_frames = 0
    for frames in (*map(framer.cut_frames, parts), framer.finish()):
        if len(frames):
            block = front_end.measure(frames)
            spectra = block.spectra if block.mel is None else spread_mel(block.mel, block.spectra.shape[1], BIN_WIDTH)
            rows = np.square(spectra) @ _row_weights(spectra.shape[1], layout)
            starts = (n_frames + np.arange(len(rows))) * HOP + ROUNDING
            # Column 0 is what lies before the picture; frames that begin before it are remembered for the first
            # columns, which may be narrower than 10 ms and then hold no frame.
            columns = np.searchsorted(edges, starts, side="right")
            before, inside = starts < first, columns <= n_columns
            if before.any():
                power[0], counts[0] = rows[before][-1], 1
            np.add.at(power, columns[inside & ~before], rows[inside & ~before])
            np.add.at(counts, columns[inside & ~before], 1)
            n_frames += len(rows)
    power /= np.maximum(counts, 1)[:, np.newaxis]
    # each empty column shows the last one before it that has a frame
    nearest = np.maximum.accumulate(np.where(counts > 0, np.arange(n_columns + 1), 0))
    shown = power[nearest][1:]
    shown[edges[:-1] >= len(samples)] = 0
    return np.asarray(np.maximum(10 * np.log10(np.maximum(shown, 1e-30)), FLOOR), np.float32)


@lru_cache(maxsize=4)
def _row_weights(n_bins: int, layout: SonagramSettings) -> Float32Array:
    """Return what each bin gives to each row, shape (n_bins, n_rows): rows lie on straight lines between bins."""
    places = np.minimum(layout.frequencies / BIN_WIDTH, n_bins - 1.0)
    below = np.minimum(places.astype(int), n_bins - 2)
    share = (places - below).astype(np.float32)
    weights = np.zeros((n_bins, layout.n_rows), np.float32)
    rows = np.arange(layout.n_rows)
    weights[below, rows] = 1 - share
    weights[below + 1, rows] += share
    return weights
