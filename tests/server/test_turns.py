"""Streams take turns: each is heard a little at a time, and what fails in one stops no other."""

import asyncio
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from phonemeanalyser.server.files import FileTurns
from phonemeanalyser.server.session import Pace
from phonemeanalyser.server.turns import (
    AT_FIRST,
    HALVED,
    LATE,
    LATE_FOR,
    MANY,
    ONE_MORE,
    ONE_MORE_LATER,
    EncoderQuota,
    Turns,
)
from phonemeengine import EngineError, GrownWords, load_preset, words_of
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.incoming import Encoding, StreamFormat
from phonemeengine.live.incoming_speech import IncomingSpeech, RecognisedPiece
from tests.waiting import come_to

THESIS = load_preset("thesis")


class Stream:
    """Hears silence, a piece a turn."""

    def __init__(self, n_pieces: int, fault: str = "", *, with_text: bool = False) -> None:
        self.speech = IncomingSpeech(THESIS, StreamFormat(Encoding.F32), with_text=with_text)
        if with_text:
            self.speech.add_words(words_of("hello", "en-us"))
        self.n_pieces, self.fault = n_pieces, fault
        self.n_frames = self.n_looks = 0
        self.error: EngineError | None = None

    def use_encoder(self, *, on: bool) -> None:
        self.speech.use_encoder(on=on)

    def next_piece(self) -> Float32Array | None:
        if self.fault == "piece":
            raise ZeroDivisionError
        if not self.n_pieces or self.error:
            return None
        self.n_pieces -= 1
        return np.zeros(4410, np.float32)

    def tell(self, heard: RecognisedPiece) -> None:
        if self.fault == "tell":
            raise ZeroDivisionError
        self.n_frames += len(heard.analysis)

    def tell_words(self, words: GrownWords) -> None:
        self.n_looks += 1

    def fail(self, error: EngineError) -> None:
        self.error = error


def taken(*streams: Stream, **options: Any) -> None:
    """Have streams take turns until nothing waits."""

    async def take() -> None:
        turns = Turns(**options)
        for stream in streams:
            turns.join(stream)
        turns.wake()
        await come_to(lambda: not turns._is_planned)

    asyncio.run(take())


def test_all_that_waits_is_heard() -> None:
    streams = Stream(5), Stream(1), Stream(0)
    taken(*streams)
    assert [stream.n_frames for stream in streams] == [48, 8, 0]


