"""``phonemeanalyser serve``, as a person types it."""

import json
import signal
import subprocess
import sys
import urllib.request
from pathlib import Path

import pytest

from phonemeanalyser.cli.main import main
from tests.tables import Capsys


@pytest.mark.skipif(sys.platform == "win32", reason="a process is ended otherwise there")
@pytest.mark.parametrize("ending", [signal.SIGINT, pytest.param(signal.SIGTERM, marks=pytest.mark.long)])
def test_it_serves_until_it_is_ended(ending: signal.Signals) -> None:
    options = ["--port", "0", "--preset", "thesis", "--max-streams", "3"]
    words = [sys.executable, "-m", "phonemeanalyser", "serve", *options]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        line = process.stdout.readline()
        address = line.split()[1].strip(",")
        assert line == f"serving {address}, streams at ws{address[4:]}/stream; Ctrl-C ends it\n"
        with urllib.request.urlopen(address, timeout=60) as answer:
            told = json.load(answer)
        process.send_signal(ending)
        _, said = process.communicate(timeout=60)
    assert (told["preset"], told["most_streams"]) == ("Thesis", 3)
    assert (process.returncode, said) == (0, "")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--host", "0.0.0.0"], "0.0.0.0 can be reached from other machines, so a token is needed"),
        (["--token-file", "nothing.txt"], "nothing.txt: there is no such file"),
        (["--preset", "nothing"], "nothing: there is no such preset"),
        (["--host", "no.such.host.invalid", "--token-file", "TOKEN"], "cannot be served"),
    ],
)
def test_what_cannot_be_served_is_said(words: list[str], sentence: str, tmp_path: Path, capsys: Capsys) -> None:
    token = tmp_path / "token.txt"
    token.write_text("0123456789abcdef\n")
    token.chmod(0o600)
    assert main(["serve", "--port", "0", *(str(token) if word == "TOKEN" else word for word in words)]) == 1
    said = capsys.readouterr().err
    assert sentence in said
    assert said.count("\n") == 1


@pytest.mark.parametrize(
    "words", [["--port", "70000"], ["--max-streams", "0"], ["--idle-timeout", "0"], ["--max-speed", "x"]]
)
def test_limits_that_are_none_are_refused(words: list[str], capsys: Capsys) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["serve", *words])
    assert ended.value.code == 2
    assert f"{words[0]}: must be a" in capsys.readouterr().err


def test_packages_that_are_missing_are_named(monkeypatch: pytest.MonkeyPatch, capsys: Capsys) -> None:
    monkeypatch.setitem(sys.modules, "phonemeanalyser.server.service", None)
    assert main(["serve"]) == 1
    assert "install them with: pip install 'phonemeanalyser[server]'" in capsys.readouterr().err
