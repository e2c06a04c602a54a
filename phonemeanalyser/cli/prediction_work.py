"""Labelled recordings that are recognised to be scored, on all cores or a cluster."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from phonemeanalyser.cli.scripts import WordsToScore
from phonemeengine import AudioError, EngineError, LabelledUtterance, Preset
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.work import Act, Job, Made, Outcome, Say
from phonemeengine.calibration.scores.added_noise import AddedNoise, NoiseAdder
from phonemeengine.calibration.scores.corpus import frame_labels_of
from phonemeengine.calibration.scores.evaluation import Predictions, predict
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Progress
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.storage.files import atomic_write, printable_name, reason_of
from phonemeengine.storage.npz import read_npz

LARGEST = 1 << 30
"""Bytes of the answers in one recording that are read."""


@dataclass(frozen=True)
class PredictionWork:
    """Recognises labelled recordings; answers are written where a job has a target, and else given back.

    Attributes
    ----------
    preset : what is recognised with.
    utterances : the recordings, by the numbers of the jobs.
    delay : seconds by which answers are taken to come late.
    noise : what is added to each recording.
    words : gives the words of a recording, which is then aligned with them.
    """

    preset: Preset
    utterances: tuple[LabelledUtterance, ...]
    delay: float
    noise: AddedNoise | None
    words: WordsToScore | None

    def jobs(self, folder: Path | None) -> list[Job]:
        """Return a job for each recording; its answers go into a folder, or nowhere."""
        return [Job(u.path, folder and folder / self._name_of(u), k) for k, u in enumerate(self.utterances)]

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        corpus = self.utterances if self.noise is not None else ()  # whose others babble
        return fingerprint_of("score", self.preset, self.delay, self.noise, corpus)

    def known_of(self, job: Job) -> str:
        """Return what is said in a recording."""
        utterance = self.utterances[job.number]
        text = None if self.words is None else self.words.known_of(utterance)
        return fingerprint_of(utterance.labels, utterance.channel, text)

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Make the noise, and give what recognises one recording."""
        noise = None if self.noise is None else NoiseAdder(self.noise, self.utterances)
        yield lambda job, say, progress: self._predict(job, noise, say, progress)

    def predictions_of(self, outcome: Outcome) -> Predictions:
        """Return what was answered in a recording.

        Raises
        ------
        EngineError : that of the work, where it was no fault of the sound; or its answers cannot be read again.
        """
        if isinstance(outcome.made.value, EngineError):
            raise outcome.made.value
        if outcome.job.target is None:
            found: Predictions = outcome.made.value
            return found
        return self._read(self.utterances[outcome.job.number], outcome.job.target)

    def _predict(self, job: Job, noise: NoiseAdder | None, say: Say, progress: Progress) -> Made:
        utterance = self.utterances[job.number]
        words = None if self.words is None else partial(self.words.of, say=say)
        try:
            found = predict(utterance, self.preset, delay=self.delay, noise=noise, words=words)
        except AudioError:
            raise
        except EngineError as error:
            if job.target is not None:
                raise
            return Made(value=error)
        progress(1.0)
        duration = len(found.phonemes) * FRAME_PERIOD
        if job.target is None:
            return Made(duration, utterance.language, value=found)
        self._write(found, job.target)
        return Made(duration, utterance.language)

    def _name_of(self, utterance: LabelledUtterance) -> str:
        about = str(utterance.path), utterance.channel, utterance.voice
        return f"{utterance.path.stem}-{fingerprint_of(*about)[:12]}.npz"

    def _write(self, found: Predictions, target: Path) -> None:
        names = ("phonemes", "intensities", "visemes", "confidences")
        arrays: dict[str, Any] = {name: a for name in names if (a := getattr(found, name)) is not None}
        try:
            with atomic_write(target) as file:
                np.savez(file, **arrays)
        except OSError as error:
            words = f"{printable_name(target)}: cannot be written ({reason_of(error)}); choose another folder"
            raise AudioError(words) from error

    def _read(self, utterance: LabelledUtterance, path: Path) -> Predictions:
        try:
            arrays = read_npz(path, LARGEST)
            labels = frame_labels_of(utterance.labels)
            return Predictions(
                utterance, labels, arrays["phonemes"], arrays["intensities"], arrays.get("visemes"),
                arrays.get("confidences"),
            )  # fmt: skip
        except (OSError, ValueError, KeyError) as error:
            raise CorpusError(f"{printable_name(path)}: these answers cannot be read; remove the file") from error
