"""Make training speech: ``python -m tools.voices OUT_DIR``. Debian 12; ``--install`` needs root, once."""

import argparse
import os
import sys
from pathlib import Path

from tools.voices import packages


def main() -> None:
    """Install what is asked for, go over into the virtual environment, and build voice by voice."""
    arguments = _arguments()
    out, cache = arguments.out.resolve(), (arguments.cache or arguments.out / ".cache").resolve()
    if arguments.install:
        packages.install(cache)
    _enter(packages.python_of(cache))
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
    parser.add_argument(
        "--only", default=",".join(packages.SYNTHESIZERS), help="synthesizers or voices, with commas between"
    )
    parser.add_argument("--minutes", type=float, default=6.0, metavar="N", help="of speech, for each voice")
    parser.add_argument("--check", action="store_true", help="print figures of the labels that are there, build none")
    parser.add_argument("--cache", type=Path, help="virtual environment and unpacked packages (OUT_DIR/.cache)")
    return parser.parse_args()


def _enter(python: Path) -> None:
    """Start again inside the virtual environment, unless it is there already."""
    if not python.exists():
        sys.exit(f"{python} is missing: run once with --install.")
    if Path(sys.prefix).resolve() != python.parent.parent.resolve():
        rest = [argument for argument in sys.argv[1:] if argument != "--install"]
        os.execv(python, [str(python), "-m", "tools.voices", *rest])


if __name__ == "__main__":
    main()
