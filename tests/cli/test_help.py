"""The help of each command: one sentence, the options, and three examples, which run."""

import importlib
import re
import shlex
import shutil
from argparse import ArgumentParser
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli import movestates, performance
from phonemeanalyser.cli.main import COMMANDS, main
from phonemeanalyser.cli.window import DEMO
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.phonemes import Phoneme
from tests.conftest import CORPUS
from tests.fakes.portaudio import FakePortAudio
from tests.graphics import context_or_skip
from tests.meshes import CUBE_OBJ
from tests.sounds import noise, vowel
from tests.tables import Capsys

PARTED = {"movestates": movestates, "performance": performance}
"""Commands that do several things, by name."""
SLOW = {"preview", "rules", "screenshot"}
"""Commands whose tests run them otherwise, and shorter."""
FIRST_SENTENCE = 4.2
"""Seconds of the demo."""
FIRST_WORD = 0.1
"""The same of what is drawn, which is slow without a graphics card."""
TEXT = "She sells sea shells, maybe, on the shore near my house."
READ_ALONE = {
    "listen": "it goes on until Ctrl-C",
    "record voice.wav": "it goes on until Ctrl-C",
    "record voice.wav --device Yeti --fill-gaps": "it goes on until Ctrl-C",
    "record voice.flac --seconds 5 --phonemes": "it takes these seconds; tests/devices records",
    "adapt my-takes -o my-voice.toml": "it learns for long; tests/training/test_learning_cli.py has a small network",
    "adapt speech.wav --script speech.txt --language en-us -o my-reading.toml": "as above",
    "serve": "it goes on until Ctrl-C",
    "train": "it takes hours; tests/training/test_learning_cli.py trains a small network",
    "takes my-takes --empty-deleted": "it asks a question",
    "whisper --fetch": "it downloads a model",
    "ship learned -o page --target web": "it compiles; tests/engine/shipping does it once",
    "": "it opens the window on a display",
    "speech.wav --preset my-voice.toml": "it opens the window on a display",
}
"""Examples whose words are read but not run, and why: command lines, or commands, without the program's name."""


def examples_of(command: str) -> tuple[str, ...]:
    return importlib.import_module(f"phonemeanalyser.cli.{command}").EXAMPLES


def words_of(example: str) -> list[str]:
    program, *words = shlex.split(example)
    assert program == "phonemeanalyser"
    return words


def help_of(capsys: Capsys, *words: str) -> str:
    with pytest.raises(SystemExit) as ended:
        main([*words, "--help"])
    assert ended.value.code == 0
    return capsys.readouterr().out


@pytest.mark.parametrize("command", [*COMMANDS, "window"])
def test_help_begins_with_a_sentence_and_ends_with_three_examples(command: str, capsys: Capsys) -> None:
    words = [] if command == "window" else [command]
    found = help_of(capsys, *words).rstrip().split("\n\n")
    assert re.fullmatch(r"[A-Z][^\n]+\.", found[0])
    assert found[1].startswith(" ".join(("usage: phonemeanalyser", *words, "[OPTIONS]")))
    assert found[-1].splitlines() == ["examples:", *(f"  {example}" for example in examples_of(command))]
    assert len(examples_of(command)) == 3
    assert all(words_of(example)[: len(words)] == words for example in examples_of(command))


@pytest.mark.parametrize(
    ("command", "what"), [(command, what) for command, module in PARTED.items() for what in module.EXAMPLES_OF]
)
def test_help_of_what_a_command_does_has_a_sentence_and_three_examples(
    command: str, what: str, capsys: Capsys
) -> None:
    found = help_of(capsys, command, what).rstrip().split("\n\n")
    assert re.fullmatch(r"[A-Z][^\n]+\.", found[0])
    assert found[1].startswith(f"usage: phonemeanalyser {command} {what} [OPTIONS]")
    examples = PARTED[command].EXAMPLES_OF[what]
    assert found[-1].splitlines() == ["examples:", *(f"  {example}" for example in examples)]
    assert len(examples) == 3
    assert all(words_of(example)[:2] == [command, what] for example in examples)


