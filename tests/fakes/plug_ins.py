"""Recognisers of other packages: the real example, installed with pip, and small ones that a test writes."""

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from phonemeengine.recognition.plug_ins import GROUP

EXAMPLE = Path(__file__).parents[2] / "examples" / "own_recogniser"
HEAD = """
import numpy as np
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import RuleComparison, Trace


class Plain:
    def __init__(self, thresholds):
        pass

    def recognise(self, windows, features):
        return np.full(len(features.values), Phoneme.U, np.uint8)

    def explain(self, features, k):
        return Trace(Phoneme.U, "always", ())
"""


def environment_with(site: Path) -> dict[str, str]:
    """The environment of a program that finds the packages of a folder beside all others."""
    paths = [str(site), *filter(None, [os.environ.get("PYTHONPATH")])]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}


def install_example(folder: Path) -> Path:
    """Install the example package into a folder, as a user would, but from nowhere else than this machine."""
    words = ["--no-index", "--no-deps", "--no-build-isolation", "--disable-pip-version-check", "--quiet"]
    command = [sys.executable, "-m", "pip", "install", *words, "--target", str(folder), str(EXAMPLE)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return folder


@dataclass(frozen=True)
class Shelf:
    """Puts packages where Python finds them, until the test is over."""

    folder: Path
    monkeypatch: pytest.MonkeyPatch

    def use(self, site: Path, module: str) -> None:
        """Find the packages of a folder, and import their module afresh."""
        self.monkeypatch.delitem(sys.modules, module, raising=False)
        self.monkeypatch.syspath_prepend(site)

    def offer(self, source: str, name: str = "own", package: str = "own-package") -> None:
        """Offer `Own`, which the source defines, or `Plain` where it does not."""
        module = package.replace("-", "_")
        site = self.folder / package
        metadata = site / f"{module}-1.0.dist-info"
        metadata.mkdir(parents=True)
        (site / f"{module}.py").write_text(f"{HEAD}\n\n{source}\n", encoding="utf-8")
        (metadata / "METADATA").write_text(
            f"Metadata-Version: 2.1\nName: {package}\nVersion: 1.0\n", encoding="utf-8"
        )
        offered = "Own" if "Own" in source else "Plain"
        (metadata / "entry_points.txt").write_text(f"[{GROUP}]\n{name} = {module}:{offered}\n", encoding="utf-8")
        self.use(site, module)
