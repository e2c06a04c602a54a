"""Presets and mouth tables of a client's own: named at the start of the server, or sent as text."""

import json
from pathlib import Path

import pytest

from phonemeanalyser.server.access import RefusedError, ServerLimits
from phonemeanalyser.server.files import FileRequest
from phonemeanalyser.server.messages import StreamStart, start_of
from phonemeanalyser.server.repertoire import Repertoire
from phonemeengine import EngineError, load_preset, load_table
from phonemeengine.mouth.table import TABLES
from phonemeengine.presets.files import DEFAULT_PRESET, FACTORY
from tests.server.conftest import REPERTOIRE
from tests.server.servers import streamed
from tests.sounds import Sound

TABLE = (TABLES / "vrm.toml").read_text(encoding="utf-8").replace('name = "', 'name = "My ')
PRESET = (FACTORY / "thesis.toml").read_text(encoding="utf-8").replace('name = "', 'name = "My ')


def begun(repertoire: Repertoire = REPERTOIRE, **told: object) -> StreamStart:
    return start_of(json.dumps({"rate": 44_100} | told), repertoire)


def test_a_client_names_what_the_server_was_started_with(tmp_path: Path) -> None:
    (tmp_path / "puppet.toml").write_text(TABLE, encoding="utf-8")
    offered = Repertoire.of_files([Path("learned"), Path("thesis")], [tmp_path / "puppet.toml"], ServerLimits())
    start = begun(offered, table="puppet", preset="thesis")
    assert start.preset.name == "Thesis"
    assert start.table is not None
    assert start.table.name.startswith("My ")
    assert begun(offered).preset.name == "Learned"
    with pytest.raises(EngineError, match=r"two mouth tables have the name 'vrm'.*; rename a file"):
        Repertoire.of_files([DEFAULT_PRESET], [TABLES / "vrm.toml"], ServerLimits())


def test_a_client_sends_its_own(server: str, recording: Sound, tmp_path: Path) -> None:
    start = {"encoding": "f32", "rate": 44_100, "table": TABLE, "preset": PRESET}
    told = streamed(server, start, [recording[:22_050].tobytes()])
    ready = told.messages[0]["ready"]
    assert ready["preset"].startswith("My ")
    assert ready["movestates"] == list(load_table("vrm").movestates)
    (tmp_path / "sound").write_bytes(b"")
    words = {"format": ["curves-json"], "table": [TABLE], "preset": [PRESET]}
    options = FileRequest(tmp_path / "sound", words).options(REPERTOIRE)
    assert load_table(str(options.table)).name.startswith("My ")
    assert load_preset(options.preset).name.startswith("My ")


@pytest.mark.parametrize(
    ("told", "words"),
    [
        ({"preset": "../learned"}, "there is no preset '../learned'; choose one of learned, or send the text"),
        ({"table": "/etc/passwd"}, "there is no mouth table '/etc/passwd'; choose one of annosoft, arkit"),
        ({"table": TABLE + "#" * 40_000}, "a mouth table of your own may have 32 KB; send a shorter one"),
        ({"table": "a\n"}, "this is no TOML file"),
        ({"table": TABLE.replace("[shapes.A]", "[shapes.B]")}, "which \\[shapes\\] lacks"),
        ({"preset": "[[" * 10_000 + "\n"}, "this is no TOML file"),
        ({"preset": DEFAULT_PRESET.read_text(encoding="utf-8")}, "learned.npz"),
        ({"preset": PRESET.replace('recogniser = "thesis"', 'recogniser = "x"')}, "there is no recogniser"),
        ({"events": "google"}, "there are no events of 'google'; choose azure or polly"),
        ({"events": "azure", "table": "vrm"}, "with events there are no frames; leave out table"),
    ],
)
def test_what_is_none_is_refused_in_a_sentence(told: dict[str, str], words: str) -> None:
    with pytest.raises(EngineError, match=words) as refused:
        begun(**told)
    assert "\n" not in str(refused.value)
    assert len(str(refused.value)) < 300


def test_a_server_may_allow_none_to_be_sent() -> None:
    closed = Repertoire.of_files([DEFAULT_PRESET], [], ServerLimits(max_own=0))
    with pytest.raises(RefusedError, match="may have 0 KB"):
        begun(closed, preset=PRESET)
    assert begun(closed, preset="learned", table="arkit").preset == load_preset("learned")
