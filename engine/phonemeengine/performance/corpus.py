"""Folders of recorded performances, read and built into tables: a sound, a TextGrid and a face's movement each.

``NAME.wav``, ``NAME.TextGrid`` with the tiers phones, words and syllables, and ``NAME.csv`` of Live Link Face or
OpenFace; in place of the latter an animated ``NAME.glb`` or ``NAME.gltf``, or messages of the VMC protocol,
``NAME.osc``. Two files say something of the whole folder, if they are there: ``offsets.csv`` (columns name, seconds)
by how much later than the sound a face begins, and ``corpus.toml`` what it is called, who speaks in which language,
and whether a person or a model moved.
"""

import math
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.files import SoundReader, is_sound, once_each
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.pitch import fundamental_of
from phonemeengine.errors import AudioError, CorpusError, PerformanceError
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.labels.phone_sets import ipa_of, stress_of_arpabet
from phonemeengine.labels.table import read_text, rows_of
from phonemeengine.labels.utterance import Syllable, Utterance, Word
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.performance.face_csv import read_face_csv
from phonemeengine.performance.face_track import LONGEST_GAP, FaceTrack, read_vmc
from phonemeengine.performance.gltf_face import read_gltf_face
from phonemeengine.performance.keywords import plain_words
from phonemeengine.performance.recording import Performance, PerformedPhone, phones_of
from phonemeengine.performance.table_file import TableAbout, write_table
from phonemeengine.settings import HOP, SAMPLE_RATE
from phonemeengine.storage.files import printable_name
from phonemeengine.storage.strict_table import load_text, parse_toml
from phonemeengine.text.syllables import syllables_of

# How loud and how high each phone is spoken.

QUIETEST = -100.0
"""What is quieter counts as so loud, dB."""
_AT_ONCE = 32 * HOP
"""Samples whose pitch is measured at once: so few that no other core is called to help, which would cost more."""


def measured(phones: Sequence[PerformedPhone], samples: Float32Array) -> tuple[PerformedPhone, ...]:
    """Return phones with their energy and pitch.

    Parameters
    ----------
    phones : in order of time.
    samples : float32, shape (n,), of the sound in which they are spoken, mono at 44.1 kHz, ±1.
    """
    squares = np.concatenate([[0.0], np.cumsum(samples.astype(np.float64) ** 2)])
    pitches = pitches_of(samples)
    return tuple(replace(phone, energy=_level(squares, phone), pitch=_pitch(pitches, phone)) for phone in phones)


def _level(squares: Float64Array, phone: PerformedPhone) -> float:
    """Return the mean level of a phone, dB; `squares` are the sums of all squares before each sample."""
    first, last = (min(round(time * SAMPLE_RATE), len(squares) - 1) for time in (phone.start, phone.end))
    power = (squares[last] - squares[first]) / max(last - first, 1)
    return max(10 * float(np.log10(max(power, 1e-30))), QUIETEST)


def _pitch(pitches: Float32Array, phone: PerformedPhone) -> float:
    """Return the median pitch of a phone's frames, Hz; 0 where fewer than half of them are voiced."""
    frames = pitches[int(phone.start * SAMPLE_RATE / HOP) : max(1, round(phone.end * SAMPLE_RATE / HOP))]
    return float(np.median(frames)) if len(frames) else 0.0


def pitches_of(samples: Float32Array) -> Float32Array:
    """Return the pitch of a sound for each 10 ms, Hz; 0 where it is unvoiced."""
    framer = Framer()
    blocks = [framer.cut_frames(samples[k : k + _AT_ONCE]) for k in range(0, len(samples), _AT_ONCE)]
    found = [fundamental_of(block) for block in (*blocks, framer.finish()) if len(block)]
    return np.concatenate([np.zeros(0, np.float32), *found])


RATE = 60.0
"""Frames a second of all performances."""
LONGEST = 600.0
"""Seconds of a recording at most."""
MOST_SURPLUS = 1.0
"""Seconds by which a face may outlast its sound."""
ABOUT, OFFSETS, FORMAT = "corpus.toml", "offsets.csv", "phonemeanalyser corpus 1"
OFFSET_COLUMNS = ("name", "seconds")
_FACES = {".csv": read_face_csv, ".glb": read_gltf_face, ".gltf": read_gltf_face, ".osc": read_vmc}
"""What reads a face, by the ending of its file; of several the first one counts."""


@dataclass(frozen=True)
class RecordingFiles:
    """The files of a recording.

    Attributes
    ----------
    sound, labels, face : the files.
    offset : by how much later than the sound the face begins, seconds.
    """

    sound: Path
    labels: Path
    face: Path
    offset: float = 0.0

    @property
    def name(self) -> str:
        """What its files are called, without endings."""
        return self.sound.stem


