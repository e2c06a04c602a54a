"""What is said in the sounds of a command, as its arguments say, and what is found of it."""

import argparse
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from phonemeanalyser.cli.jobs import say_note
from phonemeengine import (
    Analysis,
    EngineError,
    LabelledUtterance,
    Lexicon,
    ScriptWord,
    SoundReader,
    TextError,
    Transcript,
    Utterance,
    VoiceError,
    load_lexicon,
    notes_on,
    words_of,
)
from phonemeengine.alignment.align import is_other_text, scored_take
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.work import Made, Say
from phonemeengine.files import printable, printable_name
from phonemeengine.mouth.transcript import Script, scripted_transcript_of
from phonemeengine.text.espeak import languages
from phonemeengine.text.script import TIMED_SUFFIXES, load_script, script_beside, timed_script, words_beside

AUTO = "auto"
SHOWN_WORDS = 8
OTHER_TEXT = (
    "another text seems to be said in it, so it is recognised without the text; check the text and its language, or "
    "align it anyway with --accept-text"
)


@dataclass(frozen=True)
class SpokenTexts:
    """What is said in sounds, as far as it is known.

    Attributes
    ----------
    texts : by the sound's file.
    labels : TextGrids or JSON with words and times, by the sound's file; these go before texts.
    language : of the texts, or the labels.
    lexicon : goes before the language's voice.
    literal : whether the notation of scripts is words, too.
    accepted : whether texts are aligned even where others seem to be said.
    speaker : whose words of the labels.
    """

    texts: Mapping[Path, str]
    labels: Mapping[Path, Path]
    language: str | None
    lexicon: Lexicon | None
    literal: bool = False
    accepted: bool = False
    speaker: str | None = None

    def known_of(self, sound: Path) -> str:
        """Return what tells whether something else is said in a sound than before."""
        if sound in self.labels:
            return fingerprint_of(self.labels[sound], self.language, self.lexicon, self.speaker)
        return fingerprint_of(self.texts.get(sound), self.language, self.lexicon, self.literal, self.accepted)

    def script_of(self, sound: Path, duration: float, say: Say) -> Script | None:
        """Return what is said in a sound of `duration` seconds, and say what of it is not; None where nobody knows.

        Raises
        ------
        EngineError : its text cannot be spoken, or its labels cannot be read.
        """
        if sound in self.labels:
            return timed_script(self.labels[sound], duration, self.language, self.lexicon, self.speaker)
        text = self.texts.get(sound)
        if text is None:
            return None
        words = words_of(text, self.language, self.lexicon, literal=self.literal)
        for note in notes_on(text, self.language, literal=self.literal):
            say(printable_name(sound), note)
        return words

    def aligned(
        self, reader: SoundReader, sound: Path, analyses: Iterable[Analysis], say: Say
    ) -> tuple[Utterance, Transcript] | None:
        """Return what is said in an open sound, and say what does not fit its text.

        Where nothing is known of it, the answer is None, and no analysis is taken.

        Raises
        ------
        EngineError : its text cannot be spoken, or its labels cannot be read.
        """
        script = self.script_of(sound, reader.duration, say)
        if script is None:
            return None
        name, accepted = printable_name(sound), self.accepted
        found = scripted_transcript_of(analyses, script, name, reader.duration, sound, accept_text=accepted)
        say_misfits(name, found[0], say)
        return found


NO_TEXTS = SpokenTexts({}, {}, None, None)
"""Nothing is known of what is said."""


def spoken_texts(options: argparse.Namespace, sounds: Sequence[Path], *, with_labels: bool = True) -> SpokenTexts:
    """Return what is said in the sounds of a command line with the arguments of `add_script`.

    Parameters
    ----------
    sounds : files.
    with_labels : whether ``auto`` takes the words and times of a TextGrid beside a sound, before a text.

    Raises
    ------
    EngineError : a script or the lexicon cannot be read, or says nothing about the sounds.
    """
    if options.text is None and options.script is None:
        if any(given is not None for given in (options.language, options.lexicon, options.speaker)):
            options.parser.error(
                "--language, --lexicon and --speaker go with --text or --script: say what is said in the sound"
            )
        if options.literal or options.accept_text:
            options.parser.error(
                "--literal and --accept-text go with --text or --script: say what is said in the sound"
            )
        return NO_TEXTS
    lexicon = None if options.lexicon is None else load_lexicon(options.lexicon)
    if options.script is not None and options.script.suffix.lower() in TIMED_SUFFIXES:
        labels = _labels_of(options.script, sounds)
        return SpokenTexts({}, {sounds[0]: labels}, options.language, lexicon, speaker=options.speaker)
    if options.speaker is not None:
        options.parser.error("--speaker goes with a --script that tells speakers apart: a .TextGrid or .json")
    if options.script is not None and str(options.script) == AUTO:
        texts, timed = _beside(sounds, with_labels)
    else:
        texts, timed = _texts_of(options, sounds), {}
    return SpokenTexts(texts, timed, options.language, lexicon, options.literal, options.accept_text)


