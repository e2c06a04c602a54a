"""Styles: the neutral one changes nothing, each number of another one acts where it should, and files keep them."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.errors import MouthError
from phonemeengine.mouth.animation import Animation, animation_of
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.expression.composer import Expression, InhibitionTimes
from phonemeengine.mouth.expression.streams import held_expression
from phonemeengine.mouth.performer import IdleMotion
from phonemeengine.mouth.poses import USUAL_POSES, USUAL_TONGUE, load_poses
from phonemeengine.mouth.style import (
    FORMAT,
    Style,
    blend,
    load_style,
    neutral_style,
    own_styles,
    save_style,
    shipped_styles,
    style_of,
    style_to_toml,
)
from phonemeengine.mouth.table import load_table, shipped_tables
from phonemeengine.phonemes import Phoneme
from tests.engine.mouth.speaking import phones_said, speech

TABLE = load_table("arkit")
JAW, CLOSE, LEFT, RIGHT = (
    ARKIT.index(name) for name in ("jawOpen", "mouthClose", "mouthStretchLeft", "mouthStretchRight")
)
SAID = phones_said(("m", 0.1), ("i", 0.2), ("p", 0.1), ("a", 0.25), ("m", 0.09))


def moved(style: Style, rate: float = 100.0) -> Animation:
    """What a head shows in a style, without chance."""
    table = style.on_table(TABLE.with_motion(1, 1, random=False))
    return animation_of(SAID, table, rate, style.on_idle(IdleMotion(blinks=False)))


def test_the_neutral_style_changes_nothing():
    neutral = neutral_style()
    assert replace(neutral, notes="") == Style()
    for name in shipped_tables():
        assert neutral.on_table(load_table(name)) == load_table(name)
    assert (neutral.posed_mouth(), neutral.posed_tongue()) == (load_poses(USUAL_POSES), load_poses(USUAL_TONGUE))
    idle = IdleMotion(expression=Expression((held_expression({"smile": 1.0}),)))
    assert neutral.on_idle(idle) == idle
    plain, styled = (animation_of(speech(), table, 60) for table in (TABLE, neutral.on_table(TABLE)))
    assert plain.weights.tobytes() == styled.weights.tobytes()
    assert plain.head.tobytes() == styled.head.tobytes()


def test_mumbling_opens_less_and_theatrical_more_while_lips_still_meet():
    plain, mumbled, acted = (moved(Style(**amounts)) for amounts in ({}, {"mumbling": 1.0}, {"theatrical": 1.0}))
    widest = [float(animation.weights[:, JAW].max()) for animation in (mumbled, plain, acted)]
    assert widest[0] < 0.6 * widest[1] < 0.6 * 0.8 * widest[2]
    shut = slice(62, 66)  # the middle of p
    np.testing.assert_allclose(mumbled.weights[shut, CLOSE], plain.weights[shut, CLOSE], atol=0.01)
    turned = [float(np.abs(animation.head).max()) for animation in (mumbled, plain, acted)]
    assert turned[0] < turned[1] < turned[2]


def test_asymmetry_leaves_the_right_half_behind():
    weights = moved(Style(asymmetry=1.0)).weights
    assert weights[:, RIGHT].max() == pytest.approx(weights[:, LEFT].max() / 2)
    assert moved(Style()).weights[:, RIGHT].max() == pytest.approx(weights[:, LEFT].max())


def test_numbers_of_movement_and_widths_of_closures_act():
    long = style_of(f'format = "{FORMAT}"\n[closures.p]\nwidth = 2.0\n[movement]\nreleased = 0.03\n')
    shut = [
        (moved(style).weights[:80, CLOSE] > 0.95 * moved(Style()).weights[:80, CLOSE].max()).sum()
        for style in (Style(), long)
    ]
    assert shut[1] > shut[0]
    slow = Style(movement=replace(Style().movement, vowels=2.0))
    assert slow.on_table(TABLE).times != TABLE.times
    other = style_of(f'format = "{FORMAT}"\n[closures.p.shape]\nmouthClose = 40\njawOpen = 30\n')
    assert moved(other).weights[64, CLOSE] == pytest.approx(0.4, abs=0.02)


def test_firmness_of_a_closure_acts_on_rules():
    soft = style_of(f'format = "{FORMAT}"\n[closures]\np = {{ firm = false }}\nlabiodental = {{ firm = false }}\n')
    table = load_table("arkit")
    moved = soft.on_table(table)
    assert (table.closes(Phoneme.P), moved.closes(Phoneme.P), moved.closes(Phoneme.P, "b")) == (True, False, True)
    assert (table.closes(Phoneme.SZ, "f"), moved.closes(Phoneme.SZ, "f")) == (True, False)
    assert moved.shapes[moved.shape_of(Phoneme.P)] == table.shapes[table.shape_of(Phoneme.P)]
    firm = style_of(f'format = "{FORMAT}"\n[closures.o]\nfirm = true\n').on_table(table)
    assert (firm.closes(Phoneme.O), firm.shape_of(Phoneme.O, "o")) == (True, table.shape_of(Phoneme.O))


def test_a_letter_has_what_it_does_not_give_from_its_class():
    wide = style_of(f'format = "{FORMAT}"\n[closures.f]\nwidth = 2.0\n[tongue.t]\npriority = 2\n')
    assert wide.closures.phones["f"] == replace(wide.closures.phones["labiodental"], width=2.0)
    assert wide.tongue.phones["t"] == replace(wide.tongue.phones["alveolar"], priority=2.0)
    again = style_of(style_to_toml(wide))
    for own, read, letter in ((wide.closures, again.closures, "f"), (wide.tongue, again.tongue, "t")):
        pose, same = own.phones[letter], read.phones[letter]
        assert replace(same, shape=pose.shape) == pose
        assert read.shapes[same.shape] == own.shapes[pose.shape]
    assert wide.on_table(TABLE).shape_of(Phoneme.SZ, "f") == TABLE.shape_of(Phoneme.SZ, "f")


def test_the_tongue_of_a_style_moves_with_rules_where_a_face_has_one():
    edited = style_of(f'format = "{FORMAT}"\n[tongue.alveolar.shape]\ntongueTipAlveolar = 60\n')
    said = phones_said(("a", 0.2), ("t", 0.12), ("a", 0.2), ("θ", 0.12), ("k", 0.12), ("p", 0.1))
    plain = TABLE.with_motion(1, 1, random=False)
    faces = [
        animation_of(said, table, 100, IdleMotion(blinks=False))
        for table in (plain, Style().with_tongue(plain), edited.with_tongue(plain))
    ]
    lips, tongue, other = (face.weights for face in faces)
    np.testing.assert_array_equal(tongue[:, : len(ARKIT)], lips)
    tip, between, back = (len(ARKIT) + k for k in (1, 0, 4))
    assert [tongue[at, column] for at, column in ((56, tip), (88, between), (102, back))] == pytest.approx(
        [1, 1, 1], abs=0.15
    )
    assert (tongue[38, tip], tongue[104, tip]) == pytest.approx((0, 0), abs=0.02)
    assert other[:, tip].max() == pytest.approx(0.6 * tongue[:, tip].max(), abs=1e-3)
    assert load_table("vrm") == Style().with_tongue(load_table("vrm"))


def test_the_priority_of_two_closures_side_by_side_says_which_of_them_is_met_fully():
    said = phones_said(("a", 0.2), ("p", 0.06), ("f", 0.06), ("a", 0.2))
    plain = TABLE.with_motion(1, 1, random=False)

    def of(text: str) -> tuple[float, float]:
        table = style_of(f'format = "{FORMAT}"\n{text}\n').on_table(plain)
        press, roll = ARKIT.index("mouthPressLeft"), ARKIT.index("mouthRollLower")
        weights = animation_of(said, table, 200, IdleMotion(blinks=False)).weights
        return float(weights[111, press]), float(weights[113, roll])

    first, usual, second = of("[closures.p]\npriority = 9"), of(""), of("[closures.labiodental]\npriority = 9")
    assert first[0] > usual[0] + 0.02
    assert second[1] > usual[1] + 0.02


def test_expressions_give_way_as_the_style_says():
    idle = IdleMotion(expression=Expression((held_expression({"smile": 1.0}),)))
    style = Style(inhibition=InhibitionTimes(0.3, 0.6, 0.2), reductions={"browInnerUp": 0.9})
    expression = style.on_idle(idle).expression
    assert expression is not None
    assert expression.times.release == 0.6
    assert expression.channels.reductions[ARKIT.index("browInnerUp")] == np.float32(0.9)
    assert style.on_idle(style.on_idle(idle)).expression.channels.reductions.tolist() == (
        expression.channels.reductions.tolist()
    )


def test_a_blend_lies_between_and_its_ends_are_the_styles():
    one, other = load_style("mumbling"), load_style("theatrical")
    assert (blend(one, other, 0.0), blend(one, other, 1.0)) == (one, other)
    middle = blend(one, other, 0.25)
    assert (middle.mumbling, middle.theatrical) == (pytest.approx(0.525), pytest.approx(0.2))
    assert middle.closures.phones["p"].width == pytest.approx(1.075)
    with pytest.raises(MouthError, match="blend"):
        blend(one, other, 1.5)


def test_styles_are_kept_in_files_and_found_by_name(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DOCUMENTS_DIR", str(tmp_path))
    for name in shipped_styles():
        save_style(load_style(name), tmp_path / "s.toml")
        assert load_style(tmp_path / "s.toml") == load_style(name)
    mixed = blend(load_style("theatrical"), style_of(f'format = "{FORMAT}"\n[reductions]\nmouthSmile = 0.1\n'), 0.4)
    folder = tmp_path / "PhonemeAnalyser" / "styles"
    folder.mkdir(parents=True)
    save_style(replace(mixed, name="mine"), folder / "mine.toml")
    assert own_styles() == (folder / "mine.toml",)
    assert load_style("mine") == replace(mixed, name="mine")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("[amounts]\nmumbling = 2", "mumbling must be a number in 0..1"),
        ("[amounts]\nwhispering = 1", "cannot have an entry 'whispering'"),
        ("[movement]\nheld = -1", "held must be a number in 0..1"),
        ("[closures.q9]\nwidth = 1", r"\[closures\] knows no sound"),
        ("[closures.t]\nwidth = 1", "lacks shape"),
        ("[closures.p.shape]\nnose = 1", "no movestate"),
        ("[reductions]\nnose = 1", "no blend shape"),
        ("[inhibition]\nonset = 9", "onset must be a number in 0..5 s"),
        ("[gestures]\nnod = nan", "nod must be"),
    ],
)
def test_what_is_wrong_is_refused_in_one_sentence(text, told):
    with pytest.raises(MouthError, match=told):
        style_of(f'format = "{FORMAT}"\n{text}\n')


def test_a_style_that_is_not_there_is_refused_with_those_that_are():
    with pytest.raises(MouthError, match="did you mean theatrical"):
        load_style("theatrica")
