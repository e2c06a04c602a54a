"""What is asked of a conversion, each option declared once: command lines, the server, the window and the manual."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from phonemeengine.conversion.option import (
    Number,
    OneOf,
    Option,
    PictureSize,
    RecognitionOptions,
    file_option,
    files_option,
    option,
    options_of,
    switch,
)
from phonemeengine.errors import MouthError, OptionError, remedy
from phonemeengine.mouth.animation import HIGHEST_RATE, LOWEST_RATE, NEEDS_FILE, FaceDriver
from phonemeengine.mouth.cues import LONGEST_MINIMUM, MINIMUM, MOST_ANTICIPATION
from phonemeengine.mouth.exports.exporter import FACTORS, ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.expression.felt import FeelingAmounts
from phonemeengine.mouth.expression.streams import ExpressionStream, expression_presets, held_expression
from phonemeengine.mouth.morph_mesh import Framing
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.performer import IdleMotion
from phonemeengine.mouth.style import NEUTRAL, load_style, shipped_styles
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.driver import PerformancePart
from phonemeengine.performance.face_csv import read_expression

RECORDED = ".csv"
"""Ends the name of a recorded expression."""
OTHER_DRIVERS = tuple(driver for driver in FaceDriver if driver is not FaceDriver.AUTO)
SERVED_DRIVERS = tuple(driver for driver in FaceDriver if driver not in NEEDS_FILE)
"""What moves a face where no file of recorded faces can be named."""
CLIP_EDGES = 16, 4096
"""The least and the most pixels along an edge of a clip."""
THEMES = "light", "dark"
"""The colours of pictures."""


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


_TEXT = ("text", "script"), "give the text that is spoken"
_TABLE = ("performance",), "name a table of recorded faces"


@dataclass(frozen=True)
class ConversionOptions(RecognitionOptions):
    """What is asked of a conversion; `OPTIONS` says of each field what it is.

    Raises
    ------
    OptionError : an option goes with another one that was not given, or excludes it.
    """

    longest: float = option(
        "refuse audio files longer than S seconds", "S", Number(0, unit="s"), math.inf, elsewhere=False
    )
    text: str | None = option("text that is spoken; makes recognition far more accurate", "TEXT")
    script: Path | None = file_option(
        "file with the text, table with a line FILE<TAB>TEXT for each file, .TextGrid or .json with word times, or "
        "auto: x.TextGrid with words, or x.txt, beside x.wav"
    )
    speaker: str | None = option(
        "speaker whose words are used, where a .TextGrid or .json has several", "NAME", needs=_TEXT, elsewhere=False
    )
    language: str | None = option("language of the text, such as en-us or de", "L", needs=_TEXT)
    lexicon: Path | None = file_option("pronunciations of words, .toml or .csv", needs=_TEXT)
    literal: bool = switch(
        "read speakers' names, [directions], *emphasis*, <tags> and &entities; as words", needs=_TEXT
    )
    accept_text: bool = switch("align even if the recording does not seem to match the text", needs=_TEXT)
    format: str | None = option("file format (default: from the ending of OUT)", "F", OneOf(tuple(FORMATS)))
    table: str | None = option(f"mouth table: a file, or one of {', '.join(shipped_tables())}", "T")
    fps: float | None = option(
        "frames per second (default: the format's)", "N", Number(), limits=(LOWEST_RATE, HIGHEST_RATE)
    )
    minimum: float | None = option(
        f"shortest cue ({MINIMUM} s), for formats that have cues", "S", Number(), limits=(0.0, LONGEST_MINIMUM)
    )
    anticipation: float | None = option(
        f"how far the mouth leads the sound, 0..{MOST_ANTICIPATION} s", "S", Number(), limits=(0.0, MOST_ANTICIPATION)
    )
    detail: Detail = option("units that the mouth follows", "|".join(Detail), OneOf(Detail), Detail.PHONEMES)
    attack: float = option("factor for the time that mouth shapes take to rise", "X", Number(), 1.0, limits=FACTORS)
    release: float = option("factor for the time that mouth shapes take to fall", "X", Number(), 1.0, limits=FACTORS)
    steady: bool = switch("do not vary shapes and times at random")
    no_blinks: bool = switch("keep the eyes open")
    no_head: bool = switch("keep the head still")
    seed: int | None = option("seed of random variation, including that of pinyin", "N", Number(0, whole=True))
    expression: tuple[str, ...] = option(
        f"expression added to speech: NAME=V,... (0..1) of {', '.join(expression_presets())} or blend shapes; or a "
        "Live Link Face or OpenFace CSV; may be repeated",
        "E",
        str,
        (),
        several=True,
    )
    feeling: FeelingAmounts | None = option(
        "follow the feeling in the voice: one number, 0..1, or any of brows=V,lids=V,smile=V,head=V",
        "V",
        read_feeling,
    )
    text_feeling: float | None = option(
        "follow the feeling in the text, 0..1: [smile], [angry 0.6], emoji, good and bad words", "V", Number(0, 1)
    )
    style: str | None = option(
        f"style of speaking: a file, one of your own, or one of {', '.join(shipped_styles())}", "S"
    )
    priority: str | None = option(
        "priority of speech over expressions, 0..1, on its own and on other channels", "S[,E]"
    )
    text_driver: FaceDriver = option(
        "what moves the face (auto: what --performance or --face-network names, pinyin for Chinese, else rules)",
        "|".join(FaceDriver),
        OneOf(FaceDriver),
        FaceDriver.AUTO,
    )
    beside: FaceDriver | None = option(
        "second head beside the first, moved by this driver",
        "|".join(OTHER_DRIVERS),
        OneOf(OTHER_DRIVERS),
        elsewhere=False,
    )
    pinyin_table: Path | None = file_option("your own pinyin table (.toml)", "T")
    spring: str | None = option("spring that moves the mouth: mass, stiffness, damping", "M,K,D")
    performance: tuple[Path, ...] = files_option(
        "table of recorded faces that moves the face; of several, --use, --person or the language selects one",
        "T.sqlite",
    )
    face_network: Path | None = file_option(
        "network that moves the face by the sound alone (performance learn)", "N.face"
    )
    use: str | None = option("name of the table to use", "NAME", needs=_TABLE, elsewhere=False)
    person: str | None = option("use a table of this person", "NAME", needs=_TABLE, elsewhere=False)
    choice: ExampleChoice | None = option(
        f"how to choose among examples of a unit (default: {ExampleChoice.VITERBI})",
        "|".join(ExampleChoice),
        OneOf(ExampleChoice),
        needs=_TABLE,
        elsewhere=False,
    )
    without: frozenset[PerformancePart] | None = option(
        f"parts to leave out, any of {','.join(PerformancePart)}", "PARTS", read_parts, needs=_TABLE, elsewhere=False
    )
    keywords: tuple[Path, ...] = files_option(
        "your own words with gestures, and conjunctions (TOML)", "F", needs=_TABLE
    )
    performance_sound: bool = switch(
        "speak with units of the table's recordings, timed and pitched as the voice would say them",
        needs=_TABLE,
        elsewhere=False,
    )
    units: Path | None = file_option(
        "write a table of the recording that each unit comes from", "OUT.csv", needs=_TABLE
    )
    mesh: Path | None = file_option("head: woman or man, or your own face: .glb, .vrm, .gltf, .obj or .x", "M")
    movestates: Path | None = file_option("its movestates: .3dm or .3dma", "F")
    keys: Path | None = file_option("edited keys of blend shapes, or auto: x.keys.toml beside x.wav")
    size: tuple[int, int] = option(
        "size of the picture in pixels (default: 640x640)",
        "WxH",
        PictureSize((CLIP_EDGES[0],) * 2, (CLIP_EDGES[1],) * 2),
        (640, 640),
        limits=CLIP_EDGES,
        elsewhere=False,
    )
    view: Framing = option(
        f"how much is in the picture (default: {Framing.FACE})",
        "|".join(Framing),
        OneOf(Framing),
        Framing.FACE,
        elsewhere=False,
    )
    transparent: bool = switch("transparent background, for .png and .gif", elsewhere=False)
    theme: str = option("colours (default: light)", "|".join(THEMES), OneOf(THEMES), THEMES[0], elsewhere=False)
    overwrite: bool = switch("replace existing files, however they were made", elsewhere=False)

    def __post_init__(self) -> None:
        if self.text is not None and self.script is not None:
            raise OptionError("--text and --script both give the text; leave one of them out")
        for name, declared in OPTIONS.items():
            others, why = declared.needs
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
            declared = OPTIONS[name]
            if len(given) > 1 and not declared.several:
                raise OptionError(f"{name} is given {len(given)} times; give it once")
            values[name.replace("-", "_")] = _served_value(name, declared, given)
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
OPTIONS = options_of(ConversionOptions)
"""All options, by name."""
SERVED = tuple(name for name, declared in OPTIONS.items() if declared.elsewhere)
"""Those that a client on another machine may give."""


def _served_value(name: str, declared: Option, given: Sequence[str]) -> Any:
    """Return what an option means to a client, who names no file: neither a mouth table nor an expression of his."""
    known = {"table": shipped_tables(), "style": shipped_styles(), "text-driver": SERVED_DRIVERS}.get(name)
    try:
        if name == "expression" and any(words.lower().endswith(RECORDED) for words in given):
            raise OptionError(f"must be like smile=0.5, and no file, got {given[0]!r}")
        values = [(OneOf(known) if known else declared.read)(words) for words in given]
    except OptionError as error:
        raise OptionError(f"{name} {error}" if str(error).startswith("must") else f"{name}: {error}") from None
    return tuple(values) if declared.several else values[0]


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
