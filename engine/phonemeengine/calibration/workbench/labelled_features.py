"""Labelled recordings, measured once, that answer at once when a threshold changes.

It holds no sound, only what was measured, so an hour takes some 30 MB. What a new threshold, rule, sensitivity,
successor, hold or hysteresis changes is worked out in milliseconds; another front end or another variable means
measuring anew, which takes seconds and is the caller's to do in the background::

    labelled = LabelledFeatures(utterances, preset, progress=progress)    # in the background
    confusion = labelled.confusion(edited)                     # at once, while a threshold is dragged
    if labelled.needs_measuring(edited):
        labelled = LabelledFeatures(utterances, edited, known=labelled, progress=progress)   # in the background
"""

from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, IndexArray, UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, frame_labels_of
from phonemeengine.calibration.scores.scoring import Confusion, confusion_between
from phonemeengine.calibration.workbench import retuner
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.features.variables import DEFICITS, Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import NO_SENSITIVITIES, Sensitivity, deficits_of

_Stamp = tuple[Path, int, int, int]
"""A sound file as it was measured: path, time of its last change, size, frames."""


class LabelledFeatures:
    """Holds labelled recordings in memory as measured variables.

    Making one takes as long as analysing the recordings that `known` has not measured yet; asking it takes
    milliseconds. One thread may ask it for answers at a time; another one takes a `clone_for_thread`.

    Parameters
    ----------
    utterances : the labelled recordings.
    preset : what they are measured with.
    known : older ones; what it measured in the same way is taken from there.
    progress : told how far the measuring is.

    Raises
    ------
    AudioError : a sound cannot be read.
    EngineError : the preset's recogniser cannot be used.
    Cancelled : `progress` did not want to go on.
    """

    def __init__(
        self,
        utterances: Sequence[LabelledUtterance],
        preset: Preset,
        *,
        known: "LabelledFeatures | None" = None,
        progress: Progress = no_progress,
    ) -> None:
        self._utterances = tuple(utterances)
        self._names = retuner.names_of(preset)
        self._front_end = retuner.front_end_key(preset)
        self._measured_with = None if retuner.rules_in(preset) is not None else retuner.recogniser_key(preset)
        labels = [frame_labels_of(u.labels) for u in self._utterances]
        lengths = [len(part.phonemes) for part in labels]
        self._edges = np.concatenate(([0], np.cumsum(lengths, dtype=np.intp))).astype(np.intp)
        self._labels = FrameLabels(
            _joined([p.phonemes for p in labels]),
            _joined([p.certain for p in labels], bool),
            _joined([p.visemes for p in labels]),
        )
        # of the files as they are before they are measured: one that changes meanwhile is measured again
        self._stamps = [_stamp_of(u.path, n) for u, n in zip(self._utterances, lengths, strict=True)]
        self._join(list(self._measure(preset, known, progress)))

    @property
    def utterances(self) -> tuple[LabelledUtterance, ...]:
        """The recordings."""
        return self._utterances

    @property
    def variables(self) -> tuple[str, ...]:
        """The names of what was measured; deficits follow where the recogniser weighs probabilities."""
        return self._names if self._scores is None else (*self._names, *DEFICITS)

    @property
    def labels(self) -> FrameLabels:
        """What is said in all recordings, one after the other."""
        return self._labels

    @property
    def edges(self) -> IndexArray:
        """The first frame of each recording, and the number of all frames; shape (n_recordings + 1,)."""
        return self._edges

    def values(self, variable: str, sensitivities: Mapping[Phoneme, float] = NO_SENSITIVITIES) -> Float32Array:
        """Return what was measured in all frames, shape (n_frames,).

        Parameters
        ----------
        variable : one of `variables`.
        sensitivities : of the other phonemes, where it is a phoneme's deficit; its own is left out.

        Raises
        ------
        CorpusError : it was not measured.
        """
        if self._scores is not None and variable in DEFICITS:
            phoneme = Phoneme(DEFICITS.index(variable))
            others = {p: s for p, s in sensitivities.items() if p is not phoneme}
            return deficits_of(Sensitivity(others).apply(self._scores.T), phoneme)
        if variable not in self._names:
            raise CorpusError(
                f"the variable {variable!r} was not measured in these recordings; add it to the preset and have them "
                "measured anew"
            )
        return np.asarray(self._values[self._names.index(variable)])

    def features(self) -> Features:
        """Return all that was measured, as a recogniser gets it."""
        return Features(self._names, self._values.T)

    def clone_for_thread(self) -> "LabelledFeatures":
        """Return the same measurements for another thread; takes no time and hardly any memory."""
        clone = copy(self)
        clone._retuner = self._new_retuner()
        return clone

    def needs_measuring(self, preset: Preset) -> bool:
        """Return whether a preset measures differently, so that the recordings must be measured anew.

        Thresholds, rules, sensitivities, successors, minimum duration and hysteresis need none. Another front end or
        other variables do, and a recogniser that works without rules, if the recordings were not measured with it.
        """
        if retuner.front_end_key(preset) != self._front_end:
            return True
        return retuner.rules_in(preset) is None and retuner.recogniser_key(preset) != self._measured_with

    def confusion(self, preset: Preset) -> Confusion:
        """Recognise all frames with a preset, and count the answers against the labels.

        Raises
        ------
        CorpusError : the recordings must be measured anew.
        """
        return confusion_between(self._labels, self.predict(preset), self._edges)

    def predict(self, preset: Preset) -> UInt8Array:
        """Recognise all frames with a preset: what the analyser says of the files, after the statistics.

        Raises
        ------
        CorpusError : the recordings must be measured anew.
        """
        if self.needs_measuring(preset):
            raise CorpusError("the recordings were measured with another front end; have them measured anew")
        codes = self._retuner.recognise(preset)[1]
        if len(self._beyond):
            codes = codes.copy()
            codes[self._beyond] = Phoneme.SILENCE
        return codes

    def _measure(
        self, preset: Preset, known: "LabelledFeatures | None", progress: Progress
    ) -> Iterator[retuner.Measurement]:
        """Measure what is not known yet."""
        report_progress(progress, 0.0)
        again = {} if known is None or known.needs_measuring(preset) else known.measured
        total = max(1, int(self._edges[-1]))
        for k, stamp in enumerate(self._stamps):
            first, end = self._edges[k : k + 2].tolist()
            share = subrange(progress, first / total, end / total)
            yield again.get(stamp) or retuner.measure(self._utterances[k].path, preset, end - first, share)
        report_progress(progress, 1.0)

    def _join(self, measurements: list[retuner.Measurement]) -> None:
        """Put all recordings side by side, so that each variable is one array."""
        n = int(self._edges[-1])
        self._values = np.zeros((len(self._names), n), np.float32)
        for m, first, end in zip(measurements, self._edges[:-1], self._edges[1:], strict=True):
            self._values[:, first:end] = m.values
        self._codes = _joined([m.recognised for m in measurements])
        scores = [m.scores for m in measurements if m.scores is not None]
        self._scores = np.concatenate(scores, axis=1) if scores and len(scores) == len(measurements) else None
        beyond = [
            np.arange(first + m.n_in_sound, end, dtype=np.intp)
            for m, first, end in zip(measurements, self._edges[:-1], self._edges[1:], strict=True)
        ]
        self._beyond = _joined(beyond, np.intp)
        self._n_in_sound = [m.n_in_sound for m in measurements]
        self._retuner = self._new_retuner()

    def _new_retuner(self) -> retuner.Retuner:
        return retuner.Retuner(
            dict(zip(self._names, self._values, strict=True)), self._codes, self._scores, self._edges
        )

    @property
    def measured(self) -> dict[_Stamp, retuner.Measurement]:
        """What was measured, by the file as it was then, for others."""
        spans = [slice(int(first), int(end)) for first, end in zip(self._edges[:-1], self._edges[1:], strict=True)]
        return {
            stamp: retuner.Measurement(
                self._values[:, span],
                n_in_sound,
                self._codes[span],
                None if self._scores is None else self._scores[:, span],
            )
            for stamp, span, n_in_sound in zip(self._stamps, spans, self._n_in_sound, strict=True)
        }


def _stamp_of(path: Path, n_frames: int) -> _Stamp:
    """Return what changes when a file is rewritten. A missing file is refused where it is read."""
    try:
        found = path.stat()
    except OSError:
        return path, 0, 0, n_frames
    return path, found.st_mtime_ns, found.st_size, n_frames


def _joined(parts: list[NDArray[Any]], dtype: type = np.uint8) -> NDArray[Any]:
    return np.concatenate([np.zeros(0, dtype), *parts])
