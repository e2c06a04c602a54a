"""A table as a source of sound: its recordings say what a voice says, and the face moves as it did in them.

The voice says which phones are spoken, how long, how high and how loud; units of the table are chosen by that, and
their sounds are cut at pitch marks and joined. The sounds are read from beside the table, a unit at a time: a table
of an hour has 36 MB, its sounds ten times as much, and who hands on a face need not hand on a voice.
"""

import glob
import math
import os
import pickle
import tempfile
import threading
import weakref
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby, pairwise
from pathlib import Path
from typing import Any, ClassVar, Protocol, TypeVar

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.files import SoundReader, is_sound
from phonemeengine.dsp.overlap_add import SoundPiece, joined_pieces, pitch_marks
from phonemeengine.errors import PerformanceError
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word, retimed, shifted
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.performance.choice import (
    ChosenUnits,
    ExampleChoice,
    Inventory,
    PlacedUnit,
    chosen_examples,
    notes_on,
    placed_units,
    recorded_strings,
)
from phonemeengine.performance.corpus import measured, pitches_of
from phonemeengine.performance.driver import FACE
from phonemeengine.performance.halves import Recordings, bounds_of, weights_at
from phonemeengine.performance.keywords import joined_words, phrases_in
from phonemeengine.performance.recording import HEAD, SILENCE, Performance, PerformedPhone, phones_of
from phonemeengine.performance.table_file import Example, PerformanceTable
from phonemeengine.performance.units import PAUSE, Sentence, Unit, UnitKind, sentences_in
from phonemeengine.settings import HOP, SAMPLE_RATE
from phonemeengine.storage.files import printable, reason_of

MOST_CHANGED = 0.15
"""Share by which the duration and the pitch of a unit are changed at most."""
MOST_GAIN = math.log(10) * 3 / 10
"""Natural logarithm of what amplitudes of units that meet are evened by at most: 6 dB, half of it by either."""
BESIDE = 0.06
"""Seconds that are read before and after a unit."""
NEAR = 2
"""Frames of 10 ms about a join whose pitch counts."""
_LAST_PAUSE = PAUSE + 0.01
"""Seconds of silence after a sentence at least, so that its face is looked up by itself."""


class Said(Protocol):
    """A sentence as a voice speaks it; see `SpokenSentence`."""

    __dataclass_fields__: ClassVar[dict[str, Any]]

    @property
    def samples(self) -> Float32Array:
        """Mono at 44.1 kHz."""

    @property
    def words(self) -> tuple[Word, ...]:
        """What is said, in seconds from the sentence's beginning."""


SaidT = TypeVar("SaidT", bound=Said)


_Answer = tuple[int, str]
"""A recording that answers words: the first word, and its name."""


