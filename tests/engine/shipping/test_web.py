"""The ear as WebAssembly hears and moves as the engine does, in the thread of the sound as well."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import ExportError, Morpher, Phoneme, load_preset, load_table, ship
from phonemeengine.labels.visemes import VISEME_PHONES, Viseme
from phonemeengine.mouth.blending import blended_weights
from phonemeengine.shipping import compiling, targets
from tests.engine.shipping.test_same_results import check_same, recognised_by_engine, says_several, speech
from tests.sounds import silence, vowel
from tests.web_ears import frames_of, in_node

needs_shell = pytest.mark.skipif(os.name == "nt", reason="the programs that fail are shell scripts")
MOST_BYTES = 1_500_000
"""Of module and model."""


def test_the_module_hears_what_the_engine_hears(web_module: Path) -> None:
    analysis = recognised_by_engine(load_preset("learned"), speech())
    assert says_several(analysis, 9)
    check_same(frames_of(in_node(web_module, "hear", speech())[0]), analysis)


def test_weights_by_probabilities_are_those_of_the_engine(web_module: Path) -> None:
    sound = speech()[: 3 * 44_100]
    expected = blended_weights(load_table("arkit"), recognised_by_engine(load_preset("learned"), sound))
    found = in_node(web_module, "blend", sound)[0].reshape(expected.shape)
    assert np.abs(found - expected).max() < 1e-3
    assert expected.max() > 0.2


def test_rules_hear_the_same_as_well(tmp_path: Path) -> None:
    preset = load_preset("extended")
    ship(preset, tmp_path, "web-module")
    check_same(frames_of(in_node(tmp_path, "hear", speech())[0]), recognised_by_engine(preset, speech()))


def test_in_the_thread_of_the_sound_it_hears_the_same_and_allocates_nothing(web_module: Path) -> None:
    sound = speech()[: 2 * 44_100]
    numbers, words = in_node(web_module, "listenInWorklet", sound)
    growth, goes_on = words.splitlines()
    frames, whole = frames_of(numbers), frames_of(in_node(web_module, "hear", sound)[0])
    assert len(frames) > 190
    assert (frames == whole[: len(frames)]).all()
    assert float(growth) < 12  # bytes for each block of 128 samples; the least object has 16
    assert goes_on == "true false false"  # while nothing is connected, and after it was closed


def test_a_microphone_of_48_khz_is_heard(web_module: Path) -> None:
    sound = np.concatenate((silence(0.5), vowel((700, 1200, 2500), 0.5)))
    frames = frames_of(in_node(web_module, "hear", sound, 48_000)[0])
    assert len(frames) == -(-len(sound) * 100 // 48_000)
    assert (frames["phoneme"][:20] == Phoneme.SILENCE).all()
    assert (frames["intensity"][-20:-2] > 0).all()


def test_the_mouth_moves_as_the_morpher_does(web_module: Path) -> None:
    rng = np.random.default_rng(3)
    times, phonemes = np.cumsum(rng.uniform(0.0, 0.2, 60)).astype(np.float32), rng.integers(1, len(Phoneme), 60)
    visemes, loud = rng.integers(1, len(Viseme), 60), rng.uniform(0, 1, 60).astype(np.float32)
    given = np.stack((times, phonemes, visemes, loud), axis=1)
    morpher, expected = Morpher(load_table("arkit"), seed=7), []
    for time, phoneme, viseme, intensity in zip(times, phonemes, visemes, loud, strict=True):
        phone = VISEME_PHONES.get(Viseme(viseme), "")
        morpher.add(float(time), Phoneme(phoneme), float(intensity), phone)
        expected.append(morpher.weights(float(time)))
    found = in_node(web_module, "move", given.ravel())[0].reshape(len(times), -1)
    assert np.abs(found - np.array(expected)).max() < 1e-5


def test_the_module_tells_what_it_knows_and_asks_its_page_for_nothing(web_module: Path) -> None:
    told = json.loads(in_node(web_module, "tell", silence(0.0))[1])
    table = load_table("rhubarb")
    assert told["imports"] == []
    assert told["phonemes"] == [phoneme.label for phoneme in Phoneme]
    assert told["visemes"] == [viseme.label for viseme in Viseme]
    assert told["tables"] == ["arkit", "rhubarb", "vrm1"]
    assert told["shapes"] == [table.phonemes[phoneme] for phoneme in Phoneme]
    assert (told["name"], told["lookAhead"]) == ("Learned", 0.01)
    assert 95 <= told["frames"] <= 100


def test_what_cannot_be_opened_is_refused_in_a_sentence(web_module: Path) -> None:
    refused = in_node(web_module, "refuse", silence(0.0))[1].splitlines()
    for line, words in zip(
        refused,
        (
            "is damaged or cut off",
            "are no .ear file",
            "the version of ear.wasm is 0.0.0, that of ear.js 0.9.0; take both from one package",
            "the version of ear.wasm is unknown",
            "must lie in 1000..768000 Hz",
            "choose one of",
            "must lie in 1000..768000 Hz",
            "at most 4096 samples at once, got 4097; push takes any number",
            *["this ear was closed; open another one"] * 4,
            *["this mouth was closed; open another one"] * 2,
        ),
        strict=True,
    ):
        assert line.startswith("EarError: ")
        assert words in line


def test_a_module_with_its_model_is_small_and_makes_a_package(web_module: Path) -> None:
    assert sum((web_module / name).stat().st_size for name in ("ear.wasm", "preset.ear")) <= MOST_BYTES
    package = json.loads((web_module / "package.json").read_text(encoding="utf-8"))
    assert {"name", "version", "license"} <= package.keys()
    assert "dependencies" not in package
    assert all((web_module / name).exists() for name in (*package["files"], package["types"], "README.md"))
    readme = (web_module / "README.md").read_text(encoding="utf-8")
    assert all(f"`{name}`" in readme for name in package["files"])


def test_a_compiler_that_is_not_there_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setitem(sys.modules, "ziglang", None)
    with pytest.raises(ExportError, match=r"compiled by zig, which is not installed; install zig, or pip install"):
        compiling.prebuild(tmp_path)
    assert list(tmp_path.iterdir()) == []


@needs_shell
def test_a_compiler_that_fails_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    script(tmp_path / "zig", "echo 'x: error: unknown target' >&2; exit 1")
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    with pytest.raises(
        ExportError, match=r"cannot compile the runtime \(x: error: unknown target\); install a newer one"
    ):
        compiling.prebuild(tmp_path)


@needs_shell
def test_a_page_without_npm_or_network_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(ExportError, match=r"there is no npm; install Node.js, or ship the target web-module"):
        targets.npm_files()
    script(tmp_path / "npm", "exit 1")
    with pytest.raises(ExportError, match=r"npm cannot fetch three@\S+ and @pixiv/\S+; connect to the network"):
        targets.npm_files()
    script(tmp_path / "npm", 'printf x > "$4/three.tgz"')
    with pytest.raises(ExportError, match="npm fetched another three@"):
        targets.npm_files()


def script(path: Path, line: str) -> None:
    path.write_text(f"#!/bin/sh\n{line}\n", encoding="utf-8")
    path.chmod(0o755)
    assert subprocess.run(["/bin/sh", "-n", str(path)], check=False).returncode == 0
