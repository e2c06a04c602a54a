import math
from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.movestate import Mode, Movestate, MovestateSet, combinations_of, movestate_at, movestate_of
from tests.meshes import CORNERS, cube, moved_by

UP, RIGHT, BACK = (0, 1, 0), (1, 0, 0), (0, 0, -1)


def states() -> MovestateSet:
    """A mouth that opens, one that widens, one that purses, and a blink that does not care about them."""
    return MovestateSet(
        cube(),
        [
            movestate_of("open", moved_by((0, 1), UP)),
            movestate_of("wide", moved_by((1, 3), RIGHT)),
            movestate_of("purse", moved_by(tuple(range(8)), BACK)),
            movestate_of("blink", moved_by((4,), UP), interactable=False),
        ],
    )


def after(name: str, percent: float, mode: Mode) -> dict[str, float]:
    """What a set with open 60, wide 20, purse 0 and blink 90 % says after one is set."""
    full = states()
    full.set_percentages({"open": 60, "wide": 20, "blink": 90})
    full.set_percentage(name, percent, mode)
    return full.percentages


class TestPercentages:
    def test_all_states_begin_at_0(self):
        assert states().percentages == {"open": 0, "wide": 0, "purse": 0, "blink": 0}

    def test_none_leaves_the_others_alone(self):
        assert after("purse", 50, Mode.NONE) == {"open": 60, "wide": 20, "purse": 50, "blink": 90}

    def test_reset_takes_back_the_others_but_no_blink(self):
        assert after("purse", 50, Mode.RESET) == {"open": 0, "wide": 0, "purse": 50, "blink": 90}

    def test_force_reset_takes_back_the_blink_as_well(self):
        assert after("purse", 50, Mode.FORCE_RESET) == {"open": 0, "wide": 0, "purse": 50, "blink": 0}

    def test_interact_shrinks_the_others_by_one_factor_to_100_in_all(self):
        assert after("purse", 60, Mode.INTERACT) == pytest.approx({"open": 30, "wide": 10, "purse": 60, "blink": 90})

    def test_interact_leaves_the_others_alone_while_there_is_room(self):
        assert after("purse", 20, Mode.INTERACT) == {"open": 60, "wide": 20, "purse": 20, "blink": 90}

    @pytest.mark.parametrize("percent", [100, 150, -120])
    def test_interact_leaves_no_room_beside_100_percent(self, percent: float):
        assert after("purse", percent, Mode.INTERACT) == {"open": 0, "wide": 0, "purse": percent, "blink": 90}

    def test_an_exaggeration_below_0_takes_as_much_room_as_one_above(self):
        full = states()
        full.set_percentages({"open": -60, "wide": 20})
        full.set_percentage("purse", -60, Mode.INTERACT)
        assert full.percentages == pytest.approx({"open": -30, "wide": 10, "purse": -60, "blink": 0})

    def test_a_blink_takes_no_room_from_the_mouth(self):
        assert after("blink", 100, Mode.INTERACT) == {"open": 60, "wide": 20, "purse": 0, "blink": 100}

    def test_a_state_that_is_set_again_does_not_push_itself_back(self):
        assert after("open", 80, Mode.INTERACT) == {"open": 80, "wide": 20, "purse": 0, "blink": 90}

    @pytest.mark.parametrize(("force", "blink"), [(False, 90), (True, 0)])
    def test_resetting_all_takes_a_blink_back_only_by_force(self, force: bool, blink: float):
        full = states()
        full.set_percentages({"open": 60, "blink": 90})
        full.reset_all(force=force)
        assert full.percentages == {"open": 0, "wide": 0, "purse": 0, "blink": blink}

    def test_a_state_is_pushed_back_from_when_on_it_is_interactable(self):
        full = states()
        full.set_interactable("blink", True)
        full.set_interactable("wide", False)
        full.set_percentages({"open": 60, "wide": 20, "blink": 40})
        full.set_percentage("purse", 50, Mode.INTERACT)
        assert full.percentages == pytest.approx({"open": 30, "wide": 20, "purse": 50, "blink": 20})
        full.set_percentage("purse", 50, Mode.RESET)
        assert full.percentages == {"open": 0, "wide": 20, "purse": 50, "blink": 0}
        assert (full.interactable("blink"), full.interactable("wide")) == (True, False)

    def test_resetting_one_takes_back_even_a_blink(self):
        full = states()
        full.set_percentages({"open": 60, "blink": 90})
        full.reset("blink")
        assert full.percentages == {"open": 60, "wide": 0, "purse": 0, "blink": 0}

    def test_weights_are_what_a_shader_wants(self):
        full = states()
        full.set_percentages({"open": 50, "blink": 150})
        np.testing.assert_array_equal(full.weights, np.array([0.5, 0, 0, 1.5], np.float32))

    def test_an_unknown_state_is_refused_with_those_that_are_known(self):
        with pytest.raises(MeshError, match="no movestate 'smile'; choose one of open, wide, purse, blink"):
            states().set_percentage("smile", 10)

    @pytest.mark.parametrize("percent", [math.nan, math.inf, 1001, -1001])
    def test_what_is_no_percentage_is_refused_and_nothing_is_set(self, percent: float):
        full = states()
        with pytest.raises(MeshError, match="goes from -1000 to 1000 %"):
            full.set_percentages({"wide": 10, "open": percent})
        with pytest.raises(MeshError, match="goes from -1000 to 1000 %"):
            full.set_percentage("open", percent, Mode.RESET)
        assert not any(full.percentages.values())

    def test_two_states_of_one_name_are_refused(self):
        with pytest.raises(MeshError, match="two movestates 'open'"):
            MovestateSet(cube(), [movestate_of("open", moved_by((0,), UP))] * 2)

    def test_a_state_of_a_larger_mesh_is_refused(self):
        with pytest.raises(MeshError, match="moves vertex 8, and the mesh has 8"):
            MovestateSet(cube(), [movestate_at("open", [8], [UP])])


