"""Timed events of visemes, as speech services send them beside their sound: clients of these read them unchanged.

Azure Speech: ``audio.metadata``, as its Speech SDK reads it: the number of a viseme, and when it begins, in 100 ns.
Amazon Polly: a speech mark, which is a line of JSON: the name of a viseme, and its time in milliseconds.

The mouth table of a service says which viseme a sound has.
"""

import json
from collections.abc import Iterator, Sequence
from enum import StrEnum

from phonemeengine.mouth.exports.export import Export, frame_of

TICKS, MILLISECONDS = 10_000_000, 1000
"""Times that a second has, with Azure and with Polly."""

AZURE_VISEMES = frozenset(map(str, range(22)))
POLLY_VISEMES = frozenset({"sil", *"ptSTfkirsu@aeEoOBJx"})
"""What they have for visemes."""

VisemeStart = tuple[float, str]
"""When a viseme begins, seconds, and what the service calls it."""


class EventService(StrEnum):
    """A service whose events are written; the mouth table of its name has its visemes."""

    AZURE = "azure"
    POLLY = "polly"


def azure_metadata(starts: Sequence[VisemeStart]) -> str:
    """Return one message ``audio.metadata`` of Azure Speech with some visemes."""
    events = [
        {
            "Type": "Viseme",
            "Data": {
                "Offset": frame_of(start, TICKS),
                "VisemeId": int(viseme),
                "AnimationChunk": "",
                "IsLastAnimation": True,
            },
        }
        for start, viseme in starts
    ]
    return json.dumps({"Metadata": events})


def polly_mark(start: float, viseme: str) -> str:
    """Return one speech mark of Amazon Polly, without the end of its line."""
    mark = {"time": frame_of(start, MILLISECONDS), "type": "viseme", "value": viseme}
    return json.dumps(mark, separators=(",", ":"))


def messages_of(service: EventService, starts: Sequence[VisemeStart]) -> list[str]:
    """Return what a service would send of some visemes; nothing for none."""
    if service is EventService.POLLY:
        return [polly_mark(*start) for start in starts]
    return [azure_metadata(starts)] if starts else []


def write_azure(export: Export) -> Iterator[str]:
    """Write all visemes of a sound as one message."""
    yield azure_metadata(_starts_in(export)) + "\n"


def write_polly(export: Export) -> Iterator[str]:
    """Write a line for each viseme of a sound."""
    yield from (f"{polly_mark(*start)}\n" for start in _starts_in(export))


def _starts_in(export: Export) -> list[VisemeStart]:
    return [(cue.start, cue.shape) for cue in export.drawings]
