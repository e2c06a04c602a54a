"""The preset that is tuned: undo and redo, unsaved changes, bypass, and pairs that give way."""

from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeengine.errors import EngineError
from phonemeengine.features.variables import Variable
from phonemeengine.presets.files import THESIS_PRESET, load_preset, save_preset
from phonemeengine.presets.preset import Judgement
from phonemeengine.recognition.rules import PhonemeData
from phonemeengine.settings import BIN_WIDTH, STAGES, Filter

# one small change of each kind
EDITS: dict[str, Callable[[PresetModel], None]] = {
    "a threshold": lambda model: model.tune("sz_s1", 7.25),
    "a filter's number in Hz": lambda model: model.tune("high_pass_end", 861.0),
    "a setting": lambda model: model.set_setting("time_smooth", 0.375),
    "a choice": lambda model: model.set_setting("quantise", 1),
    "a filter off": lambda model: model.set_filter(Filter.NORMALISE, False),
    "a filter on": lambda model: model.set_filter(Filter.MEL, True),
    "a variable": lambda model: model.add_variable(Variable("mine", 100, 200)),
}


def test_it_begins_with_the_factory_preset(model: PresetModel) -> None:
    assert model.preset == load_preset(THESIS_PRESET)
    assert model.is_factory
    assert not model.has_unsaved_changes
    assert not model.undo_stack.canUndo()


# -- undo and redo --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("edit", EDITS.values(), ids=EDITS)
def test_every_change_can_be_taken_back_and_made_again(
    edit: Callable[[PresetModel], None], model: PresetModel, qtbot: QtBot
) -> None:
    before = model.preset
    with qtbot.waitSignals([model.changed, model.file_changed]):
        edit(model)
    after = model.preset
    assert after != before
    assert model.has_unsaved_changes
    with qtbot.waitSignals([model.changed, model.file_changed]):
        model.undo_stack.undo()
    assert model.preset == before
    assert not model.has_unsaved_changes
    with qtbot.waitSignals([model.changed, model.file_changed]):
        model.undo_stack.redo()
    assert model.preset == after
    assert model.has_unsaved_changes


def test_changes_are_taken_back_in_reverse(model: PresetModel) -> None:
    states = [model.preset]
    for edit in EDITS.values():
        edit(model)
        states.append(model.preset)
    for state in states[-2::-1]:
        model.undo_stack.undo()
        assert model.preset == state
    assert not model.undo_stack.canUndo()


def test_a_drag_is_taken_back_at_once(model: PresetModel) -> None:
    before = model.preset
    for k in range(50):
        model.tune("a_a1", 1 + k / 10)
    model.end_edit()
    assert model.undo_stack.count() == 1
    model.undo_stack.undo()
    assert model.preset == before
    model.undo_stack.redo()
    assert model.preset.thresholds.a_a1 == 5.9


def test_two_drags_are_taken_back_one_by_one(model: PresetModel) -> None:
    for value in (1.0, 2.0, 3.0):
        model.tune("a_a1", value)
    model.end_edit()
    for value in (4.0, 5.0):
        model.tune("a_a1", value)
    model.end_edit()
    model.undo_stack.undo()
    assert model.preset.thresholds.a_a1 == 3.0
    assert model.undo_stack.count() == 2


def test_changes_of_two_things_are_two_changes(model: PresetModel) -> None:
    model.tune("a_a1", 1.0)
    model.tune("sz_s1", 2.0)
    model.tune("a_a1", 3.0)
    assert model.undo_stack.count() == 3


def test_a_drag_back_to_where_it_began_is_no_change(model: PresetModel) -> None:
    start = model.preset.thresholds.a_a1
    for value in (start + 1, start + 2, start):
        model.tune("a_a1", value)
    assert model.undo_stack.count() == 0
    assert not model.has_unsaved_changes
    model.tune("a_a1", start + 1)
    model.undo_stack.undo()
    assert model.preset.thresholds.a_a1 == start


