"""Voices and pronunciations by espeak-ng: the only module that loads its library.

The library is one global object that the whole process shares: it is loaded when it is first asked for something, and
a lock lets one thread in at a time. It ends a text at a NUL, obeys control characters, and reads ``[[`` as phonemes
where its input says so, so only what `cleaning.speakable` let through may come here.
"""

import ctypes
import ctypes.util
import hashlib
import os
import re
import shutil
import sys
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine.arrays import Int16Array
from phonemeengine.errors import TextError, VoiceError
from phonemeengine.labels.phone_sets import split_ipa
from phonemeengine.storage.files import printable_name, reason_of
from phonemeengine.storage.paths import cache_folder

VOICE_RATE = 22_050
"""Samples a second of all its voices."""
NORMAL_RATE, SLOWEST, FASTEST = 175, 80, 450
"""Words a minute: what the library speaks unless told otherwise, and its limits."""
LONGEST_PATH = 159
"""Bytes that the path of its data may have; beyond, it does not find them."""
SEPARATOR = "_"
"""Stands between the names of phones in `phone_names`."""

_SYNCHRONOUS = 2
_PHONEME_EVENTS, _IN_IPA, _DO_NOT_EXIT = 0x1, 0x2, 0x8000
_UTF8, _PHONEME_INPUT = 0x1, 0x100
_RATE_PARAMETER = 1
_WORD_EVENT, _PHONEME_EVENT = 1, 7
_REMARK = re.compile(r"\([^)]*\)|[^\w?\u0300-\u036f]|[\d_]")
"""In names of phones: languages such as ``(en)``, tones, and marks that tell variants apart."""
_OF_OTHER_ALPHABETS = str.maketrans(
    {"S": "ʃ", "Z": "ʒ", "N": "ŋ", "X": "χ", "A": "a", "K": "k", "?": "ʔ", "ε": "ɛ", "Φ": "ɸ"}
)
"""What some voices write beside IPA."""
_MISNAMED = {"ru": str.maketrans({"y": "ɨ"})}
"""What voices call otherwise than IPA does, by the first part of their tag: Russian ы is not rounded."""
_NO_LIBRARY = (
    "no voice is installed: espeak-ng is missing; pip install 'phonemeanalyser[speech]', or install libespeak-ng1 of "
    "your system"
)


class EventKind(Enum):
    """What an event tells the beginning of."""

    WORD = _WORD_EVENT
    PHONE = _PHONEME_EVENT


@dataclass(frozen=True)
class Event:
    """When something begins in the sound.

    Attributes
    ----------
    kind : a word, or a phone.
    sample : of the sound since the text began, at `VOICE_RATE`.
    position : the character of the text that is said, from 0.
    name : of a phone, in IPA, cut to 8 bytes; empty at pauses and words.
    """

    kind: EventKind
    sample: int
    position: int
    name: str


TakeSound = Callable[[Int16Array, tuple[Event, ...]], bool]
"""Takes the next samples, mono at `VOICE_RATE`, and what begins in them; returns whether to go on."""


@dataclass(frozen=True)
class Language:
    """A language that can be spoken.

    Attributes
    ----------
    tag : what it is asked for by, such as ``en-us``.
    name : in English, for people.
    identifier : the library's own name of the voice.
    """

    tag: str
    name: str
    identifier: str


@dataclass(frozen=True)
class Installation:
    """Where the library lies, and its data; None where it finds these itself."""

    library: str
    data: Path | None = None


def bundled() -> Installation | None:
    """Return the library that the package espeakng-loader brings; None where that is not installed."""
    try:
        import espeakng_loader  # noqa: PLC0415 - an extra, which only who speaks needs
    except ImportError:
        return None
    return Installation(str(espeakng_loader.get_library_path()), Path(espeakng_loader.get_data_path()))


def installation(
    bundled: Callable[[], Installation | None] = bundled, find: Callable[[str], str | None] = ctypes.util.find_library
) -> Installation:
    """Return where the library is: in the package espeakng-loader, or else in the system.

    Parameters
    ----------
    bundled : finds that of the package.
    find : finds a library of the system by name.

    Raises
    ------
    VoiceError : it is nowhere.
    """
    if found := bundled():
        return found
    library = find("espeak-ng") or find("libespeak-ng")
    if library is None:
        raise VoiceError(_NO_LIBRARY)
    return Installation(library)


