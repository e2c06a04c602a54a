"""Words with times from other programs: a TextGrid with a tier of words, or JSON of a recogniser or a voice."""

import json
import math
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any

from phonemeengine.errors import CorpusError
from phonemeengine.labels.files import TIER_NAMES
from phonemeengine.labels.phone_sets import marks_silence
from phonemeengine.labels.table import read_text
from phonemeengine.labels.textgrid import Tier, tiers_of
from phonemeengine.labels.utterance import in_order
from phonemeengine.storage.files import printable_name

WORD_TIER = "word"
"""What the names of tiers of words begin with, in small letters."""
SYLLABLE_TIER = "syll"
SHORTEST = 0.02
"""Seconds; a shorter word counts as one without a time, as numbers of WhisperX and some words of Whisper are."""
_SHOWN = 8


@dataclass(frozen=True)
class TimedWord:
    """A word as another program wrote it.

    Attributes
    ----------
    start, end : seconds.
    text : with the punctuation around it.
    """

    start: float
    end: float
    text: str


@dataclass(frozen=True)
class _Layout:
    """Where the words are in the JSON of a program.

    Attributes
    ----------
    path : keys and numbers from the top down; ``*`` stands for each entry of a list.
    text, start : the keys of a word's text, and of its beginning.
    end, length : the key of its end, or of its duration.
    unit : seconds of one unit of time.
    """

    path: str
    text: str
    start: str
    end: str = ""
    length: str = ""
    unit: float = 1.0


_TICK, _MILLISECOND = 1e-7, 1e-3
_LAYOUTS = (
    _Layout("segments/*/words/*", "word", "start", end="end"),  # Whisper, WhisperX
    _Layout("*/words/*", "word", "start", end="end"),  # segments of faster-whisper
    _Layout("word_segments/*", "word", "start", end="end"),  # WhisperX
    _Layout("words/*", "word", "start", end="end"),  # OpenAI's transcriptions
    _Layout("words/*", "text", "start", end="end"),  # ElevenLabs: transcriptions and forced alignment
    _Layout("NBest/0/Words/*", "Word", "Offset", length="Duration", unit=_TICK),  # Azure: a phrase
    _Layout("*/NBest/0/Words/*", "Word", "Offset", length="Duration", unit=_TICK),  # Azure: phrases
    _Layout("recognizedPhrases/*/nBest/0/words/*", "word", "offsetInTicks", length="durationInTicks", unit=_TICK),
    _Layout("phrases/*/words/*", "text", "offsetMilliseconds", length="durationMilliseconds", unit=_MILLISECOND),
    _Layout("*", "Text", "AudioOffset", length="Duration", unit=_MILLISECOND),  # Azure: words of a synthesis
)
_ALIGNMENTS = ("alignment", "normalized_alignment")
"""Where ElevenLabs tells the times of the characters that it spoke."""
_CHARACTERS = ("characters", "character_start_times_seconds", "character_end_times_seconds")
_SPEAKERS = ("speaker", "speaker_id")
_SPOKEN = r"[\u3040-\u30ff\u3400-\u9fff][^\w\s]*|[^\s\u3040-\u30ff\u3400-\u9fff]+"
"""A word between spaces; in languages that write none, a character and the marks behind it."""
_KINDS = "|".join((*TIER_NAMES, WORD_TIER, SYLLABLE_TIER))
_OF_SPEAKER = rf"(?i)(?P<speaker>.*\S)\s*-\s*(?P<kind>(?:{_KINDS}).*)"


@dataclass(frozen=True)
class _WordEntry:
    """A word of a document; NaN where it has no time."""

    start: float
    end: float
    text: str
    speaker: str


