"""Sounds that are opened to be analysed, and what is said in them, as far as it is known."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

from phonemeengine.alignment.align import is_other_text, scored_take
from phonemeengine.analyser import Analysis
from phonemeengine.audio.files import SoundReader
from phonemeengine.batch.work import Made, Say, fingerprint_of
from phonemeengine.conversion.options import ConversionOptions
from phonemeengine.errors import AudioError, EngineError, OptionError
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.key_layer import KeyLayer, keys_beside, read_keys
from phonemeengine.mouth.transcript import Script, Transcript, scripted_transcript_of, transcript_of
from phonemeengine.settings import Channel
from phonemeengine.storage.files import is_folder, printable, printable_name
from phonemeengine.text.lexicon import Lexicon, load_lexicon
from phonemeengine.text.pronunciation import notes_on, words_of
from phonemeengine.text.script import is_timed, load_script, script_beside, timed_script, words_beside

BESIDE = Path("auto")
"""Stands for the words or the text that lie beside each sound."""
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
    scripts : words, or all that is said with its times, by the sound's file; these go before labels.
    """

    texts: Mapping[Path, str] = field(default_factory=dict)
    labels: Mapping[Path, Path] = field(default_factory=dict)
    language: str | None = None
    lexicon: Lexicon | None = None
    literal: bool = False
    accepted: bool = False
    speaker: str | None = None
    scripts: Mapping[Path, Script] = field(default_factory=dict)

    @classmethod
    def of(
        cls, options: ConversionOptions, sounds: Sequence[Path], say: Say, *, with_labels: bool = True
    ) -> "SpokenTexts":
        """Return what options say of some sounds; sounds without a text are reported.

        Parameters
        ----------
        with_labels : whether the words and times of a TextGrid beside a sound go before a text.

        Raises
        ------
        EngineError : a script or the lexicon cannot be read, or says nothing about the sounds.
        """
        if options.speaker is not None and (options.script is None or not is_timed(options.script)):
            raise OptionError("--speaker goes with a --script that tells speakers apart: a .TextGrid or .json")
        lexicon = None if options.lexicon is None else load_lexicon(options.lexicon)
        if options.text_feeling is not None and options.text is None and options.script is None:
            raise OptionError("--text-feeling goes with --text or --script: give the text that is spoken")
        known = cls({}, {}, options.language, lexicon, options.literal, options.accept_text, options.speaker)
        if options.script is not None:
            return known.of_script(options.script, sounds, say, with_labels=with_labels)
        return NO_TEXTS if options.text is None else known.of_text(options.text, sounds)

    def of_text(self, text: str, sounds: Iterable[Path]) -> "SpokenTexts":
        """Return that a text is said in each of some sounds."""
        return replace(self, texts=dict.fromkeys(sounds, text))

    def of_script(self, script: Path, sounds: Sequence[Path], say: Say, *, with_labels: bool = True) -> "SpokenTexts":
        """Return what a script says of some sounds; sounds without a text are reported.

        Parameters
        ----------
        script : a file, or `BESIDE`.
        with_labels : whether the words and times of a TextGrid beside a sound go before a text.

        Raises
        ------
        EngineError : it cannot be read, or says nothing about the sounds.
        """
        if is_timed(script):
            if len(sounds) != 1:
                words = f"it is of one sound, and there are {len(sounds)}; name that sound alone"
                raise EngineError(f"{script.name}: {words}")
            return replace(self, labels={sounds[0]: script})
        if script == BESIDE:
            return self._beside(sounds, say, with_labels)
        texts, notes = load_script(script).texts_of(sounds)
        for note in notes:
            say(printable_name(script), note)
        return replace(self, texts=texts)

    def knows(self, sound: Path) -> bool:
        """Return whether it is known what is said in a sound."""
        return sound in self.scripts or sound in self.labels or sound in self.texts

    def known_of(self, sound: Path) -> str:
        """Return what tells whether something else is said in a sound than before."""
        if sound in self.scripts:
            return fingerprint_of(self.scripts[sound], self.accepted)
        if sound in self.labels:
            return fingerprint_of(self.labels[sound], self.language, self.lexicon, self.accepted, self.speaker)
        text = self.texts.get(sound)
        return fingerprint_of(text, self.language, self.lexicon, self.literal, self.accepted)

    def script_of(self, sound: Path, duration: float, say: Say) -> Script | None:
        """Return what is said in a sound of `duration` seconds, and report what of it is not; None where unknown.

        Raises
        ------
        EngineError : its text cannot be spoken, or its labels cannot be read.
        """
        if sound in self.scripts:
            return self.scripts[sound]
        if sound in self.labels:
            return timed_script(self.labels[sound], duration, self.language, self.lexicon, self.speaker)
        text = self.texts.get(sound)
        if text is None:
            return None
        words = words_of(text, self.language, self.lexicon, literal=self.literal)
        for note in notes_on(text, self.language, literal=self.literal):
            say(printable_name(sound), note)
        return words

    def text_of(self, sound: Path, utterance: Utterance | None) -> tuple[str, Utterance | None]:
        """Return what is said in a sound as it is written, and in the language that is known."""
        if utterance is None:
            return "", None
        text = self.texts.get(sound) or " ".join(word.text for word in utterance.words)
        return text, replace(utterance, language=self.language or utterance.language)

    def aligned(
        self, reader: SoundReader, sound: Path, analyses: Iterable[Analysis], say: Say, *, felt: bool = False
    ) -> tuple[Utterance, Transcript] | None:
        """Return what is said in an open sound, and say what does not fit its text.

        With `felt` the feeling in the voice is estimated, too.

        Where nothing is known of it, the answer is None, and no analysis is taken.

        Raises
        ------
        EngineError : its text cannot be spoken, or its labels cannot be read.
        """
        script = self.script_of(sound, reader.duration, say)
        if script is None:
            return None
        name, accepted = printable_name(sound), self.accepted
        found = scripted_transcript_of(
            analyses, script, name, reader.duration, sound, accept_text=accepted, felt=felt
        )
        say_misfits(name, found[0], say)
        return found

    def said(
        self, reader: SoundReader, sound: Path, analyses: Iterable[Analysis], say: Say, *, felt: bool = False
    ) -> tuple[Utterance | None, Transcript]:
        """Return what is said in an open sound, as `aligned` does; else what is recognised in it."""
        found = self.aligned(reader, sound, analyses, say, felt=felt)
        if found is not None:
            return found
        return None, transcript_of(analyses, printable_name(reader.path), reader.duration, reader.path, felt=felt)

    def _beside(self, sounds: Sequence[Path], say: Say, with_labels: bool) -> "SpokenTexts":
        """Return the texts, and labels with words, that lie beside sounds; say where nothing does."""
        texts, labels = dict[Path, str](), dict[Path, Path]()
        for sound in sounds:
            if with_labels and (found := words_beside(sound)) is not None:
                labels[sound] = found
            elif (script := script_beside(sound)) is not None:
                texts[sound] = script.text
            else:
                names = f"{sound.stem}.TextGrid with words or " if with_labels else ""
                nothing = f"there is no {names}{sound.stem}.txt beside it, so it is recognised without text"
                say(printable_name(sound), nothing)
        return replace(self, texts=texts, labels=labels)


