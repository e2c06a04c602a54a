"""Chinese text, or what somebody says, as the track of a mouth: one call for whoever shows, plays or writes it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from phonemeengine.labels.pinyin import timed_syllable
from phonemeengine.labels.utterance import Utterance, Word
from phonemeengine.mouth.animation import Animation, animation_by
from phonemeengine.mouth.performer import IdleMotion, Performer
from phonemeengine.mouth.transcript import Transcript, transcript_of_utterance
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.speech.pinyin.driver import AFTERWARDS, PinyinMouth
from phonemeengine.speech.pinyin.plan import Plan, PlanKind
from phonemeengine.speech.pinyin.script import script_of
from phonemeengine.speech.pinyin.table import PinyinTable, load_pinyin_table
from phonemeengine.speech.pinyin.timing import USUAL_RATE, plan_at_rate, plan_of
from phonemeengine.text.notation import spoken_part

LANGUAGE = "cmn"


@dataclass(frozen=True)
class PinyinTrack:
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

    def mouth(self) -> PinyinMouth:
        """Return a mouth that says it, for a performer to play."""
        return PinyinMouth(self.plan, self.table)

    def silent_transcript(self, name: str) -> Transcript:
        """Return what is said, as if a voice of even loudness said it, until the mouth is at rest.

        Parameters
        ----------
        name : what files that are made of it call the sound.
        """
        said = replace(self.utterance, duration=self.plan.duration + AFTERWARDS)
        loud = np.zeros(round(said.duration / FRAME_PERIOD), np.float32)
        for phone in said.phones:
            loud[round(phone.start / FRAME_PERIOD) : round(phone.end / FRAME_PERIOD)] = 1
        return transcript_of_utterance(said, loud, np.zeros_like(loud), name)

    def animation(self, speech: Transcript, rate: float, idle: IdleMotion | None = None) -> Animation:
        """Animate a face: its mouth says the plan, it blinks, and its head moves with the sound.

        Parameters
        ----------
        speech : how long the animation is, and how loud and high the voice.
        rate : frames per second, 1..240.
        idle : what else the face does; blinks and a moving head, where it is None.

        Raises
        ------
        MouthError : the rate lies outside its range.
        """
        performer = Performer(self.table.mouth, idle)
        performer.play(self.mouth())
        return animation_by(performer, speech, rate)


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
    written = text if isinstance(said, Utterance) else said
    script = script_of(written if literal else spoken_part(written, LANGUAGE).text, table)
    if isinstance(said, Utterance):
        return PinyinTrack(said, plan_of(said, table, script.written, seed), table)
    plan = plan_at_rate(script.written, table, rate, seed)
    return PinyinTrack(Utterance(tuple(_words_of(plan)), plan.duration, LANGUAGE, script.skipped), plan, table)


def _words_of(plan: Plan) -> Iterator[Word]:
    """Return what a plan says of a text that nobody speaks: each syllable is a word."""
    for row in plan.rows:
        if row.kind is PlanKind.SYLLABLE:
            yield Word(row.text, (timed_syllable(row.sound, row.start, row.turn, row.end),))
