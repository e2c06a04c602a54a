"""The learned recogniser: one frame at a time, whole files, adapting to a voice; without any library for learning."""

import time

import numpy as np

from phonemeengine.analyser import Analyser
from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.features.measure import Features
from phonemeengine.labels.files import read_labels
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.settings import HOP, WINDOW
from tools.bench.dragging import CARDS
from tools.bench.figures import Absolute, Figure, interleaved, shown, speech

N_FRAMES = 1000
N_ROUNDS = 9
ONE_FRAME = 150e-6
REAL_TIME = 300
MINUTES = 5
ADAPTED_WITHIN = 5.0
COPIES = 3
"""Of 3.4 s of labelled speech: as much as the takes of a guided calibration, which is judged by one sentence."""


def figures() -> list[Figure]:
    """Measure all three."""
    preset = load_preset(DEFAULT_PRESET)
    return [_one_frame(preset), _whole_file(preset), _adapting(preset)]


def _one_frame(preset: Preset) -> Figure:
    assert preset.model is not None
    windows = np.lib.stride_tricks.sliding_window_view(speech(N_FRAMES * HOP / 44_100 + 0.1), WINDOW)[::HOP]
    blocks = [w[np.newaxis] for w in windows[:N_FRAMES]]
    features = Features(("energy",), np.zeros((1, 1), np.float32))
    recogniser = LearnedRecogniser(preset.model, 0.05)

    def recognise_all() -> None:
        for block in blocks:
            recogniser.recognise(block, features)

    (seconds,) = interleaved(N_ROUNDS, recognise_all)
    ratio = float(np.median(seconds)) / N_FRAMES / ONE_FRAME
    return Figure(
        "learned recogniser, one frame", shown(seconds, N_FRAMES), "150 µs", ratio, 1.0, absolute=Absolute.TIME
    )


def _whole_file(preset: Preset) -> Figure:
    sound = speech(60 * MINUTES)

    def analyse() -> None:
        analyser = Analyser(preset)
        for k in range(0, len(sound), 512 * HOP):
            analyser.push(sound[k : k + 512 * HOP])
        analyser.finish()

    (seconds,) = interleaved(3, analyse)
    limit = 60 * MINUTES / REAL_TIME
    return Figure(
        f"learned, {MINUTES} min of sound",
        shown(seconds),
        f"1/{REAL_TIME} of it",
        float(np.median(seconds)) / limit,
        1.0,
        absolute=Absolute.TIME,
    )


def _adapting(preset: Preset) -> Figure:
    said = LabelledUtterance(CARDS, read_labels(CARDS.with_suffix(".csv")), "cards", "takes")
    began = time.perf_counter()
    calibrate(preset, [said] * COPIES, held_back=[said])
    seconds = [time.perf_counter() - began]
    ratio = seconds[0] / ADAPTED_WITHIN
    return Figure("calibrating to 10 s of takes", shown(seconds), "5 s", ratio, 1.0, absolute=Absolute.TIME)
