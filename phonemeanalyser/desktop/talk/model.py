"""The head that talks: joins the sound in hand to a mouth, a face, and the network."""

import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.talk.expression_model import ExpressionModel
from phonemeanalyser.desktop.talk.face_model import FaceModel
from phonemeanalyser.desktop.talk.osc_model import OscModel
from phonemeanalyser.desktop.talk.text_model import TextModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.mouth.head_motion import HeadPose
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.percentages import Mode
from phonemeengine.mouth.performer import (
    IdleMotion,
    MouthTrack,
    Performer,
    TimedFrame,
    known_frames,
    timed_frames,
)
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table, shipped_tables
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.mouth.viseme_override import VisemeOverride
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE

HALF_FRAME = (HOP - HOP // 2) / SAMPLE_RATE
"""Seconds: a block of a file is due in the middle of its last frame."""
FOLLOWED = 60
"""Frames after which a mouth is where it would be had it followed the sound from its beginning."""
LEAST_WEIGHT, LEAST_ANGLE = 0.002, 0.04
"""What is no change that anybody sees: of a weight, and of the head's pose in degrees."""


class TalkModel(QObject):
    """Has a face say what is heard; `tick` moves it on while it is `watched`.

    Signals
    -------
    changed : another face, table, detail, speed, mode or switch.
    visemes_changed : other mouth shapes are asked for by key or slider.
    error : a sentence for the user.

    Attributes
    ----------
    face, osc : the face that is moved, and what is sent over the network.
    text : the words of the sound in hand, where they are known.
    table : the mouth shapes, with the speed that was chosen.
    table_name : one of the program's tables, or the path of the user's own.
    mode : what becomes of everything else when a slider asks for a shape.
    attack_factor, release_factor : by how much all attacks and releases of the table are longer.
    random : whether the mouth varies as mouths do.
    performer : says what is heard, with this face.
    idle : what the face does besides speaking, and in which detail its mouth follows.
    watched : whether anybody looks.
    revision : another number whenever the face looks different.
    pose : how the head is turned.
    """

    changed = Signal()
    visemes_changed = Signal()
    error = Signal(str)

    def __init__(
        self, session: Session, clock: Callable[[], float] = time.monotonic, text: TextModel | None = None
    ) -> None:
        super().__init__()
        self.session = session
        self._clock, self._began = clock, clock()
        self.face, self.osc = FaceModel(), OscModel(self._now)
        self.text = text or TextModel(session)
        self.expression = ExpressionModel()
        self.watched = False
        self.revision = 0
        self.pose = HeadPose()
        self.random = True
        self.attack_factor = self.release_factor = 1.0
        self.mode = Mode.INTERACT
        self.table_name = USUAL_TABLE
        self.table = self._written = load_table(USUAL_TABLE)
        self.idle = IdleMotion()
        self.performer = Performer(self.table, self.idle)
        self._performers = self.performer, self.osc.performer
        self._known: Transcript | None = None
        self._tracks: tuple[MouthTrack, ...] = ()
        self._heard: list[Analysis] = []
        self._last: Analysis | None = None
        self._seen = np.zeros(0, np.float32)
        self._work = TaskQueue(self.error.emit)
        self._connect()

    @property
    def visemes(self) -> VisemeOverride:
        """The shapes that are asked for by key or slider."""
        return self.performer.visemes

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
        self.idle = replace(self.idle, detail=detail)
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
        self.idle = replace(self.idle, blinks=on)
        self._use(self.table)

    def set_head_motion(self, on: bool) -> None:
        """Have the head move with the voice, or not."""
        self.idle = replace(self.idle, head=on)
        self._use(self.table)

    def set_known(self, known: Transcript | None) -> None:
        """Say what is known of the sound in hand, until another one is opened; of None, what is recognised in it."""
        self._known = known
        self._last = None  # what is known ahead is heard again
        self._seek()

    # -- what is asked for --------------------------------------------------------------------------------

    def press(self, phoneme: Phoneme) -> None:
        """Hold the shape that the table has for a phoneme, until `release`."""
        self.hold(self.table.phonemes[phoneme])

    def hold(self, shape: str) -> None:
        """Hold a shape, whatever is said, until `release`: everything else goes to 0 but blinks."""
        self.visemes.hold(shape)
        self.visemes_changed.emit()

    def release(self) -> None:
        """Let go of the shape that is held."""
        self.visemes.release()
        self.visemes_changed.emit()

    def set_viseme(self, shape: str, share: float) -> None:
        """Ask for a shape, 0..1; `mode` says what becomes of everything else."""
        self.visemes.set(shape, min(max(share, 0.0), 1.0), self.mode)
        self.visemes_changed.emit()

    def clear_visemes(self) -> None:
        """Leave the face to speech and blinks."""
        self.visemes.clear()
        self.visemes_changed.emit()

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
        self.text.tick()
        heard, self._heard = self._heard, []
        if not (self.watched or self.osc.on):
            self._last = None
            return
        now = self._now()
        self._listen(heard, now)
        self._play_letters(now)
        if self.watched and self.face.states is not None:
            self._move(now)

    def close(self) -> None:
        """Let everything go."""
        self.text.close()
        self.osc.close()
        self.face.close()
        self._work.close(CLOSE_TIMEOUT)

    def _now(self) -> float:
        """Return the time that performers and the network share, seconds."""
        return self._clock() - self._began

    def _listen(self, heard: list[Analysis], now: float) -> None:
        """Have the performers hear the blocks that they do not know yet."""
        end = now - FRAME_PERIOD * sum(map(len, heard))
        known = [(end := end + FRAME_PERIOD * len(block), block) for block in heard]
        if self.session.playing:
            known += [(now + seconds + HALF_FRAME, block) for seconds, block in self.session.upcoming()]
        places = [k for k, (_, block) in enumerate(known) if block is self._last]
        new = known[places[-1] + 1 if places else 0 :]
        if new:
            self._last = new[-1][1]
            frames = [frame for end, block in new for frame in timed_frames(block, end, self._known)]
            for performer in self._performers:
                performer.hear(frames, now, live=self.session.source.live)

    def _play_letters(self, now: float) -> None:
        """Have letters of pinyin move the mouths, in step with the sound, where there are any."""
        start = now - self.session.position
        for performer, track in zip(self._performers, self._tracks, strict=False):
            performer.play(track, start)

    def _take_text(self) -> None:
        """Take up the letters, or that there are none any more; each performer asks a mouth of its own."""
        letters = self.text.letters
        if letters is None and self._tracks:
            for performer in self._performers:
                performer.play(None)
        self._tracks = () if letters is None else tuple(letters.mouth() for _ in self._performers)

    def _grow_known(self, known: Transcript) -> None:
        """Go on with what is known by now of the same sound, none of which was heard yet."""
        self._known = known

    def _move(self, now: float) -> None:
        _, weights, closure, pose = self.performer.at(now)
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
        session.opened.connect(self._forget_sound)
        session.sought.connect(self._seek)
        session.rewritten.connect(self._seek)
        session.transport_changed.connect(self._hold)
        self.text.known_changed.connect(self.set_known)
        self.text.known_grew.connect(self._grow_known)
        self.text.known_changed.connect(self._take_text)
        self.text.known_grew.connect(self._take_text)
        self.face.changed.connect(self._take_face)
        self.expression.changed.connect(self._take_expression)
        self.visemes_changed.connect(self._share_visemes)
        self.osc.changed.connect(self._share_visemes)
        for part in (self.face, self.osc, self.text):
            part.error.connect(self.error)

    def _take_blocks(self, blocks: list[Analysis]) -> None:
        """Take what was heard; once the sound has been stopped, what is still told of it says nothing any more."""
        if self.session.playing or self.session.position or self.session.source.live:
            self._heard += blocks

    def _share_visemes(self) -> None:
        self.osc.performer.set_phonemes(self.visemes.phonemes, self.visemes.speech)

    def _forget_sound(self) -> None:
        self._known = None
        self._close_mouth()
        self.text.follow_sound()

    def _close_mouth(self) -> None:
        self._heard.clear()
        self._last = None
        for performer in self._performers:
            performer.close_mouth(self._now())

    def _hold(self) -> None:
        """In a pause, keep the shape of what was heard last."""
        session, newest = self.session, self.session.history.newest
        if not session.source.live and not session.playing and session.position and newest is not None:
            self._last, now = None, self._now()
            last = timed_frames(newest, now, self._known)[-1]
            for performer in self._performers:
                performer.hold(now, last.phoneme, last.phone)

    def _seek(self, _column: int = 0) -> None:
        """While nothing plays, stand as somebody does who has just said what comes before that place."""
        session, now = self.session, self._now()
        if session.playing:
            for performer in self._performers:
                performer.forget_coming(now)
        elif session.position == 0 or session.history.n == 0:
            self._close_mouth()
        else:
            frames = self._newest_frames(now)
            for performer in self._performers:
                performer.jump_to(frames, now)

    def _newest_frames(self, now: float) -> list[TimedFrame]:
        """Return what the history holds last, as if it had just been heard."""
        history = self.session.history
        first, last = history.newest_run(FOLLOWED)
        at = history.indices(history.n - (last - first), history.n)
        rows = zip(history.phonemes[at].tolist(), history.intensities[at].tolist(), strict=True)
        start = now - len(at) * FRAME_PERIOD
        frames = [TimedFrame(start + k * FRAME_PERIOD, Phoneme(code), loud) for k, (code, loud) in enumerate(rows)]
        return frames if self._known is None else known_frames(frames, first, self._known)

    def _take_expression(self) -> None:
        self.idle = replace(self.idle, expression=self.expression.expression)
        self.performer.configure(self.table, self.idle)
        self.osc.express(self.idle.expression)

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
        self._use_written()
        self.visemes_changed.emit()

    def _use_written(self) -> None:
        self._use(self._written.with_motion(self.attack_factor, self.release_factor, random=self.random))

    def _use(self, table: MouthTable) -> None:
        self.table = table
        self.performer.configure(table, self.idle)
        self.face.set_table(table)
        self.osc.follow(table, self.idle.detail)
        self._seen = np.zeros(0, np.float32)
        self.changed.emit()
