"""The runtime in C: one frame by network and by rules, memory, and a hundred recognisers on one core."""

import ctypes
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import scipy.fft

from phonemeengine import Analyser, load_preset
from phonemeengine.presets.model_choice import with_small_network
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, HOP
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import SOURCES, CEar, CModel, EarLibrary, compiled
from tests.sounds import Sound
from tools.bench.figures import Absolute, Figure, interleaved, ratio_of, shown, speech

LOOP = Path(__file__).with_name("ear_loop.c")
N_FRAMES, N_ROUNDS = 500, 9
PYTHON_S_TIME, TRANSFORMS = 0.25, 1.2
"""Of Python's time, and bare transforms of 512 values, that a frame may take."""
MOST_BYTES = 200_000
N_EARS, EARS_FRAMES, SHARE = 100, 100, 0.35
"""Recognisers of 48 kHz on one core, frames that each recognises, and the share of real time that they may take."""


def figures() -> list[Figure]:
    """Measure all of them."""
    library, learned, thesis = loop_library(), load_preset("learned"), load_preset("thesis")
    content = format_ear(learned)
    model = CModel(library, content)
    sound = speech(N_FRAMES * FRAME_PERIOD)
    return [
        _beside_python(library, model, learned, sound),
        _beside_transform(library, CModel(library, format_ear(thesis)), sound),
        _memory(model, 44_100),
        _memory(model, 48_000),
        _many(content),
    ]


def loop_library(*flags: str, by: str = "") -> EarLibrary:
    """Compile the runtime with the loop."""
    sources = [LOOP, SOURCES / "ear.c"]
    return EarLibrary(compiled("libear_loop.so", sources, *(flags or ("-O3",)), "-shared", "-fPIC", by=by))


def listening(library: EarLibrary, ears: Sequence[CEar], sound: Sound, n: int = N_FRAMES) -> Callable[[], None]:
    """Give all recognisers the first blocks of a sound."""
    handles = (ctypes.c_void_p * len(ears))(*(ear.handle for ear in ears))
    samples, hop = sound.ctypes.data_as(ctypes.c_void_p), ears[0].rate // 100

    size = ctypes.c_size_t

    def listen() -> None:
        library.c.listen(handles, size(len(ears)), samples, size(hop), size(n))

    return listen


def _beside_python(library: EarLibrary, model: CModel, preset: Preset, sound: Sound) -> Figure:
    analyser, hops = Analyser(with_small_network(preset), phonemes_only=True), sound.reshape(-1, HOP)

    def push_all() -> None:
        for hop in hops:
            analyser.push(hop)

    c, python = interleaved(N_ROUNDS, listening(library, [CEar(model)], sound), push_all)
    name, reference = "C ear, learned, one frame", f"Python {shown(python, N_FRAMES)}"
    return Figure(name, shown(c, N_FRAMES), reference, ratio_of(c, python), PYTHON_S_TIME)


def _beside_transform(library: EarLibrary, model: CModel, sound: Sound) -> Figure:
    wave = sound[:512].copy()

    def transform_all() -> None:
        for _ in range(N_FRAMES):
            scipy.fft.rfft(wave)

    c, bare = interleaved(N_ROUNDS, listening(library, [CEar(model)], sound), transform_all)
    name, reference = "C ear, thesis rules, one frame", f"scipy.fft.rfft(512) {shown(bare, N_FRAMES)}"
    return Figure(name, shown(c, N_FRAMES), reference, ratio_of(c, bare), TRANSFORMS)


def _memory(model: CModel, rate: int) -> Figure:
    size = CEar(model, rate).size
    name = f"memory of a C ear at {rate / 1000:g} kHz, besides its model of {model.size / 1e6:.2f} MB"
    return Figure(name, f"{size / 1000:.0f} KB", f"{MOST_BYTES / 1000:.0f} KB", size / MOST_BYTES, 1.0)


def _many(content: bytes) -> Figure:
    library = loop_library("-O2")
    ears = [CEar(CModel(library, content), 48_000)]
    ears += [CEar(ears[0].model, 48_000) for _ in range(N_EARS - 1)]
    listen = listening(library, ears, speech(2 * EARS_FRAMES * FRAME_PERIOD), EARS_FRAMES)
    listen()
    began = time.process_time()
    listen()
    share = (time.process_time() - began) / (EARS_FRAMES * FRAME_PERIOD)
    name = f"{N_EARS} C ears of one model on one core, 48 kHz, -O2"
    return Figure(name, f"{share:.1%} of real time", f"{SHARE:.0%}", share / SHARE, 1.0, absolute=Absolute.WORK)
