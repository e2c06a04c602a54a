"""The talking head without a window: it says what is heard, in step with the sound."""

from pathlib import Path

import numpy as np
import pytest
import soundfile
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.analyser import Analysis
from phonemeengine.audio.tone import Tone, ToneKind
from phonemeengine.labels.utterance import LabelUnit, Phone, Syllable, Utterance, Word
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.movestate import Mode
from phonemeengine.mouth.transcript import transcript_of_utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.sessions import settled
from tests.desktop.stage import AN_A, BEGINS, ENDS, LONG, Stage
from tests.fakes.outputs import Outputs
from tests.sounds import silence, vowel

HANG = 30_000
"""Milliseconds that only a hang reaches."""


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
    stage.session.play()
    before: list[float] = []
    stage.play(0.6, lambda: before.append(stage.jaw) if not stage.said_an_a else None)
    assert stage.said_an_a
    assert max(before, default=0.0) < 1
    assert stage.jaw > 15


def test_the_mouth_closes_when_nothing_live_comes_any_more(stage: Stage) -> None:
    stage.session.playback.set_tone(Tone(kind=ToneKind.VOWEL))
    stage.session.set_source(SourceKind.TONE)
    stage.session.play()
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
    stage.session.analysed.connect(late.extend)
    stage.play(0.9)
    stage.session.stop()
    stage.session.analysed.emit(late[-2:])  # as the analysis thread may give them before it knows
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
    still = np.zeros(len(stage.talking.performer.table.movestates), np.float32)
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


def test_moved_boundaries_are_asked_about_before_a_file_that_changed_on_disk_is_opened_again(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.edits.move_boundary(LabelUnit.WORD, 2, 0.8)
    asked: list[bool] = []
    desk.session.may_leave = lambda: asked.append(desk.texts.words.has_unsaved_changes) or False
    assert desk.session.open(tmp_path / "said.wav")
    assert (asked, desk.words()) == ([], ["so", "oh"])  # the same sound
    soundfile.write(tmp_path / "new.wav", AN_A[: len(AN_A) // 2], SAMPLE_RATE, subtype="FLOAT")
    (tmp_path / "new.wav").replace(tmp_path / "said.wav")
    assert not desk.session.open(tmp_path / "said.wav")
    assert (asked, desk.words()) == ([True], ["so", "oh"])
    desk.session.may_leave = lambda: True
    assert desk.session.open(tmp_path / "said.wav")
    desk.wait()
    assert (desk.words(), desk.texts.text) == ([], "so oh")
