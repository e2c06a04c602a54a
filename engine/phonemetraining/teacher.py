"""The teacher: heads on a speech encoder that has heard everybody, and what they say of all recordings.

Each recording is heard by a head that was trained without its speaker, so that it says what it hears and not what it
was told.
"""

from collections.abc import Callable, Collection, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from os import cpu_count
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Int64Array
from phonemeengine.calibration.fine_tuning import Optimiser
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.calibration.training_examples import certainties_of
from phonemeengine.encoder.head import CONTEXT, HALVES, N_OUTPUTS, EncoderHead, load_head, save_head, softmax
from phonemeengine.encoder.whisper import MODEL_FILE, SpeechEncoder, WhisperEncoder
from phonemeengine.execution import end_with_parent
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import atomic_write
from phonemetraining.examples import (
    HEAD,
    SOFT_LABELS,
    key_of,
    load_soft_labels,
    save_soft_labels,
)
from phonemetraining.trainable_network import targets_of
from phonemetraining.validation import folds_of

COMPONENTS, HIDDEN = 200, 384
EPOCHS, BATCH, RATE, DROPOUT = 4, 2048, 2e-3, 0.2
GROUPS = 4
"""Of speakers, each left out of one head."""
SAMPLED = 20
"""States of each recording from which the principal components are taken."""
LEAST_PRIOR = 1e-3
"""Added to the share of each class."""
Encoded = dict[str, Path]
"""By the key of the recording, the file with its states."""
OnShare = Callable[[float], object]


def encode_all(utterances: Sequence[LabelledUtterance], folder: Path, whisper: Path, on_progress: OnShare) -> Encoded:
    """Let the encoder hear all recordings; what lies in the folder already is not heard again.

    Parameters
    ----------
    utterances : the recordings.
    folder : for the states, a file each.
    whisper : the folder of the encoder's model.
    on_progress : is told of the share that is done.

    Raises
    ------
    ModelError : the encoder cannot be used.
    AudioError : a sound cannot be read.
    """
    files = {key_of(u): folder / f"{key_of(u)}.npy" for u in utterances}
    missing = [u for u in utterances if not files[key_of(u)].is_file()]
    if missing:
        WhisperEncoder(whisper / MODEL_FILE)  # says at once what is wrong with it
        with ProcessPoolExecutor(cpu_count(), get_context("spawn"), _open_encoder, (whisper,)) as pool:
            tasks = pool.map(_encode, missing, [files[key_of(u)] for u in missing], chunksize=4)
            for k, _ in enumerate(tasks, 1):
                on_progress(k / len(missing))
    return files


_encoder: SpeechEncoder


def _open_encoder(whisper: Path) -> None:
    global _encoder  # noqa: PLW0603 - a process opens it once, at its beginning
    end_with_parent()
    _encoder = WhisperEncoder(whisper / MODEL_FILE, n_threads=1)


def _encode(utterance: LabelledUtterance, path: Path) -> None:
    with utterance.opened() as reader:
        states = _encoder.encode(reader.read_mono())
    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_write(path) as file:
        np.save(file, states)


@dataclass(frozen=True)
class Lesson:
    """What heads are trained on.

    Attributes
    ----------
    components : of the states of all recordings, float16, the first and the last row of each some times more.
    places : rows of the states that are labelled, shape (n,).
    phonemes, visemes, certainties : of both halves of these, shape (n, 2).
    voices : whose they are, shape (n,): numbers of the speakers.
    names : of the speakers.
    weights : how much each speaker counts, shape (n_speakers,).
    """

    components: NDArray[np.float16]
    places: Int64Array
    phonemes: NDArray[np.uint8]
    visemes: NDArray[np.uint8]
    certainties: Float32Array
    voices: Int64Array
    names: tuple[str, ...]
    weights: Float32Array


