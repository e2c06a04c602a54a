"""Drive a face: the vertices of a head that says a sound, sixty pictures a second.

python examples/drive_face.py SOUND
"""

import sys

import numpy as np

from phonemeengine import (
    EngineError,
    Morpher,
    MovestateSet,
    SoundReader,
    analyse_blocks,
    load_head,
    load_preset,
    load_table,
)

PICTURES = 60


def main(sound: str) -> None:
    """Print how far the mouth has moved, ten times a second; an engine would draw `positions` instead."""
    head = load_head()  # or load_morph_mesh("face.glb")
    face = MovestateSet(head.mesh, head.states)
    morpher = Morpher(load_table("arkit"), seed=1)  # another seed makes another person
    picture = 0
    with SoundReader(sound) as reader:
        for analysis in analyse_blocks(reader.blocks(4410), load_preset("learned")):
            for time, phoneme, intensity in zip(analysis.times, analysis.phonemes, analysis.intensities, strict=True):
                morpher.add(time, phoneme, intensity)
                while picture / PICTURES <= time:
                    weights = morpher.weights(picture / PICTURES)
                    face.set_percentages(dict(zip(morpher.movestates, 100 * weights, strict=True)))
                    positions = face.morphed()  # float32, shape (n_vertices, 3)
                    if picture % 6 == 0:
                        moved = np.abs(positions - head.mesh.positions).max()
                        print(f"{picture / PICTURES:6.2f} s  {'#' * round(100 * moved)}")
                    picture += 1


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except EngineError as error:
        sys.exit(str(error))
