"""Where the speech comes from that a model is trained on, as the manifests of its corpora tell."""

import csv
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

UNKNOWN = "not told"

HUMAN = "human"
WEIGHTS = {HUMAN: 3.0}
"""How often the speech of a kind is gone through: recordings of people are rare and matter most. All other kinds
count once."""


@dataclass(frozen=True)
class LabelSource:
    """A speaker.

    Attributes
    ----------
    name : corpus/speaker.
    language, kind, licence, package : as the manifest says.
    minutes : of speech.
    n_recordings : how many.
    """

    name: str
    language: str
    kind: str
    licence: str
    package: str
    minutes: float
    n_recordings: int

    @property
    def weight(self) -> float:
        """How often its speech is gone through in an epoch."""
        return WEIGHTS.get(self.kind, 1.0)


def sources_of(corpora: Iterable[Path]) -> list[LabelSource]:
    """Return the speakers of all corpora, sorted by name; a speaker, or a recording, of several corpora is one."""
    rows: dict[str, dict[str, dict[str, str]]] = {}
    for corpus in corpora:
        with (corpus / "manifest.csv").open(newline="", encoding="utf-8-sig") as file:
            for row in csv.DictReader(file):
                recordings = rows.setdefault(f"{row['corpus']}/{row['speaker']}", {})
                recordings.setdefault(Path(row["wav"]).stem, row)
    return [
        LabelSource(
            name,
            language=entries[0].get("language") or UNKNOWN,
            kind=entries[0].get("kind") or UNKNOWN,
            licence=entries[0].get("licence") or UNKNOWN,
            package=entries[0].get("source_package") or UNKNOWN,
            minutes=sum(float(row.get("duration_s") or 0) for row in entries) / 60,
            n_recordings=len(entries),
        )
        for name, entries in sorted((name, list(recordings.values())) for name, recordings in rows.items())
    ]
