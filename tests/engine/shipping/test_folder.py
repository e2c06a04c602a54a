"""A folder that was shipped builds and runs as it is, and nothing that was changed there is lost."""

import os
import re
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine import (
    ExportError,
    ExportOptions,
    ModelKind,
    MouthError,
    PresetError,
    export,
    for_files,
    load_preset,
    ship,
)
from phonemeengine.phonemes import Phoneme
from phonemeengine.shipping import targets
from phonemeengine.shipping.compiling import LIBRARIES
from tests.compiled_ears import CModel, EarLibrary, compiled, compiler
from tests.conftest import ROOT
from tests.engine.shipping.test_same_results import speech
from tests.models import centred_model

FILES = {
    "LICENSE",
    "preset.ear",
    "ear.h",
    "ear.c",
    "ear_kernels.h",
    "CMakeLists.txt",
    "Makefile",
    "README.md",
    "examples/files.h",
    "examples/wav.h",
    "examples/rhubarb_tsv.c",
    "examples/mouth_from_microphone.c",
}


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of the preset Learned, in which make has run."""
    folder = tmp_path_factory.mktemp("shipped")
    ship(load_preset("learned"), folder)
    make(folder, f"CC={compiler('clang')}").check_returncode()
    return folder


def make(folder: Path, *words: str) -> "subprocess.CompletedProcess[str]":
    flags = "CFLAGS=-std=c99 -O1 -Wall -Wextra -Wpedantic -Werror"
    return subprocess.run(["make", "-C", str(folder), flags, *words], capture_output=True, text=True, check=False)


def test_a_shipped_folder_has_the_preset_the_sources_examples_and_a_readme(built: Path) -> None:
    files = {path.relative_to(built).as_posix() for path in built.rglob("*") if path.is_file()}
    assert files >= FILES
    assert (built / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()
    readme = (built / "README.md").read_text(encoding="utf-8")
    assert all(
        name in readme
        for name in FILES
        if name.startswith(("ear", "preset", "Make", "CMake", "examples/r", "examples/m"))
    )


def test_the_examples_print_the_drawings_of_a_file_as_the_engine_exports_them(built: Path, tmp_path: Path) -> None:
    sound = tmp_path / "speech.wav"
    soundfile.write(sound, speech(), 44_100, subtype="PCM_16")
    words = [str(built / "rhubarb_tsv"), str(built / "preset.ear"), str(sound)]
    printed = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    live, options = for_files(load_preset("learned"), ModelKind.REAL_TIME), ExportOptions(anticipation=0.0)
    export(sound, tmp_path / "speech.tsv", "rhubarb-tsv", live, options)
    ours, theirs = (letters(text) for text in (printed, (tmp_path / "speech.tsv").read_text(encoding="utf-8")))
    assert len(ours) == len(theirs) == round(len(speech()) / 441)
    assert np.mean(ours == theirs) > 0.85  # looks ahead as live, and cleans less
    assert len(set(ours)) >= 6


def letters(text: str) -> np.ndarray:
    """Give the letter of each 10 ms of Rhubarb's lines."""
    rows = [line.split("\t") for line in text.splitlines()]
    starts, names = [round(100 * float(start)) for start, _ in rows], [name for _, name in rows]
    assert starts == sorted(starts)
    return np.repeat(names[:-1], np.diff(starts))


