"""The phonemes of a whole sound file, written as labels while the window goes on."""

from collections.abc import Iterator
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.analyser import Analysis, analyse_file
from phonemeengine.audio.files import SoundReader
from phonemeengine.labels.files import write_labels
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Progress, report_progress
from phonemeengine.recognition.segments import labels_of_segments, segments_of
from phonemeengine.settings import Channel


class PhonemeWriter(QObject):
    """Analyses files in the background and writes what was found.

    Signals
    -------
    info : a sentence for the user about something that goes well.
    error : a sentence for the user.
    """

    info = Signal(str)
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._work = TaskQueue(self.error.emit)

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
        self.info.emit(f"The phonemes of {sound.name} are looked for, and then saved in {target.name} …")
        self._work.submit(
            lambda progress: _write(sound, channel, preset, target, progress),
            lambda _none: self.info.emit(f"The phonemes of {sound.name} are saved in {target}."),
        )

    def close(self) -> None:
        """Wait until what was asked for is written."""
        self._work.finish()


def _write(sound: Path, channel: Channel, preset: Preset, target: Path, progress: Progress) -> None:
    with SoundReader(sound, channel) as reader:
        found = ((a.phonemes, a.intensities) for a in _analyses(reader, preset, progress))
        labels = labels_of_segments(segments_of(found, reader.duration))
        write_labels(labels, target, duration=reader.duration)


def _analyses(reader: SoundReader, preset: Preset, progress: Progress) -> Iterator[Analysis]:
    for analysis in analyse_file(reader, preset):
        report_progress(progress, reader.position / reader.n_samples)
        yield analysis
