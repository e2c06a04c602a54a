"""A face with shapes of its own names: the guess, its table, what the sliders show, and the table that is saved."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QDialogButtonBox, QWidget
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.talk.head.mapping_dialog import FaceMappingDialog
from phonemeengine.mouth.face_mapping import FaceMapping, mapped_table
from phonemeengine.mouth.files.io import FaceFiles
from phonemeengine.mouth.table import load_table, table_to_toml
from phonemeengine.phonemes import Phoneme
from tests.desktop.stage import Stage
from tests.glb_faces import face_with_targets

NAMES = ("Mouth Open", "Smile_L", "Smile_R", "Blink", "hat")


def asked_of(stage: Stage, folder: Path, names: tuple[str, ...]) -> list[bool]:
    """Give what the model asks for, once it has a face with these shapes."""
    asked: list[bool] = []
    stage.talking.shapes_unknown.connect(lambda: asked.append(True))
    (folder / "own.glb").write_bytes(face_with_targets(names))
    stage.talking.face.load(FaceFiles(folder / "own.glb"))
    stage.settle()
    return asked


@pytest.fixture
def asked(stage: Stage, tmp_path: Path) -> list[bool]:
    """What the model asked for, once it has a face with shapes of its own."""
    return asked_of(stage, tmp_path, NAMES)


@pytest.fixture
def dialog(stage: Stage, asked: list[bool], qtbot: QtBot) -> Iterator[FaceMappingDialog]:
    parent = QWidget()
    qtbot.addWidget(parent)
    dialog = FaceMappingDialog(stage.talking.face, parent)
    dialog.show()
    yield dialog
    parent.deleteLater()


def test_shapes_that_no_table_knows_are_asked_about_once(asked: list[bool]) -> None:
    assert asked == [True]


@pytest.mark.parametrize(
    ("names", "asked"), [(("aa", "oh", *NAMES), [True]), (("aa", "ih", "ou", "ee", "oh", *NAMES), [])]
)
def test_shapes_are_asked_about_where_a_table_knows_less_than_half(
    stage: Stage, tmp_path: Path, names: tuple[str, ...], asked: list[bool]
) -> None:
    assert asked_of(stage, tmp_path, names) == asked
    assert stage.talking.table_name == "vrm1"


def test_a_guess_is_shown_with_what_is_left_over(dialog: FaceMappingDialog) -> None:
    assert dialog.boxes["jawOpen"].currentText() == "Mouth Open"
    assert dialog.boxes["mouthSmileLeft"].currentText() == "Smile_L"
    assert dialog.boxes["tongueOut"].currentText() == "–"
    assert not dialog.sliders["tongueOut"].isEnabled()
    assert dialog.left.toolTip() == "hat"


def test_a_slider_shows_its_shape_until_the_dialog_is_left(stage: Stage, dialog: FaceMappingDialog) -> None:
    dialog.sliders["mouthSmileLeft"].setValue(60)
    stage.wait(0.1)
    assert stage.talking.percentages == {"Mouth Open": 0, "Smile_L": 60, "Smile_R": 0, "Blink": 0, "hat": 0}
    dialog.sliders["eyeBlinkLeft"].setValue(100)
    dialog.sliders["eyeBlinkRight"].setValue(100)
    stage.wait(0.1)
    assert stage.talking.percentages["Blink"] == 100
    dialog.reject()
    stage.wait(0.1)
    assert stage.talking.percentages["Smile_L"] == 0


def test_a_shape_is_chosen_from_all_of_the_face(dialog: FaceMappingDialog) -> None:
    box = dialog.boxes["tongueOut"]
    box.fill()
    place = box.findData("hat")
    box.setCurrentIndex(place)
    box.activated.emit(place)
    assert dialog.mapping.targets["tongueOut"] == {"hat": 100.0}
    assert dialog.left.toolTip() == ""
    dialog.choose("jawOpen", "")
    assert dialog.left.toolTip() == "Mouth Open"


def test_one_shape_for_both_sides_moves_by_half_from_each(dialog: FaceMappingDialog) -> None:
    dialog.choose("mouthFrownLeft", "hat")
    dialog.choose("mouthFrownRight", "hat")
    assert dialog.mapping.targets["mouthFrownLeft"] == dialog.mapping.targets["mouthFrownRight"] == {"hat": 50.0}
    dialog.choose("mouthFrownRight", "")
    assert dialog.mapping.targets["mouthFrownLeft"] == {"hat": 100.0}


def test_the_saved_table_moves_and_blinks_the_face(stage: Stage, dialog: FaceMappingDialog, tmp_path: Path) -> None:
    chosen: list[FaceMapping] = []
    dialog.chosen.connect(chosen.append)
    dialog.buttons.button(QDialogButtonBox.StandardButton.Cancel)
    dialog.accept()
    (mapping,) = chosen
    (tmp_path / "own.toml").write_text(table_to_toml(mapped_table(mapping, "own")), encoding="utf-8")
    stage.talking.set_table(str(tmp_path / "own.toml"))
    stage.settle()
    assert stage.talking.table_name == str(tmp_path / "own.toml")
    stage.talking.press(Phoneme.A)
    stage.wait(0.5)
    assert stage.talking.percentages["Mouth Open"] > 20
    stage.talking.release()
    lids = []
    for _ in range(200):
        stage.wait(0.05)
        lids.append(stage.talking.percentages["Blink"])
    assert max(lids) > 50
    assert load_table(stage.talking.table_name).targets == mapping.targets
    assert not stage.failed