class OwnSound:
    """Has the recordings of a table say what a voice says, in constant memory: what was chosen lies on the disk.

    Parameters
    ----------
    table : recorded performances with their sounds beside it; it stays open as long as this is used.
    choice, seed : among the examples of a unit; see `PerformanceOptions`.

    Attributes
    ----------
    table : the same.
    """

    def __init__(self, table: PerformanceTable, choice: ExampleChoice = ExampleChoice.VITERBI, seed: int = 0) -> None:
        self.table = table
        self._choice, self._seed = choice, abs(seed)
        self._chosen = _UnitsOnDisk()
        self._lacking: dict[str, None] = {}

    @property
    def notes(self) -> tuple[str, ...]:
        """Which phones of what was said the recordings lack, and what is said in their place, a sentence each."""
        return tuple(self._lacking)

    def follow(self, sentences: Iterable[SaidT]) -> Iterator[SaidT]:
        """Return what a voice says, each sentence with the table's sound, and with the times of that.

        Raises
        ------
        PerformanceError : the table is damaged, or the sound of a recording is not beside it; or the disk is full.
        AudioError : that sound cannot be read.
        """
        for sentence in sentences:
            yield self._with_own_sound(sentence)

    def units_of(self, sentence: Sentence) -> ChosenUnits | None:
        """Return what the sound of a sentence was made of; None where it is not of this table."""
        return self._chosen.find(_names_of(sentence), sentence[-1].start - sentence[0].end)

    @cached_property
    def _recordings(self) -> Recordings:
        columns = [k for k, name in enumerate(self.table.about.channels) if name.startswith(("jaw", "mouth"))]
        return Recordings(self.table, np.array(columns, np.intp), audible=True)

    @cached_property
    def _inventory(self) -> Inventory:
        return {kind: self.table.names(kind) for kind in UnitKind}

    def _with_own_sound(self, said: SaidT) -> SaidT:
        said, clips = self._with_clips(said)
        utterance = Utterance(said.words, len(said.samples) / SAMPLE_RATE)
        phones = measured(phones_of(utterance), said.samples)
        last = phones[-1]
        end = max(last.end, last.start + _LAST_PAUSE)
        phones = (*phones[:-1], replace(last, middle=(last.start + end) / 2, end=end))
        if not said.words:
            return said
        old, new, parts, at = [], [], [], 0.0
        for sentence in sentences_in(phones):
            bounds, sounds = self._said(sentence, clips)
            old.append(bounds_of(sentence))
            new.append(at + bounds)
            parts += [(at + start, sound) for start, sound in sounds]
            at += float(bounds[-3])  # the last silence is the first one of the next sentence
        samples = np.zeros(round(float(new[-1][-1]) * SAMPLE_RATE), np.float32)
        for start, sound in parts:
            first = round(start * SAMPLE_RATE)
            samples[first : first + len(sound)] += sound[: len(samples) - first]
        times = np.concatenate(old), np.concatenate(new)
        words = tuple(retimed(word, lambda time: float(np.interp(time, *times))) for word in said.words)
        return replace(said, samples=samples, words=words)

    def _with_clips(self, said: SaidT) -> tuple[SaidT, dict[int, _Answer]]:
        """Return a sentence in which recordings answer key words, and the recording of each word that one answers."""
        clips, texts, words = self.table.about.clips, [word.text for word in said.words], [*said.words]
        samples, answered = said.samples, dict[int, _Answer]()
        for first, last in reversed([*phrases_in(texts, clips)]):
            name = clips[joined_words(texts, first, last)]
            clip = self.table.recording_called(name)
            begin, end = clip.phones[0].end, clip.phones[-1].start
            start, stop = words[first].start, words[last].end
            heard = self._read(name, round(begin * SAMPLE_RATE), round(end * SAMPLE_RATE))
            answer = _words_of(clip, texts[first : last + 1], start - begin)
            later = [shifted(word, end - begin - (stop - start)) for word in words[last + 1 :]]
            n_more = len(answer) - (last + 1 - first)
            answered = {word + n_more if word > last else word: of for word, of in answered.items()}
            answered |= dict.fromkeys(range(first, first + len(answer)), (first, name))
            words[first:] = [*answer, *later]
            before, after = round(start * SAMPLE_RATE), round(stop * SAMPLE_RATE)
            samples = np.concatenate([samples[:before], heard, samples[after:]])
        return (replace(said, samples=samples, words=tuple(words)) if answered else said), answered

    def _said(
        self, sentence: Sentence, clips: Mapping[int, _Answer]
    ) -> tuple[Float64Array, list[tuple[float, Float32Array]]]:
        """Return the bounds of a sentence's halves in the table's sound, and its parts with their starts, seconds."""
        self._lacking |= dict.fromkeys(notes_on(sentence, self._inventory, "sounds"))
        answers = [*self._answers_in(sentence, clips)]
        strings = () if answers else recorded_strings(sentence, self.table)
        placed = placed_units(sentence, self._inventory, (*answers, *strings))
        chosen = chosen_examples(placed, sentence, self.table, self._recordings, self._choice, (self._seed,))
        examples = tuple(example for _, example in chosen)
        wanted = np.diff(bounds_of(sentence))
        cuts = [
            _Cut.of(unit, example, halves.name, wanted, self.table)
            for unit, (halves, example) in zip(placed, chosen, strict=True)
        ]
        widths = np.concatenate([cut.widths for cut in cuts])
        bounds = np.concatenate([[0.0], np.cumsum(widths)])
        self._chosen.add(_names_of(sentence), ChosenUnits(bounds, placed, examples))
        sounds = []
        for run in _runs_of(cuts):
            start = float(bounds[run[0].placed.unit.first]) + run[0].silent_before
            sounds.append((start, joined_pieces(_evened([self._piece(cut) for cut in run]))))
        return bounds, sounds

    def _answers_in(self, sentence: Sentence, clips: Mapping[int, _Answer]) -> Iterator[PlacedUnit]:
        """Return the recordings that answer words of a sentence, whole, unless there is a long pause in them."""
        for answer in dict.fromkeys(filter(None, (clips.get(phone.word) for phone in sentence))):
            places = [k for k, phone in enumerate(sentence) if clips.get(phone.word) == answer]
            phones = self.table.recording_called(answer[1]).phones
            names = _names_of(phones[1:-1])
            if _names_of(sentence[places[0] : places[-1] + 1]) == names:
                unit = Unit(UnitKind.CLIP, names, 2 * places[0], 2 * places[-1] + 2)
                number, length = self.table.number_of(answer[1]), phones[-1].start - phones[0].end
                yield PlacedUnit(unit, unit.kind, names, (Example(number, 2, 2 * len(phones) - 2, length),))

    def _read(self, recording: str, first: int, last: int) -> Float32Array:
        """Return the sound of a recording from one sample to another, and silence where it has none."""
        path = original_sound(self.table, recording)
        if path is None:
            raise PerformanceError(
                f"{self.table.about.name}: the sound of the recording {printable(recording[:40])!r} is not in "
                f"the folder {printable(self.table.about.folder)!r} beside the table; put it there, or use a voice"
            )
        begin = max(first, 0)
        with SoundReader(path, as_it_is=True) as reader:
            reader.seek(begin)
            samples = reader.read_mono(last - begin)
        return np.pad(samples, (begin - first, last - begin - len(samples)))

    def _piece(self, cut: "_Cut") -> "_Piece":
        """Read the sound of a unit."""
        first, last = round(cut.start * SAMPLE_RATE), round(cut.end * SAMPLE_RATE)
        before = round(BESIDE * SAMPLE_RATE)
        samples = self._read(cut.recording, first - before, last + before)
        pitches = pitches_of(samples)
        piece = SoundPiece(samples, pitch_marks(samples, pitches), before, before + last - first, cut.stretch)
        ends = (_pitch_about(pitches, piece.start), _pitch_about(pitches, piece.end))
        return _Piece(piece, ends, cut.energies, cut.placed.kind is UnitKind.CLIP)


