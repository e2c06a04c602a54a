"""Small corpora whose right answers are known, because the preset itself made the labels."""

import csv
from collections.abc import Callable, Iterable
from pathlib import Path

import numpy as np
import soundfile

from phonemeengine.analyser import analyse_blocks
from phonemeengine.labels.files import write_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import SAMPLE_RATE
from tests.labelled import labels_of
from tests.sounds import Sound, noise, silence, vowel

MANIFEST = ("corpus", "speaker", "wav", "labels")


def speech(f0: float = 120.0, seed: int = 0) -> Sound:
    """Silence, vowels and hisses of 1.5 s that most recognisers hear differently."""
    parts = [
        silence(0.2),
        vowel((750, 1250, 2500), 0.3, f0),
        noise(0.2, 0.1, seed),
        vowel((300, 2200, 3000), 0.3, f0),
        vowel((310, 800, 2300), 0.3, f0),
        silence(0.2),
    ]
    return np.concatenate(parts)


def recognised_by(preset: Preset, sound: Sound) -> np.ndarray:
    return np.concatenate([a.phonemes for a in analyse_blocks([sound], preset)])


def write_corpus(
    folder: Path,
    preset: Preset,
    speakers: Iterable[str] = ("human_one/ann", "human_two/bob", "machine/cyd"),
    change: Callable[[np.ndarray], np.ndarray] = lambda codes: codes,
) -> Path:
    """Write a recording for each speaker, labelled with what a preset hears, changed as is asked."""
    rows = []
    for k, name in enumerate(speakers):
        corpus, speaker = name.split("/", 1)
        sound = speech(100.0 + 30 * k, k)
        soundfile.write(folder / f"u{k}.wav", sound, SAMPLE_RATE, subtype="FLOAT")
        labels = labels_of(change(recognised_by(preset, sound)), len(sound) / SAMPLE_RATE)
        write_labels(labels, folder / f"u{k}.csv")
        rows.append((corpus, speaker, f"u{k}.wav", f"u{k}.csv"))
    write_manifest(folder, rows)
    return folder


def write_manifest(folder: Path, rows: Iterable[tuple[str, ...]]) -> None:
    with (folder / "manifest.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(MANIFEST)
        writer.writerows(rows)


def put(folder: Path, name: str, sound: Sound, labels: tuple[Label, ...]) -> None:
    """Write a recording with labels of its own beside it."""
    soundfile.write(folder / f"{name}.wav", sound, SAMPLE_RATE, subtype="FLOAT")
    write_labels(labels, folder / f"{name}.csv")
