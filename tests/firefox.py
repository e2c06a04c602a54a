"""Firefox as the distribution has it, driven by WebDriver BiDi (W3C), which needs nothing but a WebSocket."""

import asyncio
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from aiohttp import ClientSession, ClientWebSocketResponse

LISTENING = "WebDriver BiDi listening on "
PREFERENCES = {
    "media.autoplay.default": "0",
    "media.autoplay.blocking_policy": "0",
    "webgl.force-enabled": "true",
    "gfx.webrender.software": "true",
}
"""Sound may start without a click, and software draws in three dimensions, which takes a display."""
TIMEOUT = 180.0
LARGEST = 1 << 26
"""Bytes of an answer."""


def in_firefox(address: str, expression: str, profile: Path, display: dict[str, str] | None = None) -> Any:
    """Open a page, and give what an expression in it comes to, a text, when its promise is kept.

    `display`: the environment of a program that may open windows; without one there is no WebGL.
    """
    program = shutil.which("firefox-esr") or shutil.which("firefox")
    if program is None and "CI" in os.environ:
        pytest.fail("there is no Firefox; install firefox-esr")
    if program is None:
        pytest.skip("there is no Firefox")
    profile.mkdir()
    lines = (f'user_pref("{name}", {value});\n' for name, value in PREFERENCES.items())
    (profile / "user.js").write_text("".join(lines), encoding="utf-8")
    words = [program, "--no-remote", "--profile", str(profile), "--remote-debugging-port", "0"]
    words += [] if display else ["--headless"]
    with subprocess.Popen(words, stderr=subprocess.PIPE, text=True, env=display) as firefox:
        assert firefox.stderr is not None
        try:
            line = next(line for line in firefox.stderr if LISTENING in line)
            place = line.partition(LISTENING)[2].strip()
            return asyncio.run(asyncio.wait_for(_evaluated(place, address, expression), TIMEOUT))
        finally:
            firefox.kill()


async def _evaluated(place: str, address: str, expression: str) -> Any:
    async with ClientSession() as client, client.ws_connect(f"{place}/session", max_msg_size=LARGEST) as socket:
        await _told(socket, "session.new", capabilities={})
        tree = await _told(socket, "browsingContext.getTree")
        context = tree["contexts"][0]["context"]
        await _told(socket, "browsingContext.navigate", context=context, url=address, wait="complete")
        target = {"context": context}
        told = await _told(socket, "script.evaluate", expression=expression, target=target, awaitPromise=True)
        assert told["type"] == "success", told
        return told["result"]["value"]


async def _told(socket: ClientWebSocketResponse, method: str, **parameters: Any) -> dict[str, Any]:
    """Send a command, and give its result; events come in between."""
    await socket.send_json({"id": 1, "method": method, "params": parameters})
    while (answer := await socket.receive_json()).get("id") != 1:
        pass
    assert answer["type"] == "success", answer
    result: dict[str, Any] = answer["result"]
    return result
