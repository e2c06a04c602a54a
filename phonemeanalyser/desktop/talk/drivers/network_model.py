"""Faces that follow the sound alone: which network is chosen, and how it moves a face by the current sound."""

from collections.abc import Iterable, Iterator
from pathlib import Path

from PySide6.QtCore import Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.drivers.opened_files import OpenedFiles
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.execution import Progress, report_progress
from phonemeengine.performance.face_network import (
    FaceFollower,
    FaceFrames,
    FaceNetwork,
    FaceNetworkTrack,
    load_face_network,
)
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, Channel

NetworkSound = tuple[Path, Channel]
"""A sound file, and which channel of it is followed."""


class NetworkModel(OpenedFiles):
    """Knows the networks that are open, and follows the current sound with the one that is chosen.

    A file is followed as a whole, as for an export; all else as it plays.

    Signals
    -------
    followed : another face.
    info : a sentence for the user.

    Attributes
    ----------
    face : moves by the current sound; None where none does.
    """

    followed = Signal()
    info = Signal(str)

    def __init__(self) -> None:
        super().__init__(load_face_network, _opened)
        self.face: FaceFrames | None = None
        self._follower: FaceFollower | None = None
        self._state: tuple[FaceNetwork | None, NetworkSound | None] = None, None
        self._work = TaskQueue(self.error.emit)
        self._work.changed.connect(self.changed)

    @property
    def network(self) -> FaceNetwork | None:
        """The network in use; None for none."""
        network: FaceNetwork | None = self._value
        return network

    @property
    def notes(self) -> tuple[str, ...]:
        """What the network in use lacks, a sentence each."""
        return () if self.network is None else self.network.notes

    @property
    def progress(self) -> str:
        """What is going on, in words; nothing where that is nothing."""
        if self._opening.busy:
            return tr("Opening face network…")
        return (
            tr("Generating the face from the sound: {progress:.0%}").format(progress=self._work.progress)
            if self._work.busy
            else ""
        )

    def follow(self, sound: NetworkSound | None, *, wanted: bool) -> None:
        """Follow a sound file, or the current sound where that is None; nothing where no head is moved by it."""
        network = self.network if wanted else None
        if (network, sound) == self._state:
            return
        told = network is not None and network is not self._state[0]
        self._state = network, sound
        self._work.cancel()
        self._show(None)
        if network is None:
            return
        if told and network.notes:
            self.info.emit(tr("{network}: {note}.").format(network=network.name, note="; ".join(network.notes)))
        if sound is None:
            self._show(FaceFrames(network), FaceFollower(network))
        else:
            self._work.replace(lambda progress: _followed(network, sound, progress), self._show)

    def listen(self, heard: Iterable[tuple[float, Analysis]], *, live: bool) -> None:
        """Follow the next blocks, each with when it ends on the clock; only what is live goes by that."""
        if self.face is not None and self._follower is not None:
            for end, block in heard:
                weights = self._follower.listen(block)
                self.face.add(weights, end if live else (block.start + len(block)) * FRAME_PERIOD)

    def begin_again(self) -> None:
        """Forget the frames so far, since the sound goes on elsewhere."""
        if self.face is not None and self._follower is not None and self.network is not None:
            self._follower = FaceFollower(self.network)
            self.face.clear()

    def close(self) -> None:
        """End all work."""
        for work in (self._opening, self._work):
            work.close(CLOSE_TIMEOUT)

    def _show(self, face: FaceFrames | None, follower: FaceFollower | None = None) -> None:
        if face is not self.face:
            self.face, self._follower = face, follower
            self.followed.emit()


def _opened(path: Path) -> tuple[FaceNetwork, FaceNetwork]:
    network = load_face_network(path)
    return network, network


def _followed(network: FaceNetwork, sound: NetworkSound, progress: Progress) -> FaceFrames:
    with SoundReader(*sound) as reader:

        def blocks() -> Iterator[Float32Array]:
            done = 0.0
            for block in reader.blocks(SAMPLE_RATE):
                yield block
                done += len(block) / SAMPLE_RATE
                report_progress(progress, min(1.0, done / max(reader.duration, FRAME_PERIOD)))

        return FaceNetworkTrack(network, blocks()).mouth()
