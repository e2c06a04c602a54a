"""Speech that plays while it is still being made: a sound that grows on the disk, and can be played at once.

One thread speaks, sentence by sentence, and stays a while ahead of what is read; who reads waits only where nothing
is there yet. What is said is known before its sound can be read, and is forgotten some time after it was.
"""

import logging
import tempfile
import threading
from bisect import bisect_right
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from typing_extensions import override

from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.waveform_peaks import WaveformPeaks
from phonemeengine.execution import Closing
from phonemeengine.labels.utterance import Word, shifted
from phonemeengine.settings import SAMPLE_RATE, Channel
from phonemeengine.speech.voice import SpokenSentence

AHEAD = 30 * SAMPLE_RATE
"""Samples that are spoken before they are read, at most by a sentence more."""
KEPT = 60 * SAMPLE_RATE
"""Samples after which it is forgotten what was said; the sound itself stays."""
_WIDTH = np.dtype(np.float32).itemsize

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class SentenceTrack:
    """What is said in a section of spooled speech.

    Attributes
    ----------
    start, end : seconds from the beginning of the sound.
    text : as it is written.
    words : with their times in the sound.
    """

    start: float
    end: float
    text: str
    words: tuple[Word, ...]


class SpooledSpeech(Closing):
    """A sound, mono at 44.1 kHz, of sentences that are being spoken; see `Reader`.

    Parameters
    ----------
    sentences : as they come, such as from `Voice.speak`; a thread of its own asks for them.

    Attributes
    ----------
    n_samples : what is spoken so far.
    position : the next sample that `read` gives.
    peaks : the outline of what is spoken so far.
    """

    channel = Channel.MIX
    n_channels = 1

    def __init__(self, sentences: Iterable[SpokenSentence]) -> None:
        self.n_samples = self.position = 0
        self.peaks = WaveformPeaks()
        self._file = tempfile.TemporaryFile()  # noqa: SIM115 - `close` lets it go
        self._tracks: deque[SentenceTrack] = deque()
        self._changed = threading.Condition()
        self._ended = self._closing = False
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._spool, args=(sentences,), name="speech", daemon=True)
        self._thread.start()

    @property
    def duration(self) -> float:
        """Length of what is spoken so far, seconds."""
        return self.n_samples / SAMPLE_RATE

    def read(self, n: int) -> Float32Array:
        """Return the next samples, shape (m, 1), as soon as they are spoken; fewer than `n` only at the end.

        Raises
        ------
        EngineError : what the speech has failed of, once all before it was read.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._is_there(n))
            n = max(0, min(n, self.n_samples - self.position))
            if n == 0 and self._error is not None and not self._closing:
                raise self._error
            block = self._at(self.position, n)
            self.position += n
            self._forget()
            self._changed.notify_all()
        return block

    def mono(self, block: Float32Array) -> Float32Array:
        """Return the one channel of a block, shape (n,)."""
        return block[:, 0]

    def seek(self, sample: int) -> None:
        """Go to a sample; beyond what is spoken so far means its end."""
        with self._changed:
            self.position = min(max(sample, 0), self.n_samples)
            self._changed.notify_all()

    def track_at(self, seconds: float) -> SentenceTrack | None:
        """Return what is said at a time; None where nothing is spoken yet, or that is forgotten."""
        with self._changed:
            k = bisect_right(self._tracks, seconds, key=lambda track: track.start) - 1
            track = self._tracks[k] if k >= 0 else None
        return track if track is not None and seconds < track.end else None

    @override
    def close(self) -> None:
        """Speak no more, and let the sound go."""
        with self._changed:
            self._closing = True
            self._changed.notify_all()
        self._thread.join()
        self._file.close()

    def _is_there(self, n: int) -> bool:
        return self._ended or self._closing or self.n_samples - self.position >= n

    def _at(self, sample: int, n: int) -> Float32Array:
        if self._closing:
            return np.zeros((0, 1), np.float32)
        self._file.seek(sample * _WIDTH)
        return np.frombuffer(self._file.read(n * _WIDTH), np.float32)[:, np.newaxis]

    def _forget(self) -> None:
        while self._tracks and self._tracks[0].end * SAMPLE_RATE < self.position - KEPT:
            self._tracks.popleft()

    def _spool(self, sentences: Iterable[SpokenSentence]) -> None:
        try:
            for sentence in sentences:
                if not self._add(sentence):
                    return
        except Exception as error:  # noqa: BLE001 - `read` raises it where it is seen
            self._error = error
            _log.warning("speaking has stopped: %s", error)
        finally:
            with self._changed:
                self._ended = True
                self._changed.notify_all()

    def _add(self, sentence: SpokenSentence) -> bool:
        """Append a sentence, once so much is read that it is wanted; returns whether to go on."""
        with self._changed:
            start = self.duration
            words = tuple(shifted(word, start) for word in sentence.words)
            self._tracks.append(SentenceTrack(start, start + sentence.duration, sentence.text, words))
            self._file.seek(self.n_samples * _WIDTH)
            self._file.write(np.asarray(sentence.samples, np.float32).tobytes())
            self.n_samples += len(sentence.samples)
            self.peaks.push(np.asarray(sentence.samples, np.float32))
            self._changed.notify_all()
            self._changed.wait_for(lambda: self._closing or self.n_samples - self.position < AHEAD)
            return not self._closing