def test_a_mouth_follows_what_comes_from_a_microphone(built: Path) -> None:
    words = [str(built / "mouth_from_microphone"), str(built / "preset.ear")]
    said = subprocess.run(words, input=speech().tobytes(), capture_output=True, check=True).stdout.decode()
    lines = said.splitlines()
    assert len(lines) == len(speech()) // 882
    opened = {line.split()[2]: line.count("#") for line in lines}
    assert max(line.count("#") for line in lines) > 10
    assert opened.keys() >= {p.label for p in (Phoneme.SILENCE, Phoneme.A, Phoneme.E, Phoneme.SZ)}


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["preset.ear"], "name an .ear file and a WAV file"),
        (["preset.ear", "nothing.wav"], "this file cannot be opened; check its name"),
        (["preset.ear", "preset.ear"], "this is no WAV file; convert it to one"),
        (["README.md", "speech.wav"], "these bytes are no .ear file; make one with phonemeanalyser ship"),
        (["preset.ear", "float.wav"], "this WAV file holds no sound of 16 bits; convert it to that"),
        (["preset.ear", "slow.wav"], "the sample rate must lie in 1000..768000 Hz; record at another one"),
    ],
)
def test_what_the_example_cannot_use_is_refused_in_a_sentence(built: Path, words: list[str], sentence: str) -> None:
    for name, rate, subtype in (("speech", 44_100, "PCM_16"), ("float", 44_100, "FLOAT"), ("slow", 500, "PCM_16")):
        soundfile.write(built / f"{name}.wav", speech()[:4410], rate, subtype=subtype)
    done = subprocess.run(
        [str(built / "rhubarb_tsv"), *words], cwd=built, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert done.stderr.strip().endswith(sentence)
    assert len(done.stderr.splitlines()) == 1


def test_a_compiler_that_is_not_there_is_named(built: Path) -> None:
    done = make(built, "CC=no-such-compiler", "-B")
    assert done.returncode != 0
    assert "there is no C compiler no-such-compiler; install gcc or clang" in done.stderr


def test_a_new_preset_takes_the_place_of_the_old_one_and_changed_files_stay(
    tmp_path: Path, library: EarLibrary
) -> None:
    ship(load_preset("thesis"), tmp_path)
    ship(load_preset("templates"), tmp_path)
    content = (tmp_path / "preset.ear").read_bytes()
    assert library.c.ear_model_name(CModel(library, content).handle).decode() == load_preset("templates").name
    (tmp_path / "ear.c").write_text("mine", encoding="utf-8")
    with pytest.raises(ExportError, match=r"ear\.c: another file is there, or it was changed; choose another folder"):
        ship(load_preset("thesis"), tmp_path)
    assert (tmp_path / "preset.ear").read_bytes() == content
    ship(load_preset("thesis"), tmp_path, overwrite=True)
    assert (tmp_path / "ear.c").read_text(encoding="utf-8") != "mine"


def test_a_file_that_is_no_ear_file_is_never_taken_for_one(tmp_path: Path) -> None:
    (tmp_path / "preset.ear").write_text("my notes", encoding="utf-8")
    with pytest.raises(ExportError, match=r"preset\.ear: another file is there"):
        ship(load_preset("thesis"), tmp_path)


def test_what_cannot_be_shipped_is_refused_before_anything_is_written(tmp_path: Path, loudness: Path) -> None:
    learned, folder = load_preset("learned"), tmp_path / "new"
    with pytest.raises(ExportError, match="there is no target 'cobol'; choose one of c"):
        ship(learned, folder, "cobol")
    with pytest.raises(MouthError, match="there is no such mouth table"):
        ship(learned, folder, tables=["nothing"])
    with pytest.raises(ExportError, match="at most 16 mouth tables, each with a name of its own, got 2"):
        ship(learned, folder, tables=["arkit", "arkit"])
    with pytest.raises(PresetError, match="recognises files only, the runtime live sound only"):
        ship(replace(learned, model=centred_model()), folder)
    with pytest.raises(PresetError, match="is another package's, and only those of the program can be shipped"):
        ship(replace(load_preset("thesis"), recogniser="loudness"), folder)
    assert not folder.exists()


def test_a_folder_that_cannot_be_written_is_refused_in_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x", encoding="utf-8")
    with pytest.raises(ExportError, match=r"cannot be (read|written)"):
        ship(load_preset("thesis"), tmp_path / "file")


@pytest.mark.skipif(os.name == "nt", reason="the compiler's stand-in is a shell script")
@pytest.mark.parametrize("target", ["unity", "godot"])
def test_a_game_engine_gets_sources_libraries_and_a_readme_that_names_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, target: str
) -> None:
    zig = tmp_path / "zig"  # what the real one makes is tried by make test-csharp
    words = "#!/bin/sh\nfor last; do :; done\n[ $1 = ar ] && last=$4\nprintf 'a library of zig' > \"$last\"\n"
    zig.write_text(words, encoding="utf-8")
    zig.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    files = ship(load_preset("thesis"), tmp_path / target, target)
    assert {path.name for path in files} >= {"Ear.cs", "TalkingFace.cs", "libear.so", "ear.dll", "libear.dylib"}
    assert sum(path.read_bytes().startswith(b"EAR\x1a") for path in files) == 1
    licence = "LICENSE.md" if target == "unity" else "LICENSE"
    assert (tmp_path / target / licence).read_bytes() == (ROOT / "LICENSE").read_bytes()
    readme = (tmp_path / target / "README.md").read_text(encoding="utf-8")
    named = [path for path in files if path.suffix == ".cs" or path.name in ("preset.bytes", "preset.ear")]
    assert len(named) >= 5
    assert all(path.name in readme for path in named)
    if target == "godot":
        about = (tmp_path / target / "plugin.cfg").read_text(encoding="utf-8")
        keys = re.findall(r'^(\w+)="[^"]+"$', about, re.MULTILINE)
        assert keys == ["name", "description", "author", "version", "script"]
        assert 'script="plugin.gd"' in about
        extension = (tmp_path / target / "phoneme_ear.gdextension").read_text(encoding="utf-8")
        named = re.findall(r'="(bin/[^"]+|icons/[^"]+)"', extension)
        assert {path.relative_to(tmp_path / target).as_posix() for path in files} >= {*named}
        assert len(named) == len(LIBRARIES) + 1


