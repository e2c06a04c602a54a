"""What a face shows that speaks and expresses something: by arithmetic."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import (
    ExportOptions,
    Expression,
    IdleMotion,
    MouthError,
    Performer,
    Phoneme,
    Transcript,
    held_expression,
    load_channels,
    load_table,
)
from phonemeengine.mouth.animation import Animation, animation_of
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.expression.composer import Composer
from phonemeengine.mouth.expression.streams import (
    SHIPPED_CHANNELS,
    expression_presets,
    recorded_expression,
    shipped_channels,
)
from phonemeengine.mouth.performer import TimedFrame
from phonemeengine.recognition.segments import Segment

SMILE, JAW, BROW = (ARKIT.index(name) for name in ("mouthSmileLeft", "jawOpen", "browInnerUp"))
NOTHING = np.zeros(len(ARKIT), np.float32)
RATE = 60.0


def weights(**shares: float) -> np.ndarray:
    found = NOTHING.copy()
    for name, share in shares.items():
        found[ARKIT.index(name)] = share
    return found


def smiling(share: float = 1.0, **more: float) -> Expression:
    return Expression((held_expression({"mouthSmile": share}),), **more)


def test_smile_and_speech_on_one_channel_add_up_and_are_shown_to_1():
    composer = Composer(smiling(0.5))
    assert composer.composed(weights(mouthSmileLeft=0.3), 0.0, 0.0)[SMILE] == pytest.approx(0.8)
    assert composer.composed(weights(mouthSmileLeft=0.75), 0.0, 0.0)[SMILE] == 1


def test_speech_that_has_all_priority_silences_expressions_on_its_own_channels():
    wide = Expression((held_expression({"jawOpen": 1.0, "browInnerUp": 1.0}),), speech_priority=1.0)
    shown = Composer(wide).composed(weights(jawOpen=0.2), 0.0, 0.0)
    assert (shown[JAW], shown[BROW]) == (pytest.approx(0.2), 1)


def test_an_expression_that_has_all_priority_leaves_speech_its_share_of_other_channels():
    shown = Composer(smiling(0.0, speech_priority=0.5, other_priority=0.0)).composed(
        weights(jawOpen=0.6, browInnerUp=0.6, mouthSmileLeft=0.6), 0.0, 0.0
    )
    assert shown[[JAW, BROW, SMILE]] == pytest.approx([0.6, 0.0, 0.3])


def test_speech_holds_back_what_moves_its_mouth_and_leaves_the_brows():
    all_at_once = Expression((held_expression({"jawOpen": 0.4, "mouthSmile": 0.8, "browInnerUp": 0.5}),))
    shown = Composer(all_at_once).composed(NOTHING, 0.0, 1.0)
    assert shown[[JAW, SMILE, BROW]] == pytest.approx([0.0, 0.4, 0.45])


def test_streams_add_up():
    two = Expression((held_expression({"smile": 0.4}), held_expression({"surprise": 0.5})))
    shown = Composer(two).composed(NOTHING, 0.0, 0.0)
    presets = expression_presets()
    assert shown == pytest.approx(0.4 * presets["smile"] + 0.5 * presets["surprise"], abs=1e-6)


def test_a_mouth_table_that_exaggerates_stays_as_it_is():
    assert Composer(smiling()).composed(weights(jawOpen=1.3), 0.0, 1.0)[JAW] == pytest.approx(1.3)


def test_a_recorded_expression_lies_on_straight_lines_between_its_frames():
    stream = recorded_expression(np.array([1.0, 2.0]), ("browInnerUp", "headYaw"), np.array([[0.0, 9.0], [1.0, 9.0]]))
    assert [float(stream.weights(time)[BROW]) for time in (0.0, 1.0, 1.25, 2.0, 3.0)] == [0, 0, 0.25, 1, 1]
    assert stream.weights(1.5).sum() == pytest.approx(0.5)


@pytest.mark.parametrize("preset", ["smile", "anger", "sorrow", "surprise", "fear", "disgust"])
def test_the_basic_emotions_are_symmetric_and_leave_no_eye_shut(preset):
    held = dict(zip(ARKIT, expression_presets()[preset], strict=True))
    assert all(held[name] == held[name.replace("Left", "Right")] for name in ARKIT if name.endswith("Left"))
    assert held["eyeBlinkLeft"] == 0
    assert 0 < max(held.values()) <= 1


def test_every_blend_shape_has_a_class():
    channels = shipped_channels()
    assert np.all((channels.speech >= 0) & (channels.speech <= 1))
    assert (channels.speech[JAW], channels.reductions[JAW]) == (1, 1)
    assert (channels.speech[BROW], channels.reductions[BROW]) == (0, pytest.approx(0.1))


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (('"tongueOut",', ""), "lacks tongueOut"),
        (('"mouthSmile", ', '"mouthSmile", "jawOpen", '), "jawOpen twice"),
        (('"tongueOut"', '"tongueUp"'), "no blend shape"),
        (("speech = 0.5", "speech = 1.5"), "a number in 0..1"),
        (("expression channels 1", "expression channels 9"), "format"),
    ],
)
def test_classes_that_are_not_whole_are_refused_in_one_sentence(tmp_path: Path, change, sentence):
    path = tmp_path / "mine.toml"
    path.write_text(SHIPPED_CHANNELS.read_text(encoding="utf-8").replace(*change, 1), encoding="utf-8")
    with pytest.raises(MouthError, match=sentence) as refused:
        load_channels(path)
    assert "mine.toml" in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(("shares", "sentence"), [({"joy": 0.5}, "smile, anger"), ({"smile": 1.5}, "0..1")])
def test_an_expression_that_nobody_knows_is_refused_and_the_known_ones_are_named(shares, sentence):
    with pytest.raises(MouthError, match=sentence):
        held_expression(shares)


def said(*runs: tuple[float, float, Phoneme]) -> Transcript:
    return Transcript("said", 3.0, tuple(Segment(start, end, phoneme, 1.0) for start, end, phoneme in runs))


def film(speech: Transcript, expression: Expression | None, duration: float = 3.0) -> Animation:
    table = load_table("arkit")
    idle = IdleMotion(blinks=False, head=False, expression=expression)
    return animation_of(replace(speech, duration=duration), table, RATE, idle)


MAMA = said(*((0.5 + 0.2 * k, 0.7 + 0.2 * k, (Phoneme.M, Phoneme.A)[k % 2]) for k in range(6)))
"""mamama, 0.5 s to 1.7 s."""


def test_lips_close_with_a_full_smile_as_without():
    plain, smile = (
        film(MAMA, expression).weights for expression in (None, Expression((held_expression({"smile": 1}),)))
    )
    lips = [ARKIT.index(name) for name in ("jawOpen", "mouthClose", "mouthPressLeft", "mouthRollLower")]
    during = slice(round(0.65 * RATE), round(1.7 * RATE))
    assert plain[during, JAW].max() > 0.2
    assert smile[during][:, lips] == pytest.approx(plain[during][:, lips], abs=1e-6)


def test_a_smile_gives_way_while_somebody_speaks_and_comes_back():
    at = film(MAMA, smiling(), 4.0).weights[:, SMILE]
    plain = film(MAMA, None, 4.0).weights[:, SMILE]
    assert at[round(0.4 * RATE)] == pytest.approx(1.0)
    assert at[round(1.2 * RATE)] == pytest.approx(min(1, 0.5 + plain[round(1.2 * RATE)]), abs=0.01)
    assert at[round(2.3 * RATE)] == pytest.approx(1.0, abs=0.01)


def test_a_film_ends_when_the_expression_has_come_back():
    short = replace(MAMA, duration=1.8)
    table = load_table("arkit")
    lengths = [
        len(animation_of(short, table, RATE, IdleMotion(expression=one)).weights) / RATE for one in (None, smiling())
    ]
    assert lengths == pytest.approx([1.88, 1.7 + 0.7], abs=3 / RATE)


def test_a_live_smile_gives_way_to_what_is_heard():
    performer = Performer(load_table("arkit"), IdleMotion(blinks=False, head=False, expression=smiling()))
    seen = {}
    for k in range(300):
        time = k / 100
        phoneme = Phoneme.M if 50 <= k < 150 else Phoneme.SILENCE
        performer.add([TimedFrame(time, phoneme, 1.0)], time, live=True)
        seen[k] = float(performer.at(time).weights[SMILE]), performer.inhibition
    assert seen[40] == (1, 0)
    assert seen[100][1] == 1
    assert seen[100][0] <= 0.6
    assert seen[190][1] == 1  # nobody knows yet that speech has ended
    assert 0 < seen[225][1] < 1
    assert seen[299] == (1, 0)


def test_sliders_go_on_from_where_speech_holds_them():
    performer = Performer(load_table("arkit"), IdleMotion(expression=smiling()))
    for k in range(50):
        performer.add([TimedFrame(k / 100, Phoneme.A, 1.0)], k / 100, live=True)
        performer.at(k / 100)
    performer.configure(performer.table, IdleMotion(expression=smiling(0.3)))
    performer.at(0.5)
    assert performer.inhibition == 1


@pytest.mark.parametrize(("kind", "table"), [("rhubarb-json", None), ("oculus-csv", None), ("curves-json", "oculus")])
def test_formats_and_tables_without_such_channels_refuse_expressions(kind, table):
    with pytest.raises(Exception, match=r"expressions"):
        Exporter(kind, ExportOptions(table=table, idle=IdleMotion(expression=smiling())))


def test_an_expression_of_nothing_is_refused():
    with pytest.raises(MouthError, match="needs a stream"):
        Expression(())
    with pytest.raises(MouthError, match=r"0\.\.1"):
        smiling(speech_priority=1.2)


@pytest.mark.parametrize("stop", [Performer.close_mouth, Performer.forget_coming])
def test_nothing_is_reduced_after_speech_was_stopped(stop):
    performer = Performer(load_table("arkit"), IdleMotion(blinks=False, head=False, expression=smiling()))
    performer.add([TimedFrame(k / 100, Phoneme.A, 1.0) for k in range(300)], 0.0)
    performer.at(1.0)
    assert performer.inhibition == pytest.approx(1.0)
    stop(performer, 1.0)
    performer.at(3.0)
    assert performer.inhibition == 0.0
