"""One frame at a time, as a game asks for it, against one bare transform of 512 values."""

import scipy.fft

from phonemeengine.analyser import Analyser
from phonemeengine.presets.files import THESIS_PRESET, load_preset
from phonemeengine.settings import HOP
from tools.bench.figures import Figure, interleaved, ratio_of, shown, speech

N_FRAMES = 1000
N_ROUNDS = 15


def figures() -> list[Figure]:
    """Measure with and without the fundamental frequency, which no rule needs."""
    hops = speech(N_FRAMES * HOP / 44_100).reshape(N_FRAMES, HOP)
    wave = hops[:2].ravel()[:512].copy()
    preset = load_preset(THESIS_PRESET)
    plain, pitched = Analyser(preset), Analyser(preset, pitch=True)

    def push_all(analyser: Analyser) -> None:
        for hop in hops:
            analyser.push(hop)

    def transform_all() -> None:
        for _ in hops:
            scipy.fft.rfft(wave)

    without, whole, bare = interleaved(N_ROUNDS, lambda: push_all(plain), lambda: push_all(pitched), transform_all)
    reference = f"scipy.fft.rfft(512) {shown(bare, N_FRAMES)}"
    return [
        Figure("one frame, all steps", shown(whole, N_FRAMES), reference, ratio_of(whole, bare), limit=5.0),
        Figure("one frame, without f0", shown(without, N_FRAMES), reference, ratio_of(without, bare), limit=5.0),
    ]
