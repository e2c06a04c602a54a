"""Recognisers from other packages, found through Python's entry points, their every answer checked.

A package declares one in its ``pyproject.toml``::

    [project.entry-points."phonemeanalyser.recognisers"]
    loudness = "package.module:Loudness"
"""

import sys
from collections.abc import Callable, Iterable
from dataclasses import fields
from functools import cached_property, lru_cache
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import numpy as np

from phonemeengine.errors import RecogniserError
from phonemeengine.features.measure import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.phoneme_data import Thresholds
from phonemeengine.recognition.recognition import Recognition
from phonemeengine.recognition.trace import RuleComparison, Trace

GROUP = "phonemeanalyser.recognisers"
"""The group of entry points in which packages offer recognisers."""
LONGEST = 160
"""Characters that are told of a foreign error."""


class PlugIn:
    """A recogniser from another package; whatever it does wrong is one sentence.

    Its `recognise` gives bare codes, it never looks ahead, and it has no scores.

    It is made when it is first asked for anything, by the thread that asks: making it may take a while.

    Parameters
    ----------
    entry : what its package declares: a callable that takes `Thresholds` and gives a `Recogniser`.
    thresholds : what it is made with.

    Raises
    ------
    RecogniserError : it cannot be imported.
    """

    look_ahead = 0
    scores: tuple[str, ...] = ()

    def __init__(self, entry: EntryPoint, thresholds: Thresholds) -> None:
        self._name = f"the recogniser {entry.name!r} of the package {package_of(entry)}"
        self._thresholds = thresholds
        self._factory = self._asked("be imported", entry.load)

    @cached_property
    def used_thresholds(self) -> frozenset[str]:
        """The fields of `Thresholds` that it says it compares with; RecogniserError where it cannot be made."""
        recogniser = self._recogniser
        used: frozenset[str] = self._asked(
            "name its thresholds", lambda: frozenset(getattr(recogniser, "used_thresholds", ()))
        )
        return used & {field.name for field in fields(Thresholds)}

    def recognise(self, features: Features) -> Recognition:
        """Recognise a block.

        Raises
        ------
        RecogniserError : it cannot be made, it failed, or what it gave are no codes of phonemes, one for each frame.
        """
        recogniser = self._recogniser
        codes = self._asked("recognise", lambda: recogniser.recognise(_read_only(features)))
        wanted = (len(features.values),)
        if not isinstance(codes, np.ndarray) or codes.dtype != np.uint8 or codes.shape != wanted:
            raise self._refusal(f"gave {_described(codes)} where codes of uint8, shape {wanted}, are wanted")
        if codes.size and codes.max() >= len(Phoneme):
            raise self._refusal(f"gave the code {codes.max()}, and phonemes are 0..{len(Phoneme) - 1}")
        return Recognition(codes.copy())

    def deficits(self, _features: Features) -> None:
        """Tell nothing: only its codes are known."""

    def explain(self, features: Features, k: int) -> Trace:
        """Return why frame `k` of a block is recognised as it is.

        Raises
        ------
        RecogniserError : it cannot be made, it failed, or what it gave is no `Trace`.
        """
        recogniser = self._recogniser
        trace: Trace = self._asked("say why", lambda: _checked(recogniser.explain(_read_only(features), k)))
        return trace

    @cached_property
    def _recogniser(self) -> Any:
        return self._asked("be made", self._factory, self._thresholds)

    def _asked(self, what: str, act: Callable[..., Any], *arguments: Any) -> Any:
        """Have the foreign code do something; what it raises becomes a sentence, even where it wants to exit."""
        try:
            return act(*arguments)
        except (Exception, SystemExit) as error:
            text = f"{type(error).__name__}: {error}"
            told = " ".join("".join(c if c.isprintable() else " " for c in text).split())
            shown = told if len(told) <= LONGEST else told[:LONGEST] + "…"
            raise self._refusal(f"cannot {what} ({shown.removesuffix(':')})") from error

    def _refusal(self, what: str) -> RecogniserError:
        return RecogniserError(f"{self._name} {what}; choose another recogniser")


def plug_ins() -> dict[str, tuple[EntryPoint, ...]]:
    """Return all recognisers that installed packages offer, by name, sorted; none of them is imported."""
    return _found(tuple(sys.path))


def package_of(entry: EntryPoint) -> str:
    """Return the name of the package that offers a recogniser."""
    return entry.dist.name if entry.dist is not None else entry.module


@lru_cache(maxsize=1)
def _found(_path: tuple[str, ...]) -> dict[str, tuple[EntryPoint, ...]]:
    """Look through the installed packages once: a preset that is edited is checked many times a second."""
    found: dict[str, tuple[EntryPoint, ...]] = {}
    for entry in sorted(entry_points(group=GROUP), key=lambda entry: (entry.name, package_of(entry))):
        found[entry.name] = (*found.get(entry.name, ()), entry)
    return found


def _read_only(features: Features) -> Features:
    """Return the same features, but not to be written to: they are shown and saved, too."""
    values = features.values.view()
    values.flags.writeable = False
    windows = features.windows.view()
    windows.flags.writeable = False
    return Features(features.names, values, windows)


def _described(codes: object) -> str:
    if isinstance(codes, np.ndarray):
        return f"{codes.dtype}, shape {codes.shape}"
    return f"a {type(codes).__name__}"


def _checked(trace: Any) -> Trace:
    """Return a trace that can be shown, whatever stands in its fields for numbers and text."""
    return Trace(Phoneme(trace.phoneme), str(trace.rule), tuple(_comparisons(trace.comparisons)))


def _comparisons(comparisons: Iterable[Any]) -> Iterable[RuleComparison]:
    for c in comparisons:
        yield RuleComparison(
            rule=str(c.rule),
            variable=str(c.variable),
            value=float(c.value),
            sign=str(c.sign),
            threshold=str(c.threshold),
            limit=float(c.limit),
            margin=float(c.margin),
        )
