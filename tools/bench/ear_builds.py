"""The runtime in C by compilers, optimisation and sample rates: how much slower each is than gcc's at -O3."""

import time
from collections.abc import Callable, Iterator, Mapping
from itertools import product

from phonemeengine import load_preset
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import CEar, CModel
from tools.bench.ear_in_c import listening, loop_library
from tools.bench.figures import Figure, speech

COMPILERS = ("gcc", "clang", "zig")
LEVELS = ("-O3", "-O2", "-Os")
RATES = (44_100, 48_000, 16_000)
PLAIN = "-DEAR_PLAIN"
N_FRAMES, N_ROUNDS = 200, 7
SLOWER_AT_O2, SLOWER_PLAIN, SLOWER_AT_A_RATE = 1.3, 3.0, 1.4
"""Than gcc at -O3, and than the same at 44.1 kHz."""

Build = tuple[str, tuple[str, ...]]


def figures() -> list[Figure]:
    """Measure all of them."""
    content, sound = format_ear(load_preset("learned")), speech(2.0 * N_FRAMES / 100)
    builds: list[Build] = [(by, (level,)) for by, level in product(COMPILERS, LEVELS)]
    builds += [(by, ("-O2", PLAIN)) for by in COMPILERS]
    libraries = {build: loop_library(*build[1], by=build[0]) for build in builds}
    ears = {
        (build, rate): CEar(CModel(library, content), rate)
        for (build, library), rate in product(libraries.items(), RATES)
    }
    acts = {key: listening(libraries[key[0]], [ear], sound, N_FRAMES) for key, ear in ears.items()}
    return list(_rows(builds, _least_times(acts)))


def _least_times(acts: Mapping[tuple[Build, int], Callable[[], None]]) -> dict[tuple[Build, int], float]:
    """Give the least processor time of each, in turns, since others use the machine too."""
    least = dict.fromkeys(acts, float("inf"))
    for _ in range(N_ROUNDS):
        for key, act in acts.items():
            began = time.process_time()
            act()
            least[key] = min(least[key], time.process_time() - began)
    return least


def _rows(builds: list[Build], least: Mapping[tuple[Build, int], float]) -> Iterator[Figure]:
    fastest = least[(builds[0], RATES[0])]
    for build in builds:
        flags = build[1]
        limit = SLOWER_PLAIN if PLAIN in flags else None if flags == ("-Os",) else SLOWER_AT_O2
        name, here = f"C ear, {build[0]} {' '.join(flags)}, one frame", least[(build, RATES[0])]
        yield Figure(name, _shown(here), f"gcc -O3 {_shown(fastest)}", here / fastest, limit)
        for rate in RATES[1:]:
            there = least[(build, rate)]
            at = f"{name} at {rate / 1000:g} kHz"
            yield Figure(at, _shown(there), f"at 44.1 kHz {_shown(here)}", there / here, SLOWER_AT_A_RATE)


def _shown(seconds: float) -> str:
    return f"{1e6 * seconds / N_FRAMES:.1f} µs"
