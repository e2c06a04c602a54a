"""The teacher: heads on a lower layer of a speech encoder, and what they recognise in recordings.

Each recording is recognised by a head that was trained without its speaker, so that no head repeats what it learned
by heart. What the heads recognise also moves the boundaries in the labels of people, which an aligner found; heads
that learn from the moved labels tell whether that helps.
"""

import tomllib
from collections.abc import Callable, Collection, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import nn

from phonemeengine.arrays import Float32Array, Int64Array
from phonemeengine.calibration.fine_tuning import N_SOFT_LABELS, certainties_of, share_of_rate
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.encoder.head import CONTEXT, HALVES, EncoderHead
from phonemeengine.encoder.whisper import MODEL_FILE, SpeechEncoder, WhisperEncoder
from phonemeengine.errors import CorpusError
from phonemeengine.execution import end_with_parent
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import atomic_write, read_text_file
from phonemetraining.examples import SoftLabels, key_of
from phonemetraining.networks import HeadNetwork
from phonemetraining.processes import in_processes
from phonemetraining.realignment import Round, realigned_by, round_of
from phonemetraining.training import cross_entropy, device_of_choice, reduced_precision

COMPONENTS, HIDDEN = 200, 384
EPOCHS, BATCH, RATE, DROPOUT = 6, 2048, 2e-3, 0.2
GROUPS = 4
"""Of speakers, each left out of one head."""
SAMPLED = 20
"""States of each recording from which the principal components are taken."""
LARGEST = 6e4
"""Components are cut off here, which float16 still holds: a few states of an excerpt are very large."""
LEAST_PRIOR = 1e-3
"""Added to the share of each class."""
ROUNDS = 2
"""Most rounds in which labels are moved."""
Encoded = Mapping[str, Path]
"""By the key of the recording, the file with its states."""
OnShare = Callable[[float], object]


def encode_all(utterances: Sequence[LabelledUtterance], folder: Path, whisper: Path, on_progress: OnShare) -> Encoded:
    """Encode all recordings; those whose states lie in the folder already are not encoded again.

    Parameters
    ----------
    utterances : the recordings.
    folder : for the states, a file each: float16, shape (n_states, 512), one each 20 ms.
    whisper : the folder of the encoder's model.
    on_progress : called with the share that is done.

    Raises
    ------
    ModelError : the encoder cannot be used.
    AudioError : a sound cannot be read.
    """
    files = {key_of(u): folder / f"{key_of(u)}.npy" for u in utterances}
    missing = [u for u in utterances if not files[key_of(u)].is_file()]
    if missing:
        WhisperEncoder(whisper / MODEL_FILE)  # says at once what is wrong with it
        columns = (missing, [files[key_of(u)] for u in missing])
        for k, _ in enumerate(in_processes(_encode, columns, _open_encoder, (whisper,)), 1):
            on_progress(k / len(missing))
    return files


_encoder: SpeechEncoder


def _open_encoder(whisper: Path) -> None:
    global _encoder  # noqa: PLW0603 - a process opens it once, as it begins
    end_with_parent()
    _encoder = WhisperEncoder(whisper / MODEL_FILE, n_threads=1)


def _encode(utterance: LabelledUtterance, path: Path) -> None:
    with utterance.opened() as reader:
        states = _encoder.encode(reader.read_mono())
    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_write(path) as file:
        np.save(file, states)


Projection = tuple[Float32Array, Float32Array]
"""The mean of the states, shape (512,), and their principal components, scaled to a spread of 1, shape (512, 200)."""


def projection_of(encoded: Encoded, seed: int) -> Projection:
    """Return the mean and the principal components of some states of all recordings."""
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


