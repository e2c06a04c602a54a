"""A face that follows the sound alone beats the rules on sentences that it never saw, however it is cut."""

from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.analyser import Analyser
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.framing import Framer
from phonemeengine.errors import EngineError, ModelError, PerformanceError
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.mouth.animation import animation_of
from phonemeengine.mouth.lip_sync import transcribe
from phonemeengine.mouth.performer import CLOSE_AFTER, MOUTH_ALONE
from phonemeengine.mouth.table import load_table
from phonemeengine.performance.corpus import build_table, find_recordings, read_performance
from phonemeengine.performance.driver import FACE
from phonemeengine.performance.face_learning import LearnedFace, learn_face
from phonemeengine.performance.face_network import (
    FADE,
    LIVE,
    WHOLE,
    FaceFollower,
    FaceFrames,
    FaceNetwork,
    load_face_network,
    save_face_network,
)
from phonemeengine.performance.making import make_corpus, sentences
from phonemeengine.performance.table_file import PerformanceTable
from phonemeengine.performance.track import PerformanceTrack
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.model_choice import with_small_network
from phonemeengine.settings import FRAME_PERIOD, HOP, WINDOW
from phonemeengine.speech.voice import Voice, speak
from tests.engine.performance.corpora import write_recording

PRESET = load_preset(DEFAULT_PRESET)
TRUNK = PRESET.model


@dataclass(frozen=True)
class Studio:
    """What a performer recorded, what was learned of it, and what the same performer recorded later."""

    folder: Path
    later: Path
    learned: LearnedFace


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Studio:
    folder, voice = tmp_path_factory.mktemp("performer"), Voice("en-us")
    first, later = folder / "first", folder / "later"
    make_corpus(first, sentences(1), lambda text: speak(text, voice), seconds=60)
    make_corpus(later, islice(sentences(77), 3), lambda text: speak(text, voice), seconds=60, seed=5)
    assert TRUNK is not None
    return Studio(first, later, learn_face(first, TRUNK, name="Ada"))


@pytest.fixture
def network(studio: Studio) -> FaceNetwork:
    return studio.learned.network


def windows_of(path: Path) -> Float32Array:
    framer = Framer()
    with SoundReader(path) as reader:
        return np.concatenate([framer.cut_frames(reader.read_mono()), framer.finish()])


def rms(moved: Float32Array, face: Float32Array) -> float:
    n = min(len(moved), len(face))
    return float(np.sqrt(np.mean((moved[:n] - face[:n]) ** 2)))


def test_it_beats_rules_and_table_on_sentences_that_it_never_saw(studio: Studio, network: FaceNetwork, tmp_path):
    errors: dict[str, list[float]] = {}
    build_table(studio.folder, tmp_path / "t.sqlite")
    arkit = load_table("arkit")
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        for files in find_recordings(studio.later).recordings:
            performance, _ = read_performance(files)
            times = np.arange(int(performance.duration / FRAME_PERIOD)) * FRAME_PERIOD
            columns = [performance.channels.index(name) for name in network.channels]
            frames = np.arange(len(performance.weights)) / performance.rate
            face = np.stack([np.interp(times, frames, performance.weights[:, k]) for k in columns], axis=1)
            said = read_utterance(files.labels, performance.duration)
            speech = transcribe(files.sound, PRESET, script=said)  # with the phones as they are labelled
            rules = animation_of(speech, arkit, 100.0, MOUTH_ALONE)
            by_table = PerformanceTrack(said, speech, table).animation(speech, 100.0, MOUTH_ALONE)
            for name, moved in (("rules", rules), ("table", by_table)):
                errors.setdefault(name, []).append(rms(moved.of_movestates(network.channels).weights, face))
            windows = windows_of(files.sound)
            for ahead in (LIVE, WHOLE):
                silence = np.zeros((ahead, WINDOW), np.float32)
                weights = FaceFollower(network, ahead).follow(np.concatenate((windows, silence)))
                errors.setdefault(f"network {ahead}", []).append(rms(weights, face))
    found = {name: float(np.mean(each)) for name, each in errors.items()}
    assert found[f"network {WHOLE}"] < found[f"network {LIVE}"] < 0.8 * found["rules"], found
    assert found[f"network {WHOLE}"] < found["table"], found


def test_it_tells_how_far_it_is_off_where_it_did_not_learn(studio: Studio):
    learned = studio.learned
    assert learned.error < 0.7 * learned.still
    assert learned.network.about["error"] == pytest.approx(learned.error, abs=1e-3)
    assert learned.network.title == "Ada (network, synthetic performer)"
    assert not learned.left_out


