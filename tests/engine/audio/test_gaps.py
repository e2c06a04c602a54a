"""A recording of a microphone that was away has a mark at that place, which other programs find too."""

import struct
import subprocess
import sys
import wave
from collections.abc import Callable
from pathlib import Path

import av
import numpy as np
import pytest
import soundfile

from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.journal import interrupted_recordings
from phonemeengine.audio.libsndfile import ROOM
from phonemeengine.audio.recording import MOST_WAITING
from phonemeengine.audio.wav import HEADER, MOST_MARKED, Gap, WavEncoder, gaps_in_words
from phonemeengine.live.recorder import Recorder
from phonemeengine.settings import HOP, SAMPLE_RATE
from tests.engine.live.test_recorder import record, rows_beside, rows_of, same
from tests.fakes.microphones import HandDrivenMicrophone, Hear, frames_in, offline
from tests.fakes.players import SPEECH
from tests.fakes.recorders import begun, check_kept, recorder_to, samples_in, samples_of_16_bits
from tests.waiting import Clock, wait_for

Mark = tuple[int, str]
"""A place in samples, and what stands there."""

KILLED = """
import os, sys
from pathlib import Path
from tests.waiting import wait_for
from tests.fakes.recorders import begun, samples_of_16_bits
recording = begun(Path(sys.argv[1]), 16_000)
recording.write(samples_of_16_bits(0, 16_000))
recording.skip(4.2)
recording.write(samples_of_16_bits(16_000, 16_000))
wait_for(lambda: recording.seconds >= 1.5)
os._exit(9)
"""


def chunks_of(content: bytes, at: int, end: int) -> dict[bytes, bytes]:
    """Walk over the chunks of a RIFF file, which must fill it, and give what each holds."""
    found = {}
    while at < end:
        name, size = struct.unpack_from("<4sI", content, at)
        if size == 0xFFFF_FFFF:
            return found  # the samples of an RF64 file, which come last
        found[name] = content[at + 8 : at + 8 + size]
        at += 8 + size + size % 2
    assert at == end
    return found


def marks_in_wav(path: Path) -> list[Mark]:
    with path.open("rb") as file:
        content = file.read(1 << 20)
    chunks = chunks_of(content, 12, path.stat().st_size)
    if b"cue " not in chunks:
        return []
    (n,) = struct.unpack_from("<I", chunks[b"cue "])
    points = [struct.unpack_from("<II4sIII", chunks[b"cue "], 4 + 24 * k) for k in range(n)]
    assert len(chunks[b"cue "]) == 4 + 24 * n
    assert all(place == offset and chunk == b"data" for _, place, chunk, _, _, offset in points)
    return [(place, text) for (_, place, *_), text in zip(points, labels_in(chunks[b"LIST"]), strict=True)]


def labels_in(listed: bytes) -> list[str]:
    assert listed[:4] == b"adtl"
    labels, at = [], 4
    while at < len(listed):
        name, size, number = struct.unpack_from("<4sII", listed, at)
        assert (name, number) == (b"labl", len(labels) + 1)
        labels.append(listed[at + 12 : at + 8 + size].rstrip(b"\0").decode("ascii"))
        at += 8 + size + size % 2
    return labels


def marks_by_libsndfile(path: Path) -> list[Mark]:
    """Ask libsndfile itself for the cue points, which soundfile does not pass on."""
    ffi, snd = soundfile._ffi, soundfile._snd
    with soundfile.SoundFile(path) as file:
        count = ffi.new("uint32_t *")
        snd.sf_command(file._file, 0x10CD, count, 4)
        cues = ffi.new("char []", 4 + 280 * count[0])
        snd.sf_command(file._file, 0x10CE, cues, len(cues))
        content = bytes(ffi.buffer(cues))
    points = [struct.unpack_from("<iIiiiI256s", content, 4 + 280 * k) for k in range(count[0])]
    return [(point[5], point[6].split(b"\0")[0].decode()) for point in points]


def marks_by_ffmpeg(path: Path) -> list[Mark]:
    with av.open(str(path)) as file:
        rate = file.streams.audio[0].rate
        return [(round(float(c["start"] * c["time_base"]) * rate), c["metadata"]["title"]) for c in file.chapters()]


READERS: dict[str, tuple[Callable[[Path], list[Mark]], ...]] = {
    ".wav": (marks_in_wav, marks_by_ffmpeg, marks_by_libsndfile),
    ".flac": (marks_by_ffmpeg,),
}


def marks_in(path: Path) -> list[Mark]:
    """What all readers of a file's kind find."""
    first, *others = [read(path) for read in READERS[path.suffix]]
    assert all(other == first for other in others)
    return first


