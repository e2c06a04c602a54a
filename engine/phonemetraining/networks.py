"""The networks while they are trained, in PyTorch; each exports itself to what the engine runs without PyTorch."""

import math
from collections.abc import Mapping

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional
from typing_extensions import override

from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.fine_tuning import HEAD_SHARES
from phonemeengine.dsp.mel import N_BANDS
from phonemeengine.encoder.graph import BACK
from phonemeengine.encoder.head import HALVES
from phonemeengine.encoder.weights import N_MELS, N_STATES
from phonemeengine.encoder.whisper import DYNAMIC_RANGE, LEAST_PEAK, PEAK_FALL
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import TAPS, Layer

N_PHONEMES, N_CLASSES = len(Phoneme), len(Phoneme) + len(Viseme)
MEAN, SPREAD = -6.0, 2.0
"""What the logarithms of the 40 bands are like, so that the small network sees numbers about 1."""


class DilatedLayer(nn.Module):
    """A convolution over three frames, normalised over the batch, and added to what came in.

    The normalisation (S. Ioffe and C. Szegedy, arXiv:1502.03167) becomes a factor of the weights in `finished`.

    Parameters
    ----------
    n_in, n_out : channels; where they are equal the layer adds its result to its input.
    dilation : frames from one tap to the next.
    centred : whether it looks as far ahead as back; if not, only back.
    dropout : share of the inputs that is dropped.
    """

    def __init__(self, n_in: int, n_out: int, dilation: int, *, centred: bool, dropout: float) -> None:
        super().__init__()
        spread = math.sqrt(2 / (TAPS * n_in))  # K. He et al., arXiv:1502.01852
        # a matrix, since the optimiser makes the steps of matrices orthogonal
        self.weights = nn.Parameter(spread * torch.randn(n_out, n_in * TAPS))
        self.residual = n_in == n_out
        self.norm = nn.BatchNorm1d(n_out, momentum=0.01)
        nn.init.constant_(self.norm.weight, 0.5 if self.residual else 1.0)
        self.dropout = nn.Dropout(dropout)
        self.dilation, self.centred = dilation, centred

    @override
    def forward(self, block: Tensor) -> Tensor:
        reach = (TAPS - 1) * self.dilation
        padding = (self.dilation, self.dilation) if self.centred else (reach, 0)
        weights = self.weights.view(len(self.weights), -1, TAPS)
        sums = functional.conv1d(functional.pad(self.dropout(block), padding), weights, dilation=self.dilation)
        found = functional.relu(self.norm(sums))
        return found + block if self.residual else found

    def finished(self) -> Layer:
        """Return the layer as the engine runs it."""
        norm = self.norm
        assert norm.running_mean is not None
        assert norm.running_var is not None
        factor = norm.weight / torch.sqrt(norm.running_var + norm.eps)
        bias = norm.bias - norm.running_mean * factor
        weights = self.weights.view(len(self.weights), -1, TAPS) * factor[:, None, None]
        return Layer(_array(weights.permute(2, 1, 0).flatten(0, 1)), _array(bias), self.dilation)


