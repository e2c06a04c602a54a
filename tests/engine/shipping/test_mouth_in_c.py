"""The mouth in C moves as the morpher does."""

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from phonemeengine import Morpher, MouthTable, Phoneme, load_preset, load_table
from phonemeengine.labels.visemes import NO_VISEME, VISEME_PHONES, Viseme
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import CModel, CMouth, EarLibrary

Heard = tuple[float, Phoneme, int, float]
VISEMES = (*Viseme, NO_VISEME)
SOUNDS = st.lists(
    st.tuples(st.floats(0.0, 0.2), st.sampled_from(Phoneme), st.sampled_from(VISEMES), st.floats(0.0, 1.0, width=32)),
    min_size=1,
    max_size=40,
)


@pytest.fixture(scope="module")
def model(library: EarLibrary) -> CModel:
    return CModel(library, format_ear(load_preset("thesis"), shipped_tables()))


def phone_of(phoneme: Phoneme, viseme: int) -> str:
    return "" if viseme == NO_VISEME else VISEME_PHONES.get(Viseme(viseme), "")


def weights_of(mouth: CMouth | Morpher, sounds: Sequence[Heard]) -> np.ndarray:
    """Give the weights before and after each sound began."""
    time, found = 0.0, []
    for passed, phoneme, viseme, intensity in sounds:
        look = viseme if phoneme is not Phoneme.SILENCE else int(Viseme.SIL)  # silence has no other look
        time += passed
        found.append(mouth.weights(time))
        if isinstance(mouth, CMouth):
            mouth.add(time, phoneme, look, intensity)
        else:
            mouth.add(time, phoneme, intensity, phone_of(phoneme, look))
        found += [mouth.weights(time), mouth.weights(time + passed / 3)]
    return np.array([*found, mouth.weights(time + 1.0), mouth.weights(time + 5.0)])


@hypothesis_settings(max_examples=40)
@given(sounds=SOUNDS, table=st.sampled_from(shipped_tables()), seed=st.integers(0, 2**32 - 1))
def test_weights_are_those_of_the_morpher_at_any_time(
    model: CModel, sounds: list[Heard], table: str, seed: int
) -> None:
    expected = weights_of(Morpher(load_table(table), seed=seed), sounds)
    found = weights_of(CMouth(model, table, seed), sounds)
    assert found.shape == expected.shape
    assert np.abs(found - expected).max(initial=0) < 1e-5


def test_more_sounds_than_a_mouth_remembers_do_no_harm(model: CModel) -> None:
    sounds = [(0.001, Phoneme(2 + k % 9), NO_VISEME, 1.0) for k in range(300)]
    found = weights_of(CMouth(model, "arkit", 1), sounds)
    assert np.abs(found - weights_of(Morpher(load_table("arkit"), seed=1), sounds)).max() < 1e-5


@pytest.mark.parametrize("name", shipped_tables())
def test_shapes_and_movestates_have_the_names_of_the_table(model: CModel, name: str) -> None:
    c, table = model.library.c, load_table(name)
    number = c.ear_table_find(model.handle, name.encode())
    assert c.ear_table_name(model.handle, number).decode() == name
    n = c.ear_table_movestates(model.handle, number)
    assert tuple(c.ear_table_movestate(model.handle, number, k).decode() for k in range(n)) == table.movestates
    assert shapes_in_c(model, number) == shapes_of(table)


def shapes_in_c(model: CModel, number: int) -> list[str]:
    c = model.library.c
    return [
        c.ear_table_shape_name(model.handle, number, c.ear_table_shape(model.handle, number, p, v)).decode()
        for p in Phoneme
        for v in VISEMES
    ]


def shapes_of(table: MouthTable) -> list[str]:
    return [table.shape_of(p, phone_of(p, v)) for p in Phoneme for v in VISEMES]


def test_a_table_that_is_not_there_has_no_number(model: CModel) -> None:
    c = model.library.c
    assert c.ear_table_find(model.handle, b"nothing") == -1
    assert c.ear_table_movestates(model.handle, -1) == c.ear_table_movestates(model.handle, 99) == 0
    assert c.ear_table_movestate(model.handle, 0, -1) == b""
