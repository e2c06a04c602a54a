"""Labelled recordings that were loaded beside the takes."""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.calibration.scores.corpus import LabelledUtterance, read_recordings
from phonemeengine.errors import AudioError, UnknownPhonemeError
from phonemeengine.labels.phoneme_map import PhonemeMap
from phonemeengine.phonemes import Phoneme

Read = tuple[tuple[LabelledUtterance, ...], list[str]]
"""What was read, and the sentences about what could not be."""


class RecordingsModel(QObject):
    """Reads labelled recordings in the background.

    Signals
    -------
    changed : the recordings are others.
    unknown : names in the label files stand for no phoneme: how often each occurs, and what was to be read.
    info : a sentence for the user about something that went well.
    error : a sentence for the user.
    """

    changed = Signal()
    unknown = Signal(dict, list)
    info = Signal(str)
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.utterances: tuple[LabelledUtterance, ...] = ()
        self.sources: list[Path] = []
        self.mapping = PhonemeMap()
        self._reading = TaskQueue(self.error.emit)

    @property
    def busy(self) -> bool:
        """Whether label files are being read."""
        return self._reading.busy

    @property
    def n_speakers(self) -> int:
        """How many people speak in them."""
        return len({utterance.speaker for utterance in self.utterances})

    def load(self, sources: Sequence[Path]) -> None:
        """Read folders or sounds with their labels beside those that are there."""
        wanted = [path for path in sources if path not in self.sources]
        mapping = self.mapping
        self._reading.submit(lambda _progress: _read(wanted, mapping), lambda found: self._take_up(wanted, found))

    def map(self, phonemes: dict[str, Phoneme], sources: Sequence[Path]) -> None:
        """Learn what names stand for, and read again what they stood in."""
        self.mapping = PhonemeMap({**self.mapping.phonemes, **phonemes})
        self.load(sources)

    def clear(self) -> None:
        """Forget all recordings; their files stay."""
        self._reading.cancel()
        self.utterances, self.sources = (), []
        self.changed.emit()

    def close(self) -> None:
        """End all reading."""
        self._reading.close()

    def add(self, utterances: Sequence[LabelledUtterance]) -> None:
        """Take recordings that were just made and labelled beside those that are there."""
        have = {utterance.path for utterance in self.utterances}
        fresh = tuple(u for u in utterances if u.path not in have)
        if fresh:
            self.utterances += fresh
            self.changed.emit()

    def _take_up(self, sources: list[Path], found: Read | dict[str, int]) -> None:
        if isinstance(found, dict):
            self.unknown.emit(found, sources)
            return
        utterances, refusals = found
        self.sources += sources
        have = {utterance.path for utterance in self.utterances}
        fresh = tuple(u for u in utterances if u.path not in have)
        self.utterances += fresh
        self.changed.emit()
        if refusals:
            self.error.emit(tr("{n} sounds were left out; {refusal}").format(n=len(refusals), refusal=refusals[0]))
        elif sources:
            self.info.emit(tr("{n} labelled recordings were loaded.").format(n=len(fresh)))


def _read(sources: Sequence[Path], mapping: PhonemeMap) -> Read | dict[str, int]:
    """Read recordings; where names are unknown, give those of all of them."""
    utterances: list[LabelledUtterance] = []
    refusals: list[AudioError] = []
    unknown: dict[str, int] = {}
    for source in sources:
        try:
            utterances += read_recordings(source, mapping, on_skipped=refusals.append)
        except UnknownPhonemeError as error:
            unknown = dict(Counter(unknown) + Counter(error.counts))
    return unknown or (tuple(utterances), [str(refusal) for refusal in refusals])
