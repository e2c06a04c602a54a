import tomllib
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import PerformanceError
from phonemeengine.performance.keywords import (
    CONJUNCTIONS,
    FORMAT,
    USUAL_KEYWORDS,
    Gesture,
    base_of,
    keywords_of,
    load_keywords,
    plain,
)
from phonemeengine.performance.recording import HEAD

KEYWORDS = load_keywords()
HEADING = f'format = "{FORMAT}"\n'
BOW = HEADING + "[gestures.bow]\nshortest = 1\nchannels = { headPitch = [-20], browDown = [0.2] }\n"


def _name_of(gesture: Gesture) -> str:
    return next(name for name, found in KEYWORDS.gestures.items() if found is gesture)


def _gestures(text: str, language: str) -> list[tuple[int, int, str]]:
    found = KEYWORDS.gestures_in(text.split(), language)
    return [(first, last, _name_of(gesture)) for first, last, gesture in found]


@pytest.mark.parametrize(
    ("language", "yes", "no", "good", "bad", "conjunction"),
    [
        ("en-us", "Yes,", "No!", "good", "bad", "and"),
        ("de", "Ja", "nein", "gut", "schlecht", "und"),
        ("fr-fr", "Oui", "non", "bon", "mauvais", "et"),
        ("it", "Sì", "no", "buono", "cattivo", "ma"),
        ("es", "sí", "no", "bueno", "malo", "pero"),
        ("pt-br", "sim", "não", "bom", "mau", "mas"),
        ("nl", "ja", "nee", "goed", "slecht", "maar"),
        ("sv", "ja", "nej", "bra", "dåligt", "och"),
        ("cs", "ano", "ne", "dobře", "špatně", "ale"),
        ("pl", "tak", "nie", "dobrze", "źle", "albo"),
        ("ru", "да", "нет", "хорошо", "плохо", "но"),
        ("fi", "kyllä", "ei", "hyvä", "huono", "mutta"),
        ("cmn", "是的", "不是", "很好", "坏", "但是"),
    ],
)
def test_yes_nods_and_no_shakes_in_many_languages(
    language: str, yes: str, no: str, good: str, bad: str, conjunction: str
) -> None:
    names = [name for _, _, name in _gestures(f"{yes} {no} {good} {bad}", language)]
    assert names == ["nod", "shake", "approve", "disapprove"]
    assert KEYWORDS.conjunctions_in(["x", conjunction, "x"], language) == {1}


def test_entries_of_several_words_count_as_one() -> None:
    assert _gestures("but of course not", "en") == [(1, 2, "nod")]
    assert _gestures("D\u2019accord", "fr") == _gestures("d'accord", "fr") == [(0, 0, "nod")]


def test_chinese_characters_are_words_of_which_the_longest_entry_counts() -> None:
    assert _gestures("他 从 来 没 有", "cmn") == [(1, 4, "shake")]
    assert _gestures("不 错", "zh") == [(0, 1, "approve")]
    assert KEYWORDS.conjunctions_in([*"我但是"], "cmn") == {1}


def test_a_language_that_nobody_knows_has_no_gestures() -> None:
    assert _gestures("yes no", "") == _gestures("yes no", "tlh") == []
    assert KEYWORDS.conjunctions_in(["a", "and"], "") == frozenset()


def test_case_and_marks_do_not_count() -> None:
    assert plain("«Straße!»") == "strasse"
    assert (base_of("EN-us"), base_of("zh"), base_of("cmn-latn-pinyin"), base_of("de")) == ("en", "cmn", "cmn", "de")


def test_a_gesture_begins_and_ends_where_the_head_is_and_reaches_its_values() -> None:
    nod = KEYWORDS.gestures["nod"]
    values = nod.channels["headPitch"]
    places = np.linspace(0, 1, len(values) + 2)
    assert nod.curve("headPitch", places) == pytest.approx([0.0, *values, 0.0])
    assert not nod.curve("headYaw", places).any()
    fine = nod.curve("headPitch", np.linspace(0, 1, 1001))
    assert fine.min() == pytest.approx(min(values))
    assert abs(np.diff(fine)).max() < 0.1


def test_a_half_way_between_two_values_is_their_mean() -> None:
    gesture = Gesture(0.5, {"headYaw": (4.0,)})
    assert gesture.curve("headYaw", np.array([0.25, 0.5, 0.75])) == pytest.approx([2.0, 4.0, 2.0])


def test_a_file_of_the_users_own_adds_words_and_gestures(tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(BOW + '[languages.en]\nbow = ["Majesty"]\nraise = ["yes"]\n[languages.tlh]\nnod = ["HIja\'"]\n')
    own = load_keywords(path)
    bow = own.gestures["bow"]
    assert bow.channels == {"headPitch": (-20.0,), "browDownLeft": (0.2,), "browDownRight": (0.2,)}
    assert [gesture for *_, gesture in own.gestures_in(["Your", "majesty"], "en")] == [bow]
    assert [gesture for *_, gesture in own.gestures_in(["HIja'"], "tlh")] == [own.gestures["nod"]]
    assert own.words["en"]["yes"] == "raise"
    assert own.words["en"]["no"] == "shake"
    assert own.conjunctions["en"] == KEYWORDS.conjunctions["en"]


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ('format = "other"', "begins with format"),
        (BOW.replace("headPitch", "jawOpen"), "there is no channel 'jawOpen'"),
        (BOW.replace("-20", "-200"), r"headPitch must be a list of up to 50 numbers within ±60, found \[-200.0\]"),
        (BOW.replace("0.2", "2"), "browDown must be a list of up to 50 numbers within ±1"),
        (BOW.replace("shortest = 1", "shortest = -1"), r"shortest must be seconds in 0..5, found -1"),
        (BOW.replace("bow", CONJUNCTIONS), "cannot have an entry 'conjunctions'"),
        (HEADING + '[languages.en]\nwink = ["yes"]', r"\[languages.en\] cannot have an entry 'wink'"),
        (BOW + "[languages.en]\nbow = [1]", r"bow must be a list of words, found \[1\]"),
        (BOW + '[languages.en]\nbow = ["..."]', "bow must be a list of words"),
    ],
)
def test_what_is_no_key_word_is_refused_in_a_sentence(text: str, sentence: str) -> None:
    with pytest.raises(PerformanceError, match=sentence):
        keywords_of(text)


def test_a_refusal_names_the_file(tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(HEADING + "[languages.en]\nwink = []\n")
    with pytest.raises(PerformanceError, match=r"own.toml: \[languages.en\] cannot have an entry 'wink'"):
        load_keywords(path)


def test_no_word_of_a_language_has_two_gestures() -> None:
    languages = tomllib.loads(USUAL_KEYWORDS.read_text(encoding="utf-8"))["languages"]
    for name, entries in languages.items():
        words = [plain(word) for key, found in entries.items() if key != CONJUNCTIONS for word in found]
        assert len(words) == len({*words}), name
        assert len(entries[CONJUNCTIONS]) >= 10, name


def test_gestures_move_the_head_or_the_brows() -> None:
    for name, gesture in KEYWORDS.gestures.items():
        assert any(gesture.channels.values()), name
    assert {*KEYWORDS.gestures["nod"].channels} == {*HEAD}
