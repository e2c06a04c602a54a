"""Texts, lexicons and tables that nobody can speak or find: a sentence with the remedy, and nothing half written."""

import ctypes.util
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import espeakng_loader
import pytest

from phonemeanalyser.cli.main import main
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.text.espeak import LONGEST_PATH
from tests.conftest import CORPUS, ROOT
from tests.tables import Capsys, refused

SAID = CORPUS / "espeak_de" / "de" / "de_01.flac"
TEXT = "Es regnet, aber der See ist eben und leer."


@pytest.fixture(params=["speak", "align", "analyse"])
def command(request: pytest.FixtureRequest, tmp_path: Path) -> list[str]:
    """A command that takes a text from the file text.txt, and writes into a folder ``out``."""
    out = tmp_path / "out"
    text = str(tmp_path / "text.txt")
    return {
        "speak": ["speak", "--file", text, "-o", str(out / "o.wav"), "--labels", str(out / "o.TextGrid")],
        "align": ["align", str(SAID), "--script", text, "-o", str(out / "o.csv")],
        "analyse": ["analyse", str(SAID), "--script", text, "-o", str(out / "o.TextGrid")],
    }[request.param]


def files_in(folder: Path) -> Iterator[Path]:
    return (path for path in folder.rglob("*") if path.is_file())


@pytest.mark.parametrize(
    ("text", "words", "sentence"),
    [
        ("", ["--language", "de"], "there is no word"),
        ("\U0001f389\U0001f600", ["--language", "de"], "there is no word to speak"),
        ("\0\x1b", ["--language", "de"], "there is no word to speak"),
        ("[[", ["--language", "de"], "there is no word to speak"),
        ("... !!! ---", ["--language", "de"], "there is no word to speak"),
        ("\u0301\u0302", ["--language", "de"], "there is no word to speak"),
        (TEXT, [], "the language of a text is not guessed; name it with --language, such as en-us"),
        (TEXT, ["--language", "klingon"], "no voice speaks the language 'klingon'; choose one of en-us"),
        (
            "Привет, как дела?",
            ["--language", "de"],
            "the voice of de cannot read 'Привет', which is of another script",
        ),
        ("兙嗧", ["--language", "cmn"], "no sounds for this text; check its language"),
    ],
)
@pytest.mark.parametrize("command", ["speak"], indirect=True)
def test_a_text_that_nobody_can_speak_is_refused_and_nothing_is_written(
    command: list[str], text: str, words: list[str], sentence: str, tmp_path: Path, capsys: Capsys
) -> None:
    (tmp_path / "text.txt").write_text(text, encoding="utf-8")
    said = refused_with_notes(capsys, *command, *words)
    assert sentence in said
    assert list(files_in(tmp_path)) == [tmp_path / "text.txt"]


def refused_with_notes(capsys: Capsys, *words: str) -> str:
    """Run it, and give the last sentence with which it fails, behind notes."""
    assert main(list(words)) == 1
    *notes, line = capsys.readouterr().err.splitlines()
    assert all(": note: " in note for note in notes)
    return line


@pytest.mark.parametrize("command", ["speak", "align"], indirect=True)
def test_what_is_left_out_or_spelt_is_told_and_the_rest_is_done(
    command: list[str], tmp_path: Path, capsys: Capsys
) -> None:
    text = TEXT.replace("Es", "E\0s") + " [[h@l'oU]] \U0001f389 Привет 银行"
    (tmp_path / "text.txt").write_text(text, encoding="utf-8")
    assert main([*command, "--language", "de"]) == 0
    said = capsys.readouterr().err
    for note in (
        "[[ would ask for phonemes and is read as [ (1 x)",
        "emoji have no sound and are left out (1 x)",
        "control characters and the like have no sound and are left out (1 x)",
        "the voice of de spells words of another script letter by letter: Привет, 银行",
    ):
        assert f"note: {note}\n" in said


@pytest.mark.parametrize("command", ["align"], indirect=True)
def test_what_the_voice_reads_needs_no_note(command: list[str], tmp_path: Path, capsys: Capsys) -> None:
    (tmp_path / "text.txt").write_text(f"<b>{TEXT.replace('See', 'λόγος naïve Łódź')}</b>", encoding="utf-8")
    assert main([*command, "--language", "de"]) == 0
    assert "spells" not in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("l.toml", "nonsense", "l.toml: this is no TOML file"),
        ("l.csv", "word,ipa\nZug,\n", "l.csv, line 2: 'Zug' has no sounds, found ''; write its IPA"),
        ("l.csv", "\xff", "l.csv"),
        ("none.toml", None, "none.toml: there is no such file; check its name and folder"),
    ],
)
@pytest.mark.parametrize("command", ["analyse"], indirect=True)
def test_a_lexicon_with_nonsense_is_refused_and_nothing_is_written(
    command: list[str], name: str, content: str | None, sentence: str, tmp_path: Path, capsys: Capsys
) -> None:
    (tmp_path / "text.txt").write_text(TEXT, encoding="utf-8")
    if content is not None:
        (tmp_path / name).write_text(content, encoding="latin-1")
    said = refused(capsys, *command, "--language", "de", "--lexicon", tmp_path / name)
    assert said.startswith(sentence)
    assert not (tmp_path / "out").exists()


