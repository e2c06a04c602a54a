"""The preset and its file: the mark for unsaved changes, saving, and loading."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeengine.errors import EngineError, PresetError
from phonemeengine.features.variables import Variable
from phonemeengine.presets.files import FACTORY, load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, Filter


def test_the_mark_goes_away_when_the_value_comes_back(model: PresetModel, qtbot: QtBot) -> None:
    start = model.preset.thresholds.sz_s1
    marks: list[bool] = []
    model.file_changed.connect(lambda: marks.append(model.has_unsaved_changes))
    model.tune("sz_s1", start + 1)
    model.end_edit()
    assert marks[-1]
    model.tune("sz_s1", start)
    assert not marks[-1]
    model.undo_stack.undo()
    assert marks[-1]
    model.undo_stack.redo()
    assert not marks[-1]


def test_saving_makes_it_clean_and_later_changes_count_from_there(model: PresetModel, tmp_path: Path) -> None:
    model.tune("sz_s1", 3.5)
    model.save(tmp_path / "saved.toml")
    assert not model.has_unsaved_changes
    assert not model.is_factory
    assert (model.path, model.preset.name) == (tmp_path / "saved.toml", "saved")
    assert load_preset(tmp_path / "saved.toml") == model.preset
    model.tune("sz_s1", 3.75)
    assert model.has_unsaved_changes
    model.undo_stack.undo()
    assert not model.has_unsaved_changes


def test_what_was_done_before_saving_can_be_taken_back_and_the_name_stays(model: PresetModel, tmp_path: Path) -> None:
    model.tune("sz_s1", 3.5)
    model.save(tmp_path / "saved.toml")
    model.undo_stack.undo()
    assert model.has_unsaved_changes
    assert model.preset.name == "saved"
    model.undo_stack.redo()
    assert not model.has_unsaved_changes


def test_saving_to_its_own_file_keeps_the_name(mine: PresetModel) -> None:
    mine.set_setting("minimum_hold", 0.05)
    mine.save(mine.path)
    assert mine.preset.name == "mine"
    assert load_preset(mine.path).settings.minimum_hold == 0.05
    assert not mine.has_unsaved_changes


def test_a_failed_saving_changes_nothing(mine: PresetModel, tmp_path: Path) -> None:
    mine.tune("sz_s1", 3.5)
    before = (mine.preset, mine.path)
    with pytest.raises(PresetError, match="cannot be written"):
        mine.save(tmp_path / "nowhere" / "saved.toml")
    assert (mine.preset, mine.path) == before
    assert mine.has_unsaved_changes


def test_loading_takes_over_everything_and_forgets_what_was_done(
    model: PresetModel, tmp_path: Path, qtbot: QtBot
) -> None:
    other = Preset(name="other", variables=(Variable("own", 50, 90),))
    save_preset(other, tmp_path / "other.toml")
    model.tune("sz_s1", 3.5)
    with qtbot.waitSignals([model.changed, model.file_changed]):
        model.load(tmp_path / "other.toml")
    assert model.preset == other
    assert model.path == tmp_path / "other.toml"
    assert not model.has_unsaved_changes
    assert not model.undo_stack.canUndo()


def test_a_preset_that_is_loaded_by_its_name_has_its_file(mine: PresetModel) -> None:
    mine.load(Path("templates"))
    assert mine.path == FACTORY / "templates.toml"
    assert mine.is_factory


def test_loading_phonemedata_means_the_thesis_whatever_was_there_before(mine: PresetModel, tmp_path: Path) -> None:
    numbers = ",".join(str(k / 32) for k in range(1, 22))
    (tmp_path / "old.phonemedata").write_text(numbers)
    mine.set_filter(Filter.MEL, True)
    mine.load(tmp_path / "old.phonemedata")
    assert mine.preset.thresholds.i_o1 == 21 / 32
    assert mine.preset.settings.time_smooth == 1 / 32
    assert mine.preset.settings.high_pass_start == pytest.approx(3 / 32 * BIN_WIDTH)
    assert not mine.preset.settings.has(Filter.MEL)  # the thesis's front end
    assert mine.preset == load_preset(tmp_path / "old.phonemedata")
    assert mine.preset.variables == ()
    assert not mine.has_unsaved_changes


@pytest.mark.parametrize("content", ["1,2,3", "nan," * 21, "format = 'x'", ""])
@pytest.mark.parametrize("name", ["broken.toml", "broken.phonemedata"])
def test_a_failed_loading_changes_nothing(name: str, content: str, mine: PresetModel, tmp_path: Path) -> None:
    (tmp_path / name).write_text(content)
    mine.tune("sz_s1", 3.5)
    before = (mine.preset, mine.path, mine.undo_stack.count())
    changes: list[None] = []
    mine.changed.connect(lambda: changes.append(None))
    with pytest.raises(EngineError, match=f"^{name}: "):
        mine.load(tmp_path / name)
    assert (mine.preset, mine.path, mine.undo_stack.count()) == before
    assert mine.has_unsaved_changes
    assert not changes