SOURCES_OF_TARGETS = ("c", "csharp", "godot", "unity", "unreal", "web", "web_demo")
SIGNED = {".c", ".h", ".cpp", ".cs", ".js", ".jsx", ".gd", ".ts", ".css", ".html", ""}
"""Endings of files that can say their licence; a Makefile has none."""


@pytest.mark.parametrize("source", SOURCES_OF_TARGETS)
def test_every_source_that_is_shipped_says_its_licence(source: str) -> None:
    files = [path for path in (Path(targets.__file__).parent / source).rglob("*") if path.is_file()]
    said = {path.name: "SPDX-License-Identifier: MIT" in path.read_text("utf-8") for path in files}
    assert [path.name for path in files if path.suffix in SIGNED and not said[path.name]] == []
    assert any(said.values())


def test_every_target_has_sources_that_are_looked_through() -> None:
    assert {source for target in targets.TARGETS.values() for source in target.sources} == {*SOURCES_OF_TARGETS}


def test_the_page_keeps_all_of_its_scripts_for_when_there_is_no_network() -> None:
    place = Path(targets.__file__).parent / "web_demo"
    kept = set(re.findall(r'^  "(.+)",$', (place / "sw.js").read_text("utf-8"), re.MULTILINE))
    own = {path.name for path in place.iterdir() if path.suffix in (".js", ".css")} - {"sw.js"}
    packages = targets.NPM_PACKAGES.values()
    fetched = {f"{of.folder}/{name}" for of in packages for name in of.files if name.endswith(".js")}
    assert kept == own | fetched | {"./", "head.glb", "../ear.js", "../ear.wasm", "../preset.ear"}


EMBEDDED = """
#include <ear.h>
#include <preset.h>
#include <stdio.h>

int main(void)
{
    ear_model *model = NULL;
    int result = ear_model_open(preset_ear, preset_ear_size, NULL, 0, &model);
    puts(result == EAR_OK ? ear_model_name(model) : ear_error_text(result));
    ear_model_close(model);
    return result;
}
"""


def test_an_embedded_preset_is_opened_without_a_file_and_replaced_by_another_one(tmp_path: Path) -> None:
    for name in ("templates", "thesis"):
        ship(load_preset(name), tmp_path, embed=True)
    (tmp_path / "main.c").write_text(EMBEDDED, encoding="utf-8")
    sources = [tmp_path / name for name in ("main.c", "preset.c", "ear.c")]
    program = compiled("embedded", sources, "-O0", "-I", str(tmp_path))
    said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    assert said.strip() == load_preset("thesis").name


@pytest.mark.long
def test_cmake_installs_what_another_project_finds(tmp_path: Path) -> None:
    ship(load_preset("thesis"), tmp_path / "shipped", embed=True)
    for shared in ("ON", "OFF"):
        place, user = tmp_path / f"installed-{shared}", tmp_path / f"user-{shared}"
        cmake("-S", tmp_path / "shipped", "-B", tmp_path / shared, f"-DBUILD_SHARED_LIBS={shared}")
        cmake("--build", tmp_path / shared)
        cmake("--install", tmp_path / shared, "--prefix", place)
        user.mkdir()
        (user / "main.c").write_text(EMBEDDED, encoding="utf-8")
        (user / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.14)\nproject(user C)\nfind_package(ear 0.9 REQUIRED)\n"
            f"add_executable(user main.c {tmp_path}/shipped/preset.c)\n"
            f"target_include_directories(user PRIVATE {tmp_path}/shipped)\ntarget_link_libraries(user ear::ear)\n",
            encoding="utf-8",
        )
        cmake("-S", user, "-B", user / "build", f"-DCMAKE_PREFIX_PATH={place}")
        cmake("--build", user / "build")
        subprocess.run([user / "build" / "user"], check=True)


def cmake(*words: str | Path) -> None:
    done = subprocess.run(["cmake", *words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
