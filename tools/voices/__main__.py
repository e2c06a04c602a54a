"""Make training speech: ``python -m tools.voices OUT_DIR``. Debian 12; ``--install`` needs root, once."""

import argparse
import os
import sys
from pathlib import Path

from tools.voices import packages

ENGINE = Path(__file__).resolve().parents[2] / "engine"


def main() -> None:
    """Install what is asked for, go over into the virtual environment, and build voice by voice."""
    arguments = _arguments()
    out, cache = arguments.out.resolve(), (arguments.cache or arguments.out / ".cache").resolve()
    if arguments.install:
        packages.install(cache)
    _enter(cache)
    if arguments.check:
        from tools.voices.check import check

        check(out)
    else:
        from tools.voices.build import build

        build(out, cache, arguments.only.split(","), arguments.minutes)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m tools.voices", description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter
    )
    parser.add_argument("out", metavar="OUT_DIR", type=Path, help="folder for the corpus")
    parser.add_argument("--install", action="store_true", help="first install the packages")
    parser.add_argument("--only", default=",".join(packages.SOURCES), help="sources or voices, with commas between")
    parser.add_argument("--minutes", type=float, default=6.0, metavar="N", help="of speech, for each synthetic voice")
    parser.add_argument("--check", action="store_true", help="print figures of the labels that are there, build none")
    parser.add_argument("--cache", type=Path, help="virtual environment and unpacked packages (OUT_DIR/.cache)")
    return parser.parse_args()


def _enter(cache: Path) -> None:
    """Start again inside the virtual environment, with the engine's modules, unless it is there already."""
    if lacking := packages.missing(cache):
        sys.exit(f"{lacking[0]} is missing: run once with --install.")
    python = packages.python_of(cache)
    if Path(sys.prefix).resolve() != python.parent.parent.resolve():
        rest = [argument for argument in sys.argv[1:] if argument != "--install"]
        modules = os.pathsep.join(filter(None, (str(ENGINE), os.environ.get("PYTHONPATH"))))
        command = [str(python), "-m", "tools.voices", *rest]
        os.execve(python, command, {**os.environ, "PYTHONPATH": modules})


if __name__ == "__main__":
    main()
