"""The training of the networks, in PyTorch: examples in, a network out; interrupted, it goes on where it was.

A GPU is used where there is one. Products are of 16-bit numbers (bfloat16) where that is faster: several times on
processors with instructions for them, and slower on others.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from timeit import repeat
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional
from torch.optim.swa_utils import AveragedModel
from typing_extensions import override

from phonemeengine.arrays import Float32Array, Int64Array
from phonemeengine.calibration.fine_tuning import VISEME_SHARE, share_of_rate
from phonemeengine.encoder.head import HALVES
from phonemeengine.encoder.whisper import LEAST_PEAK
from phonemeengine.storage.files import atomic_write
from phonemetraining.config import TrainingConfig
from phonemetraining.examples import Examples
from phonemetraining.networks import N_PHONEMES, SmallNetwork, TrainableEncoder, with_running_floor
from phonemetraining.spectra import SMALL_BANDS, WHISPER_BANDS, disturbed, warped

SMOOTHING = 0.05
"""Share of the certainty that is spread over all classes: labels lie a little beside the truth."""
TEACHER_SHARE = 0.5
"""How much the teacher counts beside a label (G. Hinton, O. Vinyals and J. Dean, "Distilling the Knowledge in a
Neural Network", arXiv:1503.02531, at the temperature 1); where there is no label, it alone counts."""
STATES_SHARE = 0.5
"""How much the error of the encoder's states counts, which the small network tells too while it is trained."""
AVERAGED = 300
"""Steps over which the average of the weights reaches back, about."""
KEPT_EVERY = 100
"""Steps after which the state of a training is kept."""
CLIP = 1.0
FASTER = 7.5
"""How much higher the rate of Muon is than that of AdamW, for steps of the same mean square."""
DECAY = 0.01


def device_of_choice() -> str:
    """Return where PyTorch works: ``cuda`` where there is a GPU, else ``cpu``."""
    return "cuda" if torch.cuda.is_available() else "cpu"


def reduced_precision(device: str) -> torch.autocast:
    """Return the context in which products are of 16-bit numbers, where these are the faster ones."""
    return torch.autocast(device, dtype=torch.bfloat16, enabled=reduces_precision(device))


def reduces_precision(device: str) -> bool:
    """Return whether products of 16-bit numbers are the faster ones."""
    return device != "cpu" or bfloat16_pays()


@lru_cache(maxsize=1)
def bfloat16_pays() -> bool:
    """Return whether the processor multiplies matrices of 16-bit numbers faster, as measured once."""
    numbers = torch.ones(256, 256)  # drawn ones would change what the training draws next
    halved = numbers.bfloat16()
    return min(repeat(lambda: halved @ halved, number=4)) < min(repeat(lambda: numbers @ numbers, number=4))


def targets_of(codes: Tensor, soft_labels: Tensor, importance: Tensor, certainties: Tensor) -> tuple[Tensor, Tensor]:
    """Return what is to be answered of one kind of classes, and how much each frame counts.

    Parameters
    ----------
    codes : of the labels, shape (..., n_frames); n_classes or above where the label says nothing of this kind.
    soft_labels : the teacher's probabilities, shape (..., n_frames, n_classes); zeros where it says nothing.
    importance : how much a frame of each class counts, shape (n_classes,).
    certainties : how much each label counts, 0..1, shape (..., n_frames).
    """
    n = len(importance)
    told = certainties * (codes < n)
    spoken = soft_labels.sum(dim=-1)
    taught = spoken * torch.where(told > 0, TEACHER_SHARE, 1.0)
    labelled = told * (1 - TEACHER_SHARE * spoken)
    known = codes.clamp(max=n - 1).long()
    smoothed = (1 - SMOOTHING) * functional.one_hot(known, n) + SMOOTHING / n
    wanted = labelled[..., None] * smoothed + taught[..., None] * soft_labels
    weights = wanted.sum(dim=-1)
    meant = torch.where(told > 0, known, soft_labels.argmax(dim=-1))
    return wanted / weights.clamp(min=1e-9)[..., None], weights * importance[meant]


def cross_entropy(
    logits: Tensor, batch: Mapping[str, Tensor], importance: Sequence[Tensor], shares: Sequence[float] = (1.0,)
) -> Tensor:
    """Return the error of the answers in a batch.

    Parameters
    ----------
    logits : shape (n_batch, n_frames, n_heads, 26); head k answers at frame t for frame t - k.
    batch : what should be answered: ``phonemes``, ``visemes``, ``certainties`` and the teacher's probabilities,
        ``soft_labels``; see `targets_of`.
    importance : how much a frame of each phoneme, and of each viseme, counts.
    shares : how much each head counts.
    """
    soft_labels, certainties = batch["soft_labels"].float(), batch["certainties"].float()
    total, n = logits.new_zeros((), dtype=torch.float32), logits.shape[1]
    kinds = (("phonemes", slice(0, N_PHONEMES), 1.0), ("visemes", slice(N_PHONEMES, None), VISEME_SHARE))
    for (name, part, weight), important in zip(kinds, importance, strict=True):
        wanted, counts = targets_of(batch[name], soft_labels[..., part], important, certainties)
        wanted = wanted * (weight * counts / counts.sum().clamp(min=1e-9))[..., None]
        logs = logits[..., part].float().log_softmax(dim=-1)
        for k, share in enumerate(shares):
            total = total - share * (wanted[:, : n - k] * logs[:, k:, k]).sum()
    return total


class Lesson(nn.Module):
    """What a network answers in a batch, and how wrong that is.

    Parameters
    ----------
    network : what learns.
    examples : what it learns from.
    """

    names: tuple[str, ...] = ("phonemes", "visemes", "certainties", "soft_labels")

    def __init__(self, network: nn.Module, examples: Examples) -> None:
        super().__init__()
        self.network = network
        self.importance = examples.importance()

    def optimisers(self) -> list[torch.optim.Optimizer]:
        """Return what improves the network; their rates are the highest ones."""
        raise NotImplementedError


class EncoderLesson(Lesson):
    """The causal encoder, in each batch with one of its two look-aheads."""

    names = (*Lesson.names, "mels")

    def __init__(self, network: TrainableEncoder, examples: Examples, config: TrainingConfig) -> None:
        super().__init__(network, examples)
        self.network: TrainableEncoder = network
        self._config = config

    @override
    def forward(self, batch: dict[str, Tensor]) -> Tensor:
        mels = disturbed(warped(batch["mels"].float(), WHISPER_BANDS), WHISPER_BANDS)
        n_ahead = int(torch.randint(2, ()))
        logits = self.network(self.network.states(with_running_floor(mels, _peaks_before(mels)), n_ahead))
        return cross_entropy(logits[:, :, None], batch, self.importance)

    @override
    def optimisers(self) -> list[torch.optim.Optimizer]:
        """Return what improves the network: the head learns faster than what Whisper knows."""
        new = {*self.network.head.parameters(), *self.network.norm.parameters()}
        old = [parameter for parameter in self.network.parameters() if parameter not in new]
        groups = [{"params": old, "lr": self._config.encoder_rate}, {"params": [*new], "lr": self._config.head_rate}]
        return [torch.optim.AdamW(groups, weight_decay=DECAY)]


def _peaks_before(mels: Tensor) -> Tensor:
    """Draw the loudest band before each excerpt, anything from nothing to what is loudest in it."""
    loudest = mels.amax(dim=(1, 2))[:, None]
    return LEAST_PEAK + (loudest - LEAST_PEAK) * torch.rand_like(loudest)


class SmallLesson(Lesson):
    """A small network, which an encoder may teach besides: its probabilities and its states.

    Parameters
    ----------
    teacher : a causal encoder that learned from the same speakers; None for none.
    """

    def __init__(
        self, network: SmallNetwork, examples: Examples, config: TrainingConfig, teacher: TrainableEncoder | None
    ) -> None:
        super().__init__(network, examples)
        self.network: SmallNetwork = network
        self._config, self._teacher = config, [] if teacher is None else [teacher.eval()]  # a list: it does not learn
        self.names = (*Lesson.names, "log_powers", *(("mels",) if teacher else ()))
        self.to_states = nn.Linear(config.width, self._teacher[0].norm.normalized_shape[0]) if teacher else None

    @override
    def forward(self, batch: dict[str, Tensor]) -> Tensor:
        network, batch = self.network, dict(batch)
        hidden = network.hidden(disturbed(warped(batch["log_powers"].float(), SMALL_BANDS), SMALL_BANDS))
        loss = hidden.new_zeros(())
        if self.to_states is not None:
            with torch.no_grad():  # the teacher gets the sound without what is added to it for the student
                mels = batch["mels"].float()
                states = self._teacher[0].norm(
                    self._teacher[0].states(with_running_floor(mels, mels.amax(dim=(1, 2))[:, None]))
                )
                shares = self._teacher[0].head(states).unflatten(2, (HALVES, -1)).flatten(1, 2).float()
            phonemes, visemes = shares[..., :N_PHONEMES].softmax(-1), shares[..., N_PHONEMES:].softmax(-1)
            batch["soft_labels"] = (batch["soft_labels"].float() + torch.cat((phonemes, visemes), dim=-1)) / 2
            # state i looks as far as frame 2 i + 4: a causal network can tell it when it has seen frame 2 i + 5
            delay = 0 if network.centred else len(network.shares) - 1
            told = self.to_states(hidden[:, delay::HALVES])
            states = states[:, : told.shape[1]].float()
            loss = loss + STATES_SHARE * functional.mse_loss(told.float(), states) / states.var().clamp(min=1e-6)
        return loss + cross_entropy(network(hidden), batch, self.importance, network.shares)

    @override
    def optimisers(self) -> list[torch.optim.Optimizer]:
        """Return what improves the network.

        Matrices between hidden layers go along their momentum made orthogonal (K. Jordan et al., "Muon: An optimizer
        for hidden layers in neural networks", 2024), all else as AdamW has it (I. Loshchilov and F. Hutter,
        arXiv:1711.05101). PyTorch's Muon computes with 16-bit numbers alone: where these are slow, a step of it takes
        seconds, and AdamW does everything.
        """
        rate, matrices = self._config.rate, self.network.matrices
        if not reduces_precision(matrices[0].device.type):
            return [torch.optim.AdamW(self.parameters(), rate, weight_decay=DECAY)]
        chosen = {id(matrix) for matrix in matrices}
        others = [parameter for parameter in self.parameters() if id(parameter) not in chosen]
        muon = torch.optim.Muon(matrices, FASTER * rate, weight_decay=DECAY, adjust_lr_fn="match_rms_adamw")
        return [muon, torch.optim.AdamW(others, rate, weight_decay=DECAY)]


@torch.no_grad()
def _averaged(means: Sequence[Tensor], values: Sequence[Tensor], n: Tensor | int) -> None:
    """Let averages follow values (B. Polyak and A. Juditsky, SIAM J. Control Optim. 30(4), 1992)."""
    share = max(1 / AVERAGED, 10 / (int(n) + 10))
    for mean, value in zip(means, values, strict=True):
        if mean.is_floating_point():
            mean.lerp_(value.to(mean.dtype), share)
        else:  # the number of batches that a normalisation saw
            mean.copy_(value)


@dataclass
class Training:
    """A training that goes on step by step.

    Attributes
    ----------
    lesson : what learns, and from what.
    examples : all of them.
    n_epochs, batch_size, n_frames : how often it goes through them, in what batches.
    seed : of all chance.
    checkpoint : the file that keeps its state, every 100 steps and after each epoch; None for none.
    on_progress : called with the share that is done.
    """

    lesson: Lesson
    examples: Examples
    n_epochs: int
    batch_size: int
    n_frames: int
    seed: int
    checkpoint: Path | None = None
    on_progress: Callable[[float], object] = field(default=lambda _share: None)

    def run(self) -> None:
        """Train; in the end the network has the average of its weights over the last steps."""
        device = self.examples.device
        lesson = self.lesson.to(device).train()
        generator = np.random.default_rng(self.seed)
        per_epoch = max(
            1, len(self.examples.epoch(self.n_frames, np.random.default_rng(self.seed))) // self.batch_size
        )
        n_steps = self.n_epochs * per_epoch
        optimisers = lesson.optimisers()
        schedules = [
            torch.optim.lr_scheduler.LambdaLR(o, lambda step: share_of_rate((step + 1) / n_steps)) for o in optimisers
        ]
        average = AveragedModel(lesson.network, torch.device(device), multi_avg_fn=_averaged, use_buffers=True)
        parts: dict[int, Any] = dict(enumerate((lesson, average, *optimisers, *schedules)))
        done = self._restored(parts, generator)
        while done < n_steps:
            before = generator.bit_generator.state  # of which the same excerpts follow
            stretches = self.examples.epoch(self.n_frames, generator)
            for k in range(done % per_epoch, per_epoch):
                self._step(stretches[k * self.batch_size :][: self.batch_size], optimisers)
                for schedule in schedules:
                    schedule.step()
                average.update_parameters(lesson.network)
                done += 1
                self.on_progress(done / n_steps)
                if done % per_epoch == 0:
                    before = generator.bit_generator.state
                if done % KEPT_EVERY == 0 or done % per_epoch == 0:
                    self._keep(parts, before, done)
        lesson.network.load_state_dict(average.module.state_dict())
        lesson.eval()

    def _step(self, frames: Int64Array, optimisers: Sequence[torch.optim.Optimizer]) -> None:
        if not len(frames):
            return
        batch = self.examples.batch(frames, *self.lesson.names)
        with reduced_precision(self.examples.device):
            loss = self.lesson(batch)
        for optimiser in optimisers:
            optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(self.lesson.parameters(), CLIP)
        for optimiser in optimisers:
            optimiser.step()

    def _keep(self, parts: dict[int, Any], generator: Mapping[str, Any], n_done: int) -> None:
        if self.checkpoint is None:
            return
        state: dict[str, Any] = {"parts": {k: part.state_dict() for k, part in parts.items()}}
        state |= {"n_done": n_done, "chance": torch.get_rng_state(), "generator": generator}
        if self.examples.device != "cpu":
            state["device_chance"] = torch.cuda.get_rng_state()
        buffer = BytesIO()
        torch.save(state, buffer)
        with atomic_write(self.checkpoint) as file:
            file.write(buffer.getvalue())

    def _restored(self, parts: dict[int, Any], generator: np.random.Generator) -> int:
        """Take up an interrupted training, and return the number of its steps."""
        if self.checkpoint is None or not self.checkpoint.is_file():
            return 0
        state = torch.load(self.checkpoint, map_location=self.examples.device, weights_only=True)
        for name, part in parts.items():
            part.load_state_dict(state["parts"][name])
        generator.bit_generator.state = state["generator"]
        torch.set_rng_state(state["chance"].cpu())
        if "device_chance" in state:
            torch.cuda.set_rng_state(state["device_chance"].cpu())
        return int(state["n_done"])


def train_small(
    examples: Examples,
    config: TrainingConfig,
    teacher: TrainableEncoder | None = None,
    checkpoint: Path | None = None,
    on_progress: Callable[[float], object] = lambda _share: None,
) -> SmallNetwork:
    """Return a small network that learned from examples, and from an encoder if there is one."""
    torch.manual_seed(config.seed)
    network = SmallNetwork(config.width, config.dilations, config.dropout, centred=config.centred)
    lesson = SmallLesson(network, examples, config, teacher)
    Training(
        lesson, examples, config.n_epochs, config.batch_size, config.n_frames, config.seed, checkpoint, on_progress
    ).run()
    return network


SAMPLE = 8
"""Excerpts of the speech from which the biases of relative positions are taken."""


def train_encoder(
    examples: Examples,
    config: TrainingConfig,
    whisper: Mapping[str, Float32Array],
    checkpoint: Path | None = None,
    on_progress: Callable[[float], object] = lambda _share: None,
) -> TrainableEncoder:
    """Return the lower layers of Whisper's encoder, made causal, once they learned from examples.

    Parameters
    ----------
    examples : the speech.
    config : how.
    whisper : the encoder's weights by their names.
    checkpoint : see `Training`.
    on_progress : called with the share that is done.
    """
    torch.manual_seed(config.seed)
    network = TrainableEncoder(whisper, config.n_layers, config.dropout).to(examples.device)
    sample = examples.epoch(config.n_encoder_frames, np.random.default_rng(config.seed))[:SAMPLE]
    mels = examples.batch(sample, "mels")["mels"].float()
    network.eval().make_causal(with_running_floor(mels, mels.amax(dim=(1, 2))[:, None]))
    lesson = EncoderLesson(network, examples, config)
    Training(
        lesson,
        examples,
        config.n_encoder_epochs,
        config.encoder_batch,
        config.n_encoder_frames,
        config.seed,
        checkpoint,
        on_progress,
    ).run()
    return network
