"""Who may ask: programs of this machine, pages from it, and whoever knows the token."""

import asyncio
from pathlib import Path

import aiohttp
import pytest

from phonemeanalyser.server.access import Access, is_loopback, token_in
from phonemeanalyser.server.refused import RefusedError
from phonemeanalyser.server.service import ServerSettings, serving
from phonemeengine import EngineError
from tests.server.servers import run, served, streamed
from tests.server.test_refusals import answer

TOKEN = "0123456789abcdef-secret"


@pytest.mark.parametrize(
    ("host", "own"),
    [
        ("127.0.0.1", True), ("127.9.9.9", True), ("::1", True), ("[::1]", True), ("localhost", True),
        ("LOCALHOST.", True), ("0.0.0.0", False), ("::", False), ("192.168.1.5", False), ("example.org", False),
        ("localhost.example.org", False), ("127.0.0.1.example.org", False), ("", False),
    ],
)  # fmt: skip
def test_names_of_this_machine_are_known(host: str, own: bool) -> None:
    assert is_loopback(host) is own


@pytest.mark.parametrize(
    ("headers", "words"),
    [
        ({"Host": "127.0.0.1:80"}, ""),
        ({"Host": "[::1]:80", "Origin": "http://localhost:8000"}, ""),
        ({"Host": "localhost", "Origin": "https://friend.example"}, ""),
        ({"Host": "evil.example:8765"}, "ask for 127.0.0.1"),
        ({}, "ask for 127.0.0.1"),
        ({"Host": "["}, "ask for 127.0.0.1"),
        ({"Host": "localhost", "Origin": "https://evil.example"}, "pages of https://evil.example may not ask"),
        ({"Host": "localhost", "Origin": "null"}, "pages of null may not ask"),
        ({"Host": "localhost", "Origin": "http://localhost.evil.example"}, "may not ask"),
    ],
)
def test_without_a_token_only_this_machine_may_ask(headers: dict[str, str], words: str) -> None:
    access = Access(origins=["https://friend.example"])
    if not words:
        access.check(headers)
        return
    with pytest.raises(RefusedError, match=words.replace("/", ".")) as refused:
        access.check(headers)
    assert refused.value.status == 403


def test_a_page_of_a_stranger_is_not_answered(server: str) -> None:
    status, told = answer(server, "/", headers={"Origin": "https://evil.example"})
    assert (status, "may not ask" in told["error"]) == (403, True)


def test_with_a_token_others_must_know_it() -> None:
    with served(ServerSettings(port=0, access=Access(TOKEN))) as address:
        for headers in (
            {},
            {"Authorization": "Bearer wrong"},
            {"Authorization": TOKEN},
            {"Authorization": "Bearer ä"},
        ):
            status, told = answer(address, "/", headers=headers)
            assert (status, "asks for its token" in told["error"]) == (401, True)
        bearer = {"Authorization": f"Bearer {TOKEN}", "Host": "server.example", "Origin": "https://page.example"}
        assert answer(address, "/", headers=bearer)[0] == 200
        start = {"rate": 44_100}
        assert streamed(address, start, [bytes(8820)], headers=bearer).code == 1000
        assert streamed(address, start, [bytes(8820)], protocols=["phonemeanalyser", TOKEN]).code == 1000
        with pytest.raises(aiohttp.WSServerHandshakeError, match="401"):
            streamed(address, start, [], protocols=["phonemeanalyser", "wrong"])


def test_other_machines_are_not_served_without_a_token() -> None:
    with pytest.raises(EngineError, match="can be reached from other machines, so a token is needed"):
        asyncio.run(begun(ServerSettings(host="0.0.0.0", port=0)))


def test_a_port_that_is_taken_is_told() -> None:
    with served(ServerSettings(port=0)) as address:
        port = int(address.rsplit(":", 1)[1])
        with pytest.raises(EngineError, match=f"127.0.0.1:{port} cannot be served"):
            asyncio.run(begun(ServerSettings(port=port)))


async def begun(settings: ServerSettings) -> None:
    async with serving(settings):
        pass


def test_a_token_is_the_only_line_of_its_file(token_file: Path) -> None:
    assert token_in(token_file) == TOKEN


@pytest.mark.parametrize(
    "content", [b"", b"short\n", b"two lines of it\nand more\n", b"with space 0123456789", b"\xff" * 20]
)
def test_what_is_no_token_is_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "token.txt"
    path.write_bytes(content)
    with pytest.raises(EngineError, match=r"token.txt: "):
        token_in(path)


def test_the_page_may_not_be_read_by_a_name_that_was_rebound(server: str) -> None:
    async def ask() -> int:
        async with (
            aiohttp.ClientSession() as session,
            session.get(server, headers={"Host": "rebound.example"}) as found,
        ):
            return found.status

    assert run(ask()) == 403
