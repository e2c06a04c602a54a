"""A text that was spoken to its end: what is said when, and how loud and high, as a mouth needs it."""

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from phonemeengine.analyser import Analyser
from phonemeengine.audio.wav import WavEncoder, check_wav_name
from phonemeengine.labels.utterance import Utterance, Word, shifted
from phonemeengine.mouth.transcript import Prosody, Transcript, transcript_of_utterance
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.voice import SpokenSentence


@dataclass(frozen=True, eq=False)
class SpokenText:
    """A text as it was spoken.

    Attributes
    ----------
    utterance : what is said when, without gaps between the sentences.
    transcript : the same as mouths and exports need it; loudness and pitch only where they were measured.
    """

    utterance: Utterance
    transcript: Transcript


def spoken_text(
    sentences: Iterable[SpokenSentence],
    *,
    language: str = "",
    sound: BinaryIO | None = None,
    path: str | os.PathLike[str] | None = None,
    measured: bool = True,
    felt: bool = False,
) -> SpokenText:
    """Take all sentences of a text as they are spoken, of any length: their sound is not kept.

    Parameters
    ----------
    sentences : as from `Voice.speak`, or one of `speak_by_program`.
    language : of the text.
    sound : an empty file, into which the sound is written as WAV.
    path : how that file is called.
    measured : loudness and pitch, by which mouth and head move; takes longer than to speak.
    felt : the feeling in the voice, too, where it is measured.

    Raises
    ------
    EngineError : as the sentences do, or the file's name ends otherwise than WAV.
    OSError : the sound cannot be written.
    """
    if path is not None:
        check_wav_name(Path(path))
    analyser = Analyser(load_preset(DEFAULT_PRESET), pitch=True) if measured else None
    words: list[Word] = []
    skipped: list[str] = []
    prosody, n = Prosody(felt=felt), 0
    for sentence in written_as_spoken(sentences, sound):
        if analyser is not None:
            prosody.add(analyser.push(sentence.samples))
        words += (shifted(word, n / SAMPLE_RATE) for word in sentence.words)
        skipped += sentence.skipped
        n += len(sentence.samples)
    if analyser is not None:
        prosody.add(analyser.finish())
    utterance = Utterance(tuple(words), n / SAMPLE_RATE, language, tuple(skipped))
    name = "text" if path is None else Path(path).name
    loud, high, feelings = prosody.intensities, prosody.pitches, prosody.feelings
    transcript = transcript_of_utterance(utterance, loud, high, name, path, feelings)
    return SpokenText(utterance, transcript)


def written_as_spoken(sentences: Iterable[SpokenSentence], sound: BinaryIO | None) -> Iterator[SpokenSentence]:
    """Return sentences as they come, and write their sound as WAV, where there is a file for it.

    Raises
    ------
    OSError : the sound cannot be written.
    """
    if sound is None:
        yield from sentences
        return
    encoder = WavEncoder(sound, SAMPLE_RATE, 1)
    for sentence in sentences:
        encoder.write(sentence.samples[:, None])
        yield sentence
    encoder.close()
