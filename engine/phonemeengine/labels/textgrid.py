"""Praat's TextGrid files, in the long and in the short text format.

To Praat both are one format: it reads the numbers, the texts in double quotes and the flags in angle brackets that
stand free, one after the other, and takes all else for remarks (Praat manual, "TextGrid file formats"). So does this.
praatio and textgrid give a cut-off file as if it were whole, or leave out intervals that they cannot read.
"""

import math
import re
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from typing_extensions import override

from phonemeengine.errors import CorpusError
from phonemeengine.execution import Closing
from phonemeengine.labels.utterance import ROUNDING, Label, RawLabel
from phonemeengine.storage.files import begins_like

INTERVALS, POINTS = "IntervalTier", "TextTier"
_IN_MEMORY = 1 << 20
"""Bytes of a tier that are kept in memory while it is written."""

_HEADER = 'File type = "ooTextFile"\nObject class = "TextGrid"\n\n'
_WORD = re.compile(
    r'"(?P<text>[^"]*+(?:""[^"]*+)*+)"(?=\s|$)|(?P<remark>![^\n]*)|(?P<flag><[^\s>]*>)(?=\s|$)|(?P<word>\S+)'
)
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*(?:e[-+]?\d+)?|nan|inf(?:inity)?)", re.IGNORECASE | re.ASCII)

Interval = tuple[float, float, str]
"""Start and end, seconds, and the text."""

owns = begins_like(
    b"%sxmin = 0 \nxmax = [0-9.]+ \ntiers\\? <exists> \nsize = [1-4] \nitem \\[\\]: \n    item \\[1\\]: \n"
    b'        class = "IntervalTier" \n        name = "(?:phonemes|words)" \n' % _HEADER.encode()
)
"""Whether the content of a file is a long TextGrid as it was written here: what Praat saves has no space after the
number of an item."""


@dataclass(frozen=True)
class Tier:
    """A tier: its name, and those of its intervals, or points, that have a name.

    Attributes
    ----------
    points : whether it is one of points, whose labels end where they start.
    """

    name: str
    raw_labels: tuple[RawLabel, ...]
    points: bool = False


def tiers_of(text: str, file: str, *, points: bool = False) -> tuple[Tier, ...]:
    """Read the interval tiers from the text of a TextGrid.

    Parameters
    ----------
    text : of the whole file, lines ending in ``\\n``.
    file : what the file is called in a refusal.
    points : whether tiers of points are given, too; else they are passed over.

    Raises
    ------
    CorpusError : this is no TextGrid, or it is cut off or damaged; says where.
    """
    if text.startswith("ooBinaryFile"):
        raise CorpusError(f"{file}: this TextGrid is binary; save it in Praat as a text file")
    words = _Words(text, file)
    if not words.text("the kind of file").startswith("ooTextFile") or words.text("the kind of object") != "TextGrid":
        raise CorpusError(f"{file}: this is no TextGrid; save it in Praat as a TextGrid, as a text file")
    words.number("where it begins")
    words.number("where it ends")
    n_tiers = words.count("the number of tiers") if words.flag() == "<exists>" else 0
    tiers = [_next_tier(words, k + 1) for k in range(n_tiers)]
    words.check_end()
    return tuple(tier for tier in tiers if points or not tier.points)


def length_of(text: str, file: str) -> float:
    """Return how long a TextGrid says that its sound is, seconds.

    Raises
    ------
    CorpusError : as `tiers_of`.
    """
    words = _Words(text, file)
    for what in ("the kind of file", "the kind of object"):
        words.text(what)
    words.number("where it begins")
    return words.number("where it ends")


def format_textgrid(labels: Sequence[Label], duration: float, *, short: bool = False) -> str:
    """Write labels, in order of time, as the text of a TextGrid: a tier ``phonemes`` holds our names.

    Where the sounds have names of their own, a second tier ``phones`` holds those. What lies between labels is
    empty; labels without length, which Praat does not know, are left out.
    """
    tiers = {"phonemes": [(label.start, label.end, label.phoneme.label) for label in labels]}
    if any(label.phone != label.phoneme.label for label in labels):
        tiers["phones"] = [(label.start, label.end, label.phone) for label in labels]
    return format_tiers(tiers, max([duration, *(label.end for label in labels)]), short=short)


