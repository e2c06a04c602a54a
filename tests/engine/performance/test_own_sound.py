"""The recordings of a table say what a voice says: hums, whose smooth waves show each step at a join."""

import gc
import tracemalloc
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.overlap_add import SoundPiece, joined_pieces, pitch_marks
from phonemeengine.errors import PerformanceError
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.performance.corpus import measured, pitches_of
from phonemeengine.performance.driver import PerformanceOptions, UsedUnit
from phonemeengine.performance.own_sound import OwnSound
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.track import PerformanceTrack
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.voice import SpokenSentence
from tests.engine.performance.corpora import write_sound
from tests.engine.performance.test_track import recorded, utterance_of

STEP = 10 ** (-50 / 20)
"""The amplitude of a step that is heard as a click."""
PITCHES = {"ma.ma tu": 120.0, "mi tu": 130.0, "ti ma": 140.0, "tu.mi ta": 125.0, "ta ti": 135.0}


def hum(pitch: float, duration: float, level: float = 0.1) -> Float32Array:
    """Give three harmonics of a pitch, between silences of 0.1 s: no sample is far from its neighbours."""
    times = np.arange(round(duration * SAMPLE_RATE)) / SAMPLE_RATE
    wave = sum(np.sin(2 * np.pi * k * pitch * times + pitch + k) / k for k in (1, 2, 3))
    edges = np.clip(np.minimum(times - 0.08, duration - 0.08 - times) / 0.02, 0, 1)
    return (level * wave * (0.5 - 0.5 * np.cos(np.pi * edges))).astype(np.float32)


@pytest.fixture
def table(tmp_path: Path) -> Iterator[PerformanceTable]:
    performances = []
    for words, pitch in PITCHES.items():
        performance = recorded(words)
        sound = hum(pitch, performance.duration)
        performances.append(replace(performance, phones=measured(performance.phones, sound)))
        write_sound(tmp_path / f"{words}.wav", sound)
    clips = {"hello": "ta ti", "nn": "mi tu"}  # words that the recordings lack
    write_table(tmp_path / "t.sqlite", performances, folder=tmp_path, clips=clips)
    with PerformanceTable.open(tmp_path / "t.sqlite") as opened:
        yield opened


def spoken(*words: str, length: float = 0.1, pause: float = 0.3) -> SpokenSentence:
    """Give what a voice says, which is a hum, too."""
    said = utterance_of(*words, length=length, gap=0.0)
    samples = np.pad(hum(110.0, said.duration), (0, round(pause * SAMPLE_RATE)))
    return SpokenSentence(samples, said.words, " ".join(words))


def said_by(own: OwnSound, sentence: SpokenSentence) -> tuple[SpokenSentence, Sequence[UsedUnit]]:
    """Give what the table says, and the units of which its face is made."""
    (said,) = own.follow([sentence])
    utterance = Utterance(said.words, said.duration)
    options = PerformanceOptions(given=own.units_of)
    return said, [*PerformanceTrack(utterance, Transcript("said", said.duration), own.table, options).units()]


def joins_in(units: Sequence[UsedUnit]) -> list[float]:
    """Give when a unit follows another one from elsewhere, seconds."""
    return [
        one.end
        for one, other in pairwise(units)
        if (one.recording, one.source_end) != (other.recording, other.source_start) and "sil" not in one.names[-1:]
    ]


def bend_at(samples: Float32Array, time: float) -> float:
    """Give how far a sample within 15 ms lies from the line through its neighbours, at most; a step at least so."""
    k, near = round(time * SAMPLE_RATE), round(0.015 * SAMPLE_RATE)
    return float(np.abs(np.diff(samples[max(k - near, 0) : k + near], 2)).max())


def check_joins(table: PerformanceTable, n: int) -> None:
    """Have the table say texts of known words until there were a number of joins, none of which is a step."""
    own, chance = OwnSound(table), np.random.default_rng(5)
    syllables = ("ma", "mi", "tu", "ti", "ta")
    found: list[float] = []
    while len(found) < n:
        words = chance.choice(syllables, 8).tolist()
        said, units = said_by(own, spoken(*words, length=float(chance.uniform(0.07, 0.15))))
        found += [bend_at(said.samples, time) for time in joins_in(units)]
        for unit in units:
            if "sil" not in unit.names:
                assert 0.849 < (unit.end - unit.start) / (unit.source_end - unit.source_start) < 1.151
    assert max(found) < STEP


