import shlex
import sys
from pathlib import Path

import pytest

from phonemeengine import EngineError, VoiceError
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


def _program(folder: Path, code: str = WRITER) -> str:
    path = folder / "a voice.py"
    path.write_text(code)
    return f"{shlex.quote(Path(sys.executable).as_posix())} {shlex.quote(path.as_posix())}"


def test_a_program_speaks_into_a_file(tmp_path: Path) -> None:
    sentence = speak_by_program(f"{_program(tmp_path)} {{output}} {{text}}", "hello")
    assert sentence.duration == pytest.approx(0.05)
    assert sentence.words == ()


def test_a_program_may_read_the_text_from_its_standard_input(tmp_path: Path) -> None:
    assert speak_by_program(f"{_program(tmp_path)} {{output}}", "hello!").duration == pytest.approx(0.06)


def test_no_shell_sees_the_text(tmp_path: Path) -> None:
    text = '$(touch x); "a" && `b` {output}'
    assert speak_by_program(f"{_program(tmp_path)} {{output}} {{text}}", text).duration == pytest.approx(
        len(text) / 100
    )


def test_labels_that_the_program_wrote_beside_its_sound_are_taken(tmp_path: Path) -> None:
    sentence = speak_by_program(f"{_program(tmp_path, WRITER + LABELS)} {{output}} {{text}}", "hello")
    assert [phone.ipa for word in sentence.words for phone in word.phones] == ["a"]


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
        ("import sys; open(sys.argv[1], 'w').write('no sound')", "not a sound file"),
    ],
)
def test_a_program_that_fails_is_told_of_in_its_own_words(tmp_path: Path, code: str, words: str) -> None:
    with pytest.raises(EngineError, match=words):
        speak_by_program(f"{_program(tmp_path, code)} {{output}}", "hello")
