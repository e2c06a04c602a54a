"""By what the mouth moves: the rules of the mouth table, letters of pinyin, recorded faces, or the sound alone."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.drivers.performance_model import MeasuredSound, OpenedFiles, PerformanceModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.conversion.driving import DriverChoice
from phonemeengine.errors import TextError
from phonemeengine.execution import Progress, report_progress
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.animation import NEEDS_FILE, FaceDriver, usual_driver
from phonemeengine.mouth.performer import MouthTrack
from phonemeengine.performance import face_network
from phonemeengine.performance.track import SpokenFace
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, Channel
from phonemeengine.speech.pinyin.table import load_pinyin_table
from phonemeengine.speech.pinyin.track import PinyinTrack, pinyin_track

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
        super().__init__(face_network.load_face_network, _opened)
        self.face: face_network.FaceFrames | None = None
        self._follower: face_network.FaceFollower | None = None
        self._state: tuple[face_network.FaceNetwork | None, NetworkSound | None] = None, None
        self._work = TaskQueue(self.error.emit)
        self._work.changed.connect(self.changed)

    @property
    def network(self) -> face_network.FaceNetwork | None:
        """The network in use; None for none."""
        network: face_network.FaceNetwork | None = self._value
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
            self._show(face_network.FaceFrames(network), face_network.FaceFollower(network))
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
            self._follower = face_network.FaceFollower(self.network)
            self.face.clear()

    def close(self) -> None:
        """End all work."""
        for work in (self._opening, self._work):
            work.close(CLOSE_TIMEOUT)

    def _show(self, face: face_network.FaceFrames | None, follower: face_network.FaceFollower | None = None) -> None:
        if face is not self.face:
            self.face, self._follower = face, follower
            self.followed.emit()


def _opened(path: Path) -> tuple[face_network.FaceNetwork, face_network.FaceNetwork]:
    network = face_network.load_face_network(path)
    return network, network


def _followed(network: face_network.FaceNetwork, sound: NetworkSound, progress: Progress) -> face_network.FaceFrames:
    with SoundReader(*sound) as reader:

        def blocks() -> Iterator[Float32Array]:
            done = 0.0
            for block in reader.blocks(SAMPLE_RATE):
                yield block
                done += len(block) / SAMPLE_RATE
                report_progress(progress, min(1.0, done / max(reader.duration, FRAME_PERIOD)))

        return face_network.FaceNetworkTrack(network, blocks()).mouth()


OTHER_PRESET = "preset"
"""Moves a second head by what the preset that is not in use recognises, whatever is known of the words."""


class DriverModel(QObject):
    """Chooses what moves the mouth, and what moves another one beside it.

    Signals
    -------
    changed : something else moves a mouth, or the same otherwise.
    compared_changed : there is another second head, or none any more.
    error, info : a sentence for the user.

    Attributes
    ----------
    performance : the tables of recorded faces.
    network : the networks that follow the sound alone.
    chosen : what is to move the mouth.
    compared : what moves a second head beside the first, a driver or `OTHER_PRESET`; None for no second head.
    letters : how a mouth says Chinese, where one goes by letters; None elsewhere.
    """

    changed = Signal()
    compared_changed = Signal()
    error = Signal(str)
    info = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.performance, self.network = PerformanceModel(), NetworkModel()
        self.chosen = FaceDriver.AUTO
        self.compared: str | None = None
        self.letters: PinyinTrack | None = None
        self._utterance: Utterance | None = None
        self._text = ""
        self._sound: MeasuredSound | None = None
        self._spoken: SpokenFace | None = None
        self._state: tuple[object, ...] = ()
        self._chosen = self._asked
        self.performance.changed.connect(self._take_choice)
        self.network.changed.connect(self._take_choice)
        for moved in (self.performance.looked_up, self.network.followed):
            moved.connect(self.changed)
        for part in (self.performance, self.network):
            part.error.connect(self.error)
            part.info.connect(self.info)

    @property
    def main(self) -> FaceDriver:
        """What moves the mouth: automatically, a table or a network, letters for Chinese, else the rules."""
        if self.chosen is not FaceDriver.AUTO:
            return self.chosen
        has_network = self.network.network is not None
        has_table = self.performance.table is not None and (self._utterance is not None or not has_network)
        return usual_driver(has_table=has_table, has_letters=self.letters is not None, has_network=has_network)

    @property
    def progress(self) -> str:
        """What is going on, in words; nothing where that is nothing."""
        return self.performance.progress or self.network.progress

    @property
    def exported(self) -> DriverChoice:
        """The same for a file; a table or a network that is not open moves none."""
        return self._choice_of(self.chosen)

    @property
    def choice_beside(self) -> DriverChoice:
        """What moves the second head, for a file; a driver that has nothing for what is said follows the sounds."""
        has_nothing = self.compared is None or self.track_by(self.compared) is None
        return DriverChoice(FaceDriver.RULES) if has_nothing else self._choice_of(FaceDriver(self.compared or ""))

    @property
    def wants_table(self) -> bool:
        """Whether a table is open, and a head is to move by it."""
        return self.performance.table is not None and FaceDriver.TABLE in {self.main, self.compared}

    def choose(self, driver: FaceDriver) -> None:
        """Move the mouth by this."""
        if driver is not self.chosen:
            self.chosen = driver
            self._choose_again()

    def compare(self, driver: str | None) -> None:
        """Show a second head that moves by this, or none."""
        if driver != self.compared:
            self.compared = driver
            self.compared_changed.emit()
            self._choose_again()

    def follow(
        self,
        utterance: Utterance | None,
        text: str = "",
        sound: MeasuredSound | None = None,
        spoken: SpokenFace | None = None,
    ) -> None:
        """Take what is said in the current sound; None for nothing that is known.

        Parameters
        ----------
        text : as it is written, for the pauses of its marks.
        sound : the file, of a recording.
        spoken : what looks it up while a voice speaks it.
        """
        self._utterance, self._text, self._sound, self._spoken = utterance, text, sound, spoken
        self._follow_again()

    def track_by(self, driver: str) -> MouthTrack | None:
        """Return what moves a mouth by a driver now; None where it follows the sound."""
        if driver is FaceDriver.PINYIN and self.letters is not None:
            return self.letters.mouth()
        if driver is FaceDriver.NETWORK:
            return self.network.face
        return self.performance.face if driver is FaceDriver.TABLE else None

    def caption_of(self, driver: str, track: MouthTrack | None) -> str:
        """Return in words what moves a mouth: by a driver that has nothing for it, its sounds do."""
        if track is None:
            return FaceDriver.RULES.caption
        return self.name_of(FaceDriver(driver)) or FaceDriver(driver).caption

    def name_of(self, driver: FaceDriver) -> str:
        """Return what the file is called by which a driver moves a mouth; empty where it has none."""
        return {FaceDriver.TABLE: self.performance.name, FaceDriver.NETWORK: self.network.name}.get(driver, "")

    def notes_of(self, driver: str | None) -> tuple[str, ...]:
        """Return what the file of a driver lacks for what is said, a sentence each."""
        notes = {FaceDriver.TABLE: self.performance.notes, FaceDriver.NETWORK: self.network.notes}
        return () if driver is None else notes.get(FaceDriver(driver), ()) if driver != OTHER_PRESET else ()

    def close(self) -> None:
        """End all work."""
        self.performance.close()
        self.network.close()

    def _choice_of(self, driver: FaceDriver) -> DriverChoice:
        performance = self.performance
        table = performance.chosen if driver in {FaceDriver.AUTO, FaceDriver.TABLE} else None
        network = self.network.chosen if driver in {FaceDriver.AUTO, FaceDriver.NETWORK} else None
        if driver in NEEDS_FILE and table is None and network is None:
            driver = FaceDriver.AUTO
        return DriverChoice(
            driver,
            performance=() if table is None else (table,),
            choice=performance.choice,
            network=network,
            style=performance.style,
        )

    # -- inside -------------------------------------------------------------------------------------------

    def _take_choice(self) -> None:
        """Look up anew where that comes out otherwise: `changed` tells of progress, too."""
        if self._asked != self._chosen:
            self._chosen = self._asked
            self._choose_again()

    def _choose_again(self) -> None:
        """Look up by what is chosen now; a spoken text goes by what was chosen when it was said."""
        self._follow_again()
        looked_up = self._spoken is not None or self._sound is not None
        if self._utterance is not None and self.wants_table and not looked_up:
            self.info.emit(
                tr("Recorded faces are looked up while a text is spoken; press Speak to apply them to this text.")
            )

    @property
    def _asked(self) -> tuple[object, ...]:
        return self.performance.table, self.performance.choice, self.performance.style, self.network.network

    def _follow_again(self) -> None:
        utterance = self._utterance
        self.letters = None if utterance is None else self._letters_of(utterance)
        state = (utterance, self._sound, self._spoken, self.wants_table, *self._chosen)
        if state != self._state:
            self._state = state
            self._look_up(utterance)
        sound = None if self._sound is None else (self._sound.path, self._sound.channel)
        self.network.follow(sound, wanted=FaceDriver.NETWORK in {self.main, self.compared})
        self.changed.emit()

    def _look_up(self, utterance: Utterance | None) -> None:
        performance = self.performance
        if utterance is None or not self.wants_table:
            performance.forget()
        elif self._sound is not None:
            performance.look_up(self._sound, utterance)
        elif self._spoken is not None:
            performance.show_spoken(self._spoken)
        else:
            performance.forget()

    def _letters_of(self, utterance: Utterance) -> PinyinTrack | None:
        """Return how the mouth says Chinese; None for other languages, and where no mouth goes by letters."""
        wanted = {self.chosen, self.compared}
        usual = self.chosen is FaceDriver.AUTO and self.performance.table is None and self.network.network is None
        in_pinyin = any(syllable.text for word in utterance.words for syllable in word.syllables)
        if FaceDriver.PINYIN not in wanted and not (usual and in_pinyin):
            return None
        try:
            table = load_pinyin_table()
            styled = replace(table, mouth=self.performance.style.on_table(table.mouth))
            return pinyin_track(utterance, styled, text=self._text)
        except TextError:
            if FaceDriver.PINYIN in wanted:
                self.error.emit(
                    tr("Pinyin letters cannot drive the mouth, since no Chinese is spoken; choose another driver.")
                )
            return None
