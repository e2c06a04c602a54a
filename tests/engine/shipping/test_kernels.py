"""The sums by hand are those of plain C99, on each processor that can be had."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.compiled_ears import compiled

PROBE = Path(__file__).parents[2] / "kernels_probe.c"
OTHERS = {
    "NEON": (("--target=aarch64-linux-musl",), ("qemu-aarch64-static",)),
    "AVX2 on Windows": (("--target=x86_64-windows-gnu",), ("/usr/lib/wine/wine64",)),
}


@pytest.mark.parametrize("flags", [("-O2",), ("-O1", "-DEAR_PLAIN")], ids=["vectors", "plain"])
def test_vectors_give_what_plain_c_gives(each_compiler: str, flags: tuple[str, ...]) -> None:
    done = subprocess.run(
        [compiled("kernels_probe", [PROBE], *flags, by=each_compiler)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout
    assert done.stdout.startswith("plain to the last bit\n")
    assert (len(done.stdout.splitlines()) > 1) == ("-O2" in flags)


@pytest.mark.long
@pytest.mark.parametrize("name", OTHERS)
def test_vectors_of_another_processor_give_what_plain_c_gives(name: str) -> None:
    flags, emulator = OTHERS[name]
    assert shutil.which(emulator[0]), f"there is no {emulator[0]}; install qemu-user-static and wine64"
    program = compiled("kernels_probe.exe", [PROBE], "-O2", *flags, by="zig")
    done = subprocess.run([*emulator, program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert done.stdout.count("but for roundings") == 1
