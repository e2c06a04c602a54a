"""A face that follows the sound alone: the small network of speech, and an output layer for blend shapes.

The layers of the network that recognises phonemes turn log-mel bands into states that hold what matters of speech.
A linear layer from the states of three frames to the weights of a face is learned from recorded performances, by
ridge regression (A. Hoerl and R. Kennard, "Ridge Regression: Biased Estimation for Nonorthogonal Problems",
Technometrics 12(1), 1970): solved exactly, in seconds, without chance. Regression tends to the mean where it is
unsure, which would leave lips ajar that must close. So where the network recognises a closure, the weights move to
the mean pose that the recorded face has there.
"""

import json
import math
import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from typing_extensions import override

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array, ShortRepr
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.mel import log_mels, silent_log_mels
from phonemeengine.encoder.head import softmax
from phonemeengine.errors import EngineError, ModelError
from phonemeengine.mouth.animation import MovementTrack
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.performer import CLOSE_AFTER
from phonemeengine.mouth.table import MouthTable
from phonemeengine.performance.driver import FACE, MOUTH
from phonemeengine.performance.track import face_table
from phonemeengine.recognition.model import LARGEST_FILE, Model, arrays_of_model, model_of_arrays
from phonemeengine.recognition.network import Network
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, WINDOW
from phonemeengine.storage.files import printable_name, read_npz, why_unreadable
from phonemeengine.storage.replacing import Guard, guarded_write

FORMAT = 1
LIVE, WHOLE = 0, 10
"""Frames of 10 ms for which an answer waits: in live sound, and in sounds that are wholly known."""
LAGS = np.array([0, 8, 16])
"""How many frames lie between the newest state and those that an answer is made of."""
REACH = int(LAGS[-1])
CLOSURES = {"PP": "bilabial", "FF": "labiodental"}
"""Visemes whose contact must be seen, and the class of the phones that make it."""
FADE = 0.1
"""Seconds in which the face comes to rest where no sound follows."""
KEPT = 200
"""Frames of live sound that are remembered."""
NAMED = 3
"""Blend shapes that a note names."""


class FaceLayer(NamedTuple):
    """Turns states into the weights of a face: float32, shapes (3 x n_states, n_channels) and (n_channels,)."""

    weights: Float32Array
    bias: Float32Array


@dataclass(frozen=True, eq=False, repr=False)
class FaceNetwork(ShortRepr):
    """What a face does by a sound, as it was learned from recorded performances.

    Attributes
    ----------
    trunk : whose layers turn the sound into states, and which tells visemes.
    channels : the blend shapes that it moves.
    layers : the output layer by the frames that an answer waits, `LIVE` or `WHOLE`.
    poses : float32, shape (2, n_channels): the face at the closures of `CLOSURES`; NaN where none was recorded.
    about : who performed, in words, and how far the network is off, for people.
    """

    trunk: Model
    channels: tuple[str, ...]
    layers: dict[int, FaceLayer]
    poses: Float32Array
    about: dict[str, Any]

    @property
    def synthetic(self) -> bool:
        """Whether no person moved, but a model of one."""
        return bool(self.about.get("synthetic"))

    @property
    def name(self) -> str:
        """What it is called."""
        return str(self.about.get("name", "face"))

    @property
    def title(self) -> str:
        """What it is called below a face."""
        return f"{self.name} (network, synthetic performer)" if self.synthetic else f"{self.name} (network)"

    @property
    def notes(self) -> tuple[str, ...]:
        """What it lacks, a sentence each."""
        open_lips = [name for name, pose in zip(CLOSURES.values(), self.poses, strict=True) if np.isnan(pose[0])]
        unmoved = [name for name in ARKIT if name.startswith(MOUTH) and name not in self.channels]
        some = ", ".join(unmoved[:NAMED]) + (f" and {len(unmoved) - NAMED} more" if len(unmoved) > NAMED else "")
        return (
            *(f"no recording of the network has a {name} sound, so lips may stay apart there" for name in open_lips),
            *((f"the network does not move {some}",) if unmoved else ()),
        )

    @cached_property
    def columns(self) -> list[int]:
        """Where its channels are in `FACE`."""
        return [FACE.index(name) for name in self.channels]


