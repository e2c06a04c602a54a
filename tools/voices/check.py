"""Figures that tell whether the labels of a built corpus fit its sound: one line a voice."""

import csv
from collections import defaultdict
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

import numpy as np
import parselmouth
import soundfile
from scipy.signal import stft

from tools.voices.classes import CLASSES, CORE, VOWELS
from tools.voices.writing import read_manifest

UTTERANCES = 20  # of each voice
HOP = 0.001  # s
WINDOW = 0.0116  # s
SHIFTS = range(-25, 26)  # hops
BANDS = ((60, 300), (300, 700), (700, 1200), (1200, 2000), (2000, 3000), (3000, 4500), (4500, 8000))  # Hz


class Labelled(NamedTuple):
    """One utterance: (n,) samples, their rate in hertz, and rows of start, end, class, certainty."""

    sound: np.ndarray
    sample_rate: int
    labels: list[tuple[float, float, str, str]]


def check(folder: Path) -> None:
    """Print the figures of every voice of the corpus whose recordings have labels."""
    print("speaker\tmin\tsilence_db\tsz_hz\tsch_hz\t" + "\t".join(f"{vowel}_hz" for vowel in VOWELS) + "\tshift_ms")
    labelled = (row for row in read_manifest(folder) if row[6])
    for (corpus, speaker), rows in groupby(labelled, key=lambda row: row[:2]):
        taken = list(rows)
        minutes = sum(float(row[7]) for row in taken) / 60
        figures = figures_of([_read(folder, row) for row in taken[:UTTERANCES]])
        print("\t".join([f"{corpus}/{speaker}", f"{minutes:.1f}", *figures]), flush=True)


def _read(folder: Path, row: list[str]) -> Labelled:
    sound, sample_rate = soundfile.read(folder / row[5])
    with (folder / row[6]).open(encoding="utf-8", newline="") as file:
        labels = [(float(a), float(b), name, sure) for a, b, _, name, sure in list(csv.reader(file))[1:]]
    return Labelled(sound, sample_rate, labels)


def figures_of(utterances: list[Labelled]) -> list[str]:
    """Level of silence against vowels, centroids of sz and sch, formants of the vowels, best shift."""
    levels, centroids = defaultdict(list), defaultdict(list)
    tracks = [_measure(utterance, levels, centroids) for utterance in utterances]
    vowels = np.median(np.concatenate([levels[vowel] for vowel in VOWELS if levels[vowel]]))
    formants = _formants(utterances)
    return [
        f"{np.median(levels['silence']) - vowels:.0f}",
        *(f"{np.median(centroids[name]):.0f}" if centroids[name] else "-" for name in ("sz", "sch")),
        *("/".join(f"{v:.0f}" for v in np.median(formants[v], axis=0)) if formants[v] else "-" for v in VOWELS),
        f"{best_shift(tracks) * 1000:.0f}",
    ]


def _measure(utterance: Labelled, levels: dict, centroids: dict) -> tuple[np.ndarray, np.ndarray]:
    """Adds levels and centroids of the labels' middles; gives band levels (band, frame) and each frame's class."""
    size = int(WINDOW * utterance.sample_rate)
    hop = round(HOP * utterance.sample_rate)
    frequency, time, spectrum = stft(
        utterance.sound, utterance.sample_rate, nperseg=size, noverlap=size - hop, boundary=None, padded=False
    )
    power = np.abs(spectrum) ** 2 + 1e-14
    level = 10 * np.log10(power[frequency >= 60].sum(axis=0))
    high = power * (frequency > 500)[:, None]
    centroid = (high * frequency[:, None]).sum(axis=0) / high.sum(axis=0)
    names = np.full(len(time), -1)
    for start, end, name, _ in utterance.labels:
        names[(time >= start) & (time < end)] = CLASSES.index(name)
        middle = np.abs(time - (start + end) / 2) < (end - start) / 4
        if middle.any():
            levels[name].append(np.median(level[middle]))
            centroids[name].append(np.median(centroid[middle]))
    bands = [power[(frequency >= low) & (frequency < top)].sum(axis=0) for low, top in BANDS]
    decibels = 10 * np.log10(np.stack(bands) + 1e-10)
    return np.maximum(decibels, decibels.max() - 70), names


def best_shift(tracks: list[tuple[np.ndarray, np.ndarray]]) -> float:
    """Seconds by which the labels are to be moved so that they explain the bands best; below 0 they come late."""
    explained = []
    edge = len(SHIFTS)
    for shift in SHIFTS:
        bands = np.concatenate([bands[:, edge:-edge] for bands, _ in tracks], axis=1)
        names = np.concatenate([np.roll(names, shift)[edge:-edge] for _, names in tracks])
        bands, names = bands[:, names >= 0], names[names >= 0]
        within = sum(bands[:, names == name].var(axis=1) * (names == name).sum() for name in np.unique(names))
        explained.append(1 - float(np.mean(within / (bands.var(axis=1) * bands.shape[1]))))
    return SHIFTS[int(np.argmax(explained))] * HOP


def _formants(utterances: list[Labelled]) -> dict[str, list[tuple[float, float]]]:
    """First and second formant in hertz of every sure vowel longer than 50 ms."""
    found: dict[str, list[tuple[float, float]]] = defaultdict(list)
    for utterance in utterances:
        track = parselmouth.Sound(utterance.sound, utterance.sample_rate).to_formant_burg(0.005, 5, 5300, 0.025, 50)
        for start, end, name in _sure_vowels(utterance):
            pair = (track.get_value_at_time(1, (start + end) / 2), track.get_value_at_time(2, (start + end) / 2))
            if not np.isnan(pair).any():
                found[name].append(pair)
    return found


def _sure_vowels(utterance: Labelled) -> Iterator[tuple[float, float, str]]:
    for start, end, name, certainty in utterance.labels:
        if name in VOWELS and certainty == CORE and end - start > 0.05:
            yield start, end, name
