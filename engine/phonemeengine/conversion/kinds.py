"""What a sound file can be turned into: tables of phonemes or of every frame, and mouth cues for other programs."""

from dataclasses import dataclass
from pathlib import Path

from phonemeengine.analysis_tables import TABLES
from phonemeengine.errors import ExportError, remedy
from phonemeengine.files import Owns
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS


@dataclass(frozen=True)
class Conversion:
    """A kind of file that a sound can be turned into.

    Attributes
    ----------
    name : what it is called, such as ``rhubarb-json`` or ``frames-csv``.
    words : what it is, for people.
    ending : of its files.
    owns : says which files are of this kind and ours; None where those of other programs look alike.
    moves_mouth : whether `ExportOptions` say how it is written.
    has_cues : whether it holds mouth cues, of which one may be too short.
    """

    name: str
    words: str
    ending: str
    owns: Owns | None
    moves_mouth: bool
    has_cues: bool = False


def _conversions() -> dict[str, Conversion]:
    tables = [
        Conversion(f"phonemes-{kind}", f"phonemes as {words}", TABLES[kind].ending, TABLES[kind].owns, False)
        for kind, words in _TABLE_WORDS.items()
    ]
    frames = [
        Conversion(
            f"frames-{kind}",
            f"every frame of 10 ms with all variables, {kind.upper()}",
            form.ending,
            form.owns,
            False,
        )
        for kind, form in TABLES.items()
        if form.write_frames is not None
    ]
    mouths = [Conversion(name, f.words, f.full_ending, f.owns, True, f.has_cues) for name, f in FORMATS.items()]
    return {c.name: c for c in (*tables, *frames, *mouths)}


_TABLE_WORDS = {"csv": "a table", "json": "JSON", "textgrid": "a TextGrid of Praat", "audacity": "labels of Audacity"}

CONVERSIONS = _conversions()
"""All kinds, by name."""


def check_options(kind: str, options: ExportOptions | None) -> None:
    """Refuse what cannot be done, before any sound is heard.

    Raises
    ------
    ExportError : there is no such kind, or it cannot do what the options say.
    MouthError : the table cannot be used.
    """
    if kind not in CONVERSIONS:
        raise ExportError(f"there is no kind of file {kind!r}; {remedy(kind, CONVERSIONS)}")
    if CONVERSIONS[kind].moves_mouth:
        Exporter(kind, options)


def targets_of(sounds: list[Path], folder: Path | None, ending: str) -> dict[Path, Path]:
    """Return where the file of each sound goes: into a folder, or beside it; a number tells equal names apart."""
    taken, found = set[Path](), {}
    for sound in sounds:
        target, k = (folder or sound.parent) / f"{sound.stem}{ending}", 2
        while target in taken:
            target, k = (folder or sound.parent) / f"{sound.stem}-{k}{ending}", k + 1
        taken.add(target)
        found[sound] = target
    return found
