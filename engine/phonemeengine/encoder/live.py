"""The real-time model: lower layers of Whisper's encoder with a causal mask, run by ONNX Runtime as the sound comes.

Its file is an ONNX model with what else has to be known in its metadata.
"""

import json
import threading
import weakref
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from typing_extensions import override

from phonemeengine.arrays import Float32Array, ShortRepr
from phonemeengine.encoder.graph import HEAD_SIZE, N_HALVES, SLOTS, Weights, live_graph, live_inputs
from phonemeengine.encoder.head import N_OUTPUTS
from phonemeengine.encoder.onnx import has_runtime, open_session
from phonemeengine.encoder.weights import N_MELS
from phonemeengine.encoder.whisper import LEAST_POWER, SILENT, WHISPER_LICENCE, RunningScale
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
"""Share of the encoder in the mean of its log probabilities and the small network's, unless the file has its own."""
MANY, N_THREADS = 8, 2
"""From how many sounds on as many threads encode them together; waking a second one for fewer costs more."""
TOGETHER = 256
"""Mel frames of a whole sound that are encoded at once; attention to more of them costs more."""
_KEY = "phonemeanalyser"
_DAMAGED = "this is not a real-time model, or it is damaged; download it again"


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

    @override
    def __eq__(self, other: object) -> bool:
        return isinstance(other, LiveEncoder) and self.content == other.content

    @override
    def __hash__(self) -> int:
        return hash(self.content)


