"""Writes labelled utterances (FLAC and label CSV) and the manifest of a corpus."""

import csv
import shutil
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import soundfile
import soxr

from tools.voices.classes import Phone
from tools.voices.labels import Segment, labels_of

SAMPLE_RATE = 44100
LABEL_COLUMNS = ("start_s", "end_s", "phone", "class", "certainty")
MANIFEST_COLUMNS = (
    "corpus",
    "speaker",
    "language",
    "sex_or_age",
    "kind",
    "wav",
    "labels",
    "duration_s",
    "original_rate",
    "licence",
    "source_package",
    "phoneset",
    "text",
)


class Speaker(NamedTuple):
    """What the manifest says of a voice."""

    corpus: str
    name: str
    language: str
    sex: str
    kind: str
    licence: str
    package: str
    phone_set: str


class Utterance(NamedTuple):
    """Speech of one sentence: (n,) samples in -1..1, their rate in hertz, the phones' times if known, the text."""

    sound: np.ndarray
    sample_rate: int
    segments: list[Segment]
    text: str


class UtteranceWriter:
    """Writes the utterances of one speaker, and remembers their rows for the manifest.

    Parameters
    ----------
    folder : of the corpus; the files go to ``folder/<corpus>/<speaker>``, which is emptied first.
    shift : seconds by which the voice's labels are corrected.
    """

    def __init__(self, folder: Path, speaker: Speaker, table: dict[str, Phone], shift: float = 0.0) -> None:
        self._folder, self._speaker, self._table, self._shift = folder, speaker, table, shift
        self._place = Path(speaker.corpus) / speaker.name
        self.rows: list[list[str]] = []
        self.seconds = 0.0
        shutil.rmtree(folder / self._place, ignore_errors=True)
        (folder / self._place).mkdir(parents=True)

    def write(self, utterance: Utterance) -> None:
        """Write the sound of one utterance, and if its phones are known its labels, for which 44.1 kHz are needed."""
        rate = SAMPLE_RATE if utterance.segments else utterance.sample_rate
        sound = _limited(soxr.resample(utterance.sound, utterance.sample_rate, rate, quality="VHQ"))
        base = self._place / f"{self._speaker.name}_{len(self.rows):04d}"
        soundfile.write(self._folder / f"{base}.flac", sound, rate, subtype="PCM_16")
        if utterance.segments:
            labels = labels_of(utterance.segments, self._table, sound, SAMPLE_RATE, self._shift)
            with (self._folder / f"{base}.csv").open("w", newline="", encoding="utf-8") as file:
                table = csv.writer(file)
                table.writerow(LABEL_COLUMNS)
                table.writerows((f"{start:.4f}", f"{end:.4f}", *rest) for start, end, *rest in labels)
        self._remember(base.as_posix(), len(sound) / rate, utterance)

    def _remember(self, base: str, duration: float, utterance: Utterance) -> None:
        speaker = self._speaker
        self.seconds += duration
        self.rows.append(
            [
                *speaker[:5],
                f"{base}.flac",
                f"{base}.csv" if utterance.segments else "",
                f"{duration:.3f}",
                str(utterance.sample_rate),
                *speaker[5:],
                utterance.text,
            ]
        )


def _limited(sound: np.ndarray) -> np.ndarray:
    """The sound, made quieter where it would clip."""
    peak = np.max(np.abs(sound))
    return sound * (0.999 / peak) if peak > 0.999 else sound


def read_manifest(folder: Path) -> list[list[str]]:
    """Rows of the manifest, without its head; none where there is no manifest."""
    path = folder / "manifest.csv"
    if not path.exists():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))[1:]


def replace_speaker(folder: Path, speaker: Speaker, rows: Iterable[list[str]]) -> None:
    """Rewrite the manifest with these rows for the speaker; it is whole at every moment."""
    folder.mkdir(parents=True, exist_ok=True)
    others = [row for row in read_manifest(folder) if tuple(row[:2]) != speaker[:2]]
    temporary = folder / "manifest.csv.new"
    with temporary.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(MANIFEST_COLUMNS)
        table.writerows(sorted([*others, *rows], key=lambda row: (row[0], row[1], row[5])))
    temporary.replace(folder / "manifest.csv")
