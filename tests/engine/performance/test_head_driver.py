from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.performance.head_driver import HeadDriver
from phonemeengine.performance.keywords import CHANNELS, Keywords
from phonemeengine.performance.recording import HEAD, Performance
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.units import PhraseMatch, PhraseMatchKind
from tests.engine.performance.rhythms import RATE, Movement, performed, said, table_of, words_of

NONE = Keywords({}, {}, {})
PAUSE = 0.3


class Moved(NamedTuple):
    """How a sentence moved, what it was made of, and what is said of it."""

    values: Float32Array
    matches: tuple[PhraseMatch, ...]
    notes: tuple[str, ...]


def _still(times: Float64Array) -> Float64Array:
    return np.zeros_like(times)


def _at(time: float, height: float, width: float = 0.15) -> Movement:
    """Give a smooth rise and fall about a time."""
    return lambda times: height * np.exp(-(((times - time) / width) ** 2))


def _level(height: float) -> Movement:
    return lambda times: np.full_like(times, height)


def _recorded(rhythm: str, length: float = 0.2, **movements: Movement) -> Performance:
    return performed(rhythm, {name: movements.get(name, _still) for name in CHANNELS}, length)


def _said(
    folder: Path,
    rhythm: str,
    *performances: Performance,
    keywords: Keywords | None = NONE,
    language: str = "en",
    length: float = 0.2,
    n_more: int = 0,
) -> Moved:
    phones = said(rhythm, length)
    with table_of(folder, *performances) as table:
        driver = HeadDriver(table, words_of(rhythm), language, keywords)
        values = driver.track(phones, _times(phones[-1].end, n_more))
        return Moved(values, driver.matches(phones), tuple(driver.notes(phones)))


def _times(end: float, n_more: int = 0) -> Float64Array:
    return np.arange(int(end * RATE + 1e-6) + 1 + n_more) / RATE


def _channel(track: Moved, name: str) -> Float32Array:
    return track.values[:, CHANNELS.index(name)]


def _time_of_peak(track: Moved, name: str) -> float:
    return float(np.argmax(np.abs(_channel(track, name)))) / RATE


def test_a_phrase_of_equal_syllables_moves_the_head_as_it_was_recorded(tmp_path: Path) -> None:
    rhythm = "da da da da DA da da da"
    recorded = _recorded(rhythm, headYaw=_at(1.1, 8.0), headPitch=_at(1.4, -6.0), browInnerUp=_at(1.0, 0.5))
    track = _said(tmp_path, rhythm, recorded)
    times = _times(recorded.duration)
    assert [match.kind for match in track.matches] == [PhraseMatchKind.SYLLABLES]
    assert _channel(track, "headYaw") == pytest.approx(_at(1.1, 8.0)(times), abs=0.8)
    assert _channel(track, "headPitch") == pytest.approx(_at(1.4, -6.0)(times), abs=0.6)
    assert _channel(track, "browInnerUp") == pytest.approx(_at(1.0, 0.5)(times), abs=0.05)
    assert not _channel(track, "browDownLeft").any()
    assert track.notes == ()


@pytest.mark.parametrize("length", [0.14, 0.3])
def test_a_nod_stays_on_its_syllable_however_fast_one_speaks(tmp_path: Path, length: float) -> None:
    recorded = _recorded("da da da DA da da da", headPitch=_at(0.3 + 3.5 * 0.2, -8.0))
    track = _said(tmp_path, "da da da DA da da da", recorded, length=length)
    assert _time_of_peak(track, "headPitch") == pytest.approx(0.3 + 3.5 * length, abs=0.02)


def test_stresses_meet_where_the_syllables_are_not_as_many(tmp_path: Path) -> None:
    recorded = _recorded("da da da DA da da", headPitch=_at(0.3 + 3.5 * 0.2, -8.0))
    track = _said(tmp_path, "da da DA da da", recorded)
    assert [match.kind for match in track.matches] == [PhraseMatchKind.STRESSES]
    assert _time_of_peak(track, "headPitch") == pytest.approx(0.3 + 2.5 * 0.2, abs=0.03)


def test_phrases_are_cross_faded_in_the_middle_of_the_pause(tmp_path: Path) -> None:
    one = _recorded("da da da da", browInnerUp=_level(0.2))
    two = _recorded("da da da da da", browInnerUp=_level(0.6))
    brow = _channel(_said(tmp_path, "da da da da, da da da da da", one, two), "browInnerUp")
    middle = 0.3 + 4 * 0.2 + 0.15
    assert brow[round(middle * RATE)] == pytest.approx(0.4, abs=0.02)
    assert brow[round((middle - 0.35) * RATE)] == pytest.approx(0.2, abs=0.02)
    assert brow[round((middle + 0.35) * RATE)] == pytest.approx(0.6, abs=0.02)
    assert (np.diff(brow[round(0.8 * RATE) : round(1.8 * RATE)]) > -2e-3).all()


