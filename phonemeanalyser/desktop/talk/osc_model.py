"""The mouth over the network: whether it is sent, and where to."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from PySide6.QtCore import QObject, QTimer, Signal

from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.errors import EngineError
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.osc import OscAddress, OscMouth
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table
from phonemeengine.phonemes import Phoneme

USUAL_ADDRESS = "127.0.0.1:39539"
"""Where VMC programs listen on this computer."""
AS_THE_HEAD = "head"
TABLES = (AS_THE_HEAD, "arkit", "vrm", "oculus")
"""What is sent: what moves the head, or one of the sets of movestates that receivers know."""
CLOSE_TIMEOUT = 2.0
"""Seconds after which the end of the program waits no longer for the network."""
WATCH_MS = 100
"""How often it is looked whether the receiver is still reached."""


class OscModel(QObject):
    """Sends what is heard, or asked for, as OSC messages while it is switched on; nothing here waits for the network.

    Signals
    -------
    changed : switched on or off, or another address or set.
    failed : a sentence for the user; it is switched off then.

    Attributes
    ----------
    address : ``HOST:PORT``, as the user wrote it.
    table : one of `TABLES`.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.address = USUAL_ADDRESS
        self.table = TABLES[0]
        self._head, self._detail = load_table(USUAL_TABLE), Detail.PHONEMES
        self._mouth: OscMouth | None = None
        self._wanted: tuple[str, MouthTable, Detail] | None = None
        self._said = ""
        self._asked: tuple[dict[Phoneme, float], float] = ({}, 1.0)
        self._work = TaskQueue(self._fail)
        self._watch = QTimer(self, interval=WATCH_MS)
        self._watch.timeout.connect(self._look_for_failure)

    @property
    def on(self) -> bool:
        """Whether it is switched on."""
        return self._wanted is not None

    @property
    def words(self) -> str:
        """What is going on, in words."""
        if not self.on:
            return "off"
        if self._mouth is None:
            return "looking for the receiver …"
        if self._mouth.failure:
            return "not reached"
        n = f"{self._mouth.n_sent:,}".replace(",", " ")
        return f"sending, {n} packets"

    def set_on(self, on: bool) -> None:
        """Begin or end to send."""
        self._leave()
        if on:
            self._begin()
        self.changed.emit()

    def set_address(self, text: str) -> None:
        """Send elsewhere."""
        if text.strip() != self.address:
            self.address = text.strip()
            self.set_on(self.on)

    def set_table(self, name: str) -> None:
        """Send the movestates of another set."""
        if name in TABLES and name != self.table:
            self.table = name
            self.set_on(self.on)

    def set_head_table(self, head: MouthTable, detail: Detail) -> None:
        """Move as a head does that is moved by this table, in this detail."""
        if (head, detail) != (self._head, self._detail):
            self._head, self._detail = head, detail
            if self.on:
                self.set_on(True)

    def add_analyses(self, blocks: Sequence[Analysis]) -> None:
        """Send what was heard."""
        if self._mouth is not None:
            for analysis in blocks:
                self._mouth.add_analysis(analysis)

    def ask(self, phonemes: Mapping[Phoneme, float], speech: float) -> None:
        """Send the shapes of these phonemes, 0..1, beside a share of what is heard; of none, what is heard."""
        self._asked = dict(phonemes), speech
        if self._mouth is not None:
            self._mouth.ask(*self._asked)

    def _look_for_failure(self) -> None:
        failure = self._mouth.failure if self._mouth else ""
        if failure and failure != self._said:
            self.error.emit(_sentence(failure))
        self._said = failure

    def close(self) -> None:
        """Close the mouth at the receiver, and stop."""
        self._leave()
        self._work.finish(CLOSE_TIMEOUT)

    def _begin(self) -> None:
        table, detail = self._table_of_receiver(), self._detail
        wanted = self._wanted = (self.address, table, detail)
        try:
            address = OscAddress.of(self.address)
        except EngineError as error:
            self._fail(str(error))
            return
        self._work.submit(
            lambda _progress: OscMouth(address, table, detail=detail), lambda mouth: self._take(wanted, mouth)
        )

    def _table_of_receiver(self) -> MouthTable:
        """Return the table of the head, or another one that moves as the head does."""
        if self.table == AS_THE_HEAD:
            return self._head
        return replace(load_table(self.table), times=self._head.times, manner=self._head.manner)

    def _take(self, wanted: tuple[str, MouthTable, Detail], mouth: OscMouth) -> None:
        """Send with this one, unless something else is wanted by now."""
        if wanted == self._wanted and self._mouth is None:
            self._mouth, self._said = mouth, ""
            self._watch.start()
            mouth.ask(*self._asked)
            self.changed.emit()
        else:
            self._work.submit(lambda _progress: mouth.close())

    def _leave(self) -> None:
        self._wanted = None
        self._watch.stop()
        mouth, self._mouth = self._mouth, None
        if mouth is not None:
            self._work.submit(lambda _progress: mouth.close())

    def _fail(self, sentence: str) -> None:
        self._leave()
        self.error.emit(_sentence(sentence))
        self.changed.emit()


def _sentence(words: str) -> str:
    return f"{words[0].upper()}{words[1:]}."