def format_tiers(tiers: Mapping[str, Sequence[Interval]], end: float, *, short: bool = False) -> str:
    """Write interval tiers, by name, as the text of a TextGrid that ends at `end` seconds."""
    stretches = {
        name: [RawLabel(first, last, text, "") for first, last, text in found] for name, found in tiers.items()
    }
    return format_grid([Tier(name, tuple(found)) for name, found in stretches.items()], end, short=short)


def format_grid(tiers: Sequence[Tier], end: float, *, short: bool = False) -> str:
    """Write tiers, of intervals and of points, as the text of a TextGrid that ends at `end` seconds."""
    lines = list(_lines(tiers, end))
    if short:
        return _HEADER + "".join(f"{value}\n" for _, value in lines if value is not None)
    return _HEADER + "".join(map(_long, lines))


class TierSpool(Closing):
    """An interval tier that may be long: what is added lies on the disk until the whole is written.

    Parameters
    ----------
    name : of the tier.
    silence : the name of the intervals between.
    """

    def __init__(self, name: str, silence: str = "") -> None:
        self._name, self._silence = name, silence
        self._file = tempfile.SpooledTemporaryFile(_IN_MEMORY, "w+", encoding="utf-8", newline="\n")  # noqa: SIM115 - `close` lets it go
        self._n, self._at = 0, "0"

    def add(self, start: float, end: float, text: str) -> None:
        """Add an interval, seconds, after all that were added before; one without length is left out."""
        first, last = _seconds(start), _seconds(end)
        if float(first) - float(self._at) > ROUNDING:
            self._append(self._at, first, self._silence)
            self._at = first
        first = self._at
        if float(last) > float(first):
            self._append(first, last, text)
            self._at = last

    @override
    def close(self) -> None:
        """Forget what was added."""
        self._file.close()

    def lines(self, number: int, end: float) -> Iterator[str]:
        """Return the tier as the lines of a TextGrid that ends at `end` seconds, as its tier of this number."""
        self.add(end, end, "")
        yield from map(_long, _tier_head(number, self._name, INTERVALS, end))
        yield _long(("        intervals: size = ", str(self._n)))
        self._file.seek(0)
        yield from self._file

    def _append(self, first: str, last: str, text: str) -> None:
        self._n += 1
        self._file.writelines(map(_long, _interval(self._n, first, last, text)))


def grid_lines(tiers: Sequence[TierSpool], end: float) -> Iterator[str]:
    """Return tiers as the lines of a TextGrid that ends at `end` seconds, as `format_tiers` has them."""
    yield _HEADER
    yield from map(_long, _head(len(tiers), end))
    for number, tier in enumerate(tiers, 1):
        yield from tier.lines(number, end)


def _long(line: tuple[str, str | None]) -> str:
    return f"{line[0]}{'' if line[1] is None else line[1]} \n"


class _Words:
    """The numbers, texts and flags of a file, one after the other."""

    def __init__(self, text: str, file: str) -> None:
        self._text = text
        self._file = file
        self._found = _WORD.finditer(text)
        self._at = 0

    def text(self, what: str) -> str:
        kind, value = self._next()
        if kind != "text":
            self._refuse(what, "a text in double quotes", value)
        return value.replace('""', '"')

    def number(self, what: str) -> float:
        kind, value = self._next()
        if kind != "number":
            self._refuse(what, "a number", value)
        return float(value)

    def count(self, what: str) -> int:
        number = self.number(what)
        if not (number >= 0 and math.isfinite(number) and number == int(number)):
            self._refuse(what, "a whole number from 0", f"{number:g}")
        return int(number)

    def flag(self) -> str:
        kind, value = self._next()
        if kind != "flag":
            self._refuse("whether there are tiers", "<exists>", value)
        return value

    def check_end(self) -> None:
        kind, value = self._next()
        if kind:
            self._refuse("the end of the file", "nothing more", value)

    def _next(self) -> tuple[str, str]:
        """Return the kind and the value of the next word that counts; empty ones at the end of the file."""
        for match in self._found:
            kind, value = str(match.lastgroup), match.group(match.lastgroup or 0)
            self._at = match.start()
            if kind == "word" and _NUMBER.fullmatch(value):
                return "number", value
            if kind in {"text", "flag"}:
                return kind, value
            if kind == "word" and value.startswith('"'):
                break
        self._found = iter(())
        return "", ""

    def _refuse(self, what: str, expected: str, value: str) -> None:
        line = self._text.count("\n", 0, self._at) + 1
        found = repr(value[:20]) if value else "the end of the file or a text without its closing quote"
        raise CorpusError(
            f"{self._file}, line {line}: {what} must be {expected}, found {found}; the file is cut off or damaged, "
            "so save it in Praat again"
        )


