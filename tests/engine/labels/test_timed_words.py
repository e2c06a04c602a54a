"""Words with times as other programs write them; the shapes of their JSON are those of their public documents."""

import json
from pathlib import Path
from typing import Any

import pytest

from phonemeengine.errors import CorpusError
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.labels.timed_words import TimedWord, read_timed_words
from phonemeengine.labels.utterance_files import read_utterance, tells_sounds

HELLO = (TimedWord(0.5, 0.9, "Hello,"), TimedWord(1.0, 1.4, "world."))
SHAPES: dict[str, Any] = {
    "Whisper": {
        "text": " Hello, world.",
        "language": "en",
        "segments": [
            {
                "id": 0,
                "start": 0.5,
                "end": 1.4,
                "text": " Hello, world.",
                "words": [
                    {"word": " Hello,", "start": 0.5, "end": 0.9, "probability": 0.9},
                    {"word": " world.", "start": 1.0, "end": 1.4, "probability": 0.8},
                ],
            }
        ],
    },
    "faster-whisper": [
        {"start": 0.5, "end": 0.9, "text": " Hello,", "words": [{"start": 0.5, "end": 0.9, "word": " Hello,"}]},
        {"start": 1.0, "end": 1.4, "text": " world.", "words": [{"start": 1.0, "end": 1.4, "word": " world."}]},
    ],
    "WhisperX, words alone": {
        "word_segments": [
            {"word": "Hello,", "start": 0.5, "end": 0.9, "score": 0.5},
            {"word": "world.", "start": 1.0, "end": 1.4},
        ]
    },
    "OpenAI": {
        "task": "transcribe",
        "duration": 2.0,
        "words": [{"word": "Hello,", "start": 0.5, "end": 0.9}, {"word": "world.", "start": 1.0, "end": 1.4}],
    },
    "ElevenLabs, transcription": {
        "language_code": "en",
        "words": [
            {"text": "Hello,", "start": 0.5, "end": 0.9, "type": "word", "speaker_id": "speaker_0"},
            {"text": " ", "start": 0.9, "end": 1.0, "type": "spacing", "speaker_id": "speaker_0"},
            {"text": "world.", "start": 1.0, "end": 1.4, "type": "word", "speaker_id": "speaker_0"},
            {"text": "(laughs)", "start": 1.5, "end": 1.9, "type": "audio_event", "speaker_id": "speaker_0"},
        ],
    },
    "ElevenLabs, speech": {
        "audio_base64": "",
        "alignment": {
            "characters": list("Hello, world."),
            "character_start_times_seconds": [0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 1.0, 1.1, 1.2, 1.25, 1.3, 1.35],
            "character_end_times_seconds": [0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 1.0, 1.1, 1.2, 1.25, 1.3, 1.35, 1.4],
        },
    },
    "Azure, phrase": {
        "RecognitionStatus": "Success",
        "NBest": [
            {
                "Confidence": 0.9,
                "Words": [
                    {"Word": "Hello,", "Offset": 5_000_000, "Duration": 4_000_000},
                    {"Word": "world.", "Offset": 10_000_000, "Duration": 4_000_000},
                ],
            },
            {"Confidence": 0.1, "Words": [{"Word": "hollow", "Offset": 5_000_000, "Duration": 9_000_000}]},
        ],
    },
    "Azure, batch": {
        "recognizedPhrases": [
            {
                "nBest": [
                    {
                        "words": [
                            {"word": "Hello,", "offsetInTicks": 5_000_000.0, "durationInTicks": 4_000_000.0},
                            {"word": "world.", "offsetInTicks": 10_000_000.0, "durationInTicks": 4_000_000.0},
                        ]
                    }
                ]
            }
        ]
    },
    "Azure, fast": {
        "phrases": [
            {
                "speaker": 1,
                "words": [
                    {"text": "Hello,", "offsetMilliseconds": 500, "durationMilliseconds": 400},
                    {"text": "world.", "offsetMilliseconds": 1000, "durationMilliseconds": 400},
                ],
            }
        ]
    },
    "Azure, synthesis": [
        {"Text": "Hello,", "AudioOffset": 500, "Duration": 400},
        {"Text": "world.", "AudioOffset": 1000, "Duration": 400},
    ],
}


def read(tmp_path: Path, document: Any, **options: Any) -> tuple[TimedWord, ...]:
    path = tmp_path / "words.json"
    path.write_text(json.dumps(document, ensure_ascii=False), encoding="utf-8")
    return read_timed_words(path, options.pop("duration", 2.0), **options)


@pytest.mark.parametrize("program", SHAPES)
def test_the_words_of_other_programs_are_read_with_their_times(tmp_path: Path, program: str) -> None:
    words = read(tmp_path, SHAPES[program])
    assert [word.text for word in words] == [word.text for word in HELLO]
    times = [time for word in words for time in (word.start, word.end)]
    assert times == pytest.approx([0.5, 0.9, 1.0, 1.4], abs=1e-9)


def entry(word: str, start: Any = None, end: Any = None, **more: Any) -> dict[str, Any]:
    times = {} if start is None else {"start": start, "end": end}
    return {"word": word, **times, **more}