def test_a_table_tells_of_texts_without_sound_and_sounds_without_text(tmp_path: Path, capsys: Capsys) -> None:
    sounds, table = tmp_path / "sounds", tmp_path / "table.tsv"
    sounds.mkdir()
    for sound in ("a.flac", "b.flac"):
        shutil.copy(SAID, sounds / sound)
    out = tmp_path / "out"
    words = ["analyse", str(sounds), "--script", str(table), "--language", "de", "-o", str(out)]
    table.write_text(f"a.flac\t{TEXT}\nz.flac\t{TEXT}\n", encoding="utf-8")
    assert main(words) == 0
    said = capsys.readouterr().err
    assert "there is no text for b.flac; add a line for each" in said
    assert "there is no sound z.flac; name them as the sounds are" in said
    shutil.rmtree(out)
    table.write_text(f"y.flac\t{TEXT}\nz.flac\t{TEXT}\n", encoding="utf-8")
    assert "table.tsv: there is no text in it for a.flac, b.flac; a line holds the name" in refused(capsys, *words)
    table.write_text(f"a.flac\t{TEXT}\nno tab\n", encoding="utf-8")
    assert "table.tsv, line 2: a table has the name of a sound, a tab and its words" in refused(capsys, *words)
    assert not out.exists()


def test_100_kilobytes_without_a_mark_are_another_text(tmp_path: Path, capsys: Capsys) -> None:
    (tmp_path / "text.txt").write_text("a" * 100_000, encoding="utf-8")
    out = tmp_path / "o.csv"
    assert main(["align", str(SAID), "--script", str(tmp_path / "text.txt"), "--language", "de", "-o", str(out)]) == 0
    assert "another text seems to be said in it" in capsys.readouterr().err
    assert ",another text," in out.read_text("utf-8")[-100:]


def test_a_text_that_turns_out_unspeakable_leaves_no_file(tmp_path: Path, capsys: Capsys) -> None:
    out = [("-o", "o.wav"), ("--labels", "o.TextGrid"), ("--plan", "p.csv")]
    written = [word for option, name in out for word in (option, str(tmp_path / name))]
    said = refused(capsys, "speak", "Hallo", "--language", "de", "--text-driver", "pinyin", *written)
    assert said == "o.wav: there is no syllable of pinyin in what is said; choose another driver"
    assert list(tmp_path.iterdir()) == []


def with_loader(folder: Path, code: str, *said: str) -> "subprocess.CompletedProcess[str]":
    """Speak in another process, in which the package espeakng_loader is this."""
    (folder / "espeakng_loader.py").write_text(code, encoding="utf-8")
    words = ["speak", *(said or ("Hallo", "--language", "de", "--labels", str(folder / "o.TextGrid")))]
    places = {"PYTHONPATH": os.pathsep.join([str(folder), str(ROOT / "engine"), str(ROOT)])}
    environment = os.environ | places | {"XDG_CACHE_HOME": str(folder / "cache")}
    command = [sys.executable, "-m", "phonemeanalyser", *words]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False, cwd=folder)


@pytest.mark.skipif(ctypes.util.find_library("espeak-ng") is not None, reason="the system has a voice")
def test_without_a_voice_one_sentence_says_what_to_install(tmp_path: Path) -> None:
    ended = with_loader(tmp_path, "raise ImportError('not installed')")
    assert ended.returncode == 1
    assert ended.stderr == (
        "phonemeanalyser: no voice is installed: espeak-ng is missing; pip install 'phonemeanalyser[speech]', or "
        "install libespeak-ng1 of your system\n"
    )
    assert not (tmp_path / "o.TextGrid").exists()


@pytest.mark.skipif(ctypes.util.find_library("espeak-ng") is not None, reason="the system has a voice")
def test_without_a_voice_silent_chinese_is_planned_and_its_latin_words_are_told(tmp_path: Path) -> None:
    missing = "raise ImportError('not installed')"
    ended = with_loader(tmp_path, missing, "我用OK", "--silent", "--plan", "-")
    assert ended.returncode == 0
    assert [line.split(",")[4] for line in ended.stdout.splitlines()[1:]] == ["我", "用"]
    assert "'OK' has no sound that is known, and is left out; no voice is installed: espeak-ng is" in ended.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="the cache's place is asked for as Linux has it")
def test_a_voice_whose_data_lie_too_deep_speaks(tmp_path: Path) -> None:
    deep = tmp_path
    while len(os.fsencode(deep)) <= LONGEST_PATH:
        deep /= "a-folder-with-a-long-name"
    deep.parent.mkdir(parents=True)
    deep.symlink_to(espeakng_loader.get_data_path())
    ended = with_loader(
        tmp_path,
        f"def get_library_path(): return {espeakng_loader.get_library_path()!r}\n"
        f"def get_data_path(): return {str(deep)!r}\n",
    )
    assert (ended.returncode, ended.stderr) == (0, "")
    assert [word.text for word in read_utterance(tmp_path / "o.TextGrid", 5.0).words] == ["Hallo"]
