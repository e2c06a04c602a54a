"""What the face expresses beside its speech, by sliders, from a recording or by OSC; the mouth is sent so, too."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.errors import EngineError
from phonemeengine.features.feeling import FeelingEstimator
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.expression.felt import FeelingAmounts, TimedFeeling, text_expression
from phonemeengine.mouth.expression.streams import ExpressionStream, expression_presets, held_expression
from phonemeengine.mouth.osc import OscAddress, OscExpression, OscMouth
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion, Performer
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table, tables_by_movestates
from phonemeengine.performance.face_csv import read_expression

NETWORK_TIMEOUT = 2.0
"""Seconds after which the end of the program waits no longer for the network."""


class OscConnection(QObject):
    """Opens and closes in the background, so that nothing waits for the network; subclasses say what in `_connect`.

    Signals
    -------
    changed : switched on or off, or another address.
    error : a sentence for the user.

    Attributes
    ----------
    address : ``HOST:PORT``, as the user wrote it.
    connection : what sends or listens; None where there is nothing.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, address: str) -> None:
        super().__init__()
        self.address = address
        self.connection: Any = None
        self._wanted: OscAddress | None = None
        self._work = TaskQueue(self._fail)

    @property
    def words(self) -> str:
        """What is going on, in words."""
        raise NotImplementedError

    @property
    def active(self) -> bool:
        """Whether messages go out, or come in."""
        raise NotImplementedError

    @property
    def on(self) -> bool:
        """Whether it is switched on."""
        return self._wanted is not None

    def set_on(self, on: bool) -> None:
        """Begin or end."""
        self._leave()
        if on:
            self._begin()
        self.changed.emit()

    def set_address(self, text: str) -> None:
        """Send to, or listen at, another address."""
        if text.strip() != self.address:
            self.address = text.strip()
            self.set_on(self.on)

    def close(self) -> None:
        """End, and wait for it a little."""
        self._leave()
        self._work.finish(NETWORK_TIMEOUT)

    def _connect(self, address: OscAddress) -> Any:
        """Open it, in the background; what comes has `close`."""
        raise NotImplementedError

    def _begin(self) -> None:
        try:
            address = self._wanted = OscAddress.of(self.address)
        except EngineError as error:
            self._fail(str(error))
            return
        self._work.submit(lambda _progress: self._connect(address), lambda opened: self._take(address, opened))

    def _take(self, address: OscAddress, opened: Any) -> None:
        """Use this one, unless something else is wanted by now."""
        if address is self._wanted:
            self.connection = opened
            self.changed.emit()
        else:
            self._work.submit(lambda _progress: opened.close())

    def _leave(self) -> None:
        self._wanted = None
        connection, self.connection = self.connection, None
        if connection is not None:
            self._work.submit(lambda _progress: connection.close())

    def _fail(self, sentence: str) -> None:
        self._leave()
        self._tell(sentence)
        self.changed.emit()

    def _tell(self, sentence: str) -> None:
        self.error.emit(f"{sentence[0].upper()}{sentence[1:]}.")


RECEIVER = "127.0.0.1:39539"
"""Where VMC programs listen on this computer."""
AS_THE_HEAD = "head"
"""Stands for the table that moves the head."""


