"""Sentences whose units can be named on paper, and performances of them."""

import numpy as np

from phonemeengine.performance.recording import SILENCE, Performance, PerformedPhone

CHANNELS = ("jawOpen", "mouthPucker")


def phones_in(words: str, length: float = 0.1) -> tuple[PerformedPhone, ...]:
    """Give the phones of words between silence, each `length` long: ``"ma.ma mi"`` is two words.

    A syllable is written without spaces inside; a ``.`` parts those of a word. Each letter is a phone.
    """
    found: list[tuple[str, int, int]] = [(SILENCE, -1, -1)]
    syllable = 0
    for word, text in enumerate(words.split()):
        for letters in text.split("."):
            found += [(letter, word, syllable) for letter in letters]
            syllable += 1
    found.append((SILENCE, -1, -1))
    return tuple(
        PerformedPhone(k * length, (k + 0.5) * length, (k + 1) * length, name, word, syllable)
        for k, (name, word, syllable) in enumerate(found)
    )


def performance_of(words: str, length: float = 0.1, name: str = "", rate: float = 100.0) -> Performance:
    """Give a performance of words whose first channel is a ramp, and whose second one rests."""
    phones = phones_in(words, length)
    ramp = np.linspace(0, 1, round(phones[-1].end * rate) + 1, dtype=np.float32)
    weights = np.stack([ramp, np.zeros_like(ramp)], axis=1)
    return Performance(name or words, rate, CHANNELS, weights, phones, tuple(words.split()))
