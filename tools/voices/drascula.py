"""Actors of the game Drascula: sounds of 8 bits and 11 kHz without a head, told apart by the files' names."""

import re
from collections import defaultdict
from functools import partial
from pathlib import Path

import numpy as np

from tools.voices.packages import RECORDINGS
from tools.voices.recordings import Clip, Source, from_bytes, voices_of
from tools.voices.voice import Voice

SOURCE = Source(
    "drascula",
    "en",
    "free with its notice, also modified, no fee for the game itself ((C) Alcachofa Soft S.L.)",
    RECORDINGS["drascula"],
)
FOLDER = "usr/share/scummvm/drascula/en"
SAMPLE_RATE = 11025
EFFECTS = "S"


def voices(cache: Path) -> list[Voice]:
    """A voice for each prefix of the files' names, the hero's for those without one."""
    clips: dict[str, list[Clip]] = defaultdict(list)
    for path in sorted((cache / "packages" / SOURCE.package / FOLDER).glob("*.ALS")):
        prefix = re.sub(r"\d+$", "", path.stem)
        if prefix != EFFECTS:
            clips[prefix or "hero"].append(partial(_read, path))
    return voices_of(SOURCE, clips, hero="hero")


def _read(path: Path) -> tuple[np.ndarray, int]:
    return from_bytes(path.read_bytes(), SAMPLE_RATE)
