"""Compiled parts that come with the program: taken while they are of these sources, the same wherever they run."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import load_preset
from phonemeengine.shipping.compiling import LIBRARIES, library, prebuilt
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import FRAME, SOURCES, compiled
from tests.engine.shipping.test_same_results import check_same, recognised_by_engine, speech
from tests.sounds import Sound

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
    done = subprocess.run(command, input=said().tobytes(), cwd=folder, capture_output=True, check=True)
    return np.frombuffer(done.stdout, FRAME)


def said() -> Sound:
    """Give four seconds of speech."""
    return speech()[: 4 * 44_100]


EMULATED = {
    "Linux on ARM": ("aarch64-linux-musl", "qemu-aarch64-static"),
    "Windows": ("x86_64-windows-gnu", "/usr/lib/wine/wine64"),
}


@pytest.mark.long
@pytest.mark.parametrize("name", EMULATED)
def test_another_system_hears_what_the_engine_hears(name: str, tmp_path: Path) -> None:
    system, emulator = EMULATED[name]
    assert shutil.which(emulator), f"there is no {emulator}; install qemu-user-static and wine64"
    program = compiled("ear_hear.exe", [PROGRAM, SOURCES / "ear.c"], "-O2", f"--target={system}", by="zig")
    check_same(heard([emulator, program], tmp_path), recognised_by_engine(load_preset("learned"), said()))


@pytest.mark.long
def test_the_library_for_android_needs_nothing_but_c_and_hears_the_same(tmp_path: Path, monkeypatch) -> None:
    (tmp_path / "libear.so").write_bytes(library("android.x86_64/libear.so"))
    for name in ("libc.so", "libm.so"):  # as Android names them
        (tmp_path / name).symlink_to(find_library_file(f"{name}.6"))
    flags = "-O1", "-L", str(tmp_path), "-Wl,--allow-shlib-undefined,--no-as-needed", str(tmp_path / "libear.so")
    program = tmp_path / "ear_hear"
    program.write_bytes(compiled("ear_hear", [PROGRAM], *flags).read_bytes())
    program.chmod(0o755)
    monkeypatch.setenv("LD_LIBRARY_PATH", str(tmp_path))
    check_same(heard([program], tmp_path), recognised_by_engine(load_preset("learned"), said()))


def find_library_file(name: str) -> Path:
    """Give the path of a library of this system that is in use."""
    lines = Path("/proc/self/maps").read_text(encoding="utf-8").splitlines()
    return next(path for line in lines if (path := Path(line.rpartition(" ")[2])).name == name)


ELF_MACHINES = {"x86_64": 62, "arm64": 183}


@pytest.mark.long
@pytest.mark.parametrize("name", LIBRARIES)
def test_a_library_is_of_its_system_and_processor(name: str) -> None:
    system, _, processor = name.partition("/")[0].partition(".")
    content = library(name)
    if system in ("linux", "android"):
        assert content.startswith(b"\x7fELF\x02\x01")
        assert int.from_bytes(content[18:20], "little") == ELF_MACHINES[processor]
        assert (b"\0libm.so\0" in content) == (system == "android")
        assert (b"libm.so.6\0" in content) == (system == "linux")
    elif system == "windows":
        start = int.from_bytes(content[60:64], "little")
        assert content[start : start + 6] == b"PE\0\0\x64\x86"
    elif system == "macos":
        assert content[:8] == bytes.fromhex("cafebabe00000002")
        assert content.count(bytes.fromhex("320000002000000001000000 00000b00")) == 2  # from macOS 11 on
    else:
        assert content.startswith(b"!<arch>\n")
        assert content.count(bytes.fromhex("cffaedfe0c000001")) == 2  # two sources for ARM, of 64 bits
        assert content.count(bytes.fromhex("320000001800000002000000 00000c00")) == 2  # for iOS 12
    assert all(name in content for name in (b"ear_open_sized", b"ear_godot"))