def short_path(data: Path, cache: Path) -> Path:
    """Return a path to the data that the library can read: their own, or that of a link or a copy in `cache`.

    Raises
    ------
    VoiceError : neither can be made, or the cache's path is too long as well.
    """
    if _n_bytes(data) <= LONGEST_PATH:
        return data
    short = cache / f"espeak-{hashlib.sha256(os.fsencode(data)).hexdigest()[:8]}"
    if _n_bytes(short) > LONGEST_PATH:
        raise VoiceError(
            f"espeak-ng reads its data from paths of at most {LONGEST_PATH} bytes, and both {data} and {short} are "
            "longer; install the program in a folder with a shorter path"
        )
    try:
        cache.mkdir(parents=True, exist_ok=True)
        _link_or_copy(data, short)
    except (OSError, ValueError) as error:
        raise VoiceError(
            f"{printable_name(short)}: espeak-ng's data cannot be placed there ({reason_of(error)}); install the "
            "program in a folder with a shorter path"
        ) from error
    return short


def languages() -> tuple[Language, ...]:
    """Return the languages that can be spoken, by tag.

    Raises
    ------
    VoiceError : the library is missing or broken.
    """
    return tuple(_library().languages[tag] for tag in sorted(_library().languages))


def voices() -> tuple[str, ...]:
    """Return the names of voices that speak every language, such as ``f3``; see `languages`."""
    return _library().variants


def language_of(tag: str | None) -> Language:
    """Return a language by its tag, however its letters are written.

    Raises
    ------
    TextError : there is none, or none was named.
    VoiceError : the library is missing or broken.
    """
    known = _library().languages
    some = ", ".join(name for name in ("en-us", "en-gb", "de", "fr", "es", "it", "ru", "ja", "cmn") if name in known)
    if not tag:
        raise TextError(f"the language of a text is not guessed; name it with --language, such as {some}")
    if tag.lower() not in known:
        raise TextError(f"no voice speaks the language {tag!r:.40}; choose one of {some} ({len(known)} are known)")
    return known[tag.lower()]


def check_voice(name: str) -> None:
    """Refuse the name of a voice that is not among `voices`; an empty one is the language's own.

    Raises
    ------
    VoiceError : there is no such voice, or the library is missing or broken.
    """
    known = voices()
    if name and name not in known:
        raise VoiceError(
            f"there is no voice {name!r:.40}; choose one such as f2, f5, m3, m7 or klatt, of {len(known)}"
        )


def phone_names(text: str, language: Language) -> str:
    """Return how a text is pronounced: words between spaces, in each names of phones between `SEPARATOR`.

    Parameters
    ----------
    text : cleaned.
    language : of the text.
    """
    library = _library()
    with library.lock:
        library.choose(language.identifier)
        return " ".join(library.translated(text, phonemes=False))


def names_sounded(names: str, language: Language) -> str:
    """Return how the library's own names of phonemes are pronounced as a word, like `phone_names`.

    Parameters
    ----------
    names : the library's, such as ``S'2:n``.
    language : whose names they are.
    """
    library = _library()
    with library.lock:
        library.choose(language.identifier)
        return " ".join(library.translated(f"[[{names}]]", phonemes=True))


def symbols_of(name: str) -> tuple[str, ...]:
    """Return the symbols of IPA that one of the library's names of phones stands for; none for a pause."""
    return split_ipa(_REMARK.sub("", name).translate(_OF_OTHER_ALPHABETS))


def stress_of(name: str) -> int:
    """Return how a phone is stressed: 0 not, 1 mainly, 2 secondarily."""
    return 1 if "ˈ" in name else 2 if "ˌ" in name else 0


def synthesise(
    text: str,
    language: Language,
    take: TakeSound,
    *,
    voice: str = "",
    rate: int = NORMAL_RATE,
    phonemes: bool = False,
) -> None:
    """Speak a text, alike each time; every event comes with the samples that it begins in.

    Parameters
    ----------
    text : cleaned.
    language : of the text.
    take : takes the sound, a few hundredths of a second at a time.
    voice : one of `voices`; the language's own where it is empty.
    rate : words a minute, 80..450.
    phonemes : ``[[...]]`` in the text holds the library's names of phonemes.

    Raises
    ------
    VoiceError : there is no such voice, or the library fails.
    """
    check_voice(voice)
    library = _library()
    with library.lock:
        library.begin_anew()
        library.choose(f"{language.identifier}+{voice}" if voice else language.identifier)
        library.speak(text, take, rate, phonemes=phonemes)