# -- the file -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".wav", ".flac"])
@pytest.mark.parametrize(("rate", "n_channels"), [(44_000, 1), (16_000, 2)])
def test_other_programs_find_the_gap_where_it_was(suffix: str, rate: int, n_channels: int, tmp_path: Path) -> None:
    recording = begun(tmp_path / f"take{suffix}", rate, n_channels)
    recording.write(samples_of_16_bits(0, 2 * rate, n_channels))
    recording.skip(4.2)
    recording.write(samples_of_16_bits(2 * rate, rate, n_channels))
    recording.skip(3600)
    recording.write(samples_of_16_bits(3 * rate, rate, n_channels))
    recording.close()
    assert recording.failure is None
    check_kept(recording.path, 4 * rate, n_channels)
    assert marks_in(recording.path) == [(2 * rate, "gap of 4.20 s"), (3 * rate, "gap of 3600.00 s")]


@pytest.mark.parametrize("suffix", [".wav", ".flac"])
def test_a_recording_without_a_gap_has_no_mark(suffix: str, tmp_path: Path) -> None:
    recording = begun(tmp_path / f"take{suffix}")
    recording.write(samples_of_16_bits(0, 10_000))
    recording.close()
    assert marks_in(recording.path) == []


def test_pythons_own_reader_reads_a_file_with_marks(tmp_path: Path) -> None:
    recording = begun(tmp_path / "take.wav")
    recording.write(samples_of_16_bits(0, 1000))
    recording.skip(0.5)
    recording.write(samples_of_16_bits(1000, 1001))
    recording.close()
    with wave.open(str(recording.path)) as file:
        assert (file.getnframes(), len(file.readframes(5000))) == (2001, 6003)
    assert recording.path.stat().st_size == HEADER + 6003 + 1


def test_more_gaps_than_there_is_room_for_spoil_nothing(tmp_path: Path) -> None:
    recording = begun(tmp_path / "take.wav", 8000)
    for k in range(MOST_MARKED + 50):
        recording.skip(1e5 + k)
        recording.write(samples_of_16_bits(80 * k, 80))
    recording.close()
    assert recording.failure is None
    check_kept(recording.path, 80 * (MOST_MARKED + 50))
    assert marks_in(recording.path)[-1] == (80 * (MOST_MARKED - 1), f"gap of {1e5 + MOST_MARKED - 1:.2f} s")
    assert len(marks_in(recording.path)) == MOST_MARKED


def test_a_killed_process_leaves_the_mark_with_the_sound(tmp_path: Path) -> None:
    path = tmp_path / "take.flac"
    assert subprocess.run([sys.executable, "-c", KILLED, str(path)], check=False).returncode == 9
    (found,) = interrupted_recordings(tmp_path / "journal")
    assert found.seconds >= 1.5
    check_kept(path, round(found.seconds * 16_000))
    assert marks_in(path) == [(16_000, "gap of 4.20 s")]


def test_a_file_beyond_4_gb_keeps_its_marks(tmp_path: Path) -> None:
    """Most of the file is a hole, which takes no room on the disk."""
    path = tmp_path / "large.wav"
    last = samples_of_16_bits(0, 1000, 2)
    n_samples = (1 << 32) // 6 + 5000
    with path.open("x+b", buffering=0) as file:
        encoder = WavEncoder(file, SAMPLE_RATE, 2)
        encoder.n_samples = n_samples - len(last)
        encoder.mark(7.5)
        encoder.write(last)
        encoder.close()
    assert soundfile.info(path).format == "RF64"
    assert marks_in_wav(path) == marks_by_ffmpeg(path) == [(n_samples - 1000, "gap of 7.50 s")]
    with SoundReader(path) as reader:
        reader.seek(n_samples - len(last))
        np.testing.assert_array_equal(reader.read(5000), last)


def test_silence_longer_than_may_wait_for_the_disk_takes_the_place_of_a_gap(tmp_path: Path) -> None:
    rate = 8000
    n_silent = round(2 * MOST_WAITING * rate)
    recording = begun(tmp_path / "take.wav", rate)
    sound = samples_of_16_bits(0, 2 * rate)
    recording.write(sound[:rate])
    recording.skip(2 * MOST_WAITING, n_silent)
    recording.write(sound[rate:])
    recording.close()
    assert recording.failure is None
    found = samples_in(recording.path)
    assert recording.n_samples == len(found) == 2 * rate + n_silent
    np.testing.assert_array_equal(found[:rate], sound[:rate])
    np.testing.assert_array_equal(found[-rate:], sound[rate:])
    assert not found[rate:-rate].any()
    assert marks_in(recording.path) == [(rate, "gap of 120.00 s")]


def test_the_takes_of_a_calibration_have_no_room_for_marks(tmp_path: Path) -> None:
    from phonemeengine.audio.recording import write_flac

    write_flac(tmp_path / "take.flac", samples_of_16_bits(0, 441)[:, 0], SAMPLE_RATE)
    assert (tmp_path / "take.flac").stat().st_size < ROOM


# -- the tape -------------------------------------------------------------------------------------------------


@pytest.fixture
def tape(request: pytest.FixtureRequest, tmp_path: Path) -> Recorder:
    """Records speech, 6.5 s of nothing, and the speech again."""
    tape = recorder_to(lambda: tmp_path / "take.wav", tmp_path, with_phonemes=True, **getattr(request, "param", {}))
    record(tape, SPEECH[: 50 * HOP])
    record(tape, SPEECH, began=7.0, gap=6.5)
    tape.close()
    return tape


