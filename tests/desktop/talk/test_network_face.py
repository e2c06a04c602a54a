"""A network moves the face by the sound alone: files, live sound, on either head, and in what is generated."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.drivers.movement import movement_of, recording_of
from phonemeengine.audio.files import SoundReader
from phonemeengine.mouth.animation import FaceDriver
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.performance.driver import FACE
from phonemeengine.performance.face_network import (
    LAGS,
    LIVE,
    WHOLE,
    FaceLayer,
    FaceNetwork,
    FaceNetworkTrack,
    load_face_network,
    save_face_network,
)
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.stage import START
from tests.desktop.talk.desk import Desk

CHANNELS = ("jawOpen", "noseSneerLeft")  # rules never move the second one
SNEER = FACE.index("noseSneerLeft")


@pytest.fixture
def network(tmp_path: Path) -> Path:
    """A network whose jaw moves by the sound, and which sneers all the time."""
    trunk = load_preset(DEFAULT_PRESET).model
    assert trunk is not None
    width = len(LAGS) * len(trunk.layers[-1].bias)
    weights = np.zeros((width, 2), np.float32)
    weights[:, 0] = np.random.default_rng(1).normal(0, 0.02, width)
    layers = {ahead: FaceLayer(weights, np.array([0.5, 0.4], np.float32)) for ahead in (LIVE, WHOLE)}
    poses = np.array([[0, 0.4], [np.nan, np.nan]], np.float32)
    bare = replace(trunk, anchors=trunk.anchors[:0], about={}, live_head=None)
    save_face_network(FaceNetwork(bare, CHANNELS, layers, poses, {"name": "ada"}), tmp_path / "ada.face")
    return tmp_path / "ada.face"


def use(desk: Desk, path: Path) -> None:
    """Open a network."""
    network = desk.texts.drivers.network
    network.open(path)
    settle(desk)


def settle(desk: Desk) -> None:
    """Wait until the network has followed the current sound."""
    desk.qtbot.waitUntil(lambda: not desk.texts.drivers.network.progress)
    desk.wait()


def shown(desk: Desk, *, beside: bool = False) -> np.ndarray:
    """What a head shows now."""
    talking = desk.stage.talking
    head = talking.beside if beside else talking.head
    return head.performer.at(desk.stage.now - START).weights


def test_a_file_is_followed_as_its_export_is_without_words(desk: Desk, network: Path, tmp_path: Path) -> None:
    desk.open(tmp_path)
    desk.stage.look()
    use(desk, network)
    drivers, talking = desk.texts.drivers, desk.stage.talking
    assert (drivers.main, talking.head.caption, desk.failed) == (FaceDriver.NETWORK, "ada (network)", [])
    assert drivers.notes_of(FaceDriver.NETWORK)[0].startswith("no recording of the network has a labiodental sound")
    assert any(sentence.startswith("ada: no recording") for sentence in desk.told)
    with SoundReader(tmp_path / "said.wav") as reader:
        mouth = FaceNetworkTrack(load_face_network(network), reader.blocks(SAMPLE_RATE)).mouth()
    seen, expected = [], []

    def look() -> None:
        if desk.session.source.playing:
            seen.append(shown(desk))
            expected.append(mouth.weights(desk.session.source.position))

    desk.stage.play(0.9, look)
    np.testing.assert_allclose(seen, expected, atol=1e-4)
    assert np.ptp(np.array(seen)[:, FACE.index("jawOpen")]) > 0.02
    said = recording_of(tmp_path / "said.wav", 1.7, desk.session.whole.tracks)
    assert said is not None
    in_use = talking.shown
    options = replace(in_use.options, rate=100.0, table=in_use.table)
    made = movement_of(said.transcript(), options, in_use.driver, desk.session.source.reopen)
    assert made.weights[50, ARKIT.index("noseSneerLeft")] == pytest.approx(0.4, abs=1e-3)
    desk.session.seek(0.8)  # what is held still is shown, too
    talking.tick()
    np.testing.assert_allclose(shown(desk), mouth.weights(desk.session.source.position), atol=1e-4)


def test_the_second_head_is_moved_by_it_and_a_file_that_is_none_is_refused(
    desk: Desk, network: Path, tmp_path: Path
) -> None:
    desk.open(tmp_path)
    desk.stage.look()
    use(desk, network)
    drivers, talking = desk.texts.drivers, desk.stage.talking
    drivers.choose(FaceDriver.RULES)
    assert drivers.network.face is None
    drivers.compare(FaceDriver.NETWORK)
    settle(desk)
    desk.stage.play(0.8)
    assert (talking.head.caption, talking.beside.caption) == (FaceDriver.RULES.caption, "ada (network)")
    assert shown(desk, beside=True)[SNEER] == pytest.approx(0.4, abs=1e-3)
    assert shown(desk)[ARKIT.index("noseSneerLeft")] == 0
    (tmp_path / "bad.face").write_bytes(b"none")
    use(desk, tmp_path / "bad.face")
    assert desk.failed[0].startswith("bad.face: it is no network of a face")
    assert drivers.network.chosen == network


def test_what_is_spoken_is_followed_while_it_is_heard(desk: Desk, network: Path) -> None:
    use(desk, network)
    desk.stage.look()
    desk.say("So. So so.")
    desk.stage.play(0.4)
    assert shown(desk)[SNEER] == pytest.approx(0.4, abs=1e-3)
    desk.session.pause()
    desk.stage.wait(1.0)
    assert shown(desk)[SNEER] == pytest.approx(0.4, abs=1e-3)
    assert desk.failed == []


def test_live_sound_is_followed_by_the_clock(desk: Desk, network: Path) -> None:
    use(desk, network)
    desk.stage.look()
    desk.session.set_source(SourceKind.TONE)
    desk.stage.play(0.5)
    assert shown(desk)[SNEER] == pytest.approx(0.4, abs=1e-3)
    desk.session.pause()
    desk.stage.wait(1.0)
    assert shown(desk)[SNEER] == 0
