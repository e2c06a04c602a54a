"""Whole files over HTTP: what the command line writes, and sentences for what it refuses."""

import asyncio
import io
import json
import os
import pickle
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path
from typing import Any

import aiohttp
import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeanalyser.server.access import FAILED, RefusedError, ServerLimits
from phonemeanalyser.server.file_process import CODE
from phonemeanalyser.server.files import check_answer, limit_memory
from phonemeanalyser.server.service import ServerSettings
from phonemeengine.batch.work import Job
from phonemeengine.presets.files import DEFAULT_PRESET
from tests.disks import watched
from tests.fakes.batch_works import CopyWork
from tests.server.conftest import RECORDING
from tests.server.servers import run, served

SOUND = RECORDING.read_bytes()


def exported(address: str, sound: bytes | None = SOUND, **fields: str | bytes | list[str]) -> tuple[int, str, bytes]:
    """Send a form, fields of several values several times; gives status, kind and content of the answer."""

    async def ask() -> tuple[int, str, bytes]:
        form = aiohttp.FormData(default_to_multipart=True)
        for name, value in fields.items():
            for each in value if isinstance(value, list) else [value]:
                form.add_field(name, io.BytesIO(each) if isinstance(each, bytes) else each)
        if sound is not None:
            form.add_field("sound", sound, filename="../../etc/line.flac")
        async with aiohttp.ClientSession() as session, session.post(f"{address}/export", data=form) as found:
            return found.status, found.content_type, await found.read()

    return run(ask())


def told(answer: tuple[int, str, bytes]) -> tuple[int, str]:
    """Give the status and the sentence of a refusal."""
    status, kind, content = answer
    assert kind == "application/json"
    sentence = json.loads(content)["error"]
    assert "\n" not in sentence
    return status, sentence


def test_a_file_is_what_the_command_line_writes(server: str, tmp_path: Path) -> None:
    sound, expected = tmp_path / "sound", tmp_path / "mouth.glb"
    sound.write_bytes(SOUND)
    assert main(["export", str(sound), "--format", "gltf", "-o", str(expected)]) == 0
    assert exported(server, format="gltf") == (200, "model/gltf-binary", expected.read_bytes())


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({}, "format: there is no ''; choose one of rhubarb-tsv"),
        ({"format": "gltf", "table": "/etc/passwd"}, "there is no mouth table '/etc/passwd'"),
        ({"format": "gltf", "fps": "many"}, "fps must be a number"),
        ({"format": "gltf", "text": b"\xff\xfe"}, "the field text is no text in UTF-8"),
        ({"format": "gltf", "text": "word " * 30_000}, "the field text may have 100000 characters"),
        ({"format": "x" * 1000}, "the field format may have 64 characters"),
        ({"format": "gltf", "mesh": "/etc/passwd"}, "there is no such field"),
        ({"format": "gltf", "preset": "/etc/passwd"}, "there is no preset '/etc/passwd'; choose one of learned"),
        ({"format": "gltf", "preset": "a = 1\n"}, "a preset begins with format = 'phonemeanalyser preset 2'"),
        ({"format": "gltf", "no-head": "no"}, "no-head must be true or false, got 'no'"),
        ({"format": "gltf", "seed": "-1"}, "seed must be a whole number of 0 or more, got '-1'"),
        ({"format": "gltf", "channel": "all"}, "channel must be mix, left, right, or a number in 1..1024, got 'all'"),
        ({"format": "gltf", "text-driver": "table"}, "text-driver: there is no 'table'; choose one of auto"),
        ({"format": "gltf", "literal": "true"}, "--literal goes with --text or --script"),
        ({"format": "gltf", "expression": "/etc/passwd.csv"}, "expression must be like smile=0.5, and no file"),
        ({"format": "gltf", "attack": "20"}, "attack must be a factor in 0.1..10, got 20"),
    ],
    ids=str,
)
def test_nonsense_is_answered_by_a_sentence(server: str, fields: dict[str, Any], words: str) -> None:
    status, sentence = told(exported(server, **fields))
    assert words in sentence
    assert status in {400, 413}


@pytest.mark.parametrize("sound", [SOUND[:1000], None], ids=["cut off", "none"])
def test_what_is_no_sound_is_answered_by_a_sentence(server: str, sound: bytes | None) -> None:
    status, sentence = told(exported(server, sound, format="gltf"))
    assert status == 400
    assert "sound" in sentence


def test_a_file_that_is_too_large_is_not_taken() -> None:
    with served(ServerSettings(port=0, limits=ServerLimits(max_file=0.01))) as address:
        assert told(exported(address, format="gltf")) == (413, "a file may have 0.01 MB; send a shorter one")


