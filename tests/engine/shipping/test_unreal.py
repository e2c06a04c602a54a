"""The plugin for Unreal: its layout; and, compiled against stand-ins, it moves a mesh as Python does."""

import json
import re
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import Morpher, Phoneme, load_preset, load_table, ship
from phonemeengine.labels.visemes import NO_VISEME, VISEME_PHONES, Viseme
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import SOURCES, compiled, compiler
from tests.engine.shipping.test_same_results import recognised_by_engine, speech

STAND_INS = Path(__file__).parents[2] / "unreal"
SOUND = speech()[: 3 * 44_100]
SHAPES = ("jawOpen", "mouthClose", "mouthFunnel", "mouthPucker", "mouthSmileLeft")
MODULES = {
    "AudioCapture": {"AudioCapture.h"},
    "Core": {
        "Containers/CircularQueue.h",
        "CoreMinimal.h",
        "HAL/CriticalSection.h",
        "HAL/PlatformProcess.h",
        "HAL/PlatformTime.h",
        "Misc/FileHelper.h",
        "Misc/Paths.h",
        "Misc/ScopeLock.h",
        "Modules/ModuleManager.h",
        "Templates/SharedPointer.h",
    },
    "CoreUObject": {"UObject/StrongObjectPtr.h"},
    "Engine": {
        "AudioDevice.h",
        "AudioDeviceManager.h",
        "Components/ActorComponent.h",
        "Components/SkeletalMeshComponent.h",
        "Engine/World.h",
        "GameFramework/Actor.h",
        "ISubmixBufferListener.h",
        "Sound/SoundSubmix.h",
    },
    "LiveLinkInterface": {
        "ILiveLinkClient.h",
        "ILiveLinkSource.h",
        "LiveLinkSourceFactory.h",
        "LiveLinkTypes.h",
        "Roles/LiveLinkBasicRole.h",
    },
    "Projects": {"Interfaces/IPluginManager.h"},
}
"""The modules of Unreal with the headers that the plugin includes."""