class SmallNetwork(nn.Module):
    """The network of `phonemeengine.recognition.network`: dilated convolutions on 40 mel bands.

    Parameters
    ----------
    width : channels.
    dilations : of the layers after the first.
    dropout : share of the inputs of each layer that is dropped.
    centred : whether it looks as far ahead as back, and has one head instead of one for each look-ahead.
    """

    def __init__(self, width: int, dilations: tuple[int, ...], dropout: float, *, centred: bool = False) -> None:
        super().__init__()
        first = DilatedLayer(N_BANDS, width, 1, centred=centred, dropout=0.0)
        others = [DilatedLayer(width, width, d, centred=centred, dropout=dropout) for d in dilations]
        self.layers = nn.Sequential(first, *others)
        self.centred = centred
        shares = np.ones(1, np.float32) if centred else HEAD_SHARES
        self.shares: tuple[float, ...] = tuple((shares / shares.sum()).tolist())
        self.heads = nn.Linear(width, len(shares) * N_CLASSES)
        nn.init.normal_(self.heads.weight, 0, math.sqrt(1 / width))
        nn.init.zeros_(self.heads.bias)

    @property
    def matrices(self) -> list[nn.Parameter]:
        """The weights between hidden layers."""
        return [layer.weights for layer in list(self.layers)[1:] if isinstance(layer, DilatedLayer)]

    def hidden(self, logarithms: Tensor) -> Tensor:
        """Return what the last layer finds, shape (n_batch, n_frames, width)."""
        found: Tensor = self.layers(((logarithms - MEAN) / SPREAD).transpose(1, 2)).transpose(1, 2)
        return found

    @override
    def forward(self, hidden: Tensor) -> Tensor:
        """Return the logits of all heads, shape (n_batch, n_frames, n_heads, 26)."""
        logits: Tensor = self.heads(hidden)
        return logits.view(*hidden.shape[:2], len(self.shares), N_CLASSES)

    def finished(self) -> Model:
        """Return the model as the engine runs it, rounded to what its file holds."""
        layers = [layer.finished() for layer in self.layers if isinstance(layer, DilatedLayer)]
        scaled = layers[0].weights / np.float32(SPREAD)
        layers[0] = Layer(scaled, layers[0].bias - np.float32(MEAN) * scaled.sum(axis=0), layers[0].dilation)
        weights = _array(self.heads.weight).reshape(len(self.shares), N_CLASSES, -1)
        bias = _array(self.heads.bias).reshape(len(self.shares), N_CLASSES)
        heads, viseme_heads = (
            tuple(OutputHead(np.ascontiguousarray(w[part].T), b[part]) for w, b in zip(weights, bias, strict=True))
            for part in (slice(0, N_PHONEMES), slice(N_PHONEMES, N_CLASSES))
        )
        return Model(tuple(layers), heads, viseme_heads=viseme_heads, centred=self.centred).rounded()


def _array(values: Tensor) -> Float32Array:
    return np.ascontiguousarray(values.detach().float().cpu().numpy())


# The lower layers of Whisper's encoder (A. Radford et al., arXiv:2212.04356), and their causal form.

N_HEADS = 8


class AttentionLayer(nn.Module):
    """A layer of a transformer that normalises first (R. Xiong et al., arXiv:2002.04745).

    Parameters
    ----------
    dropout : share of what it adds that is dropped.
    """

    def __init__(self, dropout: float) -> None:
        super().__init__()
        self.norm, self.ffn_norm = nn.LayerNorm(N_STATES), nn.LayerNorm(N_STATES)
        self.qkv, self.out = nn.Linear(N_STATES, 3 * N_STATES), nn.Linear(N_STATES, N_STATES)
        self.widen, self.narrow = nn.Linear(N_STATES, 4 * N_STATES), nn.Linear(4 * N_STATES, N_STATES)
        self.relative_bias = nn.Parameter(torch.zeros(N_HEADS, BACK + 2))
        self.dropout = nn.Dropout(dropout)

    def scores(self, states: Tensor) -> tuple[Tensor, Tensor]:
        """Return the attention scores, shape (n_batch, 8, n, n), and the values, (n_batch, 8, n, 64)."""
        parts: Tensor = self.qkv(self.norm(states))
        query, key, value = parts.view(*states.shape[:2], 3, N_HEADS, -1).permute(2, 0, 3, 1, 4)
        return query @ key.transpose(2, 3) / math.sqrt(query.shape[3]), value

    @override
    def forward(self, states: Tensor, bias: Tensor | None) -> Tensor:
        """Return the states after the layer; `bias`, shape (8, n, n), is added to the scores."""
        scores, value = self.scores(states)
        shares = (scores if bias is None else scores + bias).softmax(dim=3)
        found: Tensor = self.dropout(self.out((shares @ value).transpose(1, 2).flatten(2)))
        states = states + found
        found = self.dropout(self.narrow(functional.gelu(self.widen(self.ffn_norm(states)))))
        return states + found


_NAMES = {
    "self_attention/layer_norm": "norm",
    "self_attention/linear_0": "qkv",
    "self_attention/linear_1": "out",
    "ffn/layer_norm": "ffn_norm",
    "ffn/linear_0": "widen",
    "ffn/linear_1": "narrow",
}
"""Parts of a layer by their names in Whisper's file."""


