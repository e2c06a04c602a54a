"""Annosoft's .anno: a line ``phn start end strength phoneme`` for each phoneme, with times in milliseconds.

Where the words are known, ``word start end text`` stands before the first phoneme that begins in it.

See ".anno file format" in the documentation of Annosoft's SAPI lipsync.
"""

from collections import deque
from collections.abc import Iterator

from phonemeengine.mouth.exports.export import Export, frame_of, one_token
from phonemeengine.phonemes import Phoneme

STEPS = 1000
"""Times that a second has."""


def write(export: Export) -> Iterator[str]:
    """Write the sound's name, a line for each word, and one for each phoneme.

    The strength of a phoneme is 0 for silence, else 1 to 100.
    """
    yield f"audio {export.speech.name}\n"
    words = deque(export.speech.words)
    for cue in export.drawings:
        while words and words[0].start < cue.end:
            word = words.popleft()
            yield f"word {frame_of(word.start, STEPS)} {frame_of(word.end, STEPS)} {one_token(word.text)}\n"
        strength = 0 if cue.phoneme == Phoneme.SILENCE else max(1, round(100 * cue.intensity))
        yield f"phn {frame_of(cue.start, STEPS)} {frame_of(cue.end, STEPS)} {strength} {cue.shape}\n"
