"""A text-to-speech program of one's own: a command that writes a sound file, in which its text is found."""

import os
import shlex
import subprocess
import tempfile
from pathlib import Path

from phonemeengine.alignment.align import align
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import VoiceError
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.storage.files import printable, reason_of
from phonemeengine.text.cleaning import speakable
from phonemeengine.text.espeak import language_of
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.pronunciation import words_of

TEXT, OUTPUT = "{text}", "{output}"
TIMEOUT = 600.0
"""Seconds that it may take."""
_SHOWN = 120


def run_speech_program(template: str, text: str, output: Path) -> None:
    """Have a program speak a text into a sound file.

    The command is cut into words as a shell does, but no shell runs it: whatever the text holds stays one argument.

    Parameters
    ----------
    template : the command, with ``{output}`` where the file's name belongs, and ``{text}`` where the text does; the
        program reads the text from its standard input where there is no ``{text}``.
    text : cleaned.
    output : a WAV file that does not exist yet.

    Raises
    ------
    VoiceError : the command cannot be run, fails, or leaves no file.
    """
    words = _words_of(template)
    command = [word.replace(OUTPUT, str(output)).replace(TEXT, text) for word in words]
    spoken = None if any(TEXT in word for word in words) else text.encode()
    name = printable(words[0])
    try:
        ended = subprocess.run(command, input=spoken, capture_output=True, timeout=TIMEOUT, check=False)  # noqa: S603 - the user's own command
    except subprocess.TimeoutExpired:
        raise VoiceError(f"{name}: it has not spoken within {TIMEOUT:g} s; try it by itself") from None
    except (OSError, ValueError) as error:
        raise VoiceError(f"{name}: this program cannot be started ({reason_of(error)}); check the command") from error
    if ended.returncode != 0:
        said = printable(ended.stderr.decode(errors="replace").strip()[-_SHOWN:]) or "it printed nothing"
        raise VoiceError(f"{name}: it failed with exit code {ended.returncode} ({said}); try it by itself")
    if not output.is_file():
        raise VoiceError(f"{name}: it wrote no sound file; put {OUTPUT} where its name belongs in the command")


def speak_by_program(
    template: str, text: str, *, language: str = "", lexicon: Lexicon | None = None, literal: bool = False
) -> SpokenSentence:
    """Return what a program spoke, whole; see `run_speech_program`.

    Its words are those of a TextGrid that it wrote beside the sound, of the same name; where there is none, the sound
    is aligned with the text.

    Parameters
    ----------
    template : the command.
    text : what cannot be spoken is left out, see `speakable`.
    language : of the text, such as ``en-us``; only a program that writes a TextGrid does without.
    lexicon : how words are pronounced that a voice reads otherwise.
    literal : have the program speak the notation of scripts, too.

    Raises
    ------
    VoiceError : the command cannot be run, fails, or leaves no file, or one without speech.
    AudioError : what it wrote is no sound.
    CorpusError : what it wrote beside it is no TextGrid with the sound's phones.
    TextError : there is nothing to speak, or no such language.
    """
    cleaned = speakable(text, language, literal=literal).text
    if language:
        language_of(language)  # rather than after a program that takes minutes
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "speech.wav"
        run_speech_program(template, cleaned, output)
        with SoundReader(output) as reader:
            samples, duration = reader.read_mono(), reader.duration
        labels = output.with_suffix(".TextGrid")
        if labels.is_file():
            said = read_utterance(labels, duration)
        else:
            words = words_of(cleaned, language, lexicon, literal=True)
            said = align(output, words, load_preset(DEFAULT_PRESET), language=language)
    if not said.words:
        raise VoiceError(f"{printable(_words_of(template)[0])}: there is no speech in its sound; try it by itself")
    return SpokenSentence(samples, said.words, cleaned, said.skipped)


def _words_of(template: str) -> list[str]:
    try:
        words = shlex.split(template, posix=os.name != "nt")
    except ValueError as error:
        raise VoiceError(f"the command {template!r:.60} cannot be read ({error}); close its quotes") from error
    if not words or not any(OUTPUT in word for word in words):
        raise VoiceError(
            f"the command {template!r:.60} does not say where the sound goes; put {OUTPUT} where the name of a WAV "
            f"file belongs, and {TEXT} where the text does"
        )
    return words