def projection_of(encoded: Encoded, seed: int) -> tuple[Float32Array, Float32Array]:
    """Return the mean of the states, shape (512,), and their principal components, scaled, shape (512, 200)."""
    generator = np.random.default_rng(seed)
    drawn = []
    for path in encoded.values():
        states = np.load(path, mmap_mode="r")
        if len(states):
            drawn.append(states[np.sort(generator.integers(len(states), size=SAMPLED))].astype(np.float32))
    sample = np.concatenate(drawn)
    mean = sample.mean(axis=0)
    spreads, directions = np.linalg.eigh(np.cov((sample - mean).T))
    chosen = np.argsort(spreads)[::-1][:COMPONENTS]
    scaled = directions[:, chosen] / np.sqrt(np.maximum(spreads[chosen], 1e-9))
    return mean, np.asarray(scaled, np.float32)


def lesson_of(
    utterances: Sequence[LabelledUtterance],
    encoded: Encoded,
    weights: dict[str, float],
    projection: tuple[Float32Array, Float32Array],
) -> Lesson:
    """Put together what heads are trained on: the labelled recordings."""
    names = tuple(sorted(weights))
    numbers = {name: k for k, name in enumerate(names)}
    reach = max(CONTEXT)
    parts: list[tuple[NDArray[np.generic], ...]] = []
    components, end = [], reach
    for utterance in utterances:
        if not utterance.labels:
            continue
        states = np.load(encoded[key_of(utterance)])
        frames = frame_labels_of(utterance.labels)
        n = min(len(states), len(frames.phonemes) // HALVES)
        if n == 0:
            continue
        found = ((states.astype(np.float32) - projection[0]) @ projection[1]).astype(np.float16)
        components.append(np.pad(found, ((reach, reach), (0, 0)), mode="edge"))
        told = (frames.phonemes, frames.visemes, certainties_of(utterance.labels, HALVES * n))
        halves = [column[: HALVES * n].reshape(n, HALVES) for column in told]
        parts.append((end + np.arange(n), *halves, np.full(n, numbers[utterance.voice])))
        end += len(found) + 2 * reach
    places, phonemes, visemes, certainties, voices = (np.concatenate(column) for column in zip(*parts, strict=True))
    counts = np.array([weights[name] for name in names], np.float32)
    return Lesson(
        np.concatenate(components),
        places.astype(np.int64),
        phonemes.astype(np.uint8),
        visemes.astype(np.uint8),
        certainties.astype(np.float32),
        voices.astype(np.int64),
        names,
        counts,
    )


def train_head(
    lesson: Lesson,
    left_out: Collection[str],
    projection: tuple[Float32Array, Float32Array],
    seed: int,
    on_progress: OnShare = lambda _share: None,
) -> EncoderHead:
    """Train a head on all speakers but some."""
    generator = np.random.default_rng(seed)
    strange = np.array([name in left_out for name in lesson.names])
    chosen = np.flatnonzero(~strange[lesson.voices])
    n_in = len(CONTEXT) * COMPONENTS
    values = [
        generator.normal(0, np.sqrt(2 / n_in), (n_in, HIDDEN)).astype(np.float32),
        np.zeros(HIDDEN, np.float32),
        generator.normal(0, np.sqrt(1 / HIDDEN), (HIDDEN, HALVES * N_OUTPUTS)).astype(np.float32),
        np.zeros(HALVES * N_OUTPUTS, np.float32),
    ]
    n_batches = max(1, len(chosen) // BATCH)
    n_steps = EPOCHS * n_batches
    optimiser = Optimiser(values, n_steps, RATE)
    context = np.array(CONTEXT)
    for step in range(n_steps):
        if step % n_batches == 0:
            order = generator.permutation(chosen)
        batch = order[step % n_batches * BATCH :][:BATCH]
        inputs = lesson.components[lesson.places[batch, np.newaxis] + context].reshape(len(batch), -1)
        optimiser.step(_gradients(values, inputs.astype(np.float32), lesson, batch, generator))
        on_progress((step + 1) / n_steps)
    return EncoderHead(*(*projection, *values, _priors_of(lesson, chosen)))


def _priors_of(lesson: Lesson, chosen: Int64Array) -> Float32Array:
    """Return the shares of the phonemes, and of the visemes, in what is learned from, shape (26,)."""
    counts = lesson.certainties[chosen] * lesson.weights[lesson.voices[chosen], np.newaxis]
    shares = []
    for codes, n_classes in ((lesson.phonemes, len(Phoneme)), (lesson.visemes, N_OUTPUTS - len(Phoneme))):
        found = np.bincount(codes[chosen].ravel(), counts.ravel(), 256)[:n_classes] + LEAST_PRIOR * counts.sum()
        shares.append(found / found.sum())
    return np.concatenate(shares).astype(np.float32)


def _gradients(
    values: list[Float32Array],
    inputs: Float32Array,
    lesson: Lesson,
    batch: Int64Array,
    generator: np.random.Generator,
) -> list[Float32Array]:
    hidden_weights, hidden_bias, weights, bias = values
    kept = (generator.random((len(batch), HIDDEN), np.float32) >= DROPOUT) / np.float32(1 - DROPOUT)
    hidden = np.maximum(inputs @ hidden_weights + hidden_bias, 0) * kept
    sums = (hidden @ weights + bias).reshape(len(batch), HALVES, N_OUTPUTS)
    counts = lesson.certainties[batch] * lesson.weights[lesson.voices[batch], np.newaxis]
    errors = np.empty_like(sums)
    n, first = len(Phoneme), 0
    for codes, n_classes in ((lesson.phonemes, n), (lesson.visemes, N_OUTPUTS - n)):
        part = slice(first, first + n_classes)
        nothing = np.zeros((len(batch), HALVES, n_classes), np.float32)
        wanted, counted = targets_of(codes[batch], nothing, np.ones(n_classes, np.float32), counts)
        share = counted[..., np.newaxis] / max(float(counted.sum()), 1e-9)
        errors[..., part] = share * (softmax(sums[..., part]) - wanted)
        first += n_classes
    back = errors.reshape(len(batch), -1)
    inner = (back @ weights.T) * kept * (hidden > 0)
    return [inputs.T @ inner, inner.sum(axis=0), hidden.T @ back, back.sum(axis=0)]


def teach(
    utterances: Sequence[LabelledUtterance],
    encoded: Encoded,
    weights: dict[str, float],
    seed: int,
    folder: Path,
    on_progress: OnShare,
) -> tuple[dict[str, NDArray[np.float16]], EncoderHead]:
    """Return what heads hear in all recordings that did not hear their speakers before, and a head that heard all.

    Parameters
    ----------
    utterances : all recordings, labelled or not.
    encoded : the files with their states.
    weights : how much each speaker counts, by name.
    seed : of all chance.
    folder : for the results; what lies there already is taken.
    on_progress : is told of the share that is done.
    """
    heard, head_file = folder / SOFT_LABELS, folder / HEAD
    if not (heard.is_file() and head_file.is_file()):
        projection = projection_of(encoded, seed)
        lesson = lesson_of(utterances, encoded, weights, projection)
        groups = folds_of(list(weights), GROUPS)
        soft_labels: dict[str, NDArray[np.float16]] = {}
        for k, group in enumerate((*groups, set[str]())):
            head = train_head(lesson, group, projection, seed, partial(_tell, on_progress, k))
            for key in (key_of(u) for u in utterances if u.voice in group):
                soft_labels[key] = head.probabilities(np.load(encoded[key])).astype(np.float16)
        save_soft_labels(soft_labels, heard)
        save_head(head, head_file)
    return load_soft_labels(heard), load_head(head_file)


def _tell(on_progress: OnShare, k: int, share: float) -> None:
    on_progress((k + share) / (GROUPS + 1))
