import pypinyin
import pytest
from pypinyin.contrib.tone_convert import to_tone3

from phonemeengine.labels.phone_sets import ipa_class
from phonemeengine.text.espeak import Event, EventKind, language_of, synthesise
from phonemeengine.text.mandarin import (
    PinyinWord,
    read_characters,
    read_number,
    read_pinyin,
    spelt_for_voice,
    syllable_of,
)
from phonemeengine.text.pronunciation import words_of

FIRST, LAST = 0x4E00, 0x9FFF
"""The basic block of Chinese characters."""


def _all_syllables() -> set[str]:
    readings = pypinyin.pinyin_dict.pinyin_dict
    spelt = {one for code in range(FIRST, LAST + 1) for one in readings.get(code, "").split(",") if one}
    return {to_tone3(one, v_to_u=True).rstrip("12345") for one in spelt}


def test_each_of_the_420_syllables_is_made_of_known_phones() -> None:
    syllables = _all_syllables()
    assert len(syllables) == 420
    for syllable in syllables:
        phones = syllable_of(f"{syllable}1").phones
        assert phones
        assert all(ipa_class(phone) for phone in phones), syllable
        assert phones != ("ə",), syllable


def test_the_voice_says_each_syllable_as_one_word() -> None:
    spoken = []

    def hear(_samples: object, events: tuple[Event, ...]) -> bool:
        spoken.extend(event.position for event in events if event.kind is EventKind.WORD)
        return True

    syllables = sorted(_all_syllables())
    text = " ".join(spelt_for_voice(f"{syllable}3") for syllable in syllables[:: len(syllables) // 60])
    synthesise(text, language_of("cmn-latn-pinyin"), hear, phonemes=True)
    assert len(spoken) == len(text.split())


@pytest.mark.parametrize(
    ("pinyin", "phones"),
    [
        ("hua4", "x w a"),
        ("dong1", "t ʊ ŋ"),
        ("zhi1", "ʈ ʂ ɨ"),
        ("ju2", "t ɕ y"),
        ("yuan2", "ɥ ɛ n"),
        ("you3", "j oʊ"),
        ("wei4", "w eɪ"),
        ("lü4", "l y"),
        ("xiong2", "ɕ j ʊ ŋ"),
        ("er2", "ɚ"),
        ("yi1", "i"),
        ("wu3", "u"),
        ("m2", "m̩"),
    ],
)
def test_syllables_sound_as_the_phonetician_says(pinyin: str, phones: str) -> None:
    assert syllable_of(pinyin).phones == tuple(phones.split())


def test_characters_with_several_readings_come_right_in_their_phrase() -> None:
    words = [word for word in read_characters("银行长大还钱音乐") if isinstance(word, PinyinWord)]
    assert [word.syllables[0] for word in words] == [
        "yin2",
        "hang2",
        "zhang3",
        "da4",
        "huan2",
        "qian2",
        "yin1",
        "yue4",
    ]


def test_words_of_other_scripts_and_marks_are_left_as_they_are() -> None:
    assert [word for word in read_characters("说hello world，好") if isinstance(word, str)] == [
        "hello",
        "world",
        "，",
    ]


def test_a_number_is_one_word_of_several_syllables() -> None:
    (year, *_) = read_characters("2024年")
    assert year == PinyinWord("2024年", ("er4", "ling2", "er4", "si4", "nian2"))


def test_pinyin_is_read_with_digits_or_marks_for_tones() -> None:
    assert [word.syllables[0] for word in read_pinyin("nǐ hao3 lǜ") if isinstance(word, PinyinWord)] == [
        "ni3",
        "hao3",
        "lü4",
    ]


def test_chinese_and_english_words_stand_in_one_script() -> None:
    words = words_of("我说hello。", "cmn")
    assert [word.text for word in words] == ["我", "说", "hello"]
    assert words[0].pronunciations[0].syllables[0].text == "wo3"


@pytest.mark.parametrize(
    ("number", "characters"),
    [
        ("0", "零"),
        ("10", "十"),
        ("11", "十一"),
        ("110", "一百一十"),
        ("1005", "一千零五"),
        ("1010", "一千零一十"),
        ("10010", "一万零一十"),
        ("100000", "十万"),
        ("123456789", "一亿二千三百四十五万六千七百八十九"),
        ("1,234,567", "一百二十三万四千五百六十七"),
        ("007", "零零七"),
        ("1.05", "一点零五"),
        ("-3", "负三"),
        ("99%", "百分之九十九"),
        ("12:05", "十二点零五分"),
        ("8:00", "八点"),
        ("2024年", "二零二四年"),
        ("5年", "五年"),
        ("1000000001", "十亿零一"),
        ("13800138000138000", "一三八零零一三八零零零一三八零零零"),
    ],
)
def test_numbers_are_read_as_a_newsreader_would(number: str, characters: str) -> None:
    assert read_number(number) == characters
