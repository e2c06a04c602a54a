"""The examples of all recordings, each varied several times, made and kept in files.

They are too many for the memory of a small machine, and several trainings share them.
"""

import json
import os
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from phonemeengine.arrays import Float32Array, Int64Array
from phonemeengine.calibration import fine_tuning
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.dsp.mel import N_BANDS
from phonemeengine.encoder.weights import N_MELS
from phonemeengine.errors import CorpusError, EngineError
from phonemeengine.execution import end_with_parent
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import atomic_write, reason_of
from phonemetraining.augmentation import Augmentation, augment, draw_augmentation

# Soft labels: the probabilities of a teacher that knows many more voices, kept on disk.

SOFT_LABELS, HEAD = "soft_labels.npz", "head.npz"
"""Files of the teacher's probabilities, and of those by a head that learned from all."""

SoftLabels = Mapping[str, NDArray[np.float16]]
"""By the key of the recording: shape (n_frames, 26), frames of 10 ms."""


def key_of(utterance: LabelledUtterance) -> str:
    """Return the name of a recording among the soft labels: corpus/speaker/file, without the file's ending."""
    return f"{utterance.voice}/{utterance.path.stem}"


def save_soft_labels(soft_labels: SoftLabels, path: Path) -> None:
    """Write soft labels into an ``.npz``."""
    np.savez(path, allow_pickle=False, **soft_labels)


def load_soft_labels(path: Path) -> dict[str, NDArray[np.float16]]:
    """Read soft labels.

    Raises
    ------
    CorpusError : the file cannot be read, or holds other arrays.
    """
    try:
        with np.load(path, allow_pickle=False) as file:
            found = {name: file[name] for name in file.files}
    except (OSError, ValueError, EOFError) as error:
        reason = reason_of(error) if isinstance(error, OSError) else "it is damaged"
        raise CorpusError(
            f"{path.name}: the soft labels cannot be read ({reason}); have the teacher recognise again"
        ) from error
    if any(a.ndim != 2 or a.shape[1] != fine_tuning.N_SOFT_LABELS or a.dtype != np.float16 for a in found.values()):
        raise CorpusError(f"{path.name}: these are no soft labels of this version; have the teacher recognise again")
    return found


ARRAYS: dict[str, tuple[type[np.generic], tuple[int, ...]]] = {
    "log_powers": (np.float16, (N_BANDS,)),
    "mels": (np.float16, (N_MELS,)),
    "phonemes": (np.uint8, ()),
    "visemes": (np.uint8, ()),
    "certainties": (np.float16, ()),
    "soft_labels": (np.float16, (fine_tuning.N_SOFT_LABELS,)),
}
"""The arrays of an example, each in a file of its own: kind, and shape of a frame. The bands of the small network
and those of Whisper come from the same windows."""
INDEX = "index.json"


@dataclass(frozen=True, eq=False)
class RecordingExample(fine_tuning.TrainingExample):
    """One variation of one recording, for all networks.

    Attributes
    ----------
    mels : float16, shape (n_frames, 80): base-10 logarithms of the powers in Whisper's bands.
    """

    mels: NDArray[np.float16]


@dataclass(frozen=True)
class _Entry:
    """Where the variations of a recording lie: in order of the index, and how many frames each has."""

    voice: str
    lengths: tuple[int, ...]


def write_examples(
    folder: Path,
    utterances: Sequence[LabelledUtterance],
    n_variations: int,
    seed: int,
    soft_labels: SoftLabels | None = None,
    progress: Callable[[int], object] = lambda _n: None,
) -> None:
    """Make all examples and write them into a folder, last of all its index; `progress` is called for each recording.

    Raises
    ------
    EngineError : a sound cannot be read.
    """
    made = examples_of(utterances, n_variations, seed, soft_labels)

    def counted() -> Iterator[tuple[str, Sequence[RecordingExample]]]:
        for utterance, examples in zip(utterances, made, strict=True):
            yield utterance.voice, examples
            progress(1)

    store(folder, counted())


