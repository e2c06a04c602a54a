"""The extension for Godot: a program that plays the engine's side of the interface gets what Python finds."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import load_preset, load_table
from phonemeengine.mouth.blending import blended_weights
from phonemeengine.recognition.scores import scores_in
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import SANITIZED, SOURCES, compiled, ear_library
from tests.engine.shipping.test_same_results import recognised_by_engine, speech

EXTENSION = SOURCES.with_name("gdextension")
HOST = Path(__file__).parents[2] / "godot_host.c"
SOUND = speech()[: 3 * 44_100]


def hosted(folder: Path, content: bytes, table: str = "arkit") -> "subprocess.CompletedProcess[bytes]":
    """Have the class recognise the sound with the file of a preset, in a program that checks each use of memory."""
    words = *SANITIZED, "-I", str(EXTENSION)
    ear = [str(ear_library().path), f"-Wl,-rpath,{ear_library().path.parent}"]
    library = compiled("libear_godot.so", [EXTENSION / "ear_godot.c"], *words, *ear, "-fPIC", "-shared")
    (folder / "preset.ear").write_bytes(content)
    command = [compiled("godot_host", [HOST], *words, "-ldl"), library, folder / "preset.ear", "44100", table]
    return subprocess.run(command, input=SOUND.tobytes(), capture_output=True, check=False)


def test_a_script_gets_what_the_engine_finds(tmp_path: Path) -> None:
    done = hosted(tmp_path, format_ear(load_preset("learned")))
    assert done.returncode == 0, done.stderr.decode()
    analysis = recognised_by_engine(load_preset("learned"), SOUND)
    numbers = np.frombuffer(done.stdout).reshape(len(analysis), -1)
    phonemes, visemes, intensities, confidences, *_ = numbers.T
    assert (phonemes == analysis.phonemes).mean() >= 0.999
    assert (visemes == analysis.visemes).mean() >= 0.999
    assert np.abs(intensities - analysis.intensities).max() < 1e-3
    assert np.abs(confidences - analysis.confidences).max() < 1e-3
    scores, seen, blend = np.split(numbers[:, 4:], [11, 26], axis=1)
    expected = scores_in(analysis.features)
    assert expected is not None
    assert analysis.viseme_scores is not None
    assert np.abs(scores - expected).max() < 1e-3
    assert np.abs(seen - analysis.viseme_scores).max() < 1e-3
    assert np.abs(blend - blended_weights(load_table("arkit"), analysis)).max() < 1e-3


@pytest.mark.parametrize(
    ("content", "table", "words"),
    [
        (b"notes", "arkit", "these bytes are no .ear file; make one with phonemeanalyser ship"),
        (None, "mine", "the preset has no mouth table of this name; ship it with --table"),
    ],
)
def test_what_cannot_be_opened_is_a_sentence(tmp_path: Path, content: bytes | None, table: str, words: str) -> None:
    done = hosted(tmp_path, content or format_ear(load_preset("thesis")), table)
    assert done.returncode == 0
    assert done.stdout == b""
    assert done.stderr.decode().startswith(words)


@pytest.mark.csharp
def test_gdtoolkit_finds_nothing_wrong_in_the_scripts() -> None:
    from gdtoolkit.linter import lint_code  # of the extra test-godot
    from gdtoolkit.parser import parser

    scripts = sorted(SOURCES.with_name("godot").rglob("*.gd"))
    assert len(scripts) >= 6
    for script in scripts:
        code = script.read_text(encoding="utf-8")
        parser.parse(code)
        assert [(script.name, found.line, found.description) for found in lint_code(code)] == []
