"""A take: one speaker says one sound, and a segment of it counts."""

import math
import re
from dataclasses import asdict, dataclass, fields
from pathlib import PurePosixPath
from typing import Any

from phonemeengine.errors import TakeError
from phonemeengine.labels.label import CORE, Label
from phonemeengine.phonemes import PHONEMES_BY_LABEL, Phoneme
from phonemeengine.storage.strict_table import StrictTable, shown

TRIMMED = "trimmed"
"""The certainty of what lies outside the segment that counts."""

TAKES, DELETED = "takes", "deleted"
"""The folders of sounds in a project."""

LONGEST_NAME = 60
"""Characters of a speaker's folder."""

_RESERVED = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
_FILE_NAME = re.compile(r"(?P<phoneme>[a-z]+)-(?P<number>\d{1,9})\b")


@dataclass(frozen=True)
class Take:
    """One sound that was said to calibrate.

    Attributes
    ----------
    number : which take of the project it is, from 1.
    sound : the sound file, a path in the project's folder with ``/`` between its parts.
    speaker : who said it.
    phoneme : what was said.
    duration : length of the sound file, seconds.
    start, end : what counts of it, seconds.
    onset, offset : where the sound begins and ends; what lies before and after is background noise.
    device : the microphone, or the file that the sound is from.
    time : when it was recorded, in ISO 8601.
    excluded : whether it counts for nothing, for now.
    deleted : whether it lies among what was deleted.
    pauses : where nothing is said between its start and its end, (start, end) in seconds, in order.

    Raises
    ------
    TakeError : a time lies outside the sound, or the file outside the project's folders.
    """

    number: int
    sound: str
    speaker: str
    phoneme: Phoneme
    duration: float
    start: float
    end: float
    onset: float
    offset: float
    device: str = ""
    time: str = ""
    excluded: bool = False
    deleted: bool = False
    pauses: tuple[tuple[float, float], ...] = ()

    def __post_init__(self) -> None:
        times = (self.duration, self.start, self.end, self.onset, self.offset)
        inside = 0 <= self.start < self.end <= self.duration and 0 <= self.onset <= self.offset <= self.duration
        if not (all(map(math.isfinite, times)) and inside):
            raise TakeError(
                f"{self.name}: what counts of a take must lie in its {self.duration:g} s, got "
                f"{self.start:g}..{self.end:g} s; choose a segment of the sound"
            )
        paused = [time for pause in self.pauses for time in pause]
        if paused != sorted(paused) or not all(0 <= time <= self.duration for time in paused):
            raise TakeError(
                f"{self.name}: pauses must follow one another in the sound, got {self.pauses!r:.60}; correct them"
            )
        parts = PurePosixPath(self.sound).parts
        if len(parts) < 2 or parts[0] not in {TAKES, DELETED} or ".." in parts or re.search(r"[\\:\0]", self.sound):
            raise TakeError(
                f"a take's sound must lie in {TAKES}/ or {DELETED}/ of its project, got {self.sound!r:.80}; "
                "correct it"
            )

    @property
    def name(self) -> str:
        """What people call it, such as ``a-3``."""
        return f"{self.phoneme.label}-{self.number}"

    @property
    def labels(self) -> str:
        """The label file beside the sound, a path as in `sound`."""
        return str(PurePosixPath(self.sound).with_suffix(".csv"))

    def to_labels(self) -> tuple[Label, ...]:
        """Return the labels of the whole sound; pauses in it are silence.

        What lies outside the segment that counts is not certain: where there is no sound it is silence, elsewhere
        it is unidentified, which no figure over the ten classes counts.
        """
        room, other, own = (Phoneme.SILENCE, TRIMMED), (Phoneme.UNIDENTIFIED, TRIMMED), (self.phoneme, CORE)
        onset, offset = min(self.onset, self.start), max(self.offset, self.end)
        inner = [min(max(time, self.start), self.end) for pause in self.pauses for time in pause]
        borders = (0.0, onset, self.start, *inner, self.end, offset, self.duration)
        spoken = (own, *((Phoneme.SILENCE, CORE), own) * len(self.pauses))
        stretches = zip(borders, borders[1:], (room, other, *spoken, other, room), strict=False)
        return tuple(
            Label(start, end, phoneme.label, phoneme, certainty)
            for start, end, (phoneme, certainty) in stretches
            if end > start
        )

    def to_entry(self) -> dict[str, Any]:
        """Return it as an entry of a list in JSON."""
        return {**asdict(self), "phoneme": self.phoneme.label}


_FIELDS: dict[str, Any] = {field.name: field.type for field in fields(Take)} | {"pauses": list}
"""What an entry of a list holds, and of which kind it is."""


def take_of(entry: Any) -> Take:
    """Read an entry of a list of takes.

    Raises
    ------
    TakeError : it lacks something, or says something impossible.
    """
    if not isinstance(entry, dict):
        raise TakeError(f"a take must be a table, found {shown(entry)}; correct it")
    values = StrictTable(entry, "a take", TakeError).read(_FIELDS, ("pauses",))
    return Take(**values | {"pauses": _pauses_of(entry.get("pauses", []))})


def _pauses_of(entry: list[Any]) -> tuple[tuple[float, float], ...]:
    """Read the pauses of a take; older lists have none."""
    if not all(isinstance(p, list) and len(p) == 2 and all(type(t) in {int, float} for t in p) for p in entry):
        raise TakeError(f"pauses must be a list of pairs of seconds, found {shown(entry)}; correct it")
    return tuple((float(start), float(end)) for start, end in entry)


def folder_for(speaker: str) -> str:
    """Return a folder's name for a speaker that every disk accepts; two speakers may share one."""
    name = "".join(c if c.isalnum() or c in " -_" else "_" for c in speaker)[:LONGEST_NAME].strip(" .")
    return f"{name}_" if not name or _RESERVED.fullmatch(name) else name


def named_in(file: str) -> tuple[Phoneme, int] | None:
    """Return the phoneme and the number that a sound file's name tells; None where it is no take's."""
    found = _FILE_NAME.match(file)
    if found is None or found["phoneme"] not in PHONEMES_BY_LABEL:
        return None
    return PHONEMES_BY_LABEL[found["phoneme"]], int(found["number"])