BEFORE = rows_of(offline(SPEECH[: 50 * HOP]).part(slice(frames_in(50 * HOP))), 0.5)
AFTER = rows_of(offline(SPEECH).part(slice(frames_in(len(SPEECH)))), len(SPEECH) / SAMPLE_RATE)


def test_the_phonemes_have_a_row_for_the_gap_and_stay_in_step_with_the_file(tape: Recorder) -> None:
    gap = (0.5, 0.5, "gap of 6.50 s", 0.0)
    same(rows_beside(tape.paths[0]), [*BEFORE, gap, *((a + 0.5, b + 0.5, *rest) for a, b, *rest in AFTER)])
    assert len(samples_in(tape.paths[0])) == 50 * HOP + len(SPEECH)
    assert marks_in(tape.paths[0]) == [(50 * HOP, "gap of 6.50 s")]
    assert tape.gap_words == "with 1 gap of 6.50 s marked in it"


@pytest.mark.parametrize("tape", [{"fill_gaps": True}], indirect=True)
def test_silence_of_the_gaps_length_takes_its_place_where_that_is_chosen(tape: Recorder) -> None:
    gap = (0.5, 7.0, "gap of 6.50 s", 0.0)
    same(rows_beside(tape.paths[0]), [*BEFORE, gap, *((a + 7, b + 7, *rest) for a, b, *rest in AFTER)])
    found = samples_in(tape.paths[0])[:, 0]
    assert len(found) == 7 * SAMPLE_RATE + len(SPEECH)
    assert not found[50 * HOP : 7 * SAMPLE_RATE].any()
    np.testing.assert_allclose(found[7 * SAMPLE_RATE :], SPEECH.clip(-1, 1), atol=2**-23)
    sound = 0.5 + len(SPEECH) / SAMPLE_RATE
    assert tape.gap_words == f"with 1 gap of 6.50 s marked in it: {sound:.2f} s of sound, 6.50 s of silence"


@pytest.mark.parametrize("tape", [{"fill_gaps": True, "seconds": 3.0}], indirect=True)
def test_silence_does_not_exceed_the_length_that_was_asked_for(tape: Recorder) -> None:
    assert len(samples_in(tape.paths[0])) == 3 * SAMPLE_RATE
    assert rows_beside(tape.paths[0])[-1] == (0.5, 3.0, "gap of 6.50 s", 0.0)
    assert tape.gap_words == "with 1 gap of 6.50 s marked in it: 0.50 s of sound, 2.50 s of silence"


@pytest.mark.parametrize("tape", [{"seconds": 0.5}], indirect=True)
def test_a_gap_after_the_length_that_was_asked_for_is_none(tape: Recorder) -> None:
    assert (tape.gaps, tape.gap_words, marks_in(tape.paths[0])) == ([], "", [])


def test_several_gaps_are_counted_and_so_is_what_could_not_be_marked() -> None:
    gaps = [Gap(k, 0.5) for k in range(MOST_MARKED + 1)]
    assert gaps_in_words(gaps[:2], 3.0, 8000) == "with 2 gaps of 1.00 s in all marked in it"
    assert gaps_in_words(gaps, 3.0, 8000).endswith(f"marked in it (the first {MOST_MARKED} of them)")
    assert gaps_in_words([], 3.0, 8000) == ""


# -- the listener ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("fill_gaps", [False, True])
def test_a_microphone_that_was_away_is_recorded_with_a_gap_of_that_length(
    hear: Hear, clock: Clock, tmp_path: Path, fill_gaps: bool
) -> None:
    first, second = HandDrivenMicrophone(), HandDrivenMicrophone(name="the same again")
    tape = recorder_to(lambda: tmp_path / "take.flac", tmp_path, fill_gaps=fill_gaps)
    hearing = hear(first, recorder=tape, clock=clock)
    first.give(SPEECH[: 50 * HOP], 50 * HOP)
    hearing.wait(frames_in(50 * HOP))
    first.lost = True
    wait_for(lambda: len(hearing.openers.asked) > 1, "another try")
    clock.now += 4.21
    hearing.openers.waiting.append(second)
    hearing.wait_words("waiting for a signal from the same again")
    second.give(SPEECH[50 * HOP : 80 * HOP])  # each block began 10 ms before it came
    hearing.wait(frames_in(50 * HOP) + frames_in(30 * HOP))
    hearing.listener.record(None)
    tape.close()
    assert [gap.seconds for gap in tape.gaps] == [pytest.approx(4.2)]
    assert hearing.listener.lost_seconds == pytest.approx(4.2)
    assert marks_in(tape.paths[0]) == [(50 * HOP, "gap of 4.20 s")]
    assert len(samples_in(tape.paths[0])) == 80 * HOP + (round(4.2 * SAMPLE_RATE) if fill_gaps else 0)