def test_words_without_times_share_the_gap_and_join_their_neighbour_where_there_is_none(tmp_path: Path) -> None:
    words = [entry("in", 0.2, 0.4), entry("20"), entry("25"), entry("or", 0.8, 1.0), entry("so", 1.0, 1.0)]
    found = read(tmp_path, {"segments": [{"words": words}]})
    assert [word.text for word in found] == ["in", "20", "25", "or so"]
    times = [time for word in found for time in (word.start, word.end)]
    assert times == pytest.approx([0.2, 0.4, 0.4, 0.6, 0.6, 0.8, 0.8, 1.0])


def test_words_that_overlap_are_cut_and_the_last_one_ends_with_the_sound(tmp_path: Path) -> None:
    words = [entry("one", 0.2, 0.6), entry("two", 0.5, 2.4)]
    assert read(tmp_path, {"words": words}) == (TimedWord(0.2, 0.5, "one"), TimedWord(0.5, 2.0, "two"))


def test_in_languages_without_spaces_each_character_is_a_word(tmp_path: Path) -> None:
    times = [0.1 * k for k in range(6)]
    alignment = {
        "characters": list("你好，OK！"),
        "character_start_times_seconds": times,
        "character_end_times_seconds": [time + 0.1 for time in times],
    }
    assert [word.text for word in read(tmp_path, {"alignment": alignment})] == ["你", "好，", "OK！"]


def test_one_speaker_is_chosen(tmp_path: Path) -> None:
    words = [entry("Hello", 0.1, 0.4, speaker="SPEAKER_00"), entry("Hi", 0.5, 0.8, speaker="SPEAKER_01")]
    document = {"segments": [{"words": words}]}
    assert [word.text for word in read(tmp_path, document, speaker="SPEAKER_01")] == ["Hi"]
    with pytest.raises(CorpusError, match="tells 2 speakers apart, 'SPEAKER_00', 'SPEAKER_01'; choose one"):
        read(tmp_path, document)
    with pytest.raises(CorpusError, match="there is no 'MARY'"):
        read(tmp_path, document, speaker="MARY")


@pytest.mark.parametrize(
    ("document", "why"),
    [
        ({"segments": [{"text": " Hello.", "start": 0, "end": 1}]}, "there is no word with a time in it"),
        ({"words": [entry("late", 2.5, 2.8)]}, "'late' begins at 2.5 s, but the sound lasts 2.000 s"),
        ({"words": [entry("early", -0.5, 0.8)]}, "'early' begins at -0.5 s"),
        ({"words": [entry("odd", "0:01", "0:02")]}, "there is no word with a time in it"),
        ("a text", "there is no word with a time in it"),
        ({"alignment": {"characters": ["a"], "character_start_times_seconds": []}}, "there is no word with a time"),
    ],
)
def test_what_has_no_words_or_is_of_another_sound_is_refused(tmp_path: Path, document: Any, why: str) -> None:
    with pytest.raises(CorpusError, match=why):
        read(tmp_path, document)


def test_what_is_no_json_is_refused_in_one_sentence(tmp_path: Path) -> None:
    path = tmp_path / "words.json"
    for text in ("{", "[" * 100_000):
        path.write_text(text, encoding="utf-8")
        with pytest.raises(CorpusError, match="this is no JSON"):
            read_timed_words(path, 1.0)


def test_a_textgrid_of_words_alone_is_read(tmp_path: Path) -> None:
    path = tmp_path / "a.TextGrid"
    path.write_text(format_tiers({"words": [(0.0, 0.5, "sil"), (0.5, 0.9, "Hello,"), (1.0, 1.4, "world.")]}, 2.0))
    assert read_timed_words(path, 2.0) == HELLO
    assert not tells_sounds(path)


def test_the_tiers_of_one_of_several_speakers_are_read(tmp_path: Path) -> None:
    """As the Montreal Forced Aligner names them."""
    path = tmp_path / "a.TextGrid"
    tiers = {
        "mary - words": [(0.1, 0.5, "see")],
        "mary - phones": [(0.1, 0.3, "s"), (0.3, 0.5, "i")],
        "john - words": [(0.6, 1.0, "me")],
        "john - phones": [(0.6, 0.8, "m"), (0.8, 1.0, "i")],
    }
    path.write_text(format_tiers(tiers, 2.0))
    assert tells_sounds(path, "john")
    said = read_utterance(path, 2.0, speaker="john")
    assert [(word.text, word.start, word.end) for word in said.words] == [("me", 0.6, 1.0)]
    assert [word.text for word in read_timed_words(path, 2.0, "mary")] == ["see"]
    with pytest.raises(CorpusError, match="tells 2 speakers apart, 'mary', 'john'; choose one"):
        read_utterance(path, 2.0)
    with pytest.raises(CorpusError, match="there is no 'jane'"):
        read_utterance(path, 2.0, speaker="jane")


def test_the_only_speaker_needs_no_choice(tmp_path: Path) -> None:
    path = tmp_path / "a.TextGrid"
    path.write_text(format_tiers({"mary - words": [(0.1, 0.5, "so")], "mary - phones": [(0.1, 0.5, "o")]}, 1.0))
    assert [word.text for word in read_utterance(path, 1.0).words] == ["so"]
