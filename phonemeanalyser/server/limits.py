"""Where a server is usually reached, what it grants those who ask it, and how it refuses."""

from dataclasses import dataclass

from phonemeengine import EngineError
from phonemeengine.errors import check_range

# What a server refuses, with the number that HTTP has for it.

FAILED = "the server has failed at this; its log (--log) says where"
"""What is answered where it is the server's fault."""


class RefusedError(EngineError):
    """A request that is refused; its text is one sentence for the author of the client.

    Attributes
    ----------
    status : of the answer over HTTP.
    """

    def __init__(self, sentence: str, status: int = 400) -> None:
        super().__init__(sentence)
        self.status = status


USUAL_HOST, USUAL_PORT = "127.0.0.1", 8765
KILOBYTE, MEGABYTE = 1 << 10, 1 << 20
PER_MESSAGE = 0.005
"""Seconds of sound that a message counts for besides what it holds: very short chunks slow a client down."""
AHEAD = 5.0
"""Seconds of sound that a stream may be ahead of its clock before it is slowed down."""

LIMITS: dict[str, tuple[float, float, str, str]] = {
    "most_streams": (1, 10_000, "", "streams at a time"),
    "most_connections": (1, 20_000, "", "connections at a time, streams and files together"),
    "most_per_address": (1, 20_000, "", "connections at a time that one address may have"),
    "most_speed": (1, 1000, "", "times as fast as it is spoken that a stream is read"),
    "idle": (1, 86_400, "s", "how long a client may send nothing, or take nothing, before it is let go"),
    "largest_message": (0.001, 1024, "MB", "size of a message of a stream"),
    "most_text": (0, 10_000_000, "", "characters of the text of a stream, or a file"),
    "largest_own": (0, 1000, "KB", "size of a preset or mouth table that a client sends; 0 allows none"),
    "largest_file": (0.001, 100_000, "MB", "size of a sound file"),
    "longest_file": (1, 1_000_000, "s", "length of the sound in a file"),
    "file_memory": (128, 1_000_000, "MB", "memory that the export of a file may take (Linux only)"),
    "most_files": (1, 1000, "", "files that are exported at a time, besides those that take long; others wait"),
    "file_seconds": (1, 86_400, "s", "how long a file may take, from its first byte on"),
}
"""Least, most, unit, and what each is."""


@dataclass(frozen=True)
class ServerLimits:
    """What each of these is stands in `LIMITS`.

    Raises
    ------
    SettingsError : one lies outside its range.
    """

    most_streams: int = 64
    most_connections: int = 128
    most_per_address: int = 64
    most_speed: float = 4.0
    idle: float = 30.0
    largest_message: float = 1.0
    most_text: int = 100_000
    largest_own: float = 32.0
    largest_file: float = 64.0
    longest_file: float = 1800.0
    file_memory: float = 1024.0
    most_files: int = 1
    file_seconds: float = 300.0

    def __post_init__(self) -> None:
        for name, (low, high, unit, words) in LIMITS.items():
            check_range(f"{words}:", getattr(self, name), (low, high, unit))
