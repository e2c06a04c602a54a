"""Tables of recorded performances as SQLite databases: the only module that imports sqlite3.

A table holds recordings, weights in float16, and the units in them by set, phones and duration. It is opened
read-only as a file that does not change, so that it may lie anywhere, and is one of ours only where every table in it
was made by the very words below: what a stranger's database would compute is never run.
"""

import json
import os
import sqlite3
import threading
import weakref
from collections import OrderedDict
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Any

from typing_extensions import override

from phonemeengine.errors import EngineError, PerformanceError
from phonemeengine.execution import Closing
from phonemeengine.performance.recording import (
    LARGEST_WEIGHTS,
    Basis,
    DamageError,
    Performance,
    PerformedPhone,
    basis_of,
    clips_of,
    phone_of,
    place_beside,
    real_of,
    stored_weights,
    text_of,
    weights_of,
    whole_of,
)
from phonemeengine.performance.units import STRINGS, PhraseIndex, UnitKind, duration_of, units_of
from phonemeengine.storage.files import atomic_write, printable, printable_name, reason_of

VERSION, PLAIN = 2, 1
"""``PRAGMA user_version`` of tables with components in place of shapes, and of others."""
APPLICATION = 0x50684154
"""``PRAGMA application_id``: the letters PhAT, for phonemeanalyser's table."""
KEPT = 64 << 20
"""Bytes of weights that stay in memory after they were asked for."""
SCHEMA = (
    "CREATE TABLE meta(name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT",
    "CREATE TABLE channel(place INTEGER PRIMARY KEY, name TEXT NOT NULL) STRICT",
    """CREATE TABLE recording(
        id INTEGER PRIMARY KEY, name TEXT NOT NULL, rate REAL NOT NULL, n_frames INTEGER NOT NULL,
        duration REAL NOT NULL, synthetic INTEGER NOT NULL, words TEXT NOT NULL, weights BLOB NOT NULL
    ) STRICT""",
    """CREATE TABLE phone(
        recording INTEGER, k INTEGER, start REAL NOT NULL, middle REAL NOT NULL, "end" REAL NOT NULL,
        name TEXT NOT NULL, word INTEGER NOT NULL, syllable INTEGER NOT NULL, stress INTEGER NOT NULL,
        energy REAL NOT NULL, pitch REAL NOT NULL, PRIMARY KEY(recording, k)
    ) STRICT, WITHOUT ROWID""",
    "CREATE TABLE item(id INTEGER PRIMARY KEY, kind TEXT NOT NULL, key TEXT NOT NULL, UNIQUE(kind, key)) STRICT",
    """CREATE TABLE unit(
        item INTEGER, duration REAL, recording INTEGER, first INTEGER, last INTEGER,
        PRIMARY KEY(item, duration, recording, first, last)
    ) STRICT, WITHOUT ROWID""",
)
_EXAMPLES = "SELECT recording, first, last, duration FROM unit WHERE item = ? AND "
_BEFORE = _EXAMPLES + "duration < ? ORDER BY duration DESC LIMIT ?"
_FROM = _EXAMPLES + "duration >= ? ORDER BY duration LIMIT ?"
_PHONES = 'SELECT recording, start, middle, "end", name, word, syllable, stress, energy, pitch FROM phone '
_SOME = "WHERE recording = ? AND k BETWEEN ? AND ? ORDER BY k"
_WRONG_SIZES = "SELECT id FROM recording WHERE length(weights) != n_frames * ? LIMIT 1"
_WITHIN = _EXAMPLES + "duration BETWEEN ? AND ? ORDER BY duration"


def owns(content: bytes) -> bool:
    """Return whether the content of a file is a table that was written here."""
    return content.startswith(b"SQLite format 3\0") and content[68:72] == APPLICATION.to_bytes(4, "big")