def test_heads_turn_about_their_own_middle_wherever_the_camera_stood(tmp_path: Path) -> None:
    one = _recorded("da da da da", headYaw=_level(20.0))
    two = _recorded("da da da da da", headYaw=_level(-15.0))
    track = _said(tmp_path, "da da da da, da da da da da", one, two)
    assert np.abs(track.values[:, : len(HEAD)]).max() < 1e-3


def test_all_come_from_rest_and_go_back_there(tmp_path: Path) -> None:
    recorded = _recorded("da da da da", browInnerUp=_level(0.8), shoulderShiftLeft=_level(0.5))
    track = _said(tmp_path, "da da da da", recorded, n_more=18)
    for name in ("browInnerUp", "shoulderShiftLeft"):
        column = _channel(track, name)
        assert abs(column[[0, -1]]).max() < 0.02
        assert column.max() == pytest.approx({"browInnerUp": 0.8, "shoulderShiftLeft": 0.5}[name], abs=0.02)


@pytest.mark.parametrize(
    ("language", "rhythm"), [("en-us", "da DA Yes da DA"), ("de", "da DA Ja, da DA"), ("fi", "da DA kyllä da DA")]
)
def test_the_head_nods_at_yes(tmp_path: Path, language: str, rhythm: str) -> None:
    still = _recorded("da DA da da DA", headYaw=_at(0.8, 5.0))
    track = _said(tmp_path, rhythm, still, keywords=None, language=language)
    begin, end = 0.3 + 2 * 0.2, 0.3 + 2 * 0.2 + 0.7
    pitch = _channel(track, "headPitch")
    lowest = pitch[round(begin * RATE) : round(end * RATE)].min()
    assert -9 < lowest < -5
    assert np.abs(pitch[: round((begin - 0.15) * RATE)]).max() < 0.3
    assert np.abs(pitch[round((end + 0.15) * RATE) :]).max() < 0.3


def test_the_head_turns_to_both_sides_at_no_and_the_brows_rise_at_good(tmp_path: Path) -> None:
    recorded = _recorded("da DA da da da DA")
    track = _said(tmp_path, "no da da, da good da", recorded, keywords=None)
    yaw = _channel(track, "headYaw")
    assert yaw.max() > 4
    assert yaw.min() < -4
    assert _channel(track, "browOuterUpLeft").max() > 0.2


def test_a_gesture_takes_the_place_of_what_moved_over_its_word(tmp_path: Path) -> None:
    rhythm = "da da da da no da da da da"
    wild = _recorded("da da da da DA da da da da", headPitch=_at(0.3 + 6 * 0.2, -30.0, 0.1))
    with_no = _channel(_said(tmp_path, rhythm, wild, keywords=None), "headPitch")
    without = _channel(_said(tmp_path, rhythm, wild), "headPitch")
    assert without.min() < -15
    assert with_no.min() > -1.5


def test_shoulders_and_brows_are_weights_whatever_a_gesture_adds(tmp_path: Path) -> None:
    recorded = _recorded("da da da da da", browInnerUp=_level(0.9), browOuterUpLeft=_level(0.9))
    track = _said(tmp_path, "da da good da da", recorded, keywords=None)
    assert track.values[:, len(HEAD) :].min() >= 0
    assert track.values[:, len(HEAD) :].max() <= 1


def test_head_and_brows_are_smooth_however_different_the_recordings_are(tmp_path: Path) -> None:
    chance = np.random.default_rng(1)
    recorded = [
        _recorded(rhythm, headYaw=_at(0.6, chance.normal() * 10), browInnerUp=_level(chance.random()))
        for rhythm in ("da", "da DA", "DA da da", "da da DA da", "da DA da DA da")
    ]
    rhythm = "da.da.DA da and da DA, yes da da da.DA da no da, DA da but da.da da da DA da good da"
    track = _said(tmp_path, rhythm, *recorded, keywords=None)
    speed, jerkiness = np.abs(np.diff(track.values, axis=0)).max(0), np.abs(np.diff(track.values, 2, axis=0)).max(0)
    assert (speed[: len(HEAD)] * RATE < 250).all()  # degrees a second, as a head shakes at most
    assert (speed[len(HEAD) :] * RATE < 8).all()
    assert (jerkiness[: len(HEAD)] < 0.7).all()
    assert (jerkiness[len(HEAD) :] < 0.03).all()


