"""Sentences that a person reads: which, where their sounds are in a recording, and how it is kept beside the takes.

They are spelt in the phonetic alphabet, a space between sounds and ``|`` where a pause may be; what class a sound is
says `phonemeengine.labels.phone_sets`. Each holds all vowels, m, p, s, and sh where the language has it.

The recording has no labels by hand. Its sounds are known, though, in order, and so they are aligned with the phonemes
of the shipped recogniser. That one is no part of the presets that are compared, unless one of them is the shipped one
itself: that one is favoured a little where two sounds meet. So what lies within 10 ms of such a place, or 30 ms of a
silence, does not count.

Reading the project as a corpus gives the takes alone. What was read to learn from, and what was held out to judge
by, lie in folders of their own.
"""

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from phonemeengine.alignment.align import align_analyses
from phonemeengine.analyser import analyse_blocks
from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.recording import write_flac
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.takes.take import TRIMMED, folder_for
from phonemeengine.errors import CorpusError, TakeError, remedy
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.phone_sets import ipa_class, phone_classes_in, split_ipa
from phonemeengine.labels.table import format_table, write_text
from phonemeengine.labels.utterance import CORE, UNKNOWN_WORD, Label, Utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.model_choice import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, Channel
from phonemeengine.storage.files import free_path, printable_name, reason_of
from phonemeengine.text.pronunciation import Pronunciation, ScriptWord
from phonemeengine.text.syllables import SpokenSyllable

PAUSE = "|"
"""Where the speaker may pause; also at the beginning and at the end."""


@dataclass(frozen=True)
class Sentence:
    """A text to read aloud.

    Attributes
    ----------
    language : its name, in English.
    text : as it is shown.
    phones : as it is pronounced.

    Raises
    ------
    CorpusError : a phone is in no alphabet.
    """

    language: str
    text: str
    phones: str

    def __post_init__(self) -> None:
        for phone in self.sounds:
            if ipa_class(phone) is None:
                raise CorpusError(
                    f"{phone!r} is no sound of the phonetic alphabet; spell the sentence with those of IPA"
                )

    @property
    def words(self) -> tuple[ScriptWord, ...]:
        """What is said between two places where a pause may be, as words of a script."""
        parts = (split_ipa("".join(part.split())) for part in self.phones.split(PAUSE))
        return tuple(ScriptWord(" ".join(part), (Pronunciation((SpokenSyllable(part),)),)) for part in parts)

    @property
    def sounds(self) -> tuple[str, ...]:
        """The sounds in order; an affricate is a closure and friction."""
        return tuple(phone for word in self.words for phone in word.pronunciations[0].phones)


SENTENCES = (
    Sentence(
        "English",
        "Papa, may I have some more apple juice, please? She sells sea shells, maybe on the shore near my house.",
        "p ɑ p ɑ | m eɪ | aɪ | h æ v | s ʌ m | m ɔ ɹ | æ p ə l | dʒ u s | p l i z | ʃ i | s ɛ l z | s i | ʃ ɛ l z | "
        "m eɪ b i | ɑ n | ð ə | ʃ ɔ ɹ | n ɪ ɹ | m aɪ | h aʊ s",
    ),
    Sentence(
        "English",
        "My best sheep sleeps on the moss, and you push the door open for him.",
        "m aɪ | b ɛ s t | ʃ i p | s l i p s | ɑ n | ð ə | m ɔ s | æ n d | j u | p ʊ ʃ | ð ə | d ɔ ɹ | oʊ p ə n | "
        "f ɔ ɹ | h ɪ m",
    ),
    Sentence(
        "German",
        "Meine Mama mag Musik, und Opa schläft am See im Sessel, bis Papa schimpft und Susi eine Suppe isst.",
        "m aɪ n ə | m a m a | m a k | m u z i k | ʊ n t | o p a | ʃ l ɛ f t | a m | z e | ɪ m | z ɛ s ə l | b ɪ s | "
        "p a p a | ʃ ɪ m p f t | ʊ n t | z u z i | aɪ n ə | z ʊ p ə | ɪ s t",
    ),
    Sentence(
        "German",
        "Im Mai sah Opa ein Schaf und ein Pferd, und Susi ließ sie im Moos spielen.",
        "ɪ m | m aɪ | z a | o p a | aɪ n | ʃ a f | ʊ n t | aɪ n | p f e ɐ t | ʊ n t | z u z i | l i s | z i | ɪ m | "
        "m o s | ʃ p i l ə n",
    ),
    Sentence(
        "French",
        "Papa a mis la soupe chaude dans un seau, et le chat mouillé a sauté aussi haut que la petite souris.",
        "p a p a | a | m i | l a | s u p | ʃ o d | d ɑ̃ | z œ̃ | s o | e | l ə | ʃ a | m u j e | a | s o t e | o s i | "
        "o | k ə | l a | p ə t i t | s u ʁ i",
    ),
    Sentence(
        "French",
        "Ma poupée a sali sa chemise, mais Simon cache tout sous le piano.",
        "m a | p u p e | a | s a l i | s a | ʃ ə m i z | m ɛ | s i m ɔ̃ | k a ʃ | t u | s u | l ə | p j a n o",
    ),
    Sentence(
        "Italian",
        "La mia mamma ha preso un pesce fresco, e papà usa una sciarpa; poi il sole sale sopra il muro.",
        "l a | m i a | m a m m a | a | p r e s o | u n | p e ʃ ʃ e | f r e s k o | e | p a p a | u z a | u n a | "
        "ʃ a r p a | p o i | i l | s o l e | s a l e | s o p r a | i l | m u r o",
    ),
    Sentence(
        "Italian",
        "Mio zio esce sempre, poi usa le scimmie di pezza e il sapone.",
        "m i o | ts i o | e ʃ ʃ e | s e m p r e | p o i | u z a | l e | ʃ i m m j e | d i | p e ts ts a | e | i l | "
        "s a p o n e",
    ),
    Sentence(
        "Spanish",
        "Mi mamá puso la mesa, y Pepe sube a su mula con un saco; pasea solo por el monte, si no llueve.",
        "m i | m a m a | p u s o | l a | m e s a | i | p e p e | s u b e | a | s u | m u l a | k o n | u n | "
        "s a k o | p a s e a | s o l o | p o r | e l | m o n t e | s i | n o | ʎ w e b e",
    ),
    Sentence(
        "Spanish",
        "Este sapo come uvas, y mi primo pisa una suma de lápices.",
        "e s t e | s a p o | k o m e | u b a s | i | m i | p r i m o | p i s a | u n a | s u m a | d e | "
        "l a p i s e s",
    ),
)
"""Those that the guided calibration offers, two of each language: the first to learn from, the second to judge by."""

