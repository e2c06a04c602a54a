"""Recordings with labelled syllables: read from Praat's files, and refused in one sentence."""

from pathlib import Path

import parselmouth
import pytest
from parselmouth.praat import call

from phonemeengine.errors import CorpusError, TextError
from phonemeengine.labels.utterance import Utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.labelled import read_syllables
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
    said = read_syllables(path, DURATION)
    assert heard(said) == [("ni3", 0.3, 0.6), ("hao3", 0.6, 0.9), ("lü4", 1.2, 1.5)]
    kinds = [(str(row.kind), row.letters) for row in plan_of(said, TABLE).rows]
    assert kinds == [("pause", "&"), ("syllable", "di"), ("syllable", "ga"), ("pause", "&"), ("syllable", "do")]


def test_phones_of_a_syllable_are_its_onset_and_its_nucleus(tmp_path: Path) -> None:
    said = read_syllables(saved(tmp_path / "a.TextGrid", ["ma1", "shui3", "er2", "hng5", "fu4"]), DURATION)
    assert [phone.ipa for phone in said.phones] == ["m", "a", "ʂ", "ə", "ə", "x", "ŋ", "f", "u"]
    assert [phone.phoneme for phone in said.phones][:4] == [Phoneme.M, Phoneme.A, Phoneme.SCH, Phoneme.E]


def test_what_is_no_pinyin_is_refused_with_its_place(tmp_path: Path) -> None:
    path = saved(tmp_path / "a.TextGrid", ["ma1", "hello"])
    with pytest.raises(TextError, match=r"^a.TextGrid, tier 'syllables', interval 2: 'hello' is no syllable"):
        read_syllables(path, DURATION)


def test_a_file_without_syllables_is_refused(tmp_path: Path) -> None:
    path = saved(tmp_path / "a.TextGrid", ["ma1"], "words phones")
    with pytest.raises(CorpusError, match=r"^a.TextGrid: there is no tier of intervals named 'syllables' with"):
        read_syllables(path, DURATION)
    empty = saved(tmp_path / "b.TextGrid", [""])
    with pytest.raises(CorpusError, match=r"named 'syllables' with a label, found 'words', 'syllables'; add it"):
        read_syllables(empty, DURATION)