def test_lips_meet_where_a_closure_is_recognised(studio: Studio, network: FaceNetwork):
    closed = network.channels.index("mouthPressLeft")
    shut, mean = [], []
    for files in find_recordings(studio.later).recordings:
        performance, _ = read_performance(files)
        weights = FaceFollower(network).follow(windows_of(files.sound))[:, closed]
        mean.append(weights.mean())
        shut += [weights[int(p.middle / FRAME_PERIOD)] for p in performance.phones if p.name in {"p", "b", "m"}]
    assert np.mean(shut) > 3 * np.mean(mean)


@pytest.mark.parametrize("ahead", [LIVE, WHOLE])
def test_the_face_does_not_depend_on_how_the_sound_is_cut(studio: Studio, network: FaceNetwork, ahead: int):
    windows = windows_of(find_recordings(studio.later).recordings[0].sound)[:150]
    whole = FaceFollower(network, ahead).follow(windows)
    follower = FaceFollower(network, ahead)
    parts = [follower.follow(windows[k : k + 7]) for k in range(0, 150, 7)]
    assert len(whole) == 150 - ahead
    np.testing.assert_allclose(np.concatenate(parts), whole, atol=1e-5)


def test_live_sound_moves_the_face_before_its_phonemes_are_known(studio: Studio, network: FaceNetwork):
    with SoundReader(find_recordings(studio.later).recordings[0].sound) as reader:
        sound = reader.read_mono()[: 150 * HOP]
    late = replace(PRESET.settings, live_look_ahead=0.05)
    analyser = Analyser(replace(with_small_network(PRESET), settings=late), live=True, phonemes_only=True)
    follower, windows = FaceFollower(network), Framer().cut_frames(sound)
    blocks = [analyser.push(sound[k : k + 300]) for k in range(0, len(sound), 300)]
    moved = np.concatenate([follower.listen(block) for block in blocks])
    np.testing.assert_allclose(moved, FaceFollower(network).follow(windows), atol=1e-5)
    assert len(moved) == sum(map(len, blocks)) + 5


def test_live_frames_are_shown_when_they_end_and_the_face_rests_where_nothing_follows(network: FaceNetwork):
    live, jaw = FaceFrames(network), FACE.index("jawOpen")
    assert not live.weights(5.0).any()
    weights = np.zeros((10, len(network.channels)), np.float32)
    weights[:, network.channels.index("jawOpen")] = np.linspace(0.1, 1.0, 10)
    live.add(weights[:5], 100.05)
    live.add(weights[5:], 100.1)
    assert live.weights(100.045)[jaw] == pytest.approx(0.5)
    assert live.weights(100.05)[jaw] == pytest.approx(0.55)
    assert live.weights(100.1 + CLOSE_AFTER)[jaw] == pytest.approx(1.0, abs=0.06)
    assert not live.weights(100.1 + CLOSE_AFTER + FADE + 0.01).any()
    for k in range(100):
        live.add(weights, 100.2 + 0.1 * k)
    assert live.weights(110.1)[jaw] == pytest.approx(1.0)


def test_a_file_gives_the_same_face_again_and_keeps_what_is_there(studio: Studio, network: FaceNetwork, tmp_path):
    path = tmp_path / "ada.face"
    save_face_network(network, path)
    again, windows = load_face_network(path), windows_of(find_recordings(studio.later).recordings[0].sound)[:50]
    np.testing.assert_array_equal(FaceFollower(again).follow(windows), FaceFollower(network).follow(windows))
    assert again.about == network.about
    save_face_network(network, path)  # its own file may be replaced
    path.write_text("my notes")
    with pytest.raises(EngineError, match="is left alone"):
        save_face_network(network, path)


def test_what_is_no_network_is_refused_in_a_sentence(network: FaceNetwork, tmp_path):
    path = tmp_path / "ada.face"
    save_face_network(network, path)
    for change, sentence in (
        ({"face_format": np.array(2)}, "of version 2, and this program reads 1"),
        ({"face_0_weights": np.zeros((3, 3))}, "is no network of a face, or damaged"),
        ({"face_channels": np.array(["nothing"] * len(network.channels))}, "is no network of a face"),
        ({"face_10_bias": np.full(len(network.channels), np.nan)}, "is no network of a face"),
    ):
        with np.load(path) as arrays, (tmp_path / "other.face").open("wb") as file:
            np.savez(file, **{**arrays, **change})
        with pytest.raises(ModelError, match=sentence):
            load_face_network(tmp_path / "other.face")
    (tmp_path / "text.face").write_text("no")
    for name, sentence in (("text.face", "no network of a face"), ("none.face", "there is no such file")):
        with pytest.raises(ModelError, match=sentence):
            load_face_network(tmp_path / name)


def test_too_little_to_learn_from_is_said(tmp_path):
    write_recording(tmp_path)
    assert TRUNK is not None
    with pytest.raises(PerformanceError, match="30 s of performances and 5 recordings at least, found 1 s"):
        learn_face(tmp_path, TRUNK)
    with pytest.raises(ModelError, match="choose the preset learned"):
        learn_face(tmp_path, PRESET.offline_model)
