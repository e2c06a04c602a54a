"""Which pitch set of a preset is in use at a frame, and why, in words."""

from collections.abc import Mapping

from phonemeanalyser.desktop.language import tr
from phonemeengine.features.variables import PITCH_SET_COLUMNS
from phonemeengine.presets.preset import Preset


def pitch_set_name(preset: Preset, values: Mapping[str, float]) -> str:
    """Return the name of the set that a frame was recognised with; empty where it was with the preset's own numbers.

    `values` are the variables of the frame.
    """
    number = int(values.get(PITCH_SET_COLUMNS[1], 0))
    return preset.pitch_sets[number - 1].name if 0 < number <= len(preset.pitch_sets) else ""


def pitch_set_in_words(preset: Preset, values: Mapping[str, float]) -> str:
    """Return which numbers of PhonemeData a frame was recognised with, and why; empty where there are no sets."""
    if not preset.pitch_ranges:
        return ""
    pitch, name = values.get(PITCH_SET_COLUMNS[0], 0), pitch_set_name(preset, values)
    if not pitch > 0:
        return tr("In use: the preset's own numbers, until the pitch of the voice is known.")
    if not name:
        words = tr("In use: the preset's own numbers, since no pitch set has {pitch:.0f} Hz, the pitch of the voice.")
        return words.format(pitch=pitch)
    found = preset.pitch_sets[int(values[PITCH_SET_COLUMNS[1]]) - 1]
    return tr(
        "In use: {name} ({low:.0f}–{high:.0f} Hz), since the pitch of the voice is {pitch:.0f} Hz, the median of its "
        "last second."
    ).format(name=name, pitch=pitch, low=found.low, high=found.high)