@dataclass(frozen=True)
class _Labelled:
    """What heads are trained on: the labelled states of all recordings.

    `components` are those of the states, the first and the last row of each recording some times more; `places` rows
    of them that are labelled, shape (n,); `phonemes`, `visemes` and `certainties` of both halves of these, shape
    (n, 2); `speakers` their numbers, shape (n,); `names` those of the speakers, and `weights` how much each counts.
    """

    components: torch.Tensor
    places: Int64Array
    phonemes: NDArray[np.uint8]
    visemes: NDArray[np.uint8]
    certainties: Float32Array
    speakers: Int64Array
    names: tuple[str, ...]
    weights: Float32Array

    @classmethod
    def of(
        cls,
        utterances: Sequence[LabelledUtterance],
        encoded: Encoded,
        weights: Mapping[str, float],
        projection: Projection,
    ) -> "_Labelled":
        names = tuple(sorted(weights))
        numbers = {name: k for k, name in enumerate(names)}
        reach = max(CONTEXT)
        parts: list[tuple[NDArray[Any], ...]] = []
        components, end = [], reach
        for utterance in utterances:
            states = np.load(encoded[key_of(utterance)])
            frames = frame_labels_of(utterance.labels)
            n = min(len(states), len(frames.phonemes) // HALVES)
            if n == 0:
                continue
            found = (states.astype(np.float32) - projection[0]) @ projection[1]
            found = np.clip(found, -LARGEST, LARGEST).astype(np.float16)
            components.append(np.pad(found, ((reach, reach), (0, 0)), mode="edge"))
            told = (frames.phonemes, frames.visemes, certainties_of(utterance.labels, HALVES * n))
            halves = [column[: HALVES * n].reshape(n, HALVES) for column in told]
            parts.append((end + np.arange(n), *halves, np.full(n, numbers[utterance.voice])))
            end += len(found) + 2 * reach
        places, phonemes, visemes, certainties, speakers = (np.concatenate(c) for c in zip(*parts, strict=True))
        counts = np.array([weights[name] for name in names], np.float32)
        joined = torch.from_numpy(np.concatenate(components)).to(device_of_choice())
        return cls(joined, places, phonemes, visemes, certainties, speakers, names, counts)

    def all_but(self, names: Collection[str]) -> Int64Array:
        """Return the numbers of the states of all other speakers."""
        strange = np.array([name in names for name in self.names])
        return np.flatnonzero(~strange[self.speakers])

    def around(self, states: Int64Array) -> torch.Tensor:
        """Return the components of some states and their context, shape (n, 13 x 200)."""
        rows = torch.from_numpy(self.places[states, np.newaxis] + np.array(CONTEXT)).to(self.components.device)
        return self.components[rows].flatten(1).float()

    def counts(self, states: Int64Array) -> Float32Array:
        """Return how much both halves of some states count, shape (n, 2)."""
        return self.certainties[states] * self.weights[self.speakers[states], np.newaxis]

    def answers(self, states: Int64Array) -> dict[str, torch.Tensor]:
        """Return what should be answered to some states, for `cross_entropy`."""
        arrays: dict[str, NDArray[Any]] = {
            "phonemes": self.phonemes[states],
            "visemes": self.visemes[states],
            "certainties": self.counts(states),
            "soft_labels": np.zeros((len(states), HALVES, N_SOFT_LABELS), np.float32),
        }
        return {name: torch.from_numpy(array).to(self.components.device) for name, array in arrays.items()}


def _train_head(
    labelled: _Labelled, left_out: Collection[str], projection: Projection, seed: int, on_progress: OnShare
) -> EncoderHead:
    """Train a head on all speakers but some."""
    torch.manual_seed(seed)
    generator, device = np.random.default_rng(seed), labelled.components.device
    chosen = labelled.all_but(left_out)
    network = HeadNetwork(len(CONTEXT) * COMPONENTS, HIDDEN, DROPOUT).to(device)
    importance = [torch.ones(len(classes), device=device) for classes in (Phoneme, Viseme)]
    n_batches = max(1, len(chosen) // BATCH)
    n_steps = EPOCHS * n_batches
    optimiser = torch.optim.AdamW(network.parameters(), RATE, weight_decay=0.01)
    schedule = torch.optim.lr_scheduler.LambdaLR(optimiser, lambda step: share_of_rate((step + 1) / n_steps))
    for step in range(n_steps):
        if step % n_batches == 0:
            order = generator.permutation(chosen)
        batch = order[step % n_batches * BATCH :][:BATCH]
        with reduced_precision(device.type):
            logits = network(labelled.around(batch))
        loss = cross_entropy(logits[:, :, None], labelled.answers(batch), importance)
        optimiser.zero_grad()
        torch.autograd.backward(loss)
        nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimiser.step()
        schedule.step()
        on_progress((step + 1) / n_steps)
    hidden, hidden_bias, weights, bias = network.finished()
    return EncoderHead(*projection, hidden, hidden_bias, weights, bias, _priors_of(labelled, chosen))


def _priors_of(labelled: _Labelled, chosen: Int64Array) -> Float32Array:
    """Return the shares of the phonemes, and of the visemes, in what is learned from, shape (26,)."""
    counts = labelled.counts(chosen)
    shares = []
    for codes, n_classes in ((labelled.phonemes, len(Phoneme)), (labelled.visemes, len(Viseme))):
        found = np.bincount(codes[chosen].ravel(), counts.ravel(), 256)[:n_classes] + LEAST_PRIOR * counts.sum()
        shares.append(found / found.sum())
    return np.concatenate(shares).astype(np.float32)


@dataclass(frozen=True)
class Taught:
    """What the teacher says.

    Attributes
    ----------
    utterances : the recordings, people's with moved labels where that helps.
    soft_labels : by heads that did not learn from the speaker.
    head : that learned from all speakers.
    rounds : in which labels were moved.
    """

    utterances: tuple[LabelledUtterance, ...]
    soft_labels: SoftLabels
    head: EncoderHead
    rounds: tuple[Round, ...]


def teach(
    utterances: Sequence[LabelledUtterance],
    encoded: Encoded,
    weights: Mapping[str, float],
    people: AbstractSet[str],
    left_out: AbstractSet[str],
    seed: int,
    on_progress: OnShare,
) -> Taught:
    """Train heads, have them recognise the recordings of speakers that they did not learn from, and move labels.

    Parameters
    ----------
    utterances : all recordings, labelled or not.
    encoded : the files with their states.
    weights : how much each speaker counts, by name.
    people : speakers whose labels may be moved.
    left_out : speakers from whom no head learns but the last, which learns from all.
    seed : of all chance.
    on_progress : called with the share that is done.
    """
    heads = _HeadTraining(encoded, weights, left_out, seed, on_progress)
    kept, rounds = tuple(utterances), list[Round]()
    soft_labels = heads.soft_labels(kept)
    for _ in range(ROUNDS if people else 0):
        moved = tuple(realigned_by(u, soft_labels[key_of(u)]) if u.voice in people else u for u in kept)
        after = heads.soft_labels(moved)
        judged = [(a, b) for a, b in zip(kept, moved, strict=True) if a.labels and a.voice in people]
        rounds.append(round_of(judged, soft_labels, after))
        if not rounds[-1].gains:
            break
        kept, soft_labels = moved, after
    return Taught(kept, soft_labels, heads.of_everybody(kept), tuple(rounds))


class _HeadTraining:
    """Trains heads, one after the other; the parameters are those of `teach`."""

    def __init__(
        self,
        encoded: Encoded,
        weights: Mapping[str, float],
        left_out: AbstractSet[str],
        seed: int,
        on_progress: OnShare,
    ) -> None:
        self._encoded, self._weights, self._left_out = encoded, weights, left_out
        self._seed, self._on_progress, self._n_trained = seed, on_progress, 0
        self._projection = projection_of(encoded, seed)
        self._groups = folds_of(list(weights), GROUPS)

    def soft_labels(self, utterances: Sequence[LabelledUtterance]) -> SoftLabels:
        """Return what heads that learn from the labelled recordings say of those of other speakers."""
        labelled = self._labelled(utterances)
        found: dict[str, NDArray[np.float16]] = {}
        for group in self._groups:
            strange = group | self._left_out
            if strange >= self._weights.keys():  # there must be a speaker to learn from
                strange = group
            head = self._trained(labelled, strange)
            for key in (key_of(u) for u in utterances if u.voice in group):
                found[key] = head.probabilities(np.load(self._encoded[key])).astype(np.float16)
        return found

    def of_everybody(self, utterances: Sequence[LabelledUtterance]) -> EncoderHead:
        """Return the head that learns from all speakers."""
        return self._trained(self._labelled(utterances), frozenset())

    def _labelled(self, utterances: Sequence[LabelledUtterance]) -> _Labelled:
        return _Labelled.of([u for u in utterances if u.labels], self._encoded, self._weights, self._projection)

    def _trained(self, labelled: _Labelled, left_out: AbstractSet[str]) -> EncoderHead:
        n_done, n_heads = self._n_trained, (ROUNDS + 1) * GROUPS + 1
        self._n_trained += 1
        return _train_head(
            labelled,
            left_out,
            self._projection,
            self._seed,
            lambda share: self._on_progress((n_done + share) / n_heads),
        )


SHIPPED = Path(__file__).with_name("groups.toml")
"""The groups of the speakers whom the shipped models were trained on."""
LARGEST_FILE = 1 << 20
_DEALT = 3
"""Where no group is known, one of this many speakers is left out."""


@dataclass(frozen=True)
class Groups:
    """Speakers who are left out of one of the two trainings.

    Attributes
    ----------
    validation : those by whom settings are chosen.
    reserved : those who are recognised once, when nothing is chosen any more.
    """

    validation: frozenset[str] = frozenset()
    reserved: frozenset[str] = frozenset()

    @property
    def everybody(self) -> frozenset[str]:
        """All who are left out."""
        return self.validation | self.reserved

    @classmethod
    def of(cls, names: Collection[str], file: Path | None = None) -> "Groups":
        """Return the groups that a file names, of these speakers.

        Parameters
        ----------
        names : of all speakers, as corpus/speaker.
        file : TOML with lists of names, ``validation`` and ``reserved``; None for the shipped one, and where that
            names none of them a third of the speakers for the validation.

        Raises
        ------
        CorpusError : the file cannot be read, or names none of them.
        """
        path = SHIPPED if file is None else file
        try:
            told = tomllib.loads(read_text_file(path, LARGEST_FILE, "groups of speakers", CorpusError))
            validation, reserved = (frozenset(told.get(name, ())) & set(names) for name in ("validation", "reserved"))
        except (tomllib.TOMLDecodeError, TypeError) as error:
            raise CorpusError(
                f"{path.name}: groups are two lists of names in TOML, validation and reserved ({error}); correct it"
            ) from error
        if validation:
            return cls(validation, reserved - validation)
        if file is not None:
            raise CorpusError(
                f"{path.name}: none of its validation speakers is in the folders; name them corpus/speaker"
            )
        return cls(frozenset(folds_of(list(names), _DEALT)[0]))


def folds_of(names: Sequence[str], n_folds: int) -> list[set[str]]:
    """Deal the speakers into groups, the kinds evenly: names that begin alike lie in different ones."""
    ordered = sorted(names)
    return [set(ordered[k::n_folds]) for k in range(n_folds)]
