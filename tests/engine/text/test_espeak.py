import os
from pathlib import Path

import pytest

from phonemeengine import TextError, VoiceError
from phonemeengine.arrays import Int16Array
from phonemeengine.text import espeak
from phonemeengine.text.espeak import Event, EventKind, installation, language_of, languages, short_path, synthesise


def _heard(text: str, language: str = "en-us", **options: object) -> tuple[int, list[Event]]:
    blocks, events = [], []

    def hear(samples: object, found: tuple[Event, ...]) -> bool:
        blocks.append(len(samples))  # type: ignore[arg-type]
        events.extend(found)
        return True

    synthesise(text, language_of(language), hear, **options)  # type: ignore[arg-type]
    return sum(blocks), events


def _not_there() -> None:
    return None


def test_every_language_that_is_listed_can_pronounce_a_word() -> None:
    tags = [language.tag for language in languages()]
    assert {"en-us", "en-gb", "de", "fr", "ja", "cmn-latn-pinyin"} <= set(tags)
    assert len(tags) > 100


@pytest.mark.parametrize("tag", ["en-gb", "fr-fr", "EN-US", "no"])
def test_a_language_is_found_by_each_of_its_tags_in_any_case(tag: str) -> None:
    assert language_of(tag).tag == tag.lower()


def test_without_a_library_one_sentence_says_what_to_install() -> None:
    with pytest.raises(VoiceError, match=r"no voice is installed.*pip install.*libespeak-ng1"):
        installation(_not_there, lambda _name: None)


def test_the_library_of_the_system_serves_where_the_package_is_missing() -> None:
    assert installation(_not_there, {"espeak-ng": "libespeak-ng.so.1"}.get).library == "libespeak-ng.so.1"


def test_data_on_a_short_path_are_read_where_they_are(tmp_path: Path) -> None:
    assert short_path(Path("/opt/data"), tmp_path) == Path("/opt/data")


def _deep(folder: Path) -> Path:
    deep = folder
    while len(os.fsencode(deep)) <= espeak.LONGEST_PATH:
        deep /= "a-folder-with-a-long-name"
    deep.mkdir(parents=True)
    (deep / "phontab").write_text("here")
    return deep


def test_data_on_a_path_of_more_than_160_bytes_are_read_by_a_short_one(tmp_path: Path) -> None:
    deep = _deep(tmp_path)
    short = short_path(deep, tmp_path / "cache")
    assert len(os.fsencode(short)) <= espeak.LONGEST_PATH
    assert (short / "phontab").read_text() == "here"
    assert short_path(deep, tmp_path / "cache") == short


def test_a_cache_that_is_too_deep_as_well_is_refused_with_a_remedy(tmp_path: Path) -> None:
    deep = _deep(tmp_path)
    with pytest.raises(VoiceError, match="shorter path"):
        short_path(deep, deep / "cache")


def test_a_cache_that_cannot_be_made_is_refused_with_a_remedy(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(VoiceError, match="cannot be placed there"):
        short_path(_deep(tmp_path), tmp_path / "file" / "cache")


def test_events_lie_within_the_samples_in_order_of_time() -> None:
    n, events = _heard("Two words.")
    samples = [event.sample for event in events]
    assert samples == sorted(samples)
    assert samples[0] >= 0
    assert samples[-1] <= n
    assert [event.position for event in events if event.kind is EventKind.WORD] == [0, 4]


def test_a_listener_that_has_enough_ends_the_speech() -> None:
    n_blocks = 0

    def hear(_samples: object, _events: object) -> bool:
        nonlocal n_blocks
        n_blocks += 1
        return False

    synthesise("A very long text. " * 1000, language_of("en-us"), hear)
    assert n_blocks == 1


@pytest.mark.parametrize("voice", ["", "klatt"])
@pytest.mark.parametrize("n_blocks", [1, 2, 3, 7, 20, 80])
def test_nothing_of_a_stopped_text_is_said_with_the_next_one(voice: str, n_blocks: int) -> None:
    n, events = _heard("Hello there.", voice=voice)
    heard = 0

    def hear(_samples: object, _events: object) -> bool:
        nonlocal heard
        heard += 1
        return heard < n_blocks

    synthesise("The quick brown fox, and 1984 lazy dogs; why? " * 100, language_of("en-us"), hear, voice=voice)
    assert heard == n_blocks
    assert _heard("Hello there.", voice=voice) == (n, events)


@pytest.mark.parametrize("voice", ["", "f5", "whisper"])
def test_a_text_sounds_alike_whatever_was_spoken_before(voice: str) -> None:
    def sound() -> list[int]:
        blocks: list[int] = []

        def take(samples: Int16Array, _events: object) -> bool:
            blocks.extend(samples.tolist())
            return True

        synthesise("Hello there.", language_of("en-us"), take, voice=voice)
        return blocks

    first = sound()
    _heard("One.")
    assert sound() == first


def test_what_a_listener_raises_comes_through_the_library() -> None:
    def hear(_samples: object, _events: object) -> bool:
        raise TextError("enough")

    with pytest.raises(TextError, match="enough"):
        synthesise("Hello", language_of("en-us"), hear)


def test_a_faster_rate_is_a_shorter_sound() -> None:
    assert _heard("Hello world", rate=300)[0] < 0.8 * _heard("Hello world", rate=120)[0]


def test_an_unknown_voice_is_refused_and_some_are_named() -> None:
    with pytest.raises(VoiceError, match=r"'nonsense'.*f2"):
        _heard("Hello", voice="nonsense")


@pytest.mark.parametrize("name", ["(en)", "", "__", "5", ";", "ː"])
def test_remarks_and_tones_are_no_phones(name: str) -> None:
    assert espeak.symbols_of(name) == ()


def test_the_russian_vowel_that_is_not_rounded_has_its_own_symbol() -> None:
    russian = espeak.language_of("ru")
    assert espeak.phone_names("мы", russian).endswith("ɨ")
    heard: list[str] = []

    def take(_samples: object, events: tuple[espeak.Event, ...]) -> bool:
        heard.extend(event.name for event in events)
        return True

    espeak.synthesise("мы", russian, take)
    assert any("ɨ" in name for name in heard)


def test_a_name_is_split_into_symbols_without_stress_length_and_tone() -> None:
    assert espeak.symbols_of("ˈɑːɹ") == ("ɑ", "ɹ")
    assert espeak.symbols_of("tɕ") == ("t", "ɕ")
    assert espeak.symbols_of("ˈaɪɚ") == ("aɪ", "ɚ")
    assert espeak.symbols_of("iɑ5") == ("i", "ɑ")
