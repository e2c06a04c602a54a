"""Whole files over HTTP: a sound comes in, and what `ConversionWork` makes of it goes out.

Each is made in a process of its own: a damaged file, a huge one or a client that has gone takes nothing with it, and
live streams go first.
"""

import asyncio
import contextlib
import json
import logging
import os
import pickle
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import TypeVar

from aiohttp import BodyPartReader, web

from phonemeanalyser.server.access import FAILED, KILOBYTE, MEGABYTE, RefusedError, ServerLimits
from phonemeanalyser.server.file_process import CODE, CRASHED, NO_MEMORY, REFUSED
from phonemeanalyser.server.repertoire import Repertoire
from phonemeengine import FORMATS, EngineError
from phonemeengine.batch.work import Job
from phonemeengine.conversion.options import OPTIONS, SERVED, ConversionOptions
from phonemeengine.conversion.work import ConversionWork

# Whose file is exported: addresses take turns, and a file that takes long gives its place to those that wait.

LONG = 2.0
"""Seconds after which a file takes long: it goes on with the lowest priority, and another one may begin."""
AT_ONCE = 4
"""Files that may have begun for each that is exported at a time: those that take long keep their memory."""


@dataclass(eq=False)
class FileTurn:
    """One file's turn.

    Attributes
    ----------
    address : whose file it is.
    give_way : has its work go on with the lowest priority; what does the work puts it in.
    """

    address: str
    give_way: Callable[[], object] = lambda: None
    begins: asyncio.Event = field(default_factory=asyncio.Event)
    began: float = 0.0
    is_long: bool = False


class FileTurns:
    """Gives files their turns.

    Parameters
    ----------
    most : files at a time, besides those that take long.
    clock : gives seconds.
    """

    def __init__(self, most: int, clock: Callable[[], float] = time.monotonic) -> None:
        self._most, self._clock = most, clock
        self._waiting: list[FileTurn] = []
        self._begun: list[FileTurn] = []
        self._timer: asyncio.TimerHandle | None = None

    @property
    def n_begun(self) -> int:
        """How many files have their turn."""
        return len(self._begun)

    @asynccontextmanager
    async def turn(self, address: str) -> AsyncIterator[FileTurn]:
        """Wait for the turn of a file, which lasts as long as the block."""
        turn = FileTurn(address)
        self._waiting.append(turn)
        self.share()
        try:
            await turn.begins.wait()
            yield turn
        finally:
            (self._begun if turn in self._begun else self._waiting).remove(turn)
            self.share()

    def share(self) -> None:
        """Let files begin for which there is room, those of addresses with the fewest first; do so again soon."""
        if self._waiting:
            self._make_room()
        while (turn := self._next()) is not None:
            self._waiting.remove(turn)
            self._begun.append(turn)
            turn.began = self._clock()
            turn.begins.set()
        if self._timer is not None:
            self._timer.cancel()
        self._timer = asyncio.get_running_loop().call_later(LONG, self.share) if self._waiting else None

    def _make_room(self) -> None:
        for turn in self._begun:
            if not turn.is_long and self._clock() - turn.began >= LONG:
                turn.is_long = True
                turn.give_way()

    def _next(self) -> FileTurn | None:
        """Return the file that begins now; none where there is no room, or who waits has a whole share."""
        n_short = sum(not turn.is_long for turn in self._begun)
        if n_short >= self._most or len(self._begun) >= AT_ONCE * self._most:
            return None
        n_of = Counter(turn.address for turn in self._begun)
        share = (AT_ONCE - 1) * self._most  # so that there is always room for another address
        allowed = [turn for turn in self._waiting if n_of[turn.address] < share]
        return min(allowed, key=lambda turn: n_of[turn.address], default=None)


