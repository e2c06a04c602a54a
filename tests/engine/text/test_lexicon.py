from pathlib import Path

import pytest

from phonemeengine import TextError
from phonemeengine.text.lexicon import load_lexicon
from phonemeengine.text.syllables import SpokenSyllable

HEAD = 'format = "phonemeanalyser lexicon 1"\n'


def _written(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_a_toml_lexicon_holds_words_and_their_variants(tmp_path: Path) -> None:
    path = _written(tmp_path, "l.toml", HEAD + '[words]\nNASA = "ˈnæ.sə"\neither = ["ˈiːðɚ", "ˈaɪðɚ"]\n')
    lexicon = load_lexicon(path)
    assert lexicon.pronunciations["nasa"] == ((SpokenSyllable(("n", "æ"), 1), SpokenSyllable(("s", "ə"))),)
    assert [variant[0].phones for variant in lexicon.pronunciations["either"]] == [("i",), ("aɪ",)]


def test_a_csv_lexicon_has_a_row_for_each_variant(tmp_path: Path) -> None:
    lexicon = load_lexicon(_written(tmp_path, "l.csv", "word,ipa\nRossi,ˈrossi\nRossi,ˈroːsi\n"))
    assert len(lexicon.pronunciations["rossi"]) == 2


def test_the_mark_of_stress_may_stand_before_the_syllable_or_its_vowel(tmp_path: Path) -> None:
    lexicon = load_lexicon(_written(tmp_path, "l.csv", "word,ipa\na,bəˈnɑnə\nb,bənˈɑnə\n"))
    stresses = [[syllable.stress for syllable in lexicon.pronunciations[word][0]] for word in "ab"]
    assert stresses == [[0, 1, 0], [0, 1, 0]]


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("l.toml", "nonsense", "no TOML"),
        ("l.toml", 'format = "other"', "begins with format"),
        ("l.toml", HEAD + "[words]\na = 3\n", "must be IPA"),
        ("l.toml", HEAD + "[words]\na = [3]\n", "must be IPA"),
        ("l.toml", HEAD + '[words]\na = "%&"\n', "no IPA, found '%'"),
        ("l.toml", HEAD + '[words]\n"two words" = "a"\n', "single words"),
        ("l.toml", HEAD + "[words]\n", "no word in it"),
        ("l.toml", HEAD + "[other]\n", "cannot have an entry"),
        ("l.csv", "word,ipa\na,HH EH L OW\n", "no IPA, found 'H'"),
        ("l.csv", "word,ipa\na,ˈ.\n", "no sounds"),
        ("l.csv", "word,ipa\n,a\n", "single words"),
        ("l.csv", "word\na\n", "lacks the column ipa"),
        ("l.csv", "", "lacks the column"),
    ],
)
def test_a_lexicon_with_nonsense_is_refused_in_one_sentence(tmp_path: Path, name: str, text: str, words: str) -> None:
    with pytest.raises(TextError, match=words) as refusal:
        load_lexicon(_written(tmp_path, name, text))
    assert str(refusal.value).startswith(name)
    assert "\n" not in str(refusal.value)


def test_a_lexicon_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(TextError, match=r"none.toml: there is no such file"):
        load_lexicon(tmp_path / "none.toml")