LANGUAGES = tuple(dict.fromkeys(sentence.language for sentence in SENTENCES))
"""A language for which there are sentences; the first one where none is chosen."""


def sentences_in(language: str) -> tuple[Sentence, Sentence]:
    """Return what is read to learn from, and what is read to judge by.

    Raises
    ------
    CorpusError : there is none in this language.
    """
    found = [sentence for sentence in SENTENCES if sentence.language.lower() == language.lower()]
    if not found:
        raise CorpusError(f"there is no sentence in {language!r}; {remedy(language, LANGUAGES)}")
    return found[0], found[1]


LEAST_FRAMES = 3
"""Of a sound that is read without haste, 10 ms each, in the mean."""
LONGEST = 30
"""Seconds of a sound that are read."""
SPOKEN = "read"
"""What the corpus of a sentence that was read is called, and its folder."""
AROUND, AROUND_SILENCE = 0.01, 0.03
"""What does not count on each side of a place where two sounds meet, seconds."""


def aligned(samples: Float32Array, said: Sentence | Sequence[ScriptWord]) -> tuple[Label, ...]:
    """Label a recording of a sentence by its known text.

    Where sounds meet, and around silence, labels have the certainty ``trimmed``: the place is not known that well.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz, ±1.
    said : what was read: a sentence, or the words of a text (`phonemeengine.words_of`).

    Raises
    ------
    TakeError : it is too short for the sentence, or something else was read.
    """
    words = said.words if isinstance(said, Sentence) else said
    duration = len(samples) / SAMPLE_RATE
    n_sounds = sum(len(word.pronunciations[0].phones) for word in words)
    if duration < LEAST_FRAMES * n_sounds * FRAME_PERIOD:
        raise TakeError("the recording is too short for this sentence; read all of it, without rushing")
    found = align_analyses(analyse_blocks([samples], _judge()), words, duration)
    if found.skipped or any(word.text == UNKNOWN_WORD for word in found.words):
        raise TakeError("the recording does not match this sentence; read it again exactly as shown, without rushing")
    return labels_of(found)


def read_sentence(
    sound: str | os.PathLike[str], said: Sentence | Sequence[ScriptWord], channel: Channel = Channel.MIX
) -> LabelledUtterance:
    """Return a recording of a sentence, labelled by its known text: what `calibrate` learns a voice from.

    Parameters
    ----------
    sound : the file; at most half a minute of it is read.
    said : as for `aligned`.
    channel : which channel of the file is analysed.

    Raises
    ------
    AudioError : the file cannot be read.
    TakeError : it is too short for the sentence, or something else was read.
    """
    path = Path(sound)
    with SoundReader(path, channel) as reader:
        samples = reader.read_mono(LONGEST * SAMPLE_RATE)
    try:
        labels = aligned(samples, said)
    except TakeError as error:
        raise TakeError(f"{printable_name(path)}: {error}") from error
    return LabelledUtterance(path, labels, path.stem, SPOKEN, channel=channel)


