from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import MouthError
from phonemeengine.mouth.poses import FORMAT, USUAL_POSES, Pose, load_poses, poses_of
from phonemeengine.performance.driver import pose_shares, posed_weights
from phonemeengine.performance.recording import SILENCE, PerformedPhone
from phonemeengine.performance.units import Sentence

FRAME = 1 / 60
POSES = poses_of(f"""format = "{FORMAT}"
movestates = ["jawOpen", "smileLeft", "smileRight"]
[phones]
bilabial = {{ shape = "shut", priority = 3, firm = true }}
u = {{ shape = "round" }}
o = {{ shape = "round" }}
[shapes.shut]
jawOpen = 0
[shapes.round]
jawOpen = 40
smile = 10
""")


def said(*phones: tuple[str, float]) -> Sentence:
    """Give phones with their durations, between silence of 0.2 s."""
    ends = np.cumsum([0.0, 0.2, *(duration for _, duration in phones), 0.2])
    names = (SILENCE, *(name for name, _ in phones), SILENCE)
    return tuple(PerformedPhone(a, (a + b) / 2, b, name) for name, (a, b) in zip(names, pairwise(ends), strict=True))


def share(sentence: Sentence, times: list[float], row: int = 0) -> list[float]:
    return pose_shares(sentence, POSES, np.array(times), FRAME).shares[:, row].tolist()


def test_a_pose_holds_for_a_quarter_of_its_phone_and_early_in_it() -> None:
    sentence = said(("a", 0.1), ("m", 0.2), ("a", 0.1))  # m from 0.3 to 0.5: about 0.37
    assert share(sentence, [0.345, 0.37, 0.395]) == pytest.approx([1, 1, 1])
    before, after = 0.25 * 0.1, 0.18 * 0.1
    expected = [np.exp(-0.5), np.exp(-2), np.exp(-0.5), np.exp(-2)]
    times = [0.345 - before, 0.345 - 2 * before, 0.395 + after, 0.395 + 2 * after]
    assert share(sentence, times) == pytest.approx(expected)


def test_lips_meet_for_a_picture_however_short_the_sound_is() -> None:
    sentence = said(("a", 0.1), ("p", 0.02), ("a", 0.1))
    middle = 0.3 + 0.35 * 0.02
    assert share(sentence, [middle - 0.49 * FRAME, middle + 0.49 * FRAME]) == [1, 1]


def test_lips_are_rounded_the_less_the_shorter_the_sound_is() -> None:
    assert share(said(("u", 0.035)), [0.2 + 0.35 * 0.035]) == pytest.approx([0.5])
    assert share(said(("u", 0.2)), [0.27]) == pytest.approx([1])


def test_the_higher_priority_takes_what_it_wants_and_equal_ones_share() -> None:
    times = np.linspace(0, 1, 400)
    both = pose_shares(said(("m", 0.05), ("u", 0.05)), POSES, times, FRAME)
    alone = pose_shares(said(("m", 0.05), ("a", 0.05)), POSES, times, FRAME)
    assert both.shares[:, 0] == pytest.approx(alone.shares[:, 0])
    assert both.shares.sum(axis=1).max() <= 1 + 1e-6
    assert both.firm == pytest.approx(both.shares[:, 0])
    equal = pose_shares(said(("u", 0.04), ("o", 0.04)), POSES, times, 0.1)  # both hold where they meet
    meeting = equal.shares[np.abs(times - 0.2 - 0.014 - 0.02).argmin()]
    assert meeting == pytest.approx([0.5, 0.5], abs=0.05)


def test_a_pose_decides_on_what_it_names_and_leaves_the_rest() -> None:
    sentence, channels = said(("m", 0.2)), ("jawOpen", "smileLeft")
    looked_up = np.full((2, 2), 0.5, np.float32)
    shares = pose_shares(sentence, POSES, np.array([0.27, 0.9]), FRAME)
    assert posed_weights(looked_up, shares, POSES, channels) == pytest.approx(np.array([[0, 0.5], [0.5, 0.5]]))
    rounded = pose_shares(said(("u", 0.2)), POSES, np.array([0.27, 0.9]), FRAME)
    assert posed_weights(looked_up, rounded, POSES, channels) == pytest.approx(np.array([[0.4, 0.1], [0.5, 0.5]]))


def test_a_sentence_without_posed_phones_is_as_it_was_looked_up() -> None:
    looked_up = np.full((1, 1), 0.5, np.float32)
    shares = pose_shares(said(("k", 0.2)), POSES, np.array([0.3]), FRAME)
    assert posed_weights(looked_up, shares, POSES, ("jawOpen",)) == pytest.approx(0.5)


def test_the_poses_that_ship_shut_lips_first() -> None:
    poses = load_poses()
    assert {name: poses.pose_of(name) for name in "pbmfvwak"} == {
        **dict.fromkeys("pbm", Pose("shut", 3.0, firm=True)),
        **dict.fromkeys("fv", Pose("teeth", 2.5, firm=True)),
        "w": Pose("round"),
        "a": None,
        "k": None,
    }
    assert [pose.shape for name in ("oʊ", "u", "l", "θ", "ð") if (pose := poses.pose_of(name))] == [
        "o",
        "round",
        "l",
        "th",
        "th",
    ]


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        (('shape = "shut"', 'shape = "open"'), r"\[phones.p\] has the shape 'open', which \[shapes\] lacks"),
        (("priority = 3", "priority = -1"), r"priority must be a number in 0..100, found -1"),
        (("p = {", "q7 = {"), r"\[phones\] knows no sound 'q7'"),
        (("mouthPress = 34", "mouthPrez = 34"), r"moves 'mouthPrez', which is no movestate"),
        (("firm = true", "firm = 1"), r"firm must be true or false, found 1"),
        (("poses 1", "poses 9"), r"a file of poses begins with format"),
    ],
)
def test_a_file_that_says_something_impossible_is_refused(
    tmp_path: Path, change: tuple[str, str], complaint: str
) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(USUAL_POSES.read_text(encoding="utf-8").replace(*change), encoding="utf-8")
    with pytest.raises(MouthError, match="mine.toml: .*" + complaint):
        load_poses(path)
