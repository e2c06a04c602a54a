"""The phonemes of a whole sound file, written as labels while the window goes on."""

from collections.abc import Iterator
from pathlib import Path

from phonemeengine.analyser import Analysis, analyse_blocks
from phonemeengine.audio.files import SoundReader
from phonemeengine.labels.files import write_labels
from phonemeengine.labels.label import labels_of_runs
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Progress, report_progress
from phonemeengine.recognition.segments import segments_of
from phonemeengine.settings import SAMPLE_RATE, Channel
from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.tasks import TaskQueue

BLOCK = 5 * SAMPLE_RATE
"""Samples that are read at a time."""


class PhonemeWriter(QObject):
    """Analyses files in the background and writes what was found; `see` hands over what came of it.

    Signals
    -------
    told : a sentence for the user about something that goes well.
    failed : a sentence for the user.
    """

    told = Signal(str)
    failed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._work = TaskQueue(self.failed.emit)

    @property
    def busy(self) -> bool:
        """Whether there is a file that is not written yet."""
        return self._work.busy

    def write(self, sound: Path, channel: Channel, preset: Preset, target: Path) -> None:
        """Write the phonemes that a preset recognises in a sound file.

        Parameters
        ----------
        target : its ending says in which format: .TextGrid, .txt (Audacity) or .csv (the corpus format).
        """
        self.told.emit(f"The phonemes of {sound.name} are looked for, and then saved in {target.name} …")
        self._work.do(
            lambda heed: _write(sound, channel, preset, target, heed),
            lambda _none: self.told.emit(f"The phonemes of {sound.name} are saved in {target}."),
        )

    def see(self) -> None:
        """Take note of what was written."""
        self._work.see()

    def close(self) -> None:
        """Wait until what was asked for is written."""
        self._work.close()


def _write(sound: Path, channel: Channel, preset: Preset, target: Path, heed: Progress) -> None:
    with SoundReader(sound, channel) as reader:
        found = ((a.phonemes, a.intensities) for a in _analyses(reader, preset, heed))
        labels = labels_of_runs(segments_of(found, reader.duration))
        write_labels(labels, target, duration=reader.duration)


def _analyses(reader: SoundReader, preset: Preset, heed: Progress) -> Iterator[Analysis]:
    for analysis in analyse_blocks(reader.blocks(BLOCK), preset):
        report_progress(heed, reader.position / reader.n_samples)
        yield analysis
