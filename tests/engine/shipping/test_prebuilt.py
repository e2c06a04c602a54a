"""Compiled parts that come with the program: taken while they are of these sources, the same wherever they run."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import load_preset
from phonemeengine.shipping.targets import format_ear, prebuilt
from tests.compiled_ears import FRAME, SOURCES, compiled
from tests.engine.shipping.test_same_results import check_same, recognised_by_engine, speech

PROGRAM = Path(__file__).parents[2] / "ear_hear.c"


def test_parts_of_other_sources_or_that_are_not_there_are_not_taken(tmp_path: Path) -> None:
    assert prebuilt("ear.wasm", tmp_path) is None
    (tmp_path / "ear.wasm.bin").write_bytes(b"old")
    assert prebuilt("ear.wasm", tmp_path) is None
    (tmp_path / "SOURCES").write_text("of another version", encoding="ascii")
    assert prebuilt("ear.wasm", tmp_path) is None


def heard(words: list[str | Path], folder: Path) -> np.ndarray:
    (folder / "preset.ear").write_bytes(format_ear(load_preset("learned"), ()))
    command = [*words, "preset.ear", "44100"]
    done = subprocess.run(command, input=SOUND.tobytes(), cwd=folder, capture_output=True, check=True)
    return np.frombuffer(done.stdout, FRAME)


SOUND = speech()[: 4 * 44_100]


@pytest.mark.long
def test_arm_hears_what_the_engine_hears_in_qemu(tmp_path: Path) -> None:
    flags = ("-O2", "--target=aarch64-linux-musl")
    program = compiled("ear_hear", [PROGRAM, SOURCES / "ear.c"], *flags, by="zig")
    check_same(heard(["qemu-aarch64-static", program], tmp_path), recognised_by_engine(load_preset("learned"), SOUND))
