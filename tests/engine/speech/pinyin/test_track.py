"""The whole way: a text, or what somebody says, moves a face."""

import numpy as np
import pytest

from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.driver import AFTERWARDS, PinyinMouth
from phonemeengine.speech.pinyin.track import pinyin_track
from tests.engine.speech.pinyin.saying import SAID, TABLE

LIDS = [ARKIT.index("eyeBlinkLeft"), ARKIT.index("eyeBlinkRight")]


def test_a_silent_text_lasts_as_long_as_its_syllables_and_pauses_and_is_an_utterance() -> None:
    track = pinyin_track("你好，世界。", rate=5.0)
    assert track.plan.duration == track.utterance.duration == pytest.approx((4 + 2.4 * 1.5) / 5)
    assert [word.text for word in track.utterance.words] == list("你好世界")
    assert [s.text for word in track.utterance.words for s in word.syllables] == ["ni2", "hao3", "shi4", "jie4"]
    assert [phone.phoneme for phone in track.utterance.phones][-4:] == [
        Phoneme.SCH, Phoneme.I, Phoneme.SCH, Phoneme.E,
    ]  # fmt: skip


def test_an_utterance_keeps_its_times_and_takes_the_marks_of_its_text() -> None:
    track = pinyin_track(SAID, text="你好，吗。")
    assert track.utterance is SAID
    assert [row.text for row in track.plan.rows] == ["", "你", "好", "，", "吗", "。"]
    assert track.plan.duration == SAID.duration


def test_an_animation_shows_the_mouth_blinks_and_turns_the_head() -> None:
    track = pinyin_track("你好，世界。" * 3)
    speech = Transcript("text", track.plan.duration + AFTERWARDS)
    animation = track.animation(speech, 60.0, IdleMotion(seed=1))
    mouth = PinyinMouth(track.plan, TABLE)
    expected = np.array([mouth.weights(time) for time in animation.times.tolist()])
    np.testing.assert_array_equal(np.delete(animation.weights, LIDS, 1), np.delete(expected, LIDS, 1))
    assert animation.weights[:, LIDS].max() > 0.5
    assert animation.head.any()
    still = track.animation(speech, 60.0, MOUTH_ALONE)
    assert not still.head.any()
    assert not still.weights[:, LIDS].any()


def test_live_link_face_gets_the_movement_of_the_letters() -> None:
    track = pinyin_track("啊")
    speech = Transcript("text", track.plan.duration + AFTERWARDS)
    exporter = Exporter("livelink-csv", ExportOptions(rate=4.0))
    lines = b"".join(exporter.chunks_of(speech, track.animation(speech, 4.0, MOUTH_ALONE))).decode().splitlines()
    jaw = lines[0].split(",").index("JawOpen")
    assert [float(line.split(",")[jaw]) for line in lines[1:]] == [0.0, 0.66, 0.0]