class TestMorphing:
    def test_at_0_percent_the_mesh_is_as_it_was(self):
        np.testing.assert_array_equal(states().morphed(), CORNERS)

    @pytest.mark.parametrize("percent", [100, 50, 0, -40, 250])
    def test_vertices_move_by_their_share_of_the_offset(self, percent: float):
        full = states()
        full.set_percentage("open", percent)
        np.testing.assert_allclose(full.morphed() - CORNERS, moved_by((0, 1), (0, percent / 100, 0)), atol=1e-6)

    def test_movements_add_up(self):
        full = states()
        full.set_percentages({"open": 50, "wide": 100, "purse": 20})
        moved = full.morphed() - CORNERS
        np.testing.assert_allclose(moved[1], (1, 0.5, -0.2), atol=1e-6)
        np.testing.assert_allclose(moved[7], (0, 0, -0.2), atol=1e-6)

    def test_the_mesh_itself_stays_as_it_is(self):
        full = states()
        full.set_percentage("open", 100)
        full.morphed()
        np.testing.assert_array_equal(full.mesh.positions, CORNERS)
        with pytest.raises(ValueError, match="read-only"):
            full.mesh.positions[0] = 0

    def test_scattered_vertices_move_like_neighbours(self):
        generator = np.random.default_rng(0)
        points = generator.standard_normal((5000, 3)).astype(np.float32)
        shapes = {
            "together": np.arange(100, 700),
            "scattered": np.arange(3, 5000, 97),
            "two ends": np.array([0, 4999]),
        }
        offsets = {name: generator.standard_normal((len(where), 3)) for name, where in shapes.items()}
        full = MovestateSet(mesh_of(points), [movestate_at(name, shapes[name], offsets[name]) for name in shapes])
        expected = points.astype(float)
        for percent, (name, where) in enumerate(shapes.items(), 30):
            full.set_percentage(name, percent)
            expected[where] += percent / 100 * offsets[name]
        np.testing.assert_allclose(full.morphed(), expected, atol=1e-5)


