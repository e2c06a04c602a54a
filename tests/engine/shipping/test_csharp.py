"""The C# for Unity and Godot: compiled by Mono, and run with the library for Linux."""

import os
import re
import shutil
import struct
import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

import phonemeengine
from phonemeengine import Morpher, Phoneme, load_preset, load_table, ship
from phonemeengine.labels.visemes import NO_VISEME, VISEME_PHONES, Viseme
from phonemeengine.mouth.blending import blended_weights
from phonemeengine.shipping import targets
from phonemeengine.shipping.targets import format_ear
from phonemeengine.shipping.unity_package import package_files
from tests.compiled_ears import SOURCES, Frames
from tests.compiled_ears import compiled as compiled_library
from tests.engine.shipping.test_same_results import check_same, recognised_by_engine, speech
from tests.sounds import Sound
from tests.web_ears import ROW, frames_of

pytestmark = pytest.mark.csharp

OURS = Path(__file__).parents[2] / "csharp"
SHIPPING = Path(targets.__file__).parent
QUEUE = SHIPPING / "unity" / "Runtime" / "FrameQueue.cs"
SOUND = speech()[: 6 * 44_100]


@pytest.fixture(scope="module", params=["unity", "godot"])
def folder(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The preset Learned, shipped for an engine."""
    place = tmp_path_factory.mktemp(request.param)
    ship(load_preset("learned"), place, request.param)
    return place


def compiled(target: Path, sources: list[Path], *words: str) -> None:
    kind = "library" if target.suffix == ".dll" else "exe"
    assert shutil.which("mcs"), "there is no C# compiler; install mono-mcs and mono-runtime"
    flags = "-langversion:7.2", "-warnaserror", f"-target:{kind}", f"-out:{target}", *words
    done = subprocess.run(["mcs", *flags, *map(str, sources)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def listen(folder: Path, tmp_path: Path, preset: Path) -> "subprocess.CompletedProcess[bytes]":
    program = tmp_path / "Listen.exe"
    compiled(program, [OURS / "Listen.cs", QUEUE, *folder.rglob("Ear.cs")])
    (library,) = (path for path in folder.rglob("libear.so") if path.parent.name in ("x86_64", "linux.x86_64"))
    return in_mono(program, library, str(preset), "44100")


def in_mono(program: Path, library: Path, *words: str, sound: Sound = SOUND) -> "subprocess.CompletedProcess[bytes]":
    """Run a program that finds the ear's library."""
    environment = {**os.environ, "LD_LIBRARY_PATH": str(library.parent)}
    command = ["mono", str(program), *words]
    heard, where = sound.tobytes(), program.parent  # where Mono writes what it knows of a crash
    return subprocess.run(command, input=heard, capture_output=True, env=environment, cwd=where, check=False)


def native_library() -> Path:
    return compiled_library("libear.so", [SOURCES / "ear.c"], "-O3", "-shared", "-fPIC")


def test_it_hears_and_moves_as_the_engine_does(folder: Path, tmp_path: Path) -> None:
    (preset,) = (path for path in folder.glob("preset.*") if path.suffix != ".meta")
    done = listen(folder, tmp_path, preset)
    assert done.returncode == 0, done.stderr.decode()
    numbers = np.frombuffer(done.stdout, np.float64)
    analysis = recognised_by_engine(load_preset("learned"), SOUND)
    n = ROW * len(analysis)
    frames = frames_of(numbers[:n])
    check_same(frames, analysis)
    found, blended = np.split(numbers[n:].reshape(len(frames), -1), 2, axis=1)
    assert np.abs(found - weights_of(frames)).max() < 1e-5
    assert np.abs(blended - blended_weights(load_table("arkit"), analysis)).max() < 1e-3
    assert found.max() > 0.3


def weights_of(frames: Frames) -> np.ndarray:
    """Give the weights of the morpher for the same frames."""
    morpher, found = Morpher(load_table("arkit"), seed=7), []
    for frame in frames:
        time, viseme = int(frame["number"]) / 100, int(frame["viseme"])
        phone = "" if viseme == NO_VISEME else VISEME_PHONES.get(Viseme(viseme), "")
        morpher.add(time, Phoneme(int(frame["phoneme"])), float(frame["intensity"]), phone)
        found.append(morpher.weights(time))
    return np.array(found)


def test_the_components_compile(folder: Path, tmp_path: Path) -> None:
    is_unity = (folder / "Runtime").exists()
    stand_ins = OURS / ("UnityEngine.cs" if is_unity else "Godot.cs")
    for system in ("UNITY_EDITOR", "UNITY_WEBGL"):
        compiled(tmp_path / "components.dll", [stand_ins, *folder.rglob("*.cs")], f"-define:{system}")


SHAPES = ("jawOpen", "mouthClose", "mouthFunnel", "Smile")
GONE = "Error: Actor: the microphone was taken away; connect it, and switch the component on again"
COMPONENTS = {
    "Unity": [
        SHIPPING / "unity" / "Runtime" / name for name in ("EarListener.cs", "TalkingFace.cs", "FrameQueue.cs")
    ],
    "Godot": [SHIPPING / "godot" / name for name in ("EarListener.cs", "TalkingFace.cs", "EarLibrary.cs")],
}


@pytest.fixture(scope="module", params=["Unity", "Godot"])
def player(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A program that plays an engine's side, beside the library."""
    program = tmp_path_factory.mktemp("player") / f"Play{request.param}.exe"
    shutil.copy(native_library(), program.parent)
    stand_ins = OURS / {"Unity": "UnityEngine.cs", "Godot": "Godot.cs"}[request.param]
    ours = OURS / f"{program.stem}.cs", stand_ins, SHIPPING / "csharp" / "Ear.cs"
    compiled(program, [*ours, *COMPONENTS[request.param]])
    return program


def played(
    player: Path, content: bytes, *, shapes: Sequence[str] = SHAPES, sound: Sound = SOUND
) -> tuple[Sound, str]:
    (player.parent / "preset").write_bytes(content)
    words = str(player.parent / "preset"), "44100", ",".join(shapes)
    done = in_mono(player, player.parent / "libear.so", *words, sound=sound)
    assert done.returncode == 0, done.stderr.decode()
    return np.frombuffer(done.stdout).reshape(-1, len(SHAPES)), done.stderr.decode().strip()


def test_a_face_follows_a_microphone_until_it_is_taken_away(player: Path) -> None:
    moved, said = played(player, format_ear(load_preset("learned")))
    analysis = recognised_by_engine(load_preset("learned"), SOUND)
    table, morpher, expected = load_table("arkit"), Morpher(load_table("arkit"), seed=1), []
    columns = [table.movestates.index(name) for name in SHAPES[:3]]
    for k, phone in enumerate(analysis.viseme_phones):
        morpher.add(k / 100, Phoneme(analysis.phonemes[k]), float(analysis.intensities[k]), phone)
        expected.append(morpher.weights(k / 100)[columns])
    is_unity = player.stem == "PlayUnity"
    # A picture shows what came before it, or with it; its window ends later, and the network looks ahead.
    late, whole, n = (4, 100, len(expected) - 4) if is_unity else (3, 1, len(expected) - 4)
    np.testing.assert_allclose(moved[late : late + n, :3] / whole, expected[:n], atol=1e-3)
    assert moved.max() > 0.3 * whole
    assert said == (GONE if is_unity else "")  # in Godot a bus without its microphone is silent
    assert moved[-1, 0] < 0.01 * whole  # and the jaw shuts


@pytest.mark.parametrize(
    ("case", "words"),
    [
        ("none", "Error: Actor: there is no (microphone; connect one|bus Voice with the effect Capture; add them)"),
        ("bare", "Warning: Head: it has no blend shape of the table arkit, such as eyeBlinkLeft"),
        ("newer", "Error: Actor: this .ear file is of a newer version"),
    ],
)
def test_what_a_face_cannot_do_is_a_sentence(case: str, words: str, player: Path) -> None:
    content = format_ear(load_preset("thesis"))
    if case == "newer":
        content = content[:4] + b"\4\0\0\0" + content[8:]
    shapes, sound = (["Smile"] if case == "bare" else SHAPES), (SOUND[:0] if case == "none" else SOUND[:4410])
    assert re.match(words, played(player, content, shapes=shapes, sound=sound)[1])


@pytest.mark.parametrize(("form", "said"), [("phonemeanalyser curves 1", ""), ("other", "these are no curves")])
def test_a_clip_of_the_timeline_moves_a_mesh_by_exported_curves(form: str, said: str, tmp_path: Path) -> None:
    runtime, program = SHIPPING / "unity" / "Runtime", tmp_path / "PlayTimeline.exe"
    sources = [*runtime.rglob("*.cs"), SHIPPING / "csharp" / "Ear.cs", OURS / "UnityEngine.cs"]
    compiled(program, [OURS / "PlayTimeline.cs", *sources])
    values = np.random.default_rng(1).uniform(size=50).astype(np.float32)
    done = in_mono(program, native_library(), form, "25", "jawOpen", sound=values)
    duration, *weights, after = np.frombuffer(done.stdout)
    expected = np.interp(np.arange(150) / 3, np.arange(50), values) * (0 if said else 100)
    np.testing.assert_allclose(weights, expected, atol=1e-3)
    assert (duration, after, said in done.stderr.decode()) == (0 if said else 2, 0, True)


def test_the_window_guesses_blend_shapes_by_what_programs_call_them(tmp_path: Path) -> None:
    names, program = tmp_path / "names.txt", tmp_path / "Guess.exe"
    names.write_bytes(package_files({}, "")["Editor/shape_names.txt"])
    compiled(program, [OURS / "Guess.cs", SHIPPING / "unity" / "Editor" / "ShapeGuess.cs"])
    states = "jawOpen,mouthSmileLeft,mouthSmileRight,jawLeft,mouthPucker,eyeBlinkRight,tongueOut"
    face = "head.Jaw_Drop,Mouth_Smile_L,Mouth_Smile_R,Jaw_L,lipsPucker,Eye_Blink_R,nothing"
    done = in_mono(program, tmp_path, str(names), states, face).stdout.decode().splitlines()
    assert done == [*face.split(",")[:-1], ""]


def test_what_cannot_be_opened_is_an_exception_with_a_sentence(folder: Path, tmp_path: Path) -> None:
    done = listen(folder, tmp_path, folder / "README.md")
    assert done.returncode == 1
    assert done.stderr.decode().strip() == "these bytes are no .ear file; make one with phonemeanalyser ship"


@pytest.mark.parametrize("is_there", [True, False])
def test_a_library_that_is_older_or_not_there_is_an_exception_with_a_sentence(is_there: bool, tmp_path: Path) -> None:
    program, library = tmp_path / "Listen.exe", tmp_path / "libear.so"
    compiled(program, [OURS / "Listen.cs", QUEUE, SHIPPING / "csharp" / "Ear.cs"])
    if is_there:
        version = phonemeengine.__version__.encode()
        older = native_library().read_bytes().replace(version, re.sub(rb"\d", b"0", version))
        library.write_bytes(older)
    done = in_mono(program, library, str(OURS / "Listen.cs"), "44100")
    words = "the library ear has the version 0.0.0" if is_there else "the library ear cannot be used"
    assert (done.returncode, done.stderr.decode()[: len(words)]) == (1, words)


def test_the_library_of_macos_is_for_both_processors(folder: Path) -> None:
    (library,) = folder.rglob("libear.dylib")
    (windows,) = folder.rglob("ear.dll")
    content = library.read_bytes()
    assert content[:8] == bytes.fromhex("cafebabe00000002")
    for k, processor in enumerate((0x01000007, 0x0100000C)):  # x86-64 and ARM
        kind, _, at, size, _ = np.frombuffer(content, ">u4", 5, 8 + 20 * k)
        assert kind == processor
        assert content[at : at + 4] == bytes.fromhex("cffaedfe")
        assert at + size <= len(content)
        assert oldest_macos(content[at : at + size]) == 11
    assert b"\0ear.dll\0" in windows.read_bytes()
    assert windows.read_bytes()[:2] == b"MZ"


def test_what_was_disposed_of_is_refused_by_every_member(tmp_path: Path) -> None:
    program, preset = tmp_path / "Disposed.exe", tmp_path / "preset.ear"
    preset.write_bytes(format_ear(load_preset("thesis")))
    compiled(program, [OURS / "Disposed.cs", SHIPPING / "csharp" / "Ear.cs"])
    library = native_library()
    done = in_mono(program, library, str(preset))
    assert done.returncode == 0, done.stderr.decode()
    lines = done.stdout.decode().splitlines()
    assert len(lines) >= 6 + 2 * (5 + 3)
    assert [line for line in lines if not line.endswith(" ObjectDisposedException")] == []


def oldest_macos(library: bytes) -> int:
    """Give the version that a library asks for: its command LC_BUILD_VERSION."""
    (n_commands,), at = struct.unpack_from("<I", library, 16), 32
    for _ in range(n_commands):
        kind, size = struct.unpack_from("<II", library, at)
        if kind == 0x32:
            return int(struct.unpack_from("<I", library, at + 12)[0]) >> 16
        at += size
    raise AssertionError("it names no version")
