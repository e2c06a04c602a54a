"""The command line as a program: its words, its exit codes, and what it says without a display."""

import contextlib
import importlib
import os
import re
import subprocess
import sys
from argparse import ArgumentError, ArgumentParser
from importlib.metadata import version
from pathlib import Path

import pytest

from phonemeanalyser.cli.main import COMMANDS, main
from phonemeanalyser.cli.window import DEMO
from tests.tables import LABELS, Capsys, refused, rows_of

PROGRAM = [sys.executable, "-m", "phonemeanalyser"]


def program(*words: object, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run it as a user does who has no display but those in `environment`."""
    hidden = {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}
    env = {name: value for name, value in os.environ.items() if name not in hidden} | environment
    command = [*PROGRAM, *(str(word) for word in words)]
    return subprocess.run(command, capture_output=True, text=True, timeout=240, env=env, check=False)


def test_the_ten_sounds_are_all_in_the_demo() -> None:
    labelled = {row["class"] for row in rows_of(DEMO.with_suffix(".csv").read_text())}
    assert labelled >= LABELS - {"unidentified"}


@pytest.mark.parametrize(("path", "goes"), [(DEMO, "head -n 1"), pytest.param(None, "true", marks=pytest.mark.long)])
def test_a_reader_that_goes_away_is_no_fault(path: Path | None, goes: str, sound: Path) -> None:
    line = f'set -o pipefail; "{sys.executable}" -m phonemeanalyser analyse --features "{path or sound}" | {goes}'
    done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, timeout=240, check=False)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("platform", [None, pytest.param("wayland;xcb", marks=pytest.mark.long)])
def test_without_a_display_it_says_so_and_what_to_do(platform: str | None, sound: Path) -> None:
    done = program(sound, **({} if platform is None else {"QT_QPA_PLATFORM": platform}))
    assert (done.returncode, done.stdout) == (3, "")
    assert done.stderr == (
        "phonemeanalyser: there is no display to open a window on; run it on a desktop, or to see it as a picture, "
        "use: phonemeanalyser screenshot FILE -o PNG\n"
    )


def test_a_display_that_does_not_answer_is_named(sound: Path) -> None:
    done = program(sound, DISPLAY=":987", WAYLAND_DISPLAY="wayland-that-is-not-there" + "x" * 100)
    assert (done.returncode, done.stdout) == (3, "")
    (line,) = done.stderr.splitlines()
    assert re.match(r"phonemeanalyser: (the display :987 does not answer|the window needs system libraries); ", line)


@pytest.mark.parametrize(
    "words",
    [
        "--no-such-option",
        "one.wav two.wav",
        "analyse",
        "analyse x.wav --format xml",
        "screenshot x.wav",
        "screenshot x.wav -o x.png --size wide",
        "screenshot x.wav -o x.png --size 10x10",
        "screenshot x.wav -o x.png --theme pink",
        "screenshot x.wav -o x.png --at=-1",
        "screenshot x.wav -o x.png --at soon",
        "export",
        "export a.wav",
        "export a.wav --format fbx",
        "export a.wav --format anno --fps x",
        "listen a.wav",
        "listen --format xml",
        "listen --seconds soon",
        "listen --seconds=-1",
        "listen --channel middle",
        "listen --channel=-1",
        "listen --rate fast",
        "listen --rate 5",
        "listen --device",
        "listen --look-ahead 0.06",
        "record",
        "record a.wav --format json",
        "record a.wav --channel 1.5",
        "score",
        "score x --format xml",
        "score x --by colour",
        "score x --lag soon",
        "score x --lag 1001",
        "score x --noise brown --snr 5",
        "score x --noise pink",
        "score x --snr 5",
        "score x --noise pink --snr 99",
        "score x --noise pink --snr 9 --seed -1",
        "score x --lexicon gone.toml",
        "preview",
        "preview a.wav",
        "preview a.wav -o a --size 8x8",
        "preview a.wav -o a --size big",
        "adapt --background-noise a.wav -o a.toml --map gone.toml",
        "train x -o a.npz --groups gone.toml --no-validation",
        "speak hi -o a.wav --preset gone.toml",
        "speak hi -o a.wav --format anno",
        "speak hi -o a.wav --table gone",
        "speak hi -o a.wav --expression gone.csv",
    ],
)
def test_wrong_usage_is_explained(words: str, capsys: Capsys) -> None:
    with pytest.raises(SystemExit) as end:
        main(words.split())
    assert end.value.code == 2
    said = capsys.readouterr()
    assert said.out == ""
    (sentence,) = said.err.splitlines()
    command = words.partition(" ")[0]
    assert sentence.startswith(f"phonemeanalyser {command}: " if command in COMMANDS else "phonemeanalyser")
    assert sentence.endswith(" --help")


PRESETS = ["analyse SOUND", "align SOUND --text hi", "export SOUND --format anno", "preview SOUND -o a"]
TABLES = [*PRESETS[2:], "speak hi --language de --export a.csv --format livelink-csv"]
NO_TABLE = "gone: there is no such mouth table; name a file, or one of"


@pytest.mark.parametrize(
    ("command", "sentence"),
    [
        *((f"{command} --preset gone.toml", "gone.toml: there is no such file") for command in PRESETS),
        *((f"{command} --table gone", NO_TABLE) for command in TABLES),
    ],
)
def test_a_preset_or_a_mouth_table_that_is_not_there_is_named(
    command: str, sentence: str, sound: Path, capsys: Capsys
) -> None:
    words = [sound if word == "SOUND" else word for word in command.split()]
    assert refused(capsys, *words).startswith(sentence)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["analyse", "x.wav", "--fromat", "csv"], "analyse: '--fromat' is unknown; did you mean --format?"),
        (["analyse", "x.wav", "--format", "jsn"], "analyse: --format: there is no 'jsn'; did you mean json?"),
        (["exprot", "x.wav"], "there is no command 'exprot'; did you mean export?"),
        (["movestates", "inof", "x"], "movestates: WHAT: there is no 'inof'; did you mean info?"),
        (
            ["export", "x.wav", "--format", "rhubarb"],
            "export: --format: there is no 'rhubarb'; did you mean rhubarb-tsv, rhubarb-xml or rhubarb-json",
        ),
        (
            ["export", "x.wav", "-o", "x.json"],
            "export: several formats end as 'x.json' does; choose one of rhubarb-json, azure-json, curves-json; see",
        ),
        (["export", "x.wav", "-o", "x.fbx"], "export: --format is missing; choose one of rhubarb-tsv, rhubarb-xml"),
    ],
)
def test_what_is_spelt_wrong_is_refused_with_what_may_be_meant(
    words: list[str], sentence: str, capsys: Capsys
) -> None:
    with pytest.raises(SystemExit) as end:
        main(words)
    assert end.value.code == 2
    (said,) = capsys.readouterr().err.splitlines()
    assert said.removeprefix("phonemeanalyser").lstrip(": ").startswith(sentence)


@pytest.mark.parametrize(
    "words",
    [
        ["ship", "learned", "-o", "-"],
        ["adapt", "x", "-o", "-"],
        ["rules", "x", "-o", "-"],
        ["train", "x", "-o", "-"],
        ["screenshot", "x.wav", "-o", "-"],
        ["movestates", "convert", "head", "-"],
        ["performance", "build", "x", "-o", "-"],
        ["record", "-"],
    ],
)
def test_what_cannot_be_printed_makes_no_file_of_the_name_of_standard_output(
    words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit):
        main(words)
    assert "this command does not write to standard output" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_analyse_may_be_spelt_as_americans_do(sound: Path, capsys: Capsys) -> None:
    assert main(["analyze", str(sound)]) == 0
    american = capsys.readouterr().out
    assert main(["analyse", str(sound)]) == 0
    assert capsys.readouterr().out == american != ""


def test_help_lists_every_command_with_a_line(capsys: Capsys) -> None:
    with pytest.raises(SystemExit):
        main(["--help"])
    lines = [line for line in capsys.readouterr().out.splitlines() if line.startswith("  ")]
    for command, words in COMMANDS.items():
        assert [line.split(maxsplit=1)[1] for line in lines if line.split()[0] == command] == [words]


@pytest.mark.parametrize("command", sorted(COMMANDS))
def test_no_option_of_numbers_takes_what_is_no_number(command: str) -> None:
    parser = ArgumentParser()
    importlib.import_module(f"phonemeanalyser.cli.{command}").add_arguments(parser)
    for action in parser._actions:
        if action.option_strings and action.type is not None:
            for written in ("nan", "inf", "-inf", "1e999"):
                try:
                    value = parser._get_value(action, written)
                except ArgumentError:
                    continue
                assert not isinstance(value, float), f"{action.option_strings[0]} takes {written}"


def test_a_command_imports_no_other_and_none_a_window() -> None:
    code = (
        "import sys; from phonemeanalyser.cli.main import main, COMMANDS\n"
        "try: main(['analyse', '--help'])\n"
        "except SystemExit: pass\n"
        "print([name for name in COMMANDS if f'phonemeanalyser.cli.{name}' in sys.modules])\n"
        "import importlib\n"
        "for name in COMMANDS: importlib.import_module(f'phonemeanalyser.cli.{name}')\n"
        "print('PySide6' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=240, check=True)
    assert done.stdout.splitlines()[-2:] == ["['analyse']", "False"]


def test_the_version_is_that_of_the_package(capsys: Capsys) -> None:
    with pytest.raises(SystemExit) as end:
        main(["--version"])
    assert end.value.code == 0
    assert capsys.readouterr().out == f"phonemeanalyser {version('phonemeanalyser')}\n"


def test_a_name_that_the_system_refuses_and_a_closed_output_are_one_sentence(capsys: Capsys) -> None:
    said = refused(capsys, "takes", "x" * 5000)
    assert said.endswith("; check the name, its folder and the disk")
    assert len(said) < 400
    with contextlib.redirect_stdout(None):
        assert refused(capsys, "explain", "--preset", "thesis") == "standard output is closed; name a file with -o"
