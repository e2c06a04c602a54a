"""What is said in the sounds of a command, as its arguments say."""

import argparse
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from phonemeanalyser.cli.jobs import say_note
from phonemeengine import (
    EngineError,
    LabelledUtterance,
    Lexicon,
    ScriptWord,
    TextError,
    VoiceError,
    load_lexicon,
    words_of,
)
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.work import Say
from phonemeengine.conversion.spoken_texts import NO_TEXTS, SpokenTexts
from phonemeengine.storage.files import printable_name
from phonemeengine.text.espeak import languages
from phonemeengine.text.script import is_timed, load_script


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
    known = SpokenTexts(
        language=options.language, lexicon=lexicon, literal=options.literal, accepted=options.accept_text,
        speaker=options.speaker,
    )  # fmt: skip
    if options.speaker is not None and (options.script is None or not is_timed(options.script)):
        options.parser.error("--speaker goes with a --script that tells speakers apart: a .TextGrid or .json")
    if options.text is not None:
        return known.of_text(options.text, sounds)
    return known.of_script(options.script, sounds, say_note, with_labels=with_labels)


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
