"""What ``make release`` promises: the same bytes twice, told where they differ, and checksums that can be checked."""

import subprocess
import sys
from pathlib import Path

import pytest

from tools.release.__main__ import ROOT, add_on, made_twice, main, package, write_checksums


@pytest.mark.long
def test_the_add_on_wheel_and_source_have_the_same_bytes_twice(tmp_path, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    assert made_twice(package, tmp_path) == []
    assert made_twice(add_on, tmp_path) == []
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".gz", ".whl", ".zip"]


def test_what_differs_is_named(tmp_path):
    made = []

    def make(folder: Path) -> None:
        made.append(folder)
        (folder / "same").write_text("a")
        (folder / "other").write_text(str(len(made)))

    assert made_twice(make, tmp_path) == ["other"]
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"same": "a", "other": "1"}


@pytest.mark.skipif(sys.platform == "win32", reason="has no sha256sum")
def test_checksums_can_be_checked(tmp_path):
    (tmp_path / "one.whl").write_bytes(b"1")
    (tmp_path / "two.zip").write_bytes(b"2")
    write_checksums(tmp_path)
    check = ["sha256sum", "--check", "SHA256SUMS"]
    assert subprocess.run(check, cwd=tmp_path, capture_output=True, check=False).returncode == 0
    (tmp_path / "two.zip").write_bytes(b"3")
    assert subprocess.run(check, cwd=tmp_path, capture_output=True, check=False).returncode == 1


def test_a_checkout_with_changes_is_refused(monkeypatch, capsys, tmp_path):
    subprocess.run(["git", "init", "-q", tmp_path / "checkout"], check=True)
    (tmp_path / "checkout" / "new").touch()
    monkeypatch.setenv("GIT_DIR", str(tmp_path / "checkout" / ".git"))
    monkeypatch.setenv("GIT_WORK_TREE", str(tmp_path / "checkout"))
    assert main(["-o", str(tmp_path / "release")]) == 1
    assert "commit them" in capsys.readouterr().err
    assert not (tmp_path / "release").exists()
    assert (ROOT / "pyproject.toml").is_file()
