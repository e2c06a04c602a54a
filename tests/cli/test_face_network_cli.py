"""`phonemeanalyser performance learn`, and faces that `--face-network` moves."""

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.cli.main import main
from phonemeengine.mouth.osc import OscSettings
from phonemeengine.mouth.table import load_table
from phonemeengine.performance.face_network import LIVE, FaceLayer, load_face_network
from tests.cli.test_listen_osc import listen_to_speech, microphone, receiver
from tests.tables import Capsys, refused
from tests.waiting import wait_for

__all__ = ["microphone", "receiver"]
EXPORT = ["export", "recorded/synthetic0001.wav", "--format", "livelink-csv", "--steady", "-o"]
NETWORK = ["--face-network", "ada.face"]


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with recordings of the synthetic performer, and a network that learned from them."""
    folder = tmp_path_factory.mktemp("ada")
    assert main(["performance", "make", str(folder / "recorded"), "--minutes", "0.55"]) == 0
    words = ["performance", "learn", str(folder / "recorded"), "-o", str(folder / "ada.face"), "--name", "Ada"]
    assert main(words) == 0
    return folder


@pytest.fixture(autouse=True)
def _there(recorded: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(recorded)


def jaws(path: str) -> list[float]:
    with Path(path).open(encoding="utf-8", newline="") as file:
        return [float(row["JawOpen"]) for row in csv.DictReader(file)]


def test_a_recording_moves_a_face_by_the_network_without_words(capsys: Capsys) -> None:
    assert main([*EXPORT, "rules.csv", "--overwrite"]) == 0
    assert main([*EXPORT, "network.csv", "--overwrite", *NETWORK]) == 0
    assert "Ada: note: the performer is synthetic" in capsys.readouterr().err
    assert main([*EXPORT, "asked.csv", "--overwrite", *NETWORK, "--text-driver", "network"]) == 0
    rules, network, tracked = jaws("rules.csv"), jaws("network.csv"), jaws("recorded/synthetic0001.csv")
    assert jaws("asked.csv") == network != rules
    assert len(network) == len(rules)

    def error(moved: list[float]) -> float:
        return sum((a - b) ** 2 for a, b in zip(moved, tracked, strict=False))

    assert error(network) < 0.5 * error(rules)


def test_what_is_sent_of_live_speech_is_moved_by_the_network(microphone, receiver) -> None:
    network = load_face_network("ada.face")
    always = np.array([0.4 * (name == "noseSneerLeft") for name in network.channels], np.float32)  # rules never do
    layer = network.layers[LIVE]
    network = replace(network, layers={LIVE: FaceLayer(0 * layer.weights, always)}, poses=np.nan * network.poses)
    listen_to_speech(microphone, OscSettings(receiver.address, load_table("arkit")), network=network)
    wait_for(lambda: ("noseSneerLeft", pytest.approx(0.4)) in receiver.of("/VMC/Ext/Blend/Val"), "a sneer")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ([*EXPORT, "x.csv", "--text-driver", "network"], "--text-driver network needs a network of recorded faces"),
        ([*EXPORT, "x.csv", "--text-driver", "rules", *NETWORK], "leaves the network of --face-network unused"),
        ([*EXPORT, "x.csv", "--face-network", "network.csv"], "network.csv: it is no network of a face, or damaged"),
        (["performance", "learn", "recorded", "-o", "x.face", "--preset", "thesis"], "has no network to learn on"),
        (["performance", "learn", "nowhere", "-o", "x.face"], "nowhere: this folder cannot be read"),
    ],
)
def test_what_cannot_be_is_said(words: list[str], sentence: str, capsys: Capsys) -> None:
    Path("network.csv").touch()
    assert sentence in refused(capsys, *words)
    assert not {*Path().glob("x.*")}


def test_a_voice_moves_a_face_as_its_recording_does_and_silent_speech_does_not(capsys: Capsys) -> None:
    written = ["--format", "livelink-csv", "--overwrite", *NETWORK]
    said = ["speak", "Bob may come.", "--language", "en-us"]
    assert main([*said, "-o", "said.wav", "--labels", "said.TextGrid", "--export", "said.csv", *written]) == 0
    assert main(["speak", "--recording", "said.wav", "--export", "again.csv", *written]) == 0
    assert main(["export", "said.wav", "-o", "export.csv", *written]) == 0
    np.testing.assert_allclose(jaws("said.csv"), jaws("export.csv"), atol=0.02)  # the file has 16 bits
    np.testing.assert_allclose(jaws("again.csv"), jaws("export.csv"), atol=1e-4)
    capsys.readouterr()
    assert main([*said, "--silent", "--export", "x.csv", *written]) == 1
    assert "a network moves a face by a sound, and this has none" in capsys.readouterr().err


@pytest.mark.parametrize("words", [NETWORK, [*NETWORK, "--osc", "127.0.0.1:9", "--table", "vrm"]])
def test_listening_says_what_the_network_needs(words: list[str], capsys: Capsys) -> None:
    with pytest.raises(SystemExit):
        main(["listen", *words])
    assert ("--osc" if words is NETWORK else "use arkit") in capsys.readouterr().err
