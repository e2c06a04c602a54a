"""A threshold is dragged over one hour of labelled sound: the new confusion matrix, on one core."""

import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import soundfile

from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.labels.files import read_labels
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import SAMPLE_RATE
from tools.bench.figures import ROOT, Absolute, Figure, shown

SECONDS = 3600
N_DIFFERENT = 20
"""So many copies of the speech have a noise of their own; the hour repeats them."""
LIMIT = 0.05
CARDS = ROOT / "tests" / "data" / "cards.flac"
DRAGGED = ("ae_ae1", "silence_energy", "o_o1")
STEPS = np.linspace(0.5, 1.5, 8)


def figures() -> list[Figure]:
    """Drag three thresholds up, without and with hysteresis; a step is everything until the new matrix is there."""
    preset = load_preset(FACTORY / "thesis.toml")
    labelled = _labelled(preset)
    hours = labelled.edges[-1] / 100 / 3600
    found = []
    for hysteresis in (0.0, 0.1):
        base = replace(preset, settings=replace(preset.settings, hysteresis=hysteresis))
        wall, process = _dragged(labelled, base)
        name = f"{hours:.1f} h, threshold dragged, " + ("hysteresis" if hysteresis else "no hysteresis")
        ratio = float(np.median(process)) / LIMIT
        found.append(
            Figure(
                name, f"{shown(process)} ({shown(wall)} by the clock)", "50 ms", ratio, 1.0, absolute=Absolute.WORK
            )
        )
    return found


def _labelled(preset: Preset) -> LabelledFeatures:
    """Measure noisy copies of labelled speech, and lay them end to end for an hour."""
    with tempfile.TemporaryDirectory() as folder:
        copies = list(_noisy_copies(Path(folder)))
        measured = LabelledFeatures(copies, preset)
        n = -(-SECONDS * 100 * len(copies) // int(measured.edges[-1]))
        return LabelledFeatures([copies[k % len(copies)] for k in range(n)], preset, known=measured)


def _noisy_copies(folder: Path) -> Iterator[LabelledUtterance]:
    generator = np.random.default_rng(1)
    with SoundReader(CARDS) as reader:
        speech = np.concatenate(list(reader.blocks(SAMPLE_RATE)))
    labels = read_labels(CARDS.with_suffix(".csv"))
    for k in range(N_DIFFERENT):
        hiss = 10 ** generator.uniform(-4, -1.5) * generator.standard_normal(len(speech), np.float32)
        soundfile.write(folder / f"{k}.wav", speech + hiss, SAMPLE_RATE, subtype="FLOAT")
        yield LabelledUtterance(folder / f"{k}.wav", labels, f"noise {k}", "bench")


def _dragged(labelled: LabelledFeatures, preset: Preset) -> tuple[list[float], list[float]]:
    """Give the seconds of each step, by the clock and of this process alone."""
    wall, process = [], []
    labelled.confusion(preset)
    for name in DRAGGED:
        for step in STEPS:
            limit = float(getattr(preset.thresholds, name) * step)
            moved = replace(preset, thresholds=replace(preset.thresholds, **{name: limit}))
            began, worked = time.perf_counter(), time.process_time()
            confusion = labelled.confusion(moved)
            assert 0 <= confusion.macro_f1 <= 1
            wall.append(time.perf_counter() - began)
            process.append(time.process_time() - worked)
    return wall, process