class _UnitsOnDisk:
    """What sentences were made of; of each, some bytes stay in memory."""

    def __init__(self) -> None:
        self._file = tempfile.TemporaryFile()  # noqa: SIM115 - closed below
        weakref.finalize(self, self._file.close)
        self._known: defaultdict[int, list[tuple[float, int]]] = defaultdict(list)
        self._lock = threading.Lock()  # a face is looked up while its next sentence is spoken

    def add(self, names: tuple[str, ...], units: ChosenUnits) -> None:
        """Keep the units of a sentence."""
        with self._lock:
            try:
                place = self._file.seek(0, os.SEEK_END)
                pickle.dump(units, self._file)
                self._file.flush()
            except OSError as error:
                raise PerformanceError(
                    f"{tempfile.gettempdir()}: what the sound is made of cannot be kept there ({reason_of(error)}); "
                    "free some space"
                ) from error
            self._known[hash(names)].append((float(units.bounds[-3] - units.bounds[2]), place))

    def find(self, names: tuple[str, ...], length: float) -> ChosenUnits | None:
        """Return the units of the sentence of these phones that is the nearest in length, seconds; None for none."""
        with self._lock:
            known = self._known.get(hash(names))
            if known is None:
                return None
            self._file.seek(min(known, key=lambda one: abs(one[0] - length))[1])
            units: ChosenUnits = pickle.load(self._file)  # noqa: S301 - of our own making
            return units


