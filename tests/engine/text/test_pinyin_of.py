"""Mandarin and its numbers, read as people read them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine import Voice, pinyin_track, words_of
from phonemeengine.text.mandarin import numbers_spelt, pinyin_of, simplified


@pytest.mark.parametrize(
    ("hanzi", "pinyin"),
    [
        ("银行", "yin2 hang2"),
        ("长大", "zhang3 da4"),
        ("音乐", "yin1 yue4"),
        ("快乐", "kuai4 le4"),
        ("你好", "ni2 hao3"),
        ("不是", "bu2 shi4"),
        ("绿女", "lü4 nü3"),
        ("吗", "ma5"),
        ("儿", "er2"),
        ("", ""),
    ],
)
def test_characters_are_read_as_their_phrase_says(hanzi: str, pinyin: str) -> None:
    assert pinyin_of(hanzi) == pinyin.split()


TRADITIONAL = (
    "銀行 銀行行長 長大 長江 還錢 歸還 音樂 樂器 快樂 重要 重複 行長 會計 空調 認為 "
    "覺得 睡覺 乾淨 餅乾 反應 教書 種樹 上當 相處 自傳 朝陽 幾乎 差別 參差不齊 彈琴 "
    "子彈 可惡 過分 給予 冠軍 劃船 結實 積累 率領 沉沒 災難 勉強 喪事 捨得 石頭 挑戰 "
    "應用 暈車 著急 睡著 鑽石 長髮 測量 寶藏 萬里長城 還原 乾杯 哪裡 繫鞋帶 頭髮 為什麼 "
    "重慶 後來"
)


def test_a_traditional_phrase_is_read_as_the_simplified_one() -> None:
    same = {phrase: simplified(phrase) for phrase in TRADITIONAL.split()}
    assert {phrase for phrase, simple in same.items() if simple == phrase} == {"重要"}
    assert {phrase: pinyin_of(phrase) for phrase in same} == {p: pinyin_of(simple) for p, simple in same.items()}


@pytest.mark.parametrize(
    ("hanzi", "pinyin"), [("乾坤", "qian2 kun1"), ("著作", "zhu4 zuo4"), ("瞭望", "liao4 wang4")]
)
def test_a_character_outside_of_a_phrase_is_read_as_it_is_written(hanzi: str, pinyin: str) -> None:
    assert pinyin_of(hanzi) == pinyin.split()


@given(st.text(st.characters(min_codepoint=0x3400, max_codepoint=0x9FFF), max_size=20))
def test_simplified_characters_stay_and_are_as_many(hanzi: str) -> None:
    assert simplified(simplified(hanzi)) == simplified(hanzi)
    assert len(simplified(hanzi)) == len(hanzi)


@pytest.mark.parametrize("character", "兙嗧龦鿀")
def test_a_character_that_nobody_can_read_is_left_out_and_told(character: str) -> None:
    text = f"我{character}你"
    assert [word.text for word in words_of(text, "cmn")] == ["我", "你"]
    (sentence,) = Voice("cmn").speak(text)
    assert ([word.text for word in sentence.words], sentence.skipped) == (["我", "你"], (character,))
    silent = pinyin_track(text).utterance
    assert ([word.text for word in silent.words], silent.skipped) == (["我", "你"], (character,))


@given(st.text(st.characters(min_codepoint=0x3400, max_codepoint=0x9FFF), max_size=20))
def test_every_character_has_one_syllable(hanzi: str) -> None:
    assert len(pinyin_of(hanzi)) == len(hanzi)


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("2026年", "二零二六年"),
        ("3.5元", "三点五元"),
        ("12:30", "十二点三十分"),
        ("12:05", "十二点零五分"),
        ("8:00", "八点"),
        ("50%", "百分之五十"),
        ("1,234,567", "一百二十三万四千五百六十七"),
        ("007", "零零七"),
        ("10", "十"),
        ("15", "十五"),
        ("110", "一百一十"),
        ("105", "一百零五"),
        ("1000", "一千"),
        ("1001", "一千零一"),
        ("10000", "一万"),
        ("100000", "十万"),
        ("10001", "一万零一"),
        ("110000", "十一万"),
        ("100000000", "一亿"),
        ("100010001", "一亿零一万零一"),
        ("0", "零"),
        ("0.25", "零点二五"),
        ("13812345678", "一三八一二三四五六七八"),
        ("MP3", "MP3"),
        ("３个", "三个"),
        ("192.168.1.1", "一九二一六八一一"),
        ("1,2", "一二"),
        ("没有", "没有"),
    ],
)
def test_numbers_are_read_as_people_read_them(text: str, read: str) -> None:
    assert numbers_spelt(text) == read


@given(st.integers(1, 10**15))
def test_a_number_names_its_digits_in_order(number: int) -> None:
    read = numbers_spelt(f"有{number}个")
    named = [str("零一二三四五六七八九".index(c)) for c in read if c in "一二三四五六七八九"]
    written = [c for c in str(number) if c != "0"]
    assert named[-len(written) :] == written or (read[1] == "十" and named == written[1:]) or len(str(number)) == 11
