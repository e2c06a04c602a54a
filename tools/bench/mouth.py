"""The mouth: a picture of one face, and one hour of speech in every format."""

import dataclasses
import tempfile
import time
from pathlib import Path

import numpy as np

from phonemeengine.analyser import analyse_blocks
from phonemeengine.audio.files import SoundReader
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.morpher import Morpher
from phonemeengine.mouth.table import load_table
from phonemeengine.mouth.transcript import Transcript, transcript_of
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import FRAME_PERIOD
from tests.glb_faces import face_with_targets
from tools.bench.figures import DEMO, Absolute, Figure, interleaved, shown

N_PICTURES = 6000
N_ROUNDS = 7
PICTURE_LIMIT = 30e-6
HOUR = 3600.0
HOUR_LIMIT = 10.0


def figures() -> list[Figure]:
    """Measure the morpher as a live face uses it, and the writing of all formats, without the analysis."""
    return [_picture(), *_hours()]


def _picture() -> Figure:
    table, codes = load_table("arkit"), np.repeat(np.random.default_rng(0).integers(0, 11, N_PICTURES // 6), 6)
    frames = list(zip(codes.tolist(), np.linspace(0, 1, len(codes)).tolist(), strict=True))

    def talk() -> None:
        morpher = Morpher(table)
        for k, (code, intensity) in enumerate(frames):
            morpher.add(k * FRAME_PERIOD, code, intensity)
            morpher.weights(k * FRAME_PERIOD + 0.005)

    (times,) = interleaved(N_ROUNDS, talk)
    ratio = float(np.median(times)) / len(frames) / PICTURE_LIMIT
    return Figure("mouth, one picture", shown(times, len(frames)), "30 µs", ratio, 1.0, absolute=Absolute.TIME)


def _hours() -> list[Figure]:
    speech, found = _one_hour(), []
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder) / "face.glb"
        mesh.write_bytes(face_with_targets(ARKIT))
        for name, form in FORMATS.items():
            exporter = Exporter(name, ExportOptions(mesh=mesh if form.moves_mesh else None))
            began = time.perf_counter()
            size = sum(len(part) for part in exporter.chunks_of(speech))
            seconds = time.perf_counter() - began
            words = f"{seconds:.2f} s, {size / 1e6:.1f} MB"
            ratio = seconds / HOUR_LIMIT
            found.append(Figure(f"one hour as {name}", words, "10 s", ratio, 1.0, absolute=Absolute.TIME))
    return found


def _one_hour() -> Transcript:
    """Give what is said in the demo, again and again."""
    with SoundReader(DEMO) as reader:
        said = transcript_of(
            analyse_blocks(reader.blocks(44_100), load_preset(DEFAULT_PRESET), pitch=True), "", reader.duration
        )
    n = len(said.intensities)
    length, times = n * FRAME_PERIOD, round(HOUR / (n * FRAME_PERIOD))
    runs = [
        dataclasses.replace(run, start=run.start + k * length, end=min(run.end, length) + k * length)
        for k in range(times)
        for run in said.runs
    ]
    return Transcript(
        "hour.wav", times * length, tuple(runs), np.tile(said.intensities, times), np.tile(said.pitches, times)
    )