def store(folder: Path, recordings: Iterable[tuple[str, Sequence[RecordingExample]]]) -> None:
    """Write the variations of recordings, each with the name of its speaker, into a folder, last of all its index."""
    entries = []
    with ExitStack() as stack:
        files = {name: stack.enter_context((folder / name).open("wb")) for name in ARRAYS}
        for voice, examples in recordings:
            for example in examples:
                for name, file in files.items():
                    file.write(getattr(example, name).tobytes())
            entries.append(_Entry(voice, tuple(len(example) for example in examples)))
    with atomic_write(folder / INDEX) as index:
        index.write(json.dumps([asdict(entry) for entry in entries]).encode())


STRETCHED, RATES = 0.5, (0.85, 1.18)
"""Share of the excerpts that are slowed down or sped up by leaving out or repeating frames, and by how much."""


class Examples:
    """The examples in a folder, of some speakers.

    Parameters
    ----------
    folder : as `write_examples` filled it.
    weights : how often the speech of each speaker is gone through in an epoch; below 1, only that share of it.
    left_out : speakers who do not take part.
    device : where the arrays lie; on ``cpu`` they stay on the disk.
    """

    def __init__(
        self, folder: Path, weights: Mapping[str, float], left_out: Collection[str] = (), device: str = "cpu"
    ) -> None:
        self.device = device
        # "c": PyTorch wants arrays that can be written to; nothing is
        self._arrays = {
            name: torch.from_numpy(np.memmap(folder / name, kind, "c").reshape(-1, *shape)).to(device)
            for name, (kind, shape) in ARRAYS.items()
        }
        self._weights = weights
        self._recordings: dict[str, list[list[tuple[int, int]]]] = {}
        end = 0
        for entry in json.loads((folder / INDEX).read_text(encoding="utf-8")):
            ends = end + np.cumsum([0, *entry["lengths"]])
            end = int(ends[-1])
            if entry["voice"] not in left_out:
                spans = list(zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True))
                self._recordings.setdefault(entry["voice"], []).append(spans)

    def epoch(self, n_frames: int, generator: np.random.Generator) -> Int64Array:
        """Return the frames of excerpts that go through everything once, shape (n_excerpts, n_frames).

        Each is of joined recordings of one speaker; all speakers are mixed.
        """
        found = []
        for voice, recordings in self._recordings.items():
            weight = self._weights.get(voice, 1.0)
            for _ in range(int(weight) + (generator.random() < weight % 1)):
                drawn = [recordings[k] for k in generator.permutation(len(recordings))]
                spans = [spans[generator.integers(len(spans))] for spans in drawn]
                frames = np.concatenate([np.arange(*span) for span in spans])
                found += list(_stretches(frames, n_frames, generator))
        if not found:
            return np.zeros((0, n_frames), np.int64)
        return generator.permutation(np.stack(found))

    def batch(self, frames: Int64Array, *names: str) -> dict[str, Tensor]:
        """Return arrays of some frames, shape (*frames.shape, ...)."""
        places = torch.from_numpy(frames).to(self.device)
        return {name: self._arrays[name][places] for name in names}

    def importance(self) -> tuple[Tensor, Tensor]:
        """Return how much a frame of each phoneme, and of each viseme, counts: rare ones more."""
        spans = [spans[0] for recordings in self._recordings.values() for spans in recordings]
        frames = torch.cat([torch.arange(*span) for span in spans]).to(self.device)
        phonemes, visemes = (
            torch.bincount(self._arrays[name][frames].long(), minlength=256)[: len(classes)].float() + 1
            for name, classes in (("phonemes", Phoneme), ("visemes", Viseme))
        )
        weights = _rarities(phonemes)
        weights[Phoneme.UNIDENTIFIED] *= 0.8  # what lies between the phonemes counts a little less
        return weights, _rarities(visemes)

    def anchors(self, name: str, n: int, n_frames: int, seed: int) -> Float32Array:
        """Draw excerpts of an array of the speech as it is, of voices that count more, more often.

        Parameters
        ----------
        name : of the array, ``log_powers`` or ``mels``.
        n, n_frames : how many, and frames of each.
        seed : of chance.

        Returns
        -------
        float32, shape (n, n_frames, n_bands).
        """
        generator = np.random.default_rng(seed)
        long = [[s[0] for s in r if s[0][1] - s[0][0] >= n_frames] for r in self._recordings.values()]
        weights = np.array(
            [self._weights.get(v, 1.0) * bool(some) for v, some in zip(self._recordings, long, strict=True)]
        )
        if not weights.any():
            return np.zeros((0, n_frames, self._arrays[name].shape[1]), np.float32)
        found = []
        for k in generator.choice(len(long), n, p=weights / weights.sum()):
            first, end = long[k][generator.integers(len(long[k]))]
            begin = int(generator.integers(first, end - n_frames + 1))
            found.append(self._arrays[name][begin : begin + n_frames].float().cpu().numpy())
        return np.stack(found)


