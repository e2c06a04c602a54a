"""`phonemeanalyser export`: sound files in, files of other programs out."""

import json
from pathlib import Path

import numpy as np
import pytest
import soundfile
from pygltflib import GLTF2

from phonemeanalyser.cli.main import main
from phonemeanalyser.cli.window import DEMO
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.blendshape_names import ARKIT, TONGUE
from phonemeengine.mouth.curves_file import read_curves
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.key_layer import KeyCurve, KeyLayer, keys_beside, write_keys
from phonemeengine.mouth.morph_mesh import load_head
from phonemeengine.settings import SAMPLE_RATE
from tests.glb_faces import face_with_targets
from tests.sounds import silence
from tests.tables import Capsys, outputs_in, refused


def exported(*words: object) -> None:
    assert main(["export", *(str(word) for word in words)]) == 0


def test_a_format_is_printed_or_written_alike(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    exported(sound, "--format", "livelink-csv")
    said = capsys.readouterr()
    assert said.err == ""
    exported(sound, "--format", "livelink-csv", "-o", tmp_path / "out")
    target = tmp_path / "out" / "speech.livelink.csv"
    assert target.read_text(encoding="utf-8") == said.out
    assert [path for path in (tmp_path / "out").rglob("*") if path.is_file()] == [target]


def test_the_demo_opens_and_closes_the_mouth_of_rhubarb(capsys: Capsys) -> None:
    exported(DEMO, "--format", "rhubarb-json")
    document = json.loads(capsys.readouterr().out)
    assert document["metadata"]["soundFile"] == "demo.flac"
    assert {cue["value"] for cue in document["mouthCues"]} >= set("ABDX")


def test_a_face_is_animated(sound: Path, tmp_path: Path) -> None:
    face = tmp_path / "face.glb"
    face.write_bytes(face_with_targets(ARKIT))
    exported(sound, "--format", "gltf", "--mesh", face, "--fps", 25, "-o", tmp_path / "talking.glb")
    gltf = GLTF2().load(str(tmp_path / "talking.glb"))
    assert gltf is not None
    sampler = gltf.animations[0].samplers[0]
    n_frames = gltf.accessors[sampler.input].count
    assert 0 <= n_frames - int(soundfile.info(sound).duration * 25) - 1 < 0.3 * 25  # until the mouth is at rest
    assert gltf.accessors[sampler.output].count == n_frames * 52
    assert gltf.meshes[0].extras["targetNames"] == list(ARKIT)


def test_edited_keys_beside_a_sound_move_its_blend_shapes_and_a_clip_of_it(sound: Path, tmp_path: Path) -> None:
    keys = KeyLayer({"mouthPucker": KeyCurve(np.array([0.1, 0.2, 0.3]), np.array([0, 0.8, 0.0]))})
    write_keys(keys, keys_beside(sound))
    found = {}
    for name, words in (("plain", []), ("edited", ["--keys", "auto"])):
        exported(sound, "--format", "curves-json", *words, "-o", tmp_path / f"{name}.json")
        curves = read_curves(tmp_path / f"{name}.json")
        found[name] = Animation(curves.rate, curves.movestates, curves.weights, curves.head)
    assert found["edited"].weights == pytest.approx(found["plain"].edited(keys).weights, abs=2e-4)
    assert np.any(found["edited"].weights != found["plain"].weights)
    clips = [tmp_path / name for name in ("plain.gif", "edited.gif")]
    for clip, words in zip(clips, ([], ["--keys", "auto"]), strict=True):
        assert main(["preview", str(sound), "-o", str(clip), "--size", "64x64", "--fps", "5", *words]) == 0
    assert clips[0].read_bytes() != clips[1].read_bytes()


def test_the_programs_own_head_is_animated_where_no_other_is_named(sound: Path, tmp_path: Path) -> None:
    exported(sound, "--format", "gltf", "--fps", 25, "-o", tmp_path / "talking.glb")
    gltf, head = GLTF2().load(str(tmp_path / "talking.glb")), load_head()
    assert gltf is not None
    (primitive,) = gltf.meshes[0].primitives
    assert gltf.accessors[primitive.attributes.POSITION].count == len(head.mesh)
    names = gltf.meshes[0].extras["targetNames"]
    assert sorted(names) == sorted((*ARKIT, *TONGUE))
    (channel, turning), (sampler, turned) = gltf.animations[0].channels, gltf.animations[0].samplers
    assert (gltf.nodes[channel.target.node].mesh, channel.target.path) == (0, "weights")
    form = gltf.accessors[sampler.output]
    begin = gltf.bufferViews[form.bufferView].byteOffset
    weights = np.frombuffer(gltf.binary_blob(), "<f4", form.count, begin).reshape(-1, len(names))
    assert weights[:, names.index("jawOpen")].max() > 0.2
    assert (turning.target.node, turning.target.path) == (channel.target.node, "rotation")
    assert gltf.accessors[turned.output].type == "VEC4"


def test_wishes_reach_the_format(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    words = (sound, "--format", "curves-json", "--fps", 25, "--minimum", 0.1, "--anticipation", 0, "--table", "five")
    exported(*words, "--no-blinks", "--no-head", "--seed", 3)
    document = json.loads(capsys.readouterr().out)
    assert (document["rate"], document["table"], document["head"]) == (25, "Five mouth shapes", [])
    assert all(cue["end"] - cue["start"] > 0.0999 for cue in document["cues"])
    assert not any(curve["name"].startswith("eye") for curve in document["curves"])
    exported(*words, "--no-blinks", "--no-head", "--seed", 4)
    other = json.loads(capsys.readouterr().out)
    assert other["cues"] == document["cues"]
    assert other["curves"] != document["curves"]


def test_a_folder_is_walked_and_what_cannot_be_read_is_said_and_passed_over(
    sound: Path, tmp_path: Path, capsys: Capsys
) -> None:
    folder = tmp_path / "sounds"
    (folder / "deep").mkdir(parents=True)
    (folder / "a.wav").write_bytes(sound.read_bytes())
    (folder / "b.wav").write_bytes(b"no sound at all")
    (folder / "deep" / "c.wav").write_bytes(sound.read_bytes())
    assert main(["export", str(folder), "--format", "textgrid", "-o", str(tmp_path / "out")]) == 1
    said = capsys.readouterr()
    lines = [line for line in said.err.splitlines() if line.startswith("phonemeanalyser: ")]
    assert len(lines) == 1
    assert lines[0].startswith("phonemeanalyser: b.wav: ")
    assert outputs_in(tmp_path / "out") == ["a.mouth.TextGrid", "deep/c.mouth.TextGrid"]


@pytest.mark.parametrize("out", ["project.pgo", "deep/project.pgo", "deep", None])
def test_papagayo_finds_the_sound_wherever_the_project_lies_and_whoever_wrote_it(
    out: str | None, sound: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capsys
) -> None:
    for folder, name in ((tmp_path, "speech.wav"), (tmp_path / "elsewhere", "../speech.wav")):
        folder.mkdir(exist_ok=True)
        monkeypatch.chdir(folder)
        exported(name, "--format", "papagayo-pgo", *([] if out is None else ["-o", out]))
        text = capsys.readouterr().out
        if out is not None:
            project = folder / out / "speech.pgo" if out == "deep" else folder / out
            text = project.read_text(encoding="utf-8")
        monkeypatch.chdir("/")
        named = text.splitlines()[1]
        assert Path(named).is_absolute()
        assert Path(named).samefile(sound)


def test_silence_is_a_mouth_at_rest(tmp_path: Path, capsys: Capsys) -> None:
    soundfile.write(tmp_path / "silence.wav", silence(0.5), SAMPLE_RATE)
    exported(tmp_path / "silence.wav", "--format", "rhubarb-tsv")
    assert capsys.readouterr().out == "0.00\tX\n0.50\tX\n"
    exported(tmp_path / "silence.wav", "--format", "moho-dat")
    assert capsys.readouterr().out == "MohoSwitch1\n1 rest\n13 rest\n"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--format", "gltf"), "gltf is no text to be printed; name a file or a folder with -o"),
        (
            ("--format", "gltf", "--mesh", "a.glb", "-o", "o.glb"),
            "a.glb: there is no such file; check its name and folder",
        ),
        (("--format", "anno", "--keys", "auto"), "anno holds no edited keys; leave them out, or choose livelink-csv"),
        (("--format", "gltf", "-o", "o.glb", "--keys", "gone.keys.toml"), "gone.keys.toml: there is no such file"),
        (("--format", "anno", "--fps", "25"), "anno counts no frames, so it has no frame rate; leave it out"),
        (("--format", "anno", "--minimum", "7"), "minimum must lie in 0..1 s, got 7; choose another"),
        (("--format", "anno", "--anticipation", "1"), "anticipation must lie in 0..0.12 s, got 1; choose another"),
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
    write_keys(KeyLayer({"jawOpen": KeyCurve(np.array([0.1, 0.2]), np.zeros(2))}), keys_beside(sound))
    assert refused(capsys, "export", sound, *words).startswith(sentence)


def test_help_names_every_format_and_what_reads_it(capsys: Capsys) -> None:
    with pytest.raises(SystemExit) as end:
        main(["export", "--help"])
    assert end.value.code == 0
    said = capsys.readouterr().out
    assert all(f"  {name}" in said for name in FORMATS)
    assert "Papagayo-NG (24 fps, anticipation 0.04 s, table preston-blair)" in said


@pytest.mark.parametrize(
    ("name", "kind"), [("x.glb", "gltf"), ("x.LiveLink.csv", "livelink-csv"), ("x.curves.json", "curves-json")]
)
def test_the_ending_of_a_file_says_its_format_where_one_alone_ends_so(
    name: str, kind: str, sound: Path, tmp_path: Path
) -> None:
    assert main(["export", str(sound), "-o", str(tmp_path / name)]) == 0
    assert main(["export", str(sound), "-o", str(tmp_path / "named"), "--format", kind, "--overwrite"]) == 0
    (named,) = (tmp_path / "named").iterdir()
    assert (tmp_path / name).read_bytes() == named.read_bytes()


def test_standard_output_has_what_a_file_would_have(
    sound: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfdbinary: pytest.CaptureFixture[bytes]
) -> None:
    monkeypatch.chdir(tmp_path)
    for kind in ("rhubarb-tsv", "gltf"):
        words = ["export", str(sound), "--format", kind, "-o"]
        assert main([*words, "-"]) == 0
        printed = capfdbinary.readouterr().out
        assert main([*words, str(tmp_path / "file.x")]) == 0
        assert printed == (tmp_path / "file.x").read_bytes()
        (tmp_path / "file.x").unlink()
    assert [path.name for path in tmp_path.iterdir()] == [sound.name]


@pytest.mark.skipif(not Path("/dev/full").is_char_device(), reason="this system has no device that is always full")
def test_a_full_disk_is_told_once(sound: Path, capsys: Capsys) -> None:
    said = refused(capsys, "export", sound, "--format", "anno", "-o", "/dev/full")
    assert said == "/dev/full: cannot be written (No space left on device); choose another place"
    assert Path("/dev/full").is_char_device()
