"""Memory that a two-hour file takes above the empty window, while it plays at its beginning and after an hour."""

import json
import resource
import struct
import sys
import tempfile
from pathlib import Path

import numpy as np
from PySide6.QtCore import QTimer

from phonemeengine.settings import SAMPLE_RATE
from tools.bench.desktop import live_for, shown_desktop
from tools.bench.figures import Figure, answer_of, speech

HOURS = 2
MOST_MB = 250
STATM = Path("/proc/self/statm")


class Highest:
    """Remembers the most memory that the process has held, MB."""

    def __init__(self) -> None:
        self.megabytes = resident_megabytes()
        self._timer = QTimer()
        self._timer.timeout.connect(self.look)
        self._timer.start(20)

    def look(self) -> None:
        """Look again."""
        self.megabytes = max(self.megabytes, resident_megabytes())


def figures() -> list[Figure]:
    """Measure in a process of its own."""
    answer = answer_of("memory")
    above = answer["playing"] - answer["empty"]
    name, reference = (
        f"{HOURS}-hour file, above empty window",
        f"{MOST_MB} MB (empty window {answer['empty']:.0f} MB)",
    )
    return [Figure(name, f"{above:.0f} MB", reference, above / MOST_MB, limit=1.0)]


def main() -> None:
    """Measure, and print both as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "long.wav"
        _write_long(path)
        desktop = shown_desktop(Path(folder))
        empty, highest = resident_megabytes(), Highest()
        desktop.window.dialogs.open_sound(path)
        desktop.session.play()
        live_for(5)
        desktop.session.seek(3600)
        live_for(3)
        assert desktop.session.source.position > 3602, "the file does not play after an hour"
        desktop.close()
    print(json.dumps({"empty": empty, "playing": highest.megabytes}))


def resident_megabytes() -> float:
    """Give the memory that the process holds now, or where that cannot be asked, the most it has held."""
    if STATM.exists():
        return int(STATM.read_text().split()[1]) * resource.getpagesize() / 1e6
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (1e6 if sys.platform == "darwin" else 1e3)


def _write_long(path: Path) -> None:
    """Write a WAV file with speech at its beginning and after an hour, and holes between, which take no disk."""
    n_bytes = HOURS * 3600 * SAMPLE_RATE * 2
    riff = struct.pack("<4sI4s", b"RIFF", 36 + n_bytes, b"WAVE")
    form = struct.pack("<4sIHHIIHH", b"fmt ", 16, 1, 1, SAMPLE_RATE, 2 * SAMPLE_RATE, 2, 16)
    values = np.asarray(speech(30) * 32767, "<i2").tobytes()
    with path.open("wb") as file:
        file.write(riff + form + struct.pack("<4sI", b"data", n_bytes))
        file.write(values)
        file.seek(44 + 3600 * SAMPLE_RATE * 2 - len(values) // 2)
        file.write(values)
        file.truncate(44 + n_bytes)


if __name__ == "__main__":
    main()