@dataclass(frozen=True)
class _Cut:
    """The part of a recording that is taken.

    Attributes
    ----------
    placed : the unit.
    recording : its name.
    start, end : in the recording, seconds.
    stretch : how much longer it becomes.
    widths : of its halves, seconds.
    silent_before : seconds at its beginning that stay silent.
    energies : of its first and its last phone, dB.
    """

    placed: PlacedUnit
    recording: str
    start: float
    end: float
    stretch: float
    widths: Float64Array
    silent_before: float
    energies: tuple[float, float]

    @classmethod
    def of(
        cls, placed: PlacedUnit, example: Example, recording: str, wanted: Float64Array, table: PerformanceTable
    ) -> "_Cut":
        """Return what is cut for a unit, of an example in a recording; halves of its sentence have widths, seconds.

        Silence at its ends is as long as it is wanted, and taken from the recording as far as it is there.
        """
        first, last = example.first // 2, (example.last - 1) // 2
        phones = table.phones_in(example.recording, first, last)
        halves = bounds_of(phones)[example.first - 2 * first :][: example.last - example.first + 1]
        widths, asked = np.diff(halves), wanted[placed.unit.first : placed.unit.last]
        names = placed.names
        before, after = names[0] == SILENCE and placed.unit.first % 2, names[-1] == SILENCE and placed.unit.last % 2
        spoken = slice(int(before), len(widths) - int(after))
        least, most = 1 - MOST_CHANGED, 1 + MOST_CHANGED
        stretch = float(np.clip(asked[spoken].sum() / max(widths[spoken].sum(), 1e-3), least, most))
        whole = placed.kind in {UnitKind.CLIP, UnitKind.SENTENCE}
        stretch = 1.0 if whole or names == (SILENCE,) else stretch
        heard, silent = widths * stretch, 0.0
        start, end = float(halves[0]), float(halves[-1])
        if before:
            taken = min(widths[0], asked[0] / stretch)
            start, heard[0], silent = float(halves[1] - taken), asked[0], float(asked[0] - taken * stretch)
        if after:
            taken = min(widths[-1], asked[-1] / stretch)
            end, heard[-1] = float(halves[-2] + taken), asked[-1]
        if names == (SILENCE,):
            heard = asked
        energies = phones[0].energy, phones[-1].energy
        return cls(placed, recording, start, end, stretch, heard, silent, energies)


@dataclass(frozen=True, eq=False)
class _Piece:
    """The sound of a unit, with its pitch, Hz, and its level, dB, at both ends; and whether it stays as it is."""

    sound: SoundPiece
    pitches: tuple[float, float]
    energies: tuple[float, float]
    stays: bool


def _runs_of(cuts: Sequence[_Cut]) -> Iterator[list[_Cut]]:
    """Return units that follow each other without silence between them; half a silence alone is no sound."""
    run: list[_Cut] = []
    for cut in cuts:
        silence_first, silence_last = cut.placed.names[0] == SILENCE, cut.placed.names[-1] == SILENCE
        if run and silence_first:
            yield run
            run = []
        if cut.placed.names != (SILENCE,):
            run.append(cut)
        if run and silence_last:
            yield run
            run = []
    if run:
        yield run


def _evened(pieces: Sequence[_Piece]) -> list[SoundPiece]:
    """Return pieces whose pitch and level meet halfway at each join, as far as they may be changed; clips stay."""
    pitches, gains = [[1.0, 1.0] for _ in pieces], [[1.0, 1.0] for _ in pieces]
    for k, (one, other) in enumerate(pairwise(pieces)):
        share = 0.0 if one.stays else 1.0 if other.stays else 0.5
        low, high = one.pitches[1], other.pitches[0]
        step = math.log(high / low) if low and high else 0.0
        louder = min(max((other.energies[0] - one.energies[1]) / 20 * math.log(10), -MOST_GAIN), MOST_GAIN)
        pitches[k][1], gains[k][1] = _limited(math.exp(share * step)), math.exp(share * louder)
        if not other.stays:
            pitches[k + 1][0] = _limited(math.exp((share - 1) * step))
            gains[k + 1][0] = math.exp((share - 1) * louder)
    return [
        replace(piece.sound, pitch=(pitch[0], pitch[1]), gain=(gain[0], gain[1]))
        for piece, pitch, gain in zip(pieces, pitches, gains, strict=True)
    ]


