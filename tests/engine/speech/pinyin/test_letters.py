"""Letters of pinyin: every syllable of Mandarin has the two that a phonetician would give it."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import TextError
from phonemeengine.labels.pinyin import initial_and_final, is_sound, sound_of
from phonemeengine.speech.pinyin.table import load_pinyin_table

TABLE = load_pinyin_table()

LETTERS = {
    "&a": "a ai an ang ao",
    "&b": "m",
    "&d": "n",
    "&e": "e ei en eng er ê",
    "&g": "ng",
    "&o": "o ou",
    "ba": "ba bai ban bang bao bian biao ma mai man mang mao mian miao pa pai pan pang pao pian piao",
    "be": "bei ben beng bie me mei men meng mie pei pen peng pie",
    "bi": "bi bin bing mi min ming pi pin ping",
    "bo": "bo bu miu mo mou mu po pou pu",
    "da": "da dai dan dang dao dia dian diao duan la lai lan lang lao lia lian liang liao luan na nai nan nang nao "
    "nian niang niao nuan ta tai tan tang tao tian tiao tuan",
    "de": "de dei den deng die dui dun le lei len leng lie lun lüe ne nei nen neng nie nun nüe te tei teng tie tui "
    "tun",
    "di": "di ding li lin ling ni nin ning ti ting",
    "do": "diu dong dou du duo liu lo long lou lu luo lü niu nong nou nu nuo nü tong tou tu tuo",
    "fa": "fa fan fang fiao",
    "fe": "fei fen feng",
    "fo": "fo fou fu",
    "ga": "ga gai gan gang gao gua guai guan guang ha hai han hang hao hua huai huan huang ka kai kan kang kao kua "
    "kuai kuan kuang",
    "gb": "hm",
    "ge": "ge gei gen geng gui gun he hei hen heng hui hun ke kei ken keng kui kun",
    "gg": "hng",
    "go": "gong gou gu guo hong hou hu huo kong kou ku kuo",
    "oa": "wa wai wan wang",
    "oe": "wei wen weng",
    "oo": "wo wu",
    "ra": "cha chai chan chang chao chua chuai chuan chuang ran rang rao rua ruan sha shai shan shang shao shua "
    "shuai shuan shuang zha zhai zhan zhang zhao zhua zhuai zhuan zhuang",
    "re": "che chen cheng chui chun re ren reng rui run she shei shen sheng shui shun zhe zhei zhen zheng zhui zhun",
    "ri": "chi ri shi zhi",
    "ro": "chong chou chu chuo rong rou ru ruo shou shu shuo zhong zhou zhu zhuo",
    "ya": "ca cai can cang cao cuan jia jian jiang jiao juan qia qian qiang qiao quan sa sai san sang sao suan xia "
    "xian xiang xiao xuan ya yan yang yao yuan za zai zan zang zao zuan",
    "ye": "ce cen ceng cui cun jie jue qie que se sen seng sui sun xie xue ye yue ze zei zen zeng zui zun",
    "yi": "ci ji jin jing qi qin qing si xi xin xing yi yin ying zi",
    "yo": "cong cou cu cuo jiong jiu ju jun qiong qiu qu qun song sou su suo xiong xiu xu xun yo yong you yu yun "
    "zong zou zu zuo",
}
"""All 420 syllables without tone that Chinese characters have, by their two letters."""
LETTERS_OF = {syllable: letters for letters, syllables in LETTERS.items() for syllable in syllables.split()}

NARROW = "bu pu mu fu du tu nu lu gu ku hu zhu chu shu ru zu cu su wu nü lü ju qu xu yu jun qun xun yun"
"""The syllables that end with the lips protruding, and a small gap between them."""


def test_the_table_of_the_tests_has_every_syllable_once() -> None:
    assert len(LETTERS_OF) == sum(len(syllables.split()) for syllables in LETTERS.values()) == 420


def test_every_syllable_of_mandarin_has_its_two_letters() -> None:
    assert {syllable: TABLE.letters_of(syllable) for syllable in LETTERS_OF} == LETTERS_OF


@pytest.mark.parametrize(("hanzi", "syllable", "letters"), [("东", "dong", "do"), ("画", "hua", "ga")])
def test_the_examples_of_the_paper_come_out(hanzi: str, syllable: str, letters: str) -> None:
    assert TABLE.letters_of(syllable) == letters


def test_u_and_its_umlaut_keep_their_letter_and_have_a_narrower_shape_of_it() -> None:
    rimes = {syllable: TABLE.shapes_of(syllable)[1] for syllable in LETTERS_OF}
    assert {syllable for syllable, shape in rimes.items() if shape == "u"} == set(NARROW.split())
    assert all(TABLE.letters_of(syllable)[1] == "o" for syllable in NARROW.split())
    assert TABLE.shapes_of("wo") == ("u", "o")
    assert TABLE.shapes_of("hao") == ("g", "a")


@pytest.mark.parametrize(
    "syllable",
    ["wa", "yu", "yue", "yuan", "yun", "ju", "qun", "xuan", "zi", "shi", "ri", "xian", "yan", "er", "bu", "nü", "m"],
)
def test_a_doubtful_syllable_says_why(syllable: str) -> None:
    assert len(TABLE.doubts[syllable].split()) > 4
    assert syllable in LETTERS_OF


def test_what_nobody_doubts_is_not_doubtful() -> None:
    assert not {"ma", "hao", "dong", "fei", "gei", "ying"} & TABLE.doubts.keys()


@pytest.mark.parametrize(
    ("syllable", "parts"),
    [
        ("zhuang", ("zh", "uang")),
        ("liu", ("l", "iou")),
        ("gui", ("g", "uei")),
        ("dun", ("d", "uen")),
        ("jun", ("j", "ün")),
        ("que", ("q", "üe")),
        ("yuan", ("y", "üan")),
        ("you", ("y", "iou")),
        ("ye", ("y", "ie")),
        ("yi", ("y", "i")),
        ("wu", ("w", "u")),
        ("wei", ("w", "uei")),
        ("ang", ("", "ang")),
        ("er", ("", "er")),
        ("lü", ("l", "ü")),
        ("lue", ("l", "üe")),
    ],
)
def test_a_syllable_falls_into_its_initial_and_its_full_final(syllable: str, parts: tuple[str, str]) -> None:
    assert initial_and_final(syllable) == parts


@pytest.mark.parametrize(
    ("written", "sound"),
    [
        ("hao3", "hao3"),
        ("hǎo", "hao3"),
        ("lv4", "lü4"),
        ("LÜ4", "lü4"),
        ("lǜ", "lü4"),
        ("lu:4", "lü4"),
        ("ma", "ma5"),
        ("ế", "ê2"),
        ("ê", "ê5"),
        ("ǹg", "ng4"),
        (unicodedata.normalize("NFD", "nǚ"), "nü3"),
    ],
)
def test_a_tone_may_be_written_as_a_digit_or_a_mark(written: str, sound: str) -> None:
    assert sound_of(written) == sound


@pytest.mark.parametrize("written", ["", "5", "hello", "r5", "hao6", "hǎo3", "好", "b1", "ong\0", "hao3 hao3"])
def test_what_is_no_syllable_is_refused(written: str) -> None:
    assert not is_sound(written)
    with pytest.raises(TextError, match=r"write .* such as hao3"):
        sound_of(written)


@given(st.text(max_size=8))
def test_any_text_is_a_syllable_or_refused(written: str) -> None:
    assert is_sound(written) in (True, False)
    if is_sound(written):
        assert len(TABLE.letters_of(written[:-1])) == 2
