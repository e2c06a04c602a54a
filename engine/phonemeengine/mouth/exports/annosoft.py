"""Annosoft's .anno: a line ``phn start end strength phoneme`` for each phoneme, with times in milliseconds.

See ".anno file format" in the documentation of Annosoft's SAPI lipsync.
"""

from collections.abc import Iterator

from phonemeengine.mouth.exports.export import Export
from phonemeengine.phonemes import Phoneme


def write(export: Export) -> Iterator[str]:
    """Write the sound's name and a line for each phoneme; the strength is 0 for silence, else 1 to 100."""
    yield f"audio {export.speech.name}\n"
    for cue in export.drawings:
        strength = 0 if cue.phoneme == Phoneme.SILENCE else max(1, round(100 * cue.intensity))
        yield f"phn {round(1000 * cue.start)} {round(1000 * cue.end)} {strength} {cue.shape}\n"
