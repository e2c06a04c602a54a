"""Clients that lie, err, flood or stall: each is told why in one sentence, and no other one notices."""

import asyncio
import json
import socket
from typing import Any
from urllib.parse import urlsplit

import aiohttp
import numpy as np
import pytest

from phonemeanalyser.server.access import ServerLimits
from phonemeanalyser.server.service import ServerSettings
from tests.server.conftest import FAST
from tests.server.servers import Told, as_s16, cut, run, served, spoken_to, streamed
from tests.sounds import Sound

START = {"encoding": "f32", "rate": 44_100}


def said(server: str, *messages: str | bytes) -> Told:
    """Say something to a stream, and give what it answers."""

    async def say(client: aiohttp.ClientWebSocketResponse) -> None:
        for message in messages:
            await (client.send_str(message) if isinstance(message, str) else client.send_bytes(message))

    return spoken_to(server, say)


@pytest.mark.parametrize(
    ("message", "words"),
    [
        (b"\0\0\0\0", "the first message must say in JSON"),
        ("[]", "must be a JSON object"),
        ("[" * 100_000, "must be a JSON object"),
        ('{"rate": "fast"}', "rate must be a whole number, got 'fast'"),
        ('{"rate": true}', "rate must be a whole number"),
        ('{"rate": 1e4}', "rate must be a whole number"),
        ("{}", "the first message has no rate"),
        ('{"rate": 0}', "must lie in 1000..768000 Hz, got 0"),
        ('{"rate": 1000000000000000000000}', "must lie in 1000..768000 Hz"),
        ('{"rate": 44100, "channels": 0}', "1..8 channels, got 0"),
        ('{"rate": 44100, "encoding": "mp3"}', "there is no encoding 'mp3'; send s16, f32, opus"),
        ('{"rate": 44100, "probabilities": 1}', "probabilities must be true or false, got 1"),
        ('{"rate": 44100, "colour": "red"}', "there is no 'colour' in such a message"),
        ('{"rate": 44100, "text": "hello"}', "the text has no language"),
        ('{"rate": 44100, "text": "hello", "language": "xx-yy"}', "xx-yy"),
        ('{"rate": 44100, "text": "\\ud800", "language": "en-us"}', ""),
        ('{"rate": 44100, "text": "...", "language": "en-us"}', ""),
    ],
)
def test_a_first_message_that_is_nonsense_is_answered_by_a_sentence(
    server: str, message: str | bytes, words: str
) -> None:
    told = said(server, message)
    assert words in told.error
    assert told.code == 1008


@pytest.mark.parametrize(
    ("message", "words"),
    [
        ("more", "must be a JSON object with text, end"),
        ('{"rate": 8000}', "there is no 'rate' in such a message; it may have text, end"),
        ('{"end": "yes"}', "end must be true or false"),
        ('{"text": 7}', "text must be a text, got 7"),
        (np.full(44_100, 3e9, np.float32).tobytes(), "within ±1, found 3e+09"),
    ],
)
def test_a_later_message_that_is_nonsense_ends_the_stream_with_a_sentence(
    server: str, message: str | bytes, words: str
) -> None:
    told = said(server, json.dumps(START), message)
    assert words in told.error
    assert told.code == 1008


def test_what_is_no_number_counts_as_silence_and_is_told(server: str, recording: Sound) -> None:
    where = np.arange(44_100) % 5 == 0
    bad = np.where(where, np.float32(np.nan), recording[:44_100])
    bad[10] = np.inf
    silenced = np.where(where, np.float32(0), recording[:44_100])
    told = streamed(server, START, [bad.tobytes()])
    expected = streamed(server, START, [silenced.tobytes()])
    assert told.code == 1000
    assert told.messages[-1]["silenced"] == where.sum()
    assert "silenced" not in expected.messages[-1]
    assert told.column("phonemes") == expected.column("phonemes")


def test_what_came_before_nonsense_is_still_told(server: str, recording: Sound) -> None:
    told = said(server, json.dumps(START), recording[:44_100].tobytes(), "nonsense")
    assert len(told.column("phonemes")) > 90
    assert "JSON" in told.error


