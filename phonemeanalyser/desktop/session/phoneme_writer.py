"""The phonemes of a whole sound, written as labels while the window goes on."""

from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.analyser import BLOCK, analyse_blocks
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.output import Reader
from phonemeengine.execution import Progress, report_progress
from phonemeengine.labels.files import write_labels
from phonemeengine.presets.model_choice import for_files, model_in_words
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.segments import SegmentBuilder, labels_of_segments
from phonemeengine.settings import HOP

AT_ONCE = BLOCK * HOP
"""Samples that are read at a time."""


class PhonemeWriter(QObject):
    """Analyses sounds in the background and writes what was found.

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
        """Whether there are phonemes that are not written yet."""
        return self._work.busy

    def write(self, name: str, open_sound: Callable[[], Reader], preset: Preset, target: Path) -> None:
        """Write the phonemes that a preset recognises in a sound.

        Parameters
        ----------
        name : of the sound, for people.
        open_sound : gives it from its beginning.
        target : its ending says in which format: .TextGrid, .txt (Audacity) or .csv (the corpus format).
        """
        self.info.emit(
            tr("Recognising the phonemes of {name} and saving them as {target}…").format(
                name=name, target=target.name
            )
        )
        self._work.submit(
            lambda progress: _write(open_sound, preset, target, progress),
            lambda chosen: self._tell(name, target, chosen),
        )

    def _tell(self, name: str, target: Path, chosen: Preset) -> None:
        self.info.emit(
            tr("Phonemes of {name} saved as {target}. Model: {model}.").format(
                name=name, target=target, model=tr_engine(model_in_words(chosen))
            )
        )
        for warning in chosen.warnings:
            self.error.emit(f"{name}: {warning}")

    def close(self) -> None:
        """Wait until what was asked for is written."""
        self._work.finish()


def _write(open_sound: Callable[[], Reader], preset: Preset, target: Path, progress: Progress) -> Preset:
    """Write the phonemes of a sound; return the preset that recognised them."""
    preset = for_files(preset)
    with closing(open_sound()) as reader:
        joiner, segments = SegmentBuilder(), []
        for analysis in analyse_blocks(_blocks(reader, progress), preset):
            segments += joiner.extend(analysis.phonemes, analysis.intensities)
        segments += joiner.finish(reader.duration)
        write_labels(labels_of_segments(segments), target, duration=reader.duration)
    return preset


def _blocks(reader: Reader, progress: Progress) -> Iterator[Float32Array]:
    """Return what is recognised in a sound, whose length is known at its end at the latest."""
    n = 0
    while len(block := reader.read(AT_ONCE)):
        n += len(block)
        report_progress(progress, n / reader.n_samples)
        yield reader.mono(block)