def test_two_halves_of_many_streams_alternate_and_all_are_heard() -> None:
    order: list[int] = []

    class Noted(Stream):
        def tell(self, heard: RecognisedPiece) -> None:
            order.append(id(self))

    taken(*(Noted(2) for _ in range(HALVED)))
    first, second, *others = (set(order[k : k + HALVED // 2]) for k in range(0, 2 * HALVED, HALVED // 2))
    assert not first & second
    assert others == [first, second]


def test_slowly_more_streams_may_have_the_encoder_and_half_as_many_while_turns_are_late() -> None:
    now = [0.0]
    quota = EncoderQuota(lambda: now[0])

    def after(seconds: float, late: float, n: int) -> int:
        now[0] += seconds
        return quota.after(late, n)

    few = AT_FIRST - 1
    assert [after(1.1 * ONE_MORE, LATE, n) for n in (few, few, AT_FIRST, AT_FIRST + 1)] == [
        *(AT_FIRST, AT_FIRST, AT_FIRST + 1, AT_FIRST + 2)  # no more than can be tried
    ]
    assert after(0.0, 2 * LATE, 50) == AT_FIRST + 2  # once is no load
    assert after(0.0, LATE, 50) == AT_FIRST + 2
    assert after(900.0, 2 * LATE, 50) == AT_FIRST + 2  # nor is once more
    assert [after(1.1 * LATE_FOR, 2 * LATE, n) for n in (50, 25, 12)] == [25, 12, 6]
    assert after(LATE_FOR / 2, 2 * LATE, 6) == 6  # they have not helped yet
    assert after(2 * ONE_MORE, LATE, 6) == 6
    assert [after(1.1 * ONE_MORE_LATER, 0.0, n) for n in (6, 7, 8)] == [7, 8, 9]


def test_the_oldest_streams_have_the_encoder() -> None:
    class Changing(EncoderQuota):
        allowed = iter([MANY - 2, MANY - 2, *([MANY - 1] * 100)])

        def after(self, late: float, n: int) -> int:
            return next(self.allowed)

    known: list[list[bool]] = []

    class Noted(Stream):
        def tell(self, heard: RecognisedPiece) -> None:
            super().tell(heard)
            known.append([stream.speech.has_encoder for stream in streams])

    streams = [Noted(4) for _ in range(MANY)]
    for stream in streams:
        stream.speech = IncomingSpeech(load_preset("learned"), StreamFormat(Encoding.F32))
    taken(*streams, quota=Changing())
    assert known[0] == known[2 * MANY - 1] == (MANY - 2) * [True] + 2 * [False]
    assert known[-1] == (MANY - 1) * [True] + [False]
    assert {stream.n_frames for stream in streams} <= {36, 37, 38}


def test_words_are_looked_for_in_all_streams_while_there_is_little_time() -> None:
    streams = [Stream(20, with_text=True) for _ in range(3)]
    taken(*streams, looking=0.0)  # one look a turn
    assert all(4 <= stream.n_looks <= 7 for stream in streams)
    assert all(stream.speech.n_unlooked < 60 for stream in streams)


@pytest.mark.parametrize("fault", ["piece", "tell"])
def test_a_bug_in_one_stream_stops_no_other(fault: str, caplog: pytest.LogCaptureFixture) -> None:
    broken, whole = Stream(3, fault), Stream(3)
    taken(broken, whole)
    assert "the server has failed at this" in str(broken.error)
    assert (whole.n_frames, whole.error) == (28, None)
    assert "ZeroDivisionError" in caplog.text


def test_a_bug_in_hearing_is_told_to_those_who_were_heard(caplog: pytest.LogCaptureFixture) -> None:
    stream = Stream(1)
    stream.speech = SimpleNamespace(may_have_encoder=False, has_encoder=False)  # type: ignore[assignment]
    taken(stream)
    assert "the server has failed at this" in str(stream.error)
    assert "AttributeError" in caplog.text


def test_a_pace_lets_some_come_at_once_and_then_so_much_a_second() -> None:
    now = [0.0]
    pace = Pace(4.0, 5.0, lambda: now[0])
    assert pace.wait_after(5.0) == 0
    assert pace.wait_after(2.0) == 0.5
    now[0] = 0.5
    assert pace.wait_after(0.0) == 0
    assert pace.wait_after(1.0) == 0.25
    now[0] = 1000.0
    assert pace.wait_after(5.0) == 0
    assert pace.wait_after(0.4) == pytest.approx(0.1)


class Files:
    """Files that clients want exported, at a time that is moved by hand."""

    def __init__(self, most: int) -> None:
        self.now = 0.0
        self.turns = FileTurns(most, lambda: self.now)
        self.begun: list[str] = []
        self.gave_way: list[str] = []
        self.tasks: list[asyncio.Task[None]] = []
        self._ends: dict[str, asyncio.Event] = {}

    async def export(self, name: str) -> None:
        """Export a file, whose name begins with its address."""
        self._ends[name] = asyncio.Event()
        async with self.turns.turn(name[0]) as turn:
            turn.give_way = lambda: self.gave_way.append(name)
            self.begun.append(name)
            await self._ends[name].wait()

    async def begin(self, *names: str) -> None:
        """Have files wait for their turn, in this order."""
        self.tasks += [asyncio.create_task(self.export(name)) for name in names]
        await self.go_on()

    async def end(self, name: str) -> None:
        self._ends[name].set()
        await self.go_on()

    async def go_on(self, seconds: float = 0.0) -> None:
        self.now += seconds
        self.turns.share()
        for _ in range(5):  # until all that may begin has begun
            await asyncio.sleep(0)


def test_a_file_that_takes_long_keeps_no_other_one_waiting() -> None:
    async def act() -> None:
        files = Files(1)
        await files.begin("a long", "b short")
        assert files.begun == ["a long"]
        await files.go_on(1.0)
        assert (files.begun, files.gave_way) == (["a long"], [])
        await files.go_on(1.0)
        assert (files.begun, files.gave_way) == (["a long", "b short"], ["a long"])
        await files.end("b short")
        await files.begin("b next")
        assert files.begun[-1] == "b next"

    asyncio.run(act())


def test_alone_a_file_gives_way_to_nobody() -> None:
    async def act() -> None:
        files = Files(1)
        await files.begin("a")
        await files.go_on(100.0)
        assert files.gave_way == []
        await files.begin("b")
        assert (files.begun, files.gave_way) == (["a", "b"], ["a"])

    asyncio.run(act())


def test_addresses_take_turns_and_none_takes_all_places() -> None:
    async def act() -> None:
        files = Files(1)
        await files.begin(*(f"a{k}" for k in range(9)), "b0")
        await files.end("a0")
        assert files.begun == ["a0", "a1"]  # a has none any more, and came first
        for _ in range(9):
            await files.go_on(2.0)
        assert files.begun == ["a0", "a1", "b0", "a2", "a3"]  # four at once: those that take long keep their memory
        await files.end("b0")
        await files.go_on(2.0)
        assert files.begun[-1] == "a3"  # the last place is for others
        await files.begin("c0")
        assert files.begun[-1] == "c0"

    asyncio.run(act())


def test_who_goes_while_waiting_leaves_the_turn_to_others() -> None:
    async def act() -> None:
        files = Files(1)
        await files.begin("a", "b", "c")
        files.tasks[1].cancel()
        await files.end("a")
        assert files.begun == ["a", "c"]

    asyncio.run(act())
