"""Recognisers from other packages, found through Python's entry points, their every answer checked.

A package declares one in its ``pyproject.toml``::

    [project.entry-points."phonemeanalyser.recognisers"]
    loudness = "package.module:Loudness"

What it names is a `RecogniserSpec`, or, the short way, a class that is made from `Thresholds`.
"""

import sys
from collections.abc import Callable, Iterable
from dataclasses import fields
from functools import cached_property, lru_cache
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import AudioError, CorpusError, RecogniserError
from phonemeengine.execution import Cancelled
from phonemeengine.features.variables import Features
from phonemeengine.labels.visemes import VisemeSet
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import Thresholds
from phonemeengine.recognition.scores import Recognition, RuleComparison, Trace

GROUP = "phonemeanalyser.recognisers"
"""The group of entry points in which packages offer recognisers."""
LONGEST = 160
"""Characters that are shown of a foreign error."""
MOST_LOOK_AHEAD = 100
"""Frames: who waits longer than a second for what comes is no use to a mouth."""


class PlugIn:
    """A recogniser from another package; whatever it does wrong is one sentence.

    It needs no more than `recognise` and `explain`, and `recognise` may give bare codes. It is made when it is first
    asked for anything, by the thread that asks: making it may take a while.

    Parameters
    ----------
    entry : what its package declares.
    make : makes it.
    wanted_scores : the scores that it must have; None where it may have any.
    """

    def __init__(
        self, entry: EntryPoint, make: Callable[[], object], wanted_scores: tuple[str, ...] | None = None
    ) -> None:
        self._entry = entry
        self._make = make
        self._wanted_scores = wanted_scores
        self._n_early: int | None = None

    @cached_property
    def look_ahead(self) -> int:
        """Frames after a frame that it says it waits for; RecogniserError where it cannot be made, or lies."""
        found: int = self._call("say how far it looks ahead", lambda: int(getattr(self._recogniser, "look_ahead", 0)))
        if not 0 <= found <= MOST_LOOK_AHEAD:
            raise self._refusal(f"looks {found} frames ahead, and 0..{MOST_LOOK_AHEAD} are allowed")
        return found

    @cached_property
    def scores(self) -> tuple[str, ...]:
        """The names of its scores; RecogniserError where it cannot be made, or they are not those wanted."""
        recogniser = self._recogniser
        names: tuple[str, ...] = self._call(
            "name its scores", lambda: tuple(str(name) for name in getattr(recogniser, "scores", ()))
        )
        if self._wanted_scores is not None and names != self._wanted_scores:
            raise self._refusal("is tuned by sensitivities, so its scores must be those of all phonemes")
        return names

    @cached_property
    def used_thresholds(self) -> frozenset[str]:
        """The fields of `Thresholds` that it says it compares with; RecogniserError where it cannot be made."""
        recogniser = self._recogniser
        used: frozenset[str] = self._call(
            "name its thresholds", lambda: frozenset(getattr(recogniser, "used_thresholds", ()))
        )
        return used & {field.name for field in fields(Thresholds)}

    def recognise(self, windows: Float32Array, features: Features) -> Recognition:
        """Recognise a block.

        Raises
        ------
        RecogniserError : it cannot be made, it failed, or what it gave are no codes of phonemes, or no scores or
            visemes, one for each frame.
        """
        recogniser = self._recogniser
        given = self._call(
            "recognise", lambda: recogniser.recognise(_read_only(windows), _read_only_features(features))
        )
        found = given if isinstance(given, Recognition) else Recognition(given)
        n = self._n_due(len(features.values))
        _check(found.phonemes, np.uint8, (n,), "codes", self._refusal)
        if n and found.phonemes.max() >= len(Phoneme):
            raise self._refusal(f"gave the code {found.phonemes.max()}, and phonemes are 0..{len(Phoneme) - 1}")
        scores = visemes = None
        if self.scores:
            _check(found.scores, np.float32, (n, len(self.scores)), "scores", self._refusal)
            assert found.scores is not None
            scores = found.scores.copy()
        if found.visemes is not None:
            if not isinstance(found.viseme_set, VisemeSet):
                raise self._refusal(f"gave a {type(found.viseme_set).__name__} where a VisemeSet is wanted")
            _check(found.visemes, np.float32, (n, len(found.viseme_set.names)), "visemes", self._refusal)
            visemes = found.visemes.copy()
        return Recognition(found.phonemes.copy(), scores, visemes, found.viseme_set)

    def deficits(self, features: Features) -> Float32Array | None:
        """Return by how much each phoneme falls short, shape (n_frames, n_phonemes), or None where it does not say.

        Raises
        ------
        RecogniserError : it cannot be made, it failed, or what it gave are no numbers for each frame and phoneme.
        """
        ask = getattr(self._recogniser, "deficits", None)
        found = None if ask is None else self._call("say what falls short", ask, _read_only_features(features))
        if found is not None:
            _check(found, np.float32, (len(features.values), len(Phoneme)), "deficits", self._refusal)
        return found

    def explain(self, features: Features, k: int) -> Trace:
        """Return why frame `k` of a block is recognised as it is.

        Raises
        ------
        RecogniserError : it cannot be made, it failed, or what it gave is no `Trace`.
        """
        recogniser = self._recogniser
        trace: Trace = self._call("say why", lambda: _checked(recogniser.explain(_read_only_features(features), k)))
        return trace

    @cached_property
    def _recogniser(self) -> Any:
        return self._call("be made", self._make)

    def _n_due(self, n_frames: int) -> int:
        """Return how many answers the next frames give: the first ones of a sound wait for what comes."""
        early = self.look_ahead if self._n_early is None else self._n_early
        self._n_early = max(0, early - n_frames)
        return max(0, n_frames - early)

    def _call(self, what: str, act: Callable[..., Any], *arguments: Any) -> Any:
        return call_foreign(self._entry, what, act, *arguments)

    def _refusal(self, what: str) -> RecogniserError:
        return _refusal(self._entry, what)