def _limited(factor: float) -> float:
    return min(max(factor, 1 - MOST_CHANGED), 1 + MOST_CHANGED)


def _pitch_about(pitches: Float32Array, sample: float) -> float:
    """Return the median pitch about a sample, Hz; 0 where it is unvoiced."""
    frame = int(sample) // HOP
    near = pitches[max(frame - NEAR, 0) : frame + NEAR + 1]
    return float(np.median(near)) if len(near) else 0.0


def _names_of(sentence: Sequence[PerformedPhone]) -> tuple[str, ...]:
    return tuple(phone.name for phone in sentence)


def _words_of(clip: Performance, texts: Sequence[str], later: float) -> list[Word]:
    """Return what is said in a recording, with the texts that it answers; one word, where their numbers differ."""
    spoken = [phone for phone in clip.phones if phone.name != SILENCE]
    n_words = len({phone.word for phone in spoken})
    words = {} if n_words == len(texts) else dict.fromkeys({phone.word for phone in spoken}, 0)
    found = []
    for _, run in groupby(spoken, key=lambda phone: words.get(phone.word, phone.word)):
        syllables = tuple(
            Syllable(
                tuple(Phone(x.start + later, x.end + later, x.name, ipa_phoneme(x.name)) for x in few), few[0].stress
            )
            for few in ([*phones] for _, phones in groupby(run, key=lambda phone: phone.syllable))
        )
        found.append(syllables)
    named = texts if n_words == len(texts) else [" ".join(texts)]
    return [Word(text, syllables) for text, syllables in zip(named, found, strict=True)]


class RecordedFace:
    """A recording as it was tracked, for a performer to play: a `MouthTrack` of its own time.

    Turns of the head are counted from their median, as a camera stands anywhere.

    Parameters
    ----------
    performance : the recording.

    Attributes
    ----------
    movestates : those of `FACE`, in the order of the weights; those that were not tracked are 0.
    """

    movestates = FACE

    def __init__(self, performance: Performance) -> None:
        self._performance = performance
        places = {name: k for k, name in enumerate(performance.channels)}
        self._shown = [(k, places[name]) for k, name in enumerate(FACE) if name in places]
        turns = [places[name] for name in HEAD if name in places]
        self._turns = turns if len(turns) == len(HEAD) else []
        self._ahead = np.median(performance.weights[:, self._turns], axis=0)

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (60,), 0..1."""
        weights = np.zeros(len(FACE), np.float32)
        frame = self._frame_at(time)
        for place, column in self._shown:
            weights[place] = frame[column]
        return weights.clip(0, 1)

    def head(self, time: float) -> HeadPose | None:
        """Return how the head was turned at a time, seconds; None where that was not recorded."""
        if not self._turns:
            return None
        return HeadPose(*(self._frame_at(time)[self._turns] - self._ahead).tolist())

    def _frame_at(self, time: float) -> Float32Array:
        frame: Float32Array = weights_at(self._performance.weights, np.array([time * self._performance.rate]))[0]
        return frame


def original_sound(
    table: PerformanceTable, recording: str, folder: str | os.PathLike[str] | None = None
) -> Path | None:
    """Return the sound of a recording; None where there is none.

    Parameters
    ----------
    table : in which it is.
    recording : its name.
    folder : where the recordings are; where the table was built of them, as seen from the table, if it is None.
    """
    place = table.path.parent / table.about.folder if folder is None else Path(folder)
    found = sorted(place.glob(f"{glob.escape(recording)}.*")) if Path(recording).name == recording else []
    return next((path for path in found if is_sound(path)), None)