def test_loud_integers_that_are_said_to_be_floats_are_noticed(server: str, recording: Sound) -> None:
    loud = recording / np.abs(recording).max()
    assert "check the format" in said(server, json.dumps(START), as_s16(loud)).error


def test_a_sound_that_ends_amid_a_sample_is_answered_by_a_sentence(server: str) -> None:
    told = said(server, json.dumps(START), bytes(4411), '{"end": true}')
    assert "cut off after 0.025 s" in told.error


def test_text_that_is_not_utf_8_closes_the_stream_with_a_reason(server: str) -> None:
    async def speak() -> tuple[int, str]:
        async with aiohttp.ClientSession() as session, session.ws_connect(f"{server}/stream") as client:
            await client._writer.send_frame(b"\xff\xfe", aiohttp.WSMsgType.TEXT)
            message = await client.receive()
            return message.data, message.extra

    code, reason = run(speak())
    assert code == 1007
    assert "UTF-8" in reason


def test_a_message_that_is_too_large_closes_the_stream_with_a_reason(server: str) -> None:
    async def speak() -> tuple[int, str]:
        async with aiohttp.ClientSession() as session, session.ws_connect(f"{server}/stream") as client:
            await client.send_json(START)
            await client.receive()
            await client.send_bytes(bytes((1 << 20) + 4))
            message = await client.receive()
            return message.data, message.extra

    code, reason = run(speak())
    assert code == 1009
    assert reason == "the message is larger than a stream's may be; send the sound in smaller pieces"


def answer(address: str, path: str, method: str = "GET", **options: Any) -> tuple[int, dict[str, Any]]:
    """Ask over HTTP; gives the status and what is told."""

    async def ask() -> tuple[int, dict[str, Any]]:
        async with aiohttp.ClientSession() as session, session.request(method, address + path, **options) as found:
            return found.status, await found.json()

    return run(ask())


def test_it_tells_what_it_serves(server: str) -> None:
    status, told = answer(server, "/")
    assert status == 200
    assert {"learned", "rhubarb-json", "arkit", "opus"} <= {
        told["preset"].lower(),
        *told["formats"],
        *told["tables"],
        *told["encodings"],
    }


@pytest.mark.parametrize(
    ("path", "method", "status", "words"),
    [
        ("/nowhere", "GET", 404, "GET '/nowhere' is not served"),
        ("/export", "GET", 405, "GET '/export' is not served"),
        ("/stream", "GET", 426, "/stream is a WebSocket"),
        ("/stream", "POST", 405, "POST '/stream' is not served"),
    ],
)
def test_what_is_not_served_is_answered_by_a_sentence(
    server: str, path: str, method: str, status: int, words: str
) -> None:
    found, told = answer(server, path, method)
    assert (found, words in told["error"]) == (status, True)


