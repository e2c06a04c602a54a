"""What Whisper's encoder takes and makes: mel bands of sounds and windows, and its lower layers, cut from a model."""

import json
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.resampling import resample_whole
from phonemeengine.dsp.framing import LEAD
from phonemeengine.encoder.graph import whole_graph
from phonemeengine.encoder.onnx import first_line, open_session
from phonemeengine.encoder.weights import N_MELS, N_STATES, read_weights
from phonemeengine.errors import ModelError
from phonemeengine.execution import threads_allowed
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.storage.files import atomic_write, reason_of
from phonemeengine.storage.paths import data_folder

# The log-mel spectrogram that Whisper's encoder takes (A. Radford et al., arXiv:2212.04356, section 2.2).

ENCODER_RATE = 16_000
"""Samples a second."""
N_FFT, MEL_HOP = 400, 160
"""Samples of a frame, and from one to the next: 25 and 10 ms."""
DYNAMIC_RANGE = 8.0
"""What lies farther below the loudest band counts as that far, base-10 logarithm of powers."""
LINEAR_UP_TO, MELS_UP_TO, FACTOR, STEPS = 1000.0, 15.0, 6.4, 27
"""M. Slaney's scale (Auditory Toolbox, 1998): linear up to 1 kHz, which is 15 mel; then 27 mel a factor of 6.4."""


