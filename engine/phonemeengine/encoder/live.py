"""The real-time model: lower layers of Whisper's encoder that look back only, run by ONNX Runtime as the sound comes.

Its file is an ONNX model with what else has to be known in its metadata.
"""

import json
import threading
import weakref
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array, ShortRepr
from phonemeengine.encoder.graph import HEAD_SIZE, N_HALVES, SLOTS, Weights, live_graph, live_inputs
from phonemeengine.encoder.head import N_OUTPUTS
from phonemeengine.encoder.mel import SILENT, RunningScale
from phonemeengine.encoder.runtime import has_runtime, open_session
from phonemeengine.encoder.weights import N_MELS
from phonemeengine.encoder.whisper import WHISPER_LICENCE
from phonemeengine.errors import ModelError
from phonemeengine.storage.files import read_file, write_file

FORMAT = 1
LARGEST_FILE = 12 << 20
LICENCE = f"trained from {WHISPER_LICENCE}; MIT licence, as that"
LOOK_AHEADS = (2, 4)
"""Frames of 10 ms that it looks ahead: without, or with, a state ahead in its first layer."""
CONTEXT = 3
"""Mel frames that a call needs besides two for each state."""
ENCODER_SHARE = 0.6
"""Of the encoder in the mean of the logarithms of its probabilities and of the small network's, unless it is told."""
_KEY = "phonemeanalyser"
_DAMAGED = "is no real-time model, or damaged; get it anew"


@dataclass(frozen=True, eq=False, repr=False)
class LiveEncoder(ShortRepr):
    """A real-time model as its file holds it; two are equal if their bytes are.

    Attributes
    ----------
    content : of the file.
    name : of the file.
    """

    content: bytes
    name: str

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LiveEncoder) and self.content == other.content

    def __hash__(self) -> int:
        return hash(self.content)


@dataclass(frozen=True)
class EncoderMix:
    """How the probabilities of the encoder and of the small network are joined.

    Attributes
    ----------
    encoder_share : of the encoder in the mean of the logarithms, 0..1.
    weakened : power by which classes that are frequent count less, 0 or more.
    priors : shares of the phonemes and visemes in what it was trained on, 26 numbers above 0.
    """

    encoder_share: float = ENCODER_SHARE
    weakened: float = 0.0
    priors: tuple[float, ...] = (1 / N_OUTPUTS,) * N_OUTPUTS

    def __post_init__(self) -> None:
        fits = 0 <= self.encoder_share <= 1 and 0 <= self.weakened <= 2 and len(self.priors) == N_OUTPUTS
        if not (fits and all(0 < prior <= 1 for prior in self.priors)):
            raise ValueError("a mix has a share of 0..1, a power of 0..2 and 26 priors above 0")


def build_live_encoder(
    weights: Weights, mix: EncoderMix | None = None, bits: int = 8, about: Mapping[str, Any] | None = None
) -> LiveEncoder:
    """Return a real-time model.

    Parameters
    ----------
    weights : as of `phonemeengine.encoder.graph.live_graph`.
    mix : how it is joined with the small network; None for the usual shares, without priors.
    bits : 8, or 32 for weights as they are.
    about : what it was trained with, as of `phonemeengine.recognition.model.Model`: texts and numbers by name.
    """
    mix = mix or EncoderMix()
    known = {"format": FORMAT, "encoder_share": mix.encoder_share, "weakened": mix.weakened, "priors": mix.priors}
    told = {_KEY: json.dumps(known | {"about": dict(about or {})}), "licence": LICENCE}
    return LiveEncoder(live_graph(weights, bits, told), "the new model")


def save_live_encoder(encoder: LiveEncoder, path: Path) -> None:
    """Write a real-time model's file; the old one stays until the new one is complete.

    Raises
    ------
    ModelError : it cannot be written, or has more than 12 MB.
    """
    if len(encoder.content) > LARGEST_FILE:
        size = len(encoder.content) / (1 << 20)
        raise ModelError(f"{path.name}: a real-time model has at most 12 MB, this has {size:.1f}; use 8 bits")
    write_file(path, encoder.content, ModelError)


def load_live_encoder(path: Path) -> LiveEncoder:
    """Read a real-time model's file; what is in it is checked when it is opened.

    Raises
    ------
    ModelError : it cannot be read, or is too large.
    """
    return LiveEncoder(read_file(path, LARGEST_FILE, "a real-time model", ModelError), path.name)


