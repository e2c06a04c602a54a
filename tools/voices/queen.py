"""Actors of the game Flight of the Amazon Queen: MP3 of 11 kHz in one archive, told apart by the files' names."""

from collections import defaultdict
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from tools.voices.packages import RECORDINGS
from tools.voices.recordings import Clip, Source, decoded, voices_of
from tools.voices.voice import Voice

SOURCE = Source(
    "queen",
    "en",
    "free with its notice, also modified, no fee for the game itself ((C) John Passfield, Steven Stamatiadis)",
    RECORDINGS["queen"],
)
ARCHIVE = "usr/share/scummvm/flight-of-the-amazon-queen/queen.1c"
HEAD, ENTRY, NAME = 15, 21, 12  # bytes: before the entries, of an entry, of its name


def voices(cache: Path) -> list[Voice]:
    """The hero, and the others of each dialogue."""
    clips: dict[str, list[Clip]] = defaultdict(list)
    seen = set()
    for name, sound in lines_in((cache / "packages" / SOURCE.package / ARCHIVE).read_bytes()):
        if is_line(name) and sound not in seen:
            seen.add(sound)
            clips[speaker_of(name)].append(partial(decoded, sound))
    return voices_of(SOURCE, clips, hero="hero")


def lines_in(archive: bytes) -> Iterator[tuple[str, bytes]]:
    """Names and contents of the files in the archive: "QTBL", ..., their number, then name, bundle, offset, size."""
    for start in range(HEAD, HEAD + ENTRY * int.from_bytes(archive[HEAD - 2 : HEAD], "big"), ENTRY):
        name = archive[start : start + NAME].rstrip(b"\0").decode("latin-1")
        offset, size = (int.from_bytes(archive[start + at : start + at + 4], "big") for at in (13, 17))
        yield name, archive[offset : offset + size]


def is_line(name: str) -> bool:
    """Whether a file is one of a dialogue or a cut scene; effects are called such as 27SSSSSS, songs otherwise."""
    return name.endswith(".SB") and name[4:8] != "SSSS" and (name[0].isdigit() or name[0] in "CJ")


def speaker_of(name: str) -> str:
    """Who speaks a line: the hero, by the seventh letter, or another one of the dialogue, by the first two."""
    return "hero" if name.startswith("JOE") or name[6] == "J" else name[:2]