@pytest.fixture
def folder(
    request: pytest.FixtureRequest,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    portaudio: FakePortAudio,
    whisper_folder: Path,
) -> Path:
    """A folder with the files that the examples name, of the demo recording and others."""
    samples, rate = soundfile.read(DEMO)
    drawn = {"preview", "screenshot"} & {request.node.callspec.params["command"]}
    spoken = samples[: int((FIRST_WORD if drawn else FIRST_SENTENCE) * rate)]
    soundfile.write(tmp_path / "speech.wav", spoken, rate)
    (tmp_path / "speech.txt").write_text(TEXT, encoding="utf-8")
    (tmp_path / "recordings").mkdir()
    soundfile.write(tmp_path / "recordings" / "shells.wav", spoken, rate)
    (tmp_path / "recordings" / "shells.txt").write_text(TEXT, encoding="utf-8")
    (tmp_path / "script.tsv").write_text(f"shells.wav\t{TEXT}\n", encoding="utf-8")
    soundfile.write(tmp_path / "silence.wav", noise(3.0, 1e-4), 44_100)
    for name, shift in (("base", 0.0), ("smile", 0.5), ("frown", -0.5)):
        (tmp_path / f"{name}.obj").write_bytes(CUBE_OBJ.replace(b"v 1", f"v {1 + shift}".encode(), 1))
    shutil.copytree(whisper_folder, tmp_path / "whisper-base")
    portaudio.plug("Yeti", hears=spoken.astype(np.float32))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def write_takes(folder: Path) -> None:
    with TakeProject(folder / "my-takes") as project:
        for _ in range(2):
            project.add(vowel((750, 1250), 0.3), "Ada", Phoneme.A)
        project.delete(project.takes[0])


def write_recordings(folder: Path) -> None:
    """Write two labelled recordings, as a corpus and as what a calibration learns from."""
    for place in ("corpus", "my-takes"):
        (folder / place).mkdir()
        for path in (CORPUS / "espeak_de" / "de").glob("de_0[01].*"):
            shutil.copy(path, folder / place)


PREPARED = {"takes": write_takes, "rules": write_recordings, "score": write_recordings, "spectra": write_recordings}


@pytest.mark.usefixtures("home")
@pytest.mark.parametrize("command", [pytest.param("performance", marks=pytest.mark.long), "movestates"])
def test_the_examples_of_what_a_command_does_run_one_after_the_other(
    command: str, folder: Path, capsys: Capsys
) -> None:
    (folder / "lines.txt").write_text(f"{TEXT}\n", encoding="utf-8")
    for what, examples in PARTED[command].EXAMPLES_OF.items():
        for words in map(words_of, examples):
            if what == "show":  # tests/cli/test_performance_cli.py draws shorter ones
                read(command, words)
            else:
                assert main(words) == 0, (words, capsys.readouterr().err)


@pytest.mark.usefixtures("home", "qapp")
@pytest.mark.parametrize(
    "command", [pytest.param(c, marks=[pytest.mark.long] if c in SLOW else []) for c in (*COMMANDS, "window")]
)
def test_the_examples_run(command: str, folder: Path, capsys: Capsys) -> None:
    PREPARED.get(command, lambda _folder: None)(folder)
    if command == "preview":
        context_or_skip().release()
    for example in examples_of(command):
        words = words_of(example)
        if command in READ_ALONE or " ".join(words) in READ_ALONE:
            read(command, words)
        else:
            assert main(words) == 0, (example, capsys.readouterr().err)


def read(command: str, words: list[str]) -> None:
    parser = ArgumentParser()
    importlib.import_module(f"phonemeanalyser.cli.{command}").add_arguments(parser)
    parser.parse_args(words[command != "window" :])


def test_the_help_of_score_names_its_own_default(capsys: Capsys) -> None:
    assert "(default: real-time)" in " ".join(help_of(capsys, "score").split())
    assert "(default: the best available)" in " ".join(help_of(capsys, "export").split())
