"""The parts that this program is made of, and their licences: under *Help > Licences*, and by ``--licences``."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import Distribution, PackageMetadata, PackageNotFoundError, distribution
from pathlib import Path

PROGRAM = "phonemeanalyser"
FOR_USERS = {"live", "desktop", "speech", "encoder", "whisper", "preview", "server", "cluster"}
"""The extras whose packages run with the program; those of the others only help to make it."""
LIBRARIES = {
    "av": "FFmpeg with x264 and x265: GPL 2 or later; other codecs: LGPL and BSD-like",
    "espeakng-loader": "espeak-ng with its voices: GPL 3 or later",
    "numpy": "OpenBLAS: BSD-3-Clause",
    "onnxruntime": "Eigen: MPL 2; Abseil: Apache-2.0; protobuf, re2, others: BSD-like",
    "PySide6_Essentials": "Qt: LGPL 3",
    "scipy": "OpenBLAS: BSD-3-Clause",
    "sounddevice": "PortAudio: MIT",
    "soundfile": "libsndfile: LGPL 2.1 or later; FLAC, Ogg, Vorbis, Opus: BSD-like; mpg123, LAME: LGPL",
    "soxr": "libsoxr: LGPL 2.1 or later",
}
"""What packages bring along that is not their own, by their names."""
GNU = {"GNU General Public License 3": "gpl-3.txt", "GNU Lesser General Public License 3": "lgpl-3.txt"}
"""Licences that Qt and espeak-ng come under, whose packages lack the text."""
DATA = (
    "The head with its blend shapes: CC0, in the public domain.",
    "The demo: a synthetic voice of the Festival project (CMU slt), BSD-like licence.",
    "The learned preset: its card tells of every voice that it learned from, and of its teacher (Whisper, MIT).",
)

_NAME = re.compile(r"[\w.-]+")
_EXTRA = re.compile(r"""extra\s*==\s*['"]([\w-]+)['"]""")
_LICENCE_FILE = re.compile(r"(?:^|/)(?:licen[cs]e|copying|notice)[^/]*$", re.IGNORECASE)
_APPROVED = "License :: OSI Approved :: "


@dataclass(frozen=True)
class LicencedPart:
    """A package that the program runs with.

    Attributes
    ----------
    name, version : as the package says.
    licence : its name, such as ``MIT``; a question mark where the package names none.
    libraries : what the package brings along that is not its own, with licences; empty where nothing is known.
    texts : its licences, whole.
    """

    name: str
    version: str
    licence: str
    libraries: str
    texts: tuple[str, ...]


def parts() -> list[LicencedPart]:
    """Return the program and all packages that are installed for its users, by name."""
    found: dict[str, Distribution] = {}
    _add(PROGRAM, FOR_USERS, found)
    first, *others = (_part(name) for name in found.values())
    return [first, *sorted(others, key=lambda part: part.name.casefold())]


def licences_text(title: str = "Licences", head: tuple[str, str, str] = ("Component", "Licence", "Includes")) -> str:
    """Return a table of all parts, what is in the data, and the licences whole, as Markdown."""
    everything = parts()
    rows = [f"| {part.name} {part.version} | {part.licence} | {part.libraries} |" for part in everything]
    table = "\n".join(["| " + " | ".join(head) + " |", "| --- | --- | --- |", *rows])
    texts = {part.name: part.texts for part in everything if part.texts}
    texts |= {name: ((Path(__file__).parent / file).read_text("utf-8"),) for name, file in GNU.items()}
    whole = "\n\n".join(_whole(name, of_it) for name, of_it in texts.items())
    data = "\n".join(f"- {line}" for line in DATA)
    return f"# {title}\n\n{table}\n\n{data}\n\n{whole}\n"


def _add(name: str, extras: set[str], found: dict[str, Distribution]) -> None:
    """Add a distribution and what it requires, if they are installed."""
    try:
        there = distribution(name)
    except PackageNotFoundError:  # an extra that is not installed, or something for another system
        return
    if _key(name) in found:
        return
    found[_key(name)] = there
    for required in _required(there, extras):
        _add(required, set(), found)


def _required(there: Distribution, extras: set[str]) -> Iterator[str]:
    for requirement in there.requires or []:
        extra = _EXTRA.search(requirement)
        name = _NAME.match(requirement)
        if name and (extra is None or extra[1] in extras):
            yield name[0]


def _key(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def _part(there: Distribution) -> LicencedPart:
    about = there.metadata
    classifiers = [words.removeprefix(_APPROVED) for words in about.get_all("Classifier") or [] if _APPROVED in words]
    said = _said(about, "License").strip().split("\n")[0]
    files = [file for file in there.files or [] if _LICENCE_FILE.search(str(file))]
    texts = tuple(file.read_text() for file in files if Path(file.locate()).is_file())
    known = {_key(name): words for name, words in LIBRARIES.items()}
    licence = _said(about, "License-Expression") or ", ".join(classifiers) or said or "?"
    return LicencedPart(there.name, there.version, licence, known.get(_key(there.name), ""), texts)


def _said(about: PackageMetadata, field: str) -> str:
    return about[field] if field in about else ""  # noqa: SIM401 - its type has no get


def _whole(name: str, texts: tuple[str, ...]) -> str:
    fenced = "\n\n".join(f"```text\n{text.replace('```', '~~~').strip()}\n```" for text in texts)
    return f"## {name}\n\n{fenced}"