@pytest.mark.parametrize(
    "words", [b"nonsense\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"\x16\x03\x01" + bytes(100) + b"\r\n\r\n"]
)
def test_what_is_no_http_is_answered_by_a_sentence(server: str, words: bytes) -> None:
    parts = urlsplit(server)
    with socket.create_connection((parts.hostname, parts.port), timeout=60) as client:
        client.sendall(words)
        answered = b"".join(iter(lambda: client.recv(1000), b""))
    assert answered.startswith(b"HTTP/1.0 400 ")
    assert answered.endswith(b'{"error": "this is no request of HTTP/1.1; send one"}')


def test_a_client_that_says_nothing_is_let_go() -> None:
    with served(ServerSettings(port=0, limits=ServerLimits(idle_timeout=1))) as address:
        told = said(address, json.dumps(START))
        assert "nothing came for 1 s" in told.error
        parts = urlsplit(address)
        with socket.create_connection((parts.hostname, parts.port), timeout=60) as silent:
            silent.sendall(b"GET / HTTP/1.1\r\nHost: ")
            assert silent.recv(100) == b""


async def no_streams(session: aiohttp.ClientSession, address: str) -> None:
    """Ask a server until it has no streams any more."""
    while (await (await session.get(address)).json())["streams"]:
        pass


def test_there_are_no_more_streams_than_allowed() -> None:
    async def speak(address: str) -> list[int]:
        stream = f"{address}/stream"
        async with aiohttp.ClientSession() as session:
            codes = []
            async with session.ws_connect(stream):
                with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
                    await session.ws_connect(stream)
                codes.append(refused.value.status)
            await no_streams(session, address)
            async with session.ws_connect(stream) as again:
                await again.send_json(START)
                codes.append(len(await again.receive_json()))
        return codes

    with served(ServerSettings(port=0, limits=ServerLimits(max_streams=1))) as address:
        assert run(speak(address)) == [503, 1]


def test_there_are_no_more_connections_than_allowed() -> None:
    async def speak(address: str) -> tuple[int, dict[str, Any]]:
        async with aiohttp.ClientSession() as session, session.ws_connect(f"{address}/stream"):
            found = await session.get(address)
            return found.status, await found.json()

    with served(ServerSettings(port=0, limits=ServerLimits(max_connections=1))) as address:
        status, told = run(speak(address))
        assert (status, told) == (503, {"error": "there are as many connections as this server takes; try later"})


def test_connections_that_say_nothing_keep_nobody_out() -> None:
    with served(ServerSettings(port=0, limits=ServerLimits(max_connections=8))) as address:
        parts = urlsplit(address)
        silent = [socket.create_connection((parts.hostname, parts.port), timeout=60) for _ in range(30)]
        for client in silent[::2]:
            client.sendall(b"GET / HTTP/1.1\r\nHost: ")
        assert answer(address, "/")[0] == 200
        for client in silent:
            client.close()


def test_an_address_has_no_more_connections_than_one_may_have() -> None:
    async def speak(address: str) -> tuple[int, int]:
        async with aiohttp.ClientSession() as session:
            async with session.ws_connect(f"{address}/stream"), session.ws_connect(f"{address}/stream"):
                refused = (await session.get(address)).status
            while (again := (await session.get(address)).status) == 429:
                pass  # the server has not noticed yet
            return refused, again

    with served(ServerSettings(port=0, limits=ServerLimits(max_per_address=2))) as address:
        assert run(speak(address)) == (429, 200)


def test_a_flood_is_read_no_faster_than_allowed(recording: Sound) -> None:
    seconds = 8.0
    sound = np.resize(recording, round(seconds * 44_100))

    async def flood(address: str) -> float:
        loop = asyncio.get_running_loop()
        async with aiohttp.ClientSession() as session, session.ws_connect(f"{address}/stream") as client:
            await client.send_json(START)
            began = loop.time()
            sending = asyncio.create_task(send(client))
            async for message in client:
                if "end" in json.loads(message.data):
                    break
            await sending
            return loop.time() - began

    async def send(client: aiohttp.ClientWebSocketResponse) -> None:
        for block in cut(sound.tobytes(), [4 * 44_100]):
            await client.send_bytes(block)
        await client.send_json({"end": True})

    with served(ServerSettings(port=0, limits=ServerLimits(max_speed=10))) as address:
        assert run(flood(address)) >= (seconds - 5.0) / 10  # five seconds may come at once


def test_a_client_that_takes_no_answers_is_let_go_and_no_other_one_waits(recording: Sound) -> None:
    data = np.resize(recording, 44_100 * 2).tobytes()

    async def flood(client: aiohttp.ClientWebSocketResponse) -> None:
        while True:
            await client.send_bytes(data)

    async def speak(address: str) -> None:
        async with aiohttp.ClientSession() as session, session.ws_connect(f"{address}/stream") as client:
            await client.send_json(START | {"table": "arkit"})
            client._conn.transport.pause_reading()
            with pytest.raises(ConnectionError):
                await flood(client)

    with served(ServerSettings(port=0, limits=ServerLimits(idle_timeout=1, max_speed=1000))) as address:
        run(speak(address))
        told = streamed(address, START, cut(recording.tobytes(), [4 * 882]))
        assert told.code == 1000


def test_clients_that_vanish_leave_nothing_behind(recording: Sound) -> None:
    async def vanish(address: str) -> None:
        async with aiohttp.ClientSession() as session:
            for _ in range(10):
                client = await session.ws_connect(f"{address}/stream")
                await client.send_json(START)
                await client.send_bytes(recording[:20_000].tobytes())
                client._conn.transport.abort()
            await no_streams(session, address)

    with served(ServerSettings(port=0, limits=FAST)) as address:
        run(vanish(address))
