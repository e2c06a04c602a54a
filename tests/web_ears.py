"""The shipped module, and Node, which runs it."""

import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from tests.compiled_ears import FRAME, MOST_VISEMES, N_PHONEMES, Frames
from tests.sounds import Sound

ROW = 5 + N_PHONEMES + MOST_VISEMES
"""Numbers that are told of a frame."""
SCRIPT = Path(__file__).with_name("web_ear.mjs")


def node() -> str:
    """Give Node; where a machine that should have it has none, that is a failure."""
    found = shutil.which("node")
    if found is None and "CI" in os.environ and os.name == "posix":
        pytest.fail("there is no Node; install nodejs")
    if found is None:
        pytest.skip("there is no Node")
    return found


def in_node(folder: Path, task: str, sound: Sound, rate: int = 44_100) -> tuple[np.ndarray, str]:
    """Have Node do a task of the script; gives its numbers and its words."""
    words = [node(), "--expose-gc", str(SCRIPT), task, str(folder), str(rate)]
    done = subprocess.run(words, input=np.float32(sound).tobytes(), capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    return np.frombuffer(done.stdout, np.float64), done.stderr.decode()


def frames_of(numbers: np.ndarray) -> Frames:
    """Give what the script tells of frames as the ear in C gives them."""
    rows = numbers.reshape(-1, ROW)
    frames = np.zeros(len(rows), FRAME)
    for k, name in enumerate(FRAME.names[:-2]):
        frames[name] = rows[:, k]
    frames["scores"], frames["viseme_scores"] = np.split(rows[:, -MOST_VISEMES - N_PHONEMES :], [N_PHONEMES], axis=1)
    return frames
