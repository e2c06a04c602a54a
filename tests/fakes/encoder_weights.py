"""Random weights of a small encoder, and what it makes of mel frames, written down once more with NumPy alone."""

import numpy as np
from scipy.special import erf

N_CLASSES = 26


def encoder_weights(
    n_layers: int = 2, n_channels: int = 128, seed: int = 1, n_positions: int = 1
) -> dict[str, np.ndarray]:
    """Draw the weights of an encoder, named as the graphs want them; one position is for live sound."""
    chance = np.random.default_rng(seed)

    def draw(*shape: int) -> np.ndarray:
        fan = np.prod(shape[1:]) if len(shape) > 1 else 100
        return chance.normal(0, fan**-0.5, shape).astype(np.float32)

    def linear(name: str, n_out: int, n_in: int) -> dict[str, np.ndarray]:
        return {f"{name}/weight": draw(n_out, n_in), f"{name}/bias": draw(n_out)}

    def norm(name: str) -> dict[str, np.ndarray]:
        return {f"{name}/gamma": 1 + draw(n_channels), f"{name}/beta": draw(n_channels)}

    weights = {"conv1/weight": draw(n_channels, 80, 3), "conv1/bias": draw(n_channels)}
    weights |= {"conv2/weight": draw(n_channels, n_channels, 3), "conv2/bias": draw(n_channels)}
    weights["position_encodings/encodings"] = draw(n_positions, n_channels)
    for k in range(n_layers):
        name = f"layer_{k}/self_attention"
        weights |= norm(f"{name}/layer_norm") | linear(f"{name}/linear_0", 3 * n_channels, n_channels)
        weights |= linear(f"{name}/linear_1", n_channels, n_channels)
        weights[f"{name}/relative_bias"] = chance.normal(0, 1, (n_channels // 64, 152)).astype(np.float32)
        name = f"layer_{k}/ffn"
        weights |= norm(f"{name}/layer_norm") | linear(f"{name}/linear_0", 2 * n_channels, n_channels)
        weights |= linear(f"{name}/linear_1", n_channels, 2 * n_channels)
    return weights | norm("layer_norm") | linear("head", 2 * N_CLASSES, n_channels)


def reference_states(weights: dict[str, np.ndarray], mel: np.ndarray, ahead: int | None) -> np.ndarray:
    """Return the states of mel frames, shape (80, n): whole where `ahead` is None, else causal, from frame 2 on."""
    live = ahead is not None
    hidden = _gelu(_convolve(weights, "conv1", mel if live else np.pad(mel, ((0, 0), (1, 1))), 1))
    x = _gelu(_convolve(weights, "conv2", hidden if live else np.pad(hidden, ((0, 0), (1, 1))), 2)).T
    x = x + weights["position_encodings/encodings"][: len(x)]
    distance = np.arange(len(x)) - np.arange(len(x))[:, np.newaxis]
    for k in range(sum(name.endswith("ffn/linear_0/bias") for name in weights)):
        last = ahead if live and k == 0 else 0
        bias = 0
        if live:
            columns = np.clip(distance + 150, 0, 151)
            seen = (distance >= -150) & (distance <= last)
            bias = np.where(seen, weights[f"layer_{k}/self_attention/relative_bias"][:, columns], -np.inf)
        x = x + _attend(weights, f"layer_{k}/self_attention", x, bias)
        hidden = _gelu(_linear(weights, f"layer_{k}/ffn/linear_0", _norm(weights, f"layer_{k}/ffn/layer_norm", x)))
        x = x + _linear(weights, f"layer_{k}/ffn/linear_1", hidden)
    return _norm(weights, "layer_norm", x) if "layer_norm/gamma" in weights else x


def reference_logits(weights: dict[str, np.ndarray], mel: np.ndarray, ahead: int) -> np.ndarray:
    """Return the outputs of the live encoder, shape (2 x n_states, 26)."""
    return _linear(weights, "head", reference_states(weights, mel, ahead)).reshape(-1, N_CLASSES)


def _convolve(weights, name, frames, step):
    weight = weights[f"{name}/weight"]
    n = (frames.shape[1] - 3) // step + 1
    taps = [weight[:, :, k] @ frames[:, k : k + step * (n - 1) + 1 : step] for k in range(3)]
    return sum(taps) + weights[f"{name}/bias"][:, np.newaxis]


def _gelu(x):
    return x * (1 + erf(x / np.sqrt(2))) / 2


def _norm(weights, name, x):
    centred = x - x.mean(axis=1, keepdims=True)
    spread = np.sqrt((centred**2).mean(axis=1, keepdims=True) + 1e-5)
    return centred / spread * weights[f"{name}/gamma"] + weights[f"{name}/beta"]


def _linear(weights, name, x):
    return x @ weights[f"{name}/weight"].T + weights[f"{name}/bias"]


def _attend(weights, name, x, bias):
    both = _linear(weights, f"{name}/linear_0", _norm(weights, f"{name}/layer_norm", x))
    q, k, v = (part.reshape(len(x), -1, 64).transpose(1, 0, 2) for part in np.split(both, 3, axis=1))
    scores = q @ k.transpose(0, 2, 1) / 8 + bias
    shares = np.exp(scores - scores.max(axis=2, keepdims=True))
    shares /= shares.sum(axis=2, keepdims=True)
    return _linear(weights, f"{name}/linear_1", (shares @ v).transpose(1, 0, 2).reshape(len(x), -1))
