"""A text that a voice speaks: what has been said of it by now, and when."""

from collections import deque
from collections.abc import Iterator

from phonemeengine.labels.utterance import Utterance
from phonemeengine.performance.spoken_face import SpokenFace
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.spooled import KEPT, SentenceTrack, SpooledSpeech
from phonemeengine.speech.voice import SpokenSentence

ROUNDING = 1e-6
"""Seconds by which the end of a sentence and the start of the next one may differ."""


class RunningSpeech:
    """Follows speech that is still being made, and forgets what was heard long ago.

    Parameters
    ----------
    sentences : as a voice speaks them.
    face : looks them up meanwhile; None where nothing does.
    language : of the text.

    Attributes
    ----------
    face, language : what looks the text up, and its language.
    speech : the sound; whoever plays it closes it.
    utterance : what is said by now and not forgotten; None where nothing is known of it.
    """

    def __init__(self, sentences: Iterator[SpokenSentence], face: SpokenFace | None, language: str) -> None:
        self.face = face
        self.speech = SpooledSpeech(sentences)
        self.utterance: Utterance | None = None
        self.language = language
        self._tracks: deque[SentenceTrack] = deque()

    @property
    def text(self) -> str:
        """As it is written, what `utterance` holds."""
        return "".join(track.text for track in self._tracks)

    def follow(self, position: float) -> bool:
        """Take what was spoken meanwhile; says whether that is anything.

        Parameters
        ----------
        position : seconds of the sound that were heard.
        """
        n = len(self._tracks)
        while track := self.speech.track_at(self._tracks[-1].end + ROUNDING if self._tracks else 0.0):
            self._tracks.append(track)
        if len(self._tracks) == n:
            return False
        while self._tracks[0].end < position - KEPT / SAMPLE_RATE:
            self._tracks.popleft()
        words = tuple(word for track in self._tracks for word in track.words)
        self.utterance = Utterance(words, self._tracks[-1].end, self.language) if words else None
        return True
