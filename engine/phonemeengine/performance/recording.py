"""A recorded performance: a face's weights over time, and what was said meanwhile."""

from dataclasses import dataclass

from phonemeengine.arrays import Float32Array

SILENCE = "sil"
"""The name of the phone before the first word, after the last one, and in pauses."""


@dataclass(frozen=True)
class PerformedPhone:
    """A phone of a performance, or of a sentence that is to be performed.

    Attributes
    ----------
    start, middle, end : seconds; its halves meet at `middle`.
    name : its symbol in the International Phonetic Alphabet, without length marks; `SILENCE` where nobody speaks.
    word : number of its word in the sentence; -1 for silence.
    syllable : number of its syllable in the sentence; -1 for silence.
    stress : of its syllable: 0 for none, 1 for the main one of its word, 2 for a secondary one.
    energy : mean level of the sound, dB beside full scale.
    pitch : median fundamental frequency, Hz; 0 where the phone is voiceless.
    """

    start: float
    middle: float
    end: float
    name: str
    word: int = -1
    syllable: int = -1
    stress: int = 0
    energy: float = 0.0
    pitch: float = 0.0

    @property
    def duration(self) -> float:
        """How long it lasts, seconds."""
        return self.end - self.start


@dataclass(frozen=True, eq=False)
class Performance:
    """One recording.

    Attributes
    ----------
    name : of its files, without endings.
    rate : frames a second; frame k shows the time k / rate of the sound.
    channels : the names of the columns; see `PLACES` of the table for what they move.
    weights : float32, shape (n_frames, n_channels): blend shapes 0..1, turns of the head in degrees.
    phones : in order of time, without gaps; the first and the last are silence.
    words : the texts of the words, by number.
    synthetic : whether no person, but a model of one moved.
    """

    name: str
    rate: float
    channels: tuple[str, ...]
    weights: Float32Array
    phones: tuple[PerformedPhone, ...]
    words: tuple[str, ...] = ()
    synthetic: bool = False