@lru_cache(maxsize=2)
def open_live_encoder(encoder: LiveEncoder) -> "OpenEncoder":
    """Return the model at work, which is opened once and stays in memory.

    Raises
    ------
    ModelError : onnxruntime is not installed, or the file is damaged, foreign or of a newer version.
    """
    try:
        return OpenEncoder(encoder.content)
    except ModelError as error:
        raise ModelError(f"{encoder.name}: {error}") from error


class OpenEncoder:
    """A real-time model at work, on as many sounds as there are.

    Parameters
    ----------
    content : of its file.

    Attributes
    ----------
    mix : how its probabilities are joined with those of the small network.
    about : what it was trained with.

    Raises
    ------
    ModelError : as of `open_live_encoder`.
    """

    def __init__(self, content: bytes) -> None:
        try:
            self._session = open_session(content, 1)
        except ModelError as error:
            if not has_runtime():
                raise
            raise ModelError(_DAMAGED) from error
        self.mix, self.about = _told_by(self._session.get_modelmeta().custom_metadata_map)
        inputs = {each.name: each.shape for each in self._session.get_inputs()}
        self.n_layers, self.n_channels = (len(inputs) - 4) // 2, _width_of(inputs)
        self._rings = [f"{name}_{k}" for name in ("keys", "values") for k in range(self.n_layers)]
        self._outputs = ["logits", "next_pending", *(f"new_{name}" for name in self._rings)]
        self._batch: _JoinedRings | None = None
        self._batching = threading.Lock()
        if inputs != live_inputs(self.n_layers, self.n_channels):
            raise ModelError(_DAMAGED)
        try:
            trial = self.encode([EncoderStream(self, 0)], [np.full((CONTEXT, N_MELS), SILENT, np.float32)])[0]
        except Exception as error:  # of the library, whatever a graph from elsewhere makes it say
            raise ModelError(_DAMAGED) from error
        if trial.shape != (N_HALVES, N_OUTPUTS) or not np.isfinite(trial).all():
            raise ModelError(_DAMAGED)

    def encode(self, streams: Sequence["EncoderStream"], logarithms: Sequence[Float32Array]) -> list[Float32Array]:
        """Take the next mel frames of each sound, and return what follows from all that came.

        Parameters
        ----------
        streams : of the same look-ahead, made for this model.
        logarithms : of each, as `phonemeengine.encoder.mel.whisper_log_mels` gives them, shape (n_k, 80).

        Returns
        -------
        for each sound float32, shape (m, 26): logits of the phonemes and visemes of its next m frames. Of f frames
        that came, those up to f - 2 are answered, or up to f - 4 with a state ahead, and of an odd f one more.
        """
        for stream, block in zip(streams, logarithms, strict=True):
            stream.add(block)
        found: list[list[Float32Array]] = [[np.zeros((0, N_OUTPUTS), np.float32)] for _ in streams]
        while waiting := [k for k, stream in enumerate(streams) if stream.n_ready]:
            n = min(streams[k].n_ready for k in waiting)
            for k, answers in zip(waiting, self._push([streams[k] for k in waiting], n), strict=True):
                found[k].append(answers)
        return [np.concatenate(parts) for parts in found]

    def _push(self, streams: Sequence["EncoderStream"], n: int) -> list[Float32Array]:
        """Encode the next n states of each sound."""
        if len(streams) == 1:
            return self._run(streams, n, [0], [ring[np.newaxis] for ring in streams[0].rings])
        with self._batching:
            rows = None if self._batch is None else self._batch.rows_of(streams)
            if self._batch is None or rows is None:
                old, self._batch, rows = self._batch, _JoinedRings(streams), list(range(len(streams)))
                if old is not None:
                    old.dissolve()
            return self._run(streams, n, rows, self._batch.rings)

    def _run(
        self, streams: Sequence["EncoderStream"], n: int, rows: Sequence[int], rings: Sequence[Float32Array]
    ) -> list[Float32Array]:
        """Encode the next n states of sounds whose rings are those in these rows."""
        mel = np.zeros((len(rings[0]), N_MELS, N_HALVES * n + CONTEXT), np.float32)
        count, pending = np.zeros(len(mel), np.int64), np.zeros((len(mel), 1, self.n_channels), np.float32)
        for row, stream in zip(rows, streams, strict=True):
            mel[row], count[row] = stream.frames[: mel.shape[2]].T, stream.count
            pending[row] = stream.pending
        feed = {"mel": mel, "count": count, "ahead": np.array([streams[0].ahead]), "pending": pending}
        logits, pending, *new = self._session.run(self._outputs, feed | dict(zip(self._rings, rings, strict=True)))
        answers = [stream.without_early(logits[row]) for row, stream in zip(rows, streams, strict=True)]
        for row, stream in zip(rows, streams, strict=True):
            stream.remember(n, pending[row], [ring[row] for ring in new])
        return answers