def log_mel_spectrogram(samples: Float32Array) -> Float32Array:
    """Return what the encoder takes, float32, shape (80, n // 160).

    Parameters
    ----------
    samples : of a sound at 16 kHz, ±1, shape (n,), at least 400.
    """
    from scipy.fft import rfft  # noqa: PLC0415 - it costs half a second at the start

    # As Whisper's own preparation has it, since the encoder was trained on just these numbers: reflected ends, a
    # periodic Hann window, the last frame left out.
    padded = np.pad(samples, N_FFT // 2, mode="reflect")
    frames = np.lib.stride_tricks.sliding_window_view(padded, N_FFT)[::MEL_HOP][:-1]
    powers = np.abs(rfft(frames * np.hanning(N_FFT + 1)[:-1])) ** 2
    # 1e-10 keeps the logarithm of digital silence finite. Then all that is 80 dB below the loudest band of the
    # excerpt is cut off, and (x + 4) / 4 scales the rest as the encoder knows it.
    logarithms = np.log10(np.maximum(slaney_bank() @ powers.T, 1e-10))
    return np.asarray((np.maximum(logarithms, logarithms.max() - DYNAMIC_RANGE) + 4) / 4, np.float32)


@lru_cache(maxsize=1)
def slaney_bank() -> Float64Array:
    """Return the weights of the triangular filters, each of the area 1, shape (80, 201)."""
    # Corners equally far apart on Slaney's scale, and triangles of equal area, so that wide bands at high frequencies
    # do not read more of a white noise than narrow ones at low frequencies.
    mels = np.linspace(0, MELS_UP_TO + STEPS * np.log(ENCODER_RATE / 2 / LINEAR_UP_TO) / np.log(FACTOR), N_MELS + 2)
    linear = mels * LINEAR_UP_TO / MELS_UP_TO
    corners = np.where(mels < MELS_UP_TO, linear, LINEAR_UP_TO * FACTOR ** ((mels - MELS_UP_TO) / STEPS))
    frequencies = np.linspace(0, ENCODER_RATE / 2, N_FFT // 2 + 1)
    low, peak, high = (corners[k : k + N_MELS, np.newaxis] for k in range(3))
    triangles = np.minimum((frequencies - low) / (peak - low), (high - frequencies) / (high - peak))
    return np.asarray(np.maximum(0, triangles) * 2 / (high - low))


PERIOD = 0.02
"""Seconds of a state."""
LAYER = 4
"""After which of the encoder's layers, 0..5, its states are taken: the upper ones have turned to words."""
BEFORE, AFTER = 0.2, 0.5
"""Seconds of near silence before and after a sound, which are cut off again."""
DITHER = 1e-4
"""Level of the noise that keeps digital zeros from confusing it."""
STRETCH, OVERLAP = 2800, 100
"""Mel frames that are encoded at once, and how many more on both sides; it takes at most 3000."""
NEEDED_MEMORY = 250e6
"""Bytes: the weights, what it works on, and the whole model while it is cut."""
MODEL_FILE = "model.bin"
WHISPER_LICENCE = "Whisper base, multilingual, by OpenAI, MIT licence"
CUT = "whisper-base-layer-{layer}.onnx"
"""In the user's data: the convolutions and the lower layers of the model, as ONNX Runtime takes them."""
BITS, REVISION = 8, 1
"""Of each weight in that file, which changes no answer and saves a third of the time; of the way it is made."""


class SpeechEncoder(Protocol):
    """Turns a sound into states that separate phonemes independently of the speaker."""

    def encode(self, samples: Float32Array) -> NDArray[np.float16]:
        """Return its states, float16, shape (n_frames, 512), one each 20 ms.

        Parameters
        ----------
        samples : float32, shape (n,), 44.1 kHz, ±1.
        """
        ...


class WhisperEncoder:
    """The lower layers of the encoder of a Whisper model that CTranslate2 wrote, run by ONNX Runtime.

    They are cut out of the model once, and kept in the user's data.

    Parameters
    ----------
    files : `model.bin`, or its parts one after the other.
    layer : after which the states are taken, 0..5; `OUTPUT` for the encoder's output.
    n_threads : that work on a sound.
    free_memory : bytes that programs may still take.

    Raises
    ------
    ModelError : onnxruntime is not installed, a file is missing or damaged, or there is too little memory.
    """

    def __init__(
        self, *files: Path, layer: int = LAYER, n_threads: int = 0, free_memory: float | None = None
    ) -> None:
        free = _free_memory() if free_memory is None else free_memory
        self._session = _load(files, layer, n_threads or threads_allowed(), free)

    def encode(self, samples: Float32Array) -> NDArray[np.float16]:
        """Return the states, float16, shape (n_frames, 512): frame k lies at k x 20 ms..(k + 1) x 20 ms."""
        # The second convolution of the encoder has a stride of 2, so a state stands for two mel frames, 20 ms.
        sound = resample_whole(samples, SAMPLE_RATE, ENCODER_RATE)
        wanted = -(-len(sound) // (2 * MEL_HOP))
        mels = log_mel_spectrogram(surrounded(sound))
        parts = [np.zeros((0, N_STATES), np.float32)]
        # Attention sees the whole excerpt, so the states near a cut would change with it; both neighbours overlap by
        # a second, and of each only the middle is kept. All places are even, so that the halves meet.
        for first, begin, end, last in stretches(mels.shape[1]):
            (found,) = self._session.run(None, {"mel": mels[np.newaxis, :, begin:end]})
            parts.append(found[0, (first - begin) // 2 : (last - begin) // 2])
        before = round(BEFORE / PERIOD)
        return np.concatenate(parts)[before : before + wanted].astype(np.float16)


def surrounded(sound: Float32Array) -> Float32Array:
    """Return the sound between near silence, with faint noise, as long as a whole number of the encoder's frames."""
    # one seed for all, so that a sound is recognised alike each time
    generator = np.random.default_rng(0)
    after = round(AFTER * ENCODER_RATE) + 2 * MEL_HOP - len(sound) % (2 * MEL_HOP)
    padded = np.pad(sound, (round(BEFORE * ENCODER_RATE), after))
    return padded + np.float32(DITHER) * generator.standard_normal(len(padded)).astype(np.float32)


def stretches(n: int) -> Iterator[tuple[int, int, int, int]]:
    """Cut n mel frames into excerpts: first frame, first and end with the overlap, end; all even."""
    n -= n % 2
    for first in range(0, n, STRETCH):
        last = min(first + STRETCH, n)
        yield first, max(0, first - OVERLAP), min(n, last + OVERLAP), last


def _load(files: Sequence[Path], layer: int, n_threads: int, free: float) -> Any:
    missing = [path for path in files if not path.is_file()]
    if missing:
        raise ModelError(
            f"{missing[0].parent}: there is no Whisper model, {missing[0].name} is missing; choose its folder, or "
            "fetch it"
        )
    if free < NEEDED_MEMORY:
        raise ModelError(
            f"Whisper needs {NEEDED_MEMORY / 1e6:.0f} MB of memory and {free / 1e6:.0f} MB are free; "
            "close other programs"
        )
    cut, source = data_folder() / CUT.format(layer=layer), _source_of(files)
    if cut.is_file():
        with suppress(ModelError):  # a damaged one is made anew
            session = open_session(cut, n_threads)
            if session.get_modelmeta().custom_metadata_map.get("source") == source:
                return session
    content = _cut(files, layer, source)
    with suppress(OSError, ValueError):  # it only saves a second at the next start
        cut.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(cut) as file:
            file.write(content)
    return open_session(content, n_threads)


def _source_of(files: Sequence[Path]) -> str:
    """Return what changes as soon as a cut has to be made anew, without reading the files."""
    facts = [(str(path.absolute()), path.stat().st_size, path.stat().st_mtime_ns) for path in files]
    return json.dumps([REVISION, BITS, facts])


def _cut(files: Sequence[Path], layer: int, source: str) -> bytes:
    try:
        weights = read_weights(b"".join(path.read_bytes() for path in files), layer)
    except (OSError, ValueError, MemoryError) as error:
        reason = reason_of(error) if isinstance(error, OSError) else first_line(error)
        raise ModelError(
            f"{files[0].parent}: the Whisper model cannot be opened ({reason}); get it anew, or choose another folder"
        ) from error
    return whole_graph(weights, BITS, {"source": source, "licence": WHISPER_LICENCE})


def _free_memory() -> float:
    """Return the bytes that programs may still take; where the system does not tell, as much as is wanted."""
    try:
        lines = Path("/proc/meminfo").read_text(encoding="ascii").splitlines()
        return 1024 * next(float(line.split()[1]) for line in lines if line.startswith("MemAvailable:"))
    except (OSError, StopIteration, ValueError):
        return float("inf")


LENGTH = 1102
"""Samples of a frame, 25 ms at 44.1 kHz: bins are 40.02 Hz apart, 40 Hz in Whisper's frames of 400 at 16 kHz. Its
factors are small, which 1103, nearer to 25 ms, has none of: a Fourier transform of that takes four times as long."""
LEAST_POWER = 1e-10
LEAST_PEAK, PEAK_FALL = -2.0, 0.002
"""Of the running peak, base-10 logarithms of powers: its least, and by how much it falls each frame of 10 ms."""
SILENT = (LEAST_PEAK - DYNAMIC_RANGE + 4) / 4
"""What silence is, scaled for the encoder."""
_FRAME = slice(LEAD - LENGTH // 2, LEAD + LENGTH // 2)


def whisper_log_mels(windows: Float32Array, warp: float = 1.0) -> Float32Array:
    """Return base-10 logarithms of the powers in Whisper's 80 mel bands, before any floor, shape (n_frames, 80).

    Frame k is centred on the beginning of its 10 ms, as Whisper's are. No resampler is needed, and so no delay.

    Parameters
    ----------
    windows : of the analysis, shape (n_frames, 2048), full scale ±1.
    warp : what lies at a frequency f is looked for at f x warp, as if the vocal tract were shorter (above 1).
    """
    from scipy.fft import rfft  # noqa: PLC0415 - it costs half a second at the start

    bins = rfft(windows[:, _FRAME] * _window(), axis=1)[:, : N_FFT // 2 + 1]
    powers = bins.real * bins.real
    powers += bins.imag * bins.imag
    return np.asarray(np.log10(np.maximum(powers @ _bank(warp), np.float32(LEAST_POWER))), np.float32)


class RunningScale:
    """Scales the logarithms of a running sound for the encoder, which cuts off what is far below the loudest band.

    Whisper takes the loudest band of the whole sound; here it is that of what came, and falls by 2 dB a second.
    """

    def __init__(self) -> None:
        self._peak = LEAST_PEAK

    def scale(self, logarithms: Float32Array) -> Float32Array:
        """Return the next frames as the encoder takes them, shape (n_frames, 80)."""
        # frame by frame, so that the numbers are the same however the sound is cut
        floors = np.empty((len(logarithms), 1), np.float32)
        for k, loudest in enumerate(logarithms.max(axis=1, initial=LEAST_PEAK).tolist()):
            self._peak = max(loudest, self._peak - PEAK_FALL, LEAST_PEAK)
            floors[k] = self._peak - DYNAMIC_RANGE
        return (np.maximum(logarithms, floors) + np.float32(4)) / np.float32(4)


@lru_cache(maxsize=1)
def _window() -> Float32Array:
    # Hann, periodic, scaled so that a sine reads what it does in 400 samples: bins grow with the length of the frame.
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(LENGTH) / LENGTH)
    return np.asarray(window * N_FFT / LENGTH, np.float32)


@lru_cache(maxsize=64)
def _bank(warp: float) -> Float32Array:
    bank = slaney_bank()
    if warp != 1:
        # each filter looks at the bins at its frequencies times the warp, as `warped_mel_bank` does up to its knee
        places = np.arange(bank.shape[1])
        bank = np.stack([np.interp(places / warp, places, row, right=0.0) for row in bank]) / warp
    return np.ascontiguousarray(bank.T, np.float32)