class StateReader:
    """Runs the layers of a trunk over a stream of frames.

    Parameters
    ----------
    trunk : whose layers they are.
    ahead : frames that an answer waits.
    """

    def __init__(self, trunk: Model, ahead: int) -> None:
        self._network = Network(trunk.layers, silent_log_mels(1))
        self._seen = np.zeros((REACH, len(trunk.layers[-1].bias)), np.float32)
        self._n_early = ahead  # answers to the first frames would be about what lay before the sound
        self._head = min(ahead, len(trunk.viseme_heads) - 1)
        self._behind = ahead - self._head
        self._visemes = trunk.viseme_heads[self._head]
        self._columns = [trunk.viseme_set.names.index(name) for name in CLOSURES]

    def follow(self, windows: Float32Array) -> tuple[Float32Array, Float32Array]:
        """Take the next frames; return the states and the closures of those that have an answer now.

        Returns
        -------
        The states, float32, shape (n, 3 x n_states), and how likely each of `CLOSURES` is, shape (n, 2).
        """
        states = self._network.forward(log_mels(windows)[:, np.newaxis])[:, 0]
        seen = np.concatenate((self._seen, states))
        self._seen = seen[-REACH:]
        n_early = min(self._n_early, len(states))
        self._n_early -= n_early
        newest = np.arange(REACH + n_early, len(seen))
        scores = seen[newest - self._behind] @ self._visemes.weights + self._visemes.bias
        states = seen[newest[:, np.newaxis] - LAGS].reshape(len(newest), len(LAGS) * seen.shape[1])
        return states, softmax(scores)[:, self._columns]


def knows_closures(trunk: Model) -> bool:
    """Return whether a trunk answers as the sound comes, and tells the visemes of `CLOSURES`."""
    return not trunk.centred and bool(trunk.viseme_heads) and {*CLOSURES} <= {*trunk.viseme_set.names}


class FaceFollower:
    """Moves a face by a stream of frames; the answers do not depend on the size of the chunks.

    Parameters
    ----------
    network : what was learned.
    ahead : frames that an answer waits, `LIVE` or `WHOLE`.
    """

    def __init__(self, network: FaceNetwork, ahead: int = LIVE) -> None:
        self._network, self._states = network, StateReader(network.trunk, ahead)
        self._layer = network.layers[ahead]

    def follow(self, windows: Float32Array) -> Float32Array:
        """Take the next frames, shape (n, 2048), and return the weights of those that have an answer now.

        Returns
        -------
        float32, shape (n_answers, n_channels), 0..1, a frame each 10 ms.
        """
        if not len(windows):
            return np.zeros((0, len(self._network.channels)), np.float32)
        states, closed = self._states.follow(windows)
        weights = states @ self._layer.weights + self._layer.bias
        for share, pose in zip(closed.T[..., np.newaxis], self._network.poses, strict=True):
            if not np.isnan(pose[0]):
                weights += share * (pose - weights)
        found: Float32Array = np.clip(weights, 0, 1, out=weights)
        return found

    def listen(self, heard: Analysis) -> Float32Array:
        """Take the next block of a sound as it plays, and return the same; live sound does not wait for phonemes."""
        return self.follow(heard.arrived if len(heard.arrived) else heard.frames.windows)


