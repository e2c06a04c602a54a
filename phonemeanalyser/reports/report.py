"""A report: one or two presets on the same recordings, and how figures are named and written in all formats."""

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float64Array, Int64Array
from phonemeengine.calibration.scores.added_noise import AddedNoise
from phonemeengine.calibration.scores.comparison import PresetComparison
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import CorpusScores, GroupScores
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import rule_lines, rules_of
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.storage.files import printable, printable_name

CLASSES = (*SCORED_PHONEMES, Phoneme.UNIDENTIFIED)
"""The order in which phonemes are listed."""


@dataclass(frozen=True)
class ScoredPreset:
    """A preset under the title that tells it from the other one, and its scores."""

    title: str
    scores: CorpusScores

    @property
    def rules(self) -> list[str]:
        """The preset's rules, a line for each condition; none where it has no rules."""
        preset = self.scores.preset
        return rule_lines(preset) if rules_of(preset) else []


@dataclass(frozen=True)
class Report:
    """What is to be told.

    Attributes
    ----------
    folder : of the recordings.
    presets : one, or two that are compared.
    comparison : of the two.
    noise : what was added to the recordings.
    left_out : a sentence for each recording that could not be scored.
    """

    folder: Path
    presets: tuple[ScoredPreset, ...]
    comparison: PresetComparison | None = None
    noise: AddedNoise | None = None
    left_out: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The name of the corpus."""
        return printable_name(self.folder.absolute())

    @property
    def first(self) -> CorpusScores:
        """The scores of the first preset."""
        return self.presets[0].scores

    @property
    def conditions(self) -> str:
        """What was analysed under which conditions, in words."""
        minutes = self.first.overall.scores.minutes
        words = [counted(len(self.first.predictions), "recording"), f"{minutes:.1f} minutes"]
        words.append(counted(len(self.first.by_speaker), "speaker"))
        words.append(f"lag {1000 * self.first.delay:g} ms")
        if self.noise is not None:
            words.append(f"{self.noise.kind} noise {self.noise.snr:g} dB below the speech (seed {self.noise.seed})")
        return ", ".join(words)

    def name_of(self, utterance: LabelledUtterance) -> str:
        """Return the place of a recording in the corpus."""
        path = utterance.path
        return printable(path.relative_to(self.folder).as_posix() if path.is_relative_to(self.folder) else path.name)


@dataclass(frozen=True)
class ReportedFigure:
    """A figure of agreement: its field in `Scores`, what people call it and read in it; `better` is -1 for less."""

    field: str
    title: str
    meaning: str
    better: int = 1


FIGURES = (
    ReportedFigure("macro_f1", "Macro F1", "mean F1 of the ten classes"),
    ReportedFigure("accuracy", "Right", "share of frames right, of those labelled as one of the ten classes"),
    ReportedFigure("vowel_accuracy", "Clear vowels", "share right of the frames labelled as a clear a, e, i, o or u"),
    ReportedFigure("viseme_accuracy", "Mouth shapes", "share of all frames with the right one of six mouth shapes"),
    ReportedFigure("fine_viseme_accuracy", "15 visemes", "share right of frames whose label is one certain viseme"),
    ReportedFigure("viseme_f1", "Mouth F1", "mean F1 of the six mouth shapes"),
    ReportedFigure("silence_recall", "Silence found", "share of silent frames called silence"),
    ReportedFigure("false_silence", "False silence", "share of spoken frames called silence: less is better", -1),
)
"""The shares, all 0..1."""


def flicker_of(group: GroupScores) -> float:
    """Return how often the answer changes for each change of the labels; NaN where these never change."""
    return group.changes / group.label_changes if group.label_changes else math.nan


def look_ahead_of(scores: CorpusScores) -> str:
    """Return how long the recogniser waits, in words."""
    return f"{1000 * scores.look_ahead * FRAME_PERIOD:g} ms"


def confusion_shares(confusion: Int64Array) -> Float64Array:
    """Return what share of each label's frames got which answer, labels and answers in the order of `CLASSES`."""
    ordered = confusion[np.ix_(CLASSES, CLASSES)]
    return np.asarray(ordered / np.maximum(1, ordered.sum(axis=1, keepdims=True)))


def short(phoneme: Phoneme) -> str:
    """Return a name that fits over a narrow column."""
    return "other" if phoneme is Phoneme.UNIDENTIFIED else phoneme.label


def counted(n: int, noun: str) -> str:
    """Return a number of things in words."""
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"


def written(value: float, digits: int = 3) -> str:
    """Write a figure; a dash stands where there was nothing to count."""
    return "–" if math.isnan(value) else f"{value:.{digits}f}"


def signed(value: float) -> str:
    """Write a difference in whole numbers with its sign, and none where there is no difference."""
    return f"{value:+.0f}".replace("-", "−") if round(value) else "0"


def clock(seconds: float) -> str:
    """Write a place in a recording as minutes and seconds."""
    hundredths = round(100 * seconds)
    return f"{hundredths // 6000}:{hundredths // 100 % 60:02d}.{hundredths % 100:02d}"
