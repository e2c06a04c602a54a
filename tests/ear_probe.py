"""A process with the sanitizers in it that listens with ``.ear`` files in C, be they as damaged as may be."""

import struct
import subprocess
import weakref
import zlib
from pathlib import Path

from phonemeengine.errors import ModelError
from tests.compiled_ears import SANITIZED, SOURCES, compiled

HEADER = 16
PROBE = Path(__file__).with_suffix(".c")


def with_true_header(content: bytes) -> bytes:
    """Give a file whose header says its true size and checksum, so that what is behind it is looked at."""
    return content[:8] + struct.pack("<II", len(content), zlib.crc32(content[HEADER:])) + content[HEADER:]


class EarProbe:
    """The process, which begins when it is first asked, and ends with this.

    Parameters
    ----------
    compiler : what compiles it; without one, the first that is there.
    """

    def __init__(self, compiler: str = "") -> None:
        self._compiler = compiler
        self._process: subprocess.Popen[bytes] | None = None

    def ask(self, content: bytes) -> int:
        """Have a file listened with; gives the result, 0 where it is a good one.

        Raises
        ------
        RuntimeError : something was undefined; the message is the sanitizers'.
        """
        process = self._process = self._process or self._started()
        assert process.stdin is not None
        assert process.stdout is not None
        assert process.stderr is not None
        try:
            process.stdin.write(struct.pack("<I", len(content)) + content)
            process.stdin.flush()
            answer = process.stdout.readline()
        except BrokenPipeError:
            answer = b""
        if not answer:
            self._process = None
            raise RuntimeError(process.stderr.read().decode(errors="replace")[:3000])
        return int(answer)

    def read(self, content: bytes) -> None:
        """Have a file listened with, and refuse it as the ear does."""
        result = self.ask(content)
        if result:
            raise ModelError(f"the ear refuses the file with {result}")

    def _started(self) -> "subprocess.Popen[bytes]":
        sources, pipe = [PROBE, SOURCES / "ear.c"], subprocess.PIPE
        program = compiled("ear_probe", sources, *SANITIZED, by=self._compiler)
        process = subprocess.Popen([program], stdin=pipe, stdout=pipe, stderr=pipe)
        weakref.finalize(self, process.communicate)
        return process
