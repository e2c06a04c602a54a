import sqlite3
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import PerformanceError
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.table import table_of, table_to_toml
from phonemeengine.performance.face_learning import component_table, principal_components, reduce_table, rms_between
from phonemeengine.performance.recording import Performance
from phonemeengine.performance.table_file import PerformanceTable, write_table
from tests.engine.mouth.speaking import speech
from tests.engine.performance.sentences import performance_of

CHANNELS = ("headYaw", "jawOpen", "mouthFunnel", "mouthClose", "browInnerUp")


def moved(seed: int) -> Performance:
    """A face whose four shapes are mixed of two, and whose head turns as it likes."""
    plain = performance_of("ma.ma", 0.2)
    chance = np.random.default_rng(seed)
    shapes = chance.uniform(0, 0.4, (len(plain.weights), 2)) @ np.array([[1, 0.5, 0, 0.2], [0, 0.3, 1, 0.6]])
    weights = np.hstack([chance.uniform(-40, 40, (len(plain.weights), 1)), shapes]).astype(np.float32)
    return Performance(f"take{seed}", plain.rate, CHANNELS, weights, plain.phones, plain.words)


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """Two takes with components in place of their shapes."""
    write_table(tmp_path / "all.sqlite", map(moved, (1, 2)), person="Ann", language="de")
    with PerformanceTable.open(tmp_path / "all.sqlite") as table:
        basis = principal_components(found for _, found in table.recordings())
        assert basis.components.shape == (2, 4)
        reduce_table(table, tmp_path / "small.sqlite", basis)
    return tmp_path / "small.sqlite"


def test_weights_come_back_from_fewer_columns(small: Path) -> None:
    with PerformanceTable.open(small) as table, closing(sqlite3.connect(small)) as stored:
        table.check()
        assert [name for (name,) in stored.execute("SELECT name FROM channel")] == ["pc1", "pc2", "headYaw"]
        assert (table.about.channels, table.about.person) == ((*CHANNELS[1:], "headYaw"), "Ann")
        found = [performance for _, performance in table.recordings()]
    assert rms_between(zip(map(moved, (1, 2)), found, strict=True)) < 5e-4
    assert found[0].weights[:, -1] == pytest.approx(moved(1).weights[:, 0], abs=0.02)


def test_a_rig_with_a_shape_for_each_component_is_moved_by_rules_and_recorded_faces(small: Path) -> None:
    with PerformanceTable.open(small) as table:
        basis = principal_components(found for _, found in table.recordings())
    rig = table_of(table_to_toml(component_table(basis, "rig")))
    film = Exporter("livelink-csv").export_of(speech()).animation
    shown = film.on_face(rig)
    assert shown.movestates == ("pc1", "pc2")
    shapes = film.weights[:, [*map(film.movestates.index, basis.shapes)]]
    np.testing.assert_allclose(shown.weights, shapes @ basis.components.T, atol=1e-5)


def test_a_part_of_the_variance_takes_fewer_components() -> None:
    n = [len(principal_components([moved(1)], share).components) for share in (0.1, 0.5, 0.999, 1.0)]
    assert n[0] == 1
    assert n == sorted(n)


@pytest.mark.parametrize(
    "basis",
    ["[" * 99_999, "no JSON", "{}", '{"shapes": ["jawOpen"], "mean": [0], "components": [[NaN]]}', '{"shapes": 3}'],
)
def test_damaged_components_are_refused_in_a_sentence(small: Path, basis: str) -> None:
    with closing(sqlite3.connect(small)) as connection:
        connection.execute("UPDATE meta SET value = ? WHERE name = 'basis'", (basis,))
        connection.commit()
    with pytest.raises(PerformanceError, match="this is no table of performances, or a damaged one"):
        PerformanceTable.open(small)


def test_what_has_no_components_is_refused() -> None:
    head = performance_of("ma")
    turned = Performance("a", head.rate, ("headYaw",), head.weights[:, :1], head.phones)
    with pytest.raises(PerformanceError, match="components are of blend shapes"):
        principal_components([turned])
    with pytest.raises(PerformanceError, match=r"a share in 0\.\.1 of what moves, got nan"):
        principal_components([head], float("nan"))
