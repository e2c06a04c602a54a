"""What moves a face by what is said, as a command's arguments say: recorded faces, letters of pinyin, or rules."""

import argparse
from pathlib import Path

from phonemeengine import EngineError
from phonemeengine.conversion.driving import DriverChoice
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.driver import PerformancePart

DRIVERS = [driver.value for driver in FaceDriver]
PARTS = ",".join(PerformancePart)
CHOICES = [choice.value for choice in ExampleChoice]


def add_driver(parser: argparse.ArgumentParser) -> None:
    """Let the user choose what moves a face, and how recorded faces are looked up."""
    driver = "what moves a face (auto: a table of --performance, pinyin for Chinese, else rules)"
    parser.add_argument("--text-driver", choices=DRIVERS, default=FaceDriver.AUTO.value, help=driver)
    parser.add_argument("--pinyin-table", type=Path, metavar="T", help="a pinyin table (.toml) of yours")
    parser.add_argument("--spring", metavar="M,K,D", help="a spring moves the mouth: mass, stiffness, damping")
    table = "a table of recorded faces moves the face, or several, of which --use chooses one"
    parser.add_argument("--performance", type=Path, action="append", metavar="T.sqlite", help=table)
    parser.add_argument("--use", metavar="NAME", help="the name of the table that is used")
    parser.add_argument("--choice", choices=CHOICES, help=f"among examples of a unit (default: {CHOICES[0]})")
    parser.add_argument("--without", type=_parts, metavar="PARTS", help=f"leave out any of {PARTS}")
    words = "your own words with gestures, and conjunctions (TOML)"
    parser.add_argument("--keywords", type=Path, action="append", metavar="F", help=words)
    parser.add_argument("--units", type=Path, metavar="OUT.csv", help="write what was taken from which recording")


def driver_of(options: argparse.Namespace) -> DriverChoice:
    """Return what moves faces, of a command line with the arguments of `add_driver`, and perhaps ``--beside``.

    Raises
    ------
    EngineError : nothing would use what is given.
    """
    beside = getattr(options, "beside", None)
    chosen = DriverChoice(
        FaceDriver(options.text_driver),
        FaceDriver(beside) if beside else None,
        options.pinyin_table,
        options.spring,
        options.seed,
        tuple(options.performance or ()),
        options.use,
        ExampleChoice(options.choice or CHOICES[0]),
        options.without or frozenset(),
        tuple(options.keywords or ()),
        options.units,
        options.overwrite,
    )
    for name in ("use", "choice", "without", "keywords", "units"):
        if options.performance is None and getattr(options, name) is not None:
            raise EngineError(f"--{name} goes with --performance; name a table of recorded faces")
    return chosen


def _parts(text: str) -> frozenset[PerformancePart]:
    """Read the parts that are left out."""
    try:
        return frozenset(PerformancePart(part.strip()) for part in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"must be any of {PARTS}, with commas between, got {text!r}") from None
