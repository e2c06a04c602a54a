"""What is seen of sounds: which viseme a phone has, which ones a phoneme allows, and that none flickers."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.errors import ModelError
from phonemeengine.labels.phone_sets import IPA_LETTERS, ipa_phoneme
from phonemeengine.labels.visemes import (
    NO_VISEME,
    PHONEME_VISEMES,
    STANDARD_VISEMES,
    VISEME_PHONES,
    Viseme,
    VisemeSet,
    viseme_of,
)
from phonemeengine.mouth.blendshape_names import OCULUS
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import MARGIN, VisemeSmoother


def test_visemes_are_called_as_avatars_call_them():
    assert tuple(viseme.label for viseme in Viseme) == OCULUS


@pytest.mark.parametrize(
    ("phone", "viseme"),
    [
        ("v", Viseme.FF),
        ("tʰ", Viseme.DD),
        ("ð", Viseme.TH),
        ("ŋ", Viseme.KK),
        ("iː", Viseme.IH),
        ("ɹ", Viseme.RR),
        ("h", None),
        ("ə", None),
        ("aɪ", None),
        ("tʃ", None),
        ("w", None),
    ],
)
def test_a_phone_has_the_viseme_that_nobody_doubts(phone, viseme):
    assert viseme_of(phone, ipa_phoneme(phone)) is viseme


def test_what_is_seen_of_a_sound_is_something_that_its_phoneme_allows():
    for letter in sorted(IPA_LETTERS):
        phoneme = ipa_phoneme(letter)
        viseme = viseme_of(letter, phoneme)
        if viseme is not None and phoneme is not None:
            assert viseme in PHONEME_VISEMES[phoneme], letter


def test_a_mouth_table_shows_a_heard_viseme_as_that_viseme():
    table = load_table("oculus")
    for viseme, phone in VISEME_PHONES.items():
        shape = table.shape_of(Phoneme.UNIDENTIFIED, phone)
        shown = {name for name, percent in table.shapes[shape].items() if percent}
        assert viseme.label in shown or viseme is Viseme.DD


def test_without_ears_for_visemes_a_phoneme_has_its_own_and_an_unidentified_one_none():
    phonemes = np.array([Phoneme.SILENCE, Phoneme.M, Phoneme.UNIDENTIFIED, Phoneme.A], np.uint8)
    visemes = VisemeSmoother().follow(phonemes, None)
    assert visemes.tolist() == [Viseme.SIL, Viseme.PP, NO_VISEME, Viseme.AA]
    assert visemes.tolist() == STANDARD_VISEMES.usual_visemes(phonemes).tolist()
    assert STANDARD_VISEMES.phones_of(visemes) == ["", "", "", ""]


def heard(*likely: tuple[Viseme, float]) -> np.ndarray:
    """Probabilities of frames in each of which one viseme has so much."""
    rows = np.zeros((len(likely), len(Viseme)), np.float32)
    for row, (viseme, share) in zip(rows, likely, strict=True):
        row[:] = (1 - share) / (len(Viseme) - 1)
        row[viseme] = share
    return rows


def test_a_heard_viseme_is_one_that_the_phoneme_allows():
    phonemes = np.array([Phoneme.UNIDENTIFIED, Phoneme.A], np.uint8)
    found = VisemeSmoother().follow(phonemes, heard((Viseme.FF, 0.9), (Viseme.FF, 0.9)))
    assert found.tolist() == [Viseme.FF, Viseme.AA]
    assert STANDARD_VISEMES.phones_of(found) == ["f", ""]


OWN = VisemeSet(
    names=("shut", "teeth", "tongue", "open", "round"),
    phonemes={
        **dict.fromkeys(Phoneme, ("open",)),
        **dict.fromkeys((Phoneme.SILENCE, Phoneme.M, Phoneme.P), ("shut",)),
        **dict.fromkeys((Phoneme.U, Phoneme.O), ("round",)),
        Phoneme.UNIDENTIFIED: ("teeth", "tongue"),
    },
    usual=dict.fromkeys(set(Phoneme) - {Phoneme.UNIDENTIFIED, Phoneme.U, Phoneme.O}, "open")
    | dict.fromkeys((Phoneme.SILENCE, Phoneme.M, Phoneme.P), "shut"),
    phones={"teeth": "f", "tongue": "θ"},
)


def test_a_recogniser_may_tell_visemes_of_its_own_apart():
    phonemes = np.array([Phoneme.UNIDENTIFIED, Phoneme.UNIDENTIFIED, Phoneme.U, Phoneme.M], np.uint8)
    likely = np.array([[0, 0.9, 0.1, 0, 0], [0, 0.1, 0.8, 0.1, 0], [0.9, 0, 0, 0, 0.1], [0, 0, 0, 1, 0]], np.float32)
    found = VisemeSmoother().follow(phonemes, likely, OWN)
    assert OWN.labels_of(found) == ["teeth", "tongue", "round", "shut"]
    assert OWN.phones_of(found) == ["f", "θ", "", ""]
    assert OWN.labels_of(VisemeSmoother().follow(phonemes, None, OWN)) == [None, None, None, "shut"]


def test_a_viseme_set_is_read_as_it_was_written():
    for one in (OWN, STANDARD_VISEMES):
        assert VisemeSet.from_json(one.to_json()) == one


def test_visemes_of_two_sets_are_one_by_their_names():
    other = replace(OWN, names=("round", "open", "tongue", "teeth", "shut"))
    codes = np.array([0, 1, 4, NO_VISEME], np.uint8)
    assert OWN.codes_of(codes, other).tolist() == [4, 3, 0, NO_VISEME]
    assert OWN.codes_of(codes, STANDARD_VISEMES).tolist() == [NO_VISEME] * 4


BAD_SETS = {
    "names twice": ({"names": ("a", "a")}, "1..32 different names"),
    "a strange name": ({"names": ("shut", "teeth", "tongue", "open")}, "names 'round'"),
    "a phoneme without one": ({"phonemes": {Phoneme.A: ("open",)}}, "no viseme for the phoneme silence"),
    "unusual": ({"usual": {Phoneme.A: "shut"}}, "'shut' is no viseme of the phoneme a"),
    "no sound": ({"phones": {"teeth": "1"}}, "'1' of the viseme 'teeth' is no letter of the IPA"),
}


@pytest.mark.parametrize(("change", "sentence"), BAD_SETS.values(), ids=BAD_SETS.keys())
def test_a_viseme_set_whose_parts_do_not_fit_is_refused(change, sentence):
    with pytest.raises(ModelError, match=sentence):
        replace(OWN, **change)


def test_a_viseme_stays_until_another_is_far_likelier_however_the_sound_is_cut():
    likely = [(Viseme.NN, 0.9), (Viseme.KK, 0.5 * (1 + MARGIN) - 0.1), (Viseme.NN, 0.5), (Viseme.KK, 0.9)]
    phonemes = np.full(4, Phoneme.UNIDENTIFIED, np.uint8)
    whole = VisemeSmoother().follow(phonemes, heard(*likely))
    assert whole[[0, 2, 3]].tolist() == [Viseme.NN, Viseme.NN, Viseme.KK]
    smoother = VisemeSmoother()
    parts = [smoother.follow(phonemes[k : k + 1], heard(likely[k])) for k in range(4)]
    assert np.concatenate(parts).tolist() == whole.tolist()
