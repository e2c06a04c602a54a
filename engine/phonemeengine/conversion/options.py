"""What is asked of a conversion, each option declared once: command lines, the server, the window and the manual."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from enum import StrEnum
from pathlib import Path
from typing import Any

from phonemeengine.errors import MouthError, OptionError, remedy
from phonemeengine.mouth.animation import HIGHEST_RATE, LOWEST_RATE
from phonemeengine.mouth.cues import LONGEST_MINIMUM, MINIMUM, MOST_ANTICIPATION
from phonemeengine.mouth.exports.exporter import FACTORS, ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.expression.felt import FeelingAmounts
from phonemeengine.mouth.expression.streams import ExpressionStream, expression_presets, held_expression
from phonemeengine.mouth.face_driver import NEEDS_FILE, FaceDriver
from phonemeengine.mouth.head import Framing
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.performer import IdleMotion
from phonemeengine.mouth.style import NEUTRAL, load_style, shipped_styles
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.driver import PerformancePart
from phonemeengine.performance.face_csv import read_expression
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.presets.model_choice import WITHOUT_ENCODER
from phonemeengine.settings import MOST_CHANNELS, Channel, Decoding, ModelKind

RECORDED = ".csv"
"""Ends the name of a recorded expression."""
OTHER_DRIVERS = tuple(driver for driver in FaceDriver if driver is not FaceDriver.AUTO)
SERVED_DRIVERS = tuple(driver for driver in FaceDriver if driver not in NEEDS_FILE)
"""What moves a face where no file of recorded faces can be named."""
CLIP_EDGES = 16, 4096
"""The least and the most pixels along an edge of a clip."""
THEMES = "light", "dark"
"""The colours of pictures."""


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


def read_parts(words: str) -> frozenset[PerformancePart]:
    """Read parts of a performance, with commas between them.

    Raises
    ------
    OptionError : there is no such part.
    """
    try:
        return frozenset(PerformancePart(part.strip()) for part in words.split(","))
    except ValueError:
        raise OptionError(f"must be any of {','.join(PerformancePart)}, with commas between, got {words!r}") from None


def read_feeling(words: str) -> FeelingAmounts:
    """Read how far parts of a face follow the feeling in the voice.

    Raises
    ------
    OptionError : there is no such part, or no number.
    """
    try:
        return FeelingAmounts.of(words)
    except MouthError as error:
        raise OptionError(str(error)) from None


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


def _option(words: str, value: str = "", read: Callable[[str], Any] = str, default: Any = None, **more: Any) -> Any:
    return field(default=default, metadata={"option": Option(words, value, read, default, **more)})


def _switch(words: str, **more: Any) -> Any:
    return _option(words, "", read_switch, False, **more)


def _file(words: str, value: str = "FILE", **more: Any) -> Any:
    return _option(words, value, Path, elsewhere=False, **more)


def _files(words: str, value: str, **more: Any) -> Any:
    return _option(words, value, Path, (), several=True, elsewhere=False, **more)


_TEXT = ("text", "script"), "give the text that is spoken"
_TABLE = ("performance",), "name a table of recorded faces"


@dataclass(frozen=True)
class ConversionOptions:
    """What is asked of a conversion; `OPTIONS` says of each field what it is.

    Raises
    ------
    OptionError : an option goes with another one that was not given, or excludes it.
    """

    preset: Path = _option(
        "preset, PhonemeData file, or name of a factory preset", "PRESET", Path, DEFAULT_PRESET, elsewhere=False
    )
    model: ModelKind | None = _option(
        f"model that recognises (default: the best available); {WITHOUT_ENCODER}",
        "|".join(ModelKind),
        OneOf(ModelKind),
        elsewhere=False,
    )
    decoder: Decoding | None = _option(
        "decoder of rules: off, none, or a language", "|".join(Decoding), OneOf(Decoding), elsewhere=False
    )
    channel: Channel = _option(
        "channel to analyse: mix, left, right, or a number from 1", "C", read_channel, Channel.MIX
    )
    longest: float = _option(
        "refuse audio files longer than S seconds", "S", Number(0, unit="s"), math.inf, elsewhere=False
    )
    text: str | None = _option("text that is spoken; makes recognition far more accurate", "TEXT")
    script: Path | None = _file(
        "file with the text, table with a line FILE<TAB>TEXT for each file, .TextGrid or .json with word times, or "
        "auto: x.TextGrid with words, or x.txt, beside x.wav"
    )
    speaker: str | None = _option(
        "speaker whose words are used, where a .TextGrid or .json has several", "NAME", needs=_TEXT, elsewhere=False
    )
    language: str | None = _option("language of the text, such as en-us or de", "L", needs=_TEXT)
    lexicon: Path | None = _file("pronunciations of words, .toml or .csv", needs=_TEXT)
    literal: bool = _switch(
        "read speakers' names, [directions], *emphasis*, <tags> and &entities; as words", needs=_TEXT
    )
    accept_text: bool = _switch("align even if the recording does not seem to match the text", needs=_TEXT)
    format: str | None = _option("file format (default: from the ending of OUT)", "F", OneOf(tuple(FORMATS)))
    table: str | None = _option(f"mouth table: a file, or one of {', '.join(shipped_tables())}", "T")
    fps: float | None = _option(
        "frames per second (default: the format's)", "N", Number(), limits=(LOWEST_RATE, HIGHEST_RATE)
    )
    minimum: float | None = _option(
        f"shortest cue ({MINIMUM} s), for formats that have cues", "S", Number(), limits=(0.0, LONGEST_MINIMUM)
    )
    anticipation: float | None = _option(
        f"how far the mouth leads the sound, 0..{MOST_ANTICIPATION} s", "S", Number(), limits=(0.0, MOST_ANTICIPATION)
    )
    detail: Detail = _option("units that the mouth follows", "|".join(Detail), OneOf(Detail), Detail.PHONEMES)
    attack: float = _option("factor for the time that mouth shapes take to rise", "X", Number(), 1.0, limits=FACTORS)
    release: float = _option("factor for the time that mouth shapes take to fall", "X", Number(), 1.0, limits=FACTORS)
    steady: bool = _switch("do not vary shapes and times at random")
    no_blinks: bool = _switch("keep the eyes open")
    no_head: bool = _switch("keep the head still")
    seed: int | None = _option("seed of random variation, including that of pinyin", "N", Number(0, whole=True))
    expression: tuple[str, ...] = _option(
        f"expression added to speech: NAME=V,... (0..1) of {', '.join(expression_presets())} or blend shapes; or a "
        "Live Link Face or OpenFace CSV; may be repeated",
        "E",
        str,
        (),
        several=True,
    )
    feeling: FeelingAmounts | None = _option(
        "follow the feeling in the voice: one number, 0..1, or any of brows=V,lids=V,smile=V,head=V",
        "V",
        read_feeling,
    )
    text_feeling: float | None = _option(
        "follow the feeling in the text, 0..1: [smile], [angry 0.6], emoji, good and bad words", "V", Number(0, 1)
    )
    style: str | None = _option(
        f"style of speaking: a file, one of your own, or one of {', '.join(shipped_styles())}", "S"
    )
    priority: str | None = _option(
        "priority of speech over expressions, 0..1, on its own and on other channels", "S[,E]"
    )
    text_driver: FaceDriver = _option(
        "what moves the face (auto: what --performance or --face-network names, pinyin for Chinese, else rules)",
        "|".join(FaceDriver),
        OneOf(FaceDriver),
        FaceDriver.AUTO,
    )
    beside: FaceDriver | None = _option(
        "second head beside the first, moved by this driver",
        "|".join(OTHER_DRIVERS),
        OneOf(OTHER_DRIVERS),
        elsewhere=False,
    )
    pinyin_table: Path | None = _file("your own pinyin table (.toml)", "T")
    spring: str | None = _option("spring that moves the mouth: mass, stiffness, damping", "M,K,D")
    performance: tuple[Path, ...] = _files(
        "table of recorded faces that moves the face; of several, --use, --person or the language selects one",
        "T.sqlite",
    )
    face_network: Path | None = _file("network that moves the face by the sound alone (performance learn)", "N.face")
    use: str | None = _option("name of the table to use", "NAME", needs=_TABLE, elsewhere=False)
    person: str | None = _option("use a table of this person", "NAME", needs=_TABLE, elsewhere=False)
    choice: ExampleChoice | None = _option(
        f"how to choose among examples of a unit (default: {ExampleChoice.VITERBI})",
        "|".join(ExampleChoice),
        OneOf(ExampleChoice),
        needs=_TABLE,
        elsewhere=False,
    )
    without: frozenset[PerformancePart] | None = _option(
        f"parts to leave out, any of {','.join(PerformancePart)}", "PARTS", read_parts, needs=_TABLE, elsewhere=False
    )
    keywords: tuple[Path, ...] = _files("your own words with gestures, and conjunctions (TOML)", "F", needs=_TABLE)
    performance_sound: bool = _switch(
        "speak with units of the table's recordings, timed and pitched as the voice would say them",
        needs=_TABLE,
        elsewhere=False,
    )
    units: Path | None = _file("write a table of the recording that each unit comes from", "OUT.csv", needs=_TABLE)
    mesh: Path | None = _file("head: woman or man, or your own face: .glb, .vrm, .gltf, .obj or .x", "M")
    movestates: Path | None = _file("its movestates: .3dm or .3dma", "F")
    keys: Path | None = _file("edited keys of blend shapes, or auto: x.keys.toml beside x.wav")
    size: tuple[int, int] = _option(
        "size of the picture in pixels (default: 640x640)",
        "WxH",
        PictureSize((CLIP_EDGES[0],) * 2, (CLIP_EDGES[1],) * 2),
        (640, 640),
        limits=CLIP_EDGES,
        elsewhere=False,
    )
    view: Framing = _option(
        f"how much is in the picture (default: {Framing.FACE})",
        "|".join(Framing),
        OneOf(Framing),
        Framing.FACE,
        elsewhere=False,
    )
    transparent: bool = _switch("transparent background, for .png and .gif", elsewhere=False)
    theme: str = _option("colours (default: light)", "|".join(THEMES), OneOf(THEMES), THEMES[0], elsewhere=False)
    overwrite: bool = _switch("replace existing files, however they were made", elsewhere=False)

    def __post_init__(self) -> None:
        if self.text is not None and self.script is not None:
            raise OptionError("--text and --script both give the text; leave one of them out")
        for name, option in OPTIONS.items():
            others, why = option.needs
            if others and self._gives(name) and not any(map(self._gives, others)):
                raise OptionError(f"--{name} goes with {' or '.join(f'--{other}' for other in others)}: {why}")

    def _gives(self, name: str) -> bool:
        return bool(getattr(self, name.replace("-", "_")) != OPTIONS[name].default)

    @classmethod
    def of_words(cls, words: Mapping[str, Sequence[str]]) -> "ConversionOptions":
        """Return the options that a client on another machine gives, by their names; each may have several values.

        Raises
        ------
        OptionError : there is no such option, or it cannot have such a value.
        """
        values: dict[str, Any] = {}
        for name, given in words.items():
            if name not in SERVED:
                raise OptionError(f"there is no option {name!a}; {remedy(name, SERVED)}")
            option = OPTIONS[name]
            if len(given) > 1 and not option.several:
                raise OptionError(f"{name} is given {len(given)} times; give it once")
            values[name.replace("-", "_")] = _served_value(name, option, given)
        return cls(**values)

    def written(self) -> ExportOptions:
        """Return how mouth cues and movements are written.

        Raises
        ------
        EngineError : there is no such expression, or a file cannot be read.
        """
        style = load_style(self.style or NEUTRAL)
        idle = IdleMotion(not self.no_blinks, not self.no_head, self.seed or 0, self.detail, self.expressed())
        return ExportOptions(
            self.fps,
            self.minimum,
            self.anticipation,
            self.table,
            self.mesh,
            style.on_idle(idle),
            self.attack,
            self.release,
            not self.steady,
            style,
            self.text_feeling,
        )

    def expressed(self, *more: ExpressionStream) -> Expression | None:
        """Return what a face expresses beside its speech, with more streams; None for nothing.

        Raises
        ------
        EngineError : there is no such expression, or a file cannot be read.
        """
        streams = (*map(_stream_of, self.expression), *more)
        if not (streams or self.feeling):
            if self.priority is not None:
                raise OptionError("--priority goes with --expression or --feeling; give one")
            return None
        if self.priority is None:
            return Expression(streams, feeling=self.feeling)
        speech, _, other = self.priority.partition(",")
        own, others = _share(speech, self.priority), _share(other, self.priority) if other else None
        return Expression(streams, own, others, feeling=self.feeling)


PICTURED = ("size", "view", "transparent", "theme")
"""Options that say how pictures and clips look."""
WEIGHTED = ("detail", "attack", "release", "steady", "seed", "style")
"""Options that say how the weights of movestates move."""
EXPRESSED = ("expression", "feeling", "text-feeling", "priority")
"""Those that say what a face expresses."""
_OF_TABLES = ("performance", "use", "person", "choice", "without", "keywords", "units")
DRIVEN = ("text-driver", "pinyin-table", "spring", *_OF_TABLES, "face-network")
"""Those that say what moves a face."""
FACIAL = ("no-blinks", "no-head", *EXPRESSED, *DRIVEN, "keys")
"""Those that say what a whole face does."""
OPTIONS: dict[str, Option] = {
    each.name.replace("_", "-"): each.metadata["option"] for each in fields(ConversionOptions)
}
"""All options, by name."""
SERVED = tuple(name for name, option in OPTIONS.items() if option.elsewhere)
"""Those that a client on another machine may give."""


def _served_value(name: str, option: Option, given: Sequence[str]) -> Any:
    """Return what an option means to a client, who names no file: neither a mouth table nor an expression of his."""
    known = {"table": shipped_tables(), "style": shipped_styles(), "text-driver": SERVED_DRIVERS}.get(name)
    try:
        if name == "expression" and any(words.lower().endswith(RECORDED) for words in given):
            raise OptionError(f"must be like smile=0.5, and no file, got {given[0]!r}")
        values = [(OneOf(known) if known else option.read)(words) for words in given]
    except OptionError as error:
        raise OptionError(f"{name} {error}" if str(error).startswith("must") else f"{name}: {error}") from None
    return tuple(values) if option.several else values[0]


def _stream_of(words: str) -> ExpressionStream:
    if words.lower().endswith(RECORDED):
        return read_expression(words)
    shares: dict[str, float] = {}
    for part in words.split(","):
        name, _, share = part.partition("=")
        shares[name.strip()] = _share(share, words) if share else 1.0
    return held_expression(shares)


def _share(text: str, words: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise MouthError(f"{words[:60]!r} holds no number where {text[:20]!r} is; write such as smile=0.5") from None
