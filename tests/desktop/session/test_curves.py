"""The table of averaged spectra: what is added, kept, compared, and taken back."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile
from pytestqt.qtbot import QtBot

from phonemeanalyser.colours import CURVE_COLOURS, free_curve_colour
from phonemeanalyser.desktop.session.curves import CurveTable
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeengine.errors import CurveError
from phonemeengine.inspection import averaged_spectrum
from phonemeengine.inspection.speaker_spectra import average_parts
from phonemeengine.settings import SAMPLE_RATE, Channel
from phonemeengine.storage.files import portable_name
from tests.sounds import noise, vowel


@pytest.fixture
def table(model: PresetModel, tmp_path: Path):
    table = CurveTable(model)
    table.told, table.refused = [], []  # type: ignore[attr-defined]
    table.info.connect(table.told.append)
    table.error.connect(table.refused.append)
    yield table
    table.close()


@pytest.fixture
def part(tmp_path: Path) -> averaged_spectrum.SoundPart:
    return sound_part(tmp_path / "a.wav", vowel((700, 1200, 2500), 0.5))


def sound_part(path: Path, samples: np.ndarray) -> averaged_spectrum.SoundPart:
    soundfile.write(path, samples, SAMPLE_RATE, subtype="FLOAT")
    return averaged_spectrum.SoundPart(path, Channel.MIX, ((0.0, len(samples) / SAMPLE_RATE),))


def flat(name: str, amplitude: float = 0.1, front_end: str = "bare") -> averaged_spectrum.AveragedSpectrum:
    return averaged_spectrum.AveragedSpectrum(name, np.arange(8.0), np.full(8, amplitude), 10, front_end)


def names(table: CurveTable) -> list[str]:
    return [curve.name for curve in table.curves]


def test_a_sound_is_averaged_through_the_filters_that_are_on(table, model, part, qtbot: QtBot) -> None:
    table.average("a", [part])
    qtbot.waitUntil(lambda: len(table.curves) == 1)
    wanted = average_parts([part], model.in_force.settings, "a")
    assert table.curves[0].is_same(wanted)
    assert table.curves[0].parts == (part,)
    assert table.curves[0].front_end == model.in_force.settings.front_end()


def test_what_is_there_already_is_pointed_at(table) -> None:
    places: list[list[int]] = []
    table.added.connect(places.append)
    table.add([flat("a"), flat("b", 0.2)])
    table.add([flat("again", 0.2)])
    assert names(table) == ["a", "b"]
    assert places == [[0, 1], [1]]
    assert table.told == ["This average is in the table already, as b"]


def test_each_curve_has_a_colour_of_its_own(table) -> None:
    table.add([flat(str(k), 0.1 + k / 100) for k in range(20)])
    colours = [curve.colour for curve in table.curves]
    assert colours[: len(CURVE_COLOURS)] == list(CURVE_COLOURS)
    assert len(set(colours)) == 20
    table.add([replace(flat("mine", 0.9), colour="#123456"), replace(flat("too", 0.8), colour="#123456")])
    assert table.curves[20].colour == "#123456" != table.curves[21].colour
    assert free_curve_colour(colours) not in colours


def test_curves_are_renamed_recoloured_and_hidden(table) -> None:
    table.add([flat("a"), flat("b", 0.2)])
    table.rename(0, "  Mara,\n a ")
    table.rename(1, "   ")
    table.recolour([0, 1], "#000000")
    table.show([1], on=False)
    assert names(table) == ["Mara, a", "b"]
    assert [curve.colour for curve in table.curves] == ["#000000"] * 2
    assert [curve.name for curve in table.shown] == ["Mara, a"]


def test_what_is_removed_comes_back_where_it_was(table, model) -> None:
    table.add([flat(name, 0.1 * (k + 1)) for k, name in enumerate("abcd")])
    table.remove([0, 2])
    assert names(table) == ["b", "d"]
    model.undo_stack.undo()
    assert names(table) == ["a", "b", "c", "d"]
    model.undo_stack.redo()
    assert names(table) == ["b", "d"]


def test_curves_are_there_again_at_the_next_start(table, model, tmp_path: Path) -> None:
    folder = tmp_path / "kept"
    table.keep_in(folder)
    table.add([flat("a"), flat("b", 0.2), flat("c", 0.3)])
    table.rename(1, "Bob")
    table.show([2], on=False)
    table.remove([0])
    again = CurveTable(model)
    again.keep_in(folder)
    assert [(c.name, c.colour, c.hidden) for c in again.curves] == [
        (c.name, c.colour, c.hidden) for c in table.curves
    ]
    assert names(again) == ["Bob", "c"]
    model.undo_stack.undo()
    third = CurveTable(model)
    third.keep_in(folder)
    assert sorted(names(third)) == ["Bob", "a", "c"]


def test_two_programs_at_once_keep_the_curves_of_both(table, model, tmp_path: Path) -> None:
    other = CurveTable(model)
    for each in (table, other):
        each.keep_in(tmp_path / "kept")
    table.add([flat("a")])
    other.add([flat("b", 0.2)])
    third = CurveTable(model)
    third.keep_in(tmp_path / "kept")
    assert sorted(names(third)) == ["a", "b"]


def test_a_damaged_file_is_said_and_stays(table, tmp_path: Path) -> None:
    (tmp_path / "00001.csv").write_text("shopping\n")
    table.keep_in(tmp_path)
    assert table.refused[0].startswith("00001.csv: a curve begins with")
    table.add([flat("a")])
    assert (tmp_path / "00001.csv").read_text() == "shopping\n"
    assert len(list(tmp_path.glob("*.csv"))) == 2


def test_a_folder_that_cannot_be_written_is_said(table, tmp_path: Path) -> None:
    (tmp_path / "kept").write_text("a file")
    table.keep_in(tmp_path / "kept")
    table.add([flat("a")])
    assert names(table) == ["a"]
    assert table.refused[0].startswith("The averaged spectra can't be kept for the next start: ")


def test_several_are_saved_under_their_names_and_none_is_replaced(table, tmp_path: Path) -> None:
    table.add([flat("Mara: a/b"), flat("b", 0.2)])
    (tmp_path / "b.csv").write_text("mine")
    table.save([0, 1], tmp_path)
    assert averaged_spectrum.load_averaged_spectrum(tmp_path / "Mara- a-b.csv").name == "Mara: a/b"
    assert averaged_spectrum.load_averaged_spectrum(tmp_path / "b (2).csv").name == "b"
    assert (tmp_path / "b.csv").read_text() == "mine"
    assert table.told == [f"2 curves saved in {tmp_path}"]
    with pytest.raises(CurveError, match="cannot be written"):
        table.save([0], tmp_path / "nowhere" / "a.csv")


@pytest.mark.parametrize(
    ("name", "file"), [("a/b", "a-b"), ("..", "curve"), ("", "curve"), ("Tom\n", "Tom"), ("con", "curve con")]
)
def test_any_name_is_the_name_of_a_file(name: str, file: str) -> None:
    assert portable_name(name) == file


# -- differences ----------------------------------------------------------------------------------------------


def test_differences_are_those_of_the_engine(table) -> None:
    stepped = replace(flat("b"), amplitudes=np.repeat([0.1, 0.01], 4))
    found = table.differences([flat("a"), stepped])
    assert [[round(d.decibels, 6) for d in row] for row in found] == [[0, 10], [10, 0]]
    assert found[0][1].words == "a and b: 10.0 dB, up to 7 Hz"


def test_curves_through_other_filters_are_measured_again_through_the_present_ones(
    table, model, part, tmp_path: Path, qtbot: QtBot
) -> None:
    hiss = sound_part(tmp_path / "hiss.wav", noise(0.5, 0.1))
    settings = model.in_force.settings
    old = average_parts([part], replace(settings, quantise=1), "old")
    new = average_parts([hiss], settings, "new")
    first = table.differences([old, new])
    assert np.isnan(first[0][1].decibels)
    assert "went through different filters" in first[0][1].words
    with qtbot.waitSignal(table.compared):
        pass
    found = table.differences([old, new])[0][1]
    assert found.decibels == pytest.approx(averaged_spectrum.distance_of(average_parts([part], settings, "old"), new))
    assert found.words.endswith("both measured again with the current filters")


def test_what_cannot_be_measured_again_is_said(table, model, part, tmp_path: Path, qtbot: QtBot) -> None:
    settings = model.in_force.settings
    new = average_parts([part], settings, "new")
    gone = replace(
        average_parts([part], replace(settings, quantise=1), "old"), parts=(part._replace(path=Path("x")),)
    )
    table.differences([new, gone])
    with qtbot.waitSignal(table.compared):
        pass
    for other in (gone, flat("old")):
        found = table.differences([new, other])[0][1]
        assert np.isnan(found.decibels)
        assert "old cannot be measured again, since" in found.words


def test_other_filters_compare_anew(table, model, part, qtbot: QtBot) -> None:
    table.differences([])
    with qtbot.waitSignal(table.compared):
        model.set_setting("quantise", 1)


def test_chosen_curves_are_measured_again_in_place(table, model, part, qtbot: QtBot) -> None:
    table.average("a", [part])
    qtbot.waitUntil(lambda: len(table.curves) == 1)
    table.rename(0, "mine")
    model.set_setting("quantise", 1)
    table.measure_again([0])
    qtbot.waitUntil(lambda: len(table.curves[0].frequencies) == 1024)
    assert names(table) == ["mine"]
    part.path.unlink()
    model.set_setting("quantise", 4)
    table.measure_again([0])
    qtbot.waitUntil(lambda: bool(table.refused))
    assert table.refused == [
        "mine cannot be measured again, since a.wav is not there any more; put it back, or average another sound"
    ]
    assert len(table.curves[0].frequencies) == 1024