class _JoinedRings:
    """Sounds whose rings lie side by side in memory, so that those of many are not copied together each time.

    Parameters
    ----------
    streams : the sounds; their rings become parts of these.
    """

    def __init__(self, streams: Sequence["EncoderStream"]) -> None:
        self.rings = [np.stack(rings) for rings in zip(*(stream.rings for stream in streams), strict=True)]
        self._streams = [weakref.ref(stream) for stream in streams]
        for row, stream in enumerate(streams):
            stream.rings = [ring[row] for ring in self.rings]

    def rows_of(self, streams: Sequence["EncoderStream"]) -> list[int] | None:
        """Return where sounds lie; None where one lies elsewhere, or where they are less than half of all."""
        known = {id(kept()): row for row, kept in enumerate(self._streams)}
        rows = [known.get(id(stream), -1) for stream in streams]
        return None if min(rows) < 0 or 2 * len(rows) < len(self._streams) else rows

    def dissolve(self) -> None:
        """Give those that are still here rings of their own."""
        for kept in self._streams:
            stream = kept()
            if stream is not None and stream.rings[0].base is self.rings[0]:
                stream.rings = [ring.copy() for ring in stream.rings]


class EncoderStream:
    """What is remembered of one sound between two calls.

    Parameters
    ----------
    model : that encodes it.
    ahead : states that the first layer looks ahead, 0 or 1.

    Attributes
    ----------
    frames : scaled mel frames that are still needed, shape (n, 80).
    count : states that were encoded.
    pending : what the first layer has to answer yet, shape (1, n_channels).
    rings : keys of each layer, then values, as the graph wants them.
    """

    def __init__(self, model: OpenEncoder, ahead: int) -> None:
        self.ahead, self.count = ahead, 0
        self._scale = RunningScale()
        self.frames = np.full((CONTEXT - 1, N_MELS), SILENT, np.float32)  # before the sound there was silence
        n_heads = model.n_channels // HEAD_SIZE
        self.pending = np.zeros((1, model.n_channels), np.float32)
        shapes = (HEAD_SIZE, SLOTS), (SLOTS, HEAD_SIZE)
        self.rings = [np.zeros((n_heads, *shape), np.float32) for shape in shapes for _ in range(model.n_layers)]

    @property
    def n_ready(self) -> int:
        """States that can be encoded."""
        return max(0, (len(self.frames) - CONTEXT) // N_HALVES)

    def add(self, logarithms: Float32Array) -> None:
        """Take the next mel frames."""
        self.frames = np.concatenate((self.frames, self._scale.scale(logarithms)))

    def without_early(self, logits: Float32Array) -> Float32Array:
        """Leave out what is said of the state before the first one, where a state waits for the one after it."""
        return logits[N_HALVES * self.ahead :] if self.count == 0 else logits

    def remember(self, n: int, pending: Float32Array, rings: Sequence[Float32Array]) -> None:
        """Keep what the model gave of n states: the pending one, and the keys and the values of each layer."""
        kept, n_layers = min(n, SLOTS), len(rings) // 2
        for k in range(n_layers):
            places = (self.count - (self.ahead if k else 0) + np.arange(n - kept, n)) % SLOTS
            self.rings[k][:, :, places] = rings[k][:, :, n - kept :]
            self.rings[n_layers + k][:, places] = rings[n_layers + k][:, n - kept :]
        self.pending, self.frames, self.count = pending, self.frames[N_HALVES * n :], self.count + n


def _told_by(metadata: Mapping[str, str]) -> tuple[EncoderMix, dict[str, Any]]:
    """Return how a model is mixed, and what it was trained with."""
    try:
        known = json.loads(metadata[_KEY])
        mix = EncoderMix(float(known["encoder_share"]), float(known["weakened"]), tuple(map(float, known["priors"])))
        version, about = int(known["format"]), known.get("about")
    except (KeyError, TypeError, ValueError, OverflowError, RecursionError) as error:
        raise ModelError(_DAMAGED) from error
    if version > FORMAT:
        raise ModelError("this real-time model is of a newer version; update the program")
    return mix, about if isinstance(about, dict) else {}


def _width_of(inputs: Mapping[str, Any]) -> int:
    """Return how many channels a model has, as far as its inputs tell; 0 where they do not."""
    shape = inputs.get("pending", [0])
    return shape[-1] if isinstance(shape[-1], int) else 0
