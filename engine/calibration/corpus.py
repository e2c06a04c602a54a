"""Labelled recordings: a folder with a manifest, sounds and label files.

``manifest.csv`` has a row per utterance with at least the columns corpus, speaker, wav and labels (paths relative
to the folder). A label file has the columns start_s, end_s, phone, class and certainty; its rows leave no gaps.
"""

import csv
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from engine.errors import CorpusError
from engine.phonemes import Phoneme
from engine.settings import FRAME_PERIOD

PHONEMES = {phoneme.label: phoneme for phoneme in Phoneme}
MANIFEST_COLUMNS = ("corpus", "speaker", "wav", "labels")
LABEL_COLUMNS = ("start_s", "end_s", "phone", "class", "certainty")


@dataclass(frozen=True)
class Label:
    """What was said in one stretch of a recording.

    Attributes
    ----------
    start, end : seconds.
    phone : the sound in the alphabet of its language.
    phoneme : the class that it counts as.
    certainty : ``core``, or why the class is not certain, such as ``ambiguous`` or ``diphthong``.
    """

    start: float
    end: float
    phone: str
    phoneme: Phoneme
    certainty: str = "core"


@dataclass(frozen=True)
class Utterance:
    """One labelled recording.

    Attributes
    ----------
    path : the sound file.
    labels : what was said, in order of time and without gaps.
    speaker, corpus : who said it, and the part of the corpus it belongs to.
    """

    path: Path
    labels: tuple[Label, ...]
    speaker: str
    corpus: str


@dataclass(frozen=True)
class FrameLabels:
    """The labels of an utterance at the middles of its frames.

    Attributes
    ----------
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`.
    certain : bool, shape (n_frames,): whether the label is a core one.
    """

    phonemes: NDArray[np.uint8]
    certain: NDArray[np.bool_]


def read_corpus(folder: Path) -> tuple[Utterance, ...]:
    """Read the manifest and all label files of a folder; the sounds stay on the disk.

    Raises
    ------
    CorpusError : a file is missing or says something impossible; names the file, the line and what was found.
    """
    manifest = folder / "manifest.csv"
    return tuple(
        Utterance(
            path=folder / row["wav"],
            labels=read_labels(folder / row["labels"]),
            speaker=row["speaker"],
            corpus=row["corpus"],
        )
        for row in _rows(manifest, MANIFEST_COLUMNS)
    )


def read_labels(path: Path) -> tuple[Label, ...]:
    """Read one label file (`CorpusError` where it is none)."""
    return tuple(
        _label_of(row, f"{path.name}, line {line}") for line, row in enumerate(_rows(path, LABEL_COLUMNS), 2)
    )


def frame_labels_of(labels: tuple[Label, ...]) -> FrameLabels:
    """Give the class and the certainty at the middle of every frame that begins before the last label ends.

    A frame that no label covers counts as silence, not certain.
    """
    times = np.arange(FRAME_PERIOD / 2, labels[-1].end, FRAME_PERIOD)
    phonemes = np.full(len(times), Phoneme.SILENCE, np.uint8)
    certain = np.zeros(len(times), bool)
    for label in labels:
        inside = (times >= label.start) & (times < label.end)
        phonemes[inside] = label.phoneme
        certain[inside] = label.certainty == "core"
    return FrameLabels(phonemes, certain)


def _rows(path: Path, columns: tuple[str, ...]) -> list[dict[str, str]]:
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            reader = csv.DictReader(file)
            header = reader.fieldnames or ()
            rows = list(reader)
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise CorpusError(f"{path.name}: it cannot be read ({error}); check the file") from error
    missing = [name for name in columns if name not in header]
    if missing:
        raise CorpusError(f"{path.name}: it lacks the column {missing[0]}; it needs {', '.join(columns)}")
    if not rows:
        raise CorpusError(f"{path.name}: there is no row under the header; it needs at least one")
    return rows


def _label_of(row: dict[str, str], place: str) -> Label:
    if row["class"] not in PHONEMES:
        raise CorpusError(f"{place}: the class must be one of {', '.join(PHONEMES)}, found {row['class']!r}")
    try:
        start, end = float(row["start_s"]), float(row["end_s"])
    except (TypeError, ValueError):
        raise CorpusError(
            f"{place}: start_s and end_s must be seconds, found {row['start_s']!r} and {row['end_s']!r}"
        ) from None
    if not (math.isfinite(end) and 0 <= start <= end):
        raise CorpusError(f"{place}: a label must not end before it starts, found {start:g}..{end:g} s")
    return Label(start, end, row["phone"], PHONEMES[row["class"]], row["certainty"] or "core")
