"""The three files of Rhubarb Lip Sync: its letters A-H and X, with times in seconds, rounded to hundredths.

See "Output formats" in the manual of Rhubarb Lip Sync. Where the words are known, the metadata of the JSON file has a
list ``words`` beside what Rhubarb writes; readers of Rhubarb's files pass it over.
"""

import json
from collections.abc import Iterator
from html import escape

from phonemeengine.mouth.exports.curves import word_entry
from phonemeengine.mouth.exports.export import Export, frame_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import begins_like

SHAPES = frozenset("ABCDEFGHX")
STEPS = 100
"""Times that a second has."""

Stretch = tuple[str, str, str]

owns_xml = begins_like(
    rb'<\?xml version="1\.0" encoding="utf-8"\?>\n<rhubarbResult>\n  <metadata>\n'
    rb"    <soundFile>[^<>/\\\n]*</soundFile>\n    <duration>\d+\.\d\d</duration>\n"
)
"""Whether the content of a file was written here: Rhubarb itself names the folders of its sound too."""

owns_json = begins_like(rb'\{\n  "metadata": \{\n    "soundFile": "[^"/\\\n]*",\n    "duration": \d+\.\d\d,?\n')
"""The same for JSON."""


def write_tsv(export: Export) -> Iterator[str]:
    """Write a line with start and letter for each drawing, and a closed mouth at the end."""
    for start, _, letter in _stretches(export):
        yield f"{start}\t{letter}\n"
    yield f"{_time(export.speech.duration)}\t{_rest(export)}\n"


def write_xml(export: Export) -> Iterator[str]:
    """Write a ``rhubarbResult`` with metadata and mouth cues."""
    yield '<?xml version="1.0" encoding="utf-8"?>\n<rhubarbResult>\n  <metadata>\n'
    yield f"    <soundFile>{escape(export.speech.name, quote=False)}</soundFile>\n"
    yield f"    <duration>{_time(export.speech.duration)}</duration>\n  </metadata>\n  <mouthCues>\n"
    for start, end, letter in _stretches(export):
        yield f'    <mouthCue start="{start}" end="{end}">{letter}</mouthCue>\n'
    yield "  </mouthCues>\n</rhubarbResult>\n"


def write_json(export: Export) -> Iterator[str]:
    """Write an object with ``metadata`` and ``mouthCues``, a line each."""
    name = json.dumps(export.speech.name, ensure_ascii=False)
    words = ",\n".join(f"      {word_entry(word)}" for word in export.speech.words)
    known = f',\n    "words": [\n{words}\n    ]' if words else ""
    duration = _time(export.speech.duration)
    yield f'{{\n  "metadata": {{\n    "soundFile": {name},\n    "duration": {duration}{known}\n  }},\n'
    lines = (
        f'    {{ "start": {start}, "end": {end}, "value": "{letter}" }}' for start, end, letter in _stretches(export)
    )
    yield '  "mouthCues": [\n' + ",\n".join(lines) + "\n  ]\n}\n"


def _rest(export: Export) -> str:
    return export.table.phonemes[Phoneme.SILENCE]


def _time(seconds: float) -> str:
    return f"{frame_of(seconds, STEPS) / STEPS:.2f}"


def _stretches(export: Export) -> Iterator[Stretch]:
    """Return start, end and letter of each drawing; Rhubarb's readers want at least one."""
    stretches = [(_time(cue.start), _time(cue.end), cue.shape) for cue in export.drawings]
    whole = ("0.00", _time(export.speech.duration), _rest(export))
    yield from (stretch for stretch in stretches or [whole] if stretch[0] != stretch[1] or len(stretches) <= 1)
