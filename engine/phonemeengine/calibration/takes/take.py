"""A take, of which a segment counts, and the files of a project of takes, beside its sounds.

``takes.json`` is the list. ``manifest.csv`` and a label file for each take follow from it and are the corpus format;
deleted and excluded takes are not in the manifest. If the list is lost or damaged, takes come back from their sounds,
label files and the manifest.
"""

import filecmp
import json
import math
import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import asdict, dataclass, fields
from pathlib import Path, PurePosixPath
from typing import Any

from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import AudioError, CorpusError, TakeError
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.table import format_table, read_text, rows_of, table_of, write_text
from phonemeengine.labels.utterance import CORE, Label
from phonemeengine.phonemes import PHONEMES_BY_LABEL, Phoneme
from phonemeengine.storage.files import free_path
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


LIST, MANIFEST = "takes.json", "manifest.csv"
FORMAT, VERSION = "phonemeanalyser takes", 1
CORPUS = "takes"
MANIFEST_COLUMNS = ("corpus", "speaker", "wav", "labels", "duration_s", "device", "time")
SOUND_SUFFIX = ".flac"
SHOWN = 5
"""Files that a note names at most."""


@dataclass(frozen=True)
class TakeList:
    """What a project holds, as it was found.

    Attributes
    ----------
    takes : all of it, also what was deleted, excluded or has no sound.
    missing : numbers of the takes whose sounds are not there.
    notes : remarks for the user, a sentence each; mostly none.
    """

    takes: tuple[Take, ...]
    missing: frozenset[int]
    notes: tuple[str, ...]


def read_take_list(folder: Path) -> TakeList:
    """Read a project's list of takes, and find again what is not in it.

    Raises
    ------
    TakeError : a newer version of the program wrote the list, or the folder holds a corpus that is not the program's.
    CorpusError : the list is there and cannot be read.
    """
    listed, damage = _listed(folder)
    notes = []
    if damage:
        notes.append(_set_aside(folder / LIST, damage))
    lost = bool(damage) or not (folder / LIST).exists()
    found = tuple(_unlisted(folder, listed, told_by_manifest=lost and (folder / MANIFEST).exists()))
    if found:
        notes.append(f"{_shown(take.sound for take in found)} not in {LIST}, and taken in as labelled beside it")
    takes = (*listed, *found)
    missing = [take for take in takes if not (folder / take.sound).is_file()]
    if missing:
        notes.append(f"{_shown(take.sound for take in missing)} missing; put it back and open the project again")
    return TakeList(takes, frozenset(take.number for take in missing), tuple(notes))


def write_take_list(folder: Path, takes: Iterable[Take]) -> None:
    """Write the list; with this a change has happened.

    Raises
    ------
    CorpusError : it cannot be written.
    """
    document = {"format": FORMAT, "version": VERSION, "takes": [take.to_entry() for take in takes]}
    write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", folder / LIST)


def write_manifest(folder: Path, takes: Iterable[Take]) -> None:
    """Write the manifest of those takes that count, unless it says that already.

    Raises
    ------
    CorpusError : it cannot be written.
    """
    rows = [
        (CORPUS, take.speaker, take.sound, take.labels, f"{take.duration:.3f}", take.device, take.time)
        for take in takes
        if not (take.excluded or take.deleted)
    ]
    _write_if_new(table_of(MANIFEST_COLUMNS, rows), folder / MANIFEST)


def write_take_labels(folder: Path, take: Take) -> None:
    """Write the label file beside a take's sound, unless it says that already.

    Raises
    ------
    CorpusError : it cannot be written.
    """
    _write_if_new(format_table(take.to_labels()), folder / take.labels)


def _write_if_new(text: str, path: Path) -> None:
    with suppress(CorpusError):
        if read_text(path) == text:
            return
    write_text(text, path)


def _listed(folder: Path) -> tuple[tuple[Take, ...], str]:
    """Return the takes of the list that can be read, and what is wrong with the others; nothing where all is well."""
    if not (folder / LIST).exists():
        _check_manifest(folder)
        return (), ""
    text = read_text(folder / LIST)
    try:
        document = json.loads(text)
        version, entries = document["version"], document["takes"]
        if document["format"] != FORMAT or not isinstance(version, int) or not isinstance(entries, list):
            return (), f"it does not begin with {FORMAT!r}"
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        return (), f"{type(error).__name__} {error}"
    if version > VERSION:
        raise TakeError(
            f"{folder.name}: a newer version of the program wrote this project (version {version} of its list, known "
            f"is {VERSION}); open it with that"
        )
    return _readable(entries)