def test_a_recorded_sentence_is_heard_as_it_was(table: PerformanceTable, tmp_path: Path) -> None:
    said, units = said_by(OwnSound(table), spoken("mi", "tu", length=0.2))
    assert [unit.kind for unit in units] == ["left-half", "sentence", "right-half"]
    recorded_sound = hum(130.0, 0.6)[round(0.1 * SAMPLE_RATE) : round(0.5 * SAMPLE_RATE)]
    first = round(said.words[0].start * SAMPLE_RATE)
    assert said.words[-1].end - said.words[0].start == pytest.approx(0.4)  # however slow the voice was
    heard = said.samples[first : first + len(recorded_sound)]
    assert heard[400:-400] == pytest.approx(recorded_sound[400:-400], abs=1e-4)  # 16 bits


def test_there_is_no_click_where_units_are_joined(table: PerformanceTable) -> None:
    check_joins(table, 30)


@pytest.mark.long
def test_there_is_no_click_at_a_thousand_joins(table: PerformanceTable) -> None:
    check_joins(table, 1000)


def test_the_face_is_made_of_the_units_that_are_heard(table: PerformanceTable) -> None:
    own = OwnSound(table, seed=3)
    said, units = said_by(own, spoken("ma", "ti", "mi", length=0.12))
    names = [unit.recording for unit in units]
    pitch = pitches_of(said.samples)
    for unit in units:
        middle = (unit.start + unit.end) / 2
        if "sil" not in unit.names and unit.end - unit.start > 0.05:
            assert pitch[round(middle * 100)] == pytest.approx(PITCHES[unit.recording], rel=0.16)
    assert len({*names}) > 1
    assert [unit.start for unit in units] == [0.0, *(unit.end for unit in units[:-1])]


def test_pitches_meet_halfway_where_units_are_joined() -> None:
    pieces = []
    for pitch, factors in ((120.0, (1.0, 1.1)), (145.2, (1 / 1.1, 1.0))):
        sound = hum(pitch, 0.6)
        pieces.append(SoundPiece(sound, pitch_marks(sound, pitches_of(sound)), 6000.0, 19000.0, 1.0, factors))
    joined = joined_pieces(pieces)
    assert len(joined) == 26000
    pitches = pitches_of(joined)
    assert pitches[29] == pytest.approx(132.0, rel=0.02)
    assert pitches[4] == pytest.approx(120.0, rel=0.03)
    assert pitches[54] == pytest.approx(145.2, rel=0.03)


def test_what_the_recordings_lack_is_said(table: PerformanceTable, tmp_path: Path) -> None:
    own = OwnSound(table)
    said_by(own, spoken("no"))
    assert own.notes[0] == "the recordings have no [n], so it sounds like [t]"
    (tmp_path / "mi tu.wav").unlink()
    with pytest.raises(PerformanceError, match=r"'mi tu' is not in the folder '\.' beside the table; put it there"):
        said_by(own, spoken("mi", "tu"))


def test_a_recording_answers_a_key_word_whole(table: PerformanceTable) -> None:
    said, units = said_by(OwnSound(table), spoken("ma", "hello", "ti", "n", "n", length=0.12))
    assert [word.text for word in said.words] == ["ma", "hello", "ti", "n", "n"]
    answers = [unit for unit in units if unit.kind == "clip"]
    assert [("".join(unit.names), unit.recording) for unit in answers] == [("tati", "ta ti"), ("mitu", "mi tu")]
    assert "".join(phone.ipa for phone in said.words[1].phones) == "tati"
    for unit in answers:
        assert unit.end - unit.start == pytest.approx(0.4)  # from the first to the last phone
        middle = slice(round((unit.start + 0.1) * SAMPLE_RATE), round((unit.end - 0.1) * SAMPLE_RATE))
        assert np.median(pitches_of(said.samples[middle])[4:-4]) == pytest.approx(PITCHES[unit.recording], rel=0.01)


def test_what_was_said_takes_no_memory(table: PerformanceTable) -> None:
    own, sentence = OwnSound(table), spoken(*["ma", "ti", "mi", "tu", "ta"] * 2)
    kept = []
    tracemalloc.start()
    for _ in range(5):
        deque(own.follow([sentence] * 2), maxlen=0)
        gc.collect()
        kept.append(tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
    assert min(after - before for before, after in pairwise(kept)) < 2 * 4000  # bytes; other threads allocate, too
