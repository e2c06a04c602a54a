"""Words in a sound: how near to the synthesizers' own boundaries, right and wrong texts, speed, an hour's memory."""

import argparse
import gc
import math
import random
import time
from collections.abc import Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from itertools import pairwise

import numpy as np

from phonemeanalyser.cli.prediction_work import words_to_score
from phonemeengine.alignment.aligner import Aligner
from phonemeengine.alignment.evidence import Evidence, evidence_of, joined
from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import Float64Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.scores.corpus import LabelledUtterance, read_corpus
from phonemeengine.labels.utterance import Label, Phone, Utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.text.pronunciation import ScriptWord
from tools.bench.figures import ROOT, Absolute, Figure, shown
from tools.bench.memory import resident_megabytes

CORPUS = ROOT / "tests" / "data" / "corpus"
TEXTS = argparse.Namespace(texts=True, script=None, language=None, lexicon=None, literal=False)
"""The manifest's, each in its own language."""
PEOPLE = "human"
"""The labels of people were made by an aligner, those of synthesizers tell when they spoke."""
MEDIAN, MEAN, WITHIN, FAR = 0.015, 0.02, 0.05, 0.05
"""The median and the mean error of a boundary, s; how far from it few may be, s; and how few."""
PAUSE = 0.03
"""Seconds of silence that are a pause."""
MISSED = 0.03
"""Of the lines that are said as they are written, those of which a word is left out on purpose."""
REFUSED = 0.02
A_SECOND = 100
"""Frames of a line whose text is judged."""
ALIKE = 25
"""Letters by which a wrong text may be longer or shorter than the right one."""
N_WRONG = 5
"""Wrong texts for each line."""
REAL_TIME = 300
HOUR = 3600
MOST_MB = 100


@dataclass(frozen=True, eq=False)
class Line:
    """A line of the corpus: its evidence, and what is said."""

    utterance: LabelledUtterance
    evidence: Evidence
    words: Sequence[ScriptWord]


def figures() -> list[Figure]:
    """Measure on the corpus of the tests, with the default preset."""
    lines = _lines()
    measured = [_errors(line) for line in lines if PEOPLE not in line.utterance.corpus]
    errors = np.abs(np.concatenate([boundaries for boundaries, _ in measured]))
    ends = float(np.median(np.abs(np.concatenate([before_pauses for _, before_pauses in measured]))))
    median, mean, far = float(np.median(errors)), float(np.mean(errors)), float(np.mean(errors > WITHIN))
    long = [line for line in lines if len(line.evidence) >= A_SECOND]
    right = [_aligned(line, line.words) for line in long]
    refused = float(np.mean([aligner.fit.is_wrong for aligner, _ in right]))
    missed = float(np.mean([bool(found.skipped) for aligner, found in right if not aligner.fit.is_wrong]))
    accepted = float(np.mean([not _aligned(*pair)[0].fit.is_wrong for pair in _wrong_pairs(long)]))
    return [
        Figure("word boundaries, median", f"{1000 * median:.1f} ms", f"{1000 * MEDIAN:g} ms", median / MEDIAN, 1),
        Figure("word boundaries, mean", f"{1000 * mean:.1f} ms", f"{1000 * MEAN:g} ms", mean / MEAN, 1),
        Figure("ends before pauses, median", f"{1000 * ends:.1f} ms", f"{1000 * MEDIAN:g} ms", ends / MEDIAN, 1),
        _share(f"word boundaries off by more than {1000 * WITHIN:g} ms", far, FAR),
        _share("right texts refused", refused, REFUSED),
        _share("lines with a word falsely told to be left out", missed, MISSED),
        _share("wrong texts accepted", accepted, REFUSED),
        *_hour(lines),
    ]


def _share(name: str, found: float, most: float) -> Figure:
    return Figure(name, f"{100 * found:.1f} %", f"{100 * most:g} %", found / most, 1.0)


