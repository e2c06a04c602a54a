"""A trained model and its file: arrays in an ``.npz``, never anything that is executed."""

import json
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from typing_extensions import override

from phonemeengine.arrays import Float32Array, ShortRepr
from phonemeengine.dsp.mel import N_BANDS
from phonemeengine.encoder.head import HALVES, N_OUTPUTS
from phonemeengine.encoder.live import LiveHead
from phonemeengine.errors import ModelError
from phonemeengine.labels.visemes import STANDARD_VISEMES, VisemeSet
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.network import TAPS, Layer
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.storage.files import arrays_in_npz, atomic_write, reason_of

FORMAT = 4
"""The version of the file's layout; a newer one is refused. The first knew no visemes, the second no centred ones,
the third no visemes of its own."""
LARGEST_FILE = 8 << 20
MOST_LAYERS, MOST_CHANNELS, MOST_DILATION = 32, 1024, 256
MOST_WARPS, LEAST_WARP, MOST_WARP = 8, 0.5, 2.0
HEAD, VISEME_HEAD = "head", "viseme_head"
"""What the names of the arrays of heads begin with."""
MOST_FRAMES_AHEAD = 5
"""Frames of 10 ms that the longest look-ahead of a causal model has."""
MOST_FRAMES_AROUND = 100
"""Frames of 10 ms that a centred model uses before and after each, at most."""


@dataclass(frozen=True, repr=False)
class OutputHead(ShortRepr):
    """Turns what the network found into a score for each phoneme.

    Attributes
    ----------
    weights : float32, shape (n_channels, n_classes): of the phonemes, or of the visemes.
    bias : float32, shape (n_classes,).
    """

    weights: Float32Array
    bias: Float32Array


class LookAheadFigures(NamedTuple):
    """How well a model recognised speakers whom it did not learn from, looking ahead so far; shares, 0..1.

    Attributes
    ----------
    macro_f1 : mean over the phonemes of the harmonic mean of precision and recall.
    mouth_shapes : share of frames with the right mouth shape.
    """

    macro_f1: float
    mouth_shapes: float


def figures_by_look_ahead(about: dict[str, Any]) -> dict[int, LookAheadFigures]:
    """Return what a model's words tell of how well it recognises, by the frames of 10 ms that it looks ahead."""
    try:
        told = about.get("by_look_ahead_ms", {}).items()
        return {round(float(ms) / 1000 / FRAME_PERIOD): LookAheadFigures(*map(float, f)) for ms, f in told}
    except (AttributeError, TypeError, ValueError):  # words for people, in which anything may stand
        return {}


@dataclass(frozen=True, eq=False, repr=False)
class Model(ShortRepr):
    """What a learned recogniser knows; two models are equal if their arrays are.

    Attributes
    ----------
    layers : the network.
    heads : one for each look-ahead, 0, 1, ... frames.
    warps : of the mel bands, as if the speaker's vocal tract were shorter (above 1) or longer; the answers for
        each are mixed, see `phonemeengine.recognition.learned`.
    anchors : excerpts of the speech that it was trained on, as `phonemeengine.dsp.mel` gives it,
        shape (n, n_frames, 40), so that an adaptation to one voice does not forget them; may be empty.
    about : what it was trained with, in words, for people: name, speakers, seed, figures.
    viseme_heads : the same as `heads` for the visemes of its set; empty where it knows none.
    centred : whether it has as much context after a frame as before, for whole files; it has one head then.
    viseme_set : the visemes that it tells apart.
    live_head : what the real-time model learned of the same voice; None where it learned none.
    """

    layers: tuple[Layer, ...]
    heads: tuple[OutputHead, ...]
    warps: tuple[float, ...] = (1.0,)
    anchors: Float32Array = field(default_factory=lambda: np.zeros((0, 0, N_BANDS), np.float32))
    about: dict[str, Any] = field(default_factory=dict)
    viseme_heads: tuple[OutputHead, ...] = ()
    centred: bool = False
    viseme_set: VisemeSet = STANDARD_VISEMES
    live_head: LiveHead | None = None

    def frames_ahead(self, look_ahead: float) -> int:
        """Return for how many frames after a frame it waits, where it may wait for this many seconds.

        A centred model always waits for the sum of its dilations.
        """
        if self.centred:
            return sum(layer.dilation for layer in self.layers)
        return min(int(look_ahead / FRAME_PERIOD + 1e-6), len(self.heads) - 1)

    @cached_property
    def by_look_ahead(self) -> dict[int, LookAheadFigures]:
        """How well it recognises, by the frames of 10 ms that it looks ahead; empty where that was not measured."""
        return figures_by_look_ahead(self.about)

    @cached_property
    def digest(self) -> str:
        """A fingerprint of the arrays."""
        hashed = sha256()
        for name, array in sorted(arrays_of_model(self).items()):
            hashed.update(name.encode() + array.tobytes())
        return hashed.hexdigest()

    def rounded(self) -> "Model":
        """Return the model with the precision of its file, so that saving it changes nothing."""
        layers = tuple(Layer(_halved(layer.weights), layer.bias, layer.dilation) for layer in self.layers)
        heads, viseme_heads = (
            tuple(OutputHead(_halved(h.weights), h.bias) for h in known) for known in (self.heads, self.viseme_heads)
        )
        live_head = self.live_head and replace(self.live_head, weights=_halved(self.live_head.weights))
        anchors = _halved(self.anchors)
        return replace(
            self, layers=layers, heads=heads, viseme_heads=viseme_heads, anchors=anchors, live_head=live_head
        )

    @override
    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and self.digest == other.digest

    @override
    def __hash__(self) -> int:
        return hash(self.digest)


