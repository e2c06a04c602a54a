"""Leaving some recordings out of a fit, so that they tell how it does on what it has not seen."""

from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np

from phonemeengine.arrays import BoolArray

Fitted = TypeVar("Fitted")


def groups_of(names: Sequence[str], most: int) -> list[list[str]]:
    """Put equal names into one group, and into at most so many groups all of them."""
    different = list(dict.fromkeys(names))
    n = min(most, len(different))
    return [different[k::n] for k in range(n)]


def cross_validate(
    names: Sequence[str], groups: Sequence[Sequence[str]], fit: Callable[[BoolArray], Fitted]
) -> list[Fitted]:
    """Fit without each group in turn; gives for each recording the fit that has not seen its group.

    Parameters
    ----------
    names : of whom each recording is.
    groups : the names that are left out together; each name stands in one.
    fit : fits to the chosen recordings. Where a group is all there is, it is fitted to itself.
    """
    of_name: dict[str, Fitted] = {}
    for group in groups:
        rest = ~np.isin(names, group)
        of_name.update(dict.fromkeys(group, fit(rest if rest.any() else ~rest)))
    return [of_name[name] for name in names]
