"""A face that follows the feeling in a voice, by arithmetic."""

import numpy as np
import pytest

from phonemeengine import Expression, IdleMotion, MouthError, Performer, held_expression, load_table
from phonemeengine.features.feeling import Feeling
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.expression.felt import FeelingAmounts, FeltFace
from phonemeengine.mouth.idle_motion import HeadPose

GLAD = Feeling(1.0, 0.0, 1.0, 0.0)
SORRY = Feeling(-1.0, 0.0, -1.0, 0.0)


def settled(amounts: FeelingAmounts, feeling: Feeling) -> dict[str, float]:
    face = FeltFace(amounts)
    face.add(0.0, feeling)
    return dict(zip(ARKIT, face.weights(10.0).tolist(), strict=True))


def test_brows_lids_and_smile_follow_as_far_as_is_asked_for():
    glad, sorry = settled(FeelingAmounts(), GLAD), settled(FeelingAmounts(), SORRY)
    assert glad["mouthSmileLeft"] == pytest.approx(0.7)
    assert glad["browOuterUpRight"] == pytest.approx(0.6)
    assert (sorry["mouthSmileLeft"], sorry["mouthFrownLeft"]) == (0, pytest.approx(0.6))
    half = settled(FeelingAmounts.of("smile=0.5"), GLAD)
    assert half["mouthSmileLeft"] == pytest.approx(0.35)
    assert half["browOuterUpRight"] == 0


def test_a_head_moves_more_and_is_raised_with_activation():
    face = FeltFace(FeelingAmounts.of("head=0.5"))
    face.add(0.0, GLAD)
    assert face.turned(HeadPose(1.0, 0.0, -1.0), 10.0) == pytest.approx((1.4, 2.0, -1.4))


def test_a_feeling_is_one_more_stream_beside_sliders_and_gives_way_to_speech():
    def shown(**more: object) -> np.ndarray:
        expression = Expression((held_expression({"mouthSmile": 0.2}),), feeling=FeelingAmounts(), **more)
        performer = Performer(load_table("arkit"), IdleMotion(False, False, expression=expression))
        performer.feel(np.array([GLAD] * 100, np.float32), 1.0)
        return performer.at(10.0).weights

    smile = ARKIT.index("mouthSmileLeft")
    assert shown()[smile] == pytest.approx(0.9)
    # three streams: the two expressions share what speech leaves, (1 - pS) / 2 and (1 - pE) / 2 of three
    assert shown(speech_priority=1.0, other_priority=1.0)[smile] == 0


def test_unknown_parts_and_amounts_are_refused_in_one_sentence():
    for words, sentence in (
        ("ears=1", "no part of a face called 'ears' follows a feeling; .*brows"),
        ("smile=much", "'smile=much' holds no number for smile; write such as smile=0.5"),
        ("2", "the brows follow a feeling by 0..1, found 2; correct it"),
        ("nan", "the brows follow a feeling by 0..1, found nan; correct it"),
    ):
        with pytest.raises(MouthError, match=sentence):
            FeelingAmounts.of(words)
    with pytest.raises(MouthError, match="needs a stream"):
        Expression((), feeling=FeelingAmounts.of("0"))
