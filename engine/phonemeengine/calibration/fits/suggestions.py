"""Variables that are worth adding: the frequency ranges that part a pair of phonemes best.

Thousands of ranges are tried, of the filtered and of the normalised spectrum, for sums and for maxima (a mean parts
exactly as well as the sum of the same range). The sums of all ranges that begin at a frequency come from one running
sum, their maxima from one running maximum. How well a range parts two phonemes is their separation, as
`phonemeengine.calibration.workbench.distributions` defines it, over some frames of each.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import Float32Array, IndexArray, UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, frame_labels_of
from phonemeengine.calibration.workbench import distributions
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.dsp.mel import mel_edges
from phonemeengine.dsp.spectrum import denoise, normalise
from phonemeengine.errors import CorpusError, SettingsError
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.features.variables import Kind, Spectrum, Variable, check_user_variables
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, AnalysisSettings, Filter

# Spectra of some frames of each phoneme, from which new variables are made.

MOST_FRAMES = 1500
"""Frames that are looked at of each phoneme, evenly spread over all that there are."""

_LATE_FILTERS = frozenset({Filter.DENOISE, Filter.NORMALISE, Filter.MEL})
"""What comes after the spectrum that variables call filtered."""


@dataclass(frozen=True, eq=False)
class SpectrumSample:
    """The spectra of some certain frames, evenly spread over the recordings.

    Attributes
    ----------
    phonemes : codes of `Phoneme`, shape (n_frames,).
    spectra : by what variables call them (filtered, normalised), float32, shape (n_frames, n_bins).
    """

    phonemes: UInt8Array
    spectra: dict[Spectrum, Float32Array]

    def of(self, source: Spectrum, phonemes: Sequence[Phoneme]) -> Float32Array:
        """Return the spectra of one kind of the frames of some phonemes."""
        return self.spectra[source][np.isin(self.phonemes, phonemes)]


def sampled_spectra(
    utterances: Sequence[LabelledUtterance], preset: Preset, progress: Progress = no_progress
) -> SpectrumSample:
    """Analyse recordings, and keep the spectra of at most 1500 certain frames of each phoneme.

    Raises
    ------
    AudioError : a sound cannot be read.
    Cancelled : `progress` did not want to go on.
    """
    labels = [frame_labels_of(u.labels) for u in utterances]
    settings = preset.settings
    early = replace(settings, filters=settings.filters - _LATE_FILTERS, statistics=False)
    parts = [np.zeros((0, settings.n_bins), np.float32)]
    codes = [np.zeros(0, np.uint8)]
    for k, (utterance, label, wanted) in enumerate(zip(utterances, labels, _wanted(labels), strict=True)):
        report_progress(progress, k / len(utterances))
        if len(wanted):
            share = subrange(progress, k / len(utterances), (k + 1) / len(utterances))
            spectra = _spectra_at(utterance, wanted, early, share)
            parts.append(spectra)
            codes.append(label.phonemes[wanted[: len(spectra)]])
    report_progress(progress, 1.0)
    filtered = np.concatenate(parts)
    return SpectrumSample(
        np.concatenate(codes), {Spectrum.FILTERED: filtered, Spectrum.NORMALISED: _finished(filtered, settings)}
    )


def _wanted(labels: Sequence[FrameLabels]) -> list[IndexArray]:
    """Choose every n-th frame of each phoneme in each recording."""
    lengths = [len(part.phonemes) for part in labels]
    phonemes = np.concatenate([np.zeros(0, np.uint8), *(part.phonemes for part in labels)])
    certain = np.concatenate([np.zeros(0, bool), *(part.certain for part in labels)])
    chosen = np.zeros(len(phonemes), bool)
    for phoneme in Phoneme:
        frames = np.flatnonzero(certain & (phonemes == phoneme))
        chosen[frames[:: max(1, -(-len(frames) // MOST_FRAMES))]] = True
    return [np.flatnonzero(part) for part in np.split(chosen, np.cumsum(lengths)[:-1])]


def _spectra_at(
    utterance: LabelledUtterance, wanted: IndexArray, settings: AnalysisSettings, progress: Progress
) -> Float32Array:
    """Return the filtered spectra of those of the wanted frames that the sound has."""
    found = []
    with utterance.opened() as reader:
        for analysis in analyse_file(reader, Preset(settings=settings)):
            report_progress(progress, min(1.0, analysis.start / max(1, int(wanted[-1]))))
            first, end = np.searchsorted(wanted, (analysis.start, analysis.start + len(analysis)))
            found.append(analysis.spectra[wanted[first:end] - analysis.start])
    return np.concatenate([np.zeros((0, settings.n_bins), np.float32), *found])


def _finished(filtered: Float32Array, settings: AnalysisSettings) -> Float32Array:
    """Send filtered spectra through the filters that follow."""
    finished = filtered
    if settings.has(Filter.DENOISE) and settings.denoise_threshold > 0:
        finished = denoise(finished, np.array(settings.denoise_threshold, np.float32))
    return normalise(finished) if settings.has(Filter.NORMALISE) else finished


N_EDGES = 44
"""Frequencies between which ranges are tried, equally spaced in mel."""
MOST_SUGGESTIONS = 8
LEAST_SEPARATION = 0.55
"""A variable that parts no better is not worth a suggestion."""
MOST_OF_A_SIDE = 3000
"""Frames that are compared of each side."""


@dataclass(frozen=True)
class Suggestion:
    """A variable that is worth adding.

    Attributes
    ----------
    variable : the variable, whose name is still free.
    separation : how well it parts what was asked for, 0.5..1.
    threshold : where it parts them best.
    distribution : how it is spread over each phoneme, in the frames that were looked at.
    """

    variable: Variable
    separation: float
    threshold: float
    distribution: distributions.Distribution


@dataclass(frozen=True)
class _Range:
    """A range that was tried: bins first..end-1 of a spectrum."""

    separation: float
    source: Spectrum
    kind: Kind
    first: int
    end: int

    def overlaps(self, other: "_Range") -> bool:
        return self.first < other.end and other.first < self.end

    def measured(self, spectra: Float32Array) -> Float32Array:
        inside = spectra[:, self.first : self.end]
        return np.asarray(inside.sum(axis=1) if self.kind is Kind.SUM else inside.max(axis=1), np.float32)


def suggested_variables(
    labelled: LabelledFeatures,
    preset: Preset,
    one: Phoneme,
    other: Phoneme | None = None,
    progress: Progress = no_progress,
) -> tuple[Suggestion, ...]:
    """Search for the variables that part one phoneme best from another, or from all other ones.

    Those come first whose ranges do not overlap with better ones, the best before the others. The recordings are
    analysed for it, which takes longer than the search.

    Parameters
    ----------
    labelled : the recordings.
    preset : the front end, and the variables that there are already.
    one : the phoneme.
    other : the phoneme to part it from; None for all other ones of the ten.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    CorpusError : one of the phonemes has no certain frames in the recordings.
    AudioError : a sound cannot be read any more.
    Cancelled : `progress` did not want to go on.
    """
    sample = sampled_spectra(labelled.utterances, preset, subrange(progress, 0.0, 0.5))
    return suggestions_from(sample, preset, one, other, subrange(progress, 0.5, 1.0))


def suggestions_from(
    sample: SpectrumSample,
    preset: Preset,
    one: Phoneme,
    other: Phoneme | None = None,
    progress: Progress = no_progress,
) -> tuple[Suggestion, ...]:
    """Search as `suggested_variables` does, in spectra that are at hand."""
    sides = _sides_of(sample, one, other)
    edges = _edges_of(preset)
    sources = list(sides)
    tried: list[_Range] = []
    for k, source in enumerate(sources):
        for share, found in _tried(source, *sides[source], edges):
            report_progress(progress, (k + share) / len(sources))
            tried += found
    worthy = sorted((r for r in tried if r.separation >= LEAST_SEPARATION), key=_rank_of)
    suggestions: list[Suggestion] = []
    for best in _apart_first(worthy)[:MOST_SUGGESTIONS]:
        name = _free_name(best, preset, [s.variable for s in suggestions], one, other)
        own, others = (best.measured(side) for side in sides[best.source])
        variable = Variable(name, *_hertz(best), best.kind, best.source)
        threshold = float(f"{distributions.best_threshold(own, others):.4g}")
        spread = distributions.distribution_in(name, best.measured(sample.spectra[best.source]), sample.phonemes)
        suggestions.append(Suggestion(variable, best.separation, threshold, spread))
    return tuple(suggestions)


def _rank_of(tried: _Range) -> tuple[float, int]:
    """Put the best first, and of equally good ones the narrowest."""
    return -round(tried.separation, 4), tried.end - tried.first


def _sides_of(
    sample: SpectrumSample, one: Phoneme, other: Phoneme | None
) -> dict[Spectrum, tuple[Float32Array, Float32Array]]:
    """Return the frames of both sides, by spectrum."""
    spoken = [p for p in Phoneme if p not in {one, Phoneme.UNIDENTIFIED}]
    others = spoken if other is None else [other]
    sides = {source: (_some(sample.of(source, [one])), _some(sample.of(source, others))) for source in sample.spectra}
    for side, names in zip(next(iter(sides.values())), ([one], others), strict=True):
        if not len(side):
            phonemes = ", ".join(p.label for p in names)
            raise CorpusError(f"nothing that is loaded is clearly labelled {phonemes}; load recordings that have it")
    filtered, normalised = sides[Spectrum.FILTERED][0], sides[Spectrum.NORMALISED][0]
    if np.array_equal(filtered, normalised):
        del sides[Spectrum.FILTERED]
    return sides


def _some(spectra: Float32Array) -> Float32Array:
    return spectra[:: max(1, -(-len(spectra) // MOST_OF_A_SIDE))]


def _edges_of(preset: Preset) -> list[int]:
    """Return the bins at which ranges begin and end."""
    n_bins = preset.settings.n_bins
    edges = mel_edges(N_EDGES - 1, n_bins * BIN_WIDTH)
    bins = np.unique(np.clip(np.round(edges / BIN_WIDTH), 1, n_bins))
    return [int(edge) for edge in bins]


def _tried(
    source: Spectrum, own: Float32Array, others: Float32Array, edges: list[int]
) -> Iterator[tuple[float, list[_Range]]]:
    """Try all ranges, first edge by first edge; with each the share of the work that is done."""
    sums = [_cells(np.add, side, edges) for side in (own, others)]
    maxima = [_cells(np.maximum, side, edges) for side in (own, others)]
    for k, first in enumerate(edges[:-1]):
        found = []
        for kind, cells, run in ((Kind.SUM, sums, np.add), (Kind.MAX, maxima, np.maximum)):
            mine, theirs = (run.accumulate(side[k:], axis=0) for side in cells)
            found += [
                _Range(distributions.separability(a, b), source, kind, first, end)
                for a, b, end in zip(mine, theirs, edges[k + 1 :], strict=True)
            ]
        yield (k + 1) / len(edges), found


def _cells(run: np.ufunc, spectra: Float32Array, edges: list[int]) -> Float32Array:
    """Sum spectra up between neighbouring edges, or give their maxima there; shape (n_cells, n_frames)."""
    cells = run.reduceat(spectra[:, : edges[-1]], edges[:-1], axis=1)
    return np.ascontiguousarray(cells.T)


def _apart_first(ranges: Sequence[_Range]) -> list[_Range]:
    """Put those first that overlap with none before them."""
    apart: list[_Range] = []
    for found in ranges:
        if len(apart) == MOST_SUGGESTIONS:
            break
        if not any(found.overlaps(other) for other in apart):
            apart.append(found)
    return [*apart, *(found for found in ranges[: 2 * MOST_SUGGESTIONS] if found not in apart)]


def _hertz(found: _Range) -> tuple[float, float]:
    """Return a range in whole Hz, half a bin beyond its outermost bins."""
    low, high = (found.first - 0.5) * BIN_WIDTH, (found.end - 0.5) * BIN_WIDTH
    return float(round(low)), float(round(high))


def _free_name(
    found: _Range, preset: Preset, suggested: Sequence[Variable], one: Phoneme, other: Phoneme | None
) -> str:
    low, high = _hertz(found)
    kind = "_max" if found.kind is Kind.MAX else ""
    stem = f"{one.label}_{other.label if other is not None else 'rest'}_{low:.0f}_{high:.0f}{kind}"
    name, number = stem, 1
    while True:
        try:
            check_user_variables((*preset.variables, *suggested, Variable(name, low, high)))
        except SettingsError:
            number += 1
            name = f"{stem}_{number}"
        else:
            return name