def completed(recogniser: Any) -> Any:
    """Return an object of one's own as a whole `Recogniser`, its answers checked; a whole one stays as it is."""
    if all(hasattr(recogniser, part) for part in ("look_ahead", "scores", "used_thresholds", "deficits")):
        return recogniser
    kind = type(recogniser)
    return PlugIn(EntryPoint(kind.__name__, f"{kind.__module__}:{kind.__qualname__}", GROUP), lambda: recogniser)


def call_foreign(entry: EntryPoint, what: str, act: Callable[..., Any], *arguments: Any) -> Any:
    """Have the code of another package do something; what it raises becomes a sentence, even where it wants to exit.

    Raises
    ------
    RecogniserError : it failed.
    AudioError, CorpusError, Cancelled : as they are: it said what is wrong with a sound or with recordings, or was
        no longer wanted.
    """
    try:
        return act(*arguments)
    except (AudioError, CorpusError, RecogniserError, Cancelled):
        raise
    except (Exception, SystemExit) as error:
        text = f"{type(error).__name__}: {error}"
        line = " ".join("".join(c if c.isprintable() else " " for c in text).split())
        shown = line if len(line) <= LONGEST else line[:LONGEST] + "…"
        raise _refusal(entry, f"cannot {what} ({shown.removesuffix(':')})") from error


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


def _refusal(entry: EntryPoint, what: str) -> RecogniserError:
    name = f"the recogniser {entry.name!r} of the package {package_of(entry)}"
    return RecogniserError(f"{name} {what}; choose another recogniser")


def _read_only(values: Float32Array) -> Float32Array:
    """Return the same values, but not to be written to: they are shown and saved, too."""
    view = values.view()
    view.flags.writeable = False
    return view


def _read_only_features(features: Features) -> Features:
    return Features(features.names, _read_only(features.values))


def _check(
    array: object, dtype: type, shape: tuple[int, ...], what: str, refusal: Callable[[str], RecogniserError]
) -> None:
    """Refuse what is no array of a type and shape."""
    if not isinstance(array, np.ndarray) or array.dtype != dtype or array.shape != shape:
        found = (
            f"{array.dtype}, shape {array.shape}" if isinstance(array, np.ndarray) else f"a {type(array).__name__}"
        )
        raise refusal(f"gave {found} where {what} of {np.dtype(dtype)}, shape {shape}, are wanted")


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
