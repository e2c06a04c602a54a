"""`phonemeanalyser preview`: a sound file in, a head that says it out."""

import sys
from pathlib import Path

import av
import numpy as np
import pytest
import soundfile
from PIL import Image

from phonemeanalyser.cli.main import main
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.files.io import save_morph_targets
from phonemeengine.mouth.morph_mesh import MorphMesh, morph_targets_of
from phonemeengine.mouth.table import TABLES
from phonemeengine.settings import SAMPLE_RATE
from tests.conftest import SPEECH
from tests.glb_faces import face_with_targets
from tests.graphics import context_or_skip
from tests.meshes import CUBE_OBJ, morph_mesh_of_cube
from tests.sounds import silence
from tests.tables import Capsys, outputs_in, refused

SMALL = ("--size", "64x48", "--fps", "10")
N_FRAMES = 10
"""Of the 0.85 s of speech at 10 fps, and until the mouth is at rest: 0, 1/10, ... 0.9."""
FEW = ("--fps", "4")
"""Pictures are slow to draw without a graphics card."""


@pytest.fixture(scope="module", autouse=True)
def _graphics() -> None:
    context_or_skip().release()


def pictures(folder: Path) -> np.ndarray:
    return np.stack([np.asarray(Image.open(path)) for path in sorted(folder.iterdir())])


def shot(sound: Path, out: Path, *words: object) -> np.ndarray:
    assert main(["preview", str(sound), "-o", str(out), *SMALL, *(str(word) for word in words)]) == 0
    return pictures(out)


def test_a_film_goes_on_until_the_mouth_is_at_rest_and_has_the_sound(sound: Path, tmp_path: Path):
    assert main(["preview", str(sound), "-o", str(tmp_path / "new" / "film.mp4"), *SMALL]) == 0
    with av.open(tmp_path / "new" / "film.mp4") as film:
        (video,), (audio,) = film.streams.video, film.streams.audio
        assert (video.width, video.height, float(video.average_rate)) == (64, 48, 10)
        assert (audio.rate, audio.layout.name) == (SAMPLE_RATE, "mono")
        frames = list(film.decode(video))
    assert len(frames) == N_FRAMES
    assert [float(frame.pts * frame.time_base) for frame in frames] == pytest.approx(np.arange(N_FRAMES) / 10)
    with av.open(tmp_path / "new" / "film.mp4") as film:
        heard = np.concatenate([frame.to_ndarray()[0] for frame in film.decode(audio=0)])
    speech = soundfile.read(sound, dtype="float32")[0]
    n = min(len(heard), len(speech))
    assert abs(len(heard) - len(speech)) <= 2048
    assert np.corrcoef(heard[:n], speech[:n])[0, 1] > 0.9


def test_both_sides_of_a_stereo_sound_are_in_the_film(stereo: Path, tmp_path: Path):
    assert main(["preview", str(stereo), "-o", str(tmp_path / "film.mp4"), *SMALL, *FEW]) == 0
    with av.open(tmp_path / "film.mp4") as film:
        assert film.streams.audio[0].layout.name == "stereo"
        left, right = np.concatenate([frame.to_ndarray() for frame in film.decode(audio=0)], axis=1)
    assert np.square(right).mean() < 0.01 * np.square(left).mean()