@pytest.fixture(scope="module")
def plugin(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The preset Learned, shipped for Unreal."""
    place = tmp_path_factory.mktemp("PhonemeEar")
    ship(load_preset("learned"), place, "unreal")
    return place


@cache
def included(plugin: Path) -> set[str]:
    """Give the headers of Unreal that the plugin includes."""
    found: set[str] = set()
    for path in plugin.rglob("Phoneme*.[ch]*"):
        found |= set(re.findall(r'#include "([^"]+)"', path.read_text("utf-8")))
    return {name for name in found if not any(plugin.rglob(name)) and not name.endswith(".generated.h")}


def test_the_plugin_has_what_unreal_asks_for(plugin: Path) -> None:
    about = json.loads((plugin / "PhonemeEar.uplugin").read_text("utf-8"))
    assert about["FileVersion"] == 3
    (module,) = about["Modules"]
    rules = (plugin / "Source" / module["Name"] / f"{module['Name']}.Build.cs").read_text("utf-8")
    assert f"class {module['Name']} : ModuleRules" in rules
    assert "$(PluginDir)/Resources/preset.ear" in rules
    readme = (plugin / "README.md").read_text("utf-8")
    assert all(path.name in readme for path in plugin.rglob("*") if path.is_file() and path.name != "README.md")


def test_the_rules_name_the_module_of_each_header(plugin: Path) -> None:
    assert included(plugin) == set().union(*MODULES.values())
    rules = (plugin / "Source" / "PhonemeEar" / "PhonemeEar.Build.cs").read_text("utf-8")
    named = {
        word for line in re.findall(r"AddRange\(new\[\] \{(.+)\}\)", rules) for word in re.findall(r'"(\w+)"', line)
    }
    assert named == MODULES.keys() | {"AudioMixer"}  # which has the base of AudioCapture's class


def test_each_class_that_unreal_reflects_includes_its_generated_header_last(plugin: Path) -> None:
    headers = [path for path in plugin.rglob("*.h") if "GENERATED_BODY()" in path.read_text("utf-8")]
    assert {path.name for path in headers} == {"PhonemeEarComponent.h", "PhonemeLiveLink.h"}
    for path in headers:
        assert re.findall(r'#include "(.+)"', path.read_text("utf-8"))[-1] == f"{path.stem}.generated.h"


@pytest.fixture(scope="module")
def program(plugin: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The plugin in a program that plays the engine's part."""
    place = tmp_path_factory.mktemp("unreal")
    for name in (*included(plugin), "PhonemeEarComponent.generated.h", "PhonemeLiveLink.generated.h"):
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_text(f'#include "{STAND_INS / "UnrealStandIns.h"}"\n', encoding="utf-8")
    folders = (place, plugin / "Source/PhonemeEar/Public", plugin / "Source/PhonemeEar/Private")
    sources = sorted(plugin.rglob("Phoneme*.cpp")), STAND_INS / "play.cpp"
    warnings = "-Wall", "-Wextra", "-Wshadow", "-Wundef", "-Werror"
    flags = "-std=c++20", "-O1", *warnings, *(f"-I{folder}" for folder in folders)
    runtime = compiled("ear.o", [SOURCES / "ear.c"], "-O2", "-c", "-Wshadow", "-Wundef")
    command = [compiler("g++", "clang++"), *flags, *sources[0], sources[1], runtime, "-lm", "-o", place / "play"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return place / "play"


def played(program: Path, plugin: Path, sound: str) -> tuple[np.ndarray, str]:
    """Give the weights of SHAPES after each 10 ms, and what was logged."""
    stereo = np.repeat(SOUND, 2)
    done = subprocess.run([program, plugin, sound], input=stereo.tobytes(), capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    return np.frombuffer(done.stdout).reshape(-1, len(SHAPES)), done.stderr.decode().strip()


GONE = "the microphone was taken away; connect it, and start again"


@pytest.mark.csharp
@pytest.mark.parametrize("sound", ["microphone", "submix", "pushed", "live-link"])
def test_the_face_moves_as_the_engine_moves_it(sound: str, program: Path, plugin: Path) -> None:
    found, said = played(program, plugin, sound)
    analysis = recognised_by_engine(load_preset("learned"), SOUND)
    morpher, table = Morpher(load_table("arkit"), seed=1), load_table("arkit")
    columns, expected = [table.movestates.index(name) for name in SHAPES], []
    assert analysis.visemes is not None
    for k, (phoneme, viseme, loud) in enumerate(
        zip(analysis.phonemes, analysis.visemes, analysis.intensities, strict=True)
    ):
        phone = "" if viseme == NO_VISEME else VISEME_PHONES.get(Viseme(viseme), "")
        morpher.add((k + 1) / 100, Phoneme(phoneme), float(loud), phone)
        expected.append(morpher.weights((k + 1) / 100)[columns])
    shown = slice(0, 4) if sound == "live-link" else slice(None)  # the subject has no "Smile", a name of the mesh
    moved = np.array(expected)[:, shown]
    least = min(np.abs(found[late:, shown] - moved[: len(found) - late]).max() for late in range(2, 6))  # frames
    assert least < 1e-3
    assert found.max() > 0.3
    assert (GONE in said) == (sound in ("microphone", "live-link"))


@pytest.mark.csharp
@pytest.mark.parametrize(
    ("sound", "words"),
    [
        ("none", "Error: Actor: the microphone cannot be opened; connect one"),
        ("table", "Error: Actor: the preset has no mouth table mine; ship it with --table"),
        ("bare", "Warning: Actor: no mesh has a morph target of the table arkit, such as eyeBlinkLeft"),
    ],
)
def test_what_cannot_be_done_is_a_sentence_in_the_log(sound: str, words: str, program: Path, plugin: Path) -> None:
    assert played(program, plugin, sound)[1].startswith(words)


@pytest.mark.csharp
def test_a_preset_from_a_newer_version_is_refused_in_a_sentence(program: Path, tmp_path: Path) -> None:
    content = format_ear(load_preset("thesis"))
    (tmp_path / "Resources").mkdir()
    (tmp_path / "Resources" / "preset.ear").write_bytes(content[:4] + b"\4\0\0\0" + content[8:])
    assert "newer" in played(program, tmp_path, "microphone")[1]
    (tmp_path / "Resources" / "preset.ear").unlink()
    assert "preset.ear cannot be read; ship the plugin again" in played(program, tmp_path, "microphone")[1]
