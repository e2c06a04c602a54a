"""Actors of the game Nexuiz: calls to the team, a folder an actor, and the announcer."""

import re
import zipfile
from collections import defaultdict
from functools import partial
from pathlib import Path

import numpy as np

from tools.voices.packages import RECORDINGS
from tools.voices.recordings import Clip, Source, decoded, voices_of
from tools.voices.voice import Voice

SOURCE = Source("nexuiz", "en", "GPL-2+ (Alientrap, Lee Vermeulen)", RECORDINGS["nexuiz"])
ARCHIVE = "usr/share/games/nexuiz/data/data.pk3"
CALL = re.compile(r"sound/(?:player/([^/]+)/coms|announcer/male)/.*\.(?:ogg|wav)")


def voices(cache: Path) -> list[Voice]:
    """The actors who call words; what only screams, and the robotic announcer, are left out."""
    archive = cache / "packages" / SOURCE.package / ARCHIVE
    clips: dict[str, list[Clip]] = defaultdict(list)
    with zipfile.ZipFile(archive) as opened:
        for name in sorted(opened.namelist()):
            if actor := actor_of(name):
                clips[actor].append(partial(_read, archive, name))
    return voices_of(SOURCE, clips)


def actor_of(name: str) -> str:
    """Who calls in a file of the archive; empty where there is no voice."""
    call = CALL.fullmatch(name)
    return (call[1] or "announcer") if call else ""


def _read(archive: Path, name: str) -> tuple[np.ndarray, int]:
    with zipfile.ZipFile(archive) as opened:
        return decoded(opened.read(name))