class TrainableEncoder(nn.Module):
    """The convolutions and the lower layers of Whisper's encoder, from its weights.

    As they come they use absolute positions and attend to everything. After `make_causal` the positions are
    relative, so that all places of an endless sound are alike, and a state attends to 3 s before it and, in the
    first layer, to one state after it at most.

    Parameters
    ----------
    weights : by their names in Whisper's file, without ``encoder/``.
    n_layers : how many layers are kept.
    dropout : share of what each layer adds that is dropped.
    """

    def __init__(self, weights: Mapping[str, Float32Array], n_layers: int, dropout: float = 0.0) -> None:
        super().__init__()
        self.conv1 = nn.Conv1d(N_MELS, N_STATES, 3)
        self.conv2 = nn.Conv1d(N_STATES, N_STATES, 3, stride=2)
        self.layers = nn.ModuleList([AttentionLayer(dropout) for _ in range(n_layers)])
        self.positions = nn.Parameter(torch.zeros(1, N_STATES))
        self.norm = nn.LayerNorm(N_STATES)
        self.head = nn.Linear(N_STATES, HALVES * N_CLASSES)
        self.causal = False
        self.load(weights)

    @property
    def _attention(self) -> list[AttentionLayer]:
        return [layer for layer in self.layers if isinstance(layer, AttentionLayer)]

    def _parameters_by_name(self) -> dict[str, nn.Parameter]:
        parts: dict[str, nn.Conv1d | nn.Linear | nn.LayerNorm] = {"conv1": self.conv1, "conv2": self.conv2}
        for k, layer in enumerate(self._attention):
            parts |= {f"layer_{k}/{name}": getattr(layer, ours) for name, ours in _NAMES.items()}
        if self.causal:
            parts |= {"layer_norm": self.norm, "head": self.head}
        found: dict[str, nn.Parameter] = {}
        for name, part in parts.items():
            kinds = ("gamma", "beta") if isinstance(part, nn.LayerNorm) else ("weight", "bias")
            assert part.bias is not None
            found |= {f"{name}/{kinds[0]}": nn.Parameter(part.weight), f"{name}/{kinds[1]}": nn.Parameter(part.bias)}
        if self.causal:
            found["position_encodings/encodings"] = self.positions
            for k, layer in enumerate(self._attention):
                found[f"layer_{k}/self_attention/relative_bias"] = layer.relative_bias
        return found

    def load(self, weights: Mapping[str, Float32Array]) -> None:
        """Take weights by their names."""
        self.positions = nn.Parameter(torch.tensor(weights["position_encodings/encodings"]))
        with torch.no_grad():
            for name, parameter in self._parameters_by_name().items():
                parameter.copy_(torch.tensor(weights[name]))

    def become_causal(self, weights: Mapping[str, Float32Array]) -> None:
        """Take the weights of a causal encoder, as `finished` gives them."""
        self.causal = True
        self.load(weights)

    def finished(self) -> dict[str, Float32Array]:
        """Return the weights by their names, as float32."""
        return {name: _array(parameter) for name, parameter in self._parameters_by_name().items()}

    def embed(self, mels: Tensor) -> Tensor:
        """Return what the convolutions make of mel bands (n_batch, n_frames, 80), (n_batch, n_frames / 2, 512)."""
        # two frames more on both sides, so that a state of the middle and one of the edge see as many
        padded = torch.cat((mels[:, :1].expand(-1, 2, -1), mels, mels[:, -1:]), dim=1).transpose(1, 2)
        found: Tensor = functional.gelu(self.conv2(functional.gelu(self.conv1(padded)))).transpose(1, 2)
        return found

    def states(self, mels: Tensor, n_ahead: int = 1) -> Tensor:
        """Return the states after the last layer, shape (n_batch, n_frames / 2, 512).

        Parameters
        ----------
        mels : as Whisper has them, shape (n_batch, n_frames, 80), an even number of frames.
        n_ahead : states that the first layer of the causal form looks ahead, 0 or 1.
        """
        states = self.embed(mels)
        n = states.shape[1]
        states = states + (self.positions if self.causal else self.positions[:n])
        for k, layer in enumerate(self._attention):
            bias = _relative(layer.relative_bias, n, n_ahead if k == 0 else 0) if self.causal else None
            states = layer(states, bias)
        return states

    @override
    def forward(self, states: Tensor) -> Tensor:
        """Return the logits of the phonemes and visemes, shape (n_batch, n_frames, 26)."""
        logits: Tensor = self.head(self.norm(states))
        return logits.reshape(len(logits), -1, N_CLASSES)

    @torch.no_grad()
    def make_causal(self, mels: Tensor) -> None:
        """Replace the absolute positions by a constant vector and by biases of the scores for each distance.

        The biases are what the absolute positions add to the scores in a sample of speech, on average.

        Parameters
        ----------
        mels : the sample, shape (n_batch, n_frames, 80), at least 3 s long.
        """
        embedded = self.embed(mels)
        n = embedded.shape[1]
        constant = self.positions.mean(dim=0, keepdim=True)
        placed, unplaced = embedded + self.positions[:n], embedded + constant
        keys = torch.arange(n, device=mels.device)
        columns = keys[None, :] - keys[:, None] + BACK
        for layer in self._attention:
            added = (layer.scores(placed)[0] - layer.scores(unplaced)[0]).mean(dim=0)
            for column in range(BACK + 2):
                if (columns == column).any():
                    layer.relative_bias[:, column] = added[:, columns == column].mean(dim=1)
            placed = layer(placed, None)
            unplaced = layer(unplaced, _relative(layer.relative_bias, n, 1))
        self.positions = nn.Parameter(constant)
        self.causal = True