@dataclass(frozen=True)
class TableAbout:
    """What a table holds.

    Attributes
    ----------
    name : what it is called where several are used.
    synthetic : whether any of its recordings is not of a person, but of a model of one.
    n_recordings : how many there are.
    duration : of all of them, seconds.
    channels : the names of the columns of their weights.
    rate : frames a second of all of them.
    folder : where the recordings were found, beside the table; empty where that is not known.
    person, language : who speaks, and in which language, such as ``en-us``; empty where that is not known.
    clips : recordings that answer words, or few words, as `plain` writes them.
    """

    name: str
    synthetic: bool
    n_recordings: int
    duration: float
    channels: tuple[str, ...]
    rate: float
    folder: str = ""
    person: str = ""
    language: str = ""
    clips: Mapping[str, str] = field(default_factory=dict)

    @property
    def title(self) -> str:
        """What people call it: a table of a synthetic performer is named so wherever it is shown."""
        return f"{self.name} (synthetic performer)" if self.synthetic else self.name


@dataclass(frozen=True)
class Example:
    """A unit in a recording.

    Attributes
    ----------
    recording : its number.
    first, last : its halves in the recording; `last` is not of it.
    duration : seconds.
    """

    recording: int
    first: int
    last: int
    duration: float


class PerformanceTable(Closing):
    """A table that was written, open to be looked into, by one thread after the other.

    Who does not close it leaves that to the end of its last use.

    Attributes
    ----------
    path : the file.
    about : what it holds.
    """

    def __init__(self, connection: sqlite3.Connection, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        self._connection, self._name = connection, printable_name(self.path)
        self._kept: OrderedDict[int, Performance] = OrderedDict()
        self._lock = threading.RLock()
        weakref.finalize(self, connection.close)  # who shows a face need not know who shows it, too
        with self._asking():
            self.about = _about(connection)
            self._basis, self._stored = _stored_in(connection)

    @classmethod
    def open(cls, path: str | os.PathLike[str]) -> "PerformanceTable":
        """Open a table.

        Raises
        ------
        PerformanceError : it cannot be read, is damaged or another program's, or newer than this program.
        """
        path = Path(path)
        name = printable_name(path)
        with _refusing(name):
            path.open("rb").close()  # sqlite's own words for a file that is not there tell less
            connection = sqlite3.connect(
                f"{path.absolute().as_uri()}?mode=ro&immutable=1", uri=True, check_same_thread=False
            )
        try:
            with _refusing(name):
                _check(connection)
            return cls(connection, path)
        except BaseException:
            connection.close()
            raise

    @override
    def close(self) -> None:
        with self._lock:
            self._connection.close()

    def check(self) -> None:
        """Read all of it, so that what is damaged is known before it is used; a second for some hours.

        Raises
        ------
        PerformanceError : it is damaged.
        """
        with self._asking():
            (words,) = self._connection.execute("PRAGMA quick_check(1)").fetchone()
            if words != "ok":
                raise DamageError(text_of(words))
            wrong = self._connection.execute(_WRONG_SIZES, (2 * len(self._stored),)).fetchone()
            if wrong is not None:
                raise DamageError("the weights of a recording do not fit its frames")

    def names(self, kind: UnitKind) -> frozenset[tuple[str, ...]]:
        """Return the phones of all units of a set."""
        with self._asking():
            rows = self._connection.execute("SELECT key FROM item WHERE kind = ?", (kind.value,))
            return frozenset(tuple(text_of(key).split(" ")) for (key,) in rows)

    def n_units(self) -> dict[UnitKind, int]:
        """Count the units of each set that has an index."""
        query = "SELECT kind, count(*) FROM unit JOIN item ON item = item.id GROUP BY kind"
        with self._asking():
            counts = {UnitKind(kind): whole_of(count) for kind, count in self._connection.execute(query)}
        return {kind: counts.get(kind, 0) for kind in UnitKind if kind not in STRINGS}

    def nearest(self, kind: UnitKind, names: tuple[str, ...], duration: float, limit: int) -> tuple[Example, ...]:
        """Return examples of a unit, those first whose durations are the nearest to one in seconds.

        Parameters
        ----------
        limit : how many at most.
        """
        with self._asking():
            item = self._item(kind, names)
            rows = [
                _example(row) for query in (_BEFORE, _FROM)
                for row in self._connection.execute(query, (item, duration, limit))
            ]  # fmt: skip
        return tuple(sorted(rows, key=lambda example: abs(example.duration - duration))[:limit])

    def within(self, kind: UnitKind, names: tuple[str, ...], low: float, high: float) -> tuple[Example, ...]:
        """Return the examples of a unit whose durations lie between two, seconds, the shortest first."""
        with self._asking():
            rows = self._connection.execute(_WITHIN, (self._item(kind, names), low, high))
            return tuple(_example(row) for row in rows)

    def phones_in(self, recording: int, first: int, last: int) -> tuple[PerformedPhone, ...]:
        """Return the phones of a recording from one number to another, both counted, as far as there are any."""
        with self._asking():
            rows = self._connection.execute(_PHONES + _SOME, (recording, first, last))
            return tuple(map(phone_of, rows))

    def recording(self, number: int) -> Performance:
        """Return a recording; those that were asked for last are kept in memory.

        Raises
        ------
        PerformanceError : there is none of this number, or it is damaged.
        """
        with self._lock:
            if number not in self._kept:
                self._kept[number] = self._read(number)
                while sum(kept.weights.nbytes for kept in self._kept.values()) > KEPT and len(self._kept) > 1:
                    self._kept.popitem(last=False)
            self._kept.move_to_end(number)
            return self._kept[number]

    def recording_called(self, name: str) -> Performance:
        """Return the recording of a name; of several, the first.

        Raises
        ------
        PerformanceError : there is none, or it is damaged.
        """
        return self.recording(self.number_of(name))

    def number_of(self, name: str) -> int:
        """Return the number of the first recording of a name.

        Raises
        ------
        PerformanceError : there is none.
        """
        with self._asking():
            row = self._connection.execute("SELECT min(id) FROM recording WHERE name = ?", (name,)).fetchone()
            some = self._connection.execute("SELECT name FROM recording ORDER BY id LIMIT 1").fetchone()
        if row[0] is None:
            raise PerformanceError(
                f"{self.about.name}: there is no recording {printable(name[:40])!r} in this table; they are called "
                f"as their files are, such as {printable(text_of(some[0])[:40])!r}"
            )
        return whole_of(row[0])

    def recordings(self) -> Iterator[tuple[int, Performance]]:
        """Return all recordings, each with its number; none is kept."""
        with self._asking():
            numbers = [whole_of(row[0]) for row in self._connection.execute("SELECT id FROM recording ORDER BY id")]
        return ((number, self._read(number)) for number in numbers)

    @cached_property
    def phrases(self) -> PhraseIndex:
        """The phrases of all recordings; they are read when they are first asked for."""
        with self._asking():
            rows = self._connection.execute(_PHONES + "ORDER BY recording, k")
            recordings = groupby(rows, key=itemgetter(0))
            return PhraseIndex((whole_of(number), [*map(phone_of, few)]) for number, few in recordings)

    @contextmanager
    def _asking(self) -> Iterator[None]:
        """Let no other thread ask meanwhile, and turn whatever goes wrong into a sentence."""
        with self._lock, _refusing(self._name):
            yield

    def _item(self, kind: UnitKind, names: tuple[str, ...]) -> int:
        query = "SELECT id FROM item WHERE kind = ? AND key = ?"
        row = self._connection.execute(query, (kind.value, " ".join(names))).fetchone()
        return -1 if row is None else whole_of(row[0])

    def _read(self, number: int) -> Performance:
        with self._asking():
            query = "SELECT name, rate, n_frames, synthetic, words, weights FROM recording WHERE id = ?"
            row = self._connection.execute(query, (number,)).fetchone()
            if row is None:
                raise DamageError(f"there is no recording of the number {number}")
            name, rate, n_frames, synthetic, words, content = row
            weights = weights_of(content, whole_of(n_frames), len(self._stored))
            weights = weights if self._basis is None else self._basis.expanded(weights)
            rows = self._connection.execute(_PHONES + "WHERE recording = ? ORDER BY k", (number,))
            phones = tuple(map(phone_of, rows))
            texts = tuple(text_of(words).split("\n")) if words else ()
            return Performance(
                text_of(name), real_of(rate), self.about.channels, weights, phones, texts, bool(whole_of(synthetic))
            )


def write_table(
    path: str | os.PathLike[str], performances: Iterable[Performance], *, name: str | None = None,
    folder: str | os.PathLike[str] | None = None, person: str = "", language: str = "",
    clips: Mapping[str, str] | None = None, basis: Basis | None = None,
) -> TableAbout:  # fmt: skip
    """Write a table of performances; what is at `path` stays until the table is complete and on the disk.

    One performance after the other is taken, so that a table of any size needs no more memory than its largest one.

    Parameters
    ----------
    path : the file.
    performances : with the same rate and channels, at least one.
    name : what the table is called; as the file, where it is None.
    folder : where the recordings are, so that their sounds are found again.
    person, language : who speaks, and in which language; empty where that is not known.
    clips : recordings that answer words; see `TableAbout`. Those that are not there are left out.
    basis : the components that are stored in place of shapes; None stores these.

    Raises
    ------
    PerformanceError : there is no performance, they do not fit together, or the table cannot be written.
    """
    path = Path(path)
    try:
        with atomic_write(path, durable=True) as file, closing(_created(file.name)) as connection:
            place = "" if folder is None else place_beside(path, folder)
            meta = {"name": path.stem if name is None else name, "folder": place}
            known = meta | {"person": person, "language": language}
            _Writing(connection, basis).write(performances, known, clips or {})
            return _about(connection)
    except EngineError:
        raise
    except (OSError, ValueError, sqlite3.Error) as error:
        reason = str(error) if isinstance(error, sqlite3.Error) else reason_of(error)
        raise PerformanceError(
            f"{printable_name(path)}: it cannot be written ({reason}); choose another folder"
        ) from error


def _created(path: str) -> sqlite3.Connection:
    """Open a new database with all tables; it needs no journal, as it replaces another only when it is whole."""
    connection = sqlite3.connect(path, isolation_level=None)
    pragmas = (
        "journal_mode = OFF",
        "synchronous = OFF",
        f"application_id = {APPLICATION}",
        f"user_version = {PLAIN}",
    )
    for words in (*(f"PRAGMA {pragma}" for pragma in pragmas), "BEGIN", *SCHEMA):
        connection.execute(words)
    return connection


class _Writing:
    """Puts performances into a new database."""

    def __init__(self, connection: sqlite3.Connection, basis: Basis | None) -> None:
        self._connection, self._basis = connection, basis
        self._items: dict[tuple[UnitKind, tuple[str, ...]], int] = {}

    def write(self, performances: Iterable[Performance], meta: Mapping[str, str], clips: Mapping[str, str]) -> None:
        """Write all of them, what is known of the table, and which of them answer words."""
        names = set[str]()
        first: Performance | None = None
        for number, performance in enumerate(performances, 1):
            first = first or performance
            performance.check_beside(first)
            self._add(number, performance)
            names.add(performance.name)
        if first is None:
            raise PerformanceError("a table needs at least one recording, found none; name another folder")
        channels = first.channels
        if self._basis is not None:
            channels, meta = self._basis.stored(channels), {**meta, "basis": self._basis.text()}
            self._connection.execute(f"PRAGMA user_version = {VERSION}")
        self._connection.executemany("INSERT INTO channel VALUES (?, ?)", enumerate(channels))
        there = {"clips": json.dumps({words: name for words, name in clips.items() if name in names})}
        self._connection.executemany("INSERT INTO meta VALUES (?, ?)", {**meta, **there}.items())
        rows = ((k, kind.value, " ".join(names)) for (kind, names), k in self._items.items())
        self._connection.executemany("INSERT INTO item VALUES (?, ?, ?)", rows)
        self._connection.execute("COMMIT")

    def _add(self, number: int, performance: Performance) -> None:
        weights = stored_weights(performance, self._basis)
        self._connection.execute(
            "INSERT INTO recording VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
            (
                number, performance.name, performance.rate, len(performance.weights), performance.duration,
                performance.synthetic,
                "\n".join(" ".join(word.split()) for word in performance.words), weights,
            ),
        )  # fmt: skip
        phones = performance.phones
        self._connection.executemany(
            "INSERT INTO phone VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
            (
                (
                    number, k, phone.start, phone.middle, phone.end, phone.name, phone.word, phone.syllable,
                    phone.stress, phone.energy, phone.pitch,
                )
                for k, phone in enumerate(phones)
            ),
        )  # fmt: skip
        self._connection.executemany(
            "INSERT INTO unit VALUES (?, ?, ?, ?, ?)",
            (
                (self._item(unit.kind, unit.names), duration_of(unit, phones), number, unit.first, unit.last)
                for unit in units_of(phones)
            ),
        )

    def _item(self, kind: UnitKind, names: tuple[str, ...]) -> int:
        return self._items.setdefault((kind, names), len(self._items) + 1)


@contextmanager
def _refusing(name: str) -> Iterator[None]:
    """Turn whatever a database, or a file, of a name raises into a sentence."""
    try:
        yield
    except EngineError:
        raise
    except OSError as error:
        raise PerformanceError(f"{name}: it cannot be read ({reason_of(error)}); choose another file") from error
    except (sqlite3.Error, ValueError, KeyError, TypeError, OverflowError) as error:
        reason = printable(str(error)[:100])
        raise PerformanceError(
            f"{name}: this is no table of performances, or a damaged one ({reason}); build it anew with "
            "`phonemeanalyser performance build`"
        ) from error


def _check(connection: sqlite3.Connection) -> None:
    """Refuse a database that is not ours.

    Raises
    ------
    PerformanceError, ValueError, sqlite3.Error : it is not.
    """
    connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, LARGEST_WEIGHTS + (1 << 16))
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    if application != APPLICATION:
        raise DamageError("another program wrote it")
    if version > VERSION:
        raise PerformanceError(
            f"this table of performances has version {version}, and this program knows those up to {VERSION}; "
            "install a newer one, or build the table anew"
        )
    rows = connection.execute("SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL LIMIT ?", (len(SCHEMA) + 1,))
    if {sql for (sql,) in rows} != {*SCHEMA}:
        raise DamageError("its tables are not those of this program")