def test_a_gif_keeps_the_time_of_the_sound(tmp_path: Path):
    sound, out = tmp_path / "sound.wav", tmp_path / "film.GIF"
    soundfile.write(sound, SPEECH[: SAMPLE_RATE // 4], SAMPLE_RATE)
    assert main(["preview", str(sound), "-o", str(out), "--size", "48x48", "--fps", "30"]) == 0
    with Image.open(out) as film:
        assert film.size == (48, 48)
        assert film.n_frames > 6
        total = 0
        for frame in range(film.n_frames):
            film.seek(frame)
            total += film.info["duration"]
    assert total == pytest.approx(14 / 30 * 1000, abs=10)  # until the mouth is at rest


def test_blue_eyes_stay_blue_in_a_gif(tmp_path: Path):
    soundfile.write(tmp_path / "silence.wav", silence(0.1), SAMPLE_RATE)
    words = ("--mesh", "man", "--size", "200x200", "--fps", "2", "--no-blinks")
    assert main(["preview", str(tmp_path / "silence.wav"), "-o", str(tmp_path / "a.gif"), *words]) == 0
    assert main(["preview", str(tmp_path / "silence.wav"), "-o", str(tmp_path / "a"), *words]) == 0
    true = pictures(tmp_path / "a")[0].astype(int)
    blue = true[..., 2] > true[..., 0] + 20
    with Image.open(tmp_path / "a.gif") as film:
        near = np.asarray(film.convert("RGB")).astype(int)
    assert blue.sum() > 20
    assert np.mean(near[blue, 2] > near[blue, 0] + 8) > 0.8
    assert np.abs(near - true).mean() < 2


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of pictures in which the mouth alone moves."""
    context_or_skip().release()
    folder = tmp_path_factory.mktemp("plain")
    soundfile.write(folder / "speech.wav", SPEECH, SAMPLE_RATE, subtype="FLOAT")
    shot(folder / "speech.wav", folder / "out", *FEW, "--no-blinks", "--no-head")
    return folder / "out"


def test_a_folder_gets_a_picture_of_every_frame_and_the_mouth_moves(plain: Path):
    frames = pictures(plain)
    assert frames.shape == (5, 48, 64, 3)
    assert sorted(path.name for path in plain.iterdir())[::4] == ["000000.png", "000004.png"]
    moving = np.ptp(frames.astype(int), axis=0).max(axis=2) > 30
    rows, columns = np.argwhere(moving).T
    assert moving.sum() > 5
    assert frames[:, 0, 0].min() > 200, "the theme is the light one"
    assert np.median(rows) > 24  # below the middle
    assert 20 < columns.mean() < 34, "the mouth is in the middle, or a little to the left: the camera is aside"


@pytest.mark.long
def test_the_same_seed_gives_the_same_face_and_another_one_another(sound: Path, tmp_path: Path):
    runs = (("a", 5), ("b", 5), ("c", 6))
    one, same, other = (shot(sound, tmp_path / name, "--fps", 2, "--seed", n) for name, n in runs)
    assert np.array_equal(one, same)
    assert not np.array_equal(one, other)


def test_in_silence_a_face_without_life_stays_still(tmp_path: Path):
    soundfile.write(tmp_path / "silence.wav", silence(0.4), SAMPLE_RATE)
    still = shot(tmp_path / "silence.wav", tmp_path / "still", *FEW, "--no-blinks", "--no-head")
    assert np.ptp(still.astype(int), axis=0).max() == 0
    alive = shot(tmp_path / "silence.wav", tmp_path / "alive", *FEW, "--size", "200x200")
    assert np.ptp(alive.astype(int), axis=0).max() > 20


def test_a_face_of_ones_own_is_moved_by_its_own_movestates(sound: Path, tmp_path: Path):
    (tmp_path / "face.glb").write_bytes(face_with_targets(ARKIT))
    frames = shot(sound, tmp_path / "out", "--mesh", tmp_path / "face.glb", "--no-head", "--theme", "dark")
    assert frames.shape == (N_FRAMES, 48, 64, 3)
    assert frames[:, 0, 0].max() < 60


def test_a_mesh_is_moved_by_a_file_of_movestates(sound: Path, tmp_path: Path):
    cube = morph_mesh_of_cube()
    (tmp_path / "cube.obj").write_bytes(CUBE_OBJ)
    save_morph_targets(morph_targets_of(cube.mesh, cube.states), tmp_path / "cube.3dm")
    table = (TABLES / "vrm.toml").read_text(encoding="utf-8")
    table = table.replace('movestates = "vrm"', 'movestates = ["lid up", "A", "I", "U", "E", "O"]')
    (tmp_path / "lid.toml").write_text(table.replace("A =", '"lid up" ='), encoding="utf-8")
    words = ("--mesh", tmp_path / "cube.obj", "--movestates", tmp_path / "cube.3dm", "--table", tmp_path / "lid.toml")
    frames = shot(sound, tmp_path / "out", *words, *FEW, "--no-head")
    assert np.ptp(frames.astype(int), axis=0).max() > 60


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("-o", "a.avi"), "a.avi: a preview is an .mp4, a .gif or a folder; name one of them with -o"),
        (("-o", "a.mp4", "--size", "65x48"), "an .mp4 has an even width and height, got 65x48; choose another size"),
        (
            ("-o", "a.gif", "--fps", "60"),
            "a .gif shows at most 50 frames per second, got 60; choose fewer, or an .mp4",
        ),
        (("-o", "a", "--fps", "0.5"), "the frame rate must lie in 1..240 frames per second, got 0.5; choose another"),
        (("-o", "full"), "full: this folder is not empty; name another one for the pictures"),
        (("-o", "old"), "old: there are pictures already; name another folder, or replace them with --overwrite"),
        (("-o", "full/mine/a.mp4"), "full/mine/a.mp4: cannot be written ("),
        (("-o", "a", "--mesh", "gone.obj"), "gone.obj: there is no such file; check its name and folder"),
        (("-o", "a", "--movestates", "f.3dm"), "f.3dm: movestates move a mesh of their own; name it with --mesh"),
        (("-o", "a", "--mesh", "cube.obj"), "cube.obj: there are no morph targets in it; name its movestates with"),
        (
            ("-o", "a", "--mesh", "cube.obj", "--movestates", "cube.3dm"),
            "the mesh has none of the table's movestates",
        ),
    ],
)
def test_what_cannot_be_done_is_said_in_one_sentence(
    words: tuple[str, ...],
    sentence: str,
    sound: Path,
    tmp_path: Path,
    capsys: Capsys,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "mine").write_text("mine")
    (tmp_path / "old").mkdir()
    (tmp_path / "old" / "000000.png").touch()
    (tmp_path / "cube.obj").write_bytes(CUBE_OBJ)
    cube: MorphMesh = morph_mesh_of_cube()
    save_morph_targets(morph_targets_of(cube.mesh, cube.states), tmp_path / "cube.3dm")
    assert refused(capsys, "preview", sound, *words, *(() if "--fps" in words else ("--fps", "5"))).startswith(
        sentence
    )
    assert not [path for path in tmp_path.rglob("*") if path.suffix in {".part", ".mp4", ".gif"}]
    assert (tmp_path / "full" / "mine").read_text() == "mine"


def test_no_sound_no_preview(tmp_path: Path, capsys: Capsys):
    (tmp_path / "a.wav").write_bytes(b"no sound at all")
    assert refused(capsys, "preview", tmp_path / "a.wav", "-o", tmp_path / "a.mp4").startswith("a.wav: ")
    assert refused(capsys, "preview", tmp_path / "b.wav", "-o", tmp_path / "b.mp4").startswith("b.wav: ")
    assert not list(tmp_path.glob("*.mp4"))


def test_a_sound_that_is_too_long_for_a_gif_is_said_before_the_work(tmp_path: Path, capsys: Capsys):
    soundfile.write(tmp_path / "long.flac", silence(37.0)[::5], SAMPLE_RATE // 5)
    said = refused(capsys, "preview", tmp_path / "long.flac", "-o", tmp_path / "a.gif", "--fps", "50")
    assert said == "a .gif holds at most 1800 frames, this would have 1851; choose fewer, or an .mp4"


def test_without_the_library_for_films_a_folder_is_offered(
    sound: Path, tmp_path: Path, capsys: Capsys, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setitem(sys.modules, "av", None)
    said = refused(capsys, "preview", sound, "-o", tmp_path / "film.mp4")
    assert said.startswith("an .mp4 needs the package av, which cannot be loaded (")
    assert said.endswith("); install it with: pip install 'phonemeanalyser[preview]', or name a .gif or a folder")


@pytest.mark.parametrize(
    ("module", "words"),
    [("preview", ["preview", "a.wav"]), ("recording_clip", ["performance", "show", "a.sqlite", "one"])],
)
def test_without_the_packages_of_previews_one_sentence_says_which_extra_has_them(
    module: str, words: list[str], capsys: Capsys, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setitem(sys.modules, f"phonemeanalyser.cli.{module}", None)
    said = refused(capsys, *words, "-o", "a")
    assert said.startswith("previews need packages that cannot be loaded (")
    assert said.endswith("); install them with: pip install 'phonemeanalyser[preview]'")


@pytest.mark.long
def test_how_closely_the_mouth_follows_is_told_as_to_the_exports(sound: Path, plain: Path, tmp_path: Path):
    usual = pictures(plain)
    for k, words in enumerate((["--detail", "loudness"], ["--anticipation", 0])):
        other = shot(sound, tmp_path / f"other{k}", *FEW, "--no-blinks", "--no-head", *words)
        assert len(other) in (len(usual), len(usual) + 1), "a mouth that is not ahead is at rest later"
        assert (other[: len(usual)] != usual).any(), words


@pytest.mark.parametrize("jobs", ["1", pytest.param("2", marks=pytest.mark.long)])
def test_a_folder_of_sounds_becomes_a_folder_of_clips(jobs: str, tmp_path: Path, capsys):
    folder, out = tmp_path / "sounds", tmp_path / "out"
    folder.mkdir()
    for name in ("a.wav", "b.wav"):
        soundfile.write(folder / name, SPEECH[: SAMPLE_RATE // 4], SAMPLE_RATE)
    (folder / "c.wav").write_bytes(b"no sound")
    words = ["preview", str(folder), "-o", str(out), "--format", "gif", *SMALL, *FEW, "--jobs", jobs]
    assert main(words) == 1
    assert "c.wav" in capsys.readouterr().err
    assert outputs_in(out) == ["a.gif", "b.gif"]
    before = (out / "a.gif").stat().st_mtime_ns
    assert main([*words[:-1], "1"]) == 1
    assert (out / "a.gif").stat().st_mtime_ns == before


def test_the_name_of_a_single_clip_says_what_it_is(sound: Path, tmp_path: Path, capsys):
    with pytest.raises(SystemExit):
        main(["preview", str(sound), "-o", str(tmp_path / "a.gif"), "--format", "gif"])
    assert "for one, end the name of OUT with the format" in capsys.readouterr().err
