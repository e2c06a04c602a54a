"""Audacity's label tracks: a line for each label, with its start, its end and its name between tabs.

A second line that begins with a backslash tells the frequencies of a label that was drawn in a spectrogram; it is
passed over. A label without length is a remark at a point, not an interval, and is passed over too. Names in
double quotes are words: a track holds them beside the sounds, and readers of the sounds skip them.
"""

from collections.abc import Iterable, Sequence

from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import Label, RawLabel, Word

FREQUENCIES = "\\"
"""What a line with frequencies begins with."""


def raw_labels_of(text: str, file: str) -> tuple[RawLabel, ...]:
    """Read the intervals that have a name from the text of an exported label track.

    Raises
    ------
    CorpusError : a line is no label; names it.
    """
    lines = [(number, line) for number, line in enumerate(text.split("\n"), 1) if line.strip()]
    found = [
        _raw_label_of(line, f"line {number}", file) for number, line in lines if not line.startswith(FREQUENCIES)
    ]
    stretches = [raw for raw in found if raw.start != raw.end]
    if found and not stretches:
        raise CorpusError(
            f"{file}: all its labels are points without length; drag each label over its sound and export them again"
        )
    return tuple(raw for raw in stretches if raw.name and not _is_word(raw.name))


def format_audacity(labels: Sequence[Label], words: Sequence[Word] = ()) -> str:
    """Return labels with our names as a label track, and words in double quotes where these are known."""
    return format_track([(label.start, label.end, label.phoneme.label) for label in labels], words)


def format_track(stretches: Iterable[tuple[float, float, str]], words: Sequence[Word] = ()) -> str:
    """Return intervals, each with start and end in seconds and a name, as a label track; and words."""
    said = ((word.start, word.end, f'"{" ".join(word.text.split())}"') for word in words)
    rows = sorted((*said, *stretches), key=lambda row: row[0])  # stable: a word stands before its first sound
    return "".join(f"{start:.6f}\t{end:.6f}\t{name}\n" for start, end, name in rows)


def _is_word(name: str) -> bool:
    return len(name) > 1 and name[0] == name[-1] == '"'


def _raw_label_of(line: str, place: str, file: str) -> RawLabel:
    start, end, name = [*line.split("\t", 2), "", ""][:3]
    try:
        times = [float(time.strip().replace(",", ".")) for time in (start, end)]
    except ValueError:
        raise CorpusError(
            f"{file}, {place}: a label of Audacity is start, end and name with tabs between them, found "
            f"{line[:40]!r}; export the label track again"
        ) from None
    return RawLabel(times[0], times[1], name.strip(), place)
