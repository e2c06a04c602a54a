"""What a server tells the program that runs it: clients that come and go, and what they were refused."""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from datetime import datetime
from enum import StrEnum


class Happening(StrEnum):
    """What has happened."""

    SERVING = "serving"
    STREAM_BEGAN = "stream began"
    STREAM_ENDED = "stream ended"
    EXPORTED = "file exported"
    REFUSED = "refused"


@dataclass(frozen=True)
class Activity:
    """Something that happened at a server.

    Attributes
    ----------
    what : what it was.
    words : the address that is served, or the sentence with which something was refused.
    client : the address of the client.
    n_streams : how many streams there are now.
    clock : when it was, in hours, minutes and seconds of this machine.
    """

    what: Happening
    words: str = ""
    client: str = ""
    n_streams: int = 0
    clock: str = field(default_factory=lambda: f"{datetime.now().astimezone():%H:%M:%S}")

    def to_line(self) -> str:
        """Return it as a line of JSON, which `from_line` reads."""
        return json.dumps(asdict(self))

    @classmethod
    def from_line(cls, line: str) -> "Activity":
        """Read it.

        Raises
        ------
        ValueError, TypeError, KeyError : the line is another one.
        """
        told = json.loads(line)
        return cls(Happening(told.pop("what")), **told)


Report = Callable[[Activity], object]
"""Told what happens."""


def no_report(_activity: Activity) -> None:
    """Tell nothing."""
