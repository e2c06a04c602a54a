"""The workbench: loaded recordings and takes, measured in the background, asked at once."""

from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_count
from phonemeanalyser.desktop.session.courses import ThresholdLines
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.calibration.fits.suggestions import Suggestion, suggested_variables
from phonemeengine.calibration.scores.corpus import LabelledUtterance, read_recordings
from phonemeengine.calibration.scores.scoring import ConfusedSegment, Confusion
from phonemeengine.calibration.workbench import distributions
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import AudioError, EngineError, UnknownPhonemeError
from phonemeengine.execution import Progress, subrange
from phonemeengine.features.variables import DEFICITS, Variable
from phonemeengine.labels.phone_sets import PhonemeMap
from phonemeengine.phonemes import Phoneme

Pair = tuple[Phoneme, Phoneme | None]
ANSWER_MS = 16
"""After a change of the preset, until the answers are others: a threshold that is dragged changes all the time."""


class WorkbenchModel(QObject):
    """Measures what is loaded, and follows the preset: what a threshold changes is known a picture later.

    Attributes
    ----------
    measuring, looking, searching : the work on recordings, on distributions and rankings, and on suggestions.
    lines : the thresholds of each variable.
    answered : the recordings that `confusion` tells of; some of `utterances` may still be measured.

    Signals
    -------
    error : a sentence for the user.
    measured : another workbench is there, or none.
    confusion_changed : the answers are others.
    distribution_changed : the distribution of the chosen variable, or the ranking, is another.
    suggested : variables were found that are worth adding, or none.
    """

    error = Signal(str)
    measured = Signal()
    confusion_changed = Signal()
    distribution_changed = Signal()
    suggested = Signal()

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self.features: LabelledFeatures | None = None
        self.confusion: Confusion | None = None
        self.answered: tuple[LabelledUtterance, ...] = ()
        self.distribution: distributions.Distribution | None = None
        self.ranking: tuple[distributions.RankedVariable, ...] = ()
        self.suggestions: tuple[Suggestion, ...] = ()
        self.preview: Suggestion | None = None
        self.variable = "m_szsch1"
        self.lines = ThresholdLines(preset)
        self._preset = preset
        self._utterances: tuple[LabelledUtterance, ...] = ()
        self._left: LabelledFeatures | None = None  # with the preset before: A and B change places at once
        self._ranked_for: LabelledFeatures | None = None
        self._looked_with: Mapping[Phoneme, float] = {}
        self.measuring, self.looking, self.searching = (TaskQueue(self.error.emit) for _ in range(3))
        self._answering = QTimer(self, singleShot=True, interval=ANSWER_MS)
        self._answering.timeout.connect(self._answer)
        preset.changed.connect(self._follow_preset)

    # -- what there is ------------------------------------------------------------------------------------

    @property
    def utterances(self) -> tuple[LabelledUtterance, ...]:
        """The recordings that are measured, or are being."""
        return self._utterances

    @property
    def shown(self) -> distributions.Distribution | None:
        """The distribution of the suggestion that is looked at, or of the chosen variable."""
        return self.distribution if self.preview is None else self.preview.distribution

    @property
    def own_variables(self) -> tuple[Variable, ...]:
        """The user's own variables."""
        return self._preset.preset.variables

    @property
    def recogniser(self) -> str:
        """The name of the recogniser in use."""
        return self._preset.preset.recogniser

    def segments_in(self, truth: Phoneme, answer: Phoneme) -> list[ConfusedSegment]:
        """Return the segments of a cell of the confusion matrix, the longest first."""
        found = self.confusion.frames_in(truth, answer) if self.confusion else ()
        return sorted(found, key=lambda p: p.start - p.end)

    # -- what is asked ------------------------------------------------------------------------------------

    def load(self, utterances: tuple[LabelledUtterance, ...]) -> None:
        """Measure these recordings; what was measured before is not measured again."""
        self._utterances = utterances
        if not utterances:
            self.searching.cancel()
            self.suggestions, self.lines.suggested, self.preview = (), (), None
            self.suggested.emit()
        self._measure()

    def choose(self, variable: str) -> None:
        """Show the distribution of another variable."""
        self.variable, self.preview = variable, None
        self._look()

    def look_at(self, suggestion: Suggestion | None) -> None:
        """Show the distribution of a variable that is suggested, before it is added."""
        self.preview = suggestion
        self.distribution_changed.emit()

    def suggest(self, one: Phoneme, other: Phoneme | None) -> None:
        """Search for variables that part two phonemes, or one from all others."""
        features, preset = self.features, self._preset.in_force
        if features is None:
            self.error.emit(tr("There is no data to search. Record takes or load labelled recordings first."))
            return
        self.searching.replace(
            lambda progress: suggested_variables(features, preset, one, other, progress), self._take_suggestions
        )

    def close(self) -> None:
        """End all work."""
        self._answering.stop()
        for queue in (self.measuring, self.looking, self.searching):
            queue.close()

    def exchange(
        self, features: LabelledFeatures | None, confusion: Confusion | None
    ) -> tuple[LabelledFeatures | None, Confusion | None]:
        """Know what another preset measured and answered on all that is loaded; return what was known so far."""
        known = self.features, self.confusion
        if features is not None and features.utterances == self._utterances and not self.measuring.busy:
            self.features, self.confusion = features, confusion
        return known

    def look_anew(self) -> None:
        """Tell of what another preset measured, and rank and show its variables."""
        self.measured.emit()
        self._look()

    # -- the work -----------------------------------------------------------------------------------------

    def _follow_preset(self) -> None:
        if self.features is not None and self._must_measure():
            left = self._left
            if left is None or left.utterances != self._utterances or left.needs_measuring(self._preset.in_force):
                self._measure()
            else:
                self.measuring.cancel()
                self._take_up(left)
        elif self._others_sensitivities() != self._looked_with:
            self._look()
        self._answer_soon()

    def _must_measure(self) -> bool:
        try:
            return self.features is not None and self.features.needs_measuring(self._preset.in_force)
        except EngineError:
            return False

    def _measure(self) -> None:
        utterances, preset, known = self._utterances, self._preset.in_force, self.features
        if not utterances:
            self.measuring.cancel()
            self._take_up(None)
            return
        self.measuring.replace(
            lambda progress: LabelledFeatures(utterances, preset, known=known, progress=progress), self._take_up
        )

    def _take_up(self, features: LabelledFeatures | None) -> None:
        self.features, self._left = features, self.features
        if self.preview is not None and (features is None or self.preview.variable.name in features.variables):
            self.variable, self.preview = self.preview.variable.name, None
        self._answer_soon()
        self.measured.emit()
        self._look()

    def _answer_soon(self) -> None:
        if not self._answering.isActive():
            self._answering.start()

    def _answer(self) -> None:
        if self.features is None:
            self.confusion, self.answered = None, ()
        elif self._must_measure():
            return
        else:
            try:
                self.confusion = self.features.confusion(self._preset.in_force)
                self.answered = self.features.utterances
            except EngineError as error:
                self.error.emit(str(error))
                return
        self.confusion_changed.emit()

    def _look(self) -> None:
        features, variable = self.features, self.variable
        if features is None or not bool(np.any(features.labels.certain)):
            self.distribution, self.ranking = None, ()
            self.distribution_changed.emit()
            return
        if variable not in features.variables:
            variable = self.variable = features.variables[0]
        ranking = self.ranking if self._ranked_for is features else ()
        sensitivities = self._looked_with = self._others_sensitivities()
        self.looking.replace(
            lambda progress: _looked_at(features, variable, sensitivities, ranking, progress),
            lambda found: self._take_look(features, found),
        )

    def _others_sensitivities(self) -> Mapping[Phoneme, float]:
        """Return the sensitivities of which a deficit's distribution depends: those of the other phonemes."""
        if self.variable not in DEFICITS:
            return {}
        own = Phoneme(DEFICITS.index(self.variable))
        return {p: s for p, s in self._preset.in_force.sensitivities.items() if p is not own}

    def _take_look(
        self,
        features: LabelledFeatures,
        found: tuple[distributions.Distribution, tuple[distributions.RankedVariable, ...]],
    ) -> None:
        self.distribution, self.ranking = found
        self._ranked_for = features
        self.distribution_changed.emit()

    def _take_suggestions(self, suggestions: tuple[Suggestion, ...]) -> None:
        self.suggestions = suggestions
        self.lines.suggested = tuple(s.variable for s in suggestions)
        self.look_at(suggestions[0] if suggestions else None)
        self.suggested.emit()
        if not suggestions:
            self.error.emit(
                tr(
                    "No frequency range separates these two phonemes. Record more takes of them, or choose another "
                    "pair."
                )
            )


