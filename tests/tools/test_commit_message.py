"""The check of commit messages, as git calls it."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tools.commit_message import complaints_about

SCRIPT = ROOT / "tools" / "commit_message.py"


@pytest.mark.parametrize(
    ("message", "n_changed"),
    [
        ("Count lost samples\n", 20),
        ("Count lost samples\n\nThe status line showed none of them.\n", 21),
        ("x" * 72, 1),
        (
            "Count\n# a comment of git that is far longer than seventy-two letters, and which nobody will ever see\n",
            1,
        ),
        ("Merge branch 'live' into main, which brings everything that was measured there since last week\n", 5000),
    ],
)
def test_a_message_that_says_what_and_why_is_taken(message: str, n_changed: int) -> None:
    assert complaints_about(message, n_changed) == []


@pytest.mark.parametrize(
    ("message", "n_changed", "complaint"),
    [
        ("x" * 73, 1, "the subject may have 72 letters, this has 73"),
        ("Count lost samples\nin the status line", 1, "an empty line must follow"),
        ("Count lost samples\n", 21, "needs a body, this has 21"),
        ("Count lost samples\n\n# Please enter the message\n", 21, "needs a body"),
        ("Count\n# ------------------------ >8 ------------------------\n+a\n", 21, "needs a body"),
    ],
)
def test_a_message_that_breaks_the_rule_is_refused(message: str, n_changed: int, complaint: str) -> None:
    (found,) = complaints_about(message, n_changed)
    assert complaint in found


@pytest.mark.parametrize(("n_lines", "taken"), [(20, True), (21, False)])
def test_a_commit_without_a_body_is_refused_where_it_changes_much(tmp_path: Path, n_lines: int, taken: bool) -> None:
    def git(*words: str) -> int:
        who = ["-c", "user.name=Ada", "-c", "user.email=ada@example.org", "-c", "commit.gpgsign=false"]
        return subprocess.run(["git", *who, *words], cwd=tmp_path, capture_output=True, check=False).returncode

    assert git("init") == 0
    hook = tmp_path / ".git" / "hooks" / "commit-msg"
    hook.parent.mkdir(exist_ok=True)
    hook.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{SCRIPT}" "$1"\n')
    hook.chmod(0o755)
    (tmp_path / "poem.txt").write_text("a line\n" * n_lines)
    assert git("add", ".") == 0
    assert (git("commit", "-m", "Write a poem") == 0) is taken