def _about(connection: sqlite3.Connection) -> TableAbout:
    meta = dict(connection.execute("SELECT name, value FROM meta LIMIT 10"))
    query = "SELECT count(*), sum(duration), max(rate), max(synthetic) FROM recording"
    n, duration, rate, synthetic = connection.execute(query).fetchone()
    basis, stored = _stored_in(connection)
    channels = stored if basis is None else basis.read(stored)
    folder, person, language = (text_of(meta.get(key, "")) for key in ("folder", "person", "language"))
    return TableAbout(
        text_of(meta["name"]), bool(whole_of(synthetic)), whole_of(n), real_of(duration), channels, real_of(rate),
        folder, person, language, clips_of(meta.get("clips", "{}")),
    )  # fmt: skip


def _stored_in(connection: sqlite3.Connection) -> tuple[Basis | None, tuple[str, ...]]:
    """Return the components of a table, if there are some, and the names of the columns that it stores."""
    found = connection.execute("SELECT value FROM meta WHERE name = 'basis'").fetchone()
    names = tuple(text_of(row[0]) for row in connection.execute("SELECT name FROM channel ORDER BY place"))
    return basis_of("" if found is None else text_of(found[0])), names


def _example(row: tuple[Any, ...]) -> Example:
    recording, first, last, duration = row
    return Example(whole_of(recording), whole_of(first), whole_of(last), real_of(duration))
