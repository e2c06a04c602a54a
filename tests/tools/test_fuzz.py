"""A small run of the fuzzing, and that it finds what it looks for."""

import subprocess
import sys
from pathlib import Path
from random import Random

import pytest

from phonemeengine.errors import MeshError
from tools.fuzz import running
from tools.fuzz.kinds import Kind, kinds
from tools.fuzz.mutation import mutated
from tools.fuzz.reading import failure_of
from tools.fuzz.running import run

N = 300


def test_300_damaged_files_are_read_or_refused_in_a_sentence():
    assert run(N, "small") == []


def test_every_kind_of_file_is_good_before_it_is_damaged(tmp_path: Path):
    for name, kind in kinds(tmp_path).items():
        if name != "arrays in npz":  # its good files are arrays, which do not all fit everywhere
            kind.read(kind.dress(kind.good[0]))


def test_the_same_seed_does_the_same_damage():
    good = (b'{"a": [1, 2]}', b"3dm01 12 34")
    once, again = ([mutated(good[k % 2], good, Random(k)) for k in range(200)] for _ in range(2))
    assert once == again
    assert len(set(once)) > 100


def _refuse(_content: bytes) -> object:
    raise MeshError("this is no mesh; choose another file")


def _mumble(_content: bytes) -> object:
    raise MeshError("no\nsentence")


def _stumble(content: bytes) -> object:
    return content[1_000_000]


def _fill(_content: bytes) -> object:
    raise MemoryError


@pytest.mark.parametrize(
    ("read", "what"),
    [(len, ""), (_refuse, ""), (_mumble, "it was refused with"), (_stumble, "IndexError"), (_fill, "MemoryError")],
)
def test_only_a_sentence_counts_as_a_refusal(read: object, what: str):
    found = failure_of(Kind((b"",), read), b"content")  # type: ignore[arg-type]
    assert found.startswith(what)
    assert bool(found) == bool(what)


def test_a_process_that_stays_at_one_file_is_ended(tmp_path: Path):
    now = tmp_path / "now"
    now.write_bytes(b"%12d" % 7)
    process = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    assert running.watch(process, now, lambda _n: None, patience=0.3)
    process.stdin.close()
    assert process.returncode is not None


@pytest.mark.skipif(sys.platform != "linux", reason="the limit is the system's")
def test_memory_beyond_200_mb_is_refused_by_the_system():
    program = "from tools.fuzz.reading import limit_memory; assert limit_memory(); bytearray(210 << 20)"
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=running.ROOT, capture_output=True, text=True, check=False
    )
    assert "MemoryError" in done.stderr
