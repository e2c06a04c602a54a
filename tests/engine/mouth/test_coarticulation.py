"""Mouths that are ahead: vowels are widest early, lips leave the teeth in time, and what is short is seen.

The words are those of a recording by which mouths were late; labels of phones tell what is said when.
"""

import numpy as np
import pytest

from phonemeengine.errors import ExportError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.cues import APART, joined_runs, planned_movements
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.performer import IdleMotion
from phonemeengine.mouth.table import load_table
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment
from tests.engine.mouth.speaking import phones_said

RATE = 200.0
BEGIN = 0.3
"""When a word begins, seconds."""
CURVES = [name for name, form in FORMATS.items() if form.movestates == ARKIT or name == "curves-json"]
Phones = tuple[tuple[str, float], ...]
NOT: Phones = (("n", 0.06), ("ɒ", 0.11), ("t", 0.08))
VALID: Phones = (("v", 0.06), ("æ", 0.09), ("l", 0.06), ("ɪ", 0.05), ("d", 0.07))
PLEASE: Phones = (("p", 0.09), ("l", 0.05), ("iː", 0.10), ("z", 0.09))
FIVE: Phones = (("f", 0.11), ("aɪ", 0.17), ("v", 0.07))
OF: Phones = (("ɒ", 0.06), ("v", 0.04), ("ð", 0.05), ("ə", 0.05))
YOU: Phones = (("j", 0.05), ("uː", 0.05), ("h", 0.05), ("æ", 0.07))
BOB: Phones = (("b", 0.07), ("ɑ", 0.08), ("b", 0.06))


def moved(phones: Phones, name: str, rate: float = RATE, form: str = "curves-json") -> np.ndarray:
    """How far a movestate is on in each picture of a file."""
    options = ExportOptions(rate=rate, idle=IdleMotion(blinks=False, head=False))
    film = Exporter(form, options).export_of(phones_said(*phones)).animation
    return film.weights[:, film.movestates.index(name)]


def span(phones: Phones, number: int, rate: float = RATE) -> slice:
    """The pictures of a phone."""
    start = BEGIN + sum(length for _, length in phones[:number])
    return slice(*(round(time * rate) for time in (start, start + phones[number][1])))


@pytest.mark.parametrize(("phones", "vowel"), [(NOT, 1), (VALID, 1), (PLEASE, 2), (FIVE, 1), (BOB, 1)])
def test_the_jaw_is_widest_in_the_first_60_percent_of_a_vowel(phones: Phones, vowel: int) -> None:
    jaw = moved(phones, "jawOpen")[span(phones, vowel)]
    assert np.argmax(jaw >= jaw.max() - 2e-3) <= 0.6 * len(jaw)
    assert jaw.max() == pytest.approx(moved(phones, "jawOpen").max(), abs=0.02)


@pytest.mark.parametrize(("phones", "lip"), [(VALID, 0), (FIVE, 0), (FIVE, 2), (OF, 1)])
def test_the_lip_is_at_the_teeth_for_f_and_v_and_has_left_them_60_ms_later(phones: Phones, lip: int) -> None:
    rolled, there = moved(phones, "mouthRollLower"), span(phones, lip)
    assert rolled[there].max() > 0.6
    assert rolled[there.stop : there.stop + round(0.06 * RATE) + 1].min() < 0.1


def test_what_is_as_short_as_in_fast_speech_is_seen_in_curves() -> None:
    assert moved(OF, "mouthRollLower")[span(OF, 1)].max() > 0.7
    assert moved(YOU, "mouthPucker")[span(YOU, 1)].max() > 0.4
    assert moved(BOB, "jawOpen")[span(BOB, 1)].max() > 0.4


def test_lips_that_have_met_have_parted_when_the_next_sound_is_over() -> None:
    lips = moved(PLEASE, "mouthUpperUpLeft") + moved(PLEASE, "mouthLowerDownLeft")
    assert lips[span(PLEASE, 0)].min() == pytest.approx(0.0, abs=0.01)
    assert lips[span(PLEASE, 1)].max() > 0.4
    assert lips[span(PLEASE, 2)].min() > 0.4


@pytest.mark.parametrize("rate", [8.0, 12.0, 24.0, 30.0])
@pytest.mark.parametrize("form", CURVES)
@pytest.mark.parametrize("phone", ["p", "f"])
def test_lips_that_meet_between_two_pictures_are_met_in_one(form: str, rate: float, phone: str) -> None:
    """Wherever a closure of 30 ms lies between the pictures."""
    name = {"p": "mouthPressLeft", "f": "mouthRollLower"}[phone]
    whole = load_table("arkit").shapes[phone][name] / 100
    for k in range(10):
        phones = (("a", 0.2 + k / 10 / rate), (phone, 0.03), ("a", 0.2))
        assert moved(phones, name, rate, form).max() > 0.9 * whole, k


def test_a_shortest_cue_is_refused_where_there_are_none() -> None:
    for name in ("livelink-csv", "oculus-csv", "gltf"):
        with pytest.raises(ExportError, match=f"{name} has curves and no cues, so there is no shortest cue"):
            Exporter(name, ExportOptions(minimum=0.06))
    Exporter("curves-json", ExportOptions(minimum=0.06))


def test_the_shortest_cue_changes_the_cues_of_curves_and_not_the_curves() -> None:
    exports = [
        Exporter("curves-json", ExportOptions(minimum=minimum)).export_of(phones_said(*OF)) for minimum in (0, 0.2)
    ]
    assert len(exports[0].cues) > len(exports[1].cues)
    np.testing.assert_array_equal(*(export.animation.weights for export in exports))


def test_movements_begin_in_order_and_none_before_that_which_goes_on() -> None:
    table, generator = load_table("arkit"), np.random.default_rng(5)
    ends = np.cumsum(generator.integers(1, 20, 500)) / 100
    codes = generator.integers(0, 11, 500).tolist()
    runs = [Segment(a, b, Phoneme(c), 0.5) for a, b, c in zip([0.0, *ends[:-1]], ends, codes, strict=True)]
    for rate in (0.0, 8.0, 60.0):
        planned = planned_movements(joined_runs(runs, table), table, 0.0, rate=rate)
        begins = np.array([movement.begin for movement in planned])
        assert np.diff(begins).min() >= APART - 1e-9
        assert begins[0] > 0.0
        assert {movement.time_share <= 1.0 for movement in planned} == {True}


def test_a_mouth_that_may_not_be_ahead_moves_when_sounds_begin() -> None:
    said = phones_said(("a", 0.3))
    options = ExportOptions(rate=RATE, anticipation=0.0, idle=IdleMotion(blinks=False, head=False))
    jaw = Exporter("livelink-csv", options).export_of(said).animation.weights[:, ARKIT.index("jawOpen")]
    assert np.flatnonzero(jaw > 0)[0] == pytest.approx(BEGIN * RATE, abs=1)


def test_a_sound_without_anything_said_is_at_rest() -> None:
    film = Exporter("livelink-csv", ExportOptions(idle=IdleMotion(blinks=False, head=False))).export_of(
        Transcript("", 0.5)
    )
    assert film.animation.weights.max() <= 0.05