def _looked_at(
    features: LabelledFeatures,
    variable: str,
    sensitivities: Mapping[Phoneme, float],
    ranking: tuple[distributions.RankedVariable, ...],
    progress: Progress,
) -> tuple[distributions.Distribution, tuple[distributions.RankedVariable, ...]]:
    return distributions.distribution_of(
        features, variable, sensitivities
    ), ranking or distributions.ranked_variables(features, progress=progress)


Read = tuple[tuple[LabelledUtterance, ...], list[str]]
"""What was read, and the sentences about what could not be."""


class RecordingsModel(QObject):
    """Reads labelled recordings in the background.

    Signals
    -------
    changed : the recordings are others.
    progressed : more, or all, of what is loaded is read.
    unknown : names in the label files stand for no phoneme: how often each occurs, and what was to be read.
    info : a sentence for the user about something that went well.
    error : a sentence for the user.
    """

    changed = Signal()
    progressed = Signal()
    unknown = Signal(dict, list)
    info = Signal(str)
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.utterances: tuple[LabelledUtterance, ...] = ()
        self.sources: list[Path] = []
        self.mapping = PhonemeMap()
        self._reading = TaskQueue(self.error.emit)
        self._reading.changed.connect(self.progressed)

    @property
    def busy(self) -> bool:
        """Whether label files are being read."""
        return self._reading.busy

    @property
    def progress(self) -> float:
        """How much of what is being read is read, 0..1."""
        return self._reading.progress

    @property
    def n_speakers(self) -> int:
        """How many people speak in them."""
        return len({utterance.speaker for utterance in self.utterances})

    def load(self, sources: Sequence[Path]) -> None:
        """Read folders or sounds with their labels beside those that are there."""
        wanted = [path for path in sources if path not in self.sources]
        mapping = self.mapping
        self._reading.submit(
            lambda progress: _read(wanted, mapping, progress), lambda found: self._take_up(wanted, found)
        )

    def map(self, phonemes: dict[str, Phoneme], sources: Sequence[Path]) -> None:
        """Learn what names stand for, and read again what they stood in."""
        self.mapping = PhonemeMap({**self.mapping.phonemes, **phonemes})
        self.load(sources)

    def clear(self) -> None:
        """Forget all recordings; their files stay. While others are being read, forget only those."""
        if self.busy:
            self._reading.cancel()
            return
        self.utterances, self.sources = (), []
        self.changed.emit()

    def close(self) -> None:
        """End all reading."""
        self._reading.close()

    def add(self, utterances: Sequence[LabelledUtterance]) -> None:
        """Take recordings that were just made and labelled beside those that are there."""
        have = {utterance.path for utterance in self.utterances}
        fresh = tuple(u for u in utterances if u.path not in have)
        if fresh:
            self.utterances += fresh
            self.changed.emit()

    def _take_up(self, sources: list[Path], found: Read | dict[str, int]) -> None:
        if isinstance(found, dict):
            self.unknown.emit(found, sources)
            return
        utterances, refusals = found
        self.sources += sources
        have = {utterance.path for utterance in self.utterances}
        fresh = tuple(u for u in utterances if u.path not in have)
        self.utterances += fresh
        self.changed.emit()
        if refusals:
            self.error.emit(
                tr(
                    "1 audio file was skipped: {refusal}"
                    if len(refusals) == 1
                    else "{n} audio files were skipped. The first one: {refusal}"
                ).format(n=len(refusals), refusal=tr_engine(refusals[0]))
            )
        elif sources:
            self.info.emit(
                tr_count("1 labelled recording was loaded.", "{n} labelled recordings were loaded.", len(fresh))
            )


def _read(sources: Sequence[Path], mapping: PhonemeMap, progress: Progress) -> Read | dict[str, int]:
    """Read recordings; where names are unknown, give those of all of them."""
    utterances: list[LabelledUtterance] = []
    refusals: list[AudioError] = []
    unknown: dict[str, int] = {}
    for k, source in enumerate(sources):
        part = subrange(progress, k / len(sources), (k + 1) / len(sources))
        try:
            utterances += read_recordings(source, mapping, on_skipped=refusals.append, progress=part)
        except UnknownPhonemeError as error:
            unknown = dict(Counter(unknown) + Counter(error.counts))
    return unknown or (tuple(utterances), [str(refusal) for refusal in refusals])
