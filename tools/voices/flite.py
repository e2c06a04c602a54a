"""Speech of the voices awb and rms of flite, with the phone times that flite prints."""

import random
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import soundfile

from tools.voices.english_phones import ENGLISH
from tools.voices.labels import Segment, segments_from_ends
from tools.voices.texts import utterances
from tools.voices.voice import Voice
from tools.voices.writing import Speaker, Utterance

STRETCH = (0.8, 1.3)  # duration factor, drawn for each utterance
PITCHES = {"awb": (95.0, 175.0)}  # Hz; rms does not obey
ACCENTS = {"awb": "en-GB", "rms": "en-US"}  # awb is a Scot
LICENCE = "CMU flite BSD-like (recordings CMU ARCTIC)"


def voices(cache: Path) -> list[Voice]:
    """The voices of flite that are spoken here."""
    return [_voice(name, cache) for name in ("awb", "rms")]


def _voice(name: str, cache: Path) -> Voice:
    speaker = Speaker("flite", name, ACCENTS[name], "male", "synthetic-clustergen", LICENCE, "flite", "radio")
    return Voice(speaker, ENGLISH, lambda: _utterances(name, cache))


def _utterances(name: str, cache: Path) -> Iterator[Utterance]:
    chance = random.Random(name)
    path = cache / f"flite_{name}.wav"
    for text in utterances("en", name, cache):
        command = ["flite", "-voice", name, "--setf", f"duration_stretch={chance.uniform(*STRETCH):.3f}"]
        if name in PITCHES:
            command += ["--setf", f"int_f0_target_mean={chance.uniform(*PITCHES[name]):.0f}"]
        printed = subprocess.run(
            [*command, "-psdur", "-t", text, "-o", str(path)], capture_output=True, text=True, check=True
        ).stdout
        sound, sample_rate = soundfile.read(path)
        yield Utterance(sound, sample_rate, segments_printed(printed), text)


def segments_printed(printed: str) -> list[Segment]:
    """Segments from what flite prints with -psdur: ``pau:0.254 hh:0.296``, each phone with its end in seconds."""
    return segments_from_ends([(phone, float(end)) for phone, end in re.findall(r"(\S+):([\d.]+)", printed)])