def _lines() -> list[Line]:
    utterances, preset = read_corpus(CORPUS), load_preset(DEFAULT_PRESET)
    words_for = words_to_score(TEXTS, utterances)
    assert words_for is not None
    lines = []
    for utterance in utterances:
        with SoundReader(utterance.path) as reader:
            evidence = joined([evidence_of(part) for part in analyse_file(reader, preset)])
            n_frames = math.ceil(reader.duration / FRAME_PERIOD - 0.5)
        words = words_for(utterance)
        if words:
            lines.append(Line(utterance, evidence.part(slice(n_frames)), words))
    return lines


def _aligned(line: Line, words: Sequence[ScriptWord]) -> tuple[Aligner, Utterance]:
    aligner = Aligner(words, len(line.evidence))
    aligner.push(line.evidence)
    return aligner, aligner.finish(len(line.evidence) * FRAME_PERIOD)


def _errors(line: Line) -> tuple[Float64Array, Float64Array]:
    """Return by how much the boundaries of words are found late, s, where the synthesizer said what the voice would.

    Those of words that end before a pause are listed by themselves, too.
    """
    found = [(phone, w) for w, word in enumerate(_aligned(line, line.words)[1].words) for phone in word.phones]
    labels = [label for label in line.utterance.labels if label.phoneme is not Phoneme.SILENCE]
    numbers = [-1, *(w for _, w in found), -1]
    starts, ends = ([a != b for a, b in pairs] for pairs in (pairwise(numbers[:-1]), pairwise(numbers[1:])))
    errors: list[float] = []
    before_pauses: list[float] = []
    silences = [label for label in line.utterance.labels if label.phoneme is Phoneme.SILENCE]
    pauses = {round(label.start, 3) for label in silences if label.end - label.start > PAUSE}
    for k, label in _matched([phone for phone, _ in found], labels):
        errors += [found[k][0].start - label.start] * starts[k] + [found[k][0].end - label.end] * ends[k]
        if ends[k] and round(label.end, 3) in pauses:
            before_pauses.append(found[k][0].end - label.end)
    return np.array(errors, np.float64), np.array(before_pauses, np.float64)


def _matched(phones: Sequence[Phone], labels: Sequence[Label]) -> list[tuple[int, Label]]:
    """Return phones, by number, with the labels that stand for the same sounds."""
    classes = [phone.phoneme for phone in phones], [label.phoneme for label in labels]
    blocks = SequenceMatcher(None, *classes, autojunk=False).get_matching_blocks()
    return [(block.a + i, labels[block.b + i]) for block in blocks for i in range(block.size)]


def _wrong_pairs(lines: Sequence[Line]) -> list[tuple[Line, Sequence[ScriptWord]]]:
    """Return lines with the words of others, of the same language and about as long."""
    choice = random.Random(0)
    pairs = []
    for line in lines:
        said = line.utterance
        others = [
            other.words
            for other in lines
            if other.utterance.language == said.language
            and other.utterance.text != said.text
            and abs(len(other.utterance.text) - len(said.text)) <= ALIKE
        ]
        pairs += [(line, choice.choice(others)) for _ in range(N_WRONG) if others]
    return pairs


def _hour(lines: Sequence[Line]) -> list[Figure]:
    """Align an hour of lines, one after the other, with all their words as one script."""
    choice, order, n_frames = random.Random(1), [], 0
    while n_frames * FRAME_PERIOD < HOUR:
        order.append(choice.choice(lines))
        n_frames += len(order[-1].evidence)
    words = [word for line in order for word in line.words]
    gc.collect()
    before = most = resident_megabytes()
    began = time.process_time()
    aligner = Aligner(words, n_frames)
    for line in order:
        aligner.push(line.evidence)
        most = max(most, resident_megabytes())
    aligner.finish(n_frames * FRAME_PERIOD)
    took = time.process_time() - began
    ratio = took / (n_frames * FRAME_PERIOD / REAL_TIME)
    return [
        Figure("aligning an hour", shown([took]), f"1/{REAL_TIME} of it", ratio, 1.0, absolute=Absolute.WORK),
        Figure("the same, memory", f"{most - before:.0f} MB", f"{MOST_MB} MB", (most - before) / MOST_MB, 1.0),
    ]
