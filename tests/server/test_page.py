"""The page in the examples says what the server understands, and reads what it tells."""

import json
import re

import pytest

from phonemeanalyser.server.messages import start_of
from tests.conftest import ROOT
from tests.server.conftest import REPERTOIRE
from tests.server.servers import cut, streamed
from tests.sounds import Sound

PAGE = (ROOT / "examples" / "server_page.html").read_text(encoding="utf-8")


@pytest.fixture
def start() -> dict[str, object]:
    """What the page says first, at 44.1 kHz."""
    (words,) = re.findall(r"JSON\.stringify\(\{(.*?)\}\)", PAGE)
    spelt = re.sub(r"(\w+):", r'"\1":', words.replace("context.sampleRate", "44100"))
    told = json.loads("{" + spelt + "}")
    assert isinstance(told, dict)
    return told


def test_the_page_begins_as_the_server_wants(start: dict[str, object]) -> None:
    assert start_of(json.dumps(start), REPERTOIRE).table is not None


def test_the_page_reads_what_it_is_told(server: str, recording: Sound, start: dict[str, object]) -> None:
    told = streamed(server, start, cut(recording.tobytes(), [4 * 960]))
    known = {key for message in told.messages for key in message} | {"error"}
    read = set(re.findall(r"told\.(\w+)", PAGE))
    assert {"ready", "phonemes", "intensities", "weights", "error"} <= read <= known
    assert len(told.messages[0]["ready"]["movestates"]) == len(told.frames[0]["weights"][0]) == 15


def test_the_page_offers_the_token_as_the_server_asks_for_it() -> None:
    assert '["phonemeanalyser", token]' in PAGE


def test_the_page_needs_no_network() -> None:
    assert re.findall(r"(?:https?|wss?)://(?!127\.0\.0\.1|localhost)", PAGE) == []