class OscModel(OscConnection):
    """Sends what its performer shows, as OSC messages, while it is switched on; nothing here waits for the network.

    Parameters
    ----------
    clock : the clock of the performer's times, seconds.

    Attributes
    ----------
    table : which of the `tables` a receiver is sent.
    performer : says what the head says, with the movestates of the receiver.
    """

    _lost = Signal(str)

    def __init__(self, clock: Callable[[], float]) -> None:
        super().__init__(RECEIVER)
        self.table = AS_THE_HEAD
        self._clock = clock
        self._head_table = load_table(USUAL_TABLE)
        self._own_table: MouthTable | None = None
        self.performer = Performer(self._head_table, MOUTH_ALONE)
        self._idle = self.performer.idle
        self._expression: Expression | None = None
        self._lost.connect(self._tell, Qt.ConnectionType.QueuedConnection)

    @cached_property
    def tables(self) -> dict[str, str]:
        """What a receiver may be sent, by name, with what people call it: the head's table, or another one.

        It is read when the panel is first shown, from the files of all tables.
        """
        return {AS_THE_HEAD: tr("Same as the head"), **tables_by_movestates()}

    @property
    def _mouth(self) -> OscMouth | None:
        mouth: OscMouth | None = self.connection
        return mouth

    @property
    @override
    def active(self) -> bool:
        return self._mouth is not None and not self._mouth.failure

    @property
    @override
    def words(self) -> str:
        if not self.on:
            return tr("Off")
        if self._mouth is None:
            return tr("Looking for the receiver…")
        if self._mouth.failure:
            return tr("Receiver not reached")
        n = f"{self._mouth.n_sent:,}".replace(",", " ")
        return tr("Sending: {n} packets").format(n=n)

    def set_table(self, name: str) -> None:
        """Send the movestates of another set."""
        if name != self.table and name in self.tables:
            self.table = name
            self._own_table = None if name == AS_THE_HEAD else load_table(name)
            self.follow(self._head_table, self._idle)
            self.changed.emit()

    def follow(self, head: MouthTable, idle: IdleMotion) -> None:
        """Move as a head does that is moved by this table, and does this besides."""
        self._head_table, self._idle = head, idle
        table = replace(self._own_table or head, times=head.times, phone_times=head.phone_times, motion=head.motion)
        self.performer.configure(table, replace(idle, expression=self._expression))

    def express(self, expression: Expression | None) -> None:
        """Express this beside the speech, where the receiver has the blend shapes of ARKit."""
        self._expression = expression
        self.follow(self._head_table, self._idle)

    @override
    def _connect(self, address: OscAddress) -> OscMouth:
        return OscMouth(address, self.performer, clock=self._clock, on_failure=self._lost.emit)


SENDER = "127.0.0.1:39540"
"""Where VMC programs send faces to on this computer."""


class ExpressionInput(OscConnection):
    """Listens for expressions by OSC while it is switched on; nothing here waits for the network."""

    def __init__(self) -> None:
        super().__init__(SENDER)

    @property
    def stream(self) -> OscExpression | None:
        """What is received; None while it does not listen."""
        stream: OscExpression | None = self.connection
        return stream

    @property
    @override
    def words(self) -> str:
        if self.stream is None:
            return tr("Off") if not self.on else tr("Opening…")
        names = self.stream.names
        if not names:
            return tr("The sender has stopped") if self.stream.stopped else tr("Waiting for messages")
        if len(names) == 1:
            return tr("Receiving {name}").format(name=names[0])
        return tr("Receiving {name} and {n} more").format(name=names[0], n=len(names) - 1)

    @property
    @override
    def active(self) -> bool:
        return self.stream is not None and bool(self.stream.names)

    @override
    def _connect(self, address: OscAddress) -> OscExpression:
        return OscExpression(address)


USUAL_PRIORITY = 0.5
"""Each has all that it asks for."""