def test_a_head_that_nobody_recorded_moves_with_the_sound(tmp_path: Path) -> None:
    recorded = performed("da da da", {"jawOpen": _still})
    track = _said(tmp_path, "da DA da da", recorded, keywords=None)
    assert track.matches == ()
    assert track.notes == ("the table has no turns of the head: it moves with the sound",)
    assert np.abs(track.values[:, : len(HEAD)]).max() > 0.5
    assert not track.values[:, len(HEAD) :].any()


def test_a_head_that_nobody_recorded_nods_at_yes_and_sways_by_its_seed(tmp_path: Path) -> None:
    phones, words = said("da da yes da da"), words_of("da da yes da da")
    with table_of(tmp_path, performed("da da da", {"jawOpen": _still})) as table:
        one, same, other = (
            HeadDriver(table, words, "en", seed=seed).track(phones, _times(1.6)) for seed in (1, 1, 2)
        )
    assert (one == same).all()
    assert (one != other).any()
    assert one[:, CHANNELS.index("headPitch")].min() < -4


def test_brows_are_looked_up_where_only_they_were_recorded(tmp_path: Path) -> None:
    recorded = performed("da da da da", {"browInnerUp": _level(0.5)})
    track = _said(tmp_path, "da da da da", recorded)
    assert _channel(track, "browInnerUp").max() == pytest.approx(0.5, abs=0.02)
    assert len(track.matches) == 1


def test_a_sentence_of_a_longer_text_moves_as_it_does_alone(tmp_path: Path) -> None:
    phones, words = said("da no da"), words_of("da no da")
    later = [
        replace(
            phone,
            start=phone.start + 9,
            middle=phone.middle + 9,
            end=phone.end + 9,
            word=phone.word + 4 if phone.word >= 0 else -1,
        )
        for phone in phones
    ]
    with table_of(tmp_path, _recorded("da da da", headPitch=_at(0.6, -5.0))) as table:
        times = _times(phones[-1].end)
        alone = HeadDriver(table, words, "en").track(phones, times)
        within = HeadDriver(table, ("no", "yes", "no", "yes", *words, "yes"), "en").track(tuple(later), times + 9)
    assert within == pytest.approx(alone, abs=1e-4)


@pytest.mark.parametrize("middle", [0.5, 1.0, 1.5, 2.1, 2.6])
def test_parts_of_a_sentence_meet_as_if_they_were_one(tmp_path: Path, middle: float) -> None:
    rhythm = "da DA yes da, no DA da da DA da"
    phones = said(rhythm)
    recorded = [
        _recorded("da DA da da", headPitch=_at(0.6, -5.0)),
        _recorded("da DA da da da", headYaw=_at(0.9, 9.0)),
    ]
    with table_of(tmp_path, *recorded) as table:
        driver, times = HeadDriver(table, words_of(rhythm), "en"), _times(phones[-1].end)
        whole, before, after = (
            driver.track(phones, part) for part in (times, times[times <= middle], times[times > middle])
        )
    assert np.concatenate([before, after]) == pytest.approx(whole, abs=0.05)


def test_what_the_table_lacks_is_said(tmp_path: Path) -> None:
    track = _said(tmp_path, "da", _recorded("da da da da"))
    assert track.notes == (
        "the table has no phrase with these numbers of syllables: 1; the head takes parts of others",
    )


def test_silence_and_a_single_frame_have_a_track(tmp_path: Path) -> None:
    recorded = _recorded("da da", browInnerUp=_level(0.5))
    assert not _said(tmp_path, "", recorded).values.any()
    with table_of(tmp_path, recorded) as table:
        values = HeadDriver(table, ["da"], "").track(said("da"), np.zeros(1))
    assert values.shape == (1, len(CHANNELS))


def test_a_recording_answers_a_key_word_with_its_head_and_brows(tmp_path: Path) -> None:
    whole = _recorded("da da da da da da", headYaw=_level(0.0))
    clip = _recorded("ya", headPitch=_at(0.4, -9.0, 0.1), browInnerUp=_at(0.4, 0.6, 0.1), length=0.2)
    write_table(tmp_path / "t.sqlite", [whole, clip], clips={"hello": "ya"})
    phones = said("da da da da da da")
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        driver = HeadDriver(table, ("da", "da", "da", "Hello!", "da", "da"), "en", NONE)
        values = driver.track(phones, _times(phones[-1].end))
    moved = Moved(values, (), ())
    answered = 0.3 + 3.5 * 0.2  # the middle of its word
    assert _time_of_peak(moved, "headPitch") == pytest.approx(answered, abs=0.03)
    assert np.abs(_channel(moved, "headPitch")).max() > 4
    assert np.abs(values[: round(0.5 * RATE)]).max() < 0.1
