"""Which example is chosen: the recordings are one word, said at several speeds by a face that stays where it is."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.performance.choice import ExampleChoice, PlacedUnit, chosen_examples
from phonemeengine.performance.halves import TRAITS, Recordings, traits_of
from phonemeengine.performance.recording import Performance
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.units import Sentence, UnitKind, units_of
from tests.engine.performance.sentences import CHANNELS, performance_of, phones_in

LENGTHS = (0.1, 0.104, 0.109, 0.12, 0.2)
"""Of the phones in the recordings 1 to 5."""


def steady(words: str, length: float, level: float) -> Performance:
    """Give a performance whose face stays as it is."""
    performance = performance_of(words, length)
    return replace(performance, weights=np.full_like(performance.weights, level))


@pytest.fixture
def table(tmp_path: Path) -> Iterator[PerformanceTable]:
    levels = (0.0, 0.5, 0.0, 0.5, 0.0)
    write_table(tmp_path / "t.sqlite", [steady("ma.ma", n, level) for n, level in zip(LENGTHS, levels, strict=True)])
    with PerformanceTable.open(tmp_path / "t.sqlite") as opened:
        yield opened


def placed_in(sentence: Sentence, *kinds: UnitKind) -> list[PlacedUnit]:
    units = sorted((unit for unit in units_of(sentence) if unit.kind in kinds), key=lambda unit: unit.first)
    return [PlacedUnit(unit, unit.kind, unit.names) for unit in units]


def chosen(
    table: PerformanceTable, choice: ExampleChoice, *kinds: UnitKind, length: float = 0.1, seed: int = 0
) -> list[int]:
    """Give the recordings that are chosen for the units of some sets in "ma.ma"."""
    sentence = phones_in("ma.ma", length)
    recordings = Recordings(table, np.arange(len(CHANNELS)))
    found = chosen_examples(placed_in(sentence, *kinds), sentence, table, recordings, choice, (seed,))
    return [example.recording for _, example in found]


def test_the_nearest_example_is_that_of_the_nearest_duration(table: PerformanceTable) -> None:
    assert chosen(table, ExampleChoice.NEAREST, UnitKind.WORD, length=0.11) == [3]
    assert chosen(table, ExampleChoice.NEAREST, UnitKind.WORD, length=9.0) == [5]


def test_chance_takes_any_example_and_that_of_a_band_any_in_it(table: PerformanceTable) -> None:
    assert {chosen(table, ExampleChoice.RANDOM, UnitKind.WORD, seed=k)[0] for k in range(50)} == {1, 2, 3, 4, 5}
    assert {chosen(table, ExampleChoice.BAND, UnitKind.WORD, seed=k)[0] for k in range(50)} == {1, 2, 3}  # 15 %
    assert chosen(table, ExampleChoice.BAND, UnitKind.WORD, length=0.15) == [4]  # none is in the band: the nearest


def test_equal_seeds_choose_alike(table: PerformanceTable) -> None:
    runs = [chosen(table, ExampleChoice.RANDOM, UnitKind.LEFT_HALF, seed=seed) for seed in (3, 3, 4)]
    assert runs[0] == runs[1] != runs[2]


def test_the_best_way_goes_on_with_the_face_that_it_has(table: PerformanceTable) -> None:
    halves = (UnitKind.LEFT_HALF, UnitKind.RIGHT_HALF)
    levels = {number % 2 for number in chosen(table, ExampleChoice.VITERBI, *halves, length=0.1065)}
    assert len(levels) == 1  # all of one level, though 2 and 3 are as near in length


def test_the_best_way_keeps_to_one_recording_where_that_fits(table: PerformanceTable) -> None:
    kinds = (UnitKind.BOUNDARY_DIPHONE, UnitKind.SYLLABLE, UnitKind.DIPHONE)
    assert len({*chosen(table, ExampleChoice.VITERBI, UnitKind.SYLLABLE, length=0.1)}) == 1
    assert {*chosen(table, ExampleChoice.VITERBI, *kinds, length=0.1)} == {1}


def test_the_traits_of_a_half_tell_of_its_length_its_voice_and_its_neighbours() -> None:
    sentence = phones_in("pu", 0.2)
    louder = (sentence[0], replace(sentence[1], energy=-30.0), replace(sentence[2], energy=-6.0, pitch=200.0))
    traits = [dict(zip(TRAITS, row.tolist(), strict=True)) for row in traits_of((*louder, sentence[3]))]
    p_left, p_right, u_left = traits[2], traits[3], traits[4]
    assert p_left["duration"] == pytest.approx(np.log(0.1))
    assert (p_left["energy"], u_left["energy"]) == (-1.0, 1.0)
    assert (p_right["rounding beside"], u_left["lips beside"], p_left["lips beside"]) == (1.0, 1.0, 0.0)
    assert (p_left["syllable"], u_left["syllable"]) == (0.0, 1.0)
    assert {p_left[f"{what} beside"] for what in ("lips", "rounding", "opening", "spreading")} == {0.0}  # silence