def labels_of(utterance: Utterance) -> tuple[Label, ...]:
    """Return the phones of an utterance, and the silence between them, as labels without gaps."""
    labels = [*_with_silence(utterance)]
    return tuple(part for k in range(len(labels)) for part in _parts_of(labels, k))


def _with_silence(utterance: Utterance) -> Iterator[Label]:
    at, silence = 0.0, Phoneme.SILENCE
    for phone in utterance.phones:
        if phone.start - at > FRAME_PERIOD / 2:
            yield Label(at, phone.start, silence.label, silence)
        sense = phone_classes_in(phone.ipa)[1]
        yield Label(phone.start, phone.end, phone.ipa, phone.phoneme, sense.certainty if sense else CORE)
        at = phone.end
    if utterance.duration - at > FRAME_PERIOD / 2:
        yield Label(at, utterance.duration, silence.label, silence)


def _parts_of(labels: Sequence[Label], k: int) -> list[Label]:
    """Return a label's middle, and what of it does not count, where it meets another class."""
    label = labels[k]
    before, after = (_around(label, labels[n]) if 0 <= n < len(labels) else 0.0 for n in (k - 1, k + 1))
    first = min(label.start + before, (label.start + label.end) / 2)
    last = max(first, label.end - after)
    parts = ((label.start, first, TRIMMED), (first, last, label.certainty), (last, label.end, TRIMMED))
    return [Label(a, b, label.phone, label.phoneme, c) for a, b, c in parts if b - a > FRAME_PERIOD / 2]


def _around(one: Label, other: Label) -> float:
    classes = {one.phoneme, other.phoneme}
    if len(classes) == 1:
        return 0.0
    return AROUND_SILENCE if Phoneme.SILENCE in classes else AROUND


@lru_cache(maxsize=1)
def _judge() -> Preset:
    return for_files(load_preset(DEFAULT_PRESET))


# When a voice begins in the microphone's signal, and whether it has ended.

PERIOD = 0.01
QUIET_FRAMES, LOUD_FRAMES = 8, 5
"""How many of 10 ms must be quiet before a sound, and loud in a row where it begins."""


def onset_in(sound: Float32Array, rate: int, threshold: float) -> float | None:
    """Return when a voice begins, seconds: where, after quiet, it stays as loud as a threshold (RMS); None if never.

    Parameters
    ----------
    sound : float32, shape (n,), ±1.
    rate : Hz.
    threshold : an amplitude.
    """
    quiet = run = 0
    for k, is_loud in enumerate(_loud(sound, rate, threshold).tolist()):
        run = run + 1 if is_loud else 0
        if quiet >= QUIET_FRAMES and run >= LOUD_FRAMES:
            return (k + 1 - run) * PERIOD
        if not is_loud:
            quiet = quiet + 1
        elif quiet < QUIET_FRAMES:
            quiet = 0
    return None


def quiet_at_end(sound: Float32Array, rate: int, threshold: float) -> float:
    """Say for how long it has been quieter than a threshold, seconds; the parameters are those of `onset_in`."""
    loud = np.flatnonzero(_loud(sound, rate, threshold))
    return len(sound) / rate - (int(loud[-1]) + 1) * PERIOD if len(loud) else len(sound) / rate


def _loud(sound: Float32Array, rate: int, threshold: float) -> BoolArray:
    frame = max(1, round(PERIOD * rate))
    n = len(sound) // frame
    levels = np.sqrt(np.mean(sound[: n * frame].reshape(n, frame) ** 2, axis=1)) if n else np.zeros(0)
    return np.asarray(levels >= threshold)


HELD_OUT = "held-out"
"""The folder of sentences from which nothing is learned, in a project of takes; that of the others is `SPOKEN`."""


def keep_sentence(
    folder: Path,
    samples: Float32Array,
    rate: int,
    mono: Float32Array,
    sentence: Sentence,
    speaker: str,
    *,
    teaches: bool,
) -> LabelledUtterance:
    """Label a sentence by its known text, and keep it in a project of takes.

    Parameters
    ----------
    folder : of the project.
    samples, rate : as it was recorded, shape (n, n_channels), and Hz.
    mono : the same as one channel at 44.1 kHz, shape (m,).
    sentence : what was to be read.
    speaker : who read it.
    teaches : whether it is learned from; else it is to judge by.

    Raises
    ------
    TakeError : something else was read, or the folder cannot be written; nothing is kept.
    RecordingError, CorpusError : the disk refuses.
    """
    labels = aligned(mono, sentence)
    part = SPOKEN if teaches else HELD_OUT
    place = folder / part / folder_for(speaker)
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise TakeError(
            f"{printable_name(place)}: this folder cannot be made ({reason_of(error)}); choose another for the takes"
        ) from error
    path = free_path(place / f"{sentence.language.lower()}-1.flac")
    write_flac(path, samples, rate)
    write_text(format_table(labels), path.with_suffix(".csv"))
    return LabelledUtterance(path, read_labels(path.with_suffix(".csv")), speaker, part)  # as others will read it
