"""Scripts: the words that are said in sounds, in a file of their own, and the language that they are probably in.

A text file holds the words of one sound, or, for a folder, a table: in each line the name of a sound, a tab, and what
is said in it. Lines of the same sound follow each other in it.
"""

import os
import posixpath
import re
import tomllib
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, lru_cache
from pathlib import Path

from phonemeengine.errors import TextError
from phonemeengine.labels.timed_words import read_timed_words
from phonemeengine.labels.utterance import Utterance
from phonemeengine.labels.utterance_files import has_words, read_utterance, tells_sounds
from phonemeengine.storage.files import printable, printable_name, read_text_file
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.pronunciation import ScriptWord, timed_words_of

LARGEST = 64 << 20
"""Bytes of a script at most."""
_SHOWN = 5
_AUDACITY = re.compile(r"\s*\d+([.,]\d+)?\t\d+([.,]\d+)?\t")


@dataclass(frozen=True)
class Script:
    """What is said in sounds.

    Attributes
    ----------
    name : of its file, for people.
    text : what is said in the one sound; empty where there is a table.
    texts : by the name of a sound, as the table has it.
    """

    name: str
    text: str = ""
    texts: Mapping[str, str] = field(default_factory=dict)

    def texts_of(self, sounds: Sequence[Path]) -> tuple[dict[Path, str], tuple[str, ...]]:
        """Return what is said in each sound, and remarks on sounds without text, and texts without sound.

        A sound is found by its path, its name, or its name without ending.

        Raises
        ------
        TextError : not one sound has a text, or there are several and the script is of one.
        """
        if not self.texts:
            return self._only(sounds), ()
        keys = {sound: self._key_of(sound) for sound in sounds}
        texts = {sound: self.texts[key] for sound, key in keys.items() if key is not None}
        if not texts:
            raise TextError(
                f"{self.name}: there is no text in it for {_listed(sound.name for sound in sounds)}; a line holds "
                "the name of a sound, a tab and its words"
            )
        unsaid = [sound.name for sound in sounds if keys[sound] is None]
        soundless = [key for key in self.texts if key not in keys.values()]
        notes = [f"there is no text for {_listed(unsaid)}; add a line for each"] if unsaid else []
        notes += [f"there is no sound {_listed(soundless)}; name them as the sounds are"] if soundless else []
        return texts, tuple(notes)

    def _only(self, sounds: Sequence[Path]) -> dict[Path, str]:
        if len(sounds) != 1:
            raise TextError(
                f"{self.name}: it holds the words of one sound, and there are {len(sounds)}; write a table with the "
                "name of a sound, a tab and its words in each line"
            )
        return {sounds[0]: self.text}

    def _key_of(self, sound: Path) -> str | None:
        parts = posixpath.normpath(sound.as_posix()).split("/")
        ends = ["/".join(parts[-k:]) for k in range(len(parts), 0, -1)]
        candidates = (*ends, *(end.removesuffix(sound.suffix) for end in ends))
        return next((name for name in candidates if name in self.texts), None)


def load_script(path: str | os.PathLike[str]) -> Script:
    """Load a script: the words of one sound, or a table.

    Raises
    ------
    TextError : it cannot be read, or is empty, or only some of its lines are a table's.
    """
    path = Path(path)
    name, text = printable_name(path), read_text_file(path, LARGEST, "a script", TextError)
    lines = [(number, line) for number, line in enumerate(text.split("\n"), 1) if line.strip()]
    if not lines:
        raise TextError(f"{name}: there is no word in it; write what is said")
    odd = next((number for number, line in lines if "\t" not in line), None)
    if odd == lines[0][0]:
        return Script(name, text)
    if odd is not None:
        raise TextError(f"{name}, line {odd}: a table has the name of a sound, a tab and its words; add the tab")
    texts: dict[str, list[str]] = {}
    for _, line in lines:
        sound, _, words = line.partition("\t")
        texts.setdefault(_name_in_table(sound), []).append(words.replace("\t", " ").strip())
    return Script(name, "", {sound: "\n".join(words) for sound, words in texts.items()})


def words_beside(sound: Path) -> Path | None:
    """Return ``x.TextGrid`` beside a sound ``x.wav``, as the window saves it; None where it has no words.

    Raises
    ------
    CorpusError : it cannot be read.
    """
    path = sound.with_suffix(".TextGrid")
    return path if path.is_file() and has_words(path) else None


