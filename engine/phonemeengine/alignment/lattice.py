"""The ways through a text: its sounds in order, with all places where a pause, another word or nothing may be."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import IndexArray

Spellings = Sequence[Sequence[int]]
"""The pronunciations of a word, at least one, each the columns of its sounds in a table of scores, at least one."""

NOWHERE = -1


@dataclass(frozen=True, eq=False)
class Lattice:
    """Sounds that lead from junction to junction; word w lies between the junctions w and w + 1.

    Junctions within words have the numbers from `n_words` + 1.

    Attributes
    ----------
    n_words : how many words there are.
    columns : where the scores of each sound stand, shape (n_sounds,).
    words : to which word each sound belongs, shape (n_sounds,).
    before, after : the junctions between which each sound lies, shape (n_sounds,).
    arrivals : the sounds that lead to each junction, by the pronunciation, shape (n_variants, n_junctions), `NOWHERE`
        where there are fewer; the junctions within words have one, in the first row.
    fewest : sounds of the shortest pronunciation of each word, shape (n_words,).
    """

    n_words: int
    columns: IndexArray
    words: IndexArray
    before: IndexArray
    after: IndexArray
    arrivals: IndexArray
    fewest: IndexArray


def lattice_of(words: Sequence[Spellings]) -> Lattice:
    """Lay out words, each with its pronunciations, in the order of the text."""
    rows: list[tuple[int, int, int, int]] = []
    n_junctions = len(words) + 1
    variants = []
    for w, spellings in enumerate(words):
        for v, spelling in enumerate(spellings):
            junctions = [w, *range(n_junctions, n_junctions + len(spelling) - 1), w + 1]
            n_junctions += len(spelling) - 1
            rows += zip(spelling, [w] * len(spelling), junctions, junctions[1:], strict=False)
            variants += [*[0] * (len(spelling) - 1), v]
    columns, of_words, before, after = np.array(rows, np.intp).reshape(-1, 4).T.copy()
    arrivals = np.full((max(variants, default=0) + 1, n_junctions), NOWHERE)
    arrivals[variants, after] = np.arange(len(after))
    fewest = np.array([min(len(spelling) for spelling in spellings) for spellings in words])
    return Lattice(len(words), columns, of_words, before, after, arrivals, fewest)