@dataclass(frozen=True, eq=False, repr=False)
class LiveHead(ShortRepr):
    """What turns the states of a real-time model into phonemes and visemes: a linear map.

    Attributes
    ----------
    weights : float32, shape (n_channels, 2 x 26): of the first 10 ms of a state, then of the second.
    bias : float32, shape (2 x 26,).
    origin : fingerprint of the head that came with the model; one that was adapted to a voice keeps it, and fits no
        other model.
    warp : of the mel bands from which the states come, see `phonemeengine.encoder.mel.whisper_log_mels`; above 1 for
        a voice with a shorter vocal tract than those the model was trained on, such as a child's.
    """

    weights: Float32Array
    bias: Float32Array
    origin: str
    warp: float = 1.0

    def logits(self, states: Float32Array) -> Float32Array:
        """Return the logits of the phonemes and visemes, shape (2 x n_states, 26), a row each 10 ms."""
        return np.asarray((states @ self.weights + self.bias).reshape(-1, N_OUTPUTS), np.float32)


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
    weights: Weights,
    mix: EncoderMix | None = None,
    bits: int = 8,
    about: Mapping[str, Any] | None = None,
    anchors: Float32Array | None = None,
) -> LiveEncoder:
    """Return a real-time model.

    Parameters
    ----------
    weights : as of `phonemeengine.encoder.graph.live_graph`.
    mix : how it is joined with the small network; None for the usual shares, without priors.
    bits : 8, or 32 for weights as they are.
    about : what it was trained with, as of `phonemeengine.recognition.model.Model`: texts and numbers by name.
    anchors : excerpts of the speech that it was trained on, so that an adaptation to one voice does not forget them,
        as `phonemeengine.encoder.whisper.whisper_log_mels` gives it, shape (n, n_frames, 80); None for none.
    """
    mix = mix or EncoderMix()
    known = {"format": FORMAT, "encoder_share": mix.encoder_share, "weakened": mix.weakened, "priors": mix.priors}
    told = {_KEY: json.dumps(known | {"about": dict(about or {})}), "licence": LICENCE}
    halved = None if anchors is None else anchors.astype(np.float16)
    return LiveEncoder(live_graph(weights, bits, told, halved), "the new model")


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
    head : what turns its states into phonemes and visemes.
    anchors : excerpts of the speech that it was trained on, float16, shape (n, n_frames, 80).

    Raises
    ------
    ModelError : as of `open_live_encoder`.
    """

    def __init__(self, content: bytes) -> None:
        self._content = content
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
        self._outputs = ["states", "next_pending", *(f"new_{name}" for name in self._rings)]
        self._batches: list[_JoinedRings] = []
        self._batching = threading.Lock()
        self._anchor_states: dict[int, Float32Array] = {}
        if inputs != live_inputs(self.n_layers, self.n_channels):
            raise ModelError(_DAMAGED)
        try:
            trial, self.head, self.anchors = self._tried()
        except Exception as error:  # of the library, whatever a graph from elsewhere makes it say
            raise ModelError(_DAMAGED) from error
        shapes = self.head.weights.shape, self.head.bias.shape, self.anchors.shape[2:]
        known = (self.n_channels, N_HALVES * N_OUTPUTS), (N_HALVES * N_OUTPUTS,), (N_MELS,)
        if shapes != known or not (np.isfinite(trial).all() and np.isfinite(self.anchors).all()):
            raise ModelError(_DAMAGED)

    def _tried(self) -> tuple[Float32Array, LiveHead, NDArray[np.float16]]:
        """Encode a state of silence; return what the head makes of it, the head, and the anchors."""
        stream = EncoderStream(self, 0)
        stream.add(np.full((CONTEXT, N_MELS), SILENT, np.float32))
        feed = self._feed([stream], 1, [0], [ring[np.newaxis] for ring in stream.rings])
        weights, bias, anchors = self._session.run(["head_weights", "head_bias", "anchors"], feed)
        head = LiveHead(weights, bias, sha256(weights.tobytes() + bias.tobytes()).hexdigest()[:16])
        return head.logits(self.encode([stream], [np.zeros((0, N_MELS), np.float32)])[0]), head, anchors

    @cached_property
    def _session_of_many(self) -> Any:
        return open_session(self._content, N_THREADS)

    def fitting(self, head: LiveHead | None) -> LiveHead:
        """Return a head that was adapted to a voice, if it belongs to this model; else the model's own."""
        fits = head is not None and (head.origin, head.weights.shape) == (self.head.origin, self.head.weights.shape)
        return head if head is not None and fits else self.head

    def anchor_states(self, ahead: int) -> Float32Array:
        """Return the states of the anchors, shape (n, n_frames / 2, rounded up, n_channels)."""
        if ahead not in self._anchor_states:
            found = [self.states_of(anchor.astype(np.float32), ahead) for anchor in self.anchors]
            self._anchor_states[ahead] = np.stack(found) if found else np.zeros((0, 0, self.n_channels), np.float32)
        return self._anchor_states[ahead]

    def states_of(self, logarithms: Float32Array, ahead: int) -> Float32Array:
        """Return the states of a whole sound that silence follows, shape (n_frames / 2, rounded up, n_channels).

        Parameters
        ----------
        logarithms : of its mel frames, as of `encode`.
        ahead : states that the first layer looks ahead, 0 or 1.
        """
        silence = np.full((2 * N_HALVES, N_MELS), np.log10(LEAST_POWER), np.float32)
        frames, stream = np.concatenate((logarithms, silence)), EncoderStream(self, ahead)
        parts = [self.encode([stream], [frames[k : k + TOGETHER]])[0] for k in range(0, len(frames), TOGETHER)]
        return np.concatenate(parts)[: -(-len(logarithms) // N_HALVES)]

    def encode(self, streams: Sequence["EncoderStream"], logarithms: Sequence[Float32Array]) -> list[Float32Array]:
        """Take the next mel frames of each sound, and return what follows from all that came.

        Parameters
        ----------
        streams : of the same look-ahead, made for this model.
        logarithms : of each, as `phonemeengine.encoder.whisper.whisper_log_mels` gives them, shape (n_k, 80).

        Returns
        -------
        for each sound float32, shape (m, n_channels): its next m states, each of two frames, for `LiveHead`. Of f
        frames that came, those up to f - 2 have states, or up to f - 4 with a state ahead, and of an odd f one more.
        """
        for stream, block in zip(streams, logarithms, strict=True):
            stream.add(block)
        found: list[list[Float32Array]] = [[np.zeros((0, self.n_channels), np.float32)] for _ in streams]
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
            known = ((batch, batch.rows_of(streams)) for batch in self._batches)
            batch, rows = next(((batch, rows) for batch, rows in known if rows is not None), (None, []))
            if batch is None:
                batch, rows = _JoinedRings(streams), list(range(len(streams)))
                self._batches = [batch, *(old for old in self._batches if old.stays())]
            return self._run(streams, n, rows, batch.rings)

    def _run(
        self, streams: Sequence["EncoderStream"], n: int, rows: Sequence[int], rings: Sequence[Float32Array]
    ) -> list[Float32Array]:
        """Encode the next n states of sounds whose rings are those in these rows."""
        session = self._session if len(rings[0]) < MANY else self._session_of_many
        states, pending, *new = session.run(self._outputs, self._feed(streams, n, rows, rings))
        answers = [stream.without_early(states[row]) for row, stream in zip(rows, streams, strict=True)]
        for row, stream in zip(rows, streams, strict=True):
            stream.remember(n, pending[row], [ring[row] for ring in new])
        return answers

    def _feed(
        self, streams: Sequence["EncoderStream"], n: int, rows: Sequence[int], rings: Sequence[Float32Array]
    ) -> dict[str, Any]:
        """Return what the graph takes, for `_run`."""
        mel = np.zeros((len(rings[0]), N_MELS, N_HALVES * n + CONTEXT), np.float32)
        count, pending = np.zeros(len(mel), np.int64), np.zeros((len(mel), 1, self.n_channels), np.float32)
        for row, stream in zip(rows, streams, strict=True):
            mel[row], count[row] = stream.frames[: mel.shape[2]].T, stream.count
            pending[row] = stream.pending
        feed = {"mel": mel, "count": count, "ahead": np.array([streams[0].ahead]), "pending": pending}
        return feed | dict(zip(self._rings, rings, strict=True))


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
        known = {id(stream): row for row, stream in self._here()}
        rows = [known.get(id(stream), -1) for stream in streams]
        return None if min(rows) < 0 or 2 * len(rows) < len(self._streams) else rows

    def stays(self) -> bool:
        """Return whether half of its sounds are still here; if not, give those that are rings of their own."""
        here = [stream for _, stream in self._here()]
        if 2 * len(here) >= len(self._streams):
            return True
        for stream in here:
            stream.rings = [ring.copy() for ring in stream.rings]
        return False

    def _here(self) -> Iterator[tuple[int, "EncoderStream"]]:
        for row, kept in enumerate(self._streams):
            stream = kept()
            if stream is not None and stream.rings[0].base is self.rings[0]:
                yield row, stream


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

    def without_early(self, states: Float32Array) -> Float32Array:
        """Leave out the state before the first one, where a state waits for the one after it."""
        return states[self.ahead :] if self.count == 0 else states

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