def _readable(entries: list[Any]) -> tuple[tuple[Take, ...], str]:
    takes: dict[int, Take] = {}
    damage = ""
    for entry in entries:
        try:
            take = take_of(entry)
        except TakeError as error:
            damage = damage or str(error)
            continue
        damage = damage or (f"it holds take {take.number} twice" if take.number in takes else "")
        takes.setdefault(take.number, take)
    return tuple(takes.values()), damage


def _check_manifest(folder: Path) -> None:
    """Refuse a corpus that is not ours, whose manifest must not be overwritten."""
    path = folder / MANIFEST
    if path.exists() and not read_text(path).startswith(",".join(MANIFEST_COLUMNS)):
        raise TakeError(
            f"{folder.name}: this folder is a corpus that was not made of takes; choose an empty folder for it"
        )


def _set_aside(path: Path, damage: str) -> str:
    """Keep a damaged list under another name, and tell it."""
    aside = free_path(path.with_name("takes.damaged.json"))
    write_text(read_text(path), aside)
    return (
        f"{path.name} is damaged ({damage:.100}); what could be read was read, the rest came back from the sounds "
        f"beside it, and the damaged list is kept as {aside.name}"
    )


def _unlisted(folder: Path, listed: tuple[Take, ...], *, told_by_manifest: bool) -> Iterator[Take]:
    """Return takes for the sounds in the project that are not in the list.

    What a crash left is the copy of a listed sound, and no take.
    """
    known = {take.sound: take for take in listed}
    by_number = {take.number: take for take in listed}
    rows = _manifest_rows(folder)
    free = max(by_number, default=0)
    for path in sorted((*folder.glob(f"{TAKES}/*/*{SOUND_SUFFIX}"), *folder.glob(f"{DELETED}/*/*{SOUND_SUFFIX}"))):
        sound, named = path.relative_to(folder).as_posix(), named_in(path.name)
        if sound in known or named is None or _is_copy(path, folder, by_number.get(named[1])):
            continue
        number = named[1]
        if number in by_number:
            free += 1
            number = free
        take = _take_from(path, sound, number, rows.get(sound), excluded=told_by_manifest and sound not in rows)
        if take is not None:
            by_number[number] = take
            free = max(free, number)
            yield take


def _take_from(path: Path, sound: str, number: int, row: dict[str, str] | None, *, excluded: bool) -> Take | None:
    """Make a take of a sound from its name and label file; None where the sound cannot be read."""
    named, row = named_in(path.name), row or {}
    try:
        with SoundReader(path) as reader:
            duration = reader.duration
    except AudioError:
        return None
    assert named is not None
    start, end, onset, offset = 0.0, duration, 0.0, duration
    pauses: tuple[tuple[float, float], ...] = ()
    with suppress(CorpusError):
        labels = read_labels(path.with_suffix(".csv"), duration=duration)
        core = [label for label in labels if label.certainty == CORE]
        start, end = core[0].start, min(core[-1].end, duration)
        counting = [label for label in labels if label.certainty == CORE or label.phoneme.label == "unidentified"]
        onset, offset = counting[0].start, min(counting[-1].end, duration)
        pauses = tuple((x.start, x.end) for x in core[1:-1] if x.phoneme is not named[0]) if named else ()
    return Take(
        number=number,
        sound=sound,
        speaker=row.get("speaker") or path.parent.name,
        phoneme=named[0],
        duration=duration,
        start=start,
        end=end,
        onset=onset,
        offset=offset,
        device=row.get("device", ""),
        time=row.get("time", ""),
        excluded=excluded and not sound.startswith(DELETED),
        deleted=sound.startswith(DELETED),
        pauses=pauses,
    )


def _manifest_rows(folder: Path) -> dict[str, dict[str, str]]:
    try:
        return {row["wav"]: row for _, row in rows_of(read_text(folder / MANIFEST), MANIFEST_COLUMNS, MANIFEST)}
    except CorpusError:
        return {}


def _is_copy(path: Path, folder: Path, take: Take | None) -> bool:
    try:
        return take is not None and filecmp.cmp(path, folder / take.sound, shallow=False)
    except OSError:
        return False


def _shown(sounds: Iterable[str]) -> str:
    names = list(sounds)
    more = f" and {len(names) - SHOWN} others" if len(names) > SHOWN else ""
    return f"{', '.join(names[:SHOWN])}{more} {'is' if len(names) == 1 else 'are'}"
