from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import Lexicon, TextError, Utterance, Voice, VoiceError, Word, load_lexicon, pinyin_track, speak
from phonemeengine.arrays import Float32Array
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.pinyin.table import load_pinyin_table
from phonemeengine.speech.pinyin.timing import USUAL_RATE
from phonemeengine.speech.voice import SENTENCE_PAUSE
from phonemeengine.text.pronunciation import words_of

ENGLISH = Voice("en-us")


def _level(samples: Float32Array, start: float, end: float) -> float:
    return float(np.abs(samples[round(start * SAMPLE_RATE) : round(end * SAMPLE_RATE)]).max())


def _phones(word: Word) -> str:
    return " ".join(phone.ipa for phone in word.phones)


def test_what_is_said_lies_within_the_sound_and_covers_its_words() -> None:
    samples, utterance = speak("Good evening, dear guests.", ENGLISH)
    assert [word.text for word in utterance.words] == ["Good", "evening", "dear", "guests"]
    assert utterance.duration == len(samples) / SAMPLE_RATE
    assert samples.dtype == np.float32
    assert 0.1 < float(np.abs(samples).max()) <= 1


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("en-us", "Would you have changed the church of the judge in 1984?"),
        ("de", "Der Zug pfeift auf die Bäckerei."),
        ("fr", "Les enfants ont mangé un chat."),
        ("ja", "こんにちは、せかい。"),
        ("cmn", "我们2024年去hello银行吧。"),
    ],
)
def test_each_word_of_the_script_is_said_once_and_in_order(language: str, text: str) -> None:
    said = [word.text for word in speak(text, Voice(language))[1].words]
    assert said == [word.text for word in words_of(text, language)]


def test_between_sentences_there_is_silence_and_words_are_loud() -> None:
    samples, utterance = speak("Yes. No.", ENGLISH)
    yes, no = utterance.words
    pause = SENTENCE_PAUSE / USUAL_RATE
    assert no.start - yes.end == pytest.approx(pause, abs=0.15)
    assert _level(samples, yes.end + 0.1, yes.end + pause - 0.05) < 0.01
    assert all(_level(samples, word.start, word.end) > 0.1 for word in (yes, no))


def test_a_vowel_begins_where_its_fricative_ends() -> None:
    samples, utterance = speak("see", ENGLISH)
    friction, vowel = utterance.words[0].phones
    assert (friction.ipa, vowel.ipa) == ("s", "i")
    turns = [
        int(np.count_nonzero(np.diff(np.signbit(samples[round(a * SAMPLE_RATE) : round(b * SAMPLE_RATE)])))) / (b - a)
        for a, b in ((friction.start + 0.02, friction.end - 0.01), (vowel.start + 0.01, vowel.end - 0.02))
    ]
    assert turns[0] > 2 * turns[1]


def test_lips_close_before_the_burst_that_the_synthesizer_reports() -> None:
    samples, utterance = speak("a happy papa", ENGLISH)
    stops = [phone for phone in utterance.phones if phone.ipa == "p"]
    assert len(stops) == 3
    for stop in stops[:2]:
        assert stop.end - stop.start > 0.04
        assert _level(samples, stop.start + 0.005, stop.start + 0.02) < 0.3 * float(np.abs(samples).max())


def test_an_affricate_is_a_closure_and_friction() -> None:
    (church,) = speak("church", ENGLISH)[1].words
    assert _phones(church) == "t ʃ ɜ t ʃ"


def test_a_faster_voice_says_the_same_in_less_time() -> None:
    slow, fast = (speak("An ordinary sentence of words", Voice("en-us", rate=rate)) for rate in (2.4, 7.3))
    assert len(fast[0]) < 0.6 * len(slow[0])
    assert [word.text for word in fast[1].words] == [word.text for word in slow[1].words]


def test_another_voice_says_the_same_with_another_sound() -> None:
    (plain, said), (other, said_too) = speak("hello", ENGLISH), speak("hello", Voice("en-us", "f3"))
    assert [_phones(word) for word in said.words] == [_phones(word) for word in said_too.words]
    assert len(plain) != len(other) or not np.array_equal(plain, other)


def test_a_chinese_character_is_a_syllable_with_its_pinyin() -> None:
    utterance = speak("银行，穷不穷？", Voice("cmn"))[1]
    assert [word.syllables[0].text for word in utterance.words] == ["yin2", "hang2", "qiong2", "bu4", "qiong2"]
    assert _phones(utterance.words[2]) == "t ɕ j ʊ ŋ"


@pytest.mark.parametrize(
    ("mark", "syllables"),
    [("，", 1.2), (",", 1.2), ("、", 0.6), ("；", 1.8), ("。", 2.4), ("？！”", 2.4), ("……", 1.8)],
)
def test_a_chinese_clause_is_followed_by_the_pause_of_its_mark(mark: str, syllables: float) -> None:
    before, after = speak(f"你好{mark}世界", Voice("cmn"))[1].words[1:3]
    assert after.start - before.end == pytest.approx(syllables / USUAL_RATE, abs=0.1)


