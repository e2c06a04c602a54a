"""The learned recogniser: one frame at a time, whole files by each model, adapting to a voice."""

import json
import os
import time

import numpy as np
import scipy.fft

from phonemeengine.analyser import BLOCK, analyse_blocks
from phonemeengine.calibration.adaptation import adapt_live_head
from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.fine_tuning import example_of, sound_of, whisper_mels_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.encoder.model_folder import has_whisper
from phonemeengine.features.variables import Features
from phonemeengine.labels.files import read_labels
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.model_choice import (
    for_files,
    has_model,
    model_in_words,
    recogniser_for,
    states_in,
    with_real_time_model,
)
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.recognition.spec import Recogniser
from phonemeengine.settings import HOP, WINDOW, ModelKind
from tools.bench import PINS
from tools.bench.dragging import CARDS
from tools.bench.figures import Absolute, Figure, answer_of, interleaved, ratio_of, shown, speech

N_FRAMES = 1000
N_ROUNDS = 9
FRAME_LIMIT, FRAME_AIM = 27, 14
"""Bare transforms of 512 values that one live frame may take, and should."""
STATE_LIMIT, STATE_AIM = 356, 200
"""The same for 20 ms in real time with the encoder: 8 % of a core where a transform takes 4.5 us, and less."""
MODEL_MB = 2
REAL_TIME, ENCODER_REAL_TIME = 300, 20
"""How many times as fast as it plays a file is recognised, by the network on one core, and with Whisper on two."""
MINUTES, ENCODER_MINUTES = 5, 2
ADAPTED_WITHIN, HEAD_WITHIN = 5.0, 2.0
"""Seconds for a calibration, and for the states and the head of the real-time model in it."""
COPIES = 3
"""Of 3.4 s of labelled speech: as much as the takes of a guided calibration, which is judged by one sentence."""


def figures() -> list[Figure]:
    """Measure all of them."""
    preset = load_preset(DEFAULT_PRESET)
    known = [_one_frame(preset), *_real_time(preset), *_model_sizes(preset), _whole_file(preset, ModelKind.REAL_TIME)]
    if preset.offline_model is not None:
        known.append(_whole_file(preset, ModelKind.OFFLINE))
    return [*known, *_with_whisper(preset), _adapting(preset), *_adapting_head(preset)]


def _one_frame(preset: Preset) -> Figure:
    assert preset.model is not None
    recogniser = LearnedRecogniser(preset.model, 0.05)
    return _step("learned recogniser, one frame", recogniser, 1, (FRAME_LIMIT, FRAME_AIM))


def _real_time(preset: Preset) -> list[Figure]:
    if preset.live_encoder is None or not has_model(preset, ModelKind.ENCODER):
        print("  left out: the real-time model, which is not there")
        return []
    recogniser = recogniser_for(for_files(preset, ModelKind.ENCODER))
    return [_step("encoder and network in real time, 20 ms", recogniser, 2, (STATE_LIMIT, STATE_AIM))]


def _step(name: str, recogniser: Recogniser, n: int, limits: tuple[float, float]) -> Figure:
    """Measure blocks of n frames, beside as many transforms."""
    windows = np.lib.stride_tricks.sliding_window_view(speech(N_FRAMES * HOP / 44_100 + 0.1), WINDOW)[::HOP]
    blocks = np.split(windows[:N_FRAMES], N_FRAMES // n)
    wave = windows[0, :512].copy()
    features = Features(("energy",), np.zeros((n, 1), np.float32))

    def recognise_all() -> None:
        for block in blocks:
            recogniser.recognise(block, features)

    def transform_all() -> None:
        for _ in blocks:
            scipy.fft.rfft(wave)

    seconds, bare = interleaved(N_ROUNDS, recognise_all, transform_all)
    reference = f"scipy.fft.rfft(512) {shown(bare, len(blocks))}"
    return Figure(name, shown(seconds, len(blocks)), reference, ratio_of(seconds, bare), *limits)


def _model_sizes(preset: Preset) -> list[Figure]:
    names = {"its model": DEFAULT_PRESET.with_suffix(".npz")}
    if preset.offline_model is not None:
        names["its model for files"] = DEFAULT_PRESET.with_suffix(".files.npz")
    sizes = {name: path.stat().st_size / 1e6 for name, path in names.items()}
    return [Figure(name, f"{size:.2f} MB", f"{MODEL_MB} MB", size / MODEL_MB, 1.0) for name, size in sizes.items()]


def _whole_file(preset: Preset, kind: ModelKind) -> Figure:
    sound, used = speech(60 * MINUTES), for_files(preset, kind)

    def analyse() -> None:
        for _ in analyse_blocks(np.split(sound, range(BLOCK * HOP, len(sound), BLOCK * HOP)), used):
            pass

    (seconds,) = interleaved(3, analyse)
    limit = 60 * MINUTES / REAL_TIME
    ratio = float(np.median(seconds)) / limit
    name = f"{model_in_words(used)}, {MINUTES} min of sound"
    return Figure(name, shown(seconds), f"1/{REAL_TIME} of it", ratio, 1.0, absolute=Absolute.TIME)


def _with_whisper(preset: Preset) -> list[Figure]:
    """Measure in a process of its own, with as many threads as it would have anyway."""
    if preset.encoder_head is None or not has_whisper():
        print("  left out: files analysed with Whisper, which is not installed (phonemeanalyser whisper)")
        return []
    seconds = answer_of("learned")["seconds"]
    limit = 60 * ENCODER_MINUTES / ENCODER_REAL_TIME
    name = f"Whisper base and network, {ENCODER_MINUTES} min of sound"
    reference = f"1/{ENCODER_REAL_TIME} of it"
    return [Figure(name, shown(seconds), reference, float(np.median(seconds)) / limit, 1.0, absolute=Absolute.TIME)]


def main() -> None:
    """Recognise a sound with Whisper, on all cores, and print how long that took as JSON."""
    os.environ.pop(PINS[0])
    preset = for_files(load_preset(DEFAULT_PRESET), ModelKind.WHISPER)
    sound = speech(60 * ENCODER_MINUTES)

    def analyse() -> None:
        for _ in analyse_blocks(np.split(sound, range(BLOCK * HOP, len(sound), BLOCK * HOP)), preset):
            pass

    (seconds,) = interleaved(2, analyse)
    print(json.dumps({"seconds": seconds}))


def _adapting(preset: Preset) -> Figure:
    said = _said()
    began = time.perf_counter()
    calibrate(preset, [said] * COPIES, held_out=[said])
    seconds = [time.perf_counter() - began]
    ratio = seconds[0] / ADAPTED_WITHIN
    return Figure("calibrating to 10 s of takes", shown(seconds), "5 s", ratio, 1.0, absolute=Absolute.TIME)


def _adapting_head(preset: Preset) -> list[Figure]:
    live = with_real_time_model(preset)
    if live.model_kind is not ModelKind.ENCODER:
        return []
    sound, labels = sound_of(_said()), _said().labels
    began = time.perf_counter()
    states = [states_in(live, whisper_mels_of(sound)) for _ in range(COPIES)]
    adapt_live_head(live, [example_of(sound, labels)] * COPIES, states)
    seconds = [time.perf_counter() - began]
    ratio = seconds[0] / HEAD_WITHIN
    return [Figure("the real-time model's part of it", shown(seconds), "2 s", ratio, 1.0, absolute=Absolute.TIME)]


def _said() -> LabelledUtterance:
    return LabelledUtterance(CARDS, read_labels(CARDS.with_suffix(".csv")), "cards", "takes")


if __name__ == "__main__":
    main()
