"""Reads damaged files in a process of its own: `python -m tools.fuzz.reading FOLDER SEED BEGIN END`.

The number of the file that is read stands in FOLDER/now, so that it is known after a crash. What
fails is printed as one line of JSON, and the process goes on.
"""

import json
import sys
import tracemalloc
import warnings
from pathlib import Path
from random import Random

from phonemeengine.errors import EngineError
from tools.fuzz.kinds import Kind, kinds

MOST_MEMORY = 200 << 20
"""Bytes beyond what the process has when it begins."""
LONGEST_SENTENCE = 1000


def main() -> None:
    """Read the damaged files BEGIN..END, and print those that fail."""
    folder, seed, begin, end = Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    warnings.simplefilter("error")
    every = kinds(folder)
    for kind in every.values():
        failure_of(kind, kind.good[0])  # imports happen now
    limited = limit_memory()
    if not limited:
        tracemalloc.start()
    with (folder / "now").open("r+b", buffering=0) as now:
        for number in range(begin, end):
            now.seek(0)
            now.write(b"%12d" % number)
            what = failure_of(*damaged(every, seed, number))
            if not limited and tracemalloc.get_traced_memory()[1] > MOST_MEMORY:
                what = f"it took {tracemalloc.get_traced_memory()[1] >> 20} MB"
                tracemalloc.reset_peak()
            if what:
                print(json.dumps([number, what]), flush=True)
        now.seek(0)
        now.write(b"%12d" % end)


def damaged(every: dict[str, Kind], seed: str, number: int) -> tuple[Kind, bytes]:
    """Give the damaged file of a number, always the same for a seed."""
    kind = list(every.values())[number % len(every)]
    return kind, kind.damaged(Random(f"{seed}/{number}"))


def failure_of(kind: Kind, content: bytes) -> str:
    """Read a damaged file; empty if it was read, or refused in a sentence."""
    try:
        kind.read(content)
    except EngineError as error:
        sentence = str(error)
        good = 10 < len(sentence) < LONGEST_SENTENCE and "\n" not in sentence
        return "" if good else f"it was refused with {sentence[:200]!r}"
    except (Exception, MemoryError) as error:  # noqa: BLE001 - anything else is what this looks for
        return f"{type(error).__name__}: {str(error)[:200]}"
    return ""


def limit_memory() -> bool:
    """Let the system refuse more memory, where it can."""
    try:
        import resource

        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    except (ImportError, OSError):
        return False
    most = pages * resource.getpagesize() + MOST_MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    return True


if __name__ == "__main__":
    main()
