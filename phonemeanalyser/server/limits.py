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
    "max_streams": (1, 10_000, "", "streams at a time"),
    "max_connections": (1, 20_000, "", "connections at a time, streams and files together"),
    "max_per_address": (1, 20_000, "", "connections at a time that one address may have"),
    "max_speed": (1, 1000, "", "speed at which a stream is read, as a multiple of real time"),
    "idle_timeout": (1, 86_400, "s", "time after which a client that sends or takes nothing is disconnected"),
    "max_message": (0.001, 1024, "MB", "size of a message of a stream"),
    "max_text": (0, 10_000_000, "", "characters in the text of a stream or a file"),
    "max_own": (0, 1000, "KB", "size of a preset or mouth table that a client sends; 0 allows none"),
    "max_file": (0.001, 100_000, "MB", "size of an audio file"),
    "max_duration": (1, 1_000_000, "s", "length of the audio in a file"),
    "max_memory": (128, 1_000_000, "MB", "memory that the export of a file may use (Linux only)"),
    "max_files": (1, 1000, "", "files that are exported at a time, not counting those that take long; others wait"),
    "file_timeout": (1, 86_400, "s", "time that a file may take, from its first byte on"),
}
"""Least, most, unit, and what each is."""


@dataclass(frozen=True)
class ServerLimits:
    """What each of these is stands in `LIMITS`.

    Raises
    ------
    SettingsError : one lies outside its range.
    """

    max_streams: int = 64
    max_connections: int = 128
    max_per_address: int = 64
    max_speed: float = 4.0
    idle_timeout: float = 30.0
    max_message: float = 1.0
    max_text: int = 100_000
    max_own: float = 32.0
    max_file: float = 64.0
    max_duration: float = 1800.0
    max_memory: float = 1024.0
    max_files: int = 1
    file_timeout: float = 300.0

    def __post_init__(self) -> None:
        for name, (low, high, unit, words) in LIMITS.items():
            check_range(f"{words}:", getattr(self, name), (low, high, unit))