def script_beside(sound: Path) -> Script | None:
    """Return the script ``x.txt``, or ``x.docx``, beside a sound ``x.wav``; None where there is none.

    Labels of Audacity are none.

    Raises
    ------
    TextError : it cannot be read, or is empty.
    """
    path = next((path for ending in (".txt", ".docx") if (path := sound.with_suffix(ending)).is_file()), None)
    if path is None:
        return None
    text = read_text_file(path, LARGEST, "a script", TextError)
    if _AUDACITY.match(text):
        return None
    if not text.strip():
        raise TextError(f"{printable_name(path)}: there is no word in it; write what is said")
    return Script(printable_name(path), text)


def _name_in_table(sound: str) -> str:
    """Return the name of a sound as a table has it, without what leads nowhere, such as ``./``."""
    return posixpath.normpath(sound.strip().strip('"').replace("\\", "/"))


def is_timed(script: Path) -> bool:
    """Return whether a script, by its ending, tells when its words are said."""
    return script.suffix.lower() in {".textgrid", ".json"}


def timed_script(
    path: str | os.PathLike[str],
    duration: float,
    language: str | None = None,
    lexicon: Lexicon | None = None,
    speaker: str | None = None,
) -> Utterance | tuple[ScriptWord, ...]:
    """Return what a file with times says of a sound: all of it, or its words, whose phones are still to be found.

    Parameters
    ----------
    path : a TextGrid, or JSON; see `read_utterance` and `read_timed_words`.
    duration : of the sound, seconds.
    language : of the words; of no use where the file has phones.
    lexicon : pronunciations that go before the language's voice.
    speaker : whose words, where the file tells speakers apart.

    Raises
    ------
    CorpusError : it cannot be read, or says something impossible.
    TextError : its words need a language that is not given, or cannot be spoken.
    """
    path = Path(path)
    if path.suffix.lower() != ".json" and tells_sounds(path, speaker):
        return replace(read_utterance(path, duration, speaker=speaker), language=language or "")
    words = read_timed_words(path, duration, speaker)
    if language is None:
        raise TextError(f"{printable_name(path)}: it has words without phones; name their language")
    return timed_words_of(words, language, lexicon)


def _listed(names: Iterable[str]) -> str:
    shown = [printable(name) for name in names]
    more = f" and {len(shown) - _SHOWN} more" if len(shown) > _SHOWN else ""
    return ", ".join(shown[:_SHOWN]) + more


SCRIPTS = {
    "ja": r"[\u3040-\u30ff]",
    "ko": r"[\uac00-\ud7af]",
    "cmn": r"[\u3400-\u9fff]",
    "el": r"[\u0370-\u03ff]",
    "he": r"[\u0590-\u05ff]",
    "ar": r"[\u0600-\u06ff]",
    "hi": r"[\u0900-\u097f]",
    "th": r"[\u0e00-\u0e7f]",
    "uk": r"[іїєґІЇЄҐ]",
    "ru": r"[\u0400-\u04ff]",
}
"""Letters that tell a language, in the order in which they are looked for: Japanese has Chinese characters, too."""
LOOKED_AT = 4000
"""Characters of a text that are looked at."""
LEAST_WORDS, LEAST_LEAD = 2, 1.25
"""Different frequent words that a language needs, and how many times as many as the next language has."""


def guess_language(text: str) -> str:
    """Return the tag of the language that a text is probably written in; empty where nothing tells it.

    A guess is shown to the user before it is used: languages as near as Danish and Norwegian are not told apart, and
    short texts tell nothing.
    """
    return _guessed(text[:LOOKED_AT])


@lru_cache(1)  # at each key that is pressed, most often behind what is looked at
def _guessed(part: str) -> str:
    words = Counter(re.findall(r"[^\W\d_]+", part.lower()))
    n_letters = sum(n * len(word) for word, n in words.items())
    for tag, letters in () if part.isascii() else SCRIPTS.items():
        if 5 * len(re.findall(letters, part)) > n_letters:
            return tag
    found = {tag: [words[word] for word in frequent if word in words] for tag, frequent in _frequent().items()}
    counts = Counter({tag: sum(each) for tag, each in found.items() if len(each) >= LEAST_WORDS})
    if not counts:
        return ""
    (best, most), *others = counts.most_common(2)
    return best if not others or most >= LEAST_LEAD * others[0][1] else ""


@cache
def _frequent() -> dict[str, frozenset[str]]:
    path = Path(__file__).with_name("language_words.toml")
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    return {tag: frozenset(words.split()) for tag, words in table["words"].items()}