def read_timed_words(
    path: str | os.PathLike[str], duration: float, speaker: str | None = None
) -> tuple[TimedWord, ...]:
    """Return the words of a file and when they are said.

    Words that have no time, or hardly any, share the gap between their neighbours, or the time of the word before.

    Parameters
    ----------
    path : a TextGrid with a tier of words; or JSON with times of words of Whisper, faster-whisper, WhisperX,
        ElevenLabs (speech with timestamps, transcriptions, forced alignment) or Azure (recognition, transcription,
        word boundaries of a synthesis).
    duration : of the sound, seconds.
    speaker : whose words, where the file tells speakers apart.

    Raises
    ------
    CorpusError : it cannot be read, has no words with times, is of another sound, or has several speakers and none of
        them was chosen.
    """
    path = Path(path)
    name = printable_name(path)
    if path.suffix.lower() == ".json":
        said = _words_of_speaker(_words_in(_document_in(path, name)), speaker, name)
    else:
        tiers = tiers_of_speaker(tiers_of(read_text(path), name), speaker, name)
        tier = next((t for t in tiers if t.name.lower().startswith(WORD_TIER) and t.raw_labels), None)
        labels = in_order(tier.raw_labels if tier else (), name)
        said = [TimedWord(raw.start, raw.end, raw.name) for raw in labels if not marks_silence(raw.name)]
    timed = _timed(said)
    if not timed:
        raise CorpusError(
            f"{name}: there is no word with a time in it; it must be a TextGrid with a tier named words, or JSON of "
            "Whisper, WhisperX, ElevenLabs or Azure that was made with times of words"
        )
    return tuple(_within(timed, duration, name))


def speakers_in(path: str | os.PathLike[str]) -> tuple[str, ...]:
    """Return the speakers whom a TextGrid or JSON tells apart, in order; see `read_timed_words`.

    Raises
    ------
    CorpusError : it cannot be read.
    """
    path = Path(path)
    name = printable_name(path)
    if path.suffix.lower() == ".json":
        names = [entry.speaker for entry in _words_in(_document_in(path, name))]
    else:
        found = (re.fullmatch(_OF_SPEAKER, tier.name) for tier in tiers_of(read_text(path), name))
        names = [tier["speaker"] for tier in found if tier]
    return tuple(dict.fromkeys(name for name in names if name))


def tiers_of_speaker(tiers: Sequence[Tier], speaker: str | None, file: str) -> tuple[Tier, ...]:
    """Return the tiers of one speaker, without the name before them; all tiers where they name no speaker.

    Aligners call the tiers of several speakers ``mary - words``, ``mary - phones`` and so on.

    Raises
    ------
    CorpusError : there are several speakers, and none or another one was chosen.
    """
    owned: dict[str, list[Tier]] = {}
    for tier in tiers:
        if found := re.fullmatch(_OF_SPEAKER, tier.name):
            owned.setdefault(found["speaker"], []).append(replace(tier, name=found["kind"]))
    if not owned and speaker is None:
        return tuple(tiers)
    return tuple(owned[_chosen_speaker(owned, speaker, file)])


def _chosen_speaker(known: Mapping[str, object], speaker: str | None, file: str) -> str:
    if speaker is None and len(known) == 1:
        return next(iter(known))
    if speaker in known:
        return str(speaker)
    names = ", ".join(repr(name) for name in [*known][:_SHOWN]) or "none"
    asked = "choose one as the speaker" if speaker is None else f"there is no {speaker!r:.60}"
    raise CorpusError(f"{file}: it tells {len(known)} speakers apart, {names}; {asked}")


def _document_in(path: Path, name: str) -> Any:
    try:
        return json.loads(read_text(path))
    except (ValueError, RecursionError) as error:
        raise CorpusError(f"{name}: this is no JSON ({error!s:.80}); export the words again") from error


def _words_in(document: Any) -> list[_WordEntry]:
    """Return the words of a document, by the first layout that finds some."""
    for key in _ALIGNMENTS:
        alignment = document.get(key) if isinstance(document, dict) else None
        if isinstance(alignment, dict) and (found := list(_words_of_characters(alignment))):
            return found
    for layout in _LAYOUTS:
        entries = [_entry_of(entry, who, layout) for entry, who in _entries_at(document, layout.path.split("/"), "")]
        if found := [entry for entry in entries if entry is not None]:
            return found
    return []


