"""Writing speech in one format, with options."""

import math
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

from phonemeengine.errors import ExportError, MouthError, remedy
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.animation import HIGHEST_RATE, LOWEST_RATE, Animation
from phonemeengine.mouth.cues import MINIMUM, Cue, cues_of
from phonemeengine.mouth.exports.export import NEARLY, Export
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.expression.composer import with_stream
from phonemeengine.mouth.expression.felt import text_expression, timed_feelings
from phonemeengine.mouth.key_layer import NO_KEYS, KeyLayer
from phonemeengine.mouth.performer import IdleMotion
from phonemeengine.mouth.style import Style, neutral_style
from phonemeengine.mouth.table import MouthTable, load_table
from phonemeengine.mouth.transcript import Transcript

FACTORS = 0.1, 10.0
"""The least and the most by which all times of a mouth table may be multiplied."""


@dataclass(frozen=True)
class ExportOptions:
    """How speech shall be written; None leaves what suits the format.

    Attributes
    ----------
    rate : frames per second.
    minimum : least duration of a cue, seconds; a frame at least where frames are counted, and rounded up where times
        are rounded. Curves have no cues.
    anticipation : by how much the mouth is ahead of the sound, seconds.
    table : a mouth table's name or file.
    mesh : the file of the face that shall move; else it is the program's own head.
    idle : what else the face does.
    attack, release : factors of the times in which the table's shapes come and go.
    random : whether shapes and times vary a little, as they do in people.
    style : in which the face speaks.
    text_feeling : how far the face shows what the text says of feeling, 0..1; None for not at all.
    """

    rate: float | None = None
    minimum: float | None = None
    anticipation: float | None = None
    table: str | os.PathLike[str] | None = None
    mesh: str | os.PathLike[str] | None = None
    idle: IdleMotion = field(default_factory=IdleMotion)
    attack: float = 1.0
    release: float = 1.0
    random: bool = True
    style: Style = field(default_factory=neutral_style)
    text_feeling: float | None = None

    def mouth_table(self, usual: str) -> MouthTable:
        """Return the mouth table, the usual one unless another is asked for, with the speed that is asked for.

        Raises
        ------
        MouthError : it cannot be used, or a factor lies outside its limits.
        """
        for name, factor in (("attack", self.attack), ("release", self.release)):
            if not FACTORS[0] <= factor <= FACTORS[1]:
                limits = "{:g}..{:g}".format(*FACTORS)
                raise MouthError(f"{name} must be a factor in {limits}, got {factor:g}; choose another")
        table = load_table(self.table or usual)
        return self.style.on_table(table.with_motion(self.attack, self.release, random=self.random))

    def felt(self, text: str, utterance: Utterance | None) -> "ExportOptions":
        """Return the same of a face that shows what a text says of feeling while it is spoken; see `timed_feelings`.

        Raises
        ------
        TextError : a direction cannot be followed.
        """
        if not self.text_feeling or utterance is None or not text:
            return self
        stream = text_expression(timed_feelings(text, utterance), self.text_feeling)
        expressing = replace(self.idle, expression=with_stream(self.idle.expression, stream))
        return replace(self, idle=self.style.on_idle(expressing))


