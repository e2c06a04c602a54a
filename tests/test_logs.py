"""The log of the programs: kept where somebody asks for it, with what was refused and what crashed."""

import logging
import re
import threading
from pathlib import Path

import pytest

from phonemeanalyser import logs
from phonemeanalyser.cli.main import main
from phonemeengine.errors import EngineError

ENGINE = logging.getLogger("phonemeengine.live.listener")
Capture = pytest.CaptureFixture[str]


def refuse() -> None:
    ENGINE.info("within")
    raise EngineError("refused")


def test_a_command_logs_the_files_that_it_refuses(sound: Path, tmp_path: Path, capsys: Capture) -> None:
    log, bad = tmp_path / "run.log", tmp_path / "bad.wav"
    bad.write_bytes(b"no sound")
    assert main(["analyse", str(sound), str(bad), "--preset", "thesis", "--log", str(log), "-o", str(tmp_path)]) == 1
    (line,) = log.read_text().splitlines()
    assert re.fullmatch(r"[-\d]+ [\d:,]+ WARNING phonemeengine\.batch\.runner: bad\.wav: this is not an aud.*", line)
    assert line.split("runner: ")[1] in capsys.readouterr().err


def test_the_log_is_appended_to_and_says_what_was_refused(tmp_path: Path) -> None:
    log = tmp_path / "run.log"
    for _ in range(2):
        assert main(["score", str(tmp_path / "missing"), f"--log={log}"]) == 1
    assert log.read_text().count("missing: there is no such folder") == 2


def test_a_log_that_cannot_be_written_is_one_sentence(tmp_path: Path, capsys: Capture) -> None:
    assert main(["score", str(tmp_path), "--log", str(tmp_path / "no" / "run.log")]) == 1
    assert re.fullmatch(
        r"phonemeanalyser: run\.log: this log cannot be written \(No such .*\); choose another with --log\n",
        capsys.readouterr().err,
    )


def test_a_crash_is_logged_with_where_it_happened(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError), logs.logged_to(tmp_path / "run.log"):
        raise ZeroDivisionError("a bug")
    text = (tmp_path / "run.log").read_text()
    assert "ERROR phonemeanalyser.logs: the program crashed\nTraceback" in text
    assert "ZeroDivisionError: a bug" in text


def test_nothing_is_kept_after_the_end(tmp_path: Path) -> None:
    with pytest.raises(EngineError), logs.logged_to(tmp_path / "run.log"):
        refuse()
    ENGINE.info("after")
    lines = (tmp_path / "run.log").read_text().splitlines()
    assert [line.split(": ", 1)[1] for line in lines] == ["within", "refused"]


def test_the_window_s_log_begins_anew_before_it_grows_large(tmp_path: Path) -> None:
    with logs.logged_beside(tmp_path / "settings") as path:
        for k in range(100):
            ENGINE.info("%s line %d", 50_000 * "x", k)
    names = sorted(file.name for file in path.parent.iterdir())
    assert names == [path.name, *(f"{path.name}.{k}" for k in (1, 2, 3))]
    assert all(file.stat().st_size <= logs.LARGEST for file in path.parent.iterdir())
    assert path.read_text().endswith("line 99\n")


def test_a_folder_that_cannot_be_made_troubles_nobody(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("kept")
    with logs.logged_beside(tmp_path / "file" / "settings") as path:
        ENGINE.info("heard by nobody")
    assert not path.exists()
    assert (tmp_path / "file").read_text() == "kept"


def test_a_thread_that_crashes_is_logged(tmp_path: Path, capsys: Capture) -> None:
    with logs.logged_beside(tmp_path) as path:
        thread = threading.Thread(target={}.pop, args=("nothing",), name="a worker")
        thread.start()
        thread.join()
    assert "ERROR phonemeanalyser.logs: a worker crashed\nTraceback" in path.read_text()
    assert "KeyError" in capsys.readouterr().err