def test_the_value_it_has_already_is_no_change(model: PresetModel) -> None:
    for name, control in model.controls.items():
        model.tune(name, control.read(model.preset))
    for step in Filter:
        model.set_filter(step, model.preset.settings.has(step))
        model.reset_stage(step)
    assert model.undo_stack.count() == 0


def test_what_the_file_says_comes_back_as_one_change(model: PresetModel) -> None:
    saved = model.preset
    model.tune("a_a1", 1.0)
    model.set_filter(Filter.MEL, True)
    tuned = model.preset
    model.revert()
    assert (model.preset, model.has_unsaved_changes) == (saved, False)
    model.undo_stack.undo()
    assert model.preset == tuned


# -- bypass ---------------------------------------------------------------------------------------------------


def test_bypass_switches_all_filters_off_and_back(model: PresetModel, qtbot: QtBot) -> None:
    model.set_filter(Filter.MEL, True)
    tuned = model.preset
    with qtbot.waitSignal(model.changed):
        model.set_bypassed(True)
    assert model.in_force.settings.filters == frozenset()
    assert model.in_force.thresholds == tuned.thresholds
    assert model.preset == tuned
    model.tune("sz_s1", 3.5)
    assert model.in_force.thresholds.sz_s1 == 3.5
    with qtbot.waitSignal(model.changed):
        model.set_bypassed(False)
    assert model.in_force is model.preset
    assert model.preset.settings == tuned.settings


def test_bypass_is_no_change_of_the_preset(model: PresetModel) -> None:
    model.set_bypassed(True)
    assert not model.has_unsaved_changes
    assert not model.undo_stack.canUndo()


# -- numbers and units ----------------------------------------------------------------------------------------


def test_a_bound_in_bins_is_the_same_bound_in_hertz(model: PresetModel) -> None:
    model.tune("high_pass_end", 20 * BIN_WIDTH)
    assert model.preset.phoneme_data.high_pass_end == pytest.approx(20)
    model.set_setting("high_pass_end", 500.0)
    assert model.preset.settings.high_pass_end == 500.0
    assert model.preset.phoneme_data.high_pass_end == pytest.approx(500 / BIN_WIDTH)


@pytest.mark.parametrize("field", fields(PhonemeData), ids=lambda field: field.name)
def test_each_of_the_21_numbers_can_be_set(field: object, model: PresetModel) -> None:
    name = field.name  # type: ignore[attr-defined]
    unit = BIN_WIDTH if name.startswith("high_pass") else 1.0
    model.tune(name, 0.625 * unit)
    assert getattr(model.preset.phoneme_data, name) == pytest.approx(0.625)
    assert model.saved_value(name) == pytest.approx(getattr(load_preset(THESIS_PRESET).phoneme_data, name) * unit)


@pytest.mark.parametrize(("low", "high"), [("high_pass_start", "high_pass_end"), ("low_pass_start", "low_pass_end")])
def test_of_a_pair_the_other_bound_gives_way(low: str, high: str, model: PresetModel) -> None:
    model.set_setting(low, 12_000.0)
    assert (getattr(model.preset.settings, low), getattr(model.preset.settings, high)) == (12_000, 12_000)
    model.set_setting(high, 300.0)
    assert (getattr(model.preset.settings, low), getattr(model.preset.settings, high)) == (300, 300)
    model.undo_stack.undo()
    assert (getattr(model.preset.settings, low), getattr(model.preset.settings, high)) == (12_000, 12_000)


def test_the_range_of_the_intensity_gives_way_too(model: PresetModel) -> None:
    model.set_setting("intensity_low", -3.0)
    assert model.preset.settings.intensity_high == -3.0
    model.set_setting("intensity_high", -70.0)
    assert model.preset.settings.intensity_low == -70.0