class Exporter:
    """Writes speech in one format; what the format cannot do is said at once.

    Parameters
    ----------
    name : of the format, as in `FORMATS`.
    options : how it shall be written.

    Attributes
    ----------
    rate : frames per second; 0 where the format counts none.

    Raises
    ------
    ExportError : there is no such format, or it cannot do what the options say.
    MouthError : the table cannot be used.
    """

    def __init__(self, name: str, options: ExportOptions | None = None) -> None:
        if name not in FORMATS:
            raise ExportError(f"there is no format {name!r}; {remedy(name, FORMATS)}")
        self.name, self.format = name, FORMATS[name]
        self._options = options or ExportOptions()
        self.idle = self._options.idle
        self._mesh = None if self._options.mesh is None else Path(self._options.mesh)
        self._table = self._options.mouth_table(self.format.table)
        self.rate = self._checked_rate()
        self._check_minimum()
        self._check_table()
        self._check_mesh()
        self._check_expression()
        self.export_of(Transcript("", 0.0))

    def felt(self, text: str, utterance: Utterance | None) -> "Exporter":
        """Return an exporter whose face shows what a text says of feeling, as far as its options ask for that.

        Raises
        ------
        ExportError : the format holds no expressions.
        TextError : a direction cannot be followed.
        """
        options = self._options.felt(text, utterance)
        return self if options is self._options else Exporter(self.name, options)

    def export_of(self, speech: Transcript, movement: Animation | None = None, keys: KeyLayer = NO_KEYS) -> Export:
        """Clean the cues of speech, and put together what the format writes; see `chunks_of`."""
        movement = None if movement is None else self._held(movement)
        options = self._options
        anticipation = self.format.anticipation if options.anticipation is None else options.anticipation
        cues: tuple[Cue, ...] = ()
        if self.format.has_cues:
            cues = cues_of(speech.runs, self._table, minimum=self._minimum(), anticipation=anticipation)
        table = options.style.with_tongue(self._table) if self.format.moves_mesh else self._table
        return Export(speech, table, cues, self.rate, self.idle, self._mesh, movement, anticipation, keys)

    def chunks_of(
        self, speech: Transcript, movement: Animation | None = None, keys: KeyLayer = NO_KEYS
    ) -> Iterator[bytes]:
        """Return the file, in parts as they are made.

        Parameters
        ----------
        speech : what was said, of which the cues are made.
        movement : how the face moves, at the exporter's rate, where the cues do not say that; for formats that hold
            the pose of a head.
        keys : an animator's edits of the movement, for the same formats.

        Raises
        ------
        ExportError : the format cannot hold the movement, or that has another rate.
        """
        written = self.format.write(self.export_of(speech, movement, keys))
        if isinstance(written, bytes):
            yield written
        else:
            yield from _encoded(written)

    def _minimum(self) -> float:
        """Return the least duration of a cue, seconds, which rounded times keep, and no less than a frame."""
        minimum = MINIMUM if self._options.minimum is None else self._options.minimum
        if self.rate:
            return max(minimum, 1 / self.rate)
        steps = self.format.steps
        return math.ceil(minimum * steps - NEARLY) / steps if steps else minimum

    def _checked_rate(self) -> float:
        rate, own = self._options.rate, self.format.rate
        if rate is None:
            return own
        if not own:
            raise ExportError(f"{self.name} counts no frames, so it has no frame rate; leave it out")
        if not LOWEST_RATE <= rate <= HIGHEST_RATE or (self.format.whole_rate and rate != round(rate)):
            kind = "a whole number" if self.format.whole_rate else "a number"
            raise ExportError(
                f"the frame rate of {self.name} must be {kind} in {LOWEST_RATE:g}..{HIGHEST_RATE:g} frames per "
                f"second, got {rate:g}; choose another"
            )
        return rate

    def _check_minimum(self) -> None:
        if self._options.minimum is not None and not self.format.has_cues:
            raise ExportError(f"{self.name} has curves and no cues, so there is no shortest cue; leave it out")

    def _check_table(self) -> None:
        table, known = self._table, self.format
        for shape in (*table.phonemes.values(), *table.phones.values()):
            if known.shapes and shape not in known.shapes:
                raise ExportError(
                    f"{self.name} knows the shapes {', '.join(sorted(known.shapes))}, but the table {table.name!r} "
                    f"has {shape!r}; choose another table"
                )
            if not shape or shape.split() != [shape]:
                self._refuse_spaces(shape)
        if known.movestates and table.movestates != known.movestates:
            raise ExportError(
                f"{self.name} holds the {len(known.movestates)} movestates {known.movestates[0]} ... "
                f"{known.movestates[-1]}, which are not those of the table {table.name!r}; choose another table"
            )

    def _refuse_spaces(self, shape: str) -> None:
        """Refuse names that would break the lines of a format that separates by spaces."""
        if self.format.separated:
            raise ExportError(
                f"{self.name} separates names by spaces, so {shape!r} of the table {self._table.name!r} cannot be "
                "one; rename it there"
            )

    def takes(self, movestates: tuple[str, ...]) -> bool:
        """Return whether a file can hold a movement of these movestates; it leaves out those that it has none for.

        It needs all that the format has, or a table that was asked for.
        """
        asked = () if self._options.table is None else self._table.movestates
        return self.format.moves_head and {*self.format.movestates, *asked} <= {*movestates}

    def _held(self, movement: Animation) -> Animation:
        """Return what the format holds of a movement."""
        known = self.format.movestates or movement.movestates
        if not self.takes(movement.movestates):
            raise ExportError(
                f"{self.name} is made of cues, or of movestates other than {movement.movestates[0]} ... "
                f"{movement.movestates[-1]}; leave the movement out"
            )
        if movement.rate != self.rate:
            raise ExportError(
                f"{self.name} has {self.rate:g} frames per second, the movement {movement.rate:g}; make it with these"
            )
        return movement if movement.movestates == known else movement.of_movestates(known)

    def _check_mesh(self) -> None:
        if self._mesh is not None and not self.format.moves_mesh:
            raise ExportError(f"{self.name} moves no mesh; leave {self._mesh.name} out, or choose gltf")

    def _check_expression(self) -> None:
        if not self.format.moves_head and (self.idle.expression is not None or self._options.text_feeling):
            raise ExportError(f"{self.name} holds no expressions; leave them out, or choose livelink-csv or gltf")
        if self.idle.expression is not None:
            self.idle.expression.check_fits(self._table.movestates, self._table.name)


def _encoded(parts: Iterable[str]) -> Iterator[bytes]:
    """Encode parts of text, many at a time."""
    waiting: list[str] = []
    for part in parts:
        waiting.append(part)
        if len(waiting) >= 1000:
            yield "".join(waiting).encode("utf-8", errors="replace")
            waiting.clear()
    yield "".join(waiting).encode("utf-8", errors="replace")
