"""What moves a face by what is said: recorded faces, a network that learned from them, pinyin letters, or rules."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

from phonemeengine.alignment.align import is_other_text
from phonemeengine.batch.work import Say
from phonemeengine.conversion.options import ConversionOptions
from phonemeengine.errors import EngineError
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.animation import Animation, FaceDriver, MovementTrack, usual_driver
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.style import NEUTRAL, Style, load_style, neutral_style
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.performance.choice import ExampleChoice, chosen_table
from phonemeengine.performance.driver import PerformanceOptions, PerformancePart
from phonemeengine.performance.face_network import FaceNetwork, FaceNetworkTrack, Sound, load_face_network
from phonemeengine.performance.keywords import load_keywords
from phonemeengine.performance.own_sound import OwnSound
from phonemeengine.performance.table_file import PerformanceTable
from phonemeengine.performance.track import PerformanceTrack, format_units, owns
from phonemeengine.speech.pinyin.spring import Spring
from phonemeengine.speech.pinyin.table import PinyinTable, load_pinyin_table
from phonemeengine.speech.pinyin.timing import has_pinyin
from phonemeengine.speech.pinyin.track import pinyin_track
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.storage.replacing import Guard, write_guarded

Takes = Callable[[tuple[str, ...]], bool]
"""Whether a face or a file has what a driver moves, by the names of its movestates."""

_NEEDS_WORDS = {
    FaceDriver.TABLE: "recorded faces are looked up by the phones that are said",
    FaceDriver.PINYIN: "letters of pinyin are those of the syllables that are said",
}


@dataclass(frozen=True)
class DriverChoice:
    """What shall move a face by what is said.

    Attributes
    ----------
    driver : what moves it.
    beside : what moves a second face beside it; None where there is one face.
    pinyin_table : a pinyin table's file; None for the one that ships.
    spring : mass, stiffness and damping of a spring that moves the mouth, as ``M,K,D``; None for the table's.
    seed : of its variation; none varies where it is None.
    performance : files of tables of recorded faces.
    use, person : the name of the table that is used, and whose it is; None for any.
    choice, without : among the examples of a unit, and what is left out; see `PerformanceOptions`.
    keywords : files of words with gestures.
    network : a network's file that moves a face by the sound alone.
    units : where it is written what was taken from which recording; None writes nothing.
    overwrite : whether whatever is there is replaced.
    style : in which the face speaks; None for the neutral one.
    own_sound : whether the table's recordings speak, rather than a voice.

    Raises
    ------
    EngineError : nothing would use the tables of recorded faces or the network, or there are none.
    """

    driver: FaceDriver = FaceDriver.AUTO
    beside: FaceDriver | None = None
    pinyin_table: Path | None = None
    spring: str | None = None
    seed: int | None = None
    performance: tuple[Path, ...] = ()
    use: str | None = None
    choice: ExampleChoice = ExampleChoice.VITERBI
    without: frozenset[PerformancePart] = frozenset()
    keywords: tuple[Path, ...] = ()
    units: Path | None = None
    network: Path | None = None
    overwrite: bool = field(default=False, compare=False)
    style: Style | None = None
    person: str | None = None
    own_sound: bool = False

    def __post_init__(self) -> None:
        drivers = {self.driver, self.beside}
        for driver, given, option, what in (
            (FaceDriver.TABLE, bool(self.performance), "--performance", "table"),
            (FaceDriver.NETWORK, self.network is not None, "--face-network", "network"),
        ):
            if not given and driver in drivers:
                asked = "--text-driver" if self.driver is driver else "--beside"
                raise EngineError(f"{asked} {driver} needs a {what} of recorded faces; name it with {option}")
            if given and not drivers & {FaceDriver.AUTO, driver}:
                words = f"leaves the {what} of {option} unused; leave one of them out"
                raise EngineError(f"--text-driver {self.driver} {words}")

    @classmethod
    def of(cls, options: ConversionOptions) -> "DriverChoice":
        """Return what options ask for.

        Raises
        ------
        EngineError : nothing would use the tables of recorded faces, or there are none.
        """
        return cls(
            options.text_driver,
            options.beside,
            options.pinyin_table,
            options.spring,
            options.seed,
            options.performance,
            options.use,
            options.choice or ExampleChoice.VITERBI,
            options.without or frozenset(),
            options.keywords,
            options.units,
            options.face_network,
            options.overwrite,
            None if options.style in {None, NEUTRAL} else load_style(options.style),
            options.person,
            options.performance_sound,
        )

    @contextmanager
    def opened(self, language: str | None = None) -> Iterator["Driving"]:
        """Open what moves faces.

        Parameters
        ----------
        language : of what is said, by which one of several tables is chosen; None or empty where it is not known.

        Raises
        ------
        EngineError : a table cannot be used, or it is not known which; or another file is where the units go.
        """
        pinyin = load_pinyin_table(self.pinyin_table) if self.pinyin_table else load_pinyin_table()
        if self.spring is not None:
            pinyin = replace(pinyin, spring=Spring.of(self.spring))
        style = self.style or neutral_style()
        pinyin = replace(pinyin, mouth=style.on_table(pinyin.mouth))
        Guard(owns, self.overwrite).check(self.units)
        keywords = load_keywords(*self.keywords) if self.performance else None
        options = PerformanceOptions(self.choice, self.seed or 0, self.without, style, keywords)
        with ExitStack() as stack:
            tables = [stack.enter_context(PerformanceTable.open(path)) for path in self.performance]
            network = None if self.network is None else load_face_network(self.network)
            abouts = [table.about for table in tables]
            table = tables[chosen_table(abouts, self.use, self.person, language or "")] if tables else None
            own = None
            if table is not None and self.own_sound:
                own = OwnSound(table, self.choice, options.seed)
                options = replace(options, given=own.units_of)
            yield Driving(self, pinyin, table, options, network, own)


USUAL_DRIVER: DriverChoice = DriverChoice()
"""Letters of pinyin where Chinese is said, else rules."""


@dataclass(frozen=True)
class Driving:
    """Moves faces by what is said.

    Attributes
    ----------
    asked : what shall move them.
    pinyin : the pinyin table.
    recorded : the recorded faces; None where they move nothing.
    options : how these are looked up.
    network : moves a face by the sound alone; None where none does.
    own_sound : has the recorded faces speak; None where a voice does.
    """

    asked: DriverChoice
    pinyin: PinyinTable
    recorded: PerformanceTable | None
    options: PerformanceOptions
    network: FaceNetwork | None = None
    own_sound: OwnSound | None = None

    def spoken(self, sentences: Iterable[SpokenSentence], say: Say) -> Iterator[SpokenSentence]:
        """Return what a voice says, as the table's recordings say it where they are to speak; say what they lack.

        Raises
        ------
        EngineError : the sound of a recording is missing, or cannot be read.
        """
        own, told = self.own_sound, 0
        if own is None:
            yield from sentences
            return
        for sentence in own.follow(sentences):
            for note in own.notes[told:]:
                say(own.table.about.name, note)
            told = len(own.notes)
            yield sentence

    def say_notes(self, say: Say) -> None:
        """Say if no person, but a model of one, moved in the recorded faces."""
        words = "the performer is synthetic: no person moved, but a model of one"
        if self.recorded is not None and self.recorded.about.synthetic:
            say(self.recorded.about.name, words)
        if self.network is not None:
            for note in ((words,) if self.network.synthetic else ()) + self.network.notes:
                say(self.network.name, note)

    def chosen(
        self, utterance: Utterance | None, name: str, takes: Takes | None = None, driver: FaceDriver | None = None
    ) -> FaceDriver:
        """Return what moves a face that says this.

        Parameters
        ----------
        utterance : what is said; None where unknown.
        name : of the sound or the text, for people.
        takes : whether letters can move the face, for `AUTO`; they can, where it is None.
        driver : another one than was asked for.

        Raises
        ------
        EngineError : the driver cannot move a face by it.
        """
        driver = driver or self.asked.driver
        if driver is FaceDriver.AUTO:
            letters = utterance is not None and has_pinyin(utterance)
            moves = takes is None or takes(self.pinyin.mouth.movestates)
            driver = usual_driver(
                has_table=self.recorded is not None and (utterance is not None or self.network is None),
                has_letters=letters and moves,
                has_network=self.network is not None,
            )
        if driver in _NEEDS_WORDS and (utterance is None or is_other_text(utterance)):
            raise EngineError(
                f"{name}: {_NEEDS_WORDS[driver]}, which are unknown; give the text with --text, or the text or "
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
        self,
        driver: FaceDriver,
        utterance: Utterance | None,
        speech: Transcript,
        say: Say,
        text: str = "",
        sound: Sound | None = None,
    ) -> MovementTrack | None:
        """Return how a chosen driver moves a face; None by rules.

        What a table lacks is said, and the units that are asked for are written.

        Parameters
        ----------
        utterance, speech : what is said, and how loud and high.
        say : told what the table lacks.
        text : the same as it is written, for the marks of its pauses.
        sound : in which it is said; None where there is none to follow.

        Raises
        ------
        EngineError : a network is to follow the sound, and there is none.
        """
        if driver is FaceDriver.NETWORK and self.network is not None:
            if sound is None:
                raise EngineError(
                    f"{speech.name}: a network moves a face by a sound, and this has none; have a voice say it, or "
                    "choose another --text-driver"
                )
            return FaceNetworkTrack(self.network, sound())
        if utterance is not None and driver is FaceDriver.PINYIN:
            return pinyin_track(utterance, self.pinyin, text=text, seed=self.asked.seed)
        if utterance is None or driver is not FaceDriver.TABLE or self.recorded is None:
            return None
        track = PerformanceTrack(utterance, speech, self.recorded, self.options)
        for note in track.notes:
            say(self.recorded.about.name, note)
        if self.asked.units is not None:
            units = format_units(track.units()).encode()
            write_guarded(self.asked.units, [units], Guard(owns, self.asked.overwrite))
        return track

    def movement(
        self, track: MovementTrack | None, speech: Transcript, exporter: Exporter, say: Say
    ) -> Animation | None:
        """Return the movement of a face for an export; None by rules, and where the format has its own shapes.

        The latter is said, unless the letters were not asked for.
        """
        if track is None:
            return None
        if exporter.takes(track.mouth().movestates):
            return track.animation(speech, exporter.rate, exporter.idle)
        if self.asked.driver is not FaceDriver.AUTO or self.recorded is not None:
            say(exporter.name, "it has shapes of its own, which follow the phones")
        return None

    def caption(self, driver: FaceDriver) -> str:
        """Return what people call a chosen driver."""
        if driver is FaceDriver.TABLE and self.recorded is not None:
            return self.recorded.about.title
        if driver is FaceDriver.NETWORK and self.network is not None:
            return self.network.title
        return driver.caption
