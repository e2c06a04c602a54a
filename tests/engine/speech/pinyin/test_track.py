"""The whole way: a text, or what somebody says, moves a face."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from phonemeengine.labels.utterance import Utterance, Word
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.spring import Spring
from phonemeengine.speech.pinyin.timing import AFTERWARDS, PinyinMouth
from phonemeengine.speech.pinyin.track import pinyin_track
from tests.engine.speech.pinyin.saying import SAID, TABLE, spoken

LIDS = [ARKIT.index("eyeBlinkLeft"), ARKIT.index("eyeBlinkRight")]


def test_a_silent_text_lasts_as_long_as_its_syllables_and_pauses_and_is_an_utterance() -> None:
    track = pinyin_track("你好，世界。", rate=5.0)
    assert track.plan.duration == track.utterance.duration == pytest.approx((4 + 2.4 * 1.5) / 5)
    assert [word.text for word in track.utterance.words] == list("你好世界")
    assert [s.text for word in track.utterance.words for s in word.syllables] == ["ni2", "hao3", "shi4", "jie4"]
    assert [phone.ipa for phone in track.utterance.phones][-6:] == ["ʂ", "ɨ", "t", "ɕ", "j", "ɛ"]


def test_an_utterance_keeps_its_times_and_takes_the_marks_of_its_text() -> None:
    track = pinyin_track(SAID, text="你好，吗。")
    assert track.utterance is SAID
    assert [row.text for row in track.plan.rows] == ["", "你", "好", "，", "吗", "。"]
    assert track.plan.duration == SAID.duration


def test_an_animation_shows_the_mouth_blinks_and_turns_the_head() -> None:
    track = pinyin_track("你好，世界。" * 3)
    speech = track.silent_transcript("text")
    animation = track.animation(speech, 60.0, IdleMotion(seed=1))
    mouth = PinyinMouth(track.plan, TABLE)
    expected = np.array([mouth.weights(time) for time in animation.times.tolist()])
    np.testing.assert_array_equal(np.delete(animation.weights, LIDS, 1), np.delete(expected, LIDS, 1))
    assert animation.weights[:, LIDS].max() > 0.5
    assert animation.head.any()
    still = track.animation(speech, 60.0, MOUTH_ALONE)
    assert not still.head.any()
    assert not still.weights[:, LIDS].any()


@pytest.mark.parametrize("rate", [8.0, 24.0, 60.0])
@pytest.mark.parametrize("spring", [False, True])
def test_a_sound_that_ends_with_its_last_syllable_is_shown_until_the_mouth_is_at_rest(
    rate: float, spring: bool
) -> None:
    table = replace(TABLE, spring=Spring()) if spring else TABLE
    tight = Utterance((Word("好", (spoken(0.0, 0.2, 0.6, "hao3"),)),), 0.6, "cmn")
    jaw = (
        pinyin_track(tight, table)
        .animation(Transcript("好", 0.6), rate, MOUTH_ALONE)
        .weights[:, ARKIT.index("jawOpen")]
    )
    assert jaw.max() > 0.5
    assert jaw[-1] < 0.02


def test_live_link_face_gets_the_movement_of_the_letters() -> None:
    track = pinyin_track("啊")
    speech = track.silent_transcript("text")
    exporter = Exporter("livelink-csv", ExportOptions(rate=4.0))
    lines = b"".join(exporter.chunks_of(speech, track.animation(speech, 4.0, MOUTH_ALONE))).decode().splitlines()
    jaw = lines[0].split(",").index("JawOpen")
    assert [float(line.split(",")[jaw]) for line in lines[1:]] == [0.0, 0.66, 0.0]


def test_a_silent_text_is_even_speech_of_its_phones_until_the_mouth_is_at_rest() -> None:
    track = pinyin_track("妈，法。")
    said = track.silent_transcript("妈")
    assert said.duration == pytest.approx(0.25 + 0.3 + 0.25 + 0.6 + AFTERWARDS)
    assert [run.phoneme for run in said.runs] == [
        Phoneme.M,
        Phoneme.A,
        Phoneme.SILENCE,
        Phoneme.UNIDENTIFIED,
        Phoneme.A,
        Phoneme.SILENCE,
    ]
    assert all(run.end == following.start for run, following in pairwise(said.runs))
    assert said.runs[-1].end == said.duration
    assert said.intensities[said.times < 0.249].min() == 1
    assert said.intensities[(said.times > 0.251) & (said.times < 0.549)].max() == 0


@pytest.mark.parametrize("name", ["rhubarb-json", "moho-dat", "textgrid", "anno"])
def test_drawings_are_made_of_the_phones(name: str) -> None:
    said = pinyin_track("妈妈，你好。").silent_transcript("text")
    assert b"".join(Exporter(name).chunks_of(said))
    shapes = {cue.phoneme for cue in Exporter(name).export_of(said).cues}
    assert {Phoneme.M, Phoneme.A, Phoneme.I, Phoneme.SILENCE} <= shapes
