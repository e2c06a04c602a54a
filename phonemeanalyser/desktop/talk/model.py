"""The head that talks: joins the sound in hand to a mouth, a face, and the network."""

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.session import Session, SoundSource
from phonemeanalyser.desktop.talk.face_model import FaceModel
from phonemeanalyser.desktop.talk.mouth import Frames, TalkMouth
from phonemeanalyser.desktop.talk.osc_model import OscModel
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.mouth.blinks import Blinker
from phonemeengine.mouth.cues import MOST_ANTICIPATION
from phonemeengine.mouth.head_motion import HeadPose
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.percentages import Mode
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table, shipped_tables
from phonemeengine.mouth.viseme_override import VisemeOverride
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

QUIET = 0.3
"""Seconds without a frame after which the mouth of somebody who is listened to closes."""
FORESIGHT = MOST_ANTICIPATION + 2 * FRAME_PERIOD
"""Seconds; what of a file is known even earlier is not told yet: the user may stop it."""
FOLLOWED = 60
"""Frames after which a mouth is where it would be had it followed the sound from its beginning."""
LEAST_WEIGHT, LEAST_ANGLE = 0.002, 0.04
"""What is no change that anybody sees: of a weight, and of the head's pose in degrees."""


class TalkModel(QObject):
    """Has a face say what is heard; `tick` moves it on while it is `watched`.

    Signals
    -------
    changed : another face, table, detail, speed, mode or switch.
    asked_changed : other mouth shapes are asked for by key or slider.
    failed : a sentence for the user.

    Attributes
    ----------
    face, osc : the face that is moved, and what is sent over the network.
    table : the mouth shapes, with the speed that was chosen.
    table_name : one of the program's tables, or the path of the user's own.
    mode : what becomes of everything else when a slider asks for a shape.
    attack_factor, release_factor : by how much all attacks and releases of the table are longer.
    asked : the shapes that are asked for by key or slider.
    watched : whether anybody looks.
    revision : another number whenever the face looks different.
    pose : how the head is turned.
    """

    changed = Signal()
    asked_changed = Signal()
    error = Signal(str)

    def __init__(self, session: Session, clock: Callable[[], float] = time.monotonic) -> None:
        super().__init__()
        self.session = session
        self.face, self.osc = FaceModel(), OscModel()
        self.watched = False
        self.revision = 0
        self.pose = HeadPose()
        self.blinks = self.head_motion = self.random = True
        self.attack_factor = self.release_factor = 1.0
        self.detail, self.mode = Detail.PHONEMES, Mode.INTERACT
        self.table_name = USUAL_TABLE
        self.table = self._written = load_table(USUAL_TABLE)
        self.asked = VisemeOverride(self.table)
        self._clock = clock
        self._began = clock()
        self._mouth = TalkMouth(self.table)
        self._blinker = Blinker()
        self._heard: list[Analysis] = []
        self._heard_at = self._began
        self._last: Analysis | None = None
        self._seen = np.zeros(0, np.float32)
        self._work = TaskQueue(self.error.emit)
        self._connect()

    @property
    def percentages(self) -> dict[str, float]:
        """How far each movestate of the face is on, %; nothing before there is a face."""
        return self.face.states.percentages if self.face.states is not None else {}

    # -- what is chosen -----------------------------------------------------------------------------------

    def set_table(self, name: str) -> None:
        """Move the face by one of the program's tables, or by the user's own, whose path is given."""
        if name in shipped_tables():
            if name != self.table_name:
                self._take_table(name, load_table(name))
        else:
            self._work.replace(lambda _progress: load_table(name), lambda table: self._take_table(name, table))

    def set_detail(self, detail: Detail) -> None:
        """Follow more of the speech, or less."""
        self.detail = detail
        self._use(self.table)

    def set_speed(self, attack: float, release: float) -> None:
        """Make all attacks and all releases of the table longer, by factors above 0."""
        self.attack_factor, self.release_factor = attack, release
        self._use_written()

    def set_random(self, on: bool) -> None:
        """Have the mouth vary as mouths do, or not."""
        self.random = on
        self._use_written()

    def set_mode(self, mode: Mode) -> None:
        """Choose what becomes of other shapes, of speech and of blinks when a shape is asked for."""
        self.mode = mode
        self.changed.emit()

    def set_blinks(self, on: bool) -> None:
        """Have the eyes blink, or not."""
        self.blinks = on
        self.changed.emit()

    def set_head_motion(self, on: bool) -> None:
        """Have the head move with the voice, or not."""
        self.head_motion = on
        self.changed.emit()

    # -- what is asked for --------------------------------------------------------------------------------

    def press(self, phoneme: Phoneme) -> None:
        """Hold the shape that the table has for a phoneme, until `release`."""
        self.hold(self.table.phonemes[phoneme])

    def hold(self, shape: str) -> None:
        """Hold a shape, whatever is said, until `release`: everything else goes to 0 but blinks."""
        self.asked.hold(shape)
        self.asked_changed.emit()

    def release(self) -> None:
        """Let go of the shape that is held."""
        self.asked.release()
        self.asked_changed.emit()

    def ask(self, shape: str, share: float) -> None:
        """Ask for a shape, 0..1; `mode` says what becomes of everything else."""
        self.asked.ask(shape, min(max(share, 0.0), 1.0), self.mode)
        self.asked_changed.emit()

    def ask_nothing(self) -> None:
        """Leave the face to speech and blinks."""
        self.asked.ask_nothing()
        self.asked_changed.emit()

    def watch(self, on: bool) -> None:
        """Take note of whether anybody looks."""
        if on and not self.watched:
            self.face.wake()
            if not self.session.playing:
                self._seek()
        self.watched = on

    # -- what goes on -------------------------------------------------------------------------------------

    def tick(self) -> None:
        """Follow what is heard, and move the face there if anybody looks; call it after the session's own tick."""
        heard, self._heard = self._heard, []
        if not self.watched:
            self._last = None
            return
        now = self._clock() - self._began
        self._listen(heard, now)
        if self.face.states is not None:
            self._move(now)

    def close(self) -> None:
        """Let everything go."""
        self.osc.close()
        self.face.close()
        self._work.close()

    def _listen(self, heard: list[Analysis], now: float) -> None:
        """Tell the mouth the blocks that it does not know yet."""
        end = now - FRAME_PERIOD * sum(map(len, heard))
        known = [(end := end + FRAME_PERIOD * len(block), block) for block in heard]
        if self.session.playing:
            near = [entry for entry in self.session.upcoming() if entry[0] <= FORESIGHT]
            known += [(now + seconds, block) for seconds, block in near]
        places = [k for k, (_, block) in enumerate(known) if block is self._last]
        for at, block in known[places[-1] + 1 if places else 0 :]:
            self._mouth.hear(Frames.of(block), at)
            self._last, self._heard_at = block, now
        if self.session.source is not SoundSource.FILE and now - self._heard_at > QUIET:
            self._mouth.hush(now)

    def _move(self, now: float) -> None:
        weights = self.asked.mixed(self._mouth.weights(now), now)
        closure = self.asked.blinks * self._blinker.closure(now) if self.blinks else 0.0
        pose = self._mouth.pose(now) if self.head_motion else HeadPose()
        look = np.array([*weights, closure, pose.yaw, pose.pitch, pose.roll], np.float32)
        if len(look) == len(self._seen):
            change = np.abs(look - self._seen)
            if change[:-3].max() < LEAST_WEIGHT and change[-3:].max() < LEAST_ANGLE:
                return
        self._seen, self.pose = look, pose
        self.face.move(weights)
        self.face.blink(closure)
        self.revision += 1

    def _connect(self) -> None:
        session = self.session
        session.heard.connect(self._take_blocks)
        session.opened.connect(self._hush)
        session.sought.connect(self._seek)
        session.rewritten.connect(self._seek)
        session.transport_changed.connect(self._hold)
        self.face.changed.connect(self._take_face)
        self.asked_changed.connect(self._tell_network)
        for part in (self.face, self.osc):
            part.error.connect(self.error)

    def _take_blocks(self, blocks: list[Analysis]) -> None:
        """Take what was heard; once the sound has been stopped, what is still told of it says nothing any more."""
        if self.session.playing or self.session.position or self.session.source is not SoundSource.FILE:
            self._heard += blocks
            self.osc.add_analyses(blocks)

    def _tell_network(self) -> None:
        self.osc.ask(self.asked.phonemes, self.asked.speech)

    def _hush(self) -> None:
        self._heard.clear()
        self._last = None
        self._mouth.hush(self._clock() - self._began)

    def _hold(self) -> None:
        """In a pause, keep the shape of what was heard last."""
        session, newest = self.session, self.session.history.newest
        if session.source is SoundSource.FILE and not session.playing and session.position and newest is not None:
            self._last = None
            self._mouth.hold(self._clock() - self._began, int(newest.phonemes[-1]))

    def _seek(self, _column: int = 0) -> None:
        """While nothing plays, stand as somebody does who has just said what comes before that place."""
        session, now = self.session, self._clock() - self._began
        if session.playing:
            self._mouth.forget_coming()
        elif session.position == 0 or session.history.n == 0:
            self._hush()
        else:
            first, last = session.history.newest_run(FOLLOWED)
            at = session.history.indices(session.history.n - (last - first), session.history.n)
            codes, loud = session.history.phonemes[at].tolist(), session.history.intensities[at].tolist()
            self._mouth.stand(Frames(codes, loud, [0.0] * len(codes)), now)

    def _take_face(self) -> None:
        if not self.face.moved_by(self._written) and self.face.tables:
            self.set_table(max(self.face.tables, key=lambda name: len(self.face.moved_by(load_table(name)))))
            return
        self._use(self.table)
        if not self.face.moved_by(self.table) and self.face.states is not None:
            names = ", ".join(self.face.states.names[:4])
            self.error.emit(
                f"No table of the program moves the movestates of this face ({names} …); write a table for them, "
                "and load it as your own table."
            )

    def _take_table(self, name: str, table: MouthTable) -> None:
        if self.face.states is not None and not self.face.moved_by(table):
            names = ", ".join(self.face.tables)
            known = f"choose one of {names}" if names else "write one for it, as your own table"
            self.error.emit(f"{Path(name).name}: this face has none of the table's movestates; {known}.")
            self.changed.emit()
            return
        self.table_name, self._written = name, table
        self.asked = VisemeOverride(table)
        self._use_written()
        self.asked_changed.emit()

    def _use_written(self) -> None:
        self._use(self._written.moved_as(self.attack_factor, self.release_factor, random=self.random))

    def _use(self, table: MouthTable) -> None:
        self.table = table
        self._mouth.use(table, self.detail)
        self.face.use(table)
        self.osc.set_head_table(table, self.detail)
        self._seen = np.zeros(0, np.float32)
        self.changed.emit()
