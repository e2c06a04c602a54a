"""Sentences that a table of performances says: the face is a ramp, or is shut where the lips meet."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import MouthError, PerformanceError
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.mouth.blendshape_names import ARKIT, SHOULDERS
from phonemeengine.mouth.osc import OscMouth
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion, Performer
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.driver import FACE, PerformanceOptions, PerformancePart
from phonemeengine.performance.recording import HEAD, SILENCE, Performance
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.track import PerformanceTrack, face_table, format_units
from phonemeengine.phonemes import Phoneme
from tests.engine.performance.sentences import phones_in
from tests.fakes.osc_receiver import Receiver
from tests.waiting import wait_for

JAW, PUCKER, TONGUE_OUT = (ARKIT.index(name) for name in ("jawOpen", "mouthPucker", "tongueOut"))
PLAIN = PerformanceOptions(without=frozenset(PerformancePart))
CHANNELS = ("headYaw", "mouthPucker", "jawOpen", "eyeBlinkLeft")


def recorded(words: str, length: float = 0.1, jaw: float | None = None) -> Performance:
    """Give a performance whose jaw is a ramp, or stays where it is; the eyes are shut, and the head is turned."""
    phones = phones_in(words, length)
    weights = np.ones((round(phones[-1].end * 100) + 1, len(CHANNELS)), np.float32)
    weights[:, 1] = 0.25
    weights[:, 2] = np.linspace(0, 1, len(weights)) if jaw is None else jaw
    return Performance(words, 100.0, CHANNELS, weights, phones, tuple(words.split()))


def utterance_of(*texts: str, length: float = 0.1, pause: float = 0.1, gap: float | None = None) -> Utterance:
    """Give words, a phone a letter, with a pause before and after them, and a gap between them: a pause, too."""
    words, at = [], pause
    for text in texts:
        syllables = []
        for letters in text.split("."):
            phones = tuple(Phone(at + k * length, at + (k + 1) * length, x, Phoneme.A) for k, x in enumerate(letters))
            syllables.append(Syllable(phones))
            at += len(phones) * length
        words.append(Word(text, tuple(syllables)))
        at += pause if gap is None else gap
    return Utterance(tuple(words), at + pause - (pause if gap is None else gap))


def heard(utterance: Utterance) -> Transcript:
    return Transcript("said", utterance.duration)


@pytest.fixture
def table(tmp_path: Path) -> Iterator[PerformanceTable]:
    write_table(tmp_path / "t.sqlite", [recorded("ma.ma tu"), recorded("mi")])
    with PerformanceTable.open(tmp_path / "t.sqlite") as opened:
        yield opened


def track_of(table: PerformanceTable, utterance: Utterance, options: PerformanceOptions = PLAIN) -> PerformanceTrack:
    return PerformanceTrack(utterance, heard(utterance), table, options)


def test_a_recorded_sentence_comes_back_as_it_was(table: PerformanceTable) -> None:
    mouth = track_of(table, utterance_of("ma.ma", "tu", gap=0.0)).mouth()
    times = np.linspace(0.0, 0.8, 31)
    shown = np.stack([mouth.weights(time) for time in times.tolist()])
    assert shown[:, JAW] == pytest.approx(times / 0.8, abs=0.002)  # float16
    assert shown[:, PUCKER] == pytest.approx(0.25)
    assert np.flatnonzero(shown.any(axis=0)).tolist() == sorted([JAW, PUCKER])  # no eyes


def units_in(table: PerformanceTable, utterance: Utterance) -> list[tuple[str, str]]:
    return [(unit.kind, "".join(unit.names)) for unit in track_of(table, utterance).units()]


def test_the_units_tell_what_is_taken_from_where(table: PerformanceTable) -> None:
    rows = format_units(track_of(table, utterance_of("mi")).units()).splitlines()
    assert rows == [
        "start_s,end_s,set,phones,recording,from_s,to_s",
        "0.000,0.050,left-half,sil,mi,0.000,0.050",
        "0.050,0.350,sentence,sil m i sil,mi,0.050,0.350",
        "0.350,0.400,right-half,sil,mi,0.350,0.400",
    ]


def test_strings_of_words_are_kept_whole_where_the_sentence_was_not_recorded(tmp_path: Path) -> None:
    write_table(tmp_path / "t.sqlite", [recorded("ma tu mi pa"), recorded("mi pa ka"), recorded("mi pa", length=0.2)])
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        long = track_of(table, utterance_of("tu", "mi", "pa", "ka", gap=0.0))
        strings = [("".join(unit.names), unit.recording) for unit in long.units() if unit.kind == "words"]
        assert strings == [("tumipa", "ma tu mi pa")]  # what follows is one word, and no string
        slow = [*track_of(table, utterance_of("mi", "pa", length=0.2, pause=0.2, gap=0.0)).units()]
        assert [unit.kind for unit in slow] == ["left-half", "sentence", "right-half"]
        paused = units_in(table, utterance_of("mi", "pa", gap=0.1))
        assert not {"sentence", "words"} & {kind for kind, _ in paused}  # the recordings have no pause there


def test_lips_are_shut_at_p_b_and_m_even_where_the_recorded_ones_are_not(tmp_path: Path) -> None:
    write_table(tmp_path / "open.sqlite", [recorded("pa.ma ba", jaw=0.6)])
    with PerformanceTable.open(tmp_path / "open.sqlite") as table:
        utterance = utterance_of("ab", "am", "ap", length=0.08, pause=0.3)
        for rate in (24.0, 30.0, 60.0):
            animation = track_of(table, utterance, PerformanceOptions()).animation(heard(utterance), rate)
            for phone in utterance.phones:
                jaw = animation.weights[(animation.times >= phone.start) & (animation.times <= phone.end), JAW]
                assert jaw.min() <= 0.06 if phone.ipa in "bmp" else jaw.max() > 0.4


@pytest.mark.parametrize("rate", [8.0, 24.0, 60.0])
def test_a_sound_that_ends_with_its_last_phone_is_shown_until_the_face_is_at_rest(
    rate: float, tmp_path: Path
) -> None:
    write_table(tmp_path / "open.sqlite", [recorded("ma.ma tu", jaw=0.6)])
    said = utterance_of("ma.ma")
    tight = replace(said, duration=max(phone.end for phone in said.phones))
    with PerformanceTable.open(tmp_path / "open.sqlite") as table:
        animation = track_of(table, tight, PerformanceOptions()).animation(heard(tight), rate, MOUTH_ALONE)
    assert animation.weights[animation.times < tight.duration, JAW].max() > 0.4
    assert animation.weights[-1].max() < 0.02


def test_the_tongue_is_behind_the_teeth_in_the_middle_of_a_vowel_however_short(tmp_path: Path) -> None:
    spoken = recorded("aθa")
    channels = (*CHANNELS, "tongueOut")
    out = np.full((len(spoken.weights), 1), 0.3, np.float32)
    weights = np.hstack([spoken.weights, out]).astype(np.float32)
    write_table(tmp_path / "out.sqlite", [replace(spoken, channels=channels, weights=weights)])
    with PerformanceTable.open(tmp_path / "out.sqlite") as table:
        for length in (0.04, 0.06, 0.15):
            utterance = utterance_of("aθa", length=length)
            animation = track_of(table, utterance, PerformanceOptions()).animation(heard(utterance), 120.0)
            shown = {
                phone.start: np.interp(
                    (phone.start + phone.end) / 2, animation.times, animation.weights[:, TONGUE_OUT]
                )
                for phone in utterance.phones
            }
            first, middle, last = shown.values()
            assert max(first, last) <= 0.0501
            assert middle > 0.15


def test_sentences_are_parted_by_pauses_and_go_over_into_each_other(tmp_path: Path) -> None:
    write_table(tmp_path / "two.sqlite", [recorded("ma", jaw=0.2), recorded("tu", jaw=0.8)])
    with PerformanceTable.open(tmp_path / "two.sqlite") as table:
        utterance = utterance_of("ma", "tu", pause=0.4)  # silence until 0.4, from 0.6 to 1 and from 1.2 on
        track = track_of(table, utterance, PLAIN)
        mouth = track.mouth()
        assert len(track.sentences) == 2
        jaws = [float(mouth.weights(time)[JAW]) for time in (0.5, 0.7, 0.75, 0.8, 0.85, 0.9, 1.1, 0.8)]
        assert jaws == pytest.approx([0.2, 0.2, 0.288, 0.5, 0.712, 0.8, 0.8, 0.5], abs=0.005)


def test_a_mouth_comes_to_rest_after_the_last_word(table: PerformanceTable) -> None:
    utterance = utterance_of("mi")
    mouth = track_of(table, utterance, PerformanceOptions()).mouth()
    end = [*utterance.phones][-1].end
    assert mouth.weights(end - 0.05)[PUCKER] == pytest.approx(0.25, abs=0.01)
    assert mouth.weights(end + 0.15)[PUCKER] == pytest.approx(0.125, abs=0.01)
    assert not mouth.weights(end + 0.3).any()
    assert not mouth.weights(end + 99.0).any()


def test_what_the_table_lacks_is_said(table: PerformanceTable) -> None:
    assert track_of(table, utterance_of("mi")).notes == ()
    (note,) = track_of(table, utterance_of("bi")).notes
    assert note == "the recordings have no [b], so it looks like [m]"


def test_equal_seeds_make_equal_faces(tmp_path: Path) -> None:
    write_table(tmp_path / "many.sqlite", [recorded("ma", jaw=k / 10) for k in range(10)])
    with PerformanceTable.open(tmp_path / "many.sqlite") as table:
        utterance = utterance_of("ma", "ma")
        first, again, other = (
            track_of(table, utterance, PerformanceOptions(ExampleChoice.RANDOM, seed)).animation(
                heard(utterance), 60, IdleMotion(seed=1)
            )
            for seed in (-5, -5, 5)
        )
        assert np.array_equal(first.weights, again.weights)
        assert not np.array_equal(first.weights, other.weights)


def test_a_head_moves_unless_it_is_left_out(table: PerformanceTable) -> None:
    utterance = utterance_of("ma.ma", "tu", "mi")
    speech = replace(heard(utterance), intensities=np.ones(150, np.float32), pitches=np.full(150, 120, np.float32))
    still, moved = (
        track_of(table, utterance, PerformanceOptions(without=without)).animation(speech, 60)
        for without in (frozenset({PerformancePart.HEAD}), frozenset[PerformancePart]())
    )
    assert np.ptp(moved.head) > 0
    assert np.ptp(still.head) == 0
    with pytest.raises(MouthError, match="frame rate"):
        track_of(table, utterance).animation(speech, 0)


def test_head_brows_shoulders_and_tongue_move_with_the_mouth(tmp_path: Path) -> None:
    channels = (*HEAD, "jawOpen", "browInnerUp", "shoulderShiftRight")
    plain = recorded("ma.ma ni", length=0.2)
    weights = np.zeros((len(plain.weights), len(channels)), np.float32)
    weights[:, 1] = 6 * np.sin(2 * np.pi * np.arange(len(weights)) / len(weights))
    weights[:, 4:] = 0.5
    write_table(tmp_path / "t.sqlite", [replace(plain, channels=channels, weights=weights)])
    utterance = utterance_of("ma.ma", "ni", length=0.2, pause=0.2, gap=0.0)
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        track = track_of(table, utterance, PerformanceOptions())
        animation = track.animation(heard(utterance), 60)
    assert track.notes == ()
    assert animation.movestates == FACE
    moved = dict(zip(FACE, animation.weights.T, strict=True))
    assert np.ptp(animation.head, axis=0) == pytest.approx([0, 12, 0], abs=3)
    assert moved["browInnerUp"].max() == pytest.approx(0.5, abs=0.02)
    assert moved["shoulderShiftRight"].max() == pytest.approx(0.5, abs=0.02)
    assert moved["tongueTipAlveolar"].max() == pytest.approx(1.0, abs=0.02)
    assert moved["tongueTipAlveolar"][animation.times < 0.6].max() < 0.05


def test_shoulders_and_tongue_travel_over_the_network(tmp_path: Path) -> None:
    channels = ("jawOpen", SHOULDERS[1])
    plain = recorded("ni", length=0.2)
    write_table(tmp_path / "t.sqlite", [replace(plain, channels=channels, weights=plain.weights[:, 1:3])])
    receiver, performer = Receiver(), Performer(face_table())
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        performer.play(track_of(table, utterance_of("ni", length=0.2), PerformanceOptions()).mouth())
        with OscMouth(receiver.address, performer, clock=lambda: 0.2):
            wait_for(lambda: bool(receiver.of("/VMC/Ext/Blend/Apply")), "a frame")
    receiver.close()
    sent = {name for name, weight in receiver.of("/VMC/Ext/Blend/Val") if weight}
    assert {SHOULDERS[1], "tongueTipAlveolar", "jawOpen"} <= sent


def test_the_head_goes_from_sentence_to_sentence_without_a_jump(tmp_path: Path) -> None:
    channels = (*HEAD, "jawOpen")
    recordings = []
    for words, height in (("ma", 9.0), ("tu.tu", -9.0)):
        plain = recorded(words, length=0.2)
        weights = np.zeros((len(plain.weights), len(channels)), np.float32)
        weights[len(weights) // 2 :, 0] = height
        recordings.append(replace(plain, channels=channels, weights=weights))
    write_table(tmp_path / "t.sqlite", recordings)
    utterance = utterance_of("ma", "tu.tu", "ma", length=0.2, pause=0.4)
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        track = track_of(table, utterance, PerformanceOptions())
        head = track.animation(heard(utterance), 120).head
    assert len(track.sentences) == 3
    assert np.ptp(head[:, 0]) > 5
    assert np.abs(np.diff(head[:, 0])).max() * 120 < 120  # degrees a second
    assert np.abs(head[[0, -1]]).max() < 0.1


def test_silence_alone_is_a_face_at_rest(table: PerformanceTable) -> None:
    utterance = Utterance((), 1.0)
    track = track_of(table, utterance, PerformanceOptions())
    assert [unit.names for unit in track.units()] == [(SILENCE,), (SILENCE,)]
    assert np.isfinite(track.animation(heard(utterance), 30).weights).all()


def test_a_table_without_a_mouth_or_with_strange_units_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "t.sqlite"
    write_table(path, [replace(recorded("mi"), channels=("headYaw", "x", "y", "z"))])
    with PerformanceTable.open(path) as table, pytest.raises(PerformanceError, match="no channel of this table"):
        track_of(table, utterance_of("mi"))
    for change in ("UPDATE unit SET last = last + 40", "UPDATE unit SET first = first - 90", "DELETE FROM unit"):
        write_table(path, [recorded("mi")])
        with closing(sqlite3.connect(path)) as connection:
            connection.execute(change)
            connection.commit()
        with PerformanceTable.open(path) as table, pytest.raises(PerformanceError, match="is damaged"):
            track_of(table, utterance_of("mi")).mouth().weights(0.1)
