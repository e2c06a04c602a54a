"""Many live streams at once against a server of their own, and the latency of each frame.

The server is a process on two cores. A client plays a recording into every stream as a microphone would, a block
every 20 ms, each stream at its own time, and stamps what goes out and what comes back. A frame is late by what passes
from the sending of its last sample to the arrival of its phoneme.
"""

import argparse
import asyncio
import json
import os
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import aiohttp
import numpy as np

from phonemeengine.audio.resampling import resample_whole
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE
from tools.bench.figures import ROOT, child_environment, speech

BLOCK = 0.02
"""Seconds of sound that are sent at once."""
MOST_LATE = 0.1
"""Seconds by which no frame may be late, of fifty streams at once."""
SETTLED = 2.0
"""Seconds at the beginning of which nothing is counted: everybody connects at once."""


@dataclass(frozen=True)
class Load:
    """What was seen.

    Attributes
    ----------
    late : latencies of frames, seconds, sorted.
    n_missing : frames that were not answered at all.
    share : of a core, which the server took.
    megabytes : of memory that the server held, each second.
    models : by what frames were recognised, and how many.
    held_up : the longest time for which the machine, or its own work, kept the client from looking, seconds.
    """

    late: np.ndarray
    n_missing: int
    share: float
    megabytes: Sequence[float]
    models: Counter[str]
    held_up: float

    @property
    def n_late(self) -> int:
        """Frames that were later than any should be."""
        return int(np.count_nonzero(self.late > MOST_LATE))

    @property
    def shares(self) -> str:
        """By what frames were recognised, in words."""
        return ", ".join(f"{n / self.models.total():.0%} by {model}" for model, n in self.models.most_common())

    @property
    def words(self) -> str:
        """All of it in a line."""
        middle, high, most = (1000 * float(np.quantile(self.late, q)) for q in (0.5, 0.99, 1.0))
        return (
            f"{len(self.late)} frames: median {middle:.0f} ms, p99 {high:.0f} ms, most {most:.0f} ms; "
            f"{self.n_late} too late, {self.n_missing} missing; "
            f"{self.shares}; {self.share:.1%} of a core, "
            f"{self.megabytes[0]:.0f} to {self.megabytes[-1]:.0f} MB; "
            f"the client was held up {1000 * self.held_up:.0f} ms at most"
        )


