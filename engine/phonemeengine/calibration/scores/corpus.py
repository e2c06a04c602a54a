"""Labelled recordings: sounds with label files, in a folder with a manifest or side by side.

``manifest.csv`` has a row per utterance with at least the columns corpus, speaker, wav and labels (paths relative
to the folder). A label file of the corpus format has the columns start_s, end_s, phone, class and certainty.
"""

import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

import numpy as np

from phonemeengine.arrays import BoolArray, UInt8Array
from phonemeengine.audio.files import SoundReader, is_sound, once_each
from phonemeengine.calibration.takes.take import LIST
from phonemeengine.errors import AudioError, CorpusError
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.labels.files import LABEL_SUFFIXES, names_in, read_labels, read_raw_labels
from phonemeengine.labels.phone_sets import PhonemeMap, labels_named
from phonemeengine.labels.table import read_text, rows_of
from phonemeengine.labels.utterance import CORE, Label, RawLabel
from phonemeengine.labels.visemes import NO_VISEME, viseme_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD, Channel
from phonemeengine.storage.files import printable_name

__all__ = [
    "FrameLabels",
    "Label",
    "LabelledUtterance",
    "frame_labels_of",
    "read_corpus",
    "read_labels",
    "read_recordings",
]

OnSkipped = Callable[[AudioError], None]
"""Called with each sound that cannot be read, and why."""

MANIFEST = "manifest.csv"
MANIFEST_COLUMNS = ("corpus", "speaker", "wav", "labels")


@dataclass(frozen=True)
class LabelledUtterance:
    """One labelled recording.

    Attributes
    ----------
    path : the sound file.
    labels : what was said, in order of time.
    speaker, corpus : who said it, and the part of the corpus it belongs to.
    channel : what is analysed of a sound that has several.
    cut_off : what the sound's file lacks, as a sentence; empty where it is whole.
    text, language : what is said, in letters, and in which language, where the manifest tells.
    """

    path: Path
    labels: tuple[Label, ...]
    speaker: str
    corpus: str
    channel: Channel = Channel.MIX
    cut_off: str = ""
    text: str = ""
    language: str = ""

    @property
    def voice(self) -> str:
        """Who says it, as corpus/speaker."""
        return f"{self.corpus}/{self.speaker}"

    def opened(self) -> SoundReader:
        """Open its sound.

        Raises
        ------
        AudioError : it cannot be read.
        """
        return SoundReader(self.path, self.channel)


@dataclass(frozen=True)
class FrameLabels:
    """The labels of an utterance at the middles of its frames.

    Attributes
    ----------
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`.
    certain : bool, shape (n_frames,): whether the label is a core one.
    visemes : uint8, shape (n_frames,): codes of `Viseme`, or `NO_VISEME` where it is unknown or disputed.
    """

    phonemes: UInt8Array
    certain: BoolArray
    visemes: UInt8Array

    def at(self, frames: slice | BoolArray) -> "FrameLabels":
        """Return the labels of some frames."""
        return FrameLabels(self.phonemes[frames], self.certain[frames], self.visemes[frames])


@dataclass(frozen=True)
class _Pair:
    """A sound, its label file if there is one, whose they are, the channel that counts, and what is said."""

    sound: Path
    labels: Path | None
    speaker: str
    corpus: str
    channel: Channel
    text: str = ""
    language: str = ""


def read_corpus(
    folder: Path,
    mapping: PhonemeMap | None = None,
    *,
    channel: Channel = Channel.MIX,
    on_skipped: OnSkipped | None = None,
    unlabelled: bool = False,
    progress: Progress = no_progress,
) -> tuple[LabelledUtterance, ...]:
    """Read the manifest and all label files of a folder; of the sounds only their lengths.

    `channel` is what will be analysed of sounds that have several. `on_skipped` is called for each sound that cannot
    be read, which is then left out; None refuses it. Rows that name no label file are left out too, unless
    `unlabelled` asks for them: a teacher may know what is said there. `progress` receives the share that is read.

    Raises
    ------
    UnknownPhonemeError : names in the label files stand for no phoneme; it holds those of all files.
    CorpusError : a file is missing or says something impossible; names the file, the line and what was found.
    AudioError : a sound is missing or cannot be read.
    """
    rows = rows_of(read_text(folder / MANIFEST), MANIFEST_COLUMNS, MANIFEST)
    pairs = [
        _Pair(
            folder / row["wav"],
            folder / row["labels"] if row["labels"] else None,
            row["speaker"],
            row["corpus"],
            channel,
            row.get("text", ""),
            row.get("language", ""),
        )
        for _, row in rows
        if row["labels"] or unlabelled
    ]
    source = folder.name or str(folder)
    return _utterances_of(pairs, mapping or PhonemeMap(), source, None, on_skipped, progress)