def test_a_voice_and_a_silent_mouth_pause_alike_by_a_table_of_ones_own() -> None:
    table = replace(load_pinyin_table(), pause=6.0)
    before, after = speak("你好，世界", Voice("cmn", pinyin_table=table))[1].words[1:3]
    assert after.start - before.end == pytest.approx(3.0 / USUAL_RATE, abs=0.1)
    rows = pinyin_track("你好，世界", table, rate=USUAL_RATE).plan.rows
    assert rows[2].end - rows[2].start == pytest.approx(3.0 / USUAL_RATE)


def _lexicon(folder: Path, *rows: str) -> Lexicon:
    (folder / "l.csv").write_text("\n".join(["word,ipa", *rows]), encoding="utf-8")
    return load_lexicon(folder / "l.csv")


@pytest.mark.parametrize(
    ("language", "text"),
    [("de", "Der „Zug“, ein (Zug). Zug!"), ("en-gb", "The zug of the zug, “zug”."), ("cmn", "你好zug。")],
)
def test_a_voice_says_words_as_a_lexicon_has_them(tmp_path: Path, language: str, text: str) -> None:
    voice = Voice(language, lexicon=_lexicon(tmp_path, "zug,ˈkɔn.tɑk"))
    words = speak(text, voice)[1].words
    assert [word.text for word in words] == [word.text for word in words_of(text, language)]
    said = [word for word in words if word.text.lower() == "zug"]
    assert len(said) == text.lower().count("zug")
    for word in said:
        assert _phones(word) == "k ɔ n t ɑ k"
        assert [syllable.stress for syllable in word.syllables] == [1, 0]


def test_the_next_pronunciation_of_a_lexicon_serves_where_the_voice_lacks_sounds(tmp_path: Path) -> None:
    voice = Voice("de", lexicon=_lexicon(tmp_path, "Zug,næ", "Zug,tsɛɡ"))
    assert _phones(speak("Zug", voice)[1].words[0]) == "t s ɛ ɡ"


def test_what_a_voice_cannot_say_as_a_lexicon_has_it_is_said_as_usual_and_told(tmp_path: Path) -> None:
    lexicon = _lexicon(tmp_path, "Zug,næ", "银,a")
    (sentence,) = Voice("de", lexicon=lexicon).speak("Der Zug.")
    assert sentence.unheeded == ("Zug",)
    assert _phones(sentence.words[1]) == "t s u k"
    (sentence,) = Voice("cmn", lexicon=lexicon).speak("银行。")
    assert sentence.unheeded == ("银",)


@pytest.mark.parametrize("rate", [1.6, 4.0, 9.0])
def test_a_voice_pauses_at_marks_and_nowhere_else(rate: float) -> None:
    text = "今天我们去北京大学看看朋友，好吗？"
    _, utterance = speak(text, Voice("cmn", rate=rate))
    pauses = [row for row in pinyin_track(utterance, text=text).plan.rows if row.kind == "pause"]
    assert [pause.text for pause in pauses] == ["，", "？"]
    assert all(a.end == b.start for a, b in pairwise(utterance.words) if a.text != "友")


def test_pinyin_is_spoken_too() -> None:
    assert [word.text for word in speak("nǐ hǎo", Voice("cmn-latn-pinyin"))[1].words] == ["nǐ", "hǎo"]


def test_sentences_come_one_by_one_as_they_are_asked_for() -> None:
    sentences = Voice("en-us").speak("One. " * 10_000)
    assert next(iter(sentences)).text == "One."


@pytest.mark.parametrize("text", ["", "🎉", "\0\x01", "[[", "..."])
def test_what_nobody_can_speak_is_refused_before_anything_is_spoken(text: str) -> None:
    with pytest.raises(TextError, match="no word to speak"):
        ENGLISH.speak(text)


def test_markup_is_spoken_and_not_obeyed() -> None:
    utterance = speak('<break time="9s"/> hello [[h@]] \x01+10P there', ENGLISH)[1]
    assert utterance.duration < 12
    assert {"hello", "there"} <= {word.text for word in utterance.words}


@pytest.mark.parametrize(
    ("voice", "words"),
    [
        (Voice("xx"), "no voice speaks the language 'xx'"),
        (Voice(""), "not guessed"),
        (Voice("de", "nonsense"), "no voice 'nonsense'"),
    ],
)
def test_a_voice_that_is_not_there_is_refused_at_once(voice: Voice, words: str) -> None:
    with pytest.raises(TextError, match=words):
        voice.speak("Hallo")


@pytest.mark.parametrize("rate", [0.0, 1.5, 10.0, float("nan")])
def test_a_rate_that_no_voice_has_is_refused(rate: float) -> None:
    with pytest.raises(VoiceError, match=r"1\.6\.\.9\.5"):
        Voice("de", rate=rate)


def test_an_utterance_of_a_voice_has_stress() -> None:
    utterance: Utterance = speak("potato", ENGLISH)[1]
    assert [syllable.stress for syllable in utterance.words[0].syllables] == [0, 1, 0]
