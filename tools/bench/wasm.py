"""The runtime as WebAssembly, in Node, beside the same C compiled for this machine."""

import statistics
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from phonemeengine import load_preset, ship
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import CEar, CModel, EarLibrary
from tests.sounds import Sound
from tests.web_ears import node
from tools.bench.ear_in_c import N_FRAMES, N_ROUNDS, listening, loop_library
from tools.bench.figures import Absolute, Figure, shown, speech

SCRIPT = Path(__file__).with_name("wasm_loop.mjs")
NATIVE_S_TIME = 1.5
"""That a frame may take, of the same C with vectors as wide as those of WebAssembly."""
MOST_SECONDS, MOST_BYTES = 1e-3, 1_500_000
"""That 10 ms of sound may take, and that module and model may have."""


class WasmEar:
    """A recogniser in Node that analyses a sound again and again."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self._process = process
        self.times: list[float] = []

    def listen(self) -> None:
        """Analyse all of it, and keep how much of the processor that took."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        print("again", file=self._process.stdin, flush=True)
        self.times.append(float(self._process.stdout.readline()))


def figures() -> list[Figure]:
    """Measure all of them."""
    narrow, usual = loop_library("-O3", "-DEAR_NO_AVX2"), loop_library()
    return [
        *_beside_native(narrow, "learned", "learned", NATIVE_S_TIME),
        _beside_native(narrow, "thesis", "thesis rules", NATIVE_S_TIME)[0],
        _beside_native(usual, "learned", "learned, beside all that this processor has", None)[0],
    ]


def _beside_native(library: EarLibrary, preset: str, words: str, limit: float | None) -> list[Figure]:
    sound = speech(N_FRAMES * FRAME_PERIOD)
    listen = listening(library, [CEar(CModel(library, format_ear(load_preset(preset))))], sound)
    c: list[float] = []
    with tempfile.TemporaryDirectory() as place, _started(Path(place), preset, sound) as ear:
        for _ in range(N_ROUNDS + 1):
            ear.listen()
            began = time.process_time()
            listen()
            c.append(time.process_time() - began)
        size = sum((Path(place) / name).stat().st_size for name in ("ear.wasm", "preset.ear"))
    wasm, c = ear.times[1:], c[1:]
    share = statistics.median(wasm) / N_FRAMES / MOST_SECONDS
    name, reference = f"WebAssembly ear in Node, {words}, one frame", f"C ear {shown(c, N_FRAMES)}"
    return [
        Figure(name, shown(wasm, N_FRAMES), reference, min(wasm) / min(c), limit),
        Figure("the same, of 10 ms", shown(wasm, N_FRAMES), "1 ms", share, 1.0, absolute=Absolute.WORK),
        Figure("its module with the model", f"{size / 1e6:.2f} MB", "1.5 MB", size / MOST_BYTES, 1.0),
    ]


@contextmanager
def _started(folder: Path, preset: str, sound: Sound) -> Iterator[WasmEar]:
    ship(load_preset(preset), folder, "web-module")
    (folder / "samples.f32").write_bytes(sound.tobytes())
    words = [node(), str(SCRIPT), str(folder)]
    with subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        yield WasmEar(process)
        assert process.stdin is not None
        process.stdin.close()
