"""The talking head without a window: it says what is heard, in step with the sound."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.head.face_model import FaceFiles
from phonemeengine.analyser import Analysis, analyse_blocks
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.tone.settings import Tone, ToneKind
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.mouth.animation import animation_of
from phonemeengine.mouth.files.io import save_morph_targets
from phonemeengine.mouth.head import load_head
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.morph_mesh import MorphTargets
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.movestate import Mode, movestate_of
from phonemeengine.mouth.performer import MOUTH_ALONE
from phonemeengine.mouth.table import load_table
from phonemeengine.mouth.transcript import transcript_of, transcript_of_utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.conftest import STEP
from tests.desktop.sessions import settled
from tests.desktop.stage import AN_A, BEGINS, ENDS, LONG, START, Stage
from tests.fakes.osc_receiver import Receiver
from tests.fakes.outputs import Outputs
from tests.glb_faces import face_with_targets
from tests.sounds import silence, vowel

HANG = 30_000
"""Milliseconds that only a hang reaches."""


@pytest.fixture
def stage(session: Session, outputs: Outputs, qtbot: QtBot, tmp_path: Path) -> Iterator[Stage]:
    stage = Stage(session, outputs, qtbot)
    stage.open(tmp_path)
    stage.look()
    yield stage
    stage.talking.close()


@pytest.fixture
def receiver() -> Iterator[Receiver]:
    receiver = Receiver()
    yield receiver
    receiver.close()


# -- in step with the sound ---------------------------------------------------------------------------


def test_the_mouth_opens_for_an_a_and_silence_closes_it(stage: Stage) -> None:
    opened: dict[float, float] = {}
    stage.play(10, lambda: opened.update({stage.session.source.position: stage.jaw}))
    stage.wait(0.5)
    assert max(jaw for at, jaw in opened.items() if 0 < at < BEGINS - 0.15) < 1
    assert max(jaw for at, jaw in opened.items() if BEGINS + 0.15 < at < ENDS) > 20
    assert stage.jaw < 1


def test_a_vowel_of_a_file_moves_the_mouth_before_it_is_heard(stage: Stage) -> None:
    early: list[float] = []
    stage.play(1.0, lambda: early.append(stage.jaw) if not stage.said_an_a else None)
    assert early[-1] > 1
    assert stage.said_an_a


def test_what_is_live_moves_the_mouth_when_it_is_heard(stage: Stage) -> None:
    stage.session.playback.set_tone(Tone(kind=ToneKind.VOWEL))
    stage.session.set_source(SourceKind.TONE)
    before: list[float] = []
    stage.play(0.6, lambda: before.append(stage.jaw) if not stage.said_an_a else None)
    assert stage.said_an_a
    assert max(before, default=0.0) < 1
    assert stage.jaw > 15


def test_the_mouth_closes_when_nothing_live_comes_any_more(stage: Stage) -> None:
    stage.session.playback.set_tone(Tone(kind=ToneKind.VOWEL))
    stage.session.set_source(SourceKind.TONE)
    stage.play(0.6)
    stage.session.pause()
    stage.wait(1.0)
    assert stage.jaw < 1


def test_a_pause_holds_the_mouth_and_stop_closes_it(stage: Stage, qtbot: QtBot) -> None:
    stage.play(0.9)
    stage.session.pause()
    stage.wait(1.0)
    assert stage.jaw > 15
    stage.session.stop()
    settled(stage.session, qtbot)
    stage.wait(0.5)
    assert stage.jaw < 1


def test_the_mouth_closes_after_a_file_that_ends_in_the_middle_of_an_a(stage: Stage, tmp_path: Path) -> None:
    stage.open(tmp_path, np.concatenate((silence(0.3), vowel((700, 1200, 2500), 0.5))))
    opened: list[float] = []
    stage.play(2.0, lambda: opened.append(stage.jaw))
    assert not stage.session.source.playing
    assert max(opened) > 15
    stage.wait(0.6)
    assert stage.jaw < 1


def test_what_is_heard_too_late_does_not_open_a_mouth_that_was_stopped(stage: Stage, qtbot: QtBot) -> None:
    late: list[Analysis] = []
    stage.session.heard.connect(late.extend)
    stage.play(0.9)
    stage.session.stop()
    stage.session.heard.emit(late[-2:])  # as the analysis thread may give them before it knows
    settled(stage.session, qtbot)
    stage.wait(0.6)
    assert stage.jaw < 1


def test_what_is_known_of_a_file_moves_the_mouth_instead_of_what_is_recognised(stage: Stage, qtbot: QtBot) -> None:
    phones = Phone(BEGINS, 0.85, "f", Phoneme.UNIDENTIFIED), Phone(0.85, ENDS, "m", Phoneme.M)
    said = Utterance((Word("fm", (Syllable(phones),)),), 1.7)
    frames = np.full(170, 0.5, np.float32)
    stage.talking.text.known = transcript_of_utterance(said, frames, 0 * frames, "said.wav")
    stage.talking.text.known_changed.emit()
    rolled: dict[float, float] = {}
    stage.play(
        0.75, lambda: rolled.update({stage.session.source.position: stage.talking.percentages["mouthRollLower"]})
    )
    stage.session.pause()
    stage.wait(1.0)
    assert max(rolled.values()) > 75
    assert stage.talking.percentages["mouthRollLower"] > 75
    assert stage.jaw < 10
    stage.session.seek(1.0)
    settled(stage.session, qtbot)
    stage.wait(0.05)
    assert stage.talking.percentages["mouthPressLeft"] > 20
    stage.open(stage.session.path.parent)
    stage.session.seek(1.0)
    settled(stage.session, qtbot)
    stage.wait(0.05)
    assert stage.jaw > 15


def test_a_place_in_the_file_shows_the_mouth_that_says_it(stage: Stage, qtbot: QtBot) -> None:
    for place, opened in ((0.9, True), (0.3, False), (1.0, True)):
        stage.session.seek(place)
        settled(stage.session, qtbot)
        stage.wait(0.05)
        assert (stage.jaw > 15) is opened, place


def test_a_sound_that_goes_on_elsewhere_is_followed_there(stage: Stage, qtbot: QtBot) -> None:
    stage.play(0.2)
    stage.session.seek(0.7)
    settled(stage.session, qtbot)
    stage.play(0.3)
    assert stage.jaw > 15


def test_a_loop_is_followed_around(stage: Stage) -> None:
    stage.session.playback.set_loop(True)
    opened: list[float] = []
    stage.play(1.7)
    stage.play(1.0, lambda: opened.append(stage.jaw))
    assert max(opened) > 20


def test_nothing_is_moved_while_nobody_looks(
    session: Session, outputs: Outputs, qtbot: QtBot, tmp_path: Path
) -> None:
    stage = Stage(session, outputs, qtbot)
    stage.open(tmp_path)
    stage.play(0.9)
    assert stage.talking.face.morph_mesh is None
    assert stage.talking.head.revision == 0
    stage.look()
    stage.play(0.1)
    assert stage.jaw > 5
    stage.talking.close()


# -- how it moves -------------------------------------------------------------------------------------


def test_a_held_shape_and_a_slider_win_over_the_speech(stage: Stage) -> None:
    stage.talking.set_mode(Mode.RESET)
    stage.play(0.9)
    stage.talking.press(Phoneme.U)
    stage.wait(0.4)
    assert stage.talking.percentages["mouthPucker"] > 50
    held = stage.jaw
    stage.talking.release()
    stage.talking.set_viseme("a", 0.5)
    stage.wait(0.4)
    half = stage.jaw
    stage.talking.set_viseme("a", 1.0)
    stage.wait(0.4)
    assert stage.jaw == pytest.approx(2 * half, rel=0.02)
    assert held < half
    stage.talking.clear_visemes()
    stage.session.pause()
    stage.wait(0.6)
    assert stage.talking.percentages["mouthPucker"] < 5


def test_a_shape_is_reached_smoothly(stage: Stage) -> None:
    opened: list[float] = []
    stage.talking.press(Phoneme.A)
    stage.wait(0.5, lambda: opened.append(stage.jaw))
    assert opened == sorted(opened)
    assert opened[1] < 0.6 * opened[-1]


# what a jaw that says nothing does, in shares of the shapes a and o, after a was asked for at 80 and o at 60 %
SHARES = {
    Mode.NONE: {"a": 0.8, "o": 0.6},
    Mode.RESET: {"a": 0.0, "o": 0.6},
    Mode.FORCE_RESET: {"a": 0.0, "o": 0.6},
    Mode.INTERACT: {"a": 0.4, "o": 0.6},
}


@pytest.mark.parametrize("mode", Mode)
def test_the_mode_says_what_becomes_of_a_shape_when_another_one_is_asked_for(stage: Stage, mode: Mode) -> None:
    stage.talking.set_mode(mode)
    stage.talking.set_viseme("a", 0.8)
    stage.talking.set_viseme("o", 0.6)
    shares = {shape: share for shape, share in stage.talking.visemes.shares.items() if share or shape in SHARES[mode]}
    assert shares == pytest.approx(SHARES[mode])
    stage.wait(0.5)
    shapes = stage.talking.table.shapes
    assert stage.jaw == pytest.approx(
        sum(share * shapes[shape]["jawOpen"] for shape, share in shares.items()), rel=0.01
    )


@pytest.mark.parametrize(("mode", "left"), [(Mode.NONE, 1.0), (Mode.INTERACT, 0.6), (Mode.RESET, 0.0)])
def test_the_mode_says_how_far_the_speech_goes_on(stage: Stage, mode: Mode, left: float) -> None:
    stage.session.seek(0.9)
    settled(stage.session, stage.qtbot)
    stage.wait(0.5)
    said = stage.jaw
    stage.talking.set_mode(mode)
    stage.talking.set_viseme("silence", 0.4)
    stage.wait(0.5)
    assert said > 15
    assert stage.jaw == pytest.approx(left * said, abs=0.5)
    stage.talking.set_viseme("silence", 0.0)
    stage.wait(0.5)
    assert stage.jaw == pytest.approx(said, abs=0.5)


@pytest.mark.parametrize(("mode", "blinks"), [*((m, m is not Mode.FORCE_RESET) for m in Mode), (None, True)])
def test_eyes_go_on_blinking_whatever_the_mouth_is_asked_for_unless_they_are_forced(
    stage: Stage, mode: Mode | None, blinks: bool
) -> None:
    if mode is None:
        stage.talking.press(Phoneme.A)
    else:
        stage.talking.set_mode(mode)
        stage.talking.set_viseme("a", 1.0)
    stage.wait(0.5)
    lids: list[float] = []
    stage.wait(LONG, lambda: lids.append(stage.talking.percentages["eyeBlinkLeft"]))
    assert (max(lids) > 60) is blinks
    assert blinks or max(lids) < 1


def test_a_key_holds_its_shape_alone_and_leaves_the_sliders_as_they_were(stage: Stage) -> None:
    stage.talking.set_viseme("a", 0.4)
    stage.talking.set_viseme("o", 0.3)
    stage.talking.press(Phoneme.U)
    assert {shape for shape, share in stage.talking.visemes.shares.items() if share} == {"u"}
    stage.wait(0.5)
    assert stage.jaw == pytest.approx(stage.talking.table.shapes["u"]["jawOpen"], rel=0.02)
    stage.talking.release()
    shares = stage.talking.visemes.shares
    assert (shares["a"], shares["o"], shares["u"]) == pytest.approx((0.4, 0.3, 0.0))


def test_another_shape_of_the_mouth_does_not_open_eyes_that_blink(stage: Stage) -> None:
    face = stage.talking.face
    assert face.states is not None
    assert not face.states.interactable("eyeBlinkLeft")
    still = np.zeros(len(stage.talking.table.movestates), np.float32)
    face.blink(0.8)
    face.move(still)
    assert face.states.percentage("eyeBlinkLeft") == pytest.approx(80)
    face.blink(0.0)
    assert face.states.percentage("eyeBlinkLeft") == 0


def test_what_only_the_table_before_moved_comes_to_rest(stage: Stage) -> None:
    stage.talking.press(Phoneme.A)
    stage.wait(0.5)
    assert stage.talking.percentages["browInnerUp"] > 3
    stage.talking.release()
    stage.talking.set_table("five")
    stage.talking.press(Phoneme.A)
    stage.wait(0.5)
    assert stage.talking.percentages["browInnerUp"] == 0
    assert stage.jaw > 40


def test_two_states_do_not_care_how_loud_it_is(stage: Stage) -> None:
    stage.talking.set_detail(Detail.TWO_STATES)
    whole = stage.talking.table.weights()[Phoneme.A, stage.talking.table.movestates.index("jawOpen")]
    stage.play(0.95)
    assert 40 * whole < stage.jaw < 62 * whole


def test_a_slow_mouth_opens_later_than_a_fast_one(stage: Stage, qtbot: QtBot) -> None:
    reached = []
    for attack in (0.2, 6.0):
        stage.talking.set_speed(attack, 1.0)
        stage.session.stop()
        settled(stage.session, qtbot)
        stage.wait(0.5)
        stage.play(0.65)
        reached.append(stage.jaw)
        stage.session.pause()
    assert reached[0] > 3 * reached[1]


def test_eyes_blink_unless_they_are_told_not_to(stage: Stage) -> None:
    lids: list[float] = []
    stage.wait(LONG, lambda: lids.append(stage.talking.percentages["eyeBlinkLeft"]))
    assert max(lids) > 60
    stage.talking.set_blinks(False)
    lids.clear()
    stage.wait(LONG, lambda: lids.append(stage.talking.percentages["eyeBlinkLeft"]))
    assert max(lids[5:]) == 0


def test_the_head_moves_unless_it_is_told_not_to(stage: Stage) -> None:
    poses = []
    stage.play(1.0, lambda: poses.append(stage.talking.head.pose.pitch))
    assert max(poses) - min(poses) > 1
    stage.talking.set_head_motion(False)
    stage.wait(0.1)
    assert stage.talking.head.pose == HeadPose()


def test_a_still_face_is_not_drawn_anew(stage: Stage) -> None:
    stage.talking.set_blinks(False)
    stage.talking.set_head_motion(False)
    stage.wait(1.0)
    revision = stage.talking.head.revision
    stage.wait(3.0)
    assert stage.talking.head.revision == revision


# -- whose face it is ---------------------------------------------------------------------------------


def test_a_mesh_with_other_movestates_is_moved_by_the_table_that_fits(stage: Stage, tmp_path: Path) -> None:
    (tmp_path / "own.glb").write_bytes(face_with_targets(("A", "I", "U", "E", "O")))
    stage.talking.face.load(FaceFiles(tmp_path / "own.glb"))
    stage.settle()
    assert stage.talking.table_name == "vrm"
    assert stage.talking.face.name == "own.glb"
    stage.play(0.9)
    assert stage.talking.percentages["A"] > 20
    assert not stage.failed


def test_movestates_are_named_alike_whoever_wrote_them(stage: Stage, tmp_path: Path) -> None:
    (tmp_path / "own.glb").write_bytes(face_with_targets(("jaw_open", "Mouth Close")))
    stage.talking.face.load(FaceFiles(tmp_path / "own.glb"))
    stage.settle()
    stage.talking.press(Phoneme.A)
    stage.wait(0.5)
    assert stage.talking.percentages["jaw_open"] > 20


def test_movestates_may_lie_in_a_file_of_their_own(stage: Stage, tmp_path: Path) -> None:
    (tmp_path / "own.glb").write_bytes(face_with_targets(("smile",)))
    mesh = stage_mesh(tmp_path / "own.glb")
    state = movestate_of("jawOpen", [[0, 1, 0]] * len(mesh))
    save_morph_targets(MorphTargets((state,), state.numbers, mesh[state.numbers]), tmp_path / "own.3dm")
    stage.talking.face.load(FaceFiles(tmp_path / "own.glb", tmp_path / "own.3dm"))
    stage.settle()
    assert list(stage.talking.percentages) == ["jawOpen"]
    assert not stage.failed


def stage_mesh(path: Path):
    from phonemeengine.mouth.files.io import load_morph_mesh

    return load_morph_mesh(path).mesh.positions


def test_a_bad_mesh_is_refused_in_one_sentence_and_the_face_stays(stage: Stage, tmp_path: Path) -> None:
    (tmp_path / "bad.glb").write_bytes(b"glTF" + bytes(40))
    before = stage.talking.face.morph_mesh
    stage.talking.face.load(FaceFiles(tmp_path / "bad.glb"))
    stage.settle()
    (sentence,) = stage.failed
    assert sentence.startswith("bad.glb: ")
    assert "\n" not in sentence
    assert stage.talking.face.morph_mesh is before
    assert stage.talking.face.is_shipped


def test_a_mesh_without_movestates_is_refused_with_what_to_do(stage: Stage, tmp_path: Path) -> None:
    (tmp_path / "still.glb").write_bytes(face_with_targets(()))
    stage.talking.face.load(FaceFiles(tmp_path / "still.glb"))
    stage.settle()
    (sentence,) = stage.failed
    assert ".3dm" in sentence


def test_movestates_that_no_table_knows_are_told(stage: Stage, tmp_path: Path) -> None:
    (tmp_path / "odd.glb").write_bytes(face_with_targets(("grumpy", "wide")))
    stage.talking.face.load(FaceFiles(tmp_path / "odd.glb"))
    stage.settle()
    (sentence,) = stage.failed
    assert "grumpy" in sentence


def test_a_table_that_moves_nothing_in_the_face_is_refused(stage: Stage) -> None:
    stage.talking.set_table("oculus")
    (sentence,) = stage.failed
    assert "arkit" in sentence
    assert stage.talking.table_name == "arkit"


def test_a_table_of_ones_own_is_loaded(stage: Stage, tmp_path: Path) -> None:
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


# -- over the network ---------------------------------------------------------------------------------


def test_what_is_heard_is_sent_and_the_mouth_closes_at_the_end(
    stage: Stage, receiver: Receiver, qtbot: QtBot
) -> None:
    osc = stage.talking.osc
    osc.set_address(f"127.0.0.1:{receiver.address.port}")
    osc.set_on(True)
    qtbot.waitUntil(lambda: osc.words.startswith("sending"))
    stage.play(1.0)
    qtbot.waitUntil(lambda: any(name == "a" for name, *_ in receiver.of("/phoneme")))
    qtbot.waitUntil(lambda: receiver.weights().get("jawOpen", 0.0) > 0.1)
    osc.set_on(False)
    qtbot.waitUntil(lambda: receiver.weights()["jawOpen"] < 0.01)
    assert osc.words == "off"
    assert not stage.failed


def test_a_pause_holds_the_mouth_that_is_sent_as_it_holds_the_head(stage: Stage) -> None:
    talking = stage.talking
    stage.play(0.9)
    stage.session.pause()
    stage.wait(1.0)
    now = stage.now - START
    shown, sent = talking.performer.at(now).weights, talking.osc.performer.at(now).weights
    np.testing.assert_array_equal(sent, shown)
    assert shown[talking.table.movestates.index("jawOpen")] > 0.15


@pytest.mark.parametrize("address", ["nowhere", "127.0.0.1:99999", ":9", ""])
def test_a_wrong_address_switches_it_off_with_one_sentence(stage: Stage, address: str) -> None:
    stage.talking.osc.set_address(address)
    stage.talking.osc.set_on(True)
    (sentence,) = stage.failed
    assert "HOST:PORT" in sentence
    assert not stage.talking.osc.on


def test_a_receiver_that_nobody_knows_is_told(stage: Stage, qtbot: QtBot) -> None:
    stage.talking.osc.set_address("nobody.invalid:39539")
    stage.talking.osc.set_on(True)
    qtbot.waitUntil(lambda: bool(stage.failed))
    assert "nobody.invalid" in stage.failed[0]
    assert not stage.talking.osc.on


def test_another_set_is_sent_under_its_own_names(stage: Stage, receiver: Receiver, qtbot: QtBot) -> None:
    osc = stage.talking.osc
    osc.set_address(f"127.0.0.1:{receiver.address.port}")
    osc.set_on(True)
    osc.set_table("vrm")
    qtbot.waitUntil(lambda: "A" in receiver.weights())


@pytest.mark.parametrize("own_table", [False, True])
def test_a_receiver_moves_by_the_table_of_the_head_and_as_fast(stage: Stage, own_table: bool) -> None:
    talking, osc = stage.talking, stage.talking.osc
    osc.set_table("vrm" if own_table else "head")
    talking.set_table("five")
    talking.set_speed(3.0, 2.0)
    talking.set_random(False)
    talking.set_detail(Detail.TWO_STATES)
    shown, head = osc.performer, talking.performer
    assert talking.table.name == "Five mouth shapes"
    assert (shown.table.times, shown.table.motion) == (head.table.times, head.table.motion)
    assert shown.idle.detail is Detail.TWO_STATES
    assert shown.table.shapes == (load_table("vrm") if own_table else talking.table).shapes


def test_film_window_and_network_move_alike(stage: Stage, receiver: Receiver, qtbot: QtBot, tmp_path: Path) -> None:
    """The same sound as the frames of a film, on the head in the window, and as it arrives at a receiver."""
    sound = np.concatenate((AN_A, vowel((300, 2300, 3000), 0.4), silence(0.5)))
    stage.open(tmp_path, sound)
    path, session, talking = stage.session.path, stage.session, stage.talking
    assert path is not None
    with SoundReader(path) as reader:
        analyses = analyse_blocks(reader.blocks(SAMPLE_RATE), session.preset.in_force, pitch=True)
        utterance = transcript_of(analyses, "", reader.duration)
    film = animation_of(utterance, talking.table, SAMPLE_RATE / STEP, MOUTH_ALONE)
    talking.osc.set_address(f"127.0.0.1:{receiver.address.port}")
    talking.osc.set_on(True)
    qtbot.waitUntil(lambda: talking.osc.words.startswith("sending"))
    session.play()
    qtbot.waitUntil(lambda: stage.outputs.last.n_written >= len(sound))
    shown, sent = [], []

    def look() -> None:
        if session.source.playing:
            now = stage.now - START
            qtbot.waitUntil(lambda: receiver.weights_at(now) is not None)  # older mouths may still be on their way
            weights = receiver.weights_at(now) or {}
            shown.append(talking.performer.at(now).weights)
            sent.append([weights.get(name, 0.0) for name in film.movestates])

    stage.play(3.0, look)
    expected = film.weights[1 : len(shown) + 1]
    assert len(shown) > 100
    np.testing.assert_allclose(shown, expected, atol=1e-5)
    np.testing.assert_allclose(sent, np.clip(expected, 0, 1), atol=1e-5)
    assert expected[:, film.movestates.index("jawOpen")].max() > 0.2


def test_a_receiver_that_is_switched_off_stays_so_whatever_moves_the_head(stage: Stage) -> None:
    stage.talking.set_table("five")
    stage.talking.set_speed(3.0, 2.0)
    assert not stage.talking.osc.on
    assert not stage.talking.osc._work.busy


def test_the_receiver_is_told_how_far_the_speech_goes_on(stage: Stage) -> None:
    talking, visemes = stage.talking, stage.talking.osc.performer.visemes
    talking.set_mode(Mode.INTERACT)
    talking.set_viseme("u", 0.25)
    assert (visemes.phonemes, visemes.speech) == ({Phoneme.U: 0.25}, 0.75)
    talking.press(Phoneme.A)
    assert (visemes.phonemes, visemes.speech) == ({Phoneme.A: 1.0}, 0.0)
    talking.release()
    assert (visemes.phonemes, visemes.speech) == ({Phoneme.U: 0.25}, 0.75)
    talking.clear_visemes()
    assert (visemes.phonemes, visemes.speech) == ({}, 1.0)


@pytest.mark.parametrize("asked_first", [False, True])
def test_keys_and_sliders_move_the_receivers_mouth_too(
    stage: Stage, receiver: Receiver, qtbot: QtBot, asked_first: bool
) -> None:
    osc, talking = stage.talking.osc, stage.talking
    osc.set_address(f"127.0.0.1:{receiver.address.port}")
    osc.set_table("vrm")
    if asked_first:
        talking.press(Phoneme.U)
    osc.set_on(True)
    qtbot.waitUntil(lambda: "U" in receiver.weights())
    talking.press(Phoneme.U)
    stage.wait(0.5)
    qtbot.waitUntil(lambda: receiver.weights()["U"] > 0.5)
    qtbot.waitUntil(lambda: ("u", 1.0) in receiver.of("/phoneme"))
    talking.release()
    talking.set_viseme("a", 0.5)
    stage.wait(0.5)
    qtbot.waitUntil(lambda: receiver.weights()["U"] < 0.01 and receiver.weights()["A"] > 0.2)
    qtbot.waitUntil(lambda: receiver.of("/viseme")[-1] == ("A", 0.5))
    talking.clear_visemes()
    stage.wait(0.5)
    qtbot.waitUntil(lambda: receiver.weights()["A"] < 0.01)
    osc.set_on(False)
