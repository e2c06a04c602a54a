"""Praat's TextGrid, as everything that writes one here has it.

Where the words are known it has the tiers ``words``, ``syllables``, ``phones`` and ``phonemes``, whose times are
those of the sound; else a tier ``phonemes`` of cues. Mouth shapes that have names of their own are in a tier
``mouth``, without words in ``phones``.
"""

from collections.abc import Iterator

from phonemeengine.labels.textgrid import format_textgrid, owns
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.mouth.exports.export import Export

__all__ = ["owns", "write"]

MOUTH = "mouth"
"""The name of the tier of mouth shapes beside words."""


def write(export: Export) -> Iterator[str]:
    """Return the text of the file, in the long format."""
    if export.speech.utterance is not None:
        shapes = [(cue.start, cue.end, cue.shape) for cue in export.drawings]
        named = any(cue.shape != cue.phoneme.label for cue in export.drawings)
        yield format_utterance(export.speech.utterance, more={MOUTH: shapes} if named else None)
        return
    labels = [Label(cue.start, cue.end, cue.shape, cue.phoneme) for cue in export.cues]
    yield format_textgrid(labels, export.speech.duration)