NO_TEXTS: SpokenTexts = SpokenTexts()
"""Nothing is known of what is said."""


def edited_keys(path: Path | None, sounds: Sequence[Path]) -> dict[Path, KeyLayer]:
    """Return the keys that an animator edited, by the sound's file; a sound without such a file has none.

    Parameters
    ----------
    path : a file of keys of the only sound, `BESIDE` for those beside the sounds, or None for no keys.

    Raises
    ------
    EngineError : a file cannot be read, or there are several sounds for one.
    """
    if path is None:
        return {}
    if path == BESIDE:
        return {sound: read_keys(keys_beside(sound)) for sound in sounds if keys_beside(sound).is_file()}
    if len(sounds) != 1:
        raise EngineError(f"{path.name}: it has the keys of one sound, and there are {len(sounds)}; use --keys auto")
    return {sounds[0]: read_keys(path)}


@contextmanager
def open_sound(path: Path, channel: Channel, say: Say, longest: float = math.inf) -> Iterator[SoundReader]:
    """Open a sound to analyse one of its channels, and say what is odd about it.

    Raises
    ------
    AudioError : it cannot be read, or lacks the channel, or there is none, or it lasts longer than the limit.
    """
    name = printable_name(path)
    if is_folder(path):
        raise AudioError(f"{name}: there is no sound file in this folder; name another")
    with SoundReader(path, channel) as reader:
        if reader.duration > longest:
            lasts = f"it lasts {reader.duration:.0f} s, and at most {longest:g} s are taken"
            raise AudioError(f"{name}: {lasts}; cut it into shorter ones")
        for note in reader.notes:
            say(name, note)
        yield reader


def say_misfits(name: str, utterance: Utterance, say: Say) -> None:
    """Report words of a text that are not spoken, or that another text is."""
    if is_other_text(utterance):
        say(name, OTHER_TEXT)
    elif utterance.skipped:
        words = " ".join(printable(word) for word in utterance.skipped[:SHOWN_WORDS])
        more = len(utterance.skipped) - SHOWN_WORDS
        say(name, f"these words are not spoken: {words}" + (f" and {more} more words" if more > 0 else ""))


def made_of(reader: SoundReader, utterance: Utterance | None, language: str | None = None) -> Made:
    """Return what a batch tells of a sound, and of the words that are said in it."""
    if utterance is None:
        return Made(reader.duration)
    return Made(reader.duration, language or utterance.language, scored_take(reader.path, "", utterance).score)