def read_recordings(
    source: str | os.PathLike[str],
    mapping: PhonemeMap | None = None,
    *,
    speaker: str | None = None,
    tier: str | None = None,
    channel: Channel = Channel.MIX,
    on_skipped: OnSkipped | None = None,
    progress: Progress = no_progress,
) -> tuple[LabelledUtterance, ...]:
    """Read labelled recordings wherever they are.

    Parameters
    ----------
    source : a folder with a manifest, or one in which, however deep, sounds lie beside label files of the same name
        (.TextGrid, .csv, .txt; of takes, the .csv counts), or one sound with its label file. Where a recording is
        there as x.wav and x.flac, it counts once.
    mapping : what unknown names stand for.
    speaker : who speaks, unless a manifest says it; where it is None, the folder of the sound tells.
    tier : of TextGrids; the first one whose names are phonemes, where it is None.
    channel : what will be analysed of sounds that have several.
    on_skipped : told of each sound that cannot be read, which is then left out; None refuses it.
    progress : called with the share that is read, 0..1.

    Raises
    ------
    Cancelled : the answer of `progress` is not to go on.
    UnknownPhonemeError : names in the label files stand for no phoneme; it holds those of all files.
    CorpusError : a label file says something impossible, or there is none, or no such folder.
    AudioError : a sound is missing or cannot be read.
    """
    source, mapping = Path(source), mapping or PhonemeMap()
    if not source.exists():
        raise CorpusError(f"{printable_name(source)}: there is no such folder; name one with labelled recordings")
    if (source / MANIFEST).is_file():
        return read_corpus(source, mapping, channel=channel, on_skipped=on_skipped, progress=progress)
    pairs = list(_pairs_beside(source, speaker, channel))
    if not pairs:
        fault = "there is no label file beside this sound" if source.is_file() else "no labelled sound was found here"
        raise CorpusError(
            f"{printable_name(source)}: {fault}; "
            "put a .TextGrid, .csv or .txt file of the same name beside each sound"
        )
    return _utterances_of(pairs, mapping, printable_name(source), tier, on_skipped, progress)


def is_labelled(source: Path) -> bool:
    """Return whether a folder has a manifest, or any sound in it a label file beside it."""
    return (source / MANIFEST).is_file() or next(_pairs_beside(source, None, Channel.MIX), None) is not None


def frame_labels_of(labels: tuple[Label, ...]) -> FrameLabels:
    """Return the class and the certainty at the middle of every frame that begins before the last label ends.

    A frame that no label covers counts as silence, not certain.
    """
    times = np.arange(FRAME_PERIOD / 2, labels[-1].end, FRAME_PERIOD)
    phonemes = np.full(len(times), Phoneme.SILENCE, np.uint8)
    certain = np.zeros(len(times), bool)
    visemes = np.full(len(times), NO_VISEME, np.uint8)
    for label in labels:
        first, last = np.searchsorted(times, (label.start, label.end))
        phonemes[first:last] = label.phoneme
        certain[first:last] = label.certainty == CORE
        viseme = viseme_of(label.phone, label.phoneme) if label.certainty == CORE else None
        visemes[first:last] = NO_VISEME if viseme is None else viseme
    return FrameLabels(phonemes, certain, visemes)


def _utterances_of(
    pairs: Sequence[_Pair],
    mapping: PhonemeMap,
    source: str,
    tier: str | None,
    on_skipped: OnSkipped | None,
    progress: Progress,
) -> tuple[LabelledUtterance, ...]:
    """Read all label files before any name is given a meaning, so that all unknown ones are reported at once."""
    read = []
    for k, pair in enumerate(pairs):
        report_progress(progress, k / len(pairs))
        try:
            read.append((pair, *_marks_of(pair, mapping, tier)))
        except AudioError as error:
            if on_skipped is None:
                raise
            on_skipped(error)
    names = sum((names_in(raw_labels) for _, raw_labels, _ in read), Counter())
    phone_classes = mapping.phone_classes_of(names, source)
    return tuple(
        LabelledUtterance(
            pair.sound,
            labels_named(raw_labels, phone_classes),
            pair.speaker,
            pair.corpus,
            pair.channel,
            cut_off,
            pair.text,
            pair.language,
        )
        for pair, raw_labels, cut_off in read
    )


def _marks_of(pair: _Pair, mapping: PhonemeMap, tier: str | None) -> tuple[tuple[RawLabel, ...], str]:
    """Read the marks of a sound, and what its file lacks."""
    with SoundReader(pair.sound, pair.channel) as reader:
        duration, cut_off = reader.duration, reader.cut_off
    if pair.labels is None:
        return (), cut_off
    return read_raw_labels(pair.labels, mapping, duration=duration, tier=tier), cut_off


def _pairs_beside(source: Path, speaker: str | None, channel: Channel) -> Iterator[_Pair]:
    deep = source.is_dir()
    top = source if deep else source.parent
    found = dict(_labelled_sounds_in(os.walk(top) if deep else islice(os.walk(top), 1)))
    for sound in once_each(found)[0] if deep else [path for path in found if path == source]:
        labels = found[sound]
        yield _Pair(sound, labels, speaker or sound.parent.absolute().name, top.absolute().name, channel)


def _labelled_sounds_in(walk: Iterable[tuple[str, list[str], list[str]]]) -> Iterator[tuple[Path, Path]]:
    """Return each sound that has a label file of the same name beside it, with that; no hidden folders."""
    for folder, folders, files in walk:
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        paths = [Path(folder, name) for name in sorted(files)]
        labels = {(path.stem, path.suffix.lower()): path for path in paths}
        suffixes = _suffixes_in(Path(folder))
        for sound in paths:
            if is_sound(sound):
                beside = [labels[sound.stem, suffix] for suffix in suffixes if (sound.stem, suffix) in labels]
                yield from ((sound, found) for found in beside[:1])


def _suffixes_in(folder: Path) -> tuple[str, ...]:
    """Return the endings of label files, the one that counts first: beside a take, others are copies of the table."""
    is_of_takes = (folder.absolute().parent.parent / LIST).is_file()
    return tuple(sorted(LABEL_SUFFIXES, key=lambda suffix: suffix != ".csv")) if is_of_takes else LABEL_SUFFIXES