def test_bounds_that_are_tuned_give_way_too(model: PresetModel) -> None:
    model.tune("high_pass_start", 700.0)
    assert model.preset.settings.high_pass_end == pytest.approx(700)
    model.tune("high_pass_end", 40.0)
    assert model.preset.settings.high_pass_start == pytest.approx(40)


@pytest.mark.parametrize(("name", "value"), [("time_smooth", 1.5), ("mel_bands", 3), ("quantise", 3)])
def test_an_impossible_value_is_refused_and_changes_nothing(name: str, value: float, model: PresetModel) -> None:
    before = model.preset
    with pytest.raises(EngineError, match=name):
        model.set_setting(name, value)
    assert model.preset == before
    assert model.undo_stack.count() == 0


# -- resets ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("step", Filter)
def test_a_reset_gives_a_filter_back_what_its_file_says(step: Filter, mine: PresetModel) -> None:
    saved = mine.preset
    others = {"quantise": 2, "mel_bands": 20}
    for name in (of.name for of in STAGES[step].parameters):
        if name not in {"decimation", "window_function"}:
            mine.set_setting(name, others.get(name, 0.5))
    mine.set_filter(step, not saved.settings.has(step))
    assert mine.has_unsaved_changes
    mine.reset_stage(step)
    assert mine.preset == saved
    assert not mine.has_unsaved_changes


def test_a_reset_leaves_the_other_filters_alone(mine: PresetModel) -> None:
    mine.set_setting("time_smooth", 0.5)
    mine.set_setting("denoise_threshold", 0.25)
    mine.reset_stage(Filter.TIME_SMOOTH)
    assert mine.preset.settings.time_smooth == 0
    assert mine.preset.settings.denoise_threshold == 0.25


def test_what_follows_the_filters_is_reset_too(mine: PresetModel) -> None:
    saved = mine.preset
    mine.set_setting("intensity_low", -50.0)
    mine.set_setting("minimum_hold", 0.2)
    mine.reset_stage("intensity")
    assert mine.preset.settings.minimum_hold == 0.2
    mine.reset_stage("statistics")
    assert mine.preset == saved


# -- variables ------------------------------------------------------------------------------------------------


def test_a_variable_is_added_saved_and_removed(mine: PresetModel) -> None:
    mine.add_variable(Variable("second", 100, 200))
    mine.save(mine.path)
    assert [variable.name for variable in load_preset(mine.path).variables] == ["own", "second"]
    mine.remove_variable("own")
    assert [variable.name for variable in mine.preset.variables] == ["second"]
    mine.undo_stack.undo()
    assert [variable.name for variable in mine.preset.variables] == ["own", "second"]


@pytest.mark.parametrize("name", ["own", "energy", "m_s1", "phoneme"])
def test_a_name_that_is_taken_is_refused(name: str, mine: PresetModel) -> None:
    before = mine.preset
    with pytest.raises(EngineError, match=f"{name} exists already"):
        mine.add_variable(Variable(name, 1, 2))
    assert mine.preset == before


def test_removing_what_is_not_there_is_no_change(mine: PresetModel) -> None:
    mine.remove_variable("energy")
    assert not mine.has_unsaved_changes
    assert mine.undo_stack.count() == 0


def test_a_calibrated_preset_that_is_changed_says_that_its_figures_are_no_longer_its_own(tmp_path: Path) -> None:
    judged = Judgement("Thesis", "2026-11-25", 4.0, False, (0.5, 0.6), (0.4, 0.5))
    save_preset(replace(load_preset(THESIS_PRESET), judged=judged), tmp_path / "mine.toml")
    model = PresetModel(tmp_path / "mine.toml")
    model.edit(replace(model.preset, notes="for the booth"), "edit notes")
    assert model.preset.judged == judged
    before = model.preset.thresholds.sz_s1
    model.tune("sz_s1", 7.25)
    assert model.preset.judged == replace(judged, changed=True)
    model.tune("sz_s1", before)
    assert model.preset.judged == judged
