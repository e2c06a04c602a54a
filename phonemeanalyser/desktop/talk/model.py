"""The head that talks: joins the current sound to a mouth, a face, and the network."""

import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.exports import FaceInUse
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.drivers.difference_model import DifferenceModel
from phonemeanalyser.desktop.talk.expression.expression_model import ExpressionModel, OscModel
from phonemeanalyser.desktop.talk.expression.style_model import StyleModel
from phonemeanalyser.desktop.talk.head.face_model import FaceModel, MovingHead
from phonemeanalyser.desktop.talk.keys.key_model import KeyModel
from phonemeanalyser.desktop.talk.pictures import PictureModel
from phonemeanalyser.desktop.talk.words.felt_text import FeltText
from phonemeanalyser.desktop.talk.words.text_model import TextModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.mouth.animation import NEEDS_FILE
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.face_mapping import guess_mapping
from phonemeengine.mouth.key_layer import NO_KEYS
from phonemeengine.mouth.morpher import Detail, VisemeOverride
from phonemeengine.mouth.movestate import Mode
from phonemeengine.mouth.performer import IdleMotion, MouthTrack, Performer, TimedFrame, known_frames, timed_frames
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table, shipped_tables
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.performance.driver import FACE
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE

HALF_FRAME = (HOP - HOP // 2) / SAMPLE_RATE
"""Seconds: a block of a file is due in the middle of its last frame."""
FITTING = 0.5
"""Share of what a table of the program moves that a face has, at least, where its shapes count as known."""
FOLLOWED = 60
"""Frames after which a mouth is where it would be had it followed the sound from its beginning."""


class TalkModel(QObject):
    """Has a face say what is playing; `tick` moves it on while it is `watched`.

    Signals
    -------
    changed : another face, table, detail, speed, mode or switch.
    visemes_changed : other mouth shapes are asked for by key or slider.
    shapes_unknown : the face has no shape that the table, or one of the program, moves.
    error : a sentence for the user.

    Attributes
    ----------
    face, osc, styles : the face that is moved, what is sent over the network, and in which style it speaks.
    text : the words of the current sound, where they are known.
    table : the mouth shapes, with the speed that was chosen.
    table_name : one of the program's tables, or the path of the user's own.
    mode : what becomes of everything else when a slider asks for a shape.
    attack_factor, release_factor : by how much all attacks and releases of the table are longer.
    random : whether the mouth varies as mouths do.
    pictures : of the animation.
    head : shows on the face what its performer says.
    beside : the second head, of the same face, that shows what another driver makes of the sound.
    performer : that of the head.
    idle : what the face does besides speaking, and in which detail its mouth follows.
    watched : whether anybody looks.
    keys : an animator's edits of the current sound's movement.
    comparison : says where the second head moves otherwise.
    """

    changed = Signal()
    visemes_changed = Signal()
    shapes_unknown = Signal()
    error = Signal(str)

    def __init__(
        self, session: Session, clock: Callable[[], float] = time.monotonic, text: TextModel | None = None
    ) -> None:
        super().__init__()
        self.session = session
        self._clock, self._began = clock, clock()
        self.face, self.osc = FaceModel(), OscModel(self._now)
        self.text = text or TextModel(session)
        self.expression, self.styles = ExpressionModel(), StyleModel(session.preset.undo_stack)
        self.felt_text = FeltText(self.text, self.expression, session.preset.undo_stack)
        self.watched, self.random = False, True
        self.attack_factor = self.release_factor = 1.0
        self.mode = Mode.INTERACT
        self.table_name = USUAL_TABLE
        self.table = self._written = load_table(USUAL_TABLE)
        self.idle = IdleMotion()
        self.head = MovingHead(self.face, self.table, self.idle)
        self.beside = MovingHead(FaceModel(), self.table, self.idle)
        self.performer = self.head.performer
        self._tracks: dict[Performer, MouthTrack] = {}
        self._analysed: list[Analysis] = []
        self._last: Analysis | None = None
        self._work = TaskQueue(self.error.emit)
        self.pictures = PictureModel(session)
        self.keys = KeyModel(session, lambda: self.shown, lambda: self.pictures.rate)
        self.comparison = DifferenceModel(session, self.text, lambda: self.shown, lambda: self.pictures.rate)
        self._connect()

    @property
    def visemes(self) -> VisemeOverride:
        """The shapes that are asked for by key or slider."""
        return self.performer.visemes

    @property
    def comparing(self) -> bool:
        """Whether there is a second head."""
        return self.text.drivers.compared is not None

    @property
    def percentages(self) -> dict[str, float]:
        """How far each movestate of the face is on, %; nothing before there is a face."""
        return self.face.states.percentages if self.face.states is not None else {}

    @property
    def in_use(self) -> FaceInUse:
        """What files are made by, so that they are as the head is seen."""
        words, files, language = self.text.words, self.face.files, self.text.written.spoken_in
        known = {}
        if words.sound is not None and words.utterance is not None:
            known[words.sound] = replace(words.utterance, language=language or words.utterance.language)
        style, idle = self.styles.style, replace(self.idle, expression=self.expression.exported)
        options = ExportOptions(
            mesh=files.mesh,
            idle=style.on_idle(idle),
            attack=self.attack_factor,
            release=self.release_factor,
            random=self.random,
            style=style,
            text_feeling=self.expression.text_feeling or None,
        )
        return FaceInUse(
            self.table_name,
            options,
            files.movestates,
            self.text.drivers.exported,
            known,
            self.text.to_say,
            {self.keys.sound: self.keys.layer} if self.keys.sound is not None else {},
            dict.fromkeys(known, self.text.text_of_words),
        )

    @property
    def shown(self) -> FaceInUse:
        """The same for the current sound alone, with what its text says of feeling as the head shows it."""
        face, idle = self.in_use, replace(self.idle, expression=self.expression.of_sound)
        options = replace(face.options, idle=self.styles.style.on_idle(idle), text_feeling=None)
        return replace(face, options=options)

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
        self._use(self.table, detail=detail)

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
        self._use(self.table, blinks=on)

    def set_head_motion(self, on: bool) -> None:
        """Have the head move with the voice, or not."""
        self._use(self.table, head=on)

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
            if not self.session.source.playing:
                self._seek()
        self.watched = on

    # -- what goes on -------------------------------------------------------------------------------------

    def tick(self) -> None:
        """Follow what is playing, and move the face there if it is in view; call it after the session's `poll`."""
        self.text.tick()
        analysed, self._analysed = self._analysed, []
        if not (self.watched or self.osc.on):
            self._last = None
            return
        now = self._now()
        self._listen(analysed, now)
        self._play_tracks(now)
        if self.watched:
            for head in (self.head, self.beside) if self.comparing else (self.head,):
                head.move(now)

    def close(self) -> None:
        """Let everything go."""
        for part in (self.text, self.keys, self.comparison, self.expression, self.osc, self.face, self.beside.face):
            part.close()
        self._work.close(CLOSE_TIMEOUT)

    def _now(self) -> float:
        """Return the time that performers and the network share, seconds."""
        return self._clock() - self._began

    def _listen(self, analysed: list[Analysis], now: float) -> None:
        """Give the performers the blocks that they do not know yet."""
        end = now - FRAME_PERIOD * sum(map(len, analysed))
        known = [(end := end + FRAME_PERIOD * len(block), block) for block in analysed]
        if self.session.source.playing:
            known += [(now + seconds + HALF_FRAME, block) for seconds, block in self.session.source.upcoming()]
        places = [k for k, (_, block) in enumerate(known) if block is self._last]
        new = known[places[-1] + 1 if places else 0 :]
        if new:
            self._last = new[-1][1]
            for performer in self._performers:
                said = self._known_to(performer)
                frames = [frame for end, block in new for frame in timed_frames(block, end, said)]
                performer.add(frames, now, live=self.session.source.live)
            self.expression.feel(new, self._performers)
            self.text.drivers.network.listen(new, live=self.session.source.live)

    def _known_to(self, performer: Performer) -> Transcript | None:
        """Return what is said, where that is known: to the second head as the other preset recognises it."""
        is_other = self.comparison.by_preset and performer is self.beside.performer
        return self.comparison.known if is_other else self.text.known

    @property
    def _performers(self) -> tuple[Performer, ...]:
        both = self.performer, self.osc.performer
        return (*both, self.beside.performer) if self.comparing else both

    def _play_tracks(self, now: float) -> None:
        """Have mouths and recorded expressions go with the sound, where anything is known of it."""
        session, original = self.session, self.text.original
        if self._tracks or self.expression.in_step:
            position = session.source.position
            self.expression.follow(now - position)
            start = 0.0 if session.source.live else now - position  # the current sound is followed by the clock
            for performer, track in self._tracks.items():
                performer.play(track if session.source.playing or position else None, start)
        if original.face is not None:
            self.performer.play(original.face, now - original.position)
        layer = self.keys.layer if original.face is None else NO_KEYS  # another recording has keys of its own
        for performer in self._performers:
            performer.edit(layer, now - session.source.position)

    def _take_drivers(self) -> None:
        """Take up what moves the mouths; where nothing does, they follow the sound."""
        drivers = self.text.drivers
        movers: dict[Performer, str] = {self.performer: drivers.main, self.osc.performer: drivers.main}
        if drivers.compared is not None:
            movers[self.beside.performer] = drivers.compared
        found = {performer: drivers.track_by(driver) for performer, driver in movers.items()}
        self._tracks = {performer: track for performer, track in found.items() if track is not None}
        for performer in found.keys() - self._tracks.keys():
            performer.play(None)
        self._configure()
        self._name_heads()
        self.changed.emit()

    def _name_heads(self) -> None:
        """Say below the heads what moves them, unless there is one head, and its mouth table does."""
        drivers, original = self.text.drivers, self.text.original
        shown, beside = map(self._track_of, (self.head, self.beside))
        by_file = shown is not None and drivers.main in NEEDS_FILE
        self.head.caption = drivers.caption_of(drivers.main, shown) if self.comparing or by_file else ""
        self.head.notes = drivers.notes_of(drivers.main) if by_file else ()
        if original.face is not None:
            self.head.caption, self.head.notes = original.caption, ()
        self.beside.caption = self.comparison.caption_of(beside)
        if self.comparison.by_preset and self.text.known is None:
            self.head.caption = self.session.preset.title
        self.beside.notes = drivers.notes_of(drivers.compared)

    def _track_of(self, head: MovingHead) -> MouthTrack | None:
        """Return what moves a head, if it knows all movestates of the mouth table."""
        track = self._tracks.get(head.performer)
        return track if track is not None and {*self.table.movestates} <= {*track.movestates} else None

    def _take_compared(self) -> None:
        """Have the second head begin where the first one is, or leave it alone."""
        if self.comparing and self.beside.face.morph_mesh is not self.face.morph_mesh:
            self.beside.face.share(self.face)
        self._analyse_again()

    def _take_original(self) -> None:
        """Show a recording, or what is said again."""
        if self.text.original.face is None:
            self.performer.play(None)  # until the next tick, where a track has it
        self._name_heads()
        self.changed.emit()

    def _connect(self) -> None:
        session = self.session
        session.analysed.connect(self._take_blocks)
        for follow in (self._close_mouth, self.text.follow_sound, self.expression.forget_voice):
            session.opened.connect(follow)
        session.sought.connect(self._seek)
        session.rewritten.connect(self._seek)
        session.transport_changed.connect(self._hold)
        self.text.known_changed.connect(self._analyse_again)
        self.text.drivers.changed.connect(self._take_drivers)
        self.text.drivers.compared_changed.connect(self._take_compared)
        self.text.original.changed.connect(self._take_original)
        self.face.changed.connect(self._take_face)
        self.expression.changed.connect(self._take_expression)
        self.styles.changed.connect(self._take_style)
        self.pictures.changed.connect(self.changed)
        self.visemes_changed.connect(self._share_visemes)
        self.osc.changed.connect(self._share_visemes)
        for changed in (self.changed, self.text.known_changed, self.expression.changed):
            for made_anew in (self.keys.generate_soon, self.comparison.compare_soon):
                changed.connect(made_anew)
        self.keys.info.connect(self.text.info)
        self.comparison.known_changed.connect(self._analyse_again)
        for part in (self.face, self.osc, self.text, self.expression, self.styles, self.keys, self.comparison):
            part.error.connect(self.error)

    def _take_blocks(self, blocks: list[Analysis]) -> None:
        """Take what was played; once the sound has been stopped, what still arrives of it has no effect."""
        if self.session.source.playing or self.session.source.position or self.session.source.live:
            self._analysed += blocks

    def _share_visemes(self) -> None:
        for performer in (self.osc.performer, self.beside.performer):
            performer.set_phonemes(self.visemes.phonemes, self.visemes.speech)

    def _analyse_again(self) -> None:
        """Give the performers again what is known before it plays."""
        self._last = None
        self._seek()

    def _close_mouth(self) -> None:
        self.text.drivers.network.begin_again()
        self._analysed.clear()
        self._last = None
        for performer in self._performers:
            performer.close_mouth(self._now())

    def _hold(self) -> None:
        """In a pause, keep the shape of what was played last."""
        session, newest = self.session, self.session.history.newest
        if not session.source.live and not session.source.playing and session.source.position and newest is not None:
            self._last, now = None, self._now()
            for performer in self._performers:
                known = self._known_to(performer)
                is_text = session.source.kind is SourceKind.TEXT  # which may stand elsewhere than it was played last
                frames = self._newest_frames(now, known) if is_text else timed_frames(newest, now, known)
                performer.hold(now, frames[-1].phoneme, frames[-1].phone)

    def _seek(self, _column: int = 0) -> None:
        """While nothing plays, hold the pose at the end of what comes before that place."""
        session, now = self.session, self._now()
        self.text.drivers.network.begin_again()
        if session.source.playing:
            for performer in self._performers:
                performer.forget_coming(now)
        elif session.source.position == 0 or session.history.n == 0:
            self._close_mouth()
        else:
            for performer in self._performers:
                performer.jump_to(self._newest_frames(now, self._known_to(performer)), now)

    def _newest_frames(self, now: float, known: Transcript | None) -> list[TimedFrame]:
        """Return what is before the current place, as if it had just been played; what is not known is silence."""
        source, history = self.session.source, self.session.history
        first, last = history.newest_run(FOLLOWED)
        if source.kind is SourceKind.TEXT:  # the history holds what was played last of it, wherever that is
            first, last = (max(0, round(source.position / FRAME_PERIOD) - n) for n in (FOLLOWED, 0))
        at = history.indices_of(first, last)
        if not len(at):
            return [TimedFrame(now - FRAME_PERIOD, Phoneme.SILENCE, 0.0)]
        first = int(history.frames[at[0]])
        rows = zip(history.phonemes[at].tolist(), history.intensities[at].tolist(), strict=True)
        frames = [TimedFrame(now + k * FRAME_PERIOD, Phoneme(row[0]), row[1]) for k, row in enumerate(rows, -len(at))]
        return frames if known is None else known_frames(frames, first, known)

    def _take_expression(self) -> None:
        self.idle = replace(self.idle, expression=self.expression.expression)
        self._configure()
        self.osc.express(self.styles.style.on_idle(self.idle).expression)

    def _take_style(self) -> None:
        self._use_written()
        self.text.drivers.performance.set_style(self.styles.style)

    def _take_face(self) -> None:
        if self.comparing:
            self.beside.face.share(self.face)
        if not self.face.moved_by(self._written) and self.face.tables:
            best = max(self.face.tables, key=self.face.fit_of)
            self.set_table(best)
            if self.face.fit_of(best)[0] < FITTING:
                self.shapes_unknown.emit()
            return
        self._use(self.table)
        if not self.face.moved_by(self.table) and self.face.states is not None:
            if not guess_mapping(self.face.states.names).targets:
                names = ", ".join(self.face.states.names[:4])
                self.error.emit(
                    tr(
                        "No shipped mouth table fits the blend shapes of this face ({names} …); write a mouth table "
                        "for them and load it."
                    ).format(names=names)
                )
            self.shapes_unknown.emit()

    def _take_table(self, name: str, table: MouthTable) -> None:
        if self.face.states is not None and not self.face.moved_by(table):
            self.error.emit(self.face.refusal_of(Path(name).name))
            self.changed.emit()
            return
        self.table_name, self._written = name, table
        self._use_written()
        self.visemes_changed.emit()

    def _use_written(self) -> None:
        written = self._written.with_motion(self.attack_factor, self.release_factor, random=self.random)
        self._use(self.styles.style.on_table(written))

    def _use(self, table: MouthTable, **idle: Any) -> None:
        self.table, self.idle = table, replace(self.idle, **idle)
        self._configure()
        self._name_heads()
        self.changed.emit()

    def _configure(self) -> None:
        """Have all move by the table, with the detail and the life that are chosen."""
        idle = self.styles.style.on_idle(self.idle)
        for head in (self.head, self.beside):
            head.configure(self._table_for(head.performer), idle)
        self.osc.follow(self._table_for(self.osc.performer), idle)

    def _table_for(self, performer: Performer) -> MouthTable:
        """Return the mouth table; for recorded faces with all that they move, for heads by rules with a tongue."""
        track = self._tracks.get(performer)
        if track is None and performer is not self.osc.performer:
            return self.styles.style.with_tongue(self.table)
        recorded = track is not None and track.movestates == FACE
        return replace(self.table, movestates=FACE) if recorded and self.table.movestates == ARKIT else self.table