def save_model(model: Model, path: Path) -> None:
    """Write a model's file: weights as float16, whose rounding changes almost no answer.

    The old file stays until the new one is complete.

    Raises
    ------
    ModelError : it cannot be written.
    """
    about = np.frombuffer(json.dumps(model.about, sort_keys=True).encode(), np.uint8)
    try:
        with atomic_write(path) as file:
            np.savez_compressed(file, allow_pickle=False, about=about, **arrays_of_model(model))
    except OSError as error:
        raise ModelError(f"{path.name}: cannot be written ({reason_of(error)}); choose another folder") from error


def load_model(path: Path) -> Model:
    """Read a model's file.

    Raises
    ------
    ModelError : the file cannot be read, is damaged, is of a newer version, or holds what no model has.
    """
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise ModelError(
                f"{path.name}: a model is smaller than 8 MB, this has {path.stat().st_size / 1e6:.0f} MB; "
                "choose another"
            )
        return _model_in(path.read_bytes())
    except OSError as error:
        raise ModelError(
            f"{path.name}: the model cannot be read ({reason_of(error)}); put it beside its preset"
        ) from error
    except ModelError as error:
        raise ModelError(f"{path.name}: {str(error).removeprefix(path.name + ': ')}") from error
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError) as error:
        raise ModelError(f"{path.name}: the model's file is damaged; get it anew, or train it again") from error


@lru_cache(maxsize=4)  # many presets share theirs, and the same preset is read again and again
def _model_in(content: bytes) -> Model:
    return model_of_arrays(arrays_in_npz(content, LARGEST_FILE))


def arrays_of_model(model: Model) -> dict[str, NDArray[Any]]:
    """Return the arrays of a model's file, but for its words."""
    arrays: dict[str, NDArray[Any]] = {
        "format": np.array(_format_of(model)),
        "dilations": np.array([layer.dilation for layer in model.layers]),
        "n_heads": np.array(len(model.heads)),
        "warps": np.array(model.warps),
        "anchors": model.anchors.astype(np.float16),
        **({"centred": np.array(True)} if model.centred else {}),
    }
    if model.viseme_set != STANDARD_VISEMES:
        arrays["viseme_set"] = np.frombuffer(model.viseme_set.to_json().encode(), np.uint8)
    for k, layer in enumerate(model.layers):
        arrays[f"layer_{k}_weights"] = layer.weights.astype(np.float16)
        arrays[f"layer_{k}_bias"] = layer.bias.astype(np.float32)
    for name, heads in ((HEAD, model.heads), (VISEME_HEAD, model.viseme_heads)):
        for k, head in enumerate(heads):
            arrays[f"{name}_{k}_weights"] = head.weights.astype(np.float16)
            arrays[f"{name}_{k}_bias"] = head.bias.astype(np.float32)
    if model.live_head is not None:
        arrays["live_head_weights"] = model.live_head.weights.astype(np.float16)
        arrays["live_head_bias"] = model.live_head.bias.astype(np.float32)
        arrays["live_head_origin"] = np.frombuffer(model.live_head.origin.encode(), np.uint8)
        if model.live_head.warp != 1:
            arrays["live_head_warp"] = np.array([model.live_head.warp])
    return arrays


def _format_of(model: Model) -> int:
    """Return the lowest version that can say what a model is, so that older programs read what they can."""
    if model.viseme_set != STANDARD_VISEMES:
        return 4
    return 3 if model.centred else 2 if model.viseme_heads else 1


