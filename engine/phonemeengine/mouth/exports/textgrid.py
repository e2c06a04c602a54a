"""Praat's TextGrid: a tier ``phonemes``, and a tier ``phones`` with the mouth shapes where they have other names."""

from collections.abc import Iterator

from phonemeengine.labels.label import Label
from phonemeengine.labels.textgrid import format_textgrid, owns
from phonemeengine.mouth.exports.export import Export

__all__ = ["owns", "write"]


def write(export: Export) -> Iterator[str]:
    """Write the cues in the long text format."""
    labels = [Label(cue.start, cue.end, cue.shape, cue.phoneme) for cue in export.cues]
    yield format_textgrid(labels, export.speech.duration)