class _VoiceEntry(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p),
        ("languages", ctypes.c_void_p),
        ("identifier", ctypes.c_char_p),
        ("gender", ctypes.c_ubyte),
        ("age", ctypes.c_ubyte),
        ("variant", ctypes.c_ubyte),
        ("reserved", ctypes.c_ubyte),
        ("score", ctypes.c_int),
        ("spare", ctypes.c_void_p),
    )


class _EventEntry(ctypes.Structure):
    _fields_ = (
        ("kind", ctypes.c_int),
        ("unique_identifier", ctypes.c_uint),
        ("position", ctypes.c_int),
        ("length", ctypes.c_int),
        ("milliseconds", ctypes.c_int),
        ("sample", ctypes.c_int),
        ("user_data", ctypes.c_void_p),
        ("name", ctypes.c_char * 8),
    )


_Callback = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_short), ctypes.c_int, ctypes.POINTER(_EventEntry))


class _Library:
    """The library, loaded and initialised.

    Attributes
    ----------
    lock : held while a voice is chosen and speaks.
    languages : by tag.
    variants : names of voices for all languages.
    """

    def __init__(self, installed: Installation) -> None:
        self.lock = threading.RLock()
        self._path = installed.library
        self._data = None if installed.data is None else os.fsencode(short_path(installed.data, cache_folder()))
        self._names: dict[int, str] = {}
        self._library: Any = None
        self._open()
        self.languages = self._languages()
        self.variants = tuple(sorted(v.identifier.decode()[3:] for v in self._voices("variant")))

    def begin_anew(self) -> None:
        """Forget what was spoken: the library counts on in the flutter of its pitch, even if it is initialised again.

        So it is loaded again, which takes half a millisecond; where a system keeps it, it counts on.
        """
        self._library.espeak_Terminate()
        handle, self._library = self._library._handle, None
        _unload(handle)
        try:
            self._open()
        except VoiceError:
            _library.cache_clear()
            raise

    def _open(self) -> None:
        library = _loaded(self._path)
        # Without the data, the library would end the process unless its flags forbid that.
        options = _PHONEME_EVENTS | _IN_IPA | _DO_NOT_EXIT
        if library.espeak_Initialize(_SYNCHRONOUS, 0, self._data, options) != VOICE_RATE:
            raise VoiceError(f"espeak-ng does not find its data; install it again: {_NO_LIBRARY.partition('; ')[2]}")
        library.espeak_TextToPhonemes.restype = ctypes.c_char_p
        library.espeak_Info.restype = ctypes.c_char_p
        library.espeak_ListVoices.restype = ctypes.POINTER(ctypes.POINTER(_VoiceEntry))
        if hasattr(library, "espeak_ng_SetRandSeed"):  # from 1.52 on; of breath, whose seed is the time otherwise
            library.espeak_ng_SetRandSeed(ctypes.c_long(1))
        self._library = library
        self._chosen, self._reads_phonemes = "", False

    def choose(self, identifier: str) -> None:
        """Speak with a voice from now on."""
        if identifier == self._chosen:
            return
        if self._library.espeak_SetVoiceByName(identifier.encode()) != 0:
            self._chosen = ""
            raise VoiceError(f"espeak-ng cannot load its voice {identifier!r}; install espeak-ng again")
        self._chosen = identifier
        tag = identifier.partition("+")[0].rpartition("/")[2]
        self._names = _MISNAMED.get(tag.partition("-")[0], {})

    def translated(self, text: str, *, phonemes: bool) -> Iterator[str]:
        """Return the names of the phones of a text, clause by clause."""
        if phonemes is not self._reads_phonemes:  # a setting that needs something to speak
            self.speak("", lambda _samples, _events: True, NORMAL_RATE, phonemes=phonemes)
        content = ctypes.create_string_buffer(text.encode())
        rest = ctypes.c_void_p(ctypes.addressof(content))
        mode = _IN_IPA | ord(SEPARATOR) << 8
        while rest.value is not None:
            names = self._library.espeak_TextToPhonemes(ctypes.byref(rest), _UTF8, mode)
            yield names.decode().translate(self._names) if names else ""

    def speak(self, text: str, take: TakeSound, rate: int, *, phonemes: bool) -> None:
        """Have `take` take the sound of a text; what it raises is raised here."""
        failures: list[BaseException] = []

        def receive(samples: Any, n: int, events: Any) -> int:
            try:
                return 0 if take(_copied(samples, n), tuple(_events(events, self._names))) else 1
            except BaseException as error:  # noqa: BLE001 - it must not be lost in the library
                failures.append(error)
                return 1

        callback, content = _Callback(receive), text.encode()
        self._reads_phonemes = phonemes
        self._library.espeak_SetParameter(_RATE_PARAMETER, min(max(rate, SLOWEST), FASTEST), 0)
        self._library.espeak_SetSynthCallback(callback)
        flags = _UTF8 | (_PHONEME_INPUT if phonemes else 0)
        failed = self._library.espeak_Synth(content, len(content) + 1, 0, 1, 0, flags, None, None)
        if failures:
            raise failures[0]
        if failed:
            raise VoiceError(f"espeak-ng cannot speak this text (its error {failed}); write it otherwise")

    def _languages(self) -> dict[str, Language]:
        best: dict[str, tuple[int, Language]] = {}
        for voice in self._voices(""):
            identifier, name = voice.identifier.decode(), voice.name.decode().strip()
            tags = tuple(_tags(voice.languages))
            if not self._has_dictionary({tag for _, tag in tags}):
                continue
            for priority, tag in tags:
                if tag not in best or priority < best[tag][0]:
                    best[tag] = (priority, Language(tag, name, identifier))
        return {tag: language for tag, (_, language) in best.items()}

    def _has_dictionary(self, tags: set[str]) -> bool:
        """Return whether a voice of some languages has words: a few come without, and cannot speak."""
        path = ctypes.c_char_p()
        self._library.espeak_Info(ctypes.byref(path))
        folder = Path(os.fsdecode(path.value or b""))
        return any((folder / f"{tag.partition('-')[0]}_dict").exists() for tag in tags)

    def _voices(self, kind: str) -> Iterator[_VoiceEntry]:
        wanted = _VoiceEntry(languages=ctypes.cast(ctypes.c_char_p(kind.encode()), ctypes.c_void_p)) if kind else None
        found = self._library.espeak_ListVoices(ctypes.byref(wanted) if wanted else None)
        k = 0
        while found[k]:
            yield found[k].contents
            k += 1


