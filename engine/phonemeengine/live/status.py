"""How listening goes, in words."""

from dataclasses import dataclass

from phonemeengine.audio.input import Input

QUIET = 0.5
"""Seconds without a block after which nothing counts as coming: even silence comes every 10 ms."""


@dataclass(frozen=True)
class Status:
    """Whether sound is coming in at this moment, and what is going on, in words."""

    listening: bool
    words: str


NOT_LISTENING = Status(listening=False, words="not listening")


def status_of(source: Input, *, heard: bool, silent: float, cancels: bool = False) -> Status:
    """Return the status of an open microphone, which was heard `silent` seconds ago, or never yet.

    `cancels` says that the channels that are mixed cancel each other.
    """
    if not heard:
        return Status(listening=False, words=f"waiting for the first sound from {source.name}")
    if silent < QUIET and cancels:
        words = f"{source.name}; its channels cancel each other out when mixed, so choose one of them"
        return Status(listening=True, words=words)
    if silent < QUIET:
        return Status(listening=True, words=source.name)
    return Status(
        listening=False, words=f"nothing comes from {source.name} since {silent:.0f} s; trying again every 2 s"
    )
