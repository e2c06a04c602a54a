"""What is said in the tests of the pinyin mouth: a greeting as syllables and marks, and as a voice may say it."""

from collections.abc import Iterable

from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.script import Written, WrittenMark, WrittenSyllable
from phonemeengine.speech.pinyin.table import PinyinTable, load_pinyin_table
from phonemeengine.speech.pinyin.timing import Plan, pause_unit, said_at_rate

TABLE = load_pinyin_table()
SCRIPT = (
    WrittenSyllable("你", "ni2"),
    WrittenSyllable("好", "hao3"),
    WrittenMark("，", 0.5),
    WrittenSyllable("吗", "ma5"),
    WrittenMark("。", 1.0),
)


def spoken(start: float, middle: float, end: float, text: str) -> Syllable:
    """A syllable of two phones of which nobody knows what they are."""
    phones = ((start, middle), (middle, end))
    return Syllable(tuple(Phone(a, b, "", Phoneme.UNIDENTIFIED) for a, b in phones), text=text)


NIHAO = Word("你好", (spoken(0.1, 0.2, 0.35, "ni2"), spoken(0.35, 0.45, 0.7, "hao3")))
MA = Word("吗", (spoken(0.95, 1.0, 1.15, "ma5"),))
SAID = Utterance((NIHAO, MA), 1.5, "cmn")


def plan_at_rate(
    script: Iterable[Written], table: PinyinTable = TABLE, rate: float = 4.0, seed: int | None = None
) -> Plan:
    """The whole plan of a text that nobody speaks."""
    rows = tuple(row for part in said_at_rate(script, table, rate, seed) for row in part.rows)
    return Plan(rows, pause_unit(table, rate))