@cache
def _library() -> _Library:
    with _loading:
        return _Library(installation())


_loading = threading.RLock()


def _loaded(path: str) -> Any:
    try:
        return ctypes.CDLL(path)
    except OSError as error:
        raise VoiceError(f"espeak-ng cannot be loaded ({error}); install it again") from error


def _unload(handle: int) -> None:
    if sys.platform == "win32":
        ctypes.WinDLL("kernel32").FreeLibrary(ctypes.c_void_p(handle))
    else:
        ctypes.CDLL(None).dlclose(ctypes.c_void_p(handle))


def _n_bytes(path: Path) -> int:
    return len(os.fsencode(path))


def _link_or_copy(data: Path, short: Path) -> None:
    """Make the data reachable at a short path, unless they are; another process may do so at the same time."""
    if short.exists():
        return
    part = short.with_name(f"{short.name}.{os.urandom(4).hex()}")
    try:
        part.symlink_to(data, target_is_directory=True)
    except OSError:  # as on Windows, where links need a right
        shutil.copytree(data, part)
    part.replace(short)


def _tags(content: int) -> Iterator[tuple[int, str]]:
    """Return the languages of a voice, each with its priority: a byte and a text, until a byte is 0."""
    while priority := ctypes.string_at(content, 1)[0]:
        tag = ctypes.string_at(content + 1)
        yield priority, tag.decode().lower()
        content += 2 + len(tag)


def _copied(samples: Any, n: int) -> Int16Array:
    return np.ctypeslib.as_array(samples, (n,)).copy() if n > 0 else np.zeros(0, np.int16)


def _events(events: Any, names: dict[int, str]) -> Iterator[Event]:
    k = 0
    while (event := events[k]).kind:
        if event.kind in {_WORD_EVENT, _PHONEME_EVENT}:
            name = event.name.decode(errors="ignore").translate(names) if event.kind == _PHONEME_EVENT else ""
            yield Event(EventKind(event.kind), event.sample, event.position - 1, name)
        k += 1
