"""The sums by hand are those of plain C99, on each processor that can be had."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.compiled_ears import SOURCES, compiled, compiler

PROBE = Path(__file__).parents[2] / "kernels_probe.c"
OTHERS = {
    "NEON": (("--target=aarch64-linux-musl",), ("qemu-aarch64-static",)),
    "AVX2 on Windows": (("--target=x86_64-windows-gnu",), ("/usr/lib/wine/wine64",)),
}


@pytest.mark.parametrize(("by", "flags"), [("gcc", ("-O2",)), ("clang", ("-O1", "-DEAR_PLAIN"))])
def test_vectors_give_what_plain_c_gives(by: str, flags: tuple[str, ...]) -> None:
    program = compiled("kernels_probe", [PROBE], *flags, by=compiler(by))
    done = subprocess.run([program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert done.stdout.startswith("plain to the last bit\n")
    assert (len(done.stdout.splitlines()) > 1) == ("-O2" in flags)


def test_clang_with_the_rules_of_microsoft_compiles_the_vectors(tmp_path: Path) -> None:
    declared = SOURCES.with_name("declared")
    (tmp_path / "malloc.h").write_text("#include <stdlib.h>\n", encoding="utf-8")  # which clang's own headers include
    system = "--target=x86_64-pc-windows-msvc", "-nostdlibinc", "-isystem", declared, "-isystem", tmp_path
    made = tmp_path / "ear.o"
    words = [compiler("clang"), "-std=c99", *system, "-O0", "-w", "-c", SOURCES / "ear.c", "-o", made]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert b"AVX2" in made.read_bytes()


@pytest.mark.long
@pytest.mark.parametrize("name", OTHERS)
def test_vectors_of_another_processor_give_what_plain_c_gives(name: str) -> None:
    flags, emulator = OTHERS[name]
    assert shutil.which(emulator[0]), f"there is no {emulator[0]}; install qemu-user-static and wine64"
    program = compiled("kernels_probe.exe", [PROBE], "-O2", *flags, by="zig")
    done = subprocess.run([*emulator, program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert done.stdout.count("but for roundings") == 1