class TestOneState:
    def test_only_vertices_that_move_by_more_than_a_ten_thousandth_are_kept(self):
        offsets = [(0.0001, 0, 0), (0.00008, 0.00008, 0), (0, 0, 0), (0, -0.2, 0)]
        state = movestate_of("s", offsets)
        assert state.numbers.tolist() == [1, 3]
        assert state.reach == pytest.approx(0.2)

    def test_vertices_come_in_ascending_order_with_their_offsets(self):
        state = movestate_at("s", [7, 2], [(1, 0, 0), (0, 2, 0)])
        assert state.numbers.tolist() == [2, 7]
        assert state.offsets.tolist() == [[0, 2, 0], [1, 0, 0]]

    def test_what_was_given_can_be_used_again(self):
        offsets = np.ones((1, 3), np.float32)
        state = movestate_at("s", np.zeros(1, np.uint32), offsets)
        offsets[:] = 5
        assert state.offsets.tolist() == [[1, 1, 1]]

    @pytest.mark.parametrize("name", ["", " ", "a\nb", "a\0", " a", "x" * 256, "ä" * 128])
    def test_a_name_that_fits_on_no_line_is_refused(self, name: str):
        with pytest.raises(MeshError, match="the name of a movestate is"):
            movestate_at(name, [], np.empty((0, 3)))

    @pytest.mark.parametrize(
        ("numbers", "offsets", "said"),
        [
            ([1, 1], [UP, UP], "vertex 1 twice"),
            ([2, 1, 2], [UP, UP, UP], "vertex 2 twice"),
            ([1 << 20], [UP], "at most 1048576"),
            ([-1], [UP], "at most 1048576"),
            ([1], [(0, math.nan, 0)], "no finite number"),
            ([1], [(0, math.inf, 0)], "no finite number"),
            ([1, 2], [UP], "2 vertices and 1 offsets"),
        ],
    )
    def test_what_no_mesh_can_do_is_refused(self, numbers: list[int], offsets: list[tuple], said: str):
        with pytest.raises(MeshError, match=said):
            movestate_at("s", numbers, offsets)

    def test_a_nan_among_all_offsets_is_refused_and_not_left_out(self):
        with pytest.raises(MeshError, match="no finite number"):
            movestate_of("s", [(0, 0, 0), (math.nan, 0, 0)])

    def test_a_state_is_interactable_unless_it_says_otherwise(self):
        state: Movestate = movestate_at("s", [1], [UP])
        assert state.interactable
        assert not replace(state, interactable=False).interactable


def test_a_shape_is_a_combination_of_others_by_its_name():
    names = (
        "jawOpen",
        "smileLeft",
        "smileRight",
        "AU12_L",
        "AU26",
        "smile_jawOpen",
        "AU12_L_AU26",
        "jaw_Open",
        "AU12",
    )
    assert combinations_of((*names, "jawOpen_jawOpen_x", "_", "jawOpen_")) == {
        "smile_jawOpen": (("smileLeft", "smileRight"), ("jawOpen",)),
        "AU12_L_AU26": (("AU12_L",), ("AU26",)),
    }


@pytest.mark.parametrize(
    ("percentages", "moved"),
    [
        ({"open": 50, "wideLeft": 40, "wideRight": 60}, 0.25),
        ({"open": 200, "wideLeft": 100, "wideRight": 100}, 1.0),
        ({"open": -50, "wideLeft": 100, "wideRight": 100}, 0.0),
        ({"open": 50}, 0.0),
        ({"open": 50, "wideLeft": 40, "wideRight": 60, "open_wide": 70}, 0.7),
    ],
)
def test_a_combination_follows_the_product_of_its_parts(percentages, moved):
    plain = [movestate_of(name, moved_by((0,), RIGHT)) for name in ("open", "wideLeft", "wideRight")]
    face = MovestateSet(cube(), [*plain, movestate_of("open_wide", moved_by((1,), UP))])
    face.set_percentages(percentages)
    assert (face.morphed()[1] - face.mesh.positions[1]).tolist() == pytest.approx([0, moved, 0], abs=1e-6)
    assert face.percentages["open_wide"] == percentages.get("open_wide", 0)
