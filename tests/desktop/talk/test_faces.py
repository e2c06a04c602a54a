"""Whose face the head has: meshes of one's own, their movestates, and the tables that move them."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from phonemeengine.mouth.files.io import FaceFiles, load_morph_mesh, save_morph_targets
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import Head, MorphTargets, load_head, morph_targets_of
from phonemeengine.mouth.movestate import movestate_of
from phonemeengine.phonemes import Phoneme
from tests.conftest import ROOT
from tests.desktop.hands import FileAnswers, button, click
from tests.desktop.stage import Stage
from tests.desktop.talk.desk import drawn
from tests.glb_faces import face_with_targets
from tests.meshes import CUBE_OBJ

# -- without a window ---------------------------------------------------------------------------------


def test_a_mesh_with_other_movestates_is_moved_by_the_table_that_fits(stage: Stage, tmp_path: Path) -> None:
    (tmp_path / "own.glb").write_bytes(face_with_targets(("A", "I", "U", "E", "O")))
    stage.talking.face.load(FaceFiles(tmp_path / "own.glb"))
    stage.settle()
    assert stage.talking.table_name == "vrm"
    assert stage.talking.face.name == "own.glb"
    stage.play(0.9)
    assert stage.talking.percentages["A"] > 20
    (tmp_path / "alike.glb").write_bytes(face_with_targets(("jaw_open", "Mouth Close")))  # whoever wrote the names
    stage.talking.face.load(FaceFiles(tmp_path / "alike.glb"))
    stage.settle()
    stage.talking.press(Phoneme.A)
    stage.wait(0.5)
    assert stage.talking.percentages["jaw_open"] > 20
    mesh = load_morph_mesh(tmp_path / "own.glb").mesh.positions
    state = movestate_of("jawOpen", [[0, 1, 0]] * len(mesh))
    save_morph_targets(MorphTargets((state,), state.numbers, mesh[state.numbers]), tmp_path / "own.3dm")
    stage.talking.face.load(FaceFiles(tmp_path / "own.glb", tmp_path / "own.3dm"))  # from a file of their own
    stage.settle()
    assert list(stage.talking.percentages) == ["jawOpen"]
    assert not stage.failed


def test_a_bad_mesh_is_refused_in_one_sentence_and_the_face_stays(stage: Stage, tmp_path: Path) -> None:
    before = stage.talking.face.morph_mesh
    for content, told in (
        (b"glTF" + bytes(40), "own.glb: "),
        (face_with_targets(()), ".3dm"),
        (face_with_targets(("grumpy", "wide")), "grumpy"),  # which no table knows
    ):
        (tmp_path / "own.glb").write_bytes(content)
        stage.talking.face.load(FaceFiles(tmp_path / "own.glb"))
        stage.settle()
        (sentence,) = stage.failed
        assert told in sentence
        assert "\n" not in sentence
        assert (stage.talking.face.morph_mesh is before) == (told != "grumpy")
        stage.failed.clear()


def test_a_table_of_ones_own_is_loaded_and_one_that_moves_nothing_refused(stage: Stage, tmp_path: Path) -> None:
    stage.talking.set_table("oculus")
    assert "arkit" in stage.failed.pop()
    assert stage.talking.table_name == "arkit"
    text = (Path(load_head.__code__.co_filename).parent / "tables" / "five.toml").read_text()
    (tmp_path / "mine.toml").write_text(text.replace('name = "Five mouth shapes"', 'name = "mine"'))
    stage.talking.set_table(str(tmp_path / "mine.toml"))
    stage.settle()
    assert stage.talking.table.name == "mine"
    stage.talking.set_table(str(tmp_path / "none.toml"))
    stage.settle()
    (sentence,) = stage.failed
    assert sentence.startswith("none.toml: ")
    assert stage.talking.table.name == "mine"


# -- in the window ---------------------------------------------------------------------------------


def test_woman_and_man_are_chosen_by_a_click_and_the_choice_is_kept(window, desktop, qtbot):
    choices = window.talk.choices
    assert not choices.heads[Head.WOMAN].isEnabled()
    click(choices.heads[Head.MAN])
    qtbot.waitUntil(lambda: choices.face.text() == "Man")
    assert desktop.talking.face.head is Head.MAN
    assert [button.isEnabled() for button in choices.heads.values()] == [True, False]
    window.talk_parts.dialogs.save()
    desktop.talking.face.files = FaceFiles()
    window.talk_parts.dialogs.restore()
    assert desktop.talking.face.files == FaceFiles(Path("man"))


def test_several_meshes_are_one_face_which_is_kept(window, desktop, qtbot, tmp_path):
    for name, corner in (("face", b"1 1 1"), ("jawOpen", b"1 1.5 1"), ("mouthClose", b"1 1 1.2")):
        (tmp_path / f"{name}.obj").write_bytes(CUBE_OBJ.replace(b"v 1 1 1\n", b"v " + corner + b"\n"))
    window.files.show = FileAnswers(*(tmp_path / f"{name}.obj" for name in ("jawOpen", "mouthClose", "face")))
    click(window.talk.choices.own)
    qtbot.waitUntil(lambda: window.talk.choices.face.text() == "face.obj")
    assert [*desktop.talking.percentages] == ["jawOpen", "mouthClose"]
    files = desktop.talking.face.files
    window.talk_parts.dialogs.save()
    desktop.talking.face.files = FaceFiles()
    window.talk_parts.dialogs.restore()
    assert desktop.talking.face.files == files
    assert desktop.talking.in_use.movestates == (tmp_path / "jawOpen.obj", tmp_path / "mouthClose.obj")


def test_a_mesh_of_ones_own_is_shown_unless_it_cannot_and_the_programs_head_again(window, desktop, qtbot, tmp_path):
    head, choices, face = window.talk.head, window.talk.choices, desktop.talking.face
    (tmp_path / "bad.obj").write_text("v 0 0 zero\n")
    window.files.show = FileAnswers(tmp_path / "bad.obj")
    click(button(window.talk, "Load Face…"))
    qtbot.waitUntil(lambda: window.banner.label.text().startswith("bad.obj: "))
    assert face.head is Head.WOMAN
    assert choices.face.text() == "Woman"
    (tmp_path / "own.glb").write_bytes(face_with_targets(("A", "I", "U", "E", "O")))
    window.files.show = FileAnswers(tmp_path / "own.glb")
    click(choices.own)
    qtbot.waitUntil(lambda: choices.face.text() == "own.glb")
    assert choices.table.currentData() == "vrm"
    assert [name for name, _ in window.talk.bars.rows] == ["A", "I", "U", "E", "O"]
    n_drawn = head.surface.n_drawn
    qtbot.waitUntil(lambda: head.surface.n_drawn > n_drawn)
    points = mesh_of([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    save_morph_targets(morph_targets_of(points, [movestate_of("jawOpen", [[0, 1, 0]] * 3)]), tmp_path / "points.glb")
    window.talk_parts.dialogs.open([tmp_path / "points.glb"])  # as one that is dropped
    qtbot.waitUntil(lambda: head.trouble.startswith("The head cannot be shown: the mesh has no triangles"))
    click(choices.heads[Head.WOMAN])
    qtbot.waitUntil(lambda: not head.trouble)
    assert "jawOpen" in desktop.talking.percentages
    drawn(head, qtbot)


def test_a_window_with_opengl_draws_the_head_with_it(graphics):
    if shutil.which("xvfb-run") is None:
        pytest.skip("there is no Xvfb")
    command = ["xvfb-run", "-a", "-s", "-screen 0 1400x900x24", sys.executable, "-m", "tests.desktop.talk.gl_window"]
    environment = {name: value for name, value in os.environ.items() if name != "QT_QPA_PLATFORM"}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    answer = json.loads(done.stdout)
    assert answer["software"]  # Xvfb has no graphics card, so the program would rather draw pictures
    for seen, brightness in zip(answer["seen"], (200, 0), strict=True):
        red, green, blue = seen["middle"]
        assert seen["kind"] == "GlSurface"
        assert red > green > blue  # skin
        assert brightness <= min(seen["corner"]) <= brightness + 60
