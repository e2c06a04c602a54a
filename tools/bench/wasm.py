"""The runtime as WebAssembly, in Node, beside the same C compiled for this machine."""

import statistics
import subprocess
import tempfile
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
from tools.bench.figures import Absolute, Figure, interleaved, ratio_of, shown, speech

SCRIPT = Path(__file__).with_name("wasm_loop.mjs")
NATIVE_S_TIME = 2.0
MOST_SECONDS, MOST_BYTES = 1e-3, 1_500_000
"""That 10 ms of sound may take, and that module and model may have."""


class WasmEar:
    """A recogniser in Node that analyses a sound again and again."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self._process = process
        self.times: list[float] = []

    def listen(self) -> None:
        """Analyse all of it, and keep how long that took, by Node's clock."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        print("again", file=self._process.stdin, flush=True)
        self.times.append(float(self._process.stdout.readline()))


def figures() -> list[Figure]:
    """Measure all of them."""
    library = loop_library()
    return [*_beside_native(library, "learned", "learned"), *_beside_native(library, "thesis", "thesis rules")[:1]]


def _beside_native(library: EarLibrary, preset: str, words: str) -> list[Figure]:
    sound = speech(N_FRAMES * FRAME_PERIOD)
    native = listening(library, [CEar(CModel(library, format_ear(load_preset(preset))))], sound)
    with tempfile.TemporaryDirectory() as place, _started(Path(place), preset, sound) as ear:
        _, c = interleaved(N_ROUNDS, ear.listen, native)
        size = sum((Path(place) / name).stat().st_size for name in ("ear.wasm", "preset.ear"))
    wasm = ear.times[1:]
    share = statistics.median(wasm) / N_FRAMES / MOST_SECONDS
    name, reference = f"WebAssembly ear in Node, {words}, one frame", f"C ear {shown(c, N_FRAMES)}"
    return [
        Figure(name, shown(wasm, N_FRAMES), reference, ratio_of(wasm, c), NATIVE_S_TIME),
        Figure("the same, of 10 ms", shown(wasm, N_FRAMES), "1 ms", share, 1.0, absolute=Absolute.TIME),
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
