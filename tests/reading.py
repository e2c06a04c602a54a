"""Somebody who reads the English sentence of the guided calibration: the demo's voice, cut from the demo."""

from functools import cache

import numpy as np

from phonemeengine.audio.files import SoundReader
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.settings import SAMPLE_RATE
from tests.conftest import ROOT
from tests.sounds import Sound

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"


@cache
def english_read() -> tuple[Sound, tuple[Label, ...]]:
    """The demo's second sentence, and its first, with what is said where."""
    with SoundReader(DEMO) as reader:
        sound = np.concatenate(list(reader.blocks(1 << 16)))
    labels = read_labels(DEMO.with_suffix(".csv"))
    names = [label.phone for label in labels]
    begins = next(k for k in range(len(names)) if names[k : k + 4] == ["p", "aa", "p", "ax"])
    ends = next(k for k in range(begins, len(names)) if names[k] == "pau" and names[k - 1] == "z") + 1
    parts, moved, at = [], [], 0.0
    for label in (*labels[begins - 1 : ends], *labels[1:begins]):
        parts.append(sound[round(label.start * SAMPLE_RATE) : round(label.end * SAMPLE_RATE)])
        moved.append(Label(at, at + label.end - label.start, label.phone, label.phoneme, label.certainty))
        at = moved[-1].end
    return np.concatenate(parts), tuple(moved)
