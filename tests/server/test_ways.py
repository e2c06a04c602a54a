"""One description, four ways: a program, the command line, the server and the window's queue make the same bytes."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.cli.main import main
from phonemeanalyser.desktop.session.exports import ExportOrder, ExportQueue
from phonemeanalyser.rendering.clip import ClipWork
from phonemeanalyser.rendering.clip_options import ClipOptions
from phonemeengine import FORMATS, Preset, for_files, load_head, load_preset, morph_targets_of, save_morph_targets
from phonemeengine.batch.work import Job, Work, say_nothing
from phonemeengine.conversion.driving import DriverChoice
from phonemeengine.conversion.options import OPTIONS, SERVED, ConversionOptions
from phonemeengine.conversion.spoken_texts import SpokenTexts, edited_keys
from phonemeengine.conversion.work import CONVERSIONS, ConversionWork
from phonemeengine.execution import no_progress
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.key_layer import KeyCurve, KeyLayer, write_keys
from phonemeengine.performance.corpus import build_table
from phonemeengine.performance.face_network import LIVE, WHOLE, FaceLayer, FaceNetwork, save_face_network
from phonemeengine.speech.pinyin.table import USUAL_PINYIN_TABLE
from tests.engine.performance.corpora import write_recording
from tests.glb_faces import face_with_targets
from tests.meshes import format_obj
from tests.server.conftest import RECORDING
from tests.server.test_files import exported

Words = dict[str, list[str]]
FELT = (
    "[smile] Meine Mama [wütend 0.6] mag Musik, 😢 und mein "
    '<express-as style="excited" styledegree="2">Papa</express-as> backt am *Samstag* gute Pizza!'
)
SPOKEN: Words = {"text": [FELT], "language": ["de"], "accept-text": ["true"]}
CASES: dict[str, Words] = {
    "drawings": {"format": ["rhubarb-json"], "minimum": ["0.2"], "anticipation": ["0.05"], "channel": ["left"]},
    "weights": {
        "format": ["curves-json"],
        "table": ["arkit"],
        "fps": ["24"],
        "detail": ["loudness"],
        "attack": ["0.5"],
        "release": ["2"],
        "steady": ["true"],
        "seed": ["3"],
        "no-blinks": ["true"],
        "expression": ["smile=0.5,AU12L=0.1", "anger=0.2"],
        "feeling": ["brows=0.5,smile=1"],
        "text-feeling": ["0.6"],
        "priority": ["0.7,0.2"],
        "text-driver": ["rules"],
        "style": ["mumbling"],
        **SPOKEN,
    },
    "pinyin": {
        "format": ["livelink-csv"],
        "text": ["你好，世界。"],
        "language": ["cmn"],
        "literal": ["true"],
        "accept-text": ["true"],
        "spring": ["1,20,9"],
        "no-head": ["true"],
    },
    "files": {
        "format": ["livelink-csv"],
        "script": ["mami.json"],
        "speaker": ["Ann"],
        "language": ["en-us"],
        "lexicon": ["own.toml"],
        "performance": ["ann.sqlite"],
        "use": ["Ann"],
        "person": ["Ann"],
        "choice": ["nearest"],
        "without": ["poses,window"],
        "keywords": ["keys.toml"],
        "style": ["mine.toml"],
        "expression": ["mami.csv"],
        "units": ["units.csv"],
        "pinyin-table": ["pinyin.toml"],
        "longest": ["60"],
        "keys": ["edited.keys.toml"],
        "preset": ["extended"],
        "decoder": ["de"],
        "model": ["real-time"],
        "overwrite": ["true"],
    },
    "network": {"format": ["livelink-csv"], "face-network": ["ada.face"]},
    "mesh": {"format": ["gltf"], "mesh": ["face.glb"]},
    "clip": {
        "format": ["clip-gif"],
        "fps": ["2"],
        "text": ["你好"],
        "language": ["cmn"],
        "accept-text": ["true"],
        "text-driver": ["rules"],
        "beside": ["pinyin"],
        "mesh": ["face.obj"],
        "movestates": ["face.3dm"],
        "keys": ["edited.keys.toml"],
        "size": ["96x64"],
        "view": ["mouth"],
        "transparent": ["true"],
        "theme": ["dark"],
    },
}
"""Options with their values as they are written, by what is tried."""
STYLE = """format = "phonemeanalyser style 1"
name = "mine"
amounts = { mumbling = 0.4, theatrical = 0.2, asymmetry = 0.3 }
closures = { p = { width = 1.4, priority = 3 } }
tongue = { t = { priority = 2 } }
reductions = { AU12 = 0.2 }
"""


@pytest.fixture
def folder(case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the files that options name."""
    monkeypatch.chdir(tmp_path)
    write_recording(tmp_path)
    build_table(tmp_path, tmp_path / "ann.sqlite", name="Ann", person="Ann")
    words = [{"word": "mami", "start": 0.2, "end": 0.8, "speaker": who} for who in ("Ann", "Bob")]
    (tmp_path / "mami.json").write_text(json.dumps({"words": words}), encoding="utf-8")
    own = 'format = "phonemeanalyser lexicon 1"\n[words]\nmami = "ˈma.mi"\n'
    (tmp_path / "own.toml").write_text(own, encoding="utf-8")
    shutil.copy(RECORDING, tmp_path / "sound")
    keys = 'format = "phonemeanalyser keywords 1"\n[gestures.bow]\nshortest = 0.5\nchannels = { headPitch = [-20] }\n'
    (tmp_path / "keys.toml").write_text(keys + '[languages.en]\nbow = ["mami"]\n', encoding="utf-8")
    (tmp_path / "pinyin.toml").write_bytes(USUAL_PINYIN_TABLE.read_bytes())
    (tmp_path / "mine.toml").write_text(STYLE, encoding="utf-8")
    edited = KeyCurve(np.array([0.1, 0.3, 0.5]), np.array([0, 0.7, 0.0]))
    write_keys(KeyLayer({"jawOpen": edited}), "edited.keys.toml")
    save_face_network(still_face(), tmp_path / "ada.face")
    (tmp_path / "face.glb").write_bytes(face_with_targets(ARKIT))
    if case == "clip":
        head = load_head()
        (tmp_path / "face.obj").write_bytes(format_obj(head.mesh))
        save_morph_targets(morph_targets_of(head.mesh, head.states), tmp_path / "face.3dm")
    return tmp_path


