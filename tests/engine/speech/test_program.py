import shlex
import sys
from pathlib import Path

import pytest

from phonemeengine import EngineError, SoundReader, TextError, Utterance, Voice, VoiceError, load_lexicon, speak
from phonemeengine.audio.wav import WavEncoder
from phonemeengine.labels.utterance import UNKNOWN_WORD
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.program import run_speech_program, speak_by_program

WRITER = """
import sys, wave
out, text = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else sys.stdin.read()
with wave.open(out, "wb") as file:
    file.setparams((1, 2, 44100, 0, "NONE", ""))
    file.writeframes(b"\\0\\1" * 441 * len(text))
"""
LABELS = """
open(out.replace(".wav", ".TextGrid"), "w").write('''File type = "ooTextFile"
Object class = "TextGrid"

0
0.05
<exists>
1
"IntervalTier"
"phones"
0
0.05
1
0
0.05
"a"
''')
"""

TEXT = "Es regnet, aber der See ist eben und leer."
OTHER = "Der Onkel trinkt Kaffee mit Zucker und singt laut dazu."
PLAYER = """
import shutil, sys
shutil.copy(sys.argv[1], sys.argv[2])
"""


def _voice(folder: Path, language: str, text: str) -> Utterance:
    """Put the sound of a text where `_player` finds it."""
    samples, utterance = speak(text, Voice(language))
    with (folder / "said.wav").open("wb") as file:
        encoder = WavEncoder(file, SAMPLE_RATE, 1)
        encoder.write(samples[:, None])
        encoder.close()
    return utterance


def _player(folder: Path) -> str:
    """A program that says always the same."""
    return f"{_program(folder, PLAYER)} {shlex.quote((folder / 'said.wav').as_posix())} {{output}}"


def _program(folder: Path, code: str = WRITER) -> str:
    path = folder / "a voice.py"
    path.write_text(code)
    return f"{shlex.quote(Path(sys.executable).as_posix())} {shlex.quote(path.as_posix())}"


def _spoken(folder: Path, command: str, text: str) -> float:
    """How long a program speaks, seconds."""
    run_speech_program(command, text, folder / "o.wav")
    with SoundReader(folder / "o.wav") as reader:
        return reader.duration


def test_a_program_speaks_into_a_file(tmp_path: Path) -> None:
    assert _spoken(tmp_path, f"{_program(tmp_path)} {{output}} {{text}}", "hello") == pytest.approx(0.05)


def test_a_program_may_read_the_text_from_its_standard_input(tmp_path: Path) -> None:
    assert _spoken(tmp_path, f"{_program(tmp_path)} {{output}}", "hello!") == pytest.approx(0.06)


def test_no_shell_sees_the_text(tmp_path: Path) -> None:
    text = '$(touch x); "a" && `b` {output}'
    assert _spoken(tmp_path, f"{_program(tmp_path)} {{output}} {{text}}", text) == pytest.approx(len(text) / 100)


def test_labels_that_the_program_wrote_beside_its_sound_are_taken(tmp_path: Path) -> None:
    sentence = speak_by_program(f"{_program(tmp_path, WRITER + LABELS)} {{output}} {{text}}", "hello")
    assert [phone.ipa for word in sentence.words for phone in word.phones] == ["a"]


def test_words_are_where_a_voice_says_them_that_writes_no_labels(tmp_path: Path) -> None:
    said = _voice(tmp_path, "de", TEXT)
    found = speak_by_program(_player(tmp_path), TEXT, language="de")
    assert found.skipped == ()
    assert [word.text for word in found.words] == [word.text for word in said.words]
    for word, true in zip(found.words, said.words, strict=True):
        assert word.start == pytest.approx(true.start, abs=0.06)
        assert word.end == pytest.approx(true.end, abs=0.06)


def test_chinese_of_a_program_is_syllables_of_pinyin(tmp_path: Path) -> None:
    _voice(tmp_path, "cmn", "银行在哪里？")
    found = speak_by_program(_player(tmp_path), "银行在哪里？", language="cmn")
    texts = [syllable.text for word in found.words for syllable in word.syllables]
    assert texts == ["yin2", "hang2", "zai4", "na2", "li3"]


def test_a_program_that_says_something_else_is_found_out(tmp_path: Path) -> None:
    _voice(tmp_path, "de", TEXT)
    found = speak_by_program(_player(tmp_path), OTHER, language="de")
    assert [word.text for word in found.words if word.text != UNKNOWN_WORD] == []
    assert len(found.skipped) == len(OTHER.split())


def test_a_lexicon_tells_how_the_program_says_a_word(tmp_path: Path) -> None:
    _voice(tmp_path, "de", "Das ist ein Zug.")
    (tmp_path / "l.csv").write_text("word,ipa\nABC,tsuːk\n", encoding="utf-8")
    lexicon = load_lexicon(tmp_path / "l.csv")
    (word,) = speak_by_program(_player(tmp_path), "Das ist ein ABC.", language="de", lexicon=lexicon).words[3:]
    assert [phone.ipa for phone in word.phones] == ["t", "s", "u", "k"]


def test_without_labels_the_language_must_be_named(tmp_path: Path) -> None:
    _voice(tmp_path, "de", TEXT)
    with pytest.raises(TextError, match="name it with --language"):
        speak_by_program(_player(tmp_path), TEXT)


def test_a_language_that_nobody_knows_is_refused_before_the_program_runs(tmp_path: Path) -> None:
    with pytest.raises(TextError, match="no voice speaks the language 'xx'"):
        speak_by_program("a-program-that-is-not-there {output}", TEXT, language="xx")


def test_nothing_is_run_for_a_text_without_a_word(tmp_path: Path) -> None:
    with pytest.raises(TextError, match="there is no word to speak"):
        speak_by_program("a-program-that-is-not-there {output}", "...", language="de")


@pytest.mark.parametrize(
    ("template", "words"),
    [
        ("", "does not say where the sound goes"),
        ("voice {text}", "does not say where the sound goes"),
        ("voice 'unclosed {output}", "close its quotes"),
        ("a-program-that-is-not-there {output}", "cannot be started"),
    ],
)
def test_a_command_that_cannot_work_is_refused(tmp_path: Path, template: str, words: str) -> None:
    with pytest.raises(VoiceError, match=words):
        run_speech_program(template, "hello", tmp_path / "o.wav")


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("pass", "wrote no sound file"),
        ("import sys; sys.exit('out of breath')", r"exit code 1 \(out of breath\)"),
        ("import sys; open(sys.argv[1], 'w').write('no sound')", "not an audio file"),
    ],
)
def test_a_program_that_fails_is_told_of_in_its_own_words(tmp_path: Path, code: str, words: str) -> None:
    with pytest.raises(EngineError, match=words):
        speak_by_program(f"{_program(tmp_path, code)} {{output}}", "hello")
