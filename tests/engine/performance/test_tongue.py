import numpy as np
import pytest

from phonemeengine.arrays import Float32Array
from phonemeengine.labels.phone_sets import ARTICULATIONS, IPA_LETTERS
from phonemeengine.mouth.blendshape_names import TONGUE
from phonemeengine.mouth.poses import USUAL_TONGUE, load_poses
from phonemeengine.performance.driver import tongue_weights
from phonemeengine.performance.recording import SILENCE, PerformedPhone

POSES = load_poses(USUAL_TONGUE)
FRAME = 1 / 60
WITHOUT_POSE = {*ARTICULATIONS["bilabial"], *ARTICULATIONS["labiodental"], *ARTICULATIONS["glottal"]}


def _said(letters: str, length: float = 0.1) -> tuple[PerformedPhone, ...]:
    """Give phones between silence of 0.3 s; each letter is one."""
    bounds = [0.0, *(0.3 + length * np.arange(len(letters) + 1)).tolist()]
    bounds.append(bounds[-1] + 0.3)
    names = [SILENCE, *letters, SILENCE]
    return tuple(
        PerformedPhone(start, (start + end) / 2, end, name)
        for name, start, end in zip(names, bounds, bounds[1:], strict=False)
    )


def _at(letters: str, time: float, length: float = 0.1) -> dict[str, float]:
    """Give what the tongue does at a time after the first sound begins."""
    row = tongue_weights(_said(letters, length), POSES, np.array([0.3 + time]), FRAME)[0]
    return {name: round(float(weight), 3) for name, weight in zip(TONGUE, row, strict=True) if weight > 0.02}


def _shape(letter: str) -> Float32Array:
    pose = POSES.pose_of(letter)
    assert pose is not None
    return np.nan_to_num(POSES.weights(pose.shape, TONGUE))


def test_every_sound_but_those_of_lips_and_glottis_has_a_pose() -> None:
    assert {letter for letter in IPA_LETTERS if POSES.pose_of(letter) is None} == WITHOUT_POSE
    assert POSES.movestates == TONGUE


@pytest.mark.parametrize(
    ("letter", "channel"),
    [
        ("θ", "tongueTipInterdental"),
        ("ð", "tongueTipInterdental"),
        ("t", "tongueTipAlveolar"),
        ("n", "tongueTipAlveolar"),
        ("l", "tongueTipAlveolar"),
        ("ɾ", "tongueTipAlveolar"),
        ("ʃ", "tongueFrontDorsalPalate"),
        ("ɕ", "tongueFrontDorsalPalate"),
        ("j", "tongueMidDorsalPalate"),
        ("k", "tongueBackDorsalVelar"),
        ("ŋ", "tongueBackDorsalVelar"),
        ("u", "tongueBackDorsalVelar"),
        ("ʁ", "tongueRetreat"),
        ("ɹ", "tongueRetreat"),
        ("i", "tongueMidDorsalPalate"),
    ],
)
def test_each_place_of_articulation_has_its_movestate(letter: str, channel: str) -> None:
    weights = _shape(letter)
    assert TONGUE[int(np.argmax(weights))] == channel or weights[TONGUE.index(channel)] == weights.max()


def test_the_tongue_touches_at_its_sound_and_rests_in_silence() -> None:
    assert _at("ata", 0.135) == {"tongueTipAlveolar": 1.0}
    assert _at("ata", -0.25) == _at("ata", 0.59) == {}
    assert not tongue_weights(_said(""), POSES, np.arange(10) / 20, FRAME).any()


def test_the_farther_in_front_the_tongue_touches_the_higher_its_priority() -> None:
    poses = [POSES.pose_of(letter) for letter in ("t", "ʃ", "j", "k", "χ", "a")]
    priorities = [pose.priority for pose in poses if pose is not None]
    assert priorities == sorted(priorities, reverse=True)
    assert len({*priorities}) == len(poses)


def test_of_sounds_that_overlap_the_one_in_front_takes_its_whole_share() -> None:
    weights = tongue_weights(_said("kt", 0.02), POSES, np.array([0.3 + 0.02 * 1.35]), FRAME)[0]
    assert weights[TONGUE.index("tongueTipAlveolar")] == pytest.approx(1.0)
    assert weights[TONGUE.index("tongueBackDorsalVelar")] < 1e-3


def test_sounds_of_the_lips_leave_the_tongue_on_its_way() -> None:
    begin, middle, end = (_at("iba", time).get("tongueMidDorsalPalate", 0.0) for time in (0.05, 0.135, 0.235))
    assert begin > middle > end
    assert middle > 0.15


def test_the_tongue_does_not_drop_between_two_sounds_of_one_pose() -> None:
    times = 0.3 + np.arange(0.035, 0.135, 0.005)
    raised = tongue_weights(_said("iɪ"), POSES, times, FRAME)[:, TONGUE.index("tongueMidDorsalPalate")]
    assert raised.min() == pytest.approx(0.45, abs=1e-3)


def test_weights_lie_between_0_and_1_and_do_not_jump() -> None:
    sentence = _said("ðəstɹɛŋθəvkwaɪtʃɪldɹən")
    weights = tongue_weights(sentence, POSES, np.arange(0, sentence[-1].end, 1 / 240), 1 / 240)
    assert weights.min() >= 0
    assert weights.max() <= 1.0001
    assert np.abs(np.diff(weights, axis=0)).max() < 0.25
    assert weights.shape == (len(weights), 6)
