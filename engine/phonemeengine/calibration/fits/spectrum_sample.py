"""Spectra of some frames of each phoneme, from which new variables are made."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import Float32Array, IndexArray, UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, frame_labels_of
from phonemeengine.dsp.filters import denoise, normalise
from phonemeengine.features.variables import Spectrum
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Progress, no_progress, report_progress, subrange
from phonemeengine.settings import AnalysisSettings, Filter

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
    """Choose the frames of each recording: of each phoneme every so many one."""
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