RARE = 0.35
"""How much more the frames of a rare sound count: the power of its share; 1 would make all sounds count alike."""


def _rarities(counts: Tensor) -> Tensor:
    weights = (counts / counts.sum()) ** -RARE
    return weights / weights.mean()


def _stretches(frames: Int64Array, n_frames: int, generator: np.random.Generator) -> Iterator[Int64Array]:
    """Cut joined recordings into excerpts of some frames, some of them slower or faster."""
    place = int(generator.integers(0, n_frames // 2))
    while True:
        rate = generator.uniform(*RATES) if generator.random() < STRETCHED else 1.0
        chosen = place + (np.arange(n_frames) * rate).astype(np.int64)
        if chosen[-1] >= len(frames):
            return
        yield frames[chosen]
        place = int(chosen[-1]) + 1


def examples_of(
    utterances: Sequence[LabelledUtterance], n_variations: int, seed: int, soft_labels: SoftLabels | None = None
) -> Iterator[tuple[RecordingExample, ...]]:
    """Make the examples of all utterances: each as it is, and `n_variations` others; in as many processes as cores.

    Raises
    ------
    EngineError : a sound cannot be read.
    """
    with ProcessPoolExecutor(os.cpu_count(), initializer=end_with_parent) as pool:
        known = soft_labels or {}
        tasks = ((utterance, n_variations, seed, known.get(key_of(utterance))) for utterance in utterances)
        for made in pool.map(_examples, tasks, chunksize=8):
            if isinstance(made, EngineError):
                pool.shutdown(wait=False, cancel_futures=True)
                raise made
            yield made


def _examples(
    task: tuple[LabelledUtterance, int, int, NDArray[np.float16] | None],
) -> tuple[RecordingExample, ...] | EngineError:
    """Make the examples of one utterance; an error travels back as a value, since it must survive the way."""
    utterance, n_variations, seed, soft = task
    generator = np.random.default_rng([seed, *utterance.path.name.encode()])
    try:
        samples = fine_tuning.sound_of(utterance)
    except EngineError as error:
        return EngineError(str(error))
    variations = [Augmentation(), *(draw_augmentation(generator) for _ in range(n_variations))]
    return tuple(_augmented_example(samples, utterance.labels, v, generator, soft) for v in variations)


def _augmented_example(
    samples: Float32Array,
    labels: tuple[Label, ...],
    variation: Augmentation,
    generator: np.random.Generator,
    soft: NDArray[np.float16] | None,
) -> RecordingExample:
    moved = tuple(
        replace(label, start=label.start / variation.rate, end=label.end / variation.rate) for label in labels
    )
    if soft is not None:
        frames = (np.arange(int(len(soft) / variation.rate)) + 0.5) * variation.rate
        soft = soft[np.minimum(frames.astype(int), len(soft) - 1)]
    varied, warp = augment(samples, variation, generator), round(variation.warp, 2)
    example = fine_tuning.example_of(varied, moved, warp, soft)
    known = {field.name: getattr(example, field.name) for field in fields(example)}
    return RecordingExample(
        **known, mels=fine_tuning.whisper_mels_of(varied, warp)[: len(example)].astype(np.float16)
    )
