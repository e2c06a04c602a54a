"""Ten minutes of sound, already in memory, analysed on one core, against two plain short-time transforms."""

import librosa
import numpy as np
import scipy.fft

from phonemeengine.analyser import BLOCK, analyse_blocks
from phonemeengine.presets.files import THESIS_PRESET, load_preset
from phonemeengine.settings import HOP, WINDOW
from tests.sounds import Sound
from tools.bench.figures import Figure, interleaved, ratio_of, shown, speech

SECONDS = 600
N_ROUNDS = 5


def figures() -> list[Figure]:
    """Measure with and without the fundamental frequency, which no rule needs."""
    sound = speech(SECONDS)
    plain, pitched, by_librosa, by_scipy = interleaved(
        N_ROUNDS,
        lambda: _analyse(sound, pitch=False),
        lambda: _analyse(sound, pitch=True),
        lambda: librosa.stft(sound, n_fft=WINDOW, hop_length=HOP),
        lambda: _transform(sound),
    )
    found = []
    for name, times in (("10 minutes, all steps", pitched), ("10 minutes, without f0", plain)):
        against_librosa, against_scipy = ratio_of(times, by_librosa), ratio_of(times, by_scipy)
        found += [
            Figure(name, shown(times), f"librosa.stft {shown(by_librosa)}", against_librosa, limit=1.0),
            Figure(name, shown(times), f"scipy.fft STFT {shown(by_scipy)}", against_scipy, aim=1.0),
        ]
    return found


def _analyse(sound: Sound, *, pitch: bool) -> None:
    preset = load_preset(THESIS_PRESET)
    step = BLOCK * HOP
    blocks = (sound[k : k + step] for k in range(0, len(sound), step))
    for _ in analyse_blocks(blocks, preset, pitch=pitch):
        pass


def _transform(sound: Sound) -> None:
    frames = np.lib.stride_tricks.sliding_window_view(sound, WINDOW)[::HOP]
    window = np.hanning(WINDOW).astype(np.float32)
    for k in range(0, len(frames), BLOCK):
        scipy.fft.rfft(frames[k : k + BLOCK] * window)
