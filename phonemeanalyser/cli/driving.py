"""What moves a face by what is said, as a command's arguments say: recorded faces, letters of pinyin, or rules."""

import argparse
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeanalyser.cli.jobs import say_note
from phonemeanalyser.cli.performing import Performing, add_performance, performing
from phonemeengine import Animation, EngineError, PerformanceTrack, PinyinTable, Transcript, Utterance, pinyin_track
from phonemeengine.alignment.align import is_other_text
from phonemeengine.batch.work import Say
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.face_driver import FaceDriver, usual_driver
from phonemeengine.speech.pinyin.spring import Spring
from phonemeengine.speech.pinyin.table import load_pinyin_table
from phonemeengine.speech.pinyin.timing import has_pinyin
from phonemeengine.speech.pinyin.track import PinyinTrack

DRIVERS = [driver.value for driver in FaceDriver]
FaceTrack = PerformanceTrack | PinyinTrack
"""What moves a face that does not follow its phones by rules."""
Takes = Callable[[tuple[str, ...]], bool]
"""Whether a face or a file has what a driver moves, by the names of its movestates."""

_NEEDS_WORDS = {
    FaceDriver.TABLE: "recorded faces are looked up by the phones that are said",
    FaceDriver.PINYIN: "letters of pinyin are those of the syllables that are said",
}


def add_driver(parser: argparse.ArgumentParser) -> None:
    """Let the user choose what moves a face."""
    driver = "what moves a face (auto: a table of --performance, pinyin for Chinese, else rules)"
    parser.add_argument("--text-driver", choices=DRIVERS, default=FaceDriver.AUTO.value, help=driver)
    parser.add_argument("--pinyin-table", type=Path, metavar="T", help="a pinyin table (.toml) of yours")
    parser.add_argument("--spring", metavar="M,K,D", help="a spring moves the mouth: mass, stiffness, damping")
    add_performance(parser)


def pinyin_table_of(options: argparse.Namespace) -> PinyinTable:
    """Return the pinyin table that the command line asks for."""
    table = load_pinyin_table(options.pinyin_table) if options.pinyin_table else load_pinyin_table()
    return table if options.spring is None else replace(table, spring=Spring.of(options.spring))


@dataclass(frozen=True)
class Driving:
    """Moves faces by what is said.

    Attributes
    ----------
    driver : as the command line says.
    performer : how recorded faces move it; None where they do not.
    table : the pinyin table.
    seed : of its variation; none varies where it is None.
    """

    driver: FaceDriver
    performer: Performing | None
    table: PinyinTable
    seed: int | None

    def chosen(
        self, utterance: Utterance | None, name: str, takes: Takes | None = None, driver: FaceDriver | None = None
    ) -> FaceDriver:
        """Return what moves a face that says this.

        Parameters
        ----------
        utterance : what is said; None where nobody knows.
        name : of the sound or the text, for people.
        takes : whether letters can move the face, for `AUTO`; they can, where it is None.
        driver : another one than that of the command line.

        Raises
        ------
        EngineError : the driver cannot move a face by it.
        """
        driver = driver or self.driver
        if driver is FaceDriver.AUTO:
            driver = self._usual(utterance, takes)
        if driver in _NEEDS_WORDS and (utterance is None or is_other_text(utterance)):
            raise EngineError(
                f"{name}: {_NEEDS_WORDS[driver]}, which nobody knows; give the text with --text, or the text or "
                "labels with --script"
            )
        if utterance is not None:
            self.check_letters(driver, name, letters=has_pinyin(utterance))
        return driver

    def check_letters(self, driver: FaceDriver, name: str, *, letters: bool) -> None:
        """Refuse to move a face by letters of pinyin where what is said has none.

        Raises
        ------
        EngineError : it is so.
        """
        if driver is FaceDriver.PINYIN and not letters:
            raise EngineError(f"{name}: there is no syllable of pinyin in what is said; choose another driver")

    def track(
        self, driver: FaceDriver, utterance: Utterance | None, speech: Transcript, text: str = "", say: Say = say_note
    ) -> FaceTrack | None:  # fmt: skip
        """Return how a chosen driver moves a face; None by rules.

        What a table lacks is said, and the units that are asked for are written.

        Parameters
        ----------
        utterance, speech : what is said, and how loud and high.
        text : the same as it is written, for the marks of its pauses.
        say : told what the table lacks.
        """
        if utterance is not None and driver is FaceDriver.PINYIN:
            return pinyin_track(utterance, self.table, text=text, seed=self.seed)
        if utterance is not None and driver is FaceDriver.TABLE and self.performer is not None:
            return self.performer.track(utterance, speech, say)
        return None

    def movement(
        self, track: FaceTrack | None, speech: Transcript, exporter: Exporter, say: Say = say_note
    ) -> Animation | None:
        """Return the movement of a face for an export; None by rules, and where the format has its own shapes.

        The latter is said, unless nobody asked for the letters.
        """
        if track is None:
            return None
        if exporter.takes(track.mouth().movestates):
            return track.animation(speech, exporter.rate, exporter.idle)
        if self.driver is not FaceDriver.AUTO or self.performer is not None:
            say(exporter.name, "it has shapes of its own, which follow the phones")
        return None

    def caption(self, driver: FaceDriver) -> str:
        """Return what people call a chosen driver."""
        if driver is FaceDriver.TABLE and self.performer is not None:
            return self.performer.table.about.title
        return driver.caption

    def _usual(self, utterance: Utterance | None, takes: Takes | None) -> FaceDriver:
        letters = utterance is not None and has_pinyin(utterance)
        moves = takes is None or takes(self.table.mouth.movestates)
        return usual_driver(has_table=self.performer is not None, has_letters=letters and moves)


def driving_options(options: argparse.Namespace) -> argparse.Namespace:
    """Return the arguments of a command line by which `driving` opens the same again, in another process."""
    names = (
        "text_driver", "pinyin_table", "spring", "seed", "performance", "use", "choice", "without", "keywords",
        "units", "overwrite", "beside",
    )  # fmt: skip
    return argparse.Namespace(**{name: getattr(options, name) for name in names if name in options})


def driving_key(options: argparse.Namespace) -> dict[str, object]:
    """Return those of `driving_options` by which a face moves otherwise."""
    return {name: value for name, value in vars(options).items() if name != "overwrite"}


@contextmanager
def driving(options: argparse.Namespace, beside: FaceDriver | None = None, say: Say = say_note) -> Iterator[Driving]:
    """Open what moves faces, of a command line with the arguments of `add_driver`.

    Parameters
    ----------
    beside : another driver that moves a face, too.
    say : told that no person moved in a table.

    Raises
    ------
    EngineError : a table or the pinyin table cannot be used, or nothing would use it.
    """
    driver = FaceDriver(options.text_driver)
    if options.performance is None and FaceDriver.TABLE in {driver, beside}:
        option = "--text-driver" if driver is FaceDriver.TABLE else "--beside"
        raise EngineError(f"{option} table needs a table of recorded faces; name it with --performance")
    if options.performance is not None and not {driver, beside} & {FaceDriver.AUTO, FaceDriver.TABLE}:
        raise EngineError(f"--text-driver {driver} leaves the table of --performance unused; leave one of them out")
    table = pinyin_table_of(options)
    with performing(options, say) as performer:
        yield Driving(driver, performer, table, options.seed)