def still_face() -> FaceNetwork:
    """Give a network whose jaw is half open whatever sounds."""
    trunk = load_preset("learned").model
    assert trunk is not None
    layer = FaceLayer(np.zeros((3 * len(trunk.layers[-1].bias), 1), np.float32), np.full(1, 0.5, np.float32))
    return FaceNetwork(trunk, ("jawOpen",), {LIVE: layer, WHOLE: layer}, np.full((2, 1), np.nan, np.float32), {})


def test_every_option_is_tried() -> None:
    spoken = {"performance-sound"}  # of a text without a recording; tests/cli/test_performing_cli.py has it
    assert {name for case in CASES.values() for name in case} == OPTIONS.keys() - spoken


@pytest.mark.parametrize(
    "case", [pytest.param(case, marks=[pytest.mark.long] if case in {"clip", "drawings"} else []) for case in CASES]
)
def test_all_ways_lead_to_the_same_bytes(case: str, folder: Path, server: str, qtbot: QtBot) -> None:
    words, sound = CASES[case], folder / ("mami.wav" if case == "files" else "sound")
    asked, clip = asked_of(words), case == "clip"
    ending = ".gif" if clip else FORMATS[words["format"][0]].full_ending
    targets = [folder / f"{way}{ending}" for way in ("api", "cli", "window")]
    by_program(asked, words["format"][0], Job(sound, targets[0]))
    assert main(command_of(words, sound, targets[1], clip=clip)) == 0
    by_window(asked, words["format"][0], Job(sound, targets[2]), qtbot)
    made = [target.read_bytes() for target in targets]
    if words.keys() <= {*SERVED}:
        status, _, content = exported(server, sound.read_bytes(), **words)
        assert status == 200, content
        made.append(content)
    assert len({*made}) == 1


def asked_of(words: Words) -> ConversionOptions:
    """Give a description whose values are read from words."""
    values = {
        name.replace("-", "_"): tuple(map(OPTIONS[name].read, given))
        if OPTIONS[name].several
        else OPTIONS[name].read(given[0])
        for name, given in words.items()
        if name != "format"
    }
    return ConversionOptions(**values)


def preset_of(asked: ConversionOptions) -> Preset:
    return for_files(load_preset(asked.preset).with_decoder(asked.decoder), asked.model)


def by_program(asked: ConversionOptions, kind: str, job: Job) -> None:
    if kind in CONVERSIONS:
        work: Work = ConversionWork.of(asked, kind, preset_of(asked), [job.source])
    else:
        work = ClipWork.of(asked, preset_of(asked), "", [job.source])
    with work.opened() as act:
        act(job, say_nothing, no_progress)


def command_of(words: Words, sound: Path, target: Path, *, clip: bool) -> list[str]:
    given = [
        f"--{name}" if not OPTIONS[name].value else f"--{name}={value}"
        for name, values in words.items()
        for value in values
        if not (clip and name == "format")
    ]
    return ["preview" if clip else "export", str(sound), *given, "-o", str(target)]


def by_window(asked: ConversionOptions, kind: str, job: Job, qtbot: QtBot) -> None:
    texts = SpokenTexts.of(asked, [job.source], say_nothing)
    order = ExportOrder(
        kind, preset_of(asked), asked.written(), asked.channel, texts, DriverChoice.of(asked), asked.movestates
    )
    keys = edited_keys(asked.keys, [job.source]) if asked.keys else None
    queue = ExportQueue()
    assert job.target is not None
    with qtbot.waitSignal(queue.finished, timeout=60_000):
        order = replace(order, look=ClipOptions.of(asked))
        queue.start({job.source: job.target}, replace(order, keys=keys, overwrite=asked.overwrite))
    assert [done.words for done in queue.jobs] == [""]
    queue.close()