def _entries_at(part: Any, path: Sequence[str], speaker: str) -> Iterator[tuple[dict[str, Any], str]]:
    """Return the objects at a path, each with its speaker, who may be named further up."""
    if isinstance(part, dict):
        speaker = next((str(part[key]) for key in _SPEAKERS if isinstance(part.get(key), str | int)), speaker)
        if not path:
            yield part, speaker
        elif path[0] in part:
            yield from _entries_at(part[path[0]], path[1:], speaker)
    elif isinstance(part, list) and path:
        of_path = part if path[0] == "*" else part[: int(path[0]) + 1] if path[0].isdigit() else []
        for entry in of_path:
            yield from _entries_at(entry, path[1:], speaker)


def _entry_of(entry: Mapping[str, Any], speaker: str, layout: _Layout) -> _WordEntry | None:
    text = entry.get(layout.text)
    if not isinstance(text, str) or entry.get("type") == "audio_event":
        return None
    start = _number(entry.get(layout.start)) * layout.unit
    end = _number(entry.get(layout.end or layout.length)) * layout.unit
    return _WordEntry(start, end if layout.end else start + end, text.strip(), speaker)


def _words_of_characters(alignment: Mapping[str, Any]) -> Iterator[_WordEntry]:
    """Return the words between the spaces of characters with times."""
    columns = [alignment.get(key) for key in _CHARACTERS]
    lists = [column for column in columns if isinstance(column, list)]
    if len(lists) != len(columns) or len({len(column) for column in lists}) != 1:
        return
    characters = [str(character) for character in lists[0]]
    number_of = [k for k, character in enumerate(characters) for _ in character]
    for found in re.finditer(_SPOKEN, "".join(characters)):
        first, last = number_of[found.start()], number_of[found.end() - 1]
        yield _WordEntry(_number(lists[1][first]), _number(lists[2][last]), found.group(), "")


def _number(value: Any) -> float:
    """Return a time; NaN where there is none."""
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else math.nan


def _words_of_speaker(entries: Sequence[_WordEntry], speaker: str | None, name: str) -> list[TimedWord]:
    known = {entry.speaker: None for entry in entries if entry.speaker}
    who = _chosen_speaker(known, speaker, name) if known or speaker is not None else ""
    return [TimedWord(e.start, e.end, e.text) for e in entries if e.text and e.speaker in {"", who}]


def _timed(words: Sequence[TimedWord]) -> list[TimedWord]:
    """Return words in order of time, all with times; see `read_timed_words`."""
    timed: list[TimedWord] = []
    waiting: list[str] = []
    for word in words:
        if not word.end - word.start >= SHORTEST:  # so that NaN counts as no time
            waiting.append(word.text)
            continue
        _share_gap(timed, waiting, word.start)
        waiting.clear()
        timed.append(word)
    _share_gap(timed, waiting, math.inf)
    ordered = sorted(timed, key=lambda word: word.start)
    ends = [min(word.end, following.start) for word, following in pairwise(ordered)]
    cut = [replace(word, end=end) for word, end in zip(ordered, [*ends, *(w.end for w in ordered[-1:])], strict=True)]
    return [word for word in cut if word.end - word.start >= SHORTEST]


def _share_gap(timed: list[TimedWord], texts: Sequence[str], until: float) -> None:
    """Append words without times, which lie between the last word and a time, or belong to the last word."""
    if not texts:
        return
    start = timed[-1].end if timed else 0.0
    share = (until - start) / len(texts)
    if math.isfinite(share) and share >= SHORTEST:
        timed += [TimedWord(start + k * share, start + (k + 1) * share, text) for k, text in enumerate(texts)]
    elif timed:
        timed[-1] = replace(timed[-1], text=" ".join([timed[-1].text, *texts]))


def _within(words: Sequence[TimedWord], duration: float, name: str) -> Iterator[TimedWord]:
    """Return words that end within the sound; recognisers let the last one end a little after it."""
    for word in words:
        if word.start < 0 or word.start >= duration:
            raise CorpusError(
                f"{name}: the word {word.text!r:.40} begins at {word.start:g} s, but the sound lasts "
                f"{duration:.3f} s; check whether the words belong to this sound"
            )
        yield replace(word, end=min(word.end, duration))
