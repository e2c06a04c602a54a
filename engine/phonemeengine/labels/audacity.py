"""Audacity's label tracks: a line for each label, with its start, its end and its name between tabs.

A second line that begins with a backslash tells the frequencies of a label that was drawn in a spectrogram; it is
passed over. A label without length is a remark at a point, not a stretch of sound, and is passed over too.
"""

from collections.abc import Sequence

from phonemeengine.errors import CorpusError
from phonemeengine.labels.label import Label, RawLabel

FREQUENCIES = "\\"
"""What a line with frequencies begins with."""


def raw_labels_of(text: str, file: str) -> tuple[RawLabel, ...]:
    """Read the stretches that have a name from the text of an exported label track.

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
    return tuple(raw for raw in stretches if raw.name)


def format_audacity(labels: Sequence[Label]) -> str:
    """Write labels, in order of time, as a label track with our names."""
    return "".join(f"{label.start:.6f}\t{label.end:.6f}\t{label.phoneme.label}\n" for label in labels)


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