def _relative(biases: Tensor, n: int, n_ahead: int) -> Tensor:
    """Return what is added to the scores of n queries and keys, shape (8, n, n): minus infinity out of reach."""
    places = torch.arange(n, device=biases.device)
    columns = places[None, :] - places[:, None] + BACK
    hidden = (columns < 0) | (columns > BACK + n_ahead)
    return biases[:, columns.clamp(0, BACK + 1)].masked_fill(hidden, -torch.inf)


def with_running_floor(logarithms: Tensor, start: Tensor) -> Tensor:
    """Return mel bands as the encoder takes them, cut off below a peak that runs with the sound.

    Parameters
    ----------
    logarithms : of the powers, to the base 10, shape (n_batch, n_frames, 80).
    start : the peak before the first frame, shape (n_batch, 1).
    """
    # peak_t = max(loudest band, peak_(t-1) - fall): a running maximum of what rises by the fall in each frame
    rise = PEAK_FALL * torch.arange(1, logarithms.shape[1] + 1, device=logarithms.device)
    loudest = torch.cat((start, logarithms.amax(dim=2) + rise), dim=1).cummax(dim=1).values[:, 1:]
    peaks = (loudest - rise).clamp(min=LEAST_PEAK)
    return (torch.maximum(logarithms, peaks[:, :, None] - DYNAMIC_RANGE) + 4) / 4


class HeadNetwork(nn.Module):
    """The head of `phonemeengine.encoder.head`: one hidden layer on neighbouring, projected states."""

    def __init__(self, n_in: int, n_hidden: int, dropout: float) -> None:
        super().__init__()
        self.hidden, self.out = nn.Linear(n_in, n_hidden), nn.Linear(n_hidden, HALVES * N_CLASSES)
        self.dropout = nn.Dropout(dropout)
        for layer, gain in ((self.hidden, 2), (self.out, 1)):
            nn.init.normal_(layer.weight, 0, math.sqrt(gain / layer.in_features))
            nn.init.zeros_(layer.bias)

    @override
    def forward(self, inputs: Tensor) -> Tensor:
        """Return the logits of both halves of each state, shape (n, 2, 26)."""
        logits: Tensor = self.out(self.dropout(functional.relu(self.hidden(inputs))))
        return logits.view(-1, HALVES, N_CLASSES)

    def finished(self) -> list[Float32Array]:
        """Return weights and bias of the hidden layer, then of the outputs, as the engine has them."""
        return [
            _array(self.hidden.weight.T),
            _array(self.hidden.bias),
            _array(self.out.weight.T),
            _array(self.out.bias),
        ]