def _next_tier(words: _Words, number: int) -> Tier:
    kind = words.text(f"the kind of tier {number}")
    name = words.text(f"the name of tier {number}")
    words.number(f"where tier {name!r:.40} begins")
    words.number(f"where tier {name!r:.40} ends")
    n_labels = words.count(f"the number of intervals in tier {name!r:.40}")
    raw_labels = [
        raw for k in range(n_labels) if (raw := _next_label(words, kind, f"tier {name!r:.40}, interval {k + 1}")).name
    ]
    return Tier(name, tuple(raw_labels), kind != INTERVALS)


def _next_label(words: _Words, kind: str, place: str) -> RawLabel:
    start = words.number(f"the beginning of {place}")
    end = words.number(f"the end of {place}") if kind == INTERVALS else start
    return RawLabel(start, end, words.text(f"the name of {place}").strip(), place)


def _lines(tiers: Sequence[Tier], end: float) -> Iterator[tuple[str, str | None]]:
    """Return what stands in front of each value in the long format, and the value; None where there is none."""
    yield from _head(len(tiers), end)
    for number, tier in enumerate(tiers, 1):
        yield from _tier_head(number, tier.name, POINTS if tier.points else INTERVALS, end)
        yield from _points(tier.raw_labels) if tier.points else _intervals(tier.raw_labels, end)


def _head(n_tiers: int, end: float) -> Iterator[tuple[str, str | None]]:
    yield "xmin = ", "0"
    yield "xmax = ", _seconds(end)
    yield "tiers? ", "<exists>"
    yield "size = ", str(n_tiers)
    yield "item []:", None


def _tier_head(number: int, name: str, kind: str, end: float) -> Iterator[tuple[str, str | None]]:
    yield f"    item [{number}]:", None
    yield "        class = ", _quoted(kind)
    yield "        name = ", _quoted(name)
    yield "        xmin = ", "0"
    yield "        xmax = ", _seconds(end)


def _intervals(labels: Sequence[RawLabel], end: float) -> Iterator[tuple[str, str | None]]:
    filled = list(_filled(labels, end))
    yield "        intervals: size = ", str(len(filled))
    for k, interval in enumerate(filled, 1):
        yield from _interval(k, *interval)


def _interval(number: int, first: str, last: str, text: str) -> Iterator[tuple[str, str | None]]:
    yield f"        intervals [{number}]:", None
    yield "            xmin = ", first
    yield "            xmax = ", last
    yield "            text = ", _quoted(text)


def _points(labels: Sequence[RawLabel]) -> Iterator[tuple[str, str | None]]:
    yield "        points: size = ", str(len(labels))
    for k, label in enumerate(labels, 1):
        yield f"        points [{k}]:", None
        yield "            number = ", _seconds(label.start)
        yield "            mark = ", _quoted(label.name)


def _filled(labels: Sequence[RawLabel], end: float) -> Iterator[tuple[str, str, str]]:
    """Return intervals that follow each other from 0 to the end, with empty ones in between."""
    at = "0"
    for first, last, text in [(_seconds(x.start), _seconds(x.end), x.name) for x in labels]:
        if float(first) > float(at):
            yield at, first, ""
        if float(last) > float(first):
            yield first, last, text
            at = last
    if float(_seconds(end)) > float(at):
        yield at, _seconds(end), ""


def _seconds(value: float) -> str:
    return f"{value:.6f}".rstrip("0").rstrip(".") or "0"


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"'
