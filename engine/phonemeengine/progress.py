"""How long work tells how far it is, and hears that it is no longer wanted."""

from collections.abc import Callable

Progress = Callable[[float], bool]
"""Told how much of the work is done, 0..1; answers whether to go on."""


class Cancelled(Exception):  # noqa: N818 - no error: somebody wanted it
    """The work was ended before its end; nothing has changed."""


def no_progress(_share: float) -> bool:
    """Let work go on to its end."""
    return True


def report_progress(progress: Progress, share: float) -> None:
    """Tell how much is done.

    Raises
    ------
    Cancelled : the answer is not to go on.
    """
    if not progress(share):
        raise Cancelled


def subrange(progress: Progress, first: float, last: float) -> Progress:
    """Return what a part of the work heeds, which is the whole from `first` to `last`."""
    return lambda share: progress(first + share * (last - first))
