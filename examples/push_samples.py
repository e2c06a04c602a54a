"""Push samples: for programs that have sound of their own, such as voice chat.

python examples/push_samples.py SOUND
"""

import sys
from collections.abc import Iterator

import numpy as np

from phonemeengine import Analyser, EngineError, Phoneme, SoundReader, load_preset


def packets(sound: str) -> Iterator[np.ndarray]:
    """Stand for what brings the sound: packets of 20 ms, float32, mono, 44.1 kHz."""
    with SoundReader(sound) as reader:
        yield from reader.blocks(882)


def main(sound: str) -> None:
    """Print each phoneme as soon as it is known; how the sound is cut makes no difference."""
    analyser, last = Analyser(load_preset("learned")), -1
    for samples in packets(sound):
        analysis = analyser.push(samples)
        for time, code in zip(analysis.times, analysis.phonemes, strict=True):
            if code != last:
                print(f"{time:6.2f} s  {Phoneme(code).label}")
            last = code


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except EngineError as error:
        sys.exit(str(error))