class StreamServer:
    """A server in a process of its own, on two cores."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self._process = process
        assert process.stdout is not None
        self.address = process.stdout.readline().split()[1].strip(",")

    @property
    def processor(self) -> float:
        """Time of all its threads, seconds."""
        fields = Path(f"/proc/{self._process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    @property
    def megabytes(self) -> float:
        """Memory that it holds now."""
        lines = Path(f"/proc/{self._process.pid}/status").read_text().splitlines()
        return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1024


@contextmanager
def stream_server(preset: str) -> Iterator[StreamServer]:
    """Serve meanwhile."""
    cores = ",".join(map(str, sorted(os.sched_getaffinity(0))[-2:]))
    words = [sys.executable, "-m", "phonemeanalyser", "serve", "--port", "0", "--preset", preset]
    process = subprocess.Popen(
        ["taskset", "-c", cores, *words],
        env=child_environment() | {"OPENBLAS_NUM_THREADS": "1"},
        cwd=ROOT,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        yield StreamServer(process)
    finally:
        process.terminate()
        process.wait(10)


def loaded(
    n_streams: int,
    seconds: float,
    preset: str = "learned",
    rate: int = 24_000,
    *,
    table: str = "",
    disturbed: bool = False,
) -> Load:
    """Run a number of streams for a time; disturbed, beside clients that lie, flood, stall and vanish.

    With a mouth table, they ask for its weights, and for all probabilities.
    """
    start = {"rate": rate} | ({"table": table, "probabilities": True} if table else {})
    sound = resample_whole(speech(30.0), SAMPLE_RATE, rate)
    data = np.rint(np.clip(sound, -1, 1) * 32_767).astype("<i2").tobytes()
    with stream_server(preset) as server:
        words = ["nice", "-n", "30", sys.executable, "-m", "tools.bench.bad_clients", server.address]
        bad = subprocess.Popen(words, cwd=ROOT, env=child_environment()) if disturbed else None
        try:
            return asyncio.run(_load(server, data, n_streams, seconds, start))
        finally:
            if bad is not None:
                bad.kill()
                bad.wait()


async def _load(server: StreamServer, data: bytes, n_streams: int, seconds: float, start: dict[str, Any]) -> Load:
    megabytes: list[float] = []
    lags, share = [0.0], 0.0
    async with aiohttp.ClientSession() as session:
        streams = [
            asyncio.create_task(_stream(session, server.address, data, k / n_streams, seconds, start))
            for k in range(n_streams)
        ]
        await asyncio.sleep(SETTLED)
        beating = asyncio.create_task(_beat(lags))
        began, spent = time.monotonic(), server.processor
        while not all(stream.done() for stream in streams):
            megabytes.append(server.megabytes)
            await asyncio.sleep(1)
            if time.monotonic() - began < seconds - SETTLED - 1:
                share = (server.processor - spent) / (time.monotonic() - began)
        beating.cancel()
        found = [stream.result() for stream in streams]
    lates, missing, models = zip(*found, strict=True)
    every = sum(models, Counter())
    return Load(np.sort(np.concatenate(lates)), sum(missing), share, megabytes, every, lags[0])


async def _beat(lags: list[float]) -> None:
    """Note the longest delay with which the client itself wakes."""
    while True:
        due = time.monotonic() + BLOCK
        await asyncio.sleep(BLOCK)
        lag = time.monotonic() - due
        lags[0] = max(lags[0], lag)


async def _stream(
    session: aiohttp.ClientSession, address: str, data: bytes, phase: float, seconds: float, start: dict[str, Any]
) -> tuple[np.ndarray, int, Counter[str]]:
    """Play into one stream; return the latencies of frames, how many had no answer, and what named them."""
    n_blocks, size = round(seconds / BLOCK), round(start["rate"] * BLOCK) * 2
    sent, late = np.zeros(n_blocks), []
    async with session.ws_connect(f"{address}/stream", compress=0) as socket:
        await socket.send_json(start)

        async def play() -> None:
            await asyncio.sleep(phase)
            began = time.monotonic()
            for k in range(n_blocks):
                await asyncio.sleep(max(0.0, began + k * BLOCK - time.monotonic()))
                at = (round(phase * 1000) * size + k * size) % (len(data) - size)
                sent[k] = time.monotonic()
                await socket.send_bytes(data[at - at % 2 : at - at % 2 + size])
            await socket.send_json({"end": True})

        playing = asyncio.create_task(play())
        n, model, models = 0, "", Counter[str]()
        async for message in socket:
            now, told = time.monotonic(), json.loads(message.data)
            if "error" in told:
                raise RuntimeError(told["error"])
            model = told.get("ready", told).get("recogniser", model)
            models[model] += len(told.get("phonemes", ()))
            for _ in told.get("phonemes", ()):
                n += 1
                block = min(n_blocks - 1, int(np.ceil(n * FRAME_PERIOD / BLOCK - 1e-9)) - 1)
                late.append(now - sent[block])
        await playing
    first = round(SETTLED / FRAME_PERIOD)
    return np.array(late[first:]), round(seconds / FRAME_PERIOD) - n, models


def main() -> None:
    """Print what was seen."""
    parser = argparse.ArgumentParser(prog="python -m tools.bench.stream_load", description=__doc__)
    parser.add_argument("--streams", type=int, default=50)
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--preset", default="learned")
    parser.add_argument("--rate", type=int, default=24_000)
    parser.add_argument("--table", default="", help="mouth table whose weights are asked for, and all probabilities")
    parser.add_argument("--disturbed", action="store_true", help="beside clients that lie, flood, stall and vanish")
    options = parser.parse_args()
    asked = {"table": options.table, "disturbed": options.disturbed}
    load = loaded(options.streams, options.seconds, options.preset, options.rate, **asked)
    print(load.words)


if __name__ == "__main__":
    main()
