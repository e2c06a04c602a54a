"""What is said in the tests of the pinyin mouth: a greeting as syllables and marks, and as a voice may say it."""

from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.script import WrittenMark, WrittenSyllable
from phonemeengine.speech.pinyin.table import load_pinyin_table

TABLE = load_pinyin_table()
SCRIPT = (
    WrittenSyllable("你", "ni2"), WrittenSyllable("好", "hao3"), WrittenMark("，", 0.5), WrittenSyllable("吗", "ma5"),
    WrittenMark("。", 1.0),
)  # fmt: skip


def spoken(start: float, middle: float, end: float, text: str) -> Syllable:
    """A syllable of two phones of which nobody knows what they are."""
    phones = ((start, middle), (middle, end))
    return Syllable(tuple(Phone(a, b, "", Phoneme.UNIDENTIFIED) for a, b in phones), text=text)


NIHAO = Word("你好", (spoken(0.1, 0.2, 0.35, "ni2"), spoken(0.35, 0.45, 0.7, "hao3")))
MA = Word("吗", (spoken(0.95, 1.0, 1.15, "ma5"),))
SAID = Utterance((NIHAO, MA), 1.5, "cmn")
