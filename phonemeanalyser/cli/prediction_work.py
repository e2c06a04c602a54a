"""Labelled recordings that are recognised to be scored, on all cores or a cluster, with their words or without."""

import argparse
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import phonemeengine
from phonemeanalyser.cli.jobs import say_note
from phonemeengine.batch.work import Act, Job, Made, Outcome, Say, fingerprint_of
from phonemeengine.calibration.scores.added_noise import AddedNoise, NoiseAdder
from phonemeengine.calibration.scores.corpus import frame_labels_of
from phonemeengine.calibration.scores.evaluation import Predictions, predict
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Progress
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.storage.files import atomic_write, printable_name, read_npz, reason_of
from phonemeengine.text.espeak import languages
from phonemeengine.text.script import load_script

LARGEST = 1 << 30
"""Bytes of the answers in one recording that are read."""


@dataclass(frozen=True)
class WordsToScore:
    """The words of labelled recordings.

    Attributes
    ----------
    texts : what is said, by the sound's file.
    language : of the texts; None for the manifest's.
    lexicon : goes before the language's voice.
    tags : the languages that there are.
    literal : whether the notation of scripts is words, too.
    """

    texts: Mapping[Path, str]
    language: str | None
    lexicon: phonemeengine.Lexicon | None
    tags: frozenset[str]
    literal: bool = False

    def __call__(self, utterance: phonemeengine.LabelledUtterance) -> Sequence[phonemeengine.ScriptWord] | None:
        """Return the words of a recording, and say at once what cannot be used; None where they are not known."""
        return self.of(utterance, say_note)

    def of(self, utterance: phonemeengine.LabelledUtterance, say: Say) -> Sequence[phonemeengine.ScriptWord] | None:
        """Return the words of a recording, and say what cannot be used; None where they are not known."""
        if utterance.path not in self.texts:
            return None
        try:
            text, language = self.texts[utterance.path], self._tag_of(utterance)
            return phonemeengine.words_of(text, language, self.lexicon, literal=self.literal)
        except phonemeengine.VoiceError:
            raise
        except phonemeengine.TextError as error:
            say(printable_name(utterance.path), f"recognised without its text: {error}")
            return None

    def known_of(self, utterance: phonemeengine.LabelledUtterance) -> str:
        """Return what tells whether something else is said in a recording than before."""
        text = self.texts.get(utterance.path)
        return fingerprint_of(text, self._tag_of(utterance), self.lexicon, self.literal)

    def _tag_of(self, utterance: phonemeengine.LabelledUtterance) -> str:
        return self.language or _tag_of(utterance.language, self.tags)


def words_to_score(
    options: argparse.Namespace, utterances: Sequence[phonemeengine.LabelledUtterance]
) -> WordsToScore | None:
    """Return what gives the words of labelled recordings; None where the command line asks for none.

    Raises
    ------
    EngineError : a script or the lexicon cannot be read, or says nothing about the sounds.
    """
    if not (options.texts or options.script):
        return None
    texts = {utterance.path: utterance.text for utterance in utterances if utterance.text}
    if options.script is not None:
        texts = dict(load_script(options.script).texts_of([utterance.path for utterance in utterances])[0])
    if not texts:
        raise phonemeengine.EngineError(
            "there is no text of what is said; add a column text to the manifest, or name a --script"
        )
    lexicon = None if options.lexicon is None else phonemeengine.load_lexicon(options.lexicon)
    tags = frozenset(language.tag for language in languages())
    literal = options.literal or options.script is None  # a manifest tells what is said, and is no script
    return WordsToScore(texts, options.language, lexicon, tags, literal)


def _tag_of(language: str, known: Collection[str]) -> str:
    """Return a manifest's language, such as de-DE, as a voice has it."""
    whole = language.lower()
    return next((tag for tag in (whole, whole.partition("-")[0]) if tag in known), whole)


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

    preset: phonemeengine.Preset
    utterances: tuple[phonemeengine.LabelledUtterance, ...]
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
        if isinstance(outcome.made.value, phonemeengine.EngineError):
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
        except phonemeengine.AudioError:
            raise
        except phonemeengine.EngineError as error:
            if job.target is not None:
                raise
            return Made(value=error)
        progress(1.0)
        duration = len(found.phonemes) * FRAME_PERIOD
        if job.target is None:
            return Made(duration, utterance.language, value=found)
        self._write(found, job.target)
        return Made(duration, utterance.language)

    def _name_of(self, utterance: phonemeengine.LabelledUtterance) -> str:
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
            raise phonemeengine.AudioError(words) from error

    def _read(self, utterance: phonemeengine.LabelledUtterance, path: Path) -> Predictions:
        try:
            arrays = read_npz(path, LARGEST)
            labels = frame_labels_of(utterance.labels)
            return Predictions(
                utterance,
                labels,
                arrays["phonemes"],
                arrays["intensities"],
                arrays.get("visemes"),
                arrays.get("confidences"),
            )
        except (OSError, ValueError, KeyError) as error:
            raise CorpusError(f"{printable_name(path)}: these answers cannot be read; remove the file") from error
