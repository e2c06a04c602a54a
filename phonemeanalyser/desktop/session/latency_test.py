"""The measurement of latency by clicks, while the window stays alive."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.audio.devices import InputChoice
from phonemeengine.errors import EngineError
from phonemeengine.live.loopback import Loopback


class LatencyTest(QObject):
    """Plays clicks and listens for them.

    Parameters
    ----------
    cards : what lets sound cards go; some serve one stream at a time, so it is measured after that.
    measure : plays the clicks.

    Signals
    -------
    info : a sentence about what was measured.
    error : a sentence about why nothing was.
    ended : it is over; `result` is what was measured last.
    """

    info = Signal(str)
    error = Signal(str)
    ended = Signal()

    def __init__(self, cards: TaskQueue, measure: Callable[[InputChoice], Loopback]) -> None:
        super().__init__()
        self.result: Loopback | None = None
        self.running = False
        self._cards = cards
        self._measure = measure

    def begin(self, choice: InputChoice) -> None:
        """Measure as soon as the cards are free."""
        self.running = True
        self._cards.submit(lambda _progress: self._measured(choice), self._take)

    def _measured(self, choice: InputChoice) -> Loopback | EngineError:
        try:
            return self._measure(choice)
        except EngineError as error:
            return error

    def _take(self, found: Loopback | EngineError) -> None:
        self.running = False
        if isinstance(found, Loopback):
            self.result = found
            self.info.emit(_sentence_of(found))
        else:
            self.error.emit(tr("The latency was not measured: {why}.").format(why=tr_engine(str(found))))
        self.ended.emit()


def _sentence_of(found: Loopback) -> str:
    share = tr("{ms:.0f} ms of it are the microphone's, and the status line now counts with them").format(
        ms=1000 * found.capture
    )
    if not found.capture:
        share = tr("the card does not tell which part of it is the microphone's")
    return tr(
        "A click comes back after {ms:.0f} ms ({n_heard} of {n_played} "
        "heard, within {spread:.0f} ms of each other); {share}."
    ).format(
        ms=1000 * found.round_trip,
        n_heard=found.n_heard,
        n_played=found.n_played,
        spread=1000 * found.spread,
        share=share,
    )
