"""Clients that vanish, flood, lie and stall, one after the other every second, until they are killed."""

import asyncio
import sys
from contextlib import suppress
from itertools import cycle

import aiohttp
import numpy as np


async def _disturb(session: aiohttp.ClientSession, address: str) -> None:
    """Have a client behave badly every second."""
    held: list[asyncio.Task[None]] = []
    for act in cycle((_vanish, _flood, _lie, _stall, _flood_with_crumbs)):
        held = [task for task in held if not task.done()]
        held.append(asyncio.create_task(act(session, address)))
        await asyncio.sleep(1)


async def _vanish(session: aiohttp.ClientSession, address: str) -> None:
    with suppress(aiohttp.ClientError, ConnectionError):
        socket = await session.ws_connect(f"{address}/stream")
        await socket.send_json({"rate": 16_000, "table": "arkit"})
        await socket.send_bytes(bytes(10_000))
        socket._response.connection.transport.abort()


async def _flood(session: aiohttp.ClientSession, address: str) -> None:
    """Send sound as fast as it is taken, for a second."""
    with suppress(aiohttp.ClientError, ConnectionError, TimeoutError):
        async with session.ws_connect(f"{address}/stream") as socket, asyncio.timeout(1):
            await socket.send_json({"rate": 48_000})
            while True:
                await socket.send_bytes(bytes(1 << 16))


async def _flood_with_crumbs(session: aiohttp.ClientSession, address: str) -> None:
    """Send a sample at a time as fast as they are taken, for a second."""
    with suppress(aiohttp.ClientError, ConnectionError, TimeoutError):
        async with session.ws_connect(f"{address}/stream") as socket, asyncio.timeout(1):
            await socket.send_json({"rate": 48_000})
            while True:
                await socket.send_bytes(bytes(2))


async def _lie(session: aiohttp.ClientSession, address: str) -> None:
    with suppress(aiohttp.ClientError, ConnectionError):
        async with session.ws_connect(f"{address}/stream") as socket:
            await socket.send_json({"rate": 48_000, "encoding": "f32"})
            await socket.send_bytes(np.full(1000, np.nan, np.float32).tobytes())
            async for message in socket:
                message.json()


async def _stall(session: aiohttp.ClientSession, address: str) -> None:
    """Send sound as it is spoken, and take no answers, for a while."""
    with suppress(aiohttp.ClientError, ConnectionError, TimeoutError):
        async with session.ws_connect(f"{address}/stream") as socket, asyncio.timeout(10):
            socket._response.connection.transport.pause_reading()
            await socket.send_json({"rate": 8000, "table": "arkit"})
            while True:
                await socket.send_bytes(bytes(1600))
                await asyncio.sleep(0.02)


async def _main(address: str) -> None:
    async with aiohttp.ClientSession() as session:
        await _disturb(session, address)


if __name__ == "__main__":
    asyncio.run(_main(sys.argv[1]))
