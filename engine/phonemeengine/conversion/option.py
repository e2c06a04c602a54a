"""How options are declared and read, and those of recognition, which the window has too.

What else a conversion is asked stands in `phonemeengine.conversion.options`, whose imports take longer.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, fields
from enum import StrEnum
from pathlib import Path
from typing import Any

from phonemeengine.errors import OptionError, remedy
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.presets.model_choice import WITHOUT_ENCODER
from phonemeengine.settings import MOST_CHANNELS, Channel, Decoding, ModelKind

# What reads the words of an option; each refuses by the end of a sentence, which begins with the option's name.


@dataclass(frozen=True)
class Number:
    """Reads a number.

    Attributes
    ----------
    low, high : its limits.
    unit : of these.
    whole : whether it has no fraction.
    """

    low: float = -math.inf
    high: float = math.inf
    unit: str = ""
    whole: bool = False

    def __call__(self, words: str) -> Any:
        """Return the number, finite and within its limits.

        Raises
        ------
        OptionError : it is none.
        """
        try:
            value = float(words) if not self.whole else int(words) if words.isdecimal() else math.nan
        except ValueError:
            value = math.nan
        if not (abs(value) < math.inf and self.low <= value <= self.high):
            kind = "a whole number" if self.whole else "a number"
            raise OptionError(f"must be {kind}{self._limits}, got {words!r}")
        return value

    @property
    def _limits(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        if self.high < math.inf:
            return f" in {self.low:g}..{self.high:g}{unit}"
        return f" of {self.low:g}{unit} or more" if self.low > -math.inf else ""


@dataclass(frozen=True)
class OneOf:
    """Reads one of some words.

    Attributes
    ----------
    known : the words, or an enumeration of them.
    """

    known: Sequence[str] | type[StrEnum]

    def __call__(self, words: str) -> str:
        """Return it as it is known.

        Raises
        ------
        OptionError : it is none of them.
        """
        for word in self.known:
            if words == word:
                return word
        raise OptionError(f"there is no {words!r}; {remedy(words, self.known)}")


@dataclass(frozen=True)
class PictureSize:
    """Reads width and height of a picture, such as 640x480.

    Attributes
    ----------
    least, most : width and height at least and at most, pixels.
    """

    least: tuple[int, int]
    most: tuple[int, int]

    def __call__(self, words: str) -> tuple[int, int]:
        """Return width and height, pixels.

        Raises
        ------
        OptionError : they are none, or beyond the limits.
        """
        try:
            width, height = (int(part) for part in words.lower().split("x"))
        except ValueError:
            raise OptionError(f"must be like {self.least[0]}x{self.least[1]}, got {words!r}") from None
        if not (self.least[0] <= width <= self.most[0] and self.least[1] <= height <= self.most[1]):
            limits = "..".join(f"{w}x{h}" for w, h in (self.least, self.most))
            raise OptionError(f"must lie in {limits}, got {words!r}")
        return width, height


def read_switch(words: str) -> bool:
    """Read whether something is on.

    Raises
    ------
    OptionError : the words do not say it.
    """
    if words not in {"true", "false"}:
        raise OptionError(f"must be true or false, got {words!r}")
    return words == "true"


def read_channel(words: str) -> Channel:
    """Read a channel.

    Raises
    ------
    OptionError : it is none.
    """
    try:
        return Channel(words)
    except ValueError:
        limits = f"mix, left, right, or a number in 1..{MOST_CHANNELS}"
        raise OptionError(f"must be {limits}, got {words!r}") from None


@dataclass(frozen=True)
class Option:
    """An option of conversions.

    Attributes
    ----------
    words : what it does, for people.
    value : what stands for its value in a line of help, such as ``N``; empty for a switch.
    read : gives the value that words mean, or refuses them by the end of a sentence.
    default : the value of who does not give it.
    limits : the least and the most that it may be, where it is a number; the engine refuses others.
    several : whether it may be given more than once.
    needs : the options of which one must be given beside it, and what these say.
    elsewhere : whether a client on another machine may give it: it names no file of this one.
    """

    words: str
    value: str = ""
    read: Callable[[str], Any] = str
    default: Any = None
    limits: tuple[float, float] | None = None
    several: bool = False
    needs: tuple[tuple[str, ...], str] = (), ""
    elsewhere: bool = True


def option(words: str, value: str = "", read: Callable[[str], Any] = str, default: Any = None, **more: Any) -> Any:
    """Declare a field of a dataclass as an `Option`; return the field."""
    return field(default=default, metadata={"option": Option(words, value, read, default, **more)})


def switch(words: str, **more: Any) -> Any:
    """Declare an option that is on or off; return its field."""
    return option(words, "", read_switch, False, **more)


def file_option(words: str, value: str = "FILE", **more: Any) -> Any:
    """Declare an option that names a file of this machine; return its field."""
    return option(words, value, Path, elsewhere=False, **more)


def files_option(words: str, value: str, **more: Any) -> Any:
    """Declare an option that names files of this machine; return its field."""
    return option(words, value, Path, (), several=True, elsewhere=False, **more)


@dataclass(frozen=True)
class RecognitionOptions:
    """What is asked of recognition."""

    preset: Path = option(
        "preset, PhonemeData file, or name of a factory preset", "PRESET", Path, DEFAULT_PRESET, elsewhere=False
    )
    model: ModelKind | None = option(
        f"model that recognises (default: the best available); {WITHOUT_ENCODER}",
        "|".join(ModelKind),
        OneOf(ModelKind),
        elsewhere=False,
    )
    decoder: Decoding | None = option(
        "decoder of rules: off, none, or a language", "|".join(Decoding), OneOf(Decoding), elsewhere=False
    )
    channel: Channel = option(
        "channel to analyse: mix, left, right, or a number from 1", "C", read_channel, Channel.MIX
    )


def options_of(declared: type) -> dict[str, Option]:
    """Return the options that a dataclass declares, by name."""
    return {each.name.replace("_", "-"): each.metadata["option"] for each in fields(declared)}


RECOGNITION = options_of(RecognitionOptions)
"""Those of recognition, by name."""
