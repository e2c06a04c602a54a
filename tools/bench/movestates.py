"""Movestates: morphing a face on the processor, and loading a large .3dm file."""

import numpy as np

from phonemeengine.mouth.files.threedm import format_3dm, parse_3dm
from phonemeengine.mouth.mesh import Mesh, mesh_of
from phonemeengine.mouth.morph_mesh import morph_targets_of
from phonemeengine.mouth.movestate import Movestate, MovestateSet, movestate_of
from tools.bench.figures import Absolute, Figure, interleaved, shown

N_VERTICES, N_ACTIVE, N_STATES = 5000, 12, 100
MORPHED_WITHIN = 1e-3
LOADED_WITHIN = 50e-3
N_ROUNDS = 15
N_FRAMES = 100


def figures() -> list[Figure]:
    """Measure both, with states that move every vertex, and morphing also with states that move a scattered fifth."""
    everywhere, scattered = _face(1), _face(5)
    return [
        _morphing("that move all", *everywhere),
        _morphing("that move a fifth", *scattered),
        _loading(*everywhere),
    ]


def _face(step: int) -> tuple[Mesh, list[Movestate]]:
    generator = np.random.default_rng(0)
    mesh = mesh_of(generator.standard_normal((N_VERTICES, 3)))
    moving = (np.arange(N_VERTICES) % step == 0)[:, np.newaxis]
    shape = (N_VERTICES, 3)
    return mesh, [movestate_of(f"state {k}", moving * generator.standard_normal(shape)) for k in range(N_STATES)]


def _morphing(what: str, mesh: Mesh, states: list[Movestate]) -> Figure:
    face = MovestateSet(mesh, states)
    face.set_percentages({f"state {k}": 50 for k in range(N_ACTIVE)})

    def morph() -> None:
        for _ in range(N_FRAMES):
            face.morphed()

    (seconds,) = interleaved(N_ROUNDS, morph)
    ratio = float(np.median(seconds)) / N_FRAMES / MORPHED_WITHIN
    name = f"{N_VERTICES} vertices, {N_ACTIVE} states {what}"
    return Figure(name, shown(seconds, N_FRAMES), "1 ms", ratio, 1.0, absolute=Absolute.TIME)


def _loading(mesh: Mesh, states: list[Movestate]) -> Figure:
    content = format_3dm(morph_targets_of(mesh, states))
    (seconds,) = interleaved(N_ROUNDS, lambda: parse_3dm(content))
    ratio = float(np.median(seconds)) / LOADED_WITHIN
    return Figure(f".3dm of {N_STATES} x {N_VERTICES}", shown(seconds), "50 ms", ratio, 1.0, absolute=Absolute.TIME)