CHUNK = 1 << 16
SOUND = "sound"
FIELDS = ("format", "preset", *(name for name in SERVED if name != "format"))
"""What may stand beside the sound, each as the option of ``export`` of that name."""
OWN = ("preset", "table")
"""Fields with a name, or the text of a file that the client sends."""
NICE, NICEST = 1, 19
LONGEST_FIELD, LONGEST_PART = 64, 2048
"""Characters of a field other than the text, and of one that may be given several times."""
KINDS = {
    ".json": "application/json",
    ".xml": "application/xml",
    ".csv": "text/csv",
    ".glb": "model/gltf-binary",
    ".tsv": "text/tab-separated-values",
}
"""Media types by the ending of a format; all others are plain text."""
GENTLY = getattr(subprocess, "BELOW_NORMAL_PRIORITY_CLASS", 0)
"""Flags of a process on Windows, so that streams go first; elsewhere there are none."""


_T = TypeVar("_T")
_log = logging.getLogger(__name__)


@dataclass
class FileRequest:
    """What a client asks for.

    Attributes
    ----------
    sound : the file that it sent.
    words : what stood beside it, by the names of `FIELDS`, as often as it was sent.
    """

    sound: Path
    words: dict[str, list[str]] = field(default_factory=dict)

    def options(self, repertoire: Repertoire) -> ConversionOptions:
        """Return what it asks for, of a server with this repertoire.

        Raises
        ------
        EngineError : it asks for what is not there, or sends no sound.
        """
        if not self.sound.exists():
            raise RefusedError(f"there is no sound in the request; send it as the field {SOUND}")
        own = {name: self.words.pop(name)[-1] for name in OWN if name in self.words}
        options = ConversionOptions.of_words({"format": [""]} | self.words)
        files = {name: repertoire.file_told(name, own.get(name, ""), self.sound.parent) for name in OWN}
        table = str(files["table"]) if files["table"] else own.get("table") or None
        return replace(options, preset=files["preset"] or options.preset, table=table)


class FileExporter:
    """Exports files that clients send, a few at a time.

    Parameters
    ----------
    repertoire, limits : of the server.
    """

    def __init__(self, repertoire: Repertoire, limits: ServerLimits) -> None:
        self._repertoire, self._limits = repertoire, limits
        self._turns = FileTurns(limits.max_files)

    @property
    def n_files(self) -> int:
        """How many files are being exported."""
        return self._turns.n_begun

    async def handle(self, request: web.Request, address: str) -> web.StreamResponse:
        """Answer a request of an address.

        Raises
        ------
        RefusedError : it asks for something impossible, or takes too long.
        """
        try:
            async with asyncio.timeout(self._limits.file_timeout):
                with tempfile.TemporaryDirectory(prefix="phonemeanalyser-") as folder:
                    asked = await self._received(request, Path(folder))
                    options = await asyncio.to_thread(asked.options, self._repertoire)
                    options = replace(options, longest=self._limits.max_duration)
                    assert options.format is not None
                    work = partial(ConversionWork.of, options, options.format, sounds=[asked.sound])
                    out = Path(folder) / f"mouth{FORMATS[options.format].ending}"
                    order = pickle.dumps((options.preset, work, Job(asked.sound, out)))
                    async with self._turns.turn(address) as turn:
                        await _make(order, turn, self._limits.max_memory)
                    return await _sent(request, out)
        except RefusedError:
            raise
        except EngineError as error:
            raise RefusedError(str(error)) from error
        except TimeoutError:
            raise RefusedError(
                f"the file took longer than {self._limits.file_timeout:g} s; send a shorter one, or try later", 503
            ) from None

    async def _received(self, request: web.Request, folder: Path) -> FileRequest:
        asked = FileRequest(folder / SOUND)
        if not request.content_type.startswith("multipart/"):
            raise RefusedError(f"send a form (multipart/form-data) with the fields {SOUND}, {', '.join(FIELDS)}", 415)
        try:
            reader = await request.multipart()
            while (part := await self._in_time(reader.next())) is not None:
                if not isinstance(part, BodyPartReader) or part.name not in (SOUND, *FIELDS):
                    raise RefusedError(f"there is no such field; a form has {SOUND}, {', '.join(FIELDS)}")
                if part.name == SOUND:
                    await self._keep(part, asked.sound)
                else:
                    asked.words.setdefault(part.name, []).append(await self._text_of(part))
        except (ValueError, RuntimeError) as error:
            raise RefusedError("the form is damaged or cut off; send it again") from error
        return asked

    async def _in_time(self, coming: Awaitable[_T]) -> _T:
        """Return the next of what the client sends, unless it sends nothing for too long."""
        try:
            async with asyncio.timeout(self._limits.idle_timeout):
                return await coming
        except TimeoutError:
            raise RefusedError(
                f"nothing came for {self._limits.idle_timeout:g} s; send the form at once", 408
            ) from None

    async def _keep(self, part: BodyPartReader, path: Path) -> None:
        n = 0
        with path.open("wb") as file:
            while chunk := await self._in_time(part.read_chunk(CHUNK)):
                n += len(chunk)
                if n > self._limits.max_file * MEGABYTE:
                    raise RefusedError(f"a file may have {self._limits.max_file:g} MB; send a shorter one", 413)
                file.write(chunk)

    async def _text_of(self, part: BodyPartReader) -> str:
        several = part.name in OPTIONS and OPTIONS[part.name].several
        most = LONGEST_PART if several else LONGEST_FIELD
        if part.name in ("text", *OWN):
            own = max(LONGEST_FIELD, int(self._limits.max_own * KILOBYTE))
            most = self._limits.max_text if part.name == "text" else own
        too_long = RefusedError(f"the field {part.name} may have {most} characters; send fewer", 413)
        content = bytearray()
        while chunk := await self._in_time(part.read_chunk(CHUNK)):
            content += chunk
            if len(content) > 4 * most:
                raise too_long
        try:
            words = content.decode()
        except UnicodeDecodeError:
            raise RefusedError(f"the field {part.name} is no text in UTF-8; send it as such") from None
        if len(words) > most:
            raise too_long
        return words


