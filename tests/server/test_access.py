"""Who may ask: programs of this machine, pages from it, and whoever knows the token."""

import asyncio
import os
import time
from pathlib import Path

import aiohttp
import pytest

from phonemeanalyser.server.access import Access, RefusedError, WrongTokens, is_loopback, token_in
from phonemeanalyser.server.service import ServerSettings, serving
from phonemeengine import EngineError
from tests.server.servers import run, served, streamed
from tests.server.test_refusals import answer

TOKEN = "0123456789abcdef-secret"


@pytest.mark.parametrize(
    ("host", "own"),
    [
        ("127.0.0.1", True),
        ("127.9.9.9", True),
        ("::1", True),
        ("[::1]", True),
        ("localhost", True),
        ("LOCALHOST.", True),
        ("0.0.0.0", False),
        ("::", False),
        ("localhost.example.org", False),
        ("127.0.0.1.example.org", False),
        ("", False),
    ],
)
def test_names_of_this_machine_are_known(host: str, own: bool) -> None:
    assert is_loopback(host) is own


@pytest.mark.parametrize(
    ("headers", "words"),
    [
        ({"Host": "127.0.0.1:80"}, ""),
        ({"Host": "[::1]:80", "Origin": "http://[::1]:80"}, ""),
        ({"Host": "localhost.", "Origin": "https://FRIEND.example"}, ""),
        ({"Host": "localhost:8765", "Origin": "http://localhost:8000"}, "pages of http://localhost:8000 may not ask"),
        ({"Host": "localhost:8765", "Origin": "https://localhost"}, "may not ask"),
        ({"Host": "evil.example/@127.0.0.1:80"}, "ask for 127.0.0.1"),
        ({"Host": "127.0.0.1:80:80"}, "ask for 127.0.0.1"),
        ({"Host": "127.0.0.1:x"}, "ask for 127.0.0.1"),
        ({"Host": " localhost"}, "ask for 127.0.0.1"),
        ({"Host": "localhost", "host": "evil.example"}, "ask for 127.0.0.1"),
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
    path.chmod(0o600)
    with pytest.raises(EngineError, match=r"token.txt: "):
        token_in(path)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no mode of a file")
@pytest.mark.parametrize("mode", [0o604, 0o602])
def test_a_token_that_all_users_know_is_refused(token_file: Path, mode: int) -> None:
    token_file.chmod(mode)
    with pytest.raises(EngineError, match=r"token\.txt: all users of this machine can read or change it"):
        token_in(token_file)
    token_file.chmod(0o640)  # of a group that an administrator has made for it
    assert token_in(token_file) == TOKEN


@pytest.mark.parametrize("origin", ["*", "null", "friend.example", "https://friend.example/", "https://a b", ""])
def test_what_is_no_origin_is_refused(origin: str) -> None:
    with pytest.raises(EngineError, match=r"is no origin of a page; name its scheme, host and port alone"):
        Access(origins=[origin])


def test_who_guesses_waits_longer_after_each_wrong_token_and_nobody_else_does() -> None:
    now = [0.0]
    wrong = WrongTokens(lambda: now[0])
    waits = []
    for _ in range(12):
        waits.append(wrong.wait_of("10.0.0.1"))
        wrong.add("10.0.0.1")
    assert waits[:5] == [0.0, 0.05, 0.1, 0.2, 0.4]
    assert waits[-1] == 5.0
    assert wrong.wait_of("10.0.0.2") == 0.0
    now[0] = 601.0
    assert wrong.wait_of("10.0.0.1") == 0.0
    wrong.add("10.0.0.1")
    assert wrong.wait_of("10.0.0.1") == 0.05
    wrong.forgive("10.0.0.1")
    assert wrong.wait_of("10.0.0.1") == 0.0


def test_guesses_are_slowed_and_the_token_still_lets_in() -> None:
    with served(ServerSettings(port=0, access=Access(TOKEN))) as address:
        began = time.monotonic()
        for k in range(4):
            assert answer(address, "/", headers={"Authorization": f"Bearer wrong{k}"})[0] == 401
        assert time.monotonic() - began >= 0.05 + 0.1 + 0.2
        assert answer(address, "/", headers={"Authorization": f"Bearer {TOKEN}"})[0] == 200
        assert answer(address, "/")[0] == 401


@pytest.mark.parametrize(
    ("peer", "told", "client"),
    [
        ("192.0.2.1", "203.0.113.5", "192.0.2.1"),  # no proxy of ours: it may say anything
        ("127.0.0.1", None, "127.0.0.1"),
        ("127.0.0.1", "203.0.113.5", "203.0.113.5"),
        ("127.0.0.1", "198.51.100.9, 203.0.113.5", "203.0.113.5"),  # the client may have said the first
        ("127.0.0.1", "203.0.113.5, 10.1.2.3", "203.0.113.5"),  # two proxies of ours
        ("127.0.0.1", "203.0.113.5, unknown", "127.0.0.1"),
        ("::ffff:127.0.0.1", "203.0.113.5", "203.0.113.5"),
        ("127.0.0.1", "2001:db8:1:2:3:4:5:6", "2001:db8:1:2::/64"),
        ("2001:db8::7", None, "2001:db8::/64"),
    ],
)
def test_limits_count_for_whom_a_trusted_proxy_asks(peer: str, told: str | None, client: str) -> None:
    access = Access(TOKEN, proxies=["127.0.0.1", "10.0.0.0/8"])
    assert access.client_of(peer, {} if told is None else {"X-Forwarded-For": told}) == client


def test_what_is_no_address_of_a_proxy_is_refused() -> None:
    with pytest.raises(EngineError, match=r"--trusted-proxy: 'proxy' does not appear to be"):
        Access(proxies=["proxy"])


def asked_by_page(address: str, method: str, origin: str, path: str = "/", **headers: str) -> tuple[int, str | None]:
    """Ask as a browser does for a page; gives the status, and who may read the answer."""

    async def ask() -> tuple[int, str | None]:
        asked = {"Origin": origin, **{name.replace("_", "-"): value for name, value in headers.items()}}
        async with (
            aiohttp.ClientSession() as session,
            session.request(method, address + path, headers=asked) as found,
        ):
            if method == "OPTIONS" and found.status == 204:
                assert "POST" in found.headers["Access-Control-Allow-Methods"]
                assert "Authorization" in found.headers["Access-Control-Allow-Headers"]
            return found.status, found.headers.get("Access-Control-Allow-Origin")

    return run(ask())


@pytest.mark.parametrize("token", [None, TOKEN])
def test_pages_of_an_origin_that_may_ask_read_what_is_answered(token: str | None) -> None:
    friend, evil = "https://friend.example", "https://evil.example"
    given = {"Authorization": f"Bearer {token}"} if token else {}
    with served(ServerSettings(port=0, access=Access(token, [friend]))) as address:
        assert asked_by_page(address, "OPTIONS", friend, "/export") == (204, friend)
        assert asked_by_page(address, "OPTIONS", evil, "/export") == (403, None)
        assert asked_by_page(address, "GET", friend, **given) == (200, friend)
        assert asked_by_page(address, "POST", friend, "/export", **given) == (415, friend)
        assert asked_by_page(address, "GET", friend, "/nowhere", **given) == (404, friend)
        assert asked_by_page(address, "GET", evil, **given) == ((200, None) if token else (403, None))