def model_of_arrays(arrays: dict[str, NDArray[Any]]) -> Model:
    """Return the model whose file has some arrays.

    Raises
    ------
    ModelError, ValueError, KeyError : they are none of a model.
    """
    if not 1 <= int(arrays["format"]) <= FORMAT:
        raise ModelError(
            f"the model is of version {int(arrays['format'])}, and this program reads those up to {FORMAT}; "
            "update the program, or train the model again"
        )
    # Sizes are checked before anything is built from them: the file may come from anywhere.
    dilations, n_heads = arrays["dilations"], int(arrays["n_heads"])
    if not (0 < len(dilations) <= MOST_LAYERS and 0 < n_heads <= MOST_FRAMES_AHEAD + 1):
        raise ModelError(f"a model has 1..{MOST_LAYERS} layers and 1..{MOST_FRAMES_AHEAD + 1} heads; get it anew")
    if not np.all((dilations >= 1) & (dilations <= MOST_DILATION)):
        raise ModelError(f"its dilations must lie in 1..{MOST_DILATION} frames; get it anew")
    width, layers = N_BANDS, []
    for k, dilation in enumerate(dilations):
        bias = _checked(arrays[f"layer_{k}_bias"], (None,))
        layers.append(Layer(_checked(arrays[f"layer_{k}_weights"], (TAPS * width, len(bias))), bias, int(dilation)))
        if k and len(bias) != width:
            raise ModelError("its layers do not fit together; get it anew")
        width = len(bias)
    heads = _heads_of(arrays, HEAD, n_heads, (width, len(Phoneme)))
    knows_visemes = f"{VISEME_HEAD}_0_weights" in arrays
    viseme_set = STANDARD_VISEMES
    if "viseme_set" in arrays:
        viseme_set = VisemeSet.from_json(arrays["viseme_set"].tobytes().decode())
    n_visemes = len(viseme_set.names)
    viseme_heads = _heads_of(arrays, VISEME_HEAD, n_heads, (width, n_visemes)) if knows_visemes else ()
    anchors = _checked(arrays["anchors"], (None, None, N_BANDS))
    about = _about_of(arrays["about"])
    centred = bool(arrays.get("centred", False))
    if centred and (n_heads > 1 or dilations.sum() > MOST_FRAMES_AROUND):
        raise ModelError(f"a centred model has one head and uses {MOST_FRAMES_AROUND} frames around; get it anew")
    # Weights are float16 in the file, half the size; they are worked on as float32, which processors are faster at.
    return Model(
        tuple(layers),
        heads,
        _warps_of(arrays["warps"]),
        anchors,
        about,
        viseme_heads,
        centred,
        viseme_set,
        _live_head_of(arrays),
    )


def _heads_of(
    arrays: dict[str, NDArray[Any]], name: str, n_heads: int, shape: tuple[int, int]
) -> tuple[OutputHead, ...]:
    return tuple(
        OutputHead(_checked(arrays[f"{name}_{k}_weights"], shape), _checked(arrays[f"{name}_{k}_bias"], shape[1:]))
        for k in range(n_heads)
    )


def _live_head_of(arrays: dict[str, NDArray[Any]]) -> LiveHead | None:
    if "live_head_origin" not in arrays:
        return None
    n = HALVES * N_OUTPUTS
    weights, bias = _checked(arrays["live_head_weights"], (None, n)), _checked(arrays["live_head_bias"], (n,))
    warp = _warps_of(arrays.get("live_head_warp", np.ones(1)))[0]
    return LiveHead(weights, bias, arrays["live_head_origin"].tobytes().decode(), warp)


def _warps_of(array: NDArray[Any]) -> tuple[float, ...]:
    known = array.dtype.kind == "f" and array.ndim == 1 and 0 < len(array) <= MOST_WARPS
    if not (known and np.all((array >= LEAST_WARP) & (array <= MOST_WARP))):
        raise ModelError(f"a model has 1..{MOST_WARPS} warps of {LEAST_WARP:g}..{MOST_WARP:g}; get it anew")
    return tuple(array.tolist())


def _halved(array: Float32Array) -> Float32Array:
    return array.astype(np.float16).astype(np.float32)


def _checked(array: NDArray[Any], shape: tuple[int | None, ...]) -> Float32Array:
    """Return an array as float32, after looking at its shape and its numbers."""
    fits = array.ndim == len(shape) and all(n in (None, m) for n, m in zip(shape, array.shape, strict=True))
    known = array.dtype in {np.dtype(np.float16), np.dtype(np.float32)}
    if not (fits and known and array.size <= MOST_CHANNELS**2 * TAPS and np.all(np.isfinite(array))):
        raise ModelError("its arrays do not fit together; get it anew, or train it again")
    checked = array.astype(np.float32)
    checked.flags.writeable = False  # all who read the file have the same array
    return checked


def _about_of(array: NDArray[Any]) -> dict[str, Any]:
    about = json.loads(array.tobytes())
    return about if isinstance(about, dict) else {}
