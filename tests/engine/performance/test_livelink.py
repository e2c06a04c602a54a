import numpy as np
import pytest

from phonemeengine import CorpusError
from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.blendshape_names import ARKIT, LIVE_LINK_COLUMNS
from phonemeengine.mouth.exports.livelink import COUNT, HEADER, lines_of, timecode_of
from phonemeengine.performance.face_track import CHANNELS, parse_livelink
from tests.engine.performance.faces import livelink_of, ramp

JAW = CHANNELS.index("jawOpen")


def _counting(n: int) -> Float32Array:
    """Rows whose jaw opens by a 128th a frame, and whose other channels rest."""
    weights = np.zeros((n, COUNT), np.float32)
    weights[:, JAW] = np.arange(n) / 128
    return weights


def _codes(frames: list[int], rate: int = 60) -> list[str]:
    return [timecode_of(frame, rate) for frame in frames]


@pytest.mark.parametrize("rate", [24, 25, 30, 50, 60])
def test_a_written_file_is_read_as_it_was(rate: int) -> None:
    face = ramp(3 * rate + 1, rate=rate)
    track = parse_livelink("".join(lines_of(face)), "a.csv")
    assert track.times == pytest.approx(face.times, abs=1e-9)
    assert track.channels[:52] == ARKIT
    assert track.channels[52:55] == ("headYaw", "headPitch", "headRoll")
    assert track.weights[:, :52] == pytest.approx(face.weights, abs=1e-5)
    assert track.weights[:, 52] == pytest.approx(face.head[:, 0], abs=1e-3)
    assert track.notes == ()


def test_a_telephone_that_counts_sixtieths_and_records_every_second_one_has_no_gaps() -> None:
    codes = [f"12:27:{47 + (47 + k) // 60:02d}:{(47 + k) % 60:02d}.{169 - k % 3}" for k in range(0, 90, 2)]
    track = parse_livelink(livelink_of(codes, _counting(45)), "a.csv")
    assert track.duration == pytest.approx(88 / 60, abs=1e-4)
    assert track.notes == ()


def test_times_come_from_the_time_code_and_a_dropped_frame_is_bridged_and_said() -> None:
    frames = [k for k in range(120) if k not in {40, 41, 42}]
    track = parse_livelink(livelink_of(_codes(frames), _counting(120)[frames]), "a.csv")
    assert track.times == pytest.approx(np.array(frames) / 60)
    assert track.sampled(np.array([41 / 60]))[0, JAW] == pytest.approx(41 / 128)
    assert track.notes == ("frames are missing at 1 places, for 0.067 s at most; they are bridged",)


def test_a_recording_over_midnight_goes_on() -> None:
    codes = [f"23:59:59:{frame:02d}.000" for frame in range(40, 60, 4)] + _codes([0, 4, 8])
    assert parse_livelink(livelink_of(codes, _counting(8)), "a.csv").duration == pytest.approx(28 / 60)


def test_frames_that_stand_there_twice_count_once() -> None:
    track = parse_livelink(livelink_of(_codes([0, 1, 1, 2, 3]), _counting(5)), "a.csv")
    assert track.weights[:, JAW] == pytest.approx(np.array([0, 1, 3, 4]) / 128)
    assert track.notes == ("1 frames stand there twice; the first of each counts",)


def test_columns_are_known_by_their_names_in_any_order_and_case() -> None:
    weights = _counting(3)
    header = ",".join([*LIVE_LINK_COLUMNS[:2], *(name.upper() for name in LIVE_LINK_COLUMNS[:1:-1])])
    rows = [
        f"{code},61,{','.join(map(str, row[::-1]))}" for code, row in zip(_codes([0, 1, 2]), weights, strict=True)
    ]
    track = parse_livelink("\n".join([header, *rows]), "a.csv")
    assert track.weights[:, JAW] == pytest.approx(np.array([0, 1, 2]) / 128)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "this is no recording of Live Link Face"),
        ("start_s,end_s,phone,class,certainty\n", "this is no recording of Live Link Face"),
        (HEADER + "\n", "there is no frame under the header"),
        (livelink_of(["0:00"], _counting(1)), "a time code is like 12:27:47:31.169, found '0:00'"),
        (livelink_of(["00:00:00:00"], _counting(1)), "it needs two frames or more within an hour, found 1"),
        (livelink_of(["00:00:00:999"], _counting(1)), "counts up to 240 frames a second, found 999"),
        (
            livelink_of(_codes([0, 1]), _counting(2)).replace("0.0078", "x.0078"),
            "there must be a number in each cell",
        ),
        (
            livelink_of(_codes([0, 1]), _counting(2)).replace("0.0078125000", "nan"),
            "frame 2: a blend shape's weight must lie",
        ),
        (livelink_of(_codes([0, 1]), 2000 * _counting(2)), "frame 2: a blend shape's weight must lie in 0..1"),
        (livelink_of(_codes([0, 1]), _counting(2))[:-40], "line 3: a row has 63 cells, found 60"),
        (livelink_of(_codes([0, 2, 1]), _counting(3)), "frame 3: the times of frames must not go back"),
        (livelink_of(_codes([0, 1, 8]), _counting(3)), "for 0.1 s at most, found 0.12 s without one after 0.02 s"),
        (livelink_of(_codes([0, 1]), _counting(2)).replace("JawOpen", "Snout"), "this lacks jawOpen"),
        (livelink_of(_codes([0, 1]), _counting(2)).replace("\n", ",Snout\n", 1), "this has 'Snout'"),
    ],
)
def test_what_is_no_recording_is_refused_in_a_sentence(text: str, sentence: str) -> None:
    with pytest.raises(CorpusError, match=sentence.replace(".", r"\.")) as refused:
        parse_livelink(text, "a.csv")
    assert str(refused.value).startswith("a.csv")
    assert "\n" not in str(refused.value)