@dataclass(frozen=True)
class Corpus:
    """A folder of recordings.

    Attributes
    ----------
    name : what it is called.
    synthetic : whether no person, but a model of one moved.
    recordings : those that are complete, by name.
    notes : what is odd about the folder, a sentence each.
    person, language : who speaks, and in which language; empty where that is not known.
    clips : recordings that answer words, or up to five words, as `plain` writes them.
    """

    name: str
    synthetic: bool
    recordings: tuple[RecordingFiles, ...]
    notes: tuple[str, ...]
    person: str = ""
    language: str = ""
    clips: Mapping[str, str] = field(default_factory=dict)


def find_recordings(folder: Path) -> Corpus:
    """Return the recordings in a folder; those that lack a file are left out, and it is said.

    Raises
    ------
    CorpusError : the folder cannot be read, or holds none; or a file about it says something impossible.
    """
    about = _about(folder)
    try:
        files = {path.name.lower(): path for path in sorted(folder.iterdir())}
    except OSError as error:
        raise CorpusError(
            f"{printable_name(folder)}: this folder cannot be read ({error.strerror}); check its name and permissions"
        ) from error
    sounds, copies = once_each(path for path in files.values() if is_sound(path))
    found = [_recording_of(sound, files) for sound in sounds]
    found += [f"{printable_name(x)}: it is left out, as {printable_name(of)} is the same" for x, of in copies.items()]
    recordings = tuple(entry for entry in found if isinstance(entry, RecordingFiles))
    if not recordings:
        raise CorpusError(
            f"{printable_name(folder)}: a recording is NAME.wav, NAME.TextGrid and NAME.csv of Live Link Face, and "
            "there is none in this folder; put them side by side"
        )
    recordings, unknown = _shifted(recordings, folder / OFFSETS)
    clips, known = about.get("clips", {}), {recording.name for recording in recordings}
    lacking = dict.fromkeys(name for name in clips.values() if name not in known)
    silent = (f"{ABOUT}: there is no recording {name[:40]!r} for [clips]" for name in lacking)
    notes = (*(note for note in found if isinstance(note, str)), *unknown, *silent)
    synthetic, name = about.get("synthetic", False), about.get("name", folder.resolve().name)
    return Corpus(name, synthetic, recordings, notes, about.get("person", ""), about.get("language", ""), clips)


def read_performance(recording: RecordingFiles, *, synthetic: bool = False) -> tuple[Performance, tuple[str, ...]]:
    """Read a recording: its face at 60 frames a second, and its phones with their energy and pitch.

    Returns
    -------
    The performance, and what is odd about it, a sentence each.

    Raises
    ------
    AudioError : its sound cannot be read.
    CorpusError : its labels or its face cannot be read, or they do not fit its sound.
    """
    with SoundReader(recording.sound) as reader:
        duration = reader.duration
        if duration > LONGEST:
            raise CorpusError(
                f"{printable_name(recording.sound)}: a recording lasts {LONGEST:g} s at most, this {duration:.0f} s; "
                "cut it into sentences"
            )
        samples = reader.read_mono()
    utterance = _syllabified(read_utterance(recording.labels, duration))
    if not utterance.words:
        raise CorpusError(f"{printable_name(recording.labels)}: its labels hold no speech; label it, or leave it out")
    face = _FACES[recording.face.suffix.lower()](recording.face)
    _check_lengths(face, recording, duration)
    times = np.arange(math.floor(duration * RATE + 1e-6) + 1) / RATE
    performance = Performance(
        recording.name,
        RATE,
        face.channels,
        face.sampled(times - recording.offset),
        measured(phones_of(utterance), samples),
        tuple(word.text for word in utterance.words),
        synthetic,
    )
    return performance, tuple(f"{printable_name(recording.face)}: {note}" for note in face.notes)


def _about(folder: Path) -> dict[str, Any]:
    path = folder / ABOUT
    return load_text(path, "a text", CorpusError, _entries_of_about, 1 << 16) if path.is_file() else {}


def _entries_of_about(text: str) -> dict[str, Any]:
    table = parse_toml(text, "such a file", FORMAT, CorpusError)
    known: dict[str, type] = {"name": str, "synthetic": bool, "person": str, "language": str, "clips": dict}
    entries, clips = table.read(known, optional=tuple(known)), table.table("clips")
    return entries | {"clips": {words: name for name in clips.entries for words in plain_words(clips, name)}}


def _recording_of(sound: Path, files: dict[str, Path]) -> RecordingFiles | str:
    """Return a recording of a sound, or a sentence about what is missing."""
    stem = sound.stem.lower()
    labels = files.get(f"{stem}.textgrid")
    face = next((files[stem + suffix] for suffix in _FACES if stem + suffix in files), None)
    if labels is None or face is None:
        return f"{printable_name(sound)}: it is left out, as there is no {'TextGrid' if face else 'face'} beside it"
    return RecordingFiles(sound, labels, face)


def _shifted(recordings: tuple[RecordingFiles, ...], path: Path) -> tuple[tuple[RecordingFiles, ...], Iterator[str]]:
    """Return recordings with their offsets, and what is said of unknown ones."""
    offsets = _offsets_in(path) if path.is_file() else {}
    unknown = offsets.keys() - {recording.name for recording in recordings}
    notes = (f"{OFFSETS}: there is no recording {name[:40]!r}" for name in sorted(unknown))
    return tuple(replace(x, offset=offsets.get(x.name, 0.0)) for x in recordings), notes