@dataclass(frozen=True)
class WordsToScore:
    """The words of labelled recordings.

    Attributes
    ----------
    texts : what is said, by the sound's file.
    language : of the texts; None for the manifest's.
    lexicon : goes before the language's voice.
    tags : the languages that there are.
    literal : whether the notation of scripts is words, too.
    """

    texts: Mapping[Path, str]
    language: str | None
    lexicon: Lexicon | None
    tags: frozenset[str]
    literal: bool = False

    def __call__(self, utterance: LabelledUtterance) -> Sequence[ScriptWord] | None:
        """Return the words of a recording, and say at once what cannot be used; None where they are not known."""
        return self.of(utterance, say_note)

    def of(self, utterance: LabelledUtterance, say: Say) -> Sequence[ScriptWord] | None:
        """Return the words of a recording, and say what cannot be used; None where they are not known."""
        if utterance.path not in self.texts:
            return None
        try:
            text, language = self.texts[utterance.path], self._tag_of(utterance)
            return words_of(text, language, self.lexicon, literal=self.literal)
        except VoiceError:
            raise
        except TextError as error:
            say(printable_name(utterance.path), f"recognised without its text: {error}")
            return None

    def known_of(self, utterance: LabelledUtterance) -> str:
        """Return what tells whether something else is said in a recording than before."""
        text = self.texts.get(utterance.path)
        return fingerprint_of(text, self._tag_of(utterance), self.lexicon, self.literal)

    def _tag_of(self, utterance: LabelledUtterance) -> str:
        return self.language or _tag_of(utterance.language, self.tags)


def words_to_score(options: argparse.Namespace, utterances: Sequence[LabelledUtterance]) -> WordsToScore | None:
    """Return what gives the words of labelled recordings; None where the command line asks for none.

    Raises
    ------
    EngineError : a script or the lexicon cannot be read, or says nothing about the sounds.
    """
    if not (options.texts or options.script):
        return None
    texts = {utterance.path: utterance.text for utterance in utterances if utterance.text}
    if options.script is not None:
        texts = dict(load_script(options.script).texts_of([utterance.path for utterance in utterances])[0])
    if not texts:
        raise EngineError("there is no text of what is said; add a column text to the manifest, or name a --script")
    lexicon = None if options.lexicon is None else load_lexicon(options.lexicon)
    tags = frozenset(language.tag for language in languages())
    literal = options.literal or options.script is None  # a manifest tells what is said, and is no script
    return WordsToScore(texts, options.language, lexicon, tags, literal)


def _tag_of(language: str, known: Collection[str]) -> str:
    """Return a manifest's language, such as de-DE, as a voice has it."""
    whole = language.lower()
    return next((tag for tag in (whole, whole.partition("-")[0]) if tag in known), whole)


def say_misfits(name: str, utterance: Utterance, say: Say) -> None:
    """Say what of a text nobody says, or that another one is said."""
    if is_other_text(utterance):
        say(name, OTHER_TEXT)
    elif utterance.skipped:
        words = " ".join(printable(word) for word in utterance.skipped[:SHOWN_WORDS])
        more = len(utterance.skipped) - SHOWN_WORDS
        say(name, f"nobody says: {words}" + (f" and {more} more words" if more > 0 else ""))


def made_of(reader: SoundReader, utterance: Utterance | None, language: str | None = None) -> Made:
    """Return what a batch tells of a sound, and of the words that are said in it."""
    if utterance is None:
        return Made(reader.duration)
    return Made(reader.duration, language or utterance.language, scored_take(reader.path, "", utterance).score)


def _beside(sounds: Sequence[Path], with_labels: bool) -> tuple[Mapping[Path, str], Mapping[Path, Path]]:
    """Return the texts, and labels with words, that lie beside sounds under their names; say where nothing does."""
    texts, labels = dict[Path, str](), dict[Path, Path]()
    for sound in sounds:
        if with_labels and (found := words_beside(sound)) is not None:
            labels[sound] = found
        elif (script := script_beside(sound)) is not None:
            texts[sound] = script.text
        else:
            names = f"{sound.stem}.TextGrid with words or {sound.stem}.txt" if with_labels else f"{sound.stem}.txt"
            say_note(printable_name(sound), f"there is no {names} beside it, so it is recognised without text")
    return texts, labels


def _texts_of(options: argparse.Namespace, sounds: Sequence[Path]) -> Mapping[Path, str]:
    if options.text is not None:
        return dict.fromkeys(sounds, options.text)
    texts, notes = load_script(options.script).texts_of(sounds)
    for note in notes:
        say_note(printable_name(options.script), note)
    return texts


def _labels_of(path: Path, sounds: Sequence[Path]) -> Path:
    if len(sounds) != 1:
        raise EngineError(f"{path.name}: it is of one sound, and there are {len(sounds)}; name that sound alone")
    return path
