"""What is said in a recording: written as a TextGrid, read from one that is labelled, or refused in one sentence."""

from pathlib import Path

import parselmouth
import pytest
from parselmouth.praat import call

from phonemeengine.errors import CorpusError, UnknownPhonemeError
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.timed_words import read_timed_words
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.timing import plan_of
from tests.engine.speech.pinyin.saying import TABLE

DURATION = 1.5


def saved(path: Path, names: list[str], tiers: str = "words syllables") -> Path:
    """Have Praat write a TextGrid of 1.5 s whose second tier has these names, each 0.3 s long."""
    grid = parselmouth.TextGrid(0, DURATION, tiers, "")
    for k, name in enumerate(names):
        if k:
            call(grid, "Insert boundary...", 2, 0.3 * k)
        call(grid, "Set interval text...", 2, k + 1, name)
    call(grid, "Save as text file...", str(path))
    return path


def heard(said: Utterance) -> list[tuple[str, float, float]]:
    return [(s.text, round(s.start, 6), round(s.end, 6)) for word in said.words for s in word.syllables]


def test_syllables_of_a_recording_keep_their_times_and_silence_is_a_pause(tmp_path: Path) -> None:
    path = saved(tmp_path / "a.TextGrid", ["sil", "nǐ", "hao3", "", "lv4"])
    said = read_utterance(path, DURATION)
    assert heard(said) == [("ni3", 0.3, 0.6), ("hao3", 0.6, 0.9), ("lü4", 1.2, 1.5)]
    kinds = [(str(row.kind), row.letters) for row in plan_of(said, TABLE).rows]
    assert kinds == [("pause", "&"), ("syllable", "di"), ("syllable", "ga"), ("pause", "&"), ("syllable", "do")]


def test_phones_of_a_syllable_are_those_of_its_pinyin(tmp_path: Path) -> None:
    said = read_utterance(saved(tmp_path / "a.TextGrid", ["ma1", "shui3", "er2", "hng5", "fu4"]), DURATION)
    assert [phone.ipa for phone in said.phones] == ["m", "a", "ʂ", "w", "eɪ", "ɚ", "x", "ŋ̩", "f", "u"]
    phonemes = [phone.phoneme for phone in said.phones]
    assert phonemes[:2] + phonemes[2:5:2] == [Phoneme.M, Phoneme.A, Phoneme.SCH, Phoneme.E]
    assert [round(phone.start, 3) for phone in said.phones][:6] == [0, 0.15, 0.3, 0.375, 0.45, 0.6]


def test_what_is_no_pinyin_is_refused_with_its_place(tmp_path: Path) -> None:
    path = saved(tmp_path / "a.TextGrid", ["ma1", "hello"])
    with pytest.raises(CorpusError, match=r"^a.TextGrid, tier 'syllables', interval 2: 'hello' is no syllable"):
        read_utterance(path, DURATION)


def test_syllables_that_are_no_pinyin_need_a_tier_of_sounds(tmp_path: Path) -> None:
    path = saved(tmp_path / "a.TextGrid", ["ˈɹuθ", "", "ˈsɛd"])
    with pytest.raises(CorpusError, match=r"^a.TextGrid: there is no tier named 'phones' with a label, or"):
        read_utterance(path, DURATION)


def test_a_file_that_is_longer_than_its_sound_is_refused(tmp_path: Path) -> None:
    path = saved(tmp_path / "a.TextGrid", ["ma1", "", "sil"])
    assert heard(read_utterance(path, DURATION - 0.04)) == [("ma1", 0.0, 0.3)]
    with pytest.raises(CorpusError, match=r"is of a sound of 1\.50 s, and the sound here lasts 0\.50 s; check"):
        read_utterance(path, 0.5)


def test_a_file_without_sounds_and_syllables_is_refused(tmp_path: Path) -> None:
    path = saved(tmp_path / "a.TextGrid", ["ma1"], "words others")
    with pytest.raises(CorpusError, match=r"^a.TextGrid: there is no tier named 'phones' with a label, or"):
        read_utterance(path, DURATION)
    with pytest.raises(CorpusError, match=r"^b.TextGrid: there is no tier"):
        read_utterance(saved(tmp_path / "b.TextGrid", [""]), DURATION)


def spoken(start: float, *names: str, text: str = "") -> Syllable:
    """A syllable whose phones last 0.1 s each."""
    phones = (Phone(start + 0.1 * k, start + 0.1 * (k + 1), ipa, ipa_phoneme(ipa)) for k, ipa in enumerate(names))
    return Syllable(tuple(phones), text=text)


MIXED = Utterance(
    (
        Word("你好", (spoken(0.1, "n", "i", text="ni3"), spoken(0.3, "x", "aʊ", text="hao3"))),
        Word("Silence", (spoken(0.6, "s", "aɪ"), spoken(0.8, "l", "ə", "n", "s"))),
    ),
    DURATION,
)


@pytest.mark.parametrize("silence", ["", "sil"])
def test_an_utterance_that_is_written_is_read_again(tmp_path: Path, silence: str) -> None:
    path = tmp_path / "a.TextGrid"
    path.write_text(format_utterance(MIXED, silence), encoding="utf-8")
    again = read_utterance(path, DURATION)
    assert [(w.text, round(w.start, 6), round(w.end, 6)) for w in again.words] == [
        (w.text, round(w.start, 6), round(w.end, 6)) for w in MIXED.words
    ]
    assert heard(again) == heard(MIXED)
    assert [phone.ipa for phone in again.phones] == [phone.ipa for phone in MIXED.phones]
    assert [word.text for word in read_timed_words(path, MIXED.duration)] == ["你好", "Silence"]


def test_phones_win_over_those_of_pinyin_unless_nobody_knows_them(tmp_path: Path) -> None:
    grid = parselmouth.TextGrid(0, DURATION, "phones syllables", "")
    call(grid, "Set interval text...", 1, 1, "o")
    call(grid, "Set interval text...", 2, 1, "ma1")
    call(grid, "Save as text file...", str(tmp_path / "a.TextGrid"))
    said = read_utterance(tmp_path / "a.TextGrid", DURATION)
    assert ([phone.ipa for phone in said.phones], heard(said)) == (["o"], [("ma1", 0.0, DURATION)])
    call(grid, "Set interval text...", 1, 1, "i˥˩")
    call(grid, "Save as text file...", str(tmp_path / "a.TextGrid"))
    assert [phone.ipa for phone in read_utterance(tmp_path / "a.TextGrid", DURATION).phones] == ["m", "a"]
    call(grid, "Set interval text...", 2, 1, "hello")
    call(grid, "Save as text file...", str(tmp_path / "a.TextGrid"))
    with pytest.raises(UnknownPhonemeError, match="i˥˩"):
        read_utterance(tmp_path / "a.TextGrid", DURATION)


def test_syllables_that_are_spelt_as_their_sounds_are_no_pinyin(tmp_path: Path) -> None:
    phones = tuple(Phone(0.1 * k, 0.1 * (k + 1), x, ipa_phoneme(x)) for k, x in enumerate("misu"))
    words = (Word("me", (Syllable(phones[:2]),)), Word("sue", (Syllable(phones[2:]),)))
    path = tmp_path / "english.TextGrid"
    path.write_text(format_utterance(Utterance(words, DURATION)), encoding="utf-8")
    assert heard(read_utterance(path, DURATION)) == [("", 0.0, 0.2), ("", 0.2, 0.4)]