@dataclass(eq=False)
class StreamInStep:
    """A recorded expression whose time 0 is the beginning of the sound.

    Attributes
    ----------
    stream : the recording.
    start : when the sound began, on the view's clock, seconds.
    """

    stream: ExpressionStream
    start: float = 0.0

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time on the clock, float32, shape (52,)."""
        return self.stream.weights(time - self.start)


class ExpressionModel(QObject):
    """Knows what is asked for, and how much of their channels speech has.

    Signals
    -------
    changed : the expression is another one, or where it comes from.
    error : a sentence for the user.

    Attributes
    ----------
    shares : how far each is asked for, by name, 0..1.
    priority : of speech on its own channels, 0..1.
    feeling : how far brows, lids, smile and head follow the feeling in the voice, 0..1 each, by name.
    text_feeling : how far the face shows what the text says of feeling, 0..1.
    path : the recording in use; None for none.
    input : what other programs send.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.shares: dict[str, float] = dict.fromkeys(expression_presets(), 0.0)
        self.priority = USUAL_PRIORITY
        self.feeling: dict[str, float] = asdict(FeelingAmounts(0.0, 0.0, 0.0, 0.0))
        self.text_feeling = 0.0
        self._timed: tuple[TimedFeeling, ...] = ()
        self._text: StreamInStep | None = None
        self.path: Path | None = None
        self.input = ExpressionInput()
        self._recorded: StreamInStep | None = None
        self._voice = FeelingEstimator()
        self._work = TaskQueue(self.error.emit)
        self.input.changed.connect(self.changed)
        self.input.error.connect(self.error)

    @property
    def expression(self) -> Expression | None:
        """What is expressed; None for nothing."""
        return self._of(self._recorded, self._text, self.input.stream)

    @property
    def exported(self) -> Expression | None:
        """The same for a file: recordings begin with its sound, and its text tells the feeling itself.

        What other programs send now is not in it.
        """
        return self._of(None if self._recorded is None else self._recorded.stream)

    @property
    def of_sound(self) -> Expression | None:
        """The same for what is generated of the current sound, with what its text says of feeling."""
        return self._of(*(part.stream for part in (self._recorded, self._text) if part is not None))

    def _of(self, *more: ExpressionStream | None) -> Expression | None:
        asked = {name: share for name, share in self.shares.items() if share}
        held = held_expression(asked) if asked else None
        streams = tuple(stream for stream in (held, *more) if stream is not None)
        feeling = FeelingAmounts(**self.feeling)
        if not (streams or feeling):
            return None
        return Expression(streams, None if self.priority == USUAL_PRIORITY else self.priority, feeling=feeling)

    def set_share(self, name: str, share: float) -> None:
        """Ask for an expression, 0..1."""
        if name in self.shares and self.shares[name] != min(max(share, 0.0), 1.0):
            self.shares[name] = min(max(share, 0.0), 1.0)
            self.changed.emit()

    def set_feeling(self, part: str, amount: float) -> None:
        """Have a part of the face follow the feeling in the voice so far, 0..1."""
        if self.feeling[part] != min(max(amount, 0.0), 1.0):
            self.feeling = self.feeling | {part: min(max(amount, 0.0), 1.0)}
            self.changed.emit()

    def set_text_feeling(self, amount: float) -> None:
        """Show what the text says of feeling so far, 0..1."""
        if self.text_feeling != min(max(amount, 0.0), 1.0):
            self.text_feeling = min(max(amount, 0.0), 1.0)
            self.take_text(self._timed)
            self.changed.emit()

    def take_text(self, timed: tuple[TimedFeeling, ...]) -> None:
        """Take what the text of the current sound says of feeling."""
        before, self._timed = self._text, timed
        start = before.start if before is not None else 0.0
        shown = self.text_feeling > 0 and bool(timed)
        self._text = StreamInStep(text_expression(timed, self.text_feeling), start) if shown else None
        if before is not None or shown:
            self.changed.emit()

    @property
    def in_step(self) -> bool:
        """Whether something that is shown goes with the time of the sound."""
        return self._recorded is not None or self._text is not None

    def set_priority(self, priority: float) -> None:
        """Give speech so much of its own channels, 0..1; the expression has the rest."""
        if self.priority != min(max(priority, 0.0), 1.0):
            self.priority = min(max(priority, 0.0), 1.0)
            self.changed.emit()

    def set_file(self, path: Path | None) -> None:
        """Show what was recorded, too, from the beginning of the current sound on; None for nothing recorded."""
        if path is None:
            self._take(None, None)
        else:
            self._work.replace(
                lambda _progress: read_expression(path), lambda stream: self._take(path, StreamInStep(stream))
            )

    def forget_voice(self) -> None:
        """Learn the habits of another speaker: another sound is open."""
        self._voice = FeelingEstimator()

    def feel(self, sound: Sequence[tuple[float, Analysis]], performers: Iterable[Performer]) -> None:
        """Tell faces how the voice sounds in the next blocks, each with when it ends, as far as one follows that."""
        if any(self.feeling.values()):
            felt = [(end, self._voice.follow(block.frames.windows)) for end, block in sound]
            for performer in performers:
                for end, feelings in felt:
                    performer.feel(feelings, end)

    def follow(self, start: float) -> None:
        """Take note when the current sound began, on the clock of the view of the face, seconds."""
        for stream in (self._recorded, self._text):
            if stream is not None:
                stream.start = start

    def clear(self) -> None:
        """Set all sliders back."""
        if any((*self.shares.values(), *self.feeling.values(), self.text_feeling)):
            self.text_feeling = 0.0
            self.take_text(self._timed)
            self.shares = dict.fromkeys(self.shares, 0.0)
            self.feeling = dict.fromkeys(self.feeling, 0.0)
            self.changed.emit()

    def close(self) -> None:
        """Listen no more."""
        self.input.close()
        self._work.close(CLOSE_TIMEOUT)

    def _take(self, path: Path | None, recorded: StreamInStep | None) -> None:
        self.path, self._recorded = path, recorded
        self.changed.emit()
