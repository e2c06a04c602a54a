"""A threshold is dragged over one hour of labelled sound: all figures and the confusion matrix anew, on one core."""

import tempfile
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import soundfile

from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.labels.files import read_labels
from phonemeengine.presets.controls import Control, controls_of
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.spec import recogniser_of
from phonemeengine.settings import SAMPLE_RATE
from tools.bench.figures import ROOT, Figure, shown
from tools.bench.speed import scaled_work

SECONDS = 3600
N_DIFFERENT = 20
"""Copies of the speech with a noise of their own; the hour repeats them."""
LIMIT = 0.05
PRESETS = ("thesis", "extended", "learned")
CARDS = ROOT / "tests" / "data" / "cards.flac"
N_DRAGGED = 3
"""Controls of each preset that are dragged: those that change the most comparisons."""
STEPS = np.linspace(-0.3, 0.3, 8)
"""By what share of a limit, or by how many nats of a sensitivity, a control is moved."""


def figures() -> list[Figure]:
    """Drag three controls of each preset, rules of the thesis with hysteresis, too; a step ends with the figures."""
    found = []
    for name in PRESETS:
        preset = load_preset(FACTORY / f"{name}.toml")
        labelled = _labelled(preset)
        for hysteresis in dict.fromkeys((preset.settings.hysteresis, 0.1)):
            base = replace(preset, settings=replace(preset.settings, hysteresis=hysteresis))
            scaled = _dragged(labelled, base)
            found.append(
                Figure(
                    f"{labelled.edges[-1] / 100 / 3600:.1f} h scored anew, {name} dragged, hysteresis {hysteresis:g}",
                    f"{shown(scaled)}, scaled",
                    "50 ms",
                    float(np.median(scaled)) / LIMIT,
                    1.0,
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


def _dragged(labelled: LabelledFeatures, preset: Preset) -> list[float]:
    """Give the seconds of the processor of each step, scaled."""
    scaled = []
    labelled.confusion(preset)
    for control in _most_asked(preset):
        value = control.read(preset)
        for step in STEPS:
            moved = control.write(preset, value + step * (abs(value) or 1.0))
            scaled.append(scaled_work(partial(_score, labelled, moved)))
    return scaled


def _score(labelled: LabelledFeatures, preset: Preset) -> None:
    agreement = labelled.confusion(preset).agreement
    assert 0 <= agreement.macro_f1 <= 1
    agreement.worst_confusions(2)


def _most_asked(preset: Preset) -> list[Control]:
    made = recogniser_of(preset.recogniser, preset.config)
    controls = [control for group in controls_of(preset, made) for control in group.controls if control.variable]
    return sorted(controls, key=lambda control: -len(control.places))[:N_DRAGGED]
