"""Folders of recorded performances: for each a sound, a TextGrid of what is said, and the face's movement.

``NAME.wav``, ``NAME.TextGrid`` with the tiers phones, words and syllables, and ``NAME.csv`` of Live Link Face; in
place of the latter an animated ``NAME.glb`` or ``NAME.gltf``, or messages of the VMC protocol, ``NAME.osc``. Two
files say something of the whole folder, if they are there: ``offsets.csv`` (columns name, seconds) by how much later
than the sound a face begins, and ``corpus.toml`` what it is called, and whether a person or a model moved.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from phonemeengine.audio.files import SoundReader, is_sound, once_each
from phonemeengine.errors import CorpusError
from phonemeengine.files import printable_name, read_text_file
from phonemeengine.labels.phone_sets import ipa_of, stress_of_arpabet
from phonemeengine.labels.table import rows_of
from phonemeengine.labels.text_io import read_text
from phonemeengine.labels.utterance import Syllable, Utterance, Word
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.performance.face_track import LONGEST_GAP, FaceTrack
from phonemeengine.performance.gltf_face import read_gltf_face
from phonemeengine.performance.livelink import read_livelink
from phonemeengine.performance.prosody import measured
from phonemeengine.performance.recording import Performance, phones_of
from phonemeengine.performance.vmc import read_vmc
from phonemeengine.strict_table import parse_toml
from phonemeengine.text.syllables import syllables_of

RATE = 60.0
"""Frames a second of all performances."""
LONGEST = 600.0
"""Seconds of a recording at most."""
MOST_SURPLUS = 1.0
"""Seconds by which a face may outlast its sound."""
ABOUT, OFFSETS, FORMAT = "corpus.toml", "offsets.csv", "phonemeanalyser corpus 1"
OFFSET_COLUMNS = ("name", "seconds")
_FACES = {".csv": read_livelink, ".glb": read_gltf_face, ".gltf": read_gltf_face, ".osc": read_vmc}
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
    """

    name: str
    synthetic: bool
    recordings: tuple[RecordingFiles, ...]
    notes: tuple[str, ...]


def find_recordings(folder: Path) -> Corpus:
    """Return the recordings in a folder; those that lack a file are left out, and it is said.

    Raises
    ------
    CorpusError : the folder cannot be read, or holds none; or a file about it says something impossible.
    """
    name, synthetic = _about(folder)
    try:
        files = {path.name.lower(): path for path in sorted(folder.iterdir())}
    except OSError as error:
        raise CorpusError(f"{printable_name(folder)}: this folder cannot be read ({error.strerror})") from error
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
    return Corpus(name, synthetic, recordings, (*(note for note in found if isinstance(note, str)), *unknown))


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
        raise CorpusError(f"{printable_name(recording.labels)}: nobody speaks in it; label it, or leave it out")
    face = _FACES[recording.face.suffix.lower()](recording.face)
    _check_lengths(face, recording, duration)
    times = np.arange(math.floor(duration * RATE + 1e-6) + 1) / RATE
    performance = Performance(
        recording.name, RATE, face.channels, face.sampled(times - recording.offset),
        measured(phones_of(utterance), samples), tuple(word.text for word in utterance.words), synthetic,
    )  # fmt: skip
    return performance, tuple(f"{printable_name(recording.face)}: {note}" for note in face.notes)


def _about(folder: Path) -> tuple[str, bool]:
    path = folder / ABOUT
    if not path.is_file():
        return folder.resolve().name, False
    try:
        table = parse_toml(read_text_file(path, 1 << 16, "a text", CorpusError), "such a file", FORMAT, CorpusError)
        entries = table.read({"name": str, "synthetic": bool}, optional=("name", "synthetic"))
    except CorpusError as error:
        raise CorpusError(f"{ABOUT}: {error}") from error
    return entries.get("name", folder.resolve().name), entries.get("synthetic", False)


def _recording_of(sound: Path, files: dict[str, Path]) -> RecordingFiles | str:
    """Return a recording of a sound, or a sentence about what is missing."""
    stem = sound.stem.lower()
    labels = files.get(f"{stem}.textgrid")
    face = next((files[stem + suffix] for suffix in _FACES if stem + suffix in files), None)
    if labels is None or face is None:
        return f"{printable_name(sound)}: it is left out, as there is no {'TextGrid' if face else 'face'} beside it"
    return RecordingFiles(sound, labels, face)


def _shifted(recordings: tuple[RecordingFiles, ...], path: Path) -> tuple[tuple[RecordingFiles, ...], Iterator[str]]:
    """Return recordings with their offsets, and what is said of those that nobody knows."""
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
