"""Figures of agreement in words: what each is called and means, and how its value is written."""

import math

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import Theme
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES, Agreement

FIGURES: tuple[tuple[str, str, bool, str], ...] = (
    (
        tr_noop("Macro F1"),
        "macro_f1",
        True,
        tr_noop("Mean of the F1 scores of the ten phonemes: rare ones count as much as frequent ones"),
    ),
    (tr_noop("Accuracy"), "accuracy", True, tr_noop("Share of frames of the ten phonemes recognised correctly")),
    (
        tr_noop("Vowels"),
        "vowel_accuracy",
        True,
        tr_noop("Share of clear a, e, i, o and u frames recognised correctly"),
    ),
    (
        tr_noop("Mouth shapes"),
        "viseme_accuracy",
        True,
        tr_noop("Share of frames with the correct one of six mouth shapes"),
    ),
    (tr_noop("Silence recall"), "silence_recall", True, tr_noop("Share of silent frames recognised as silence")),
    (tr_noop("False silence"), "false_silence", False, tr_noop("Share of speech frames recognised as silence")),
    (
        tr_noop("Changes/s"),
        "changes_per_s",
        False,
        tr_noop("How often the recognised phoneme changes; more often than the labels do is flicker"),
    ),
)
"""Heading, name of the figure, whether more is better, and what it means."""

LEAST_GAIN = 5e-4
"""A difference that is smaller counts as none: figures are written with one digit more than percent."""
MOST_FLICKER = 1.5
"""How many times as often as the labels an answer may change: more is flicker."""


def figure_in_words(name: str, value: float) -> str:
    """Write a figure: shares in percent, rates as they are."""
    if math.isnan(value):
        return "–"
    return f"{value:.1f}" if name.endswith("per_s") else f"{value:.1%}"


def colour_of_gain(gain: float, theme: Theme) -> str:
    """Return the colour of what is better (a gain above 0), worse or the same."""
    return theme.good if gain > LEAST_GAIN else theme.bad if gain < -LEAST_GAIN else theme.text


def colour_of_changes(agreement: Agreement, theme: Theme) -> str:
    """Return the colour of the changes a second: bad where they are far more than those of the labels."""
    flickers = agreement.changes_per_s > MOST_FLICKER * agreement.label_changes_per_s
    return theme.bad if flickers else theme.good


def classes_in_words(agreement: Agreement) -> str:
    """Say of which phonemes macro F1 is where the labels do not hold all ten; else nothing."""
    classes = agreement.classes
    if len(classes) == len(SCORED_PHONEMES):
        return ""
    names = ", ".join(sound_name(phoneme) for phoneme in classes)
    return tr("The labels hold {n} of the 10 phonemes, and macro F1 is of these: {names}.").format(
        n=len(classes), names=names
    )