class FaceFrames:
    """A `MouthTrack` of frames of 10 ms; beyond the last one the face comes to rest.

    Parameters
    ----------
    network : whose channels move.
    weights : float32, shape (n_frames, n_channels), of a whole sound.
    """

    movestates = FACE

    def __init__(self, network: FaceNetwork, weights: Float32Array | None = None) -> None:
        nothing = np.zeros((0, len(network.channels)), np.float32)
        self._network = network
        self._frames = 0.0, nothing if weights is None else weights  # one value, so that threads see both or neither

    def add(self, weights: Float32Array, end: float) -> None:
        """Take the next frames of live sound, of which the last one ends at a time of the performer's clock."""
        kept = np.concatenate((self._frames[1], weights))[-KEPT:]
        self._frames = end - len(kept) * FRAME_PERIOD, kept

    def clear(self) -> None:
        """Forget all frames."""
        self._frames = 0.0, self._frames[1][:0]

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (60,), 1 for the whole movement."""
        start, frames = self._frames
        found = np.zeros(len(FACE), np.float32)
        if len(frames):
            place = (time - start) / FRAME_PERIOD - 0.5  # a frame is shown at its middle
            first = min(max(math.floor(place), 0), len(frames) - 1)
            share = min(max(place - first, 0.0), 1.0)
            after = frames[min(first + 1, len(frames) - 1)]
            late = (place - len(frames)) * FRAME_PERIOD - CLOSE_AFTER
            left = 1 - min(max(late / FADE, 0.0), 1.0)
            found[self._network.columns] = left * ((1 - share) * frames[first] + share * after)
        return found

    def head(self, _time: float) -> HeadPose | None:
        """Return None: the head follows the sound."""
        return None


class FaceNetworkTrack(MovementTrack):
    """How a network moves a face by a whole sound.

    Parameters
    ----------
    network : what was learned.
    blocks : the sound, mono at 44.1 kHz, float32 within ±1, in order.
    """

    def __init__(self, network: FaceNetwork, blocks: Iterable[Float32Array]) -> None:
        follower = FaceFollower(network, WHOLE)
        weights = [follower.follow(windows) for windows in windows_of(blocks, WHOLE)]
        self._mouth = FaceFrames(network, np.concatenate(weights))

    @property
    @override
    def face(self) -> MouthTable:
        return face_table()

    @override
    def mouth(self) -> FaceFrames:
        return self._mouth


def windows_of(blocks: Iterable[Float32Array], ahead: int) -> Iterator[Float32Array]:
    """Return the frames of a sound, and silence after it, for which answers to its last frames wait."""
    framer = Framer()
    cut = (framer.cut_frames(block) for block in blocks)
    yield from (windows for windows in chain(cut, (framer.finish() for _ in range(1))) if len(windows))
    if ahead:
        yield np.zeros((ahead, WINDOW), np.float32)


# Files.


def save_face_network(network: FaceNetwork, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
    """Write a network's file, an archive of arrays that is never executed.

    Raises
    ------
    EngineError : another file is there, or it cannot be written.
    """
    arrays: dict[str, NDArray[Any]] = {
        "face_format": np.array(FORMAT),
        "face_channels": np.array(network.channels),
        "face_poses": network.poses.astype(np.float32),
        "about": np.frombuffer(json.dumps(network.about, sort_keys=True).encode(), np.uint8),
    }
    for ahead, layer in network.layers.items():
        arrays[f"face_{ahead}_weights"] = layer.weights.astype(np.float16)
        arrays[f"face_{ahead}_bias"] = layer.bias
    with guarded_write(Path(path), Guard(owns, overwrite)) as file:
        np.savez_compressed(file, allow_pickle=False, **arrays, **arrays_of_model(network.trunk))


def owns(content: bytes) -> bool:
    """Return whether the beginning of a file is that of such an archive, whose first array names the format."""
    return content.startswith(b"PK") and b"face_format.npy" in content[:64]


def load_face_network(path: str | os.PathLike[str]) -> FaceNetwork:
    """Read a network's file.

    Raises
    ------
    ModelError : the file cannot be read, is damaged, is of a newer version, or is no such file.
    """
    path = Path(path)
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise ModelError("a network of a face is smaller than 8 MB; choose another file")
        return _network_of(read_npz(path, 4 * LARGEST_FILE))
    except OSError as error:
        raise ModelError(f"{printable_name(path)}: {why_unreadable(path, error)}") from error
    except EngineError as error:
        raise ModelError(f"{printable_name(path)}: {error}") from error
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError) as error:
        raise ModelError(
            f"{printable_name(path)}: it is no network of a face, or damaged; learn one with "
            "`phonemeanalyser performance learn`"
        ) from error


def _network_of(arrays: dict[str, NDArray[Any]]) -> FaceNetwork:
    version = int(arrays["face_format"])
    if version != FORMAT:
        raise ModelError(f"the network is of version {version}, and this program reads {FORMAT}; update the program")
    trunk = model_of_arrays(arrays)
    channels = tuple(arrays["face_channels"].tolist())
    width = len(LAGS) * len(trunk.layers[-1].bias)
    poses = arrays["face_poses"].astype(np.float32)
    layers = {}
    for ahead in (LIVE, WHOLE):
        weights, bias = (arrays[f"face_{ahead}_{part}"].astype(np.float32) for part in ("weights", "bias"))
        if weights.shape != (width, len(channels)) or bias.shape != (len(channels),):
            raise ValueError
        if not (np.isfinite(weights).all() and np.isfinite(bias).all()):
            raise ValueError
        layers[ahead] = FaceLayer(weights, bias)
    known = {*channels} <= {*FACE} and len({*channels}) == len(channels) > 0
    if not known or poses.shape != (len(CLOSURES), len(channels)) or not knows_closures(trunk):
        raise ValueError
    return FaceNetwork(trunk, channels, layers, poses, trunk.about)


Sound = Callable[[], Iterable[Float32Array]]
"""Gives a sound from its beginning, in blocks, mono at 44.1 kHz."""


def sound_of(reader: SoundReader) -> Sound:
    """Return what gives the sound of an open file from its beginning."""

    def blocks() -> Iterator[Float32Array]:
        reader.seek(0)
        yield from reader.blocks(SAMPLE_RATE)

    return blocks