def _offsets_in(path: Path) -> dict[str, float]:
    offsets: dict[str, float] = {}
    for line, row in rows_of(read_text(path), OFFSET_COLUMNS, OFFSETS):
        try:
            seconds = float(row["seconds"])
        except ValueError:
            seconds = math.nan
        if not abs(seconds) <= LONGEST:
            raise CorpusError(
                f"{OFFSETS}, line {line}: seconds must be a number within ±{LONGEST:g}, found "
                f"{row['seconds'][:20]!r}; correct the row"
            )
        offsets[row["name"]] = seconds
    return offsets


def _check_lengths(face: FaceTrack, recording: RecordingFiles, duration: float) -> None:
    begin, end = recording.offset, recording.offset + face.duration
    if begin > LONGEST_GAP or end < duration - LONGEST_GAP or end > duration + MOST_SURPLUS:
        raise CorpusError(
            f"{printable_name(recording.face)}: the face moves from {begin:.2f} to {end:.2f} s of its sound, which "
            f"lasts {duration:.2f} s; it may lack {LONGEST_GAP:g} s, and outlast it by {MOST_SURPLUS:g} s, so cut "
            f"it, or say in {OFFSETS} when it begins"
        )


def _syllabified(utterance: Utterance) -> Utterance:
    """Part words that are labelled as a single syllable by what they are made of."""
    return replace(utterance, words=tuple(_parted(word) for word in utterance.words))


def _parted(word: Word) -> Word:
    if len(word.syllables) > 1 or word.syllables[0].stress:
        return word
    phones = word.phones
    names = ["".join(ipa_of(phone.ipa)) or "?" for phone in phones]
    found = syllables_of(names, [stress_of_arpabet(phone.ipa) for phone in phones])
    coming = iter(phones)
    return replace(
        word, syllables=tuple(Syllable(tuple(next(coming) for _ in few.phones), few.stress) for few in found)
    )


# Building a table of a folder of recordings: one recording after the other, and whole or not at all.

MOST_NOTES = 1000
"""Sentences that are kept."""


@dataclass(frozen=True)
class BuiltTable:
    """A table that was built.

    Attributes
    ----------
    about : what it holds.
    left_out : why recordings were left out, a sentence for each.
    notes : what is odd about the others, a sentence each.
    """

    about: TableAbout
    left_out: tuple[str, ...]
    notes: tuple[str, ...]


def build_table(
    folder: str | os.PathLike[str],
    path: str | os.PathLike[str],
    *,
    name: str | None = None,
    person: str | None = None,
    language: str | None = None,
    progress: Progress = no_progress,
) -> BuiltTable:
    """Build a table of a folder of recordings; see `find_recordings` for what it holds.

    A recording that cannot be used is left out. It takes no more memory than its largest recording does.

    Parameters
    ----------
    path : the table; what is there stays until the new one is complete.
    name : what the table is called; as the folder, where it is None.
    person, language : who speaks, and in which language; as the folder says, where they are None.

    Raises
    ------
    CorpusError : there is no recording in the folder.
    PerformanceError : no recording can be used, or the table cannot be written.
    Cancelled : it was not wanted any more; nothing has changed.
    """
    corpus = find_recordings(Path(folder))
    reading = CorpusReading(corpus, progress)
    about = write_table(
        path,
        reading.performances(),
        name=name or corpus.name,
        folder=folder,
        person=person or corpus.person,
        language=language or corpus.language,
        clips=corpus.clips,
    )
    return BuiltTable(about, tuple(reading.left_out), (*corpus.notes, *reading.notes))


class CorpusReading:
    """Reads the recordings of a corpus, and remembers what is to be said of them."""

    def __init__(self, corpus: Corpus, progress: Progress) -> None:
        self.left_out: list[str] = []
        self.notes: list[str] = []
        self._corpus, self._progress = corpus, progress

    def performances(self) -> Iterator[Performance]:
        """Return those that can be read, one after the other; see `recordings`."""
        return (performance for _, performance in self.recordings())

    def recordings(self) -> Iterator[tuple[RecordingFiles, Performance]]:
        """Return those that can be read with their files, one after the other.

        Raises
        ------
        PerformanceError : none can.
        """
        first: Performance | None = None
        for k, recording in enumerate(self._corpus.recordings):
            report_progress(self._progress, k / len(self._corpus.recordings))
            try:
                performance, notes = read_performance(recording, synthetic=self._corpus.synthetic)
                first = first or performance
                performance.check_beside(first)
            except (AudioError, CorpusError, PerformanceError) as error:
                self.left_out.append(str(error))
                continue
            self.notes += notes[: MOST_NOTES - len(self.notes)]
            yield recording, performance
        if first is None:
            raise PerformanceError(f"no recording can be used; of the first one: {self.left_out[0]}")
        report_progress(self._progress, 1.0)