def silent_flac(seconds: float) -> bytes:
    """Give silence, which FLAC holds in next to nothing."""
    content = io.BytesIO()
    soundfile.write(content, np.zeros(round(seconds * 8000), np.int16), 8000, format="FLAC")
    return content.getvalue()


def test_a_sound_that_is_too_long_is_not_taken_however_small_its_file_is() -> None:
    with served(ServerSettings(port=0, limits=ServerLimits(max_duration=60))) as address:
        sound = silent_flac(120)
        assert len(sound) < 100_000
        status, sentence = told(exported(address, sound, format="rhubarb-tsv"))
        assert (status, "it lasts 120 s, and at most 60 s are taken" in sentence) == (400, True)


def answered(work: object, tmp_path: Path, memory: int | None = None) -> RefusedError:
    """Give why a process has failed at work."""
    order = pickle.dumps((DEFAULT_PRESET, work, Job(tmp_path / "crashes.wav", tmp_path / "out")))
    with subprocess.Popen(
        [sys.executable, "-c", CODE], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        if memory is not None:
            limit_memory(process.pid, memory << 20)
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(order)
        process.stdin.flush()
        answer = process.stdout.read()
    with pytest.raises(RefusedError) as refused:
        check_answer(answer, "", memory or 0)
    return refused.value


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not limit the memory of other processes")
def test_a_file_that_needs_too_much_memory_is_given_up_in_a_sentence(tmp_path: Path) -> None:
    refused = answered(partial(CopyWork, "hungry"), tmp_path, memory=800)
    assert (refused.status, str(refused)) == (413, "the file needs more than 800 MB of memory; send a shorter one")


def test_a_bug_in_an_export_is_no_traceback(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    refused = answered(partial(CopyWork, "copy"), tmp_path)
    assert (refused.status, str(refused)) == (500, FAILED)
    assert "ZeroDivisionError: a bug" in caplog.text


def test_a_process_that_died_has_failed(caplog: pytest.LogCaptureFixture) -> None:
    with pytest.raises(RefusedError, match="the server has failed"):
        check_answer(b"", "killed", 200)
    assert "killed" in caplog.text


@pytest.mark.long  # test_turns moves the clock of such turns by hand
@pytest.mark.skipif(os.name == "nt", reason="there, processes do not give way")
def test_a_short_file_does_not_wait_for_a_long_one_that_came_first() -> None:
    ended: list[str] = []

    async def ask(session: aiohttp.ClientSession, address: str, name: str, sound: bytes) -> None:
        form = aiohttp.FormData({"format": "rhubarb-tsv"})
        form.add_field("sound", sound, filename=name)
        async with session.post(f"{address}/export", data=form) as found:
            await found.read()
            ended.append(name)

    async def both(address: str) -> None:
        async with aiohttp.ClientSession() as session:
            long = asyncio.create_task(ask(session, address, "long", silent_flac(2400)))
            while (await (await session.get(address)).json())["files"] == 0:
                pass
            await ask(session, address, "short", SOUND)
            long.cancel()
            await asyncio.gather(long, return_exceptions=True)

    with served(ServerSettings(port=0, limits=ServerLimits(max_files=1, max_duration=7200))) as address:
        run(both(address))
    assert ended == ["short"]


def test_a_form_that_is_no_form_is_answered_by_a_sentence(server: str) -> None:
    async def ask(**options: Any) -> tuple[int, str, bytes]:
        async with aiohttp.ClientSession() as session, session.post(f"{server}/export", **options) as found:
            return found.status, found.content_type, await found.read()

    kind = {"Content-Type": "multipart/form-data; boundary=x"}
    assert told(run(ask(data=SOUND)))[0] == 415
    assert "damaged" in told(run(ask(data=b"nonsense", headers=kind)))[1]
    assert "field" in told(run(ask(data=b"--x\r\n\r\nfoo\r\n--x--\r\n", headers=kind)))[1]


@pytest.mark.parametrize(
    ("limits", "words"),
    [
        (ServerLimits(idle_timeout=1), b"nothing came for 1 s"),
        (ServerLimits(file_timeout=1), b"took longer than 1 s"),
    ],
)
def test_a_form_that_stops_coming_or_takes_too_long_is_given_up_and_leaves_nothing(
    limits: ServerLimits, words: bytes
) -> None:
    async def ask(address: str) -> None:
        reader, writer = await asyncio.open_connection("127.0.0.1", int(address.rsplit(":", 1)[1]))
        head = "POST /export HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; boundary=x\r\n"
        writer.write(f"{head}Content-Length: 1000\r\n\r\n--x\r\n".encode())
        assert words in await reader.read()
        writer.close()

    made = watched(Path(tempfile.gettempdir()), {"tempfile.mkdtemp"})
    with made as folders, served(ServerSettings(port=0, limits=limits)) as address:
        run(ask(address))
        assert [Path(folder).exists() for _, folder in folders.changes] == [False]