async def _make(order: bytes, turn: FileTurn, memory: float) -> None:
    """Have a process make a file in its turn, with a limit of memory in MB; what it refuses is refused.

    The process is killed once no client waits for it.
    """
    pipe = asyncio.subprocess.PIPE
    process = await asyncio.create_subprocess_exec(
        sys.executable, "-c", CODE, stdin=pipe, stdout=pipe, stderr=pipe, creationflags=GENTLY
    )
    _set_priority(process.pid, NICE)
    limit_memory(process.pid, round(memory * MEGABYTE))
    turn.give_way = partial(_set_priority, process.pid, NICEST)
    try:
        assert process.stdin is not None
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdin.write(order)  # it stays open as long as this process is there
        answer, said = await asyncio.gather(process.stdout.read(), process.stderr.read())
        await process.wait()
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
    check_answer(answer, said.decode(errors="replace"), memory)


def check_answer(answer: bytes, said: str, memory: float) -> None:
    """Refuse what a process could not make.

    Parameters
    ----------
    answer : of the process; nothing where it died.
    said : what it wrote on standard error.
    memory : MB that it had.

    Raises
    ------
    RefusedError : the file was refused, or the process has failed at it.
    """
    state, words = json.loads(answer) if answer else (NO_MEMORY if "MemoryError" in said else CRASHED, said)
    if state == REFUSED:
        raise RefusedError(words)
    if state == NO_MEMORY:
        raise RefusedError(f"the file needs more than {memory:g} MB of memory; send a shorter one", 413)
    if state == CRASHED:
        _log.error("a file could not be exported: %s", words[-2000:])
        raise RefusedError(FAILED, 500)


def _set_priority(process: int, nice: int) -> None:
    if not GENTLY:
        with contextlib.suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, process, nice)


def limit_memory(process: int, most: int) -> None:
    """Limit the data of a process to a number of bytes; only Linux limits other processes."""
    if sys.platform == "linux":
        import resource  # noqa: PLC0415 - it is not there on Windows

        with contextlib.suppress(OSError):
            resource.prlimit(process, resource.RLIMIT_DATA, (most, most))


async def _sent(request: web.Request, path: Path) -> web.StreamResponse:
    """Answer with a file that is there no longer afterwards."""
    answer = web.StreamResponse()
    answer.content_type = KINDS.get(path.suffix, "text/plain")
    answer.content_length = path.stat().st_size
    answer.force_close()
    await answer.prepare(request)
    with path.open("rb") as file:
        while chunk := file.read(CHUNK):
            await answer.write(chunk)
    await answer.write_eof()
    return answer
