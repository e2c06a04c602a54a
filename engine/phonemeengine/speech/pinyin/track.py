"""Chinese text, or a spoken recording of it, as the track of a mouth: one call to show, play or write it."""

from dataclasses import dataclass
from functools import cached_property

from typing_extensions import override

from phonemeengine.errors import TextError
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.animation import MovementTrack
from phonemeengine.mouth.table import MouthTable
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.speech.pinyin.script import script_of
from phonemeengine.speech.pinyin.table import PinyinTable, load_pinyin_table
from phonemeengine.speech.pinyin.timing import USUAL_RATE, PinyinMouth, Plan, has_pinyin, plan_of
from phonemeengine.speech.silent import SilentSpeech, SilentText
from phonemeengine.text.cleaning import spoken_part

LANGUAGE = "cmn"


@dataclass(frozen=True)
class PinyinTrack(MovementTrack):
    """What a mouth says by pinyin.

    Attributes
    ----------
    utterance : what is said, with times.
    plan : the same, with letters and pauses.
    table : the shapes, and how the mouth goes there.
    """

    utterance: Utterance
    plan: Plan
    table: PinyinTable

    @property
    @override
    def face(self) -> MouthTable:
        return self.table.mouth

    @cached_property
    @override
    def rests_from(self) -> float:
        return self.mouth().rests_from

    @override
    def mouth(self) -> PinyinMouth:
        return PinyinMouth(self.plan, self.table)

    def silent_transcript(self, name: str) -> Transcript:
        """Return what is said, as if a voice of even loudness said it; see `SilentSpeech.transcript`."""
        return SilentSpeech(self.utterance, self.plan).transcript(name)


def pinyin_track(
    said: str | Utterance,
    table: PinyinTable | None = None,
    *,
    text: str = "",
    rate: float = USUAL_RATE,
    seed: int | None = None,
    literal: bool = False,
) -> PinyinTrack:
    """Have a mouth say a text without sound, or what is said in a sound.

    Parameters
    ----------
    said : a Chinese text; or an utterance whose syllables hold pinyin with the tone as a digit, whose times count.
    table : the letters, shapes and times; those that ship, where it is None.
    text : of an utterance, for the marks of its pauses.
    rate : syllables per second of a text, 0.5..10.
    seed : of the variation of onsets; none varies where it is None.
    literal : take the notation of scripts as words, too.

    Raises
    ------
    TextError : there is no Chinese syllable in it, or the rate lies outside its range.
    """
    table = table or load_pinyin_table()
    if isinstance(said, Utterance):
        script = script_of(text if literal else spoken_part(text, LANGUAGE).text, table)
        speech = SilentSpeech(said, plan_of(said, table, script.written, seed))
    else:
        speech = SilentText(said, LANGUAGE, table, rate, seed, literal=literal).whole()
    if not has_pinyin(speech.utterance):
        if isinstance(said, str):
            raise TextError("there is no Chinese syllable in the text; write some, or choose another driver")
        raise TextError("there is no syllable of pinyin in what is said; choose another driver")
    return PinyinTrack(speech.utterance, speech.plan, table)
