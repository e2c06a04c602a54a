"""Audacity's label track: each mouth shape and, in double quotes, each known word, with start and end."""

from collections.abc import Iterator

from phonemeengine.labels.audacity import format_track
from phonemeengine.mouth.exports.export import Export


def write(export: Export) -> Iterator[str]:
    """Return a line for each drawing and each word, in order of time."""
    yield format_track(((cue.start, cue.end, cue.shape) for cue in export.drawings), export.speech.words)
